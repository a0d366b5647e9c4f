"""Forces of all members, reactions and drives along a given motion, with friction in bearings."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import moment
from kinetruss.dynamics.bearing_friction import couples_on_ends, friction_directions, jam, seats_of
from kinetruss.dynamics.force_tables import Read, force_arrays, forces_of, solved_in_space
from kinetruss.dynamics.imbalance import imbalance, imbalance_note, refuse_falling
from kinetruss.dynamics.least_norm import free_forces, least_norm
from kinetruss.errors import AnalysisError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.structure import EndForces, NodalLoads, States
from kinetruss.kernels.sweep.forces import applied, forces as sweep
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import (
    Arrangement,
    System,
    arrange,
    cached,
    compile,
    constraint_gradients,
    jacobian,
    not_unique_at_notes,
    not_unique_note,
    rearrange,
)
from kinetruss.mechanics.accuracy import NEAR, NOTHING, accuracy_note, error_of, lost
from kinetruss.mechanics.beam_shapes import STRAIGHT, FixedShapes, fixed_shapes
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.tables import nodal_loads, structure_of
from kinetruss.model import Model
from kinetruss.results import Forces, Motion, provenance
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray


TOGETHER = 16
"""Samples whose Jacobians are found at once."""
UNBALANCED = 1e-9
"""Residual of a singular position, as a fraction of what acts, that is more than round-off of loads and accelerations."""


# Forces with friction that follows from the joint forces: solved again with it until both agree.

CLOSE = 1e-12
"""Change of the couples that counts as none, relative to the largest."""
GROWN = 1e6
"""Growth of the change at which the couples count as unbounded."""
MOST = 200
"""Rounds; they take about as many as -12/log10(mu r/l) with the lengths l of the members."""


def with_friction(
    system: System,
    read: Read,
    loads: Loads,
    states: States,
    solve: Callable[[Loads], dict[str, Any]],
    *,
    at_rest: bool = False,
) -> dict[str, Any]:
    """What `solve` finds under loads and friction: its result, and the couples (times, bearings, 3), N m, as ``bearing``.

    Raises
    ------
    AnalysisError : the couples do not settle: the joints jam.

    Notes
    -----
    Fixed point C = -mu r |R(C)| w/|w| over the samples together; its rate is mu r/l, far below 1 where joints turn at all.
    """
    solved = solve(loads)
    seats = seats_of(system)
    if at_rest or not seats:
        return solved
    x, ways = states.x.reshape(len(states.x), -1, 3), friction_directions(system, states)
    couple, first = np.zeros_like(ways), None
    for _ in range(MOST):
        trial = solved | {"joint": solved["joint"].copy(), "bearing": couple}
        joint = forces_of(system, read, loads, trial, False)[0].joint_force
        force = np.stack([np.linalg.norm(joint[:, seat.member, seat.end], axis=1) for seat in seats], axis=1)
        found = -(np.array([seat.arm for seat in seats]) * force)[:, :, None] * ways
        change, couple = np.abs(found - couple).max(initial=0.0), found
        first = change if first is None else first
        if not change <= GROWN * first:
            break
        if change <= CLOSE * np.abs(found).max(initial=0.0):
            return solved | {"bearing": couple}
        solved = solve(with_bearing_friction(system, loads, x, couple))
    worst = seats[int(np.argmax(np.abs(couple).max(axis=(0, 2))))].name
    raise jam(worst)


def with_bearing_friction(system: System, loads: Loads, x: NDArray[np.float64], couple: NDArray[np.float64]) -> Loads:
    """Loads and the nodal forces of couples of friction."""
    nodes, forces = couples_on_ends(system, x, couple)
    return replace(
        loads,
        loads=(*loads.loads, *("friction" for _ in nodes)),
        node=np.concatenate([loads.node, nodes]),
        force=np.concatenate([loads.force, forces], axis=1),
    )


# Forces of all members, reactions and drives along a given motion.


@one_thread
def inverse(model: Model, motion: Motion, load_case: str | None = None, *, static: bool = True) -> Forces:
    """Inverse dynamics: the forces of all members, supports and drives along a motion.

    Parameters
    ----------
    motion : from `kinematics.follow`, `inverse`, `from_arrays` or `from_csv` of the same model.
    load_case : name of a load case; None takes all loads of the model with factor 1.
    static : also find the forces of the same poses at rest (``forces.static``; ``forces.difference()`` is the rest).

    Returns
    -------
    Forces. ``member_force`` (time, member): mean axial force over the length, N, tension positive; for an active member
    the force between base and tube, which is the actuator's. ``end_force`` (time, member, end): axial tension at A and B.
    ``joint_force`` (time, member, end, axis): force on the member from its joint. ``reaction`` (time, support, axis): force
    on the structure. ``drive_force`` (time, drive): N, for angles N m; positive if it does positive work when the coordinate
    grows; ``coupling_force`` (time, coupling) likewise, if there are couplings. ``interface_force``, ``interface_moment``:
    between base and tube, on the base, in member axes, at the tube's free end. ``energy``, ``power``, ``energy_rate``,
    ``energy_balance``: J and W. If anything other than weight, inertia and joints acts on a member (the couple of a drive or
    coupling, a pin on it, a load, a body): ``action_force`` (time, action, end, axis) N, the equivalent forces at its ends;
    ``action_couple`` (time, action, rotation) N m at ``action_place`` (time, action), a fraction from A, NaN if distributed
    along the member; coordinates ``action_member`` and ``action_source``. ``joint_force``, ``end_force`` and ``member_force``
    are without these actions. ``bearing_couple`` (time, bearing, rotation): of friction on the members of bearings, N m;
    ``forces.static`` is without it.

    Raises
    ------
    InputError : an unknown load case, or a motion of another model. AnalysisError : bearings that jam, a singular position.

    Notes
    -----
    J^T N = f - M a with consistent masses, the multiplier of a bar being its mean tension. In redundant structures the
    forces minimise sum N^2 l/(E A) if every bar of the state of self-stress has E and A, else sum N^2;
    ``data.attrs["not_unique"]`` names the members, and ``message`` reports them. So they do at samples in singular positions,
    where ``data.attrs["not_unique_at"]`` has by member the times.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=2.0)}, fixed=["O"],
    ...     bars={"crank": kt.Bar(ends=("O", "A"), mass=0)}, drives={"motor": kt.AngleDrive("crank")},
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"motor": 10.0}, duration=0.1), samples=3)
    >>> forces = kt.dynamics.inverse(crank, motion)
    >>> forces.member_force.sel(member="crank").values.round(6).tolist()  # N: m r w^2
    [100.0, 100.0, 100.0]
    """
    system = compile(model)
    check_motion(system, motion, members=True)
    states = States(*(flat(system, motion, name) for name in ("position", "velocity", "acceleration")))
    loads = case_loads(system, motion.arrays["time"].values, load_case, rotating=True).at(states.x)
    values = motion.arrays["drive_position"].values
    solved = with_friction(system, Read.of(motion), loads, states, lambda pushed: solve(system, values, pushed, states))
    still = None
    if static:
        still = _record(system, motion, loads, solve(system, values, loads, _at_rest(states)), None, at_rest=True)
    return _record(system, motion, loads, solved, still, at_rest=False)


def at_rest(system: System, motion: Motion, loads: Loads, closed: NDArray[np.bool_] | None = None) -> Forces:
    """Forces of the poses of a motion at rest, under given loads, as a separate record; closed (times,) : as of `_record`."""
    check_motion(system, motion, members=True)
    x = flat(system, motion, "position")
    loads = loads.at(x)
    solved = solve(system, motion.arrays["drive_position"].values, loads, _at_rest(States(x, x, x)))
    if closed is not None:
        refuse_falling(system, loads, solved)
    return _record(system, motion, loads, solved, None, at_rest=True, closed=closed)


def _at_rest(states: States) -> States:
    """The same positions at rest; velocities and accelerations are one row of zeros for all samples."""
    still = np.zeros((1, states.x.shape[1]))
    return States(states.x, still, still)


def flat(system: System, motion: Motion, name: str) -> NDArray[np.float64]:
    """A node history as (times, 3 n), z = 0 in the plane."""
    values = motion.arrays[name].values
    if system.dim == 3:
        return np.ascontiguousarray(values).reshape(len(values), -1)
    full = np.zeros((len(values), len(system.nodes), 3))
    full[:, :, : system.dim] = values
    return full.reshape(len(values), -1)


def solve(system: System, values: NDArray[np.float64], loads: Loads, states: States) -> dict[str, Any]:
    """Constraint forces N (times, rows), joint forces (times, members, 2, 3), residuals at nodes (times, 3 n), N, and the
    constraints whose force is not unique, at drive values (times, drives); with the states, in space if the base rotates.

    ``singular`` : of singular samples the constraints whose force is not unique there. ``near`` : of samples near singular
    positions what `lost` finds. ``of`` : the system that these are of.
    """
    return solved_in_space(system, loads, states, lambda pushed, space: _solve(system, values, pushed, space))


def _solve(system: System, values: NDArray[np.float64], loads: Any, states: States) -> dict[str, Any]:
    x, arrangement = states.x, arrange(system)
    held = None if arrangement.plan is not None else fixed_shapes(system)
    # beams that keep their shape carry what rigid ones would
    if held is not None and np.abs(modes := held.modes(x.reshape(len(x), -1, 3))).max(initial=0.0) < STRAIGHT:
        return _solve_fixed_shapes(held, modes, values, loads, states)
    values = np.ascontiguousarray(values)
    count = len(x)
    N, joint, rest = allocate((count, len(system.row_member)), (count, len(system.members), 2, 3), (count, system.x0.size))
    ends = EndForces(joint, rest)
    solved: dict[str, Any] = {"x": x, "v": states.v, "a": states.a, "N": N, "joint": joint, "rest": rest}
    solved |= {"not_unique": arrangement.not_unique, "near": {}, "singular": {}, "of": system}
    if arrangement.plan is None:
        solved["not_unique"], solved["singular"] = free_forces(system, loads, values, states, N, ends)
        return solved | {"left": imbalance(system, loads, x, rest, joint, len(states.v) == 1)}
    pivot, whole, acting = np.ones(count), structure_of(system), nodal_loads(loads)
    for part, used in _pieces(system, arrangement, x, values):
        plan: Any = used.plan
        sweep(
            plan,
            used.weight[plan.row],
            whole,
            _given(acting, part),
            values[part],
            _cut(states, part),
            N[part],
            EndForces(joint[part], rest[part]),
            pivot[part],
        )
        solved["not_unique"] = solved["not_unique"] | used.not_unique
        for k in (part.start + np.flatnonzero(pivot[part] < NEAR)).tolist():
            solved["near"][k] = near = lost(system, used, x[k].tobytes())
            if error_of(*near) >= NOTHING:
                solved["singular"][k] = _singular(system, values, acting, states, k, N, ends)
    return solved


def _singular(
    system: System,
    values: NDArray[np.float64],
    loads: NodalLoads,
    states: States,
    k: int,
    N: NDArray[np.float64],
    ends: EndForces,
) -> NDArray[np.bool_]:
    """Fill N and the ends of a singular sample k with the forces of least norm; returns the mask of constraints whose force is
    not unique there.

    Raises AnalysisError where none balance what acts, because it has a part along a motion that nothing holds.
    """
    one = slice(k, k + 1)
    here, (joint, rest) = _cut(states, one), EndForces(ends.joint[one], ends.rest[one])
    applied(structure_of(system), _given(loads, one), here, EndForces(joint, rest))
    parts = (loads.force[one], joint, _moving_mass(system) * here.a, _moving_mass(system) * loads.gravity)
    size = sum(float(np.abs(part).max(initial=0.0)) for part in parts)
    not_unique, _ = least_norm(system, values[one], here.x, N[one], EndForces(joint, rest))
    if float(np.abs(rest[0, system.free]).max()) > UNBALANCED * max(size, float(np.abs(N[k]).max())):
        raise AnalysisError(
            f"Position {k} of {len(N)} is singular: drives and bars leave a motion free there, along which loads or "
            "inertia act, so that no forces balance them. Take another position, or let the parts move (dynamics.simulate)."
        )
    return not_unique


@cached()
def _moving_mass(system: System) -> float:
    """About the mass of all parts, kg."""
    parts = (system.lump, system.pair_mass, system.rods[:, [0, 3]], system.body[:, 0])
    return sum(float(np.abs(one).sum()) for one in parts)


def _given(loads: NodalLoads, part: slice) -> NodalLoads:
    """A range of the histories of loads."""
    return loads._replace(force=loads.force[part], t=loads.t[part] if len(loads.t) > 1 else loads.t)


def _solve_fixed_shapes(
    held: FixedShapes, modes: NDArray[np.float64], values: NDArray[np.float64], loads: Any, states: States
) -> dict[str, Any]:
    """`solve` of beams that keep their shape but for modes (times, k, s) of round-off, with the forces of their modes,
    ``mode_force`` (times, beams, s), N m; or, where balance alone does not decide these, the names of the beams, ``undecided``.
    """
    solved, first = solve(held.system, values, loads, states), held.rows[0, 0]
    solved["joint"][:, held.chords] = 0.0
    own: dict[str, Any] = {"N": solved["N"][:, :first], "not_unique": solved["not_unique"][:first]}
    own["singular"] = {k: mask[:first] for k, mask in solved["singular"].items()}
    if undecided := held.undecided(solved["not_unique"]):
        own["undecided"] = undecided
    else:
        own["mode_force"] = held.mode_forces(solved["N"], modes)
    return solved | own


def _pieces(
    system: System, arrangement: Arrangement, x: NDArray[np.float64], values: NDArray[np.float64]
) -> list[tuple[slice, Arrangement]]:
    """Ranges of samples, each with the arrangement that is regular in it; one range unless the structure is redundant.

    A new set of independent constraints is chosen when the smallest singular value of the present one falls to a tenth.
    """
    count = len(x)
    if not len(arrangement.redundant):
        return [(slice(0, count), arrangement)]
    pieces: list[tuple[int, Arrangement]] = []
    kept, best = np.zeros(0, np.int64), np.inf
    for first in range(0, count, TOGETHER):
        part = slice(first, first + TOGETHER)
        J = constraint_gradients(system, x[part].reshape(-1, *system.x0.shape), values[part])[:, :, system.free]
        for i, own in enumerate(J, first):
            if pieces and _least(own[kept]) >= 0.1 * best:
                continue
            found = _chosen(system, x[i].tobytes(), values[i].tobytes())
            pieces.append((i, found))
            if i + 1 < count:
                kept, best = _conditioned(system, x[i].tobytes(), values[i].tobytes())
    ends = [*(i for i, _ in pieces[1:]), count]
    return [(slice(i, end), found) for (i, found), end in zip(pieces, ends, strict=True)]


@cached(16)
def _chosen(system: System, x: bytes, values: bytes) -> Arrangement:
    """Arrangement at one sample; equal for all load cases."""
    place, drives = np.frombuffer(x).reshape(-1, 3), np.frombuffer(values)
    start = np.array_equal(place, system.x0) and np.array_equal(drives, system.drive_start)
    found = arrange(system) if start else rearrange(system, place, drives)
    return found if found.plan is not None else arrange(system)


@cached(16)
def _conditioned(system: System, x: bytes, values: bytes) -> tuple[NDArray[np.int64], float]:
    """The independent constraints at one sample, and their smallest singular value."""
    J = jacobian(system, np.frombuffer(x).reshape(-1, 3), np.frombuffer(values))
    kept = np.setdiff1d(np.arange(len(J)), _chosen(system, x, values).redundant)
    return kept, _least(J[kept])


def _least(J: NDArray[np.float64]) -> float:
    """Smallest singular value; infinite if nothing can move or there are no constraints."""
    return float(np.linalg.svd(J, compute_uv=False)[-1]) if J.size else np.inf


def _cut(states: States, part: slice) -> States:
    """A range of histories; at rest velocities and accelerations are one row for all samples."""
    still = len(states.v) == 1
    return States(states.x[part], states.v if still else states.v[part], states.a if still else states.a[part])


def _record(
    system: System,
    motion: Motion,
    loads: Any,
    solved: dict[str, Any],
    static: Forces | None,
    *,
    at_rest: bool,
    closed: NDArray[np.bool_] | None = None,
) -> Forces:
    """The Forces record of one solution; closed (times,) : positions that are closed from lengths."""
    data = force_arrays(system, motion, loads, solved, at_rest)
    names = system.parts_of(np.flatnonzero(solved["not_unique"]))
    data.attrs.update({"kind": "forces", "load_case": loads.name, "not_unique": names, "at_rest": int(at_rest)})
    left = solved.get("left", {})
    said = [motion.message, imbalance_note(system, left, at_rest)]
    if off := left.get("off") or left.get("adrift"):
        data.attrs["not_balanced"] = off
    if undecided := solved.get("undecided", ()):
        data.attrs["undecided"] = list(undecided)
        said.append(
            f"Balance alone does not decide the forces of the beams {', '.join(undecided[:8])}, nor those of "
            "supports that they stand on; an equilibrium does (in the model file: statics.equilibrium)."
        )
    if (note := not_unique_note(names)) not in motion.message:  # the equilibrium of a run says it already
        said.append(note)
    if solved["singular"] or solved["near"]:
        poses = [repr(str(name)) for name in motion.whole["pose"].values] if "pose" in motion.whole.coords else []
        if at := _not_unique_at(system, motion, solved, names):
            data.attrs["not_unique_at"] = at
        said += [*not_unique_at_notes(at, poses), _digits_lost(motion, solved, poses, closed)]
    return Forces(
        data=data.later,
        status=motion.status,
        message=" ".join(filter(None, said)),
        provenance=provenance(system.given, load_case=loads.name),
        motion=motion,
        static=static,
        load_case=loads.name,
    )


def _not_unique_at(system: System, motion: Motion, solved: dict[str, Any], everywhere: list[str]) -> dict[str, list[float]]:
    """By member the times of singular samples at which its force is not unique; without those `everywhere`, at all times."""
    time, found = motion.arrays["time"].values, dict[str, list[float]]()
    for k, mask in solved["singular"].items():
        for name in system.parts_of(np.flatnonzero(mask)):
            if name not in everywhere:
                found.setdefault(name, []).append(float(time[k]))
    return found


def _digits_lost(motion: Motion, solved: dict[str, Any], poses: list[str], closed: NDArray[np.bool_] | None) -> str:
    """The sentence on the least accurate forces of samples that are not singular; empty if they have seven digits."""
    errors = {
        k: error_of(round_off, ratio, 2 if closed is not None and closed[k] else 1)
        for k, (round_off, ratio) in solved["near"].items()
        if k not in solved["singular"]
    }
    if not errors:
        return ""
    worst = max(errors, key=errors.__getitem__)
    own: System = solved["of"]
    said = accuracy_note(own, solved["x"][worst].reshape(-1, 3), errors[worst])
    where = moment(float(motion.arrays["time"].values[worst]), poses)
    return f"{f'P{where[1:]}' if poses else f'At {where}'}: {said}" if said else ""
