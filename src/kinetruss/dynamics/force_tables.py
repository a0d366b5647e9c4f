"""The arrays of a Forces record from the solved forces, and what a rotating base adds to them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from kinetruss.dynamics.actions import Acting, CarriedBy, on_rods
from kinetruss.dynamics.bar_actions import (
    BarActions,
    acting_along,
    action_coordinates,
    action_variables,
    actions_of,
    adds_tension,
    mean_tension,
    take_off,
)
from kinetruss.dynamics.bearing_friction import relative_rates
from kinetruss.elements.beams import MODES
from kinetruss.elements.kinds import present
from kinetruss.elements.loads.load import Spread
from kinetruss.elements.local_axes import local_axes
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.sections.records import Actives, interface
from kinetruss.kernels.structure.lengths import end_tensions
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, EndForces, NodalLoads, States, Structure
from kinetruss.kernels.sweep.forces import applied, energies
from kinetruss.kinematics.turns import Passed, refined
from kinetruss.mechanics import System, cached, ends_of
from kinetruss.mechanics.elements import fed, named_motions, refuse_turns
from kinetruss.mechanics.loads import Loads
from kinetruss.mechanics.matrices import bar_laws
from kinetruss.mechanics.rotating_base import ROTATION
from kinetruss.mechanics.tables import nodal_loads, structure_arrays, structure_of
from kinetruss.results import Arrays, Axes, Column, Motion, variable
from kinetruss.results.user_parts import part_axes, reactions, support_axes
from kinetruss.results.wide_tables import element_axes, element_columns, force_units, other_columns

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from kinetruss.mechanics import BeamElements, Continua


def in_space(loads: Loads, states: States) -> States:
    """States with velocities and accelerations in space; as given where the base does not rotate.

    Accelerations are less the change of gravity, if it turns: with the gravity of `loads` they give a - g.
    """
    if loads.base is None:
        return states
    x, v, a = (y.reshape(len(y), -1, 3) for y in states)
    moving = np.broadcast_to(loads.base.velocities(x, v), x.shape)
    felt = loads.base.accelerations(x, v, a, loads.base.gravity_change(loads.t, loads.gravity))
    return States(states.x, *(np.ascontiguousarray(np.broadcast_to(y, x.shape)).reshape(len(x), -1) for y in (moving, felt)))


def solved_in_space(
    system: System, loads: Loads, states: States, solve: Callable[[Loads, States], dict[str, Any]]
) -> dict[str, Any]:
    """What `solve` finds with states in space; the states relative to the base are its ``relative``.

    Elements resist relative velocities: the difference acts as forces on nodes.
    """
    if loads.base is None:
        return solve(loads, states)
    space = in_space(loads, states)
    if present(system):
        whole = structure_of(system)
        change = _nodal(whole, system, states) - _nodal(whole, system, space) + fictitious_forces(system, states, space)
        loads = _with(loads, change.reshape(len(change), -1, 3))
    return solve(loads, space) | {"relative": states}


def fictitious_forces(system: System, states: States, space: States) -> NDArray[np.float64]:
    """Centrifugal, Euler and Coriolis forces at the nodes (times, 3 n), N: -M (a - a_rel) and the convective terms.

    With the consistent masses of members and bodies: accelerations of a rotating frame are linear in position and velocity.
    """
    masses = _masses(system)
    return _nodal(masses, system, space) - _nodal(masses, system, states)


@cached()
def _masses(system: System) -> Structure:
    """The element tables of masses alone."""
    table = structure_arrays(system)
    return Structure.of(table | {name: values[:0] for name, values in table.items() if name.startswith(("law", "element"))})


def _nodal(structure: Structure, system: System, states: States) -> NDArray[np.float64]:
    """f - M a of the elements at the nodes (times, 3 n), N, without gravity and loads."""
    joint, rest = np.zeros((len(states.x), len(system.members), 2, 3)), np.zeros_like(states.x)
    none, force = np.zeros(0, np.int64), np.zeros((len(states.x), 0, 3))
    nothing = NodalLoads(np.zeros(3), np.zeros_like(system.x0), none, force, np.zeros(1))
    applied(structure, nothing, states, EndForces(joint, rest))
    return rest


def _with(loads: Loads, force: NDArray[np.float64]) -> Loads:
    """Loads and forces (times, n, 3) on all nodes."""
    return replace(
        loads,
        loads=(*loads.loads, *("base" for _ in range(force.shape[1]))),
        node=np.concatenate([loads.node, np.arange(force.shape[1])]),
        force=np.concatenate([loads.force, force], axis=1),
    )


# Computes the arrays of a Forces record from the solved forces.


class Read(NamedTuple):
    """Data of a motion other than its nodes: lengths and their rates (times, members), drives (times, drives)."""

    length: NDArray[np.float64]
    length_rate: NDArray[np.float64]
    drive_position: NDArray[np.float64]
    drive_velocity: NDArray[np.float64]

    @classmethod
    def of(cls, motion: Motion) -> Read:
        """The data of a Motion."""
        return cls(*(motion.arrays[name].values for name in cls._fields))


class Carried(NamedTuple):
    """Forces along a motion, N or N m, as in the whole of a `Forces` record, with three components everywhere; reaction is its
    ``held_force`` where there are inner nodes.

    member_force (times, members); end_force (times, members, 2); joint_force (times, members, 2, 3); reaction (times,
    supports, 3); drive_force (times, drives); coupling_force (times, couplings). not_unique (members,): True if redundant, so
    that the force is one of many.
    """

    member_force: NDArray[np.float64]
    end_force: NDArray[np.float64]
    joint_force: NDArray[np.float64]
    reaction: NDArray[np.float64]
    drive_force: NDArray[np.float64]
    coupling_force: NDArray[np.float64]
    not_unique: NDArray[np.bool_]


def forces_of(
    system: System, read: Read, loads: Any, solved: dict[str, Any], at_rest: bool
) -> tuple[Carried, BarActions, Acting]:
    """Forces of members, supports and drives, and the actions on bars. `solved` holds flat x, v, a (times, 3 n), N, joint,
    rest; the actions are subtracted from its joint forces. With ``relative`` the base rotates, and v and a are those in space.
    """
    joint, rest = solved["joint"], solved["rest"]
    count = len(rest)
    drive_force = _drive_forces(system, read, solved["N"], rest)
    coupling_force = _coupling_forces(system, solved["N"])
    mean = _member_forces(system, read, solved["N"], at_rest)
    index, fixed = _supports(system)
    reaction = np.where(fixed, -rest.reshape(count, len(system.nodes), 3)[:, index], 0.0)
    by = _carried_by(system, mean, reaction, solved.get("bearing", np.zeros((count, 0, 3))))
    states = States(solved["x"], _relative(solved).v, solved["a"])
    found, acting = acting_along(system, loads, states, drive_force, coupling_force, carried=by)
    take_off(joint, found, acting)
    (tension,) = allocate((count, len(system.members), 2))
    end_tensions(system.p, system.q, solved["x"], joint, tension)
    if any(adds_tension(action) for action in found.actions):
        mean += mean_tension(system, found.actions, acting, solved["x"])
    unsure = np.zeros(len(system.members), np.bool_)
    if "not_unique" in solved and (rows := solved["not_unique"]).any():
        unsure[system.row_member[rows & (system.row_measure < 0)]] = True
    return Carried(mean, tension, joint, reaction, drive_force, coupling_force, unsure), found, acting


def force_arrays(system: System, motion: Motion, loads: Any, solved: dict[str, Any], at_rest: bool) -> Arrays:
    """All arrays of a Forces record; `solved` as for `forces_of`."""
    dim, per, read = system.dim, ("time", "member"), Read.of(motion)
    every, found, acting = forces_of(system, read, loads, solved, at_rest)
    data = {
        "member_force": variable(per, every.member_force, "N", "mean axial force, tension positive"),
        "end_force": variable((*per, "end"), every.end_force, "N", "axial tension at end A (first node), end B"),
        "joint_force": variable((*per, "end", "axis"), every.joint_force[..., :dim], "N", "force on the member from its joint"),
        "drive_force": variable(("time", "drive"), every.drive_force, force_units(system)[0]["drive"], "drive force or torque"),
    }
    on = named_motions(system, solved["x"], _relative(solved).v) if system.force_elements else None
    x = solved["x"].reshape(len(solved["x"]), len(system.nodes), 3)
    data |= reactions(system, ("time",), x, every.reaction, every.coupling_force, None if on is None else on.force)
    if system.model.couplings:
        words = "force or torque on the coupled coordinate"
        data["coupling_force"] = variable(("time", "coupling"), every.coupling_force, force_units(system)[0]["coupling"], words)
    if on is not None:
        if not at_rest:
            whole = refined(motion.arrays["time"].values, *_relative(solved), Passed.of(system, motion))
            refuse_turns(system, whole.t, whole.x, whole.v)
        data |= element_columns(system, ("time",), on.force, on.value)
    data |= other_columns(system, ("time",), solved["x"], _relative(solved).v, np.asarray(loads.t, float))
    if "bearing" in solved:
        turns = slice(2, 3) if dim == 2 else slice(0, 3)
        couples, words = solved["bearing"][..., turns], "couple of friction on the member of the bearing"
        data["bearing_couple"] = variable(("time", "bearing", "rotation"), couples, "N m", words)
    if "mode_force" in solved:
        words = "force of the deformation mode of a beam that keeps its shape"
        data["mode_force"] = variable(("time", "beam", "mode"), solved["mode_force"], "N m", words)
    data |= action_variables(system, acting) | _interfaces(system, loads, solved, found, acting)
    if not at_rest:
        data |= _power(system, read, loads, solved, every.drive_force)
    attrs = {"gravity": loads.gravity[:dim].tolist()}
    if loads.base is not None:
        attrs[ROTATION] = loads.base.numbers
    return Arrays(_axes(system, loads.name, "mode_force" in solved), motion.arrays["time"].values, data, attrs)


@cached(of_records=True)
def _fixed_coordinates(system: System) -> NDArray[np.int64]:
    """Flat coordinates that supports fix; the force of a drive is its drive_force instead."""
    mask = system.prescribed.copy()
    mask[system.coordinate_drive[:, 0]] = False
    return np.flatnonzero(mask)


@cached(of_records=True)
def _supports(system: System) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Nodes of supports, and the coordinates (supports, 3) that they fix."""
    index = np.array([system.node_index(name) for name in system.supports], np.int64)
    mask = np.zeros(system.x0.shape, np.bool_)
    mask.reshape(-1)[_fixed_coordinates(system)] = True
    return index, mask[index]


