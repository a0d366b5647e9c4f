"""Poses near another that satisfy all lengths, moves between good poses, and what a pose at rest gives."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import dynamics, kinematics, statics
from kinetruss.actuators.demands import columns_of
from kinetruss.display import quantity
from kinetruss.errors import AnalysisError, KinetrussError
from kinetruss.kinematics.positions import assembled, refuse_unmet
from kinetruss.mechanics import arrange, compile
from kinetruss.mechanics.positions import drive_values
from kinetruss.model import Active, LengthDrive, Model, Quintic, turns
from kinetruss.results import Row
from kinetruss.statics.search import row_errors
from kinetruss.strength import check
from kinetruss.strength.beam_verdict import beam_parts, chords_of
from kinetruss.strength.findings import Finding, find
from kinetruss.strength.verdict import strength_histories, worst_of
from kinetruss.viewer.moving import moving

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.results import Forces, Verdict

    Pose = NDArray[np.float64]


CLOSED = 1e-10
"""Largest error of a length in a pose that is shown, as a fraction of the size of the structure."""

EXACT = 1e-13
"""Error of a length below which a pose is not corrected, as a fraction of the size."""


def gap(model: Model, position: Pose, values: Mapping[str, float]) -> tuple[float, str]:
    """Largest error of a length, angle or coordinate at a pose (n_nodes, dim), as a fraction of the size, and its name."""
    system = compile(model)
    x = _full(system, position)
    return _gap(system, x, _wanted(system, values), values)


def closed(model: Model, position: Pose, values: Mapping[str, float]) -> Pose:
    """The pose with drives at `values`, reached from a pose (n_nodes, dim) by changing all lengths together.

    Raises
    ------
    AnalysisError : there is no continuous path to it. InputError : lengths that contradict each other.
    """
    system = compile(model)
    x, wanted = _full(system, position), _wanted(system, values)
    if _gap(system, x, wanted, values)[0] <= EXACT:
        return position
    here = replace(system, x0=x)
    found, reached = assembled(here, wanted, _pushed(system, values))
    if reached == 1:
        refuse_unmet(here, found, wanted)
    miss, what = _gap(system, found, wanted, values)
    if reached < 1 or not miss <= CLOSED:
        miss, what = _gap(system, x, wanted, values)
        raise AnalysisError(
            f"The lengths cannot be closed from the pose shown, where {what!r} is off by {miss:.2g} of the structure's size: "
            f"{reached:.1%} of the way was reached."
        )
    return found[:, : system.dim].copy()


def present_values(model: Model, position: Pose) -> dict[str, float]:
    """Drive values of a model at a pose (n_nodes, dim), m or rad; angles within half a turn of the model's own."""
    system = compile(model)
    x = _full(system, position)[None]
    now = drive_values(system, x, 0 * x, 0 * x)[0][0]
    found = {}
    for name, own, value in zip(system.drives, system.drive_start, now, strict=True):
        apart = float(value - own)
        turned = np.remainder(apart + np.pi, 2 * np.pi) - np.pi
        found[name] = float(own) + float(turned) if turns(model.all_drives[name]) else float(value)
    return found


def _gap(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], values: Mapping[str, float]) -> tuple[float, str]:
    size = float(np.ptp(x, axis=0).max()) or 1.0
    misses = np.abs(row_errors(system, x, wanted))
    found = [(float(misses.max()), system.part_of(int(misses.argmax())))] if len(misses) else []
    flat = x.reshape(-1)
    found += [(abs(float(flat[at]) - values[system.drives[d]]), system.drives[d]) for at, d in system.coordinate_drive]
    miss, what = max(found, default=(0.0, ""))
    return miss / size, what


def _wanted(system: System, values: Mapping[str, float]) -> NDArray[np.float64]:
    """Target of every constraint with the drives at `values`."""
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = np.array([values[name] for name in system.drives])[system.row_drive[driven]]
    return wanted


def _pushed(system: System, values: Mapping[str, float]) -> NDArray[np.float64] | None:
    coordinates = system.coordinate_drive[:, 1]
    return np.array([values[system.drives[d]] for d in coordinates]) if len(coordinates) else None


def _full(system: System, position: Pose) -> NDArray[np.float64]:
    full = np.zeros_like(system.x0)
    full[:, : system.dim] = position
    return full


