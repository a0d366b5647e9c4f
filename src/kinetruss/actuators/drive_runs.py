"""A drive train forwards: from a voltage, a current or a torque to a history of a length or an angle."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.drive_model import (
    BELOW,
    COLUMNS,
    ENERGIES,
    HELD,
    Mode,
    drive_model_of,
    gains_of,
    motor_input,
    refuse_jam,
)
from kinetruss.actuators.inputs import edges_of, in_currents, inputs_of, kinks, source_of, thrust_of
from kinetruss.actuators.modes import Coordinate, Drives, MotorModes
from kinetruss.actuators.steps import Tolerances, method_from, step_of, watch
from kinetruss.errors import AnalysisError, InputError
from kinetruss.limits import whole
from kinetruss.model import DriveInput, DriveLoad, DriveTrain, PositionLoop
from kinetruss.results import DriveRun, Episode, Status

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.actuators.drive_model import DriveModel
    from kinetruss.actuators.events import Interpolant, ModeEvent
    from kinetruss.actuators.modes import Instant

    Floats = NDArray[np.float64]


MOST_CHANGES = 5000


@dataclass(frozen=True, slots=True, eq=False)
class Phase:
    """A time in one mode, from `begin` to `end` (s), within an interval without jumps. table : of the modes.

    ends (steps,) : s, of the steps; parts : their interpolants.
    """

    begin: float
    end: float
    interval: int
    table: Floats
    ends: list[float]
    parts: list[Interpolant]

    @property
    def mode(self) -> Mode:
        """The mode of its drive."""
        return Mode.of(self.table[0].tolist())

    def at(self, t: float) -> Floats:
        """The state."""
        return self.parts[min(bisect_left(self.ends, t), len(self.parts) - 1)](t)

    def instant(self, modes: MotorModes, t: float, y: Floats) -> Instant:
        """Evaluate the drive in the mode of this phase."""
        modes.table = self.table
        return modes.instant(t, self.interval, y)


def phases_of(modes: MotorModes, start: Sequence[float], rtol: float) -> list[Phase]:
    """All phases of a run from a value and its rate; the last ends early where the stroke does."""
    drives, found = modes.drives, list[Phase]()
    y = np.zeros(modes.size)
    y[:2] = start
    given = Tolerances(rtol, modes.tolerances(1e-3 * rtol, 1e-3 * rtol))
    for interval, (t, until) in enumerate(pairwise(drives.edges)):
        y = modes.settled(t, interval, y) if interval else modes.begin(y)
        while t < until:
            direction = modes.modes[0].direction
            if direction and direction * (drives.limits[direction > 0] - y[0]) <= 0:
                return found
            phase, event = _phase(modes, interval, (t, until), y, given)
            found.append(phase)
            t, y = phase.end, phase.at(phase.end)
            if event is not None and event.name == "end of stroke":
                return found
            y, _ = modes.projected(t, interval, y, (0,) if event is not None and event.name == "stop" else ())
            if event is not None:
                y = modes.changed(t, interval, y, event)
            if len(found) > MOST_CHANGES:
                raise AnalysisError(
                    f"The drive changed its mode {MOST_CHANGES} times before t = {t:.6g} s. Its loop chatters: lower its gains."
                )
    return found


def _phase(
    modes: MotorModes, interval: int, span: tuple[float, float], y: Floats, given: Tolerances
) -> tuple[Phase, ModeEvent | None]:
    """Integrate until a mode ends; the event that ends it, or None at the end of the span."""
    solver, watched, steps = method_from(modes, interval, span[0], y, span[1], given), watch(modes, interval), []
    while solver.status == "running":
        step = step_of(solver, watched)
        if step is None:
            raise AnalysisError(f"The drive could not be integrated beyond t = {solver.t:.6g} s: its step became too small.")
        steps.append(step)
        if step.event is not None:
            break
    ends, parts = [one.at.t_max for one in steps], [one.at for one in steps]
    return Phase(span[0], steps[-1].end, interval, modes.table, ends, parts), steps[-1].event


# What held a drive back: when, and by how much.

LOOKS = 17
"""Instants of a phase at which the worst is looked for."""
STALLED = 0.1
"""A drive that stands still, asked to move, for this last part of a run has stalled."""
KINDS = ("input saturated", "voltage saturated", "current saturated")


def episodes(modes: MotorModes, phases: list[Phase]) -> tuple[Episode, ...]:
    """All episodes in order of time; neighbouring phases of one kind are one."""
    found: dict[str, list[Episode]] = {}
    for phase in phases:
        for new in _of_phase(modes, phase):
            kept = found.setdefault(new.kind, [])
            if kept and kept[-1].end == new.start:
                kept[-1] = _one(kept[-1], new)
            else:
                kept.append(new)
    every = [one for kept in found.values() for one in kept]
    limits = modes.drives.limits
    if math.isfinite(max(limits)):
        last = phases[-1]
        length = float(last.at(last.end)[0])
        edge = min(limits, key=lambda limit: abs(limit - length))
        if last.mode.direction and abs(edge - length) <= 1e-9 * max(abs(edge), abs(limits[1] - limits[0])):
            every.append(
                Episode(
                    "end of stroke", last.end, last.end, last.end, length, edge, "rad" if modes.models[0].shaft.turns else "m"
                )
            )
    return tuple(sorted(every, key=lambda one: (one.start, one.kind)))


def outcome(found: tuple[Episode, ...], phases: list[Phase], duration: float) -> Status:
    """What a run came to: the gravest of its episodes."""
    end = phases[-1].end
    kinds = {one.kind for one in found}
    if "end of stroke" in kinds or end < duration:
        return Status.END_OF_STROKE
    if any(one.kind == "stuck" and one.end == end and one.end - one.start > STALLED * duration for one in found):
        return Status.STALLED
    if kinds & {"speed limit", "too fast"}:
        return Status.SPEED_LIMIT
    return Status.SATURATED if kinds & set(KINDS) else Status.COMPLETED


def _one(first: Episode, second: Episode) -> Episode:
    worse = max(first, second, key=lambda one: one.wanted - one.possible if one.kind != "stuck" else one.possible - one.wanted)
    return Episode(first.kind, first.start, second.end, worse.time, worse.wanted, worse.possible, worse.unit)


def _of_phase(modes: MotorModes, phase: Phase) -> Iterator[Episode]:
    model, command = modes.models[0], modes.drives.commands[phase.interval][0]
    begin, end, mode = phase.begin, phase.end, phase.mode
    instants = np.linspace(begin, end, LOOKS).tolist()
    states = [phase.at(t).tolist() for t in instants]
    for which, saturated in enumerate(mode.saturated):
        if saturated:
            limit, unit = ((model.max_input, "V"), (model.max_voltage, "V"), (model.max_current, "A"))[which]
            over = [motor_input(model, command, t, *y[:3])[4 + which] for t, y in zip(instants, states, strict=True)]
            at = int(np.argmax(over))
            yield Episode(KINDS[which], begin, end, instants[at], limit + over[at], limit, unit)
    if mode.limited:
        yield Episode(KINDS[2], begin, end, begin, *(model.max_current,) * 2, "A")
    if mode.speed != BELOW:
        fastest = model.shaft.speed * max(abs(y[1]) for y in states)
        kind = "speed limit" if mode.speed == HELD else "too fast"
        yield Episode(kind, begin, end, begin, fastest, model.shaft.speed * model.max_rate, "rad/s")
    if mode.direction == 0:
        yield from _stuck(modes, phase, instants, states)
    elif _driven(modes, phase, (begin + end) / 2):
        yield Episode("driven back", begin, end, begin, math.nan, 0.0, "N m")


def _stuck(modes: MotorModes, phase: Phase, instants: list[float], states: list[list[float]]) -> Iterator[Episode]:
    """Asked to move, but too weak to."""
    model, command = modes.models[0], modes.drives.commands[phase.interval][0]
    worst: tuple[float, float, float] | None = None
    for t, y in zip(instants, states, strict=True):
        torque = model.torque_constant * motor_input(model, command, t, *y[:3]).current
        if abs(torque) <= max(modes.drives.small[0], 1e-12):
            continue
        load = phase.instant(modes, t, np.array(y)).thrust[0]
        needed = model.shaft.breakaway(1 if torque > 0 else -1, load)
        if worst is None or abs(torque) - needed > worst[1] - worst[2]:
            worst = t, abs(torque), needed
    if worst is not None:
        yield Episode("stuck", phase.begin, phase.end, worst[0], worst[2], worst[1], "N m")


def _driven(modes: MotorModes, phase: Phase, t: float) -> bool:
    """The motor does not push, yet the load moves."""
    y = phase.at(t)
    instant, s = phase.instant(modes, t, y), phase.mode.direction
    torque = modes.columns(instant, y)[0][list(COLUMNS).index("motor_torque")]
    return not s * torque > modes.drives.small[0] and s * instant.thrust[0] < 0 and s * modes.body.thrust[0] < 0


# A drive train forwards: from a voltage, a current or a torque to a history of a length or an angle.

SHORT = {f"motor_{name}": name for name in ("command", "voltage", "current", "direction", "stored_energy")}
HISTORIES = {SHORT.get(name, name): words for name, words in COLUMNS.items()} | {
    "actuator_work": ("J", "work of the thrust so far, its moving mass included"),
    "thrust": ("N", "thrust of the actuator, its moving mass included"),
    "length": ("m", "length"),
    "length_rate": ("m/s", "rate of length"),
    "length_acceleration": ("m/s^2", "acceleration of length"),
}
"""In the order in which they are recorded."""
ROTARY = {
    "thrust": ("drive_torque", "N m", "torque on the angle, its moving inertia included"),
    "length": ("angle", "rad", "angle"),
    "length_rate": ("angle_rate", "rad/s", "rate of angle"),
    "length_acceleration": ("angle_acceleration", "rad/s^2", "acceleration of angle"),
    "actuator_work": ("actuator_work", "J", "work of the torque so far, its moving inertia included"),
}
"""How histories are called where a train turns an angle."""
SCREWED = ("screw_torque", "screw_loss")
"""Histories of trains with a screw alone."""


def simulate_drive(
    train: DriveTrain,
    history: DriveInput | PositionLoop,
    *,
    load: DriveLoad | float | None = None,
    duration: float,
    length: float | None = None,
    angle: float | None = None,
    rate: float = 0.0,
    limits: tuple[float, float] | None = None,
    samples: int = 501,
    times: ArrayLike | None = None,
    rtol: float = 1e-9,
) -> DriveRun:
    """What a drive train does with an input: amplifier, motor, gear and screw to a history of length, or gear to one of angle.

    Parameters
    ----------
    train : screw, motor, gear, amplifier; of a model's active member or drive of an angle by `train_of`.
    history : the input of the amplifier (V), or without one the voltage (V), the current (A) or the torque (N m) of the motor:
        `StepInput`, `ExponentialInput`, `SineInput`, `TableInput`. Or a `PositionLoop`, which makes the input from the length.
    load : thrust to work against (N, positive presses the member short; of an angle torque, N m, positive turns it back), or a
        `DriveLoad`.
    duration : s. length or angle, rate : at the start, m (1) or rad (0), m/s or rad/s. limits : least and largest length (m) or
        angle (rad); the run ends there.
    samples : evenly spaced, both ends included; or `times` (n,), s.
    rtol : relative tolerance of the integration; its absolute one is 1e-3 of it in SI units.

    Returns
    -------
    DriveRun. Over (time,): ``command``, ``voltage`` V, ``current`` A, ``motor_torque`` N m, ``motor_speed`` rad/s,
    ``screw_torque`` N m, ``thrust`` N, ``length`` m, ``length_rate``, ``length_acceleration``, ``direction``, and in J
    ``electrical_energy``, ``copper_energy``, ``motor_loss``, ``gear_loss``, ``screw_loss``, ``actuator_work``,
    ``stored_energy``, ``energy_balance`` (electrical minus all others: zero to the tolerance of the integration). ``episodes``
    and ``status`` say where it saturated, stuck or ran at its largest speed; ``trajectory(drive)`` makes the length history
    a `Spline`. Of an angle ``drive_torque`` N m, ``angle`` rad, ``angle_rate``, ``angle_acceleration`` stand for thrust and
    length, and there is nothing of a screw.

    Raises
    ------
    InputError : data with which no motion can be computed.
    AnalysisError : the drive changes its mode without end.

    Notes
    -----
    J w' = K_t i - T_f sign w - T_p eta^(-+1)/G, L i' = U - R i - K_b w, w = G L'/lead; T_p from `screw_torque` with the thrust
    F + m L'', of an angle T + I q''. At rest it sticks until the motor's torque exceeds its friction and the screw's static
    friction, in either direction; a screw or gear that is not self-locking runs back under its load. Where a drive changes
    between sticking, slipping, saturation and its speed limit, the instant is found and the integration (DOP853, or Radau where
    the winding is very quick) starts anew: friction is not smoothed. The largest voltage, current and torque of motor and
    amplifier limit what they give; at its largest speed the motor is held by its electronics, unless the load drives it
    beyond. A source of current takes no notice of the inductance.

    Examples
    --------
    >>> from kinetruss.library.drives import TRAIN_LACY
    >>> from kinetruss.model import StepInput
    >>> run = simulate_drive(TRAIN_LACY, StepInput(voltage=12.0), load=40.0, duration=1.0)
    >>> print(f"{run.length_rate.values[-1] * 1e3:.3f} mm/s, {run.status.name}")
    14.229 mm/s, COMPLETED
    """
    given = _load(train, load)
    start = _start(train, length, angle)
    train, history = in_currents(train, history)
    model = drive_model_of(train, source_of(history))
    refuse_jam(model, given.carried)
    at = _instants(duration, samples, times)
    _check(start, rate, limits, rtol, "rad" if model.shaft.turns else "m")
    modes = _modes(model, history, given, start, duration, limits)
    phases = phases_of(modes, (start, rate), rtol)
    if not phases:
        raise InputError("The drive starts at the end of its stroke and moves beyond it. Give another start, or wider limits.")
    data = _sampled(modes, phases, at)
    if isinstance(history, PositionLoop):
        gains = gains_of(model, history, given.carried)
        data.attrs |= {"position_gain": gains.position, "rate_gain": gains.rate, "current_gain": gains.current}
    found = episodes(modes, phases)
    status = outcome(found, phases, duration)
    return DriveRun(
        data=data,
        status=status,
        message=" ".join(str(one) for one in found),
        episodes=found,
        provenance={"rtol": rtol, "stretches": len(phases), "train": train.model_dump()},
    )


def _modes(
    model: DriveModel,
    history: DriveInput | PositionLoop,
    load: DriveLoad,
    start: float,
    duration: float,
    limits: tuple[float, float] | None,
) -> MotorModes:
    """The modes of one drive that works on a single coordinate, between the kinks of its input and of its load."""
    edges = edges_of(kinks(history, load), duration)
    thrusts = [thrust_of(load, a, b) for a, b in pairwise(edges)]
    drives = Drives(
        **inputs_of((model,), (history,), edges, (start,), (load.carried,), lambda i, t: (thrusts[i](t, start),)),
        names=("drive",),
        period=np.zeros(1),
        limits=(-math.inf, math.inf) if limits is None else (float(limits[0]), float(limits[1])),
    )
    return MotorModes(drives, Coordinate(load.carried, thrusts))


def _instants(duration: float, samples: int, times: ArrayLike | None) -> NDArray[np.float64]:
    if not (math.isfinite(duration) and duration > 0):
        raise InputError(f"A drive cannot run for {duration:g} s. Give a duration greater than 0.")
    at = np.linspace(0.0, duration, whole(samples, "samples", least=2)) if times is None else np.asarray(times, float)
    if at.ndim != 1 or not at.size or not (np.all(np.diff(at) > 0) and at[0] >= 0 and at[-1] <= duration * (1 + 1e-12)):
        raise InputError(f"The times must increase, between 0 and the duration of {duration:g} s.")
    return at


def _load(train: DriveTrain, load: DriveLoad | float | None) -> DriveLoad:
    turns = train.screw is None
    if not isinstance(load, DriveLoad):
        amount = 0.0 if load is None else float(load)
        return DriveLoad(torque=amount) if turns else DriveLoad(thrust=amount)
    if load.of_length and turns:
        raise InputError("The train has no screw, so it turns an angle. Give its load as torque (N m) and inertia (kg m^2).")
    if load.of_angle and not turns:
        raise InputError("The train has a screw, so it drives a length. Give its load as thrust (N) and mass (kg).")
    return load


def _start(train: DriveTrain, length: float | None, angle: float | None) -> float:
    if train.screw is None and length is not None:
        raise InputError("The train has no screw, so it turns an angle. Give angle (rad), not length.")
    if train.screw is not None and angle is not None:
        raise InputError("The train has a screw, so it drives a length. Give length (m), not angle.")
    given, usual = (angle, 0.0) if train.screw is None else (length, 1.0)
    return usual if given is None else float(given)


def _check(start: float, rate: float, limits: tuple[float, float] | None, rtol: float, unit: str) -> None:
    if not 1e-13 < rtol < 1e-2:
        raise InputError(f"rtol = {rtol:g} is no tolerance. Give one between 1e-13 and 1e-2.")
    if not (math.isfinite(start) and math.isfinite(rate)):
        raise InputError(f"The start, {start:g} {unit} and rate {rate:g} {unit}/s, is not finite.")
    if limits is not None and not limits[0] <= start <= limits[1]:
        raise InputError(f"The drive starts at {start:g} {unit}, outside its limits {limits[0]:g} to {limits[1]:g} {unit}.")


def _sampled(modes: MotorModes, phases: list[Phase], times: NDArray[np.float64]) -> xr.Dataset:
    """Histories at the times the run has reached; at a change of mode the value behind it."""
    import xarray as xr

    from kinetruss.results import variable

    times, rows, phase = times[times <= phases[-1].end * (1 + 1e-12)], [], phases[0]
    modes.table = phase.table
    behind = np.searchsorted([phase.begin for phase in phases], times, side="right")
    for t, k in zip(times.tolist(), behind.tolist(), strict=True):
        if phase is not phases[k - 1]:
            phase = phases[k - 1]
            modes.table = phase.table
        y = phase.at(t)
        instant = modes.instant(t, phase.interval, y)
        rows.append([*modes.columns(instant, y)[0], instant.thrust[0], *y[:2].tolist(), instant.w[0]])
    columns = np.array(rows, float).reshape(len(times), len(HISTORIES)).T.copy()
    table = dict(zip(HISTORIES, columns, strict=True))
    spent = sum(table[name] for name in [*ENERGIES[1:], "stored_energy"])
    balance = table["electrical_energy"] - spent + table["stored_energy"][:1]
    turns, data = modes.models[0].shaft.turns, {}
    for name, column in table.items():
        if name != "motor_angle" and not (turns and name in SCREWED):
            label, *words = ROTARY.get(name, (name, *HISTORIES[name])) if turns else (name, *HISTORIES[name])
            data[label] = variable(("time",), column, *words)
    data["energy_balance"] = variable(("time",), balance, "J", "electrical energy minus all it went to")
    coords = {"time": variable(("time",), times, "s", "time")}
    return xr.Dataset(data, coords=coords, attrs={"kind": "drive_run"})