@cached(of_records=True)
def _row_of(system: System) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Index of the length constraint of each member (the last index if it has none), and the mask of members without one."""
    axial = np.flatnonzero(system.row_kind == LENGTH)
    row = np.full(len(system.members), -1)
    row[system.row_member[axial]] = axial
    return row, np.flatnonzero(row < 0)


@cached()
def _driven_rows(system: System) -> tuple[tuple[int, int, float, int], ...]:
    """Constraints of drives: constraint, drive, scale of its value, and the member whose length is its arm (-1: none)."""
    found = []
    for r in np.flatnonzero(system.row_drive >= 0):
        m, arm = int(system.row_measure[r]), int(system.row_member[r]) if system.row_kind[r] == ANGLE else -1
        scale, arm = (float(system.measure_scale[m]), -1) if m >= 0 else (1.0, arm)
        found.append((int(r), int(system.row_drive[r]), scale, arm))
    return tuple(found)


def _carried_by(
    system: System, mean: NDArray[np.float64], reaction: NDArray[np.float64], couple: NDArray[np.float64]
) -> CarriedBy | None:
    """Forces of truss bars, and of supports at all nodes, from those of the supports (times, supports, 3); None if nothing
    depends on them.
    """
    if not (system.model.hubs or system.model.bearings):
        return None
    support = np.zeros((len(mean), len(system.nodes), 3))
    support[:, _supports(system)[0]] = reaction
    return CarriedBy(mean.copy(), support, couple)


def _relative(solved: dict[str, Any]) -> States:
    """Positions, velocities and accelerations relative to the base."""
    found = solved.get("relative")
    return States(solved["x"], solved["v"], solved["a"]) if found is None else cast("States", found)


@cached()
def _axes(system: System, case: str, shaped: bool) -> Axes:
    members = np.array(system.members, dtype=object).astype(str)
    couplings = {"coupling": list(system.model.couplings)} if system.model.couplings else {}
    couplings |= element_axes(system)
    if system.model.bearings:
        couplings["bearing"] = list(system.model.bearings)
    if shaped:
        beams = cast("BeamElements", cast("Continua", system.continua).beams)
        couplings |= {"beam": list(beams.names), "mode": list(MODES[system.dim])}
    return Axes(
        couplings
        | force_units(system)[1]
        | action_coordinates(system, actions_of(system, case))
        | part_axes(system)
        | support_axes(system)
        | {
            "drive": np.array(system.drives, dtype=object).astype(str),
            "end": ["A", "B"],
            "active": members[system.two_rods],
            "component": ["axial", "shear_2", "shear_3"][: system.dim],
            "moment": ["moment_3"] if system.dim == 2 else ["moment_2", "moment_3"],
        }
    )


def _member_forces(system: System, read: Read, N: NDArray[np.float64], at_rest: bool) -> NDArray[np.float64]:
    row, without = _row_of(system)
    found = N.take(row, axis=1) if N.shape[1] else np.empty((len(N), len(row)))
    if len(without):
        found[:, without] = 0.0
    if system.law.any():
        found += bar_laws(system, read.length, None if at_rest else read.length_rate).tension
    return found


def _drive_forces(system: System, read: Read, N: NDArray[np.float64], rest: NDArray[np.float64]) -> NDArray[np.float64]:
    """Drive forces (times, drives): constraint forces, and minus the residual at prescribed coordinates."""
    found = np.zeros((len(N), len(system.drives)))
    for flat, d in system.coordinate_drive:
        found[:, d] = -rest[:, flat]
    for r, d, scale, arm in _driven_rows(system):
        found[:, d] = -N[:, r] * (read.length[:, arm] if arm >= 0 else scale)
    return found


def _coupling_forces(system: System, N: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coupling forces (times, couplings) on each sum of coordinates, per m or rad of the sum: minus its multiplier."""
    names = list(system.model.couplings)
    found = np.zeros((len(N), len(names)))
    for r in system.sums:
        m = system.row_measure[r]
        if system.measures[m] in system.model.couplings:
            found[:, names.index(system.measures[m])] = -N[:, r] * system.measure_scale[m]
    return found