def posed(model: Model, position: NDArray[np.float64], values: Mapping[str, float]) -> Model:
    """The model in another pose: with its node positions, and driven members with their lengths there."""
    nodes = {
        name: node.model_copy(update={"at": tuple(map(float, position[k]))})
        for k, (name, node) in enumerate(model.nodes.items())
    }
    # a rigid bar without a given length has that of its node positions; keep it to the last bit
    whole = model.whole
    lengths = {name: math.dist(*(whole.nodes[end].at for end in whole.bars[name].ends)) for name in model.bars}
    bars = {
        name: bar.model_copy(update={"length": lengths[name]})
        if bar.kind == "rigid" and bar.length is None
        else bar.model_copy(update={"length": values.get(name)})
        if bar.kind == "driven" and name in values
        else bar.model_copy(update={"natural_length": lengths[name]})
        if bar.kind in ("elastic", "cable") and bar.natural_length is None and bar.pretension is None
        else bar
        for name, bar in model.bars.items()
    }
    active = {
        name: member.model_copy(update={"length": values[name]}) if name in values else member
        for name, member in model.active.items()
    }
    return model.with_(nodes=nodes, bars=bars, active=active)


def range_of(model: Model, name: str, position: Pose) -> tuple[float, float, bool]:
    """Smallest and largest value of a slider at a pose (n_nodes, dim), m or rad, and whether they are limits of the model."""
    drive, system = model.all_drives[name], compile(model)
    start = float(system.drive_start[list(system.drives).index(name)])
    if isinstance(drive, LengthDrive):
        member = model.members[drive.bar]
        if isinstance(member, Active) and member.limits is not None:
            return (*member.limits, True)
        return 0.6 * start, 1.5 * start, False
    reach = math.pi if turns(drive) else 0.5 * float(np.ptp(position, axis=0).max())
    return start - reach, start + reach, False


# Moves from one good pose to another, and decides which poses may be shown.

LEAST = 1e-3
"""Singularity measure at which a slider stops: forces and drive rates are then up to 1000 times those of a good pose."""

