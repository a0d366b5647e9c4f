"""Force and moment of a joint on a body, independent of how the mass of the body is distributed over its bars."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.dynamics.bar_actions import actions_of
from kinetruss.dynamics.free_bodies import determined
from kinetruss.errors import InputError
from kinetruss.kinematics.joint_motion import shared_nodes
from kinetruss.kinematics.poses import carried, nodes_of
from kinetruss.mechanics import compile
from kinetruss.mechanics.frames import resultant, side_forces, sides_of
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.rotating_base import rates_in_space
from kinetruss.model import Model, Pressure, body_mass, nearest
from kinetruss.results import Forces, Simulation, variable
from kinetruss.results.records import check_samples

if TYPE_CHECKING:
    from numpy.typing import NDArray


def joint_reaction(
    model: Model,
    forces: Forces | Simulation,
    body: str,
    at: str | Sequence[str],
    *,
    point: str | None = None,
    frame: str | Sequence[str] | None = None,
) -> xr.Dataset:
    """Force and moment on a body, by everything else, through the nodes of one joint.

    Parameters
    ----------
    body : name of a body. at : name of the other body (the joint is the nodes that the two share) or of a joint of the model,
        or the joint's nodes.
    point : a node about which the moment is taken; by default the middle of the joint's nodes.
    frame : a body in whose axes the result is given; by default the global axes.

    Returns
    -------
    Dataset: ``force`` (time, axis) N on the body, ``moment`` (time, rotation) N m; of a joint by name that couplings hold
    ``coupling_force`` (time, coupling), what each does to its coordinate. attrs ``unique``: 0 if a state of self-stress acts
    through the joint (as in a closed loop of welds), so that equilibrium and motion do not determine the two; ``message`` says
    so. With two bodies at a joint and no load on its nodes, the reaction on the other body is the opposite. Nodal loads there
    and supports count as "everything else". Loads on the body itself do not, nor does the couple of a drive, a coupling or a
    spring at a hinge (``drive_force``, ``coupling_force``, ``spring_force``): the result is the load on the bearing.

    Raises
    ------
    InputError : unknown names; nodes that are not the body's; only some of the nodes that the body shares with another body,
        if common bars then leave the joint.

    Notes
    -----
    The free body: at each node s of the joint F_s = sum_j m_sj (a_j - g) + what the body's own bars need there. Single bar
    forces depend on how the mass is distributed over the nodes; this sum and its moment do not. A bar between nodes of the
    joint that both bodies share (along the axis of a revolute, in a weld) adds no force and no moment. So a weld is cut like
    any other joint.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"O": (0, 0), "P": (1, 0)}, fixed={"O": "xy", "P": "y"}, gravity=(0, -10),
    ...                bodies={"rod": kt.Body(nodes=("O", "P"), mass=2.0, center=(0.5, 0), inertia=0.1)})
    >>> still = kt.kinematics.from_arrays(rod, [0.0], *([[(0, 0), (1, 0)]], [[(0, 0)] * 2], [[(0, 0)] * 2]))
    >>> kt.dynamics.joint_reaction(rod, kt.dynamics.inverse(rod, still), "rod", ["O"]).force.values.round(9).tolist()
    [[0.0, 10.0]]
    """
    found = forces.forces if isinstance(forces, Simulation) else forces
    check_samples(found)
    names = _joint_nodes(model, body, at)
    if point is not None and point not in model.whole.nodes:
        raise InputError(f"No node called {point!r}. {nearest(point, model.nodes)}")
    push = _pushes(model, found, body, names)
    place = _spatial(found.motion.whole["position"].sel(node=list(names)).values)
    about = place.mean(axis=1) if point is None else _spatial(found.motion.whole["position"].sel(node=[point]).values)[:, 0]
    force, moment = resultant(place, push, about)
    if frame is not None:
        R = carried(model, found.motion, frame, None).R
        force, moment = (np.einsum("tji,tj->ti", R, y) for y in (force, moment))
    turns = slice(2, 3) if model.dim == 2 else slice(0, 3)
    data: dict[str, Any] = {
        "force": variable(("time", "axis"), force[:, : model.dim], "N", f"force on {body}"),
        "moment": variable(("time", "rotation"), moment[:, turns], "N m", f"moment on {body}"),
    }
    coords = {"time": found.motion.whole["time"], "axis": ["x", "y", "z"][: model.dim], "rotation": ["x", "y", "z"][turns]}
    if held_by := list(model.joints[at].couplings) if isinstance(at, str) and at in model.joints else []:
        data["coupling_force"] = found.whole["coupling_force"].sel(coupling=held_by).variable
        coords["coupling"] = held_by
    attrs = {"kind": "joint_reaction", "body": body, "nodes": list(names), "unique": 1, "message": ""}
    start = _spatial(found.motion.arrays["position"].values[:1])[0]
    if body in model.whole.bodies and determined(compile(model), start, body, names) is False:
        attrs |= {"unique": 0, "message": _shared_out(body, names)}
    return xr.Dataset(data, coords=coords, attrs=attrs)


def _joint_nodes(model: Model, body: str, at: str | Sequence[str]) -> tuple[str, ...]:
    """Names of the joint's nodes, all of them the body's."""
    own, bodies = nodes_of(model, body), model.whole.bodies
    if not isinstance(at, str):
        names = tuple(at)
    elif at in model.joints and at not in bodies:
        names = tuple(name for name in own if name in model.joints[at].nodes)
    elif at in own and at not in bodies:
        names = (at,)
    else:
        names = shared_nodes(model, body, at)
    if not names:
        raise InputError(f"{body} and {at if isinstance(at, str) else 'an empty list'} share no node, so there is no joint.")
    if strange := [name for name in names if name not in own]:
        raise InputError(f"{strange[0]!r} is not a node of {body}. {nearest(strange[0], own)}")
    for other, record in bodies.items():
        common = set(record.nodes) & set(own)
        if other != body and len(common) > 1 and common & set(names) and not common <= set(names):
            raise InputError(
                f"{body} and {other} share {', '.join(sorted(common))}, so a bar between these belongs to both; "
                f"{', '.join(names)} cuts it. Name all of them: at={sorted(common | set(names))}."
            )
    return names


def _shared_out(body: str, names: Sequence[str]) -> str:
    return (
        f"A state of self-stress acts through {', '.join(names)} of {body!r}: motion and loads do not determine force and "
        "moment there; these are what the bars of the model take of them. Let one of the joints that close the loop give way."
    )


def _pushes(model: Model, forces: Forces, body: str, names: Sequence[str]) -> NDArray[np.float64]:
    """F_s (time, nodes, 3), N, on the body at each node."""
    a = _spatial(_accelerations(forces))
    g = np.zeros(3)
    g[: model.dim] = forces.whole.attrs.get("gravity", model.gravity or np.zeros(model.dim))
    place, row = {name: i for i, name in enumerate(names)}, {name: i for i, name in enumerate(model.whole.nodes)}
    out = np.zeros((len(a), len(names), 3))
    for s, j, m, skew in _shares(model, body):
        if s in place:
            free = a[:, row[j]] - g
            out[:, place[s]] += m * free
            out[:, place[s], :2] += skew * np.stack([-free[:, 1], free[:, 0]], axis=1)
    joint_force = _with_actions(model, forces)
    for nodes, load in (*_own_loads(model, forces, body), *_own_couples(model, forces, body)):
        for k, node in enumerate(nodes):
            if node in place:
                out[:, place[node]] -= load[:, k]
    for bar in _own_bars(model, body):
        for end, node in enumerate(model.whole.bars[bar].ends):
            if node in place:
                out[:, place[node]] += _spatial(joint_force.sel(member=bar).values[:, end])
    return out


def _accelerations(forces: Forces) -> NDArray[np.float64]:
    """Accelerations in space (time, node, axis)."""
    t, x, v, a = (forces.motion.arrays[name].values for name in ("time", "position", "velocity", "acceleration"))
    if forces.attrs.get("at_rest", 0):
        v, a = 0 * v, 0 * a
    return rates_in_space(forces.attrs, t, x, v, a)[1]


def _with_actions(model: Model, forces: Forces) -> xr.DataArray:
    """Joint forces of members, with the actions on them (couples, pins, loads, bodies) counted at their nodes.

    Couples of motors that turn a bar in the plane and of friction are left out: they are not loads on the bearing.
    """
    joint_force = forces.whole["joint_force"].copy()
    for k, action in enumerate(actions_of(compile(model), forces.load_case).actions):
        if not action.counted and action.kind not in ("friction", "bearing"):
            joint_force[:, action.member] += forces.arrays["action_force"].values[:, k]
    return joint_force


def _shares(model: Model, body: str) -> Iterator[tuple[str, str, float, float]]:
    """Pairs (s, j) of mass-carrying nodes with m_sj, kg, and the skew part that multiplies a_j turned by 90 degrees."""
    record = model.whole.bodies[body]
    nodes = record.carried_by(model.dim)
    if not record.mass:
        return
    m, skew = body_mass(model.whole, record)
    for i, s in enumerate(nodes):
        for k, j in enumerate(nodes):
            yield s, j, float(m[i, k]), 0.0 if i == k else skew if i < k else -skew


def _own_loads(model: Model, forces: Forces, body: str) -> Iterator[tuple[tuple[str, ...], NDArray[np.float64]]]:
    """Nodes and forces (time, nodes, 3) equivalent to the loads on the body itself."""
    system, own = compile(model), set(model.whole.bodies[body].nodes)
    x = _spatial(forces.motion.arrays["position"].values)
    case = forces.load_case if forces.load_case in model.cases else None
    for name, push, amount in case_loads(system, forces.motion.arrays["time"].values, case, rotating=True).unit_loads:
        record = model.loads[name]
        mine = own.issuperset(record.face) if isinstance(record, Pressure) else getattr(record, "body", None) == body
        if mine:
            yield tuple(system.nodes[k] for k in push.nodes), amount[:, None, None] * push.forces(x[:, push.nodes])


def _own_couples(model: Model, forces: Forces, body: str) -> Iterator[tuple[tuple[str, ...], NDArray[np.float64]]]:
    """Nodes and forces (time, nodes, 3) on this body by the couples of drives, couplings and springs about axes."""
    system, own = compile(model), set(model.whole.bodies[body].nodes)
    x = _spatial(forces.motion.arrays["position"].values)
    for side in sides_of(system):
        names, (kind, name) = tuple(system.nodes[node] for node in side.nodes), side.source
        if side.turns and own.issuperset(names):
            torque = forces.whole[f"{kind}_force"].sel({kind: name}).values
            yield names, torque[:, None, None] * side_forces(system, side, x)


def _own_bars(model: Model, body: str) -> list[str]:
    """Rigid bars between nodes of the body."""
    own = set(model.whole.bodies[body].nodes)
    return [name for name, bar in model.whole.bars.items() if bar.kind == "rigid" and own.issuperset(bar.ends)]


def _spatial(y: NDArray[np.float64]) -> NDArray[np.float64]:
    """Vectors with three components."""
    if y.shape[-1] == 3:
        return y
    return np.concatenate([y, np.zeros((*y.shape[:-1], 1))], axis=-1)