def _interfaces(system: System, loads: Any, solved: dict[str, Any], found: BarActions, acting: Acting) -> dict[str, Column]:
    active = np.flatnonzero(system.two_rods)
    if not len(active):
        return {}
    x = solved["x"]
    axes = local_axes(system, x.reshape(len(x), len(system.nodes), 3)[:, :, : system.dim], active)
    force, moment = (np.empty((len(x), len(active), 3)) for _ in range(2))
    ends = {"p": system.p[active], "q": system.q[active]}
    actives = Actives.of({"member": active, **ends, "tube": system.own_rods[active, 4], "rods": system.rods[active]})
    states = States(x, solved["v"], solved["a"])
    interface(actives, states, solved["joint"], loads.gravity, axes, force, moment)
    column = {int(i): k for k, i in enumerate(active)}
    for k, action in enumerate(found.actions):
        if action.member not in column:
            continue
        at = column[action.member]
        if action.place == 1.0:  # a couple on the tube acts on the base at their interface
            moment[:, at] += np.einsum("tkc,tc->tk", axes[:, at], acting.couple[:, k])
        elif isinstance(action.place, Spread):  # what the tube takes of a load along both
            length = ends_of(system, x.reshape(len(x), len(system.nodes), 3), action.member)[1]
            nut = np.maximum(0.0, 1.0 - system.own_rods[action.member, 4] / length)
            _, (share, first) = on_rods(action.place.ratio or (1.0, 1.0), nut)
            q = np.einsum("tkc,tc->tk", axes[:, at], acting.worth[:, k].sum(axis=1))
            force[:, at] += share[:, None] * q
            arm = (first - nut * share) * length
            moment[:, at, 1] -= arm * q[:, 2]
            moment[:, at, 2] += arm * q[:, 1]
    per = ("time", "active")
    kept = slice(2, 3) if system.dim == 2 else slice(1, 3)
    where = "of the tube on the base, member axes, at the tube's free end"
    return {
        "interface_force": variable((*per, "component"), force[..., : system.dim], "N", f"force {where}"),
        "interface_moment": variable((*per, "moment"), moment[..., kept], "N m", f"moment {where}"),
    }