COARSE, FINE = 33, 513
"""Number of samples on the path to a new pose; if its end cannot be reached, more are used to stop close to the limit."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Reached:
    """The last good pose on a path.

    position : (n_nodes, dim), m. values : drive values there, m or rad. gauge : smallest singular value of the Jacobian's
    blocks, NaN if parts hang freely. stopped : why the path ends before the wanted values, or empty.
    note : other remarks on the pose.
    """

    position: Pose
    values: dict[str, float]
    gauge: float = float("nan")
    stopped: str = ""
    note: str = ""


def start_of(model: Model) -> Reached:
    """The own pose of the model.

    Raises
    ------
    AnalysisError, InputError : lengths that cannot be closed, or no equilibrium.
    """
    system = compile(model)
    values = {name: float(value) for name, value in zip(system.drives, system.drive_start, strict=True)}
    if arrange(system).plan is None:
        return _settled(model, None, values)
    position = kinematics.assemble(model)
    return _checked(model, Reached(position=position, values=values, gauge=_gauge(model, position, values)))


def stand(model: Model, position: Pose, values: Mapping[str, float]) -> Reached:
    """A changed model at drive values (m or rad): closed from the pose shown, else from its own pose, or in equilibrium.

    Raises
    ------
    AnalysisError, InputError : it cannot be closed from either pose, or has no equilibrium.
    """
    if arrange(compile(model)).plan is None:
        return _settled(model, position, values)
    note = ""
    try:
        found = closed(model, position, values)
    except KinetrussError as first:
        try:
            found = closed(model, kinematics.assemble(model), values)
        except KinetrussError:
            raise first from None
        note = "It could not be closed from the previous pose; it was closed from the pose of the model instead."
    return _checked(model, Reached(position=found, values=dict(values), gauge=_gauge(model, found, values), note=note))


def _checked(model: Model, pose: Reached) -> Reached:
    """The pose, after a check that all lengths and angles are satisfied.

    Raises
    ------
    AnalysisError : a length or an angle is not satisfied.
    """
    miss, what = gap(model, pose.position, pose.values)
    if miss <= CLOSED:
        return pose
    raise AnalysisError(f"The lengths cannot be closed: {what!r} is off by {miss:.2g} of the structure's size.")


def reach(model: Model, position: Pose, now: Mapping[str, float], wanted: Mapping[str, float]) -> Reached:
    """Move drives from their present to new values, continuously in steps, up to the last good pose.

    Parameters
    ----------
    position : (n_nodes, dim) a good pose at the values `now`, m. wanted : values of some or all drives, m or rad.
    """
    goal = dict(now) | dict(wanted)
    if arrange(compile(model)).plan is None:
        try:
            return _settled(model, position, goal)
        except KinetrussError as error:
            return Reached(position=position, values=dict(now), stopped=_reason(str(error)))
    if goal == dict(now):
        return Reached(position=position, values=goal, gauge=_gauge(model, position, now))
    try:
        found = _followed(model, position, now, goal, COARSE)
        return _checked(model, found if not found.stopped else _followed(model, position, now, goal, FINE))
    except KinetrussError as error:
        return Reached(position=position, values=dict(now), gauge=_gauge(model, position, now), stopped=_reason(str(error)))


def _followed(model: Model, position: Pose, now: Mapping[str, float], goal: Mapping[str, float], samples: int) -> Reached:
    moves = {name: (now[name], goal[name]) for name in goal}
    way = Quintic(moves=moves, duration=1.0)
    motion = kinematics.follow(model, way, samples=samples, start=position, least=LEAST, raise_on_failure=False)
    found = motion.arrays
    if not len(found["time"].values):
        return Reached(position=position, values=dict(now), stopped=_reason(motion.message))
    names = [str(name) for name in found["drive"].values]
    return Reached(
        position=np.array(found["position"].values[-1]),
        values=dict(goal)
        if motion.status.ok
        else dict(zip(names, map(float, found["drive_position"].values[-1]), strict=True)),
        gauge=float(found["singularity"].values[-1]),
        stopped="" if motion.status.ok else _reason(motion.message),
    )


TIMED = re.compile(r" \(t = [^)]*\)| (?:at|between|from) t = \S+ s(?: and \S+ s)?(?: on)?|^At t = \S+ s ")
"""Parts of messages with the time of a path, which a slider does not have."""

ADVICE = ("The motion is good", "Start the path", "Correct the path", "Change the path to avoid it", "Drive one of them less")
"""Starts of sentences that apply only to paths."""


def reason(message: str) -> str:
    """Why a motion ends, without times and advice that apply to a path but not to a slider, and without the full stop."""
    sentences = re.split(r"(?<=[.!?]) (?=[A-Z])", message)
    kept = " ".join(TIMED.sub("", one) for one in sentences if not one.startswith(ADVICE))
    kept = kept.replace("The path runs", "This motion runs").replace("at the start of the path ", "").rstrip(".")
    return f"{kept[:1].upper()}{kept[1:]}"


def _reason(message: str) -> str:
    """The same for a slider, with what to do."""
    return f"{reason(message)}. Stopped at the last good pose: move the drives in another way."


def _settled(model: Model, position: Pose | None, values: Mapping[str, float]) -> Reached:
    """The equilibrium of a structure with springs or loose parts at given drive values."""
    rest = statics.equilibrium(model, position, lengths=values)
    note = rest.message
    if not rest.stable:
        note = f"{note} {'; '.join(rest.ways_out)}".strip()
    return _checked(model, Reached(position=np.array(rest.whole["position"].values), values=dict(values), note=note))


def _gauge(model: Model, position: Pose, values: Mapping[str, float]) -> float:
    """The singularity measure of one pose, computed for a path that stays there."""
    if not values:
        return float("nan")
    way = Quintic(moves={name: (value, value) for name, value in values.items()}, duration=1.0)
    motion = kinematics.follow(model, way, times=[0.0], start=position, raise_on_failure=False)
    gauge = motion.arrays["singularity"].values
    return float(gauge[0]) if len(gauge) else 0.0


# Forces, reactions, stresses and motor demand of one pose at rest.

MANY = 40
"""Number of members above which motors and mobility are computed only when the slider stops."""

LARGEST = 400
"""Number of members above which the mobility of a pose (a dense singular value decomposition) is omitted."""

ALARMS = 4
"""Largest number of members in messages."""

DEMANDS = ("thrust", "stroke", "holding_torque", "breakaway_torque", "current")


@dataclass(frozen=True, kw_only=True, eq=False)
class Instant:
    """One pose at rest: forces, arrays of the scene, demand of the motors, mobility as text, limits exceeded."""

    forces: Forces
    arrays: dict[str, NDArray[Any]]
    demand: list[dict[str, Any]] | None
    mobility: str | None
    alarms: list[str]
    verdict: dict[str, Any]


def instant(model: Model, position: NDArray[np.float64], case: str | None, fine: bool = True) -> Instant:
    """All results shown for a pose (n_nodes, dim), m, at rest under a load case (None: all loads)."""
    forces = at_rest(model, position, case)
    _, arrays = moving(model, forces.motion, [forces], None, 600)
    fine = fine or len(model.members) <= MANY
    demand = _demand(model, forces) if fine and model.actuators else None
    mobility = str(kinematics.mobility(model, position)) if fine and len(model.members) <= LARGEST else None
    finding = _finding(check(model, forces), demand or [])
    return Instant(
        forces=forces, arrays=arrays, demand=demand, mobility=mobility, alarms=_alarms(finding), verdict=finding.record
    )


def at_rest(model: Model, position: NDArray[np.float64], case: str | None = None) -> Forces:
    """Forces of a pose (n_nodes, dim), m, at rest under a load case (None: all loads)."""
    still = np.zeros((1, *position.shape))
    motion = kinematics.from_arrays(model, [0.0], position[None], still, still)
    return dynamics.inverse(model, motion, case, static=False)


def strength_of(model: Model, forces: Forces) -> tuple[list[str], dict[str, float]]:
    """Members and motors beyond a limit under the forces of one pose, in sentences; and the utilisation of each member that was
    checked.
    """
    verdict = check(model, forces)
    finding = _finding(verdict, _demand(model, forces) if model.actuators else [])
    used = _by_name(model, worst_of(model, verdict).get("utilisation"))
    return _alarms(finding), {name: float(value) for name, value in used.items() if math.isfinite(value)}


def used_over(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Utilisation (times,) of every bar, active member, beam and link: the largest of all its rules that is a number.

    NaN where it was not checked; also where the rules that were ask for nothing and another one was not, for instance of a bar
    in tension without a yield strength. Empty if nothing was checked.
    """
    return _by_name(model, strength_histories(model, forces).get("utilisation"))


