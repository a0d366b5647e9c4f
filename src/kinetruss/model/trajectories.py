"""Trajectories: motions of drive or pose coordinates in time, and lengths of zero that they reach."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import dist
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import Field, Tag, model_validator

from kinetruss.errors import Fault, InputError
from kinetruss.kernels.motion import profiles
from kinetruss.model.drives import CoordinateName, LengthDrive
from kinetruss.model.in_time import Shape, check_times
from kinetruss.model.record import (
    Angle,
    Coordinate,
    Name,
    NameOrRecord,
    Number,
    PositiveNumber,
    PositiveTime,
    Rate,
    Record,
    SecondRate,
    Series,
    Time,
    Whole,
)
from kinetruss.model.references import TrajectoryName
from kinetruss.model.table import Filled, ReadOnly, Table

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


Move = tuple[Coordinate, Coordinate]
Moves = Filled[CoordinateName, Move]


class Quintic(Record):
    """From start to end by 10 s^3 - 15 s^4 + 6 s^5: at rest, without acceleration, at both ends.

    moves : coordinate -> (start, end), m or rad.
    duration : s.

    >>> import kinetruss as kt
    >>> kt.Quintic(moves={"motor": ("0 deg", "90 deg")}, duration="2 s")
    Quintic(moves={'motor': (0.0, 1.5707963267948966)}, duration=2.0)
    """

    kind: Literal["quintic"] = "quintic"
    moves: Moves
    duration: PositiveTime


class Trapezoid(Record):
    """From start to end with constant acceleration over the fraction `ramp` of the time, constant rate, deceleration.

    moves : coordinate -> (start, end), m or rad.
    duration : s.
    ramp : fraction of the duration for each of acceleration and deceleration.

    >>> import kinetruss as kt
    >>> kt.Trapezoid(moves={"jack": ("0.8 m", "1.0 m")}, duration=4.0, ramp=0.2)
    Trapezoid(moves={'jack': (0.8, 1.0)}, duration=4.0, ramp=0.2)
    """

    kind: Literal["trapezoid"] = "trapezoid"
    moves: Moves
    duration: PositiveTime
    ramp: Annotated[Number, Field(gt=0, le=0.5)] = 0.25


class ConstantRate(Record):
    """Every named coordinate moves at a constant rate (m/s or rad/s) from its value in the model.

    rates : coordinate -> rate, m/s or rad/s.
    duration : s.

    >>> import kinetruss as kt
    >>> kt.ConstantRate(rates={"motor": "10 rad/s"}, duration="0.5 s")
    ConstantRate(rates={'motor': 10.0}, duration=0.5)
    """

    kind: Literal["constant_rate"] = "constant_rate"
    rates: Filled[CoordinateName, Rate]
    duration: PositiveTime


class Sine(Record):
    """Value in the model plus amplitude x (sin(2 pi t/period + phase) - sin(phase)).

    amplitudes : coordinate -> amplitude, m or rad.
    period : of one oscillation, s.
    phase : angle at the start, rad.
    duration : s.

    >>> import kinetruss as kt
    >>> kt.Sine(amplitudes={"jack": "5 mm"}, period="0.2 s", duration="1 s")
    Sine(amplitudes={'jack': 0.005}, period=0.2, duration=1.0)
    """

    kind: Literal["sine"] = "sine"
    amplitudes: Filled[CoordinateName, Coordinate]
    period: PositiveTime
    phase: Angle = 0.0
    duration: PositiveTime


class Cyclic(Record):
    """There and back: start + (end - start)(1 - cos(2 pi t/period))/2, for `cycles` periods.

    moves : coordinate -> (start, turning point), m or rad.
    period : of one way there and back, s.
    cycles : number of periods.

    >>> import kinetruss as kt
    >>> kt.Cyclic(moves={"jack": (0.8, 1.0)}, period=2.0, cycles=3)
    Cyclic(moves={'jack': (0.8, 1.0)}, period=2.0, cycles=3.0)
    """

    kind: Literal["cyclic"] = "cyclic"
    moves: Moves
    period: PositiveTime
    cycles: PositiveNumber = 1.0

    @property
    def duration(self) -> float:
        """s."""
        return self.period * self.cycles


class StepResponse(Record):
    """Response to a step from start to end of a system with placed poles.

    Order 2: w^2/(s^2 + 2 zeta w s + w^2); order 3: the same times p/(s + p) with p = `third_pole` w.
    w = `settling_factor`/(zeta `settling_time`); 4 is the usual 2 % rule. The profile of Lacy (1991, section 3.2) is order 3,
    zeta 0.8, settling time 0.9 of the duration, settling factor 6, third pole 2.

    moves : coordinate -> (start, end), m or rad.
    duration : s.
    damping : the damping ratio zeta.
    settling_time : s.
    settling_factor : zeta w times the settling time.
    order : 2 or 3.
    third_pole : p over w, of order 3.

    >>> import kinetruss as kt
    >>> kt.StepResponse(moves={"jack": (0.8, 1.0)}, duration=2.0, order=2)
    StepResponse(moves={'jack': (0.8, 1.0)}, duration=2.0, order=2)
    """

    kind: Literal["step_response"] = "step_response"
    moves: Moves
    duration: PositiveTime
    damping: PositiveNumber = 0.8
    settling_time: PositiveTime | None = None
    settling_factor: PositiveNumber = 4.0
    order: Annotated[Whole, Field(ge=2, le=3)] = 3
    third_pole: PositiveNumber = 2.0

    @property
    def frequency(self) -> float:
        """w, rad/s."""
        settling = 0.9 * self.duration if self.settling_time is None else self.settling_time
        return self.settling_factor / (self.damping * settling)

    @property
    def pole(self) -> float | None:
        """p, rad/s, of order 3; None of order 2."""
        return self.third_pole * self.frequency if self.order == 3 else None


class Tabulated(Record):
    """A table in time: times (s) and one column a coordinate, without long gaps."""

    times: Annotated[tuple[Time, ...], Field(min_length=4), Series]
    values: Filled[CoordinateName, Annotated[tuple[Coordinate, ...], Series]]
    largest_gap: Annotated[Number, Field(gt=1)] = 10.0

    @model_validator(mode="after")
    def _table(self) -> Self:
        check_times(self.times)
        for name, column in self.values.items():
            if len(column) != len(self.times):
                raise ValueError(f"column {name!r} has {len(column)} values for {len(self.times)} times. Give as many.")
        steps = sorted(b - a for a, b in zip(self.times[:-1], self.times[1:], strict=True))
        median = steps[len(steps) // 2]
        for a, b in zip(self.times[:-1], self.times[1:], strict=True):
            if b - a > self.largest_gap * median:
                raise ValueError(
                    f"gap in the table from {a:g} s to {b:g} s (median step {median:g} s). "
                    "Fill it, or raise largest_gap if it is meant."
                )
        return self

    @property
    def duration(self) -> float:
        """s."""
        return self.times[-1] - self.times[0]


class Spline(Tabulated):
    """A measured table: times (s) and one column a coordinate; a quintic spline through all points (cubic below 6 points).

    `shape`: a spline may overshoot its points, most where values repeat. ``monotone`` interpolates the same points by quintics
    with continuous acceleration that rise only where the table rises, and are constant where it is. It turns at rows only, so
    if the measured motion turns between rows, the accelerations there are not the measured ones. In a file, ``file:
    table.csv`` (columns t, coordinate names) is read into times and values. `largest_gap` refuses a table with a longer pause
    between two samples than this many times the median step. A noisy table is a `Measured` one.

    times : s.
    values : coordinate -> its values at these times, m or rad.
    largest_gap : longest pause between two samples, as a multiple of the median step.
    shape : ``spline`` or ``monotone``.

    >>> import kinetruss as kt
    >>> kt.Spline(times=(0, 1, 2, 3), values={"jack": (0.8, 0.85, 0.95, 1.0)}, shape="monotone")
    Spline(times=(0.0, 1.0, 2.0, 3.0), values={'jack': (0.8, 0.85, 0.95, 1.0)}, shape='monotone')
    """

    kind: Literal["spline"] = "spline"
    shape: Shape = "spline"


class Measured(Tabulated):
    """A record with noise: it is smoothed; rates and accelerations that are given are used as they are.

    `rates` and `accelerations` are columns as `values` are; a coordinate has its rates, or rates and accelerations, or
    neither. What is not given comes from the smoothed values (or the smoothed rates). Between the rows the motion is the
    quintic with value, rate and acceleration of the rows. `smoothing`: ``spline``, a quintic smoothing spline; or
    ``savitzky_golay``, for even steps, with an odd number of rows as `window` (by default the best by cross-validation).
    `outliers`: ``keep`` reports them, ``replace`` smooths without them too. In a file, ``file: table.csv`` has columns ``t``,
    ``M7``, ``M7.rate``, ``M7.acceleration``. See `kinematics.measured`.

    times : s.
    values : coordinate -> its values at these times, m or rad.
    largest_gap : as of a `Spline`.
    rates : coordinate -> rates at these times, m/s or rad/s.
    accelerations : coordinate -> accelerations, m/s^2 or rad/s^2.
    smoothing : ``spline`` or ``savitzky_golay``.
    window : of ``savitzky_golay``, an odd number of rows.
    outliers : ``keep`` or ``replace``.
    """

    kind: Literal["measured"] = "measured"
    rates: Table[Name, Annotated[tuple[Rate, ...], Series]] = ReadOnly()
    accelerations: Table[Name, Annotated[tuple[SecondRate, ...], Series]] = ReadOnly()
    smoothing: Literal["spline", "savitzky_golay"] = "spline"
    window: Whole | None = None
    outliers: Literal["keep", "replace"] = "keep"

    @model_validator(mode="after")
    def _columns(self) -> Measured:
        for field in ("rates", "accelerations"):
            for name, column in getattr(self, field).items():
                if name not in self.values:
                    raise ValueError(f"{field} has a column {name!r}, but there are no values of {name!r}. Give both.")
                if len(column) != len(self.times):
                    raise ValueError(f"{field}: column {name!r} has {len(column)} values for {len(self.times)} times.")
                kinds = {getattr(column[0], "quantity", None), getattr(self.values[name][0], "quantity", None)} - {None}
                if len(kinds) > 1:
                    raise ValueError(
                        f"{field}: column {name!r} has a unit of angles, its values one of lengths, or the reverse."
                    )
        if alone := [name for name in self.accelerations if name not in self.rates]:
            raise ValueError(f"accelerations of {alone[0]!r} are given without its rates. Give the rates, or leave them out.")
        if self.window is not None and self.smoothing == "spline":
            raise ValueError("window is given, but a smoothing spline has none. Set smoothing: savitzky_golay, or remove it.")
        if self.window is not None and not (self.window % 2 and 7 <= self.window <= len(self.times)):
            raise ValueError(
                f"window {self.window} is not an odd number from 7 to the {len(self.times)} rows. Give one, or none."
            )
        return self

    @property
    def smoothed(self) -> bool:
        """True if at least one column is smoothed."""
        return any(name not in self.accelerations for name in self.values)


Trajectory = Annotated[
    Quintic | Trapezoid | ConstantRate | Sine | Cyclic | StepResponse | Spline | Measured, Field(discriminator="kind")
]
TrajectoryOrName = Annotated[Annotated[Trajectory, Tag("record")] | Annotated[TrajectoryName, Tag("name")], NameOrRecord]


def moved_by(trajectory: Any) -> tuple[str, Mapping[str, Any]]:
    """The field with the coordinates of a trajectory, and its table: name -> (start, end), rate, amplitude or column.

    Raises
    ------
    InputError : the argument is not a trajectory.

    Examples
    --------
    >>> import kinetruss as kt
    >>> kt.model.moved_by(kt.Quintic(moves={"M7": (1.1, 1.2)}, duration=1.0))
    ('moves', {'M7': (1.1, 1.2)})
    """
    for field in ("moves", "values", "rates", "amplitudes"):
        if isinstance(trajectory, Record) and field in type(trajectory).model_fields:
            return field, getattr(trajectory, field)
    if isinstance(trajectory, Mapping):
        raise InputError(
            "A mapping is not a trajectory: one record moves all its coordinates, e.g. "
            "kt.Quintic(moves={'M7': (1.1, 1.2), 'M9': (1.1, 1.0)}, duration=1). Drives that move by different laws go to "
            "dynamics.simulate(tasks={drive: record}), or into one kt.Spline of their values."
        )
    if callable(trajectory):
        raise InputError(
            "A function is not a trajectory. Give its values in a table: kt.Spline(times=..., values={drive: ...})."
        )
    name = type(trajectory).__name__
    raise InputError(f"{name} is not a trajectory. Give one of the trajectory records, e.g. kt.Quintic.")


# Trajectories that reach a length of zero or less.

LEAST = 1e-9
"""Lengths up to this fraction of the length in the model count as zero."""
PLACES = 2001


def length_faults(model: ModelData, trajectory: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """A fault for every member whose length becomes zero or negative along a trajectory."""
    field, table = moved_by(trajectory)
    for name, given in table.items():
        drive = model.all_drives.get(name)
        if not isinstance(drive, LengthDrive) or drive.bar not in model.members:
            continue
        now = _length(model, drive.bar)
        if now is None:
            continue
        least, when = _least(trajectory, given, now)
        if not least > LEAST * now:
            at = f" at t = {when:.4g} s" if when is not None else ""
            yield Fault(
                (*path, field, name),
                f"takes the length of {drive.bar!r} to {least:.6g} m{at}.",
                f"A length must stay above 0 m; in the model it is {now:.6g} m.",
            )


def _length(model: ModelData, name: str) -> float | None:
    """The length of a member in the model, m; None if its nodes are unknown, which is reported by another check."""
    member = model.members[name]
    if member.length is not None:
        return float(member.length)
    ends = [model.nodes.get(end) for end in member.ends]
    places = [one.at for one in ends if one is not None]
    return dist(*places) if len(places) == 2 and len(places[0]) == len(places[1]) else None


def _least(trajectory: Any, given: Any, now: float) -> tuple[float, float | None]:
    """The smallest value of a coordinate along a trajectory (m), and its time (s) if that is neither start nor end."""
    if isinstance(trajectory, ConstantRate):
        return min(now, now + float(given) * trajectory.duration), None
    if isinstance(trajectory, Sine):
        t = np.linspace(0.0, min(trajectory.duration, trajectory.period), PLACES)
        value = now + float(given) * profiles.sine(t, trajectory.period, trajectory.phase)[0]
    elif isinstance(trajectory, StepResponse):
        t = np.linspace(0.0, trajectory.duration, PLACES)
        law = profiles.step_response(t, trajectory.frequency, trajectory.damping, trajectory.pole)[0]
        value = given[0] + (given[1] - given[0]) * law
    elif isinstance(given, tuple) and len(given) == 2:
        return float(min(given)), None
    else:
        t, value = np.array(trajectory.times) - trajectory.times[0], np.array(given, float)
    k = int(np.argmin(value))
    return float(value[k]), float(t[k])