def _power(
    system: System,
    read: Read,
    loads: Any,
    solved: dict[str, Any],
    drive_force: NDArray[np.float64],
) -> dict[str, Column]:
    """Energy, its rate, and the power supplied; relative to the base, if it rotates, with the power of fictitious forces."""
    (x, v, a), held = _relative(solved), _fixed_coordinates(system)
    energy = np.empty((len(x), 3))
    energies(structure_of(system), nodal_loads(loads), States(x, v, a), energy)
    # sums of rows, not einsum, whose order of terms is another for one sample alone than for many
    power = (drive_force * read.drive_velocity).sum(axis=1)
    if len(loads.node):
        nodal = v.reshape(len(v), len(system.nodes), 3)
        power += (loads.force * nodal[:, loads.node]).sum(axis=(1, 2))
    if loads.base is not None:
        pushed = fictitious_forces(system, States(x, v, a), States(x, solved["v"], solved["a"]))
        power += (pushed * v).sum(axis=1)
    if "bearing" in solved:
        place, moving = (y.reshape(len(y), -1, 3) for y in (x, v))
        energy[:, 2] -= (solved["bearing"] * relative_rates(system, place, moving)).sum(axis=(1, 2))
    power -= (solved["rest"][:, held] * v[:, held]).sum(axis=1)
    time = ("time",)
    resists = system.damping.any() or any(one.loses(record) for one, record in present(system)) or "bearing" in solved
    words = f"power that dampers and friction take{', less what elements give' * fed(system)}"
    lost = {"dissipation": variable(time, energy[:, 2], "W", words)} if resists else {}
    return lost | {
        "energy": variable(time, energy[:, 0], "J", "kinetic and potential energy"),
        "energy_rate": variable(time, energy[:, 1], "W", "rate of kinetic and potential energy"),
        "power": variable(time, power, "W", "power of drives, loads and moving supports"),
        "energy_balance": variable(
            time, power - energy[:, 1] - energy[:, 2], "W", "power minus rate of energy and dissipation"
        ),
    }