def _by_name(model: Model, values: NDArray[np.float64] | None) -> dict[str, NDArray[np.float64]]:
    """Of values (..., members) those of every bar, active member, beam and link."""
    if values is None:
        return {}
    at = {name: k for k, name in enumerate(model.whole.members)}
    of = {name: name for name in (*model.bars, *model.active)} | {name: chords_of(model, name)[0] for name in beam_parts(model)}
    return {name: values[..., at[part]] for name, part in of.items()}


def _finding(verdict: Verdict, demand: list[dict[str, Any]]) -> Finding:
    """What a pose says: its members, and the share of the largest current that each motor takes to hold."""
    holding = []
    for one in demand:
        if one["current"] is not None and one["max_current"]:
            held, most = abs(one["current"]), one["max_current"]
            used = held / most
            margin = 1 / used - 1 if used else math.inf
            row = Row(
                part=one["name"], member=one["name"], rule="holding current", value=held, limit=most, unit="A",
                utilisation=used, margin=margin, time=math.nan,
            )  # fmt: skip
            holding.append(row)
    return find(verdict, holding, timed=False)


def _alarms(finding: Finding) -> list[str]:
    """Members and motors beyond a limit, worst first, in sentences; and why the forces are not to be trusted."""
    worst: dict[str, Row] = {}
    for row in finding.members:
        if row.status == "exceeded":
            worst[row.member] = row if row.rule == "buckling" else worst.get(row.member, row)
    found = [
        f"{name} buckles: its compression is {quantity(row.utilisation, '%')} of what is allowed."
        if row.rule == "buckling"
        else f"{name} is at {quantity(row.utilisation, '%')} of its allowed load."
        for name, row in worst.items()
    ]
    more = [f"{len(found) - ALARMS} more members are beyond a limit."] * (len(found) > ALARMS)
    motors = [
        f"{row.part}: holding takes {quantity(row.value, 'A')}, more than the motor's {quantity(row.limit, 'A')}."
        for row in finding.drives
        if row.status == "exceeded"
    ]
    return [*filter(None, [finding.partial and f"{finding.partial}."]), *found[:ALARMS], *more, *motors]


def _demand(model: Model, forces: Forces) -> list[dict[str, Any]]:
    columns = columns_of(model, forces.motion, forces)
    return [
        {
            "name": name,
            **{one: number(of[one][0]) if one in of else None for one in DEMANDS},
            "max_current": _limit(model, name),
        }
        for name, of in zip(model.actuators, columns, strict=True)
    ]


def _limit(model: Model, name: str) -> float | None:
    motor = model.actuators[name].motor
    record = model.motors[motor] if isinstance(motor, str) else motor
    return None if record is None else record.max_current


def number(value: Any) -> float | None:
    """A float, or None if JSON cannot represent it."""
    return float(value) if math.isfinite(value) else None
