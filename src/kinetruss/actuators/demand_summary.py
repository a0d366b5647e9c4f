"""What follows from the whole history of a demand: peaks against limits, energies, root mean squares."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr

from kinetruss.actuators.screws import is_self_locking, largest_self_locking_lead
from kinetruss.actuators.shafts import Geared, Output, Parts, at_motor, output_of, parts_of
from kinetruss.display import instant, quantity
from kinetruss.display.ranks import largest_first, place_of_largest
from kinetruss.model import Active, Model
from kinetruss.results import Arrays, Axes, Column, Demand, variable
from kinetruss.results.wide_tables import SLACK

if TYPE_CHECKING:
    from numpy.typing import NDArray


FEWEST = 4
"""Samples a cubic spline needs."""


def current_rate(
    time: NDArray[np.float64], current: NDArray[np.float64], moving: NDArray[np.float64], thrust: NDArray[np.float64]
) -> NDArray[np.float64]:
    """dI/dt (A/s), shape (times,), from samples of the current.

    The current jumps where the motion turns (friction turns with it) and bends where the thrust does: between two such
    places the derivative of a cubic spline through the samples is taken, exact to the third order of their distance; of two
    or three samples, differences. A sample alone between two jumps has none: the spike of a jump is not counted.
    """
    found = np.zeros_like(current)
    signs = 3 * np.sign(moving) + np.sign(thrust)
    cuts = np.flatnonzero(np.diff(signs)) + 1
    for part in np.split(np.arange(len(time)), cuts):
        if len(part) >= FEWEST:
            from scipy.interpolate import CubicSpline

            found[part] = CubicSpline(time[part], current[part])(time[part], 1)
        elif len(part) > 1:
            found[part] = np.gradient(current[part], time[part])
    return found


# Limits that a demand exceeds: which, when, by how much.


@dataclass(frozen=True, slots=True)
class Exceeded:
    """One limit exceeded for one stretch of time.

    start, end : s, between two samples by straight lines (NaN for a root mean square, which belongs to the whole motion).
    time : s, of the worst; value : its magnitude there, and limit, in `unit`.
    """

    active: str
    quantity: str
    start: float
    end: float
    time: float
    value: float
    limit: float
    unit: str

    def __str__(self) -> str:
        excess = f"{quantity(self.value / self.limit - 1, '%')} above {quantity(self.limit, self.unit)}"
        if math.isnan(self.start):
            return f"{self.active}: {self.quantity} {quantity(self.value, self.unit)} over the motion, {excess}."
        what = "stroke from the middle between its limits" if self.quantity == "stroke" else self.quantity
        when = f"at {instant(self.start)}" if self.start == self.end else f"from {instant(self.start)} to {instant(self.end)}"
        return f"{self.active}: {what} too high {when}; {quantity(self.value, self.unit)} at {instant(self.time)}, {excess}."


def exceeded(demand: Demand) -> tuple[Exceeded, ...]:
    """Every limit that a demand exceeds, with each stretch of time in which it does; worst first.

    As text, one is for example ``M7: voltage too high from 0.2941 s to 0.7059 s; 36.3 V at 0.5 s, 45.2 % above 25 V.``

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.Quintic(moves={"actuator": (2.5, 3.0)}, duration=1.0), samples=21)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> [(one.active, one.quantity, round(one.time, 2), float(one.limit)) for one in kt.actuators.exceeded(demand)]
    [('actuator', 'voltage', 0.45, 25.0)]
    """
    found = list(_found(demand))
    return tuple(largest_first(found, lambda one: one.value / one.limit))


def _found(demand: Demand) -> Iterator[Exceeded]:
    data = demand.data
    time = data["time"].values
    value, limit = data["value"].values, data["limit"].values
    for i, active in enumerate(data["active"].values):
        for j, (what, (unit, history)) in enumerate(QUANTITIES.items()):
            if not value[i, j] > limit[i, j] * (1 + SLACK):
                continue
            if history is None:
                yield Exceeded(str(active), what, *(math.nan,) * 3, value[i, j], limit[i, j], unit)
                continue
            magnitudes = np.abs(data[history].values[:, i])
            for start, end, at in _stretches(time, magnitudes, limit[i, j]):
                yield Exceeded(str(active), what, start, end, float(time[at]), float(magnitudes[at]), limit[i, j], unit)


def _stretches(time: NDArray[np.float64], values: NDArray[np.float64], limit: float) -> Iterator[tuple[float, float, int]]:
    """Begin, end and sample of the largest value of every stretch above the limit."""
    above = np.concatenate(([False], values > limit * (1 + SLACK), [False]))
    firsts, ends = np.flatnonzero(~above[:-1] & above[1:]), np.flatnonzero(above[:-1] & ~above[1:])
    for first, end in zip(firsts.tolist(), ends.tolist(), strict=True):
        start = _crossing(time, values, first - 1, limit) if first > 0 else float(time[0])
        stop = _crossing(time, values, end - 1, limit) if end < len(time) else float(time[-1])
        yield start, stop, first + place_of_largest(values[first:end])


def _crossing(time: NDArray[np.float64], values: NDArray[np.float64], at: int, limit: float) -> float:
    """Where the straight line from sample `at` to the next meets the limit; the nearer one where both are on one side of it."""
    share = (limit - values[at]) / (values[at + 1] - values[at])
    return float(time[at] + min(max(share, 0.0), 1.0) * (time[at + 1] - time[at]))


# What follows from the whole history of a demand: peaks against limits, energies, root mean squares.

QUANTITIES = {
    "voltage": ("V", "voltage"),
    "current": ("A", "current"),
    "speed": ("rad/s", "motor_speed"),
    "torque": ("N m", "motor_torque"),
    "stroke": ("m", "stroke"),
    "break-away": ("N m", "breakaway_torque"),
    "input": ("V", "amplifier_input"),
    "rms current": ("A", None),
    "rms torque": ("N m", None),
}
"""What is held against a limit: unit, history (None: of the whole motion)."""

ALWAYS = ("voltage", "current", "speed", "torque", "stroke")
"""Quantities that are listed even where nobody gave a limit."""

TOTALS = {
    "electrical_energy": ("J", "electrical energy of the motion, net", "sum"),
    "drawn_energy": ("J", "electrical energy without feeding back", "sum"),
    "returned_energy": ("J", "electrical energy fed back", "sum"),
    "actuator_work": ("J", "work of the thrust, net", "sum"),
    "positive_work": ("J", "work of the thrust where it drives", "sum"),
    "negative_work": ("J", "work of the thrust where it is driven", "sum"),
    "copper_energy": ("J", "heat in the winding", "sum"),
    "motor_loss": ("J", "friction of the motor", "sum"),
    "gear_loss": ("J", "lost in the gear", "sum"),
    "screw_loss": ("J", "friction of the screw", "sum"),
    "stored_energy": ("J", "gained by rotor and winding", "sum"),
    "energy_balance": ("J", "electrical energy minus all it went to: the error of the sampling", "sum"),
    "rms_torque": ("N m", "root mean square motor torque", "rms"),
    "rms_current": ("A", "root mean square motor current", "rms"),
    "gear_ratio": ("", "gear ratio that brings the motor to its largest speed", "least"),
    "largest_self_locking_lead": ("m/rad", "largest lead that holds by itself, for this thread", "same"),
    "self_locking": ("", "screw or gear holds by itself", "same"),
}
"""What belongs to a whole motion: unit, words, how two stretches of time go together."""


def summarise(model: Model, demand: Demand) -> Demand:
    """The same demand with what follows from its whole time history.

    Use it after joining histories of consecutive stretches of time; `evaluate` has done it already.

    Returns
    -------
    Demand with, over (active, quantity), ``value`` (largest magnitude), ``limit``, ``utilisation``, ``margin``, ``time_of``,
    ``note`` for voltage, current, speed, torque, stroke, and where it has a limit: break-away torque, amplifier input, root
    mean square current and torque. And over (active), J: ``electrical_energy`` (net), ``drawn_energy`` (nothing fed back),
    ``returned_energy``, ``actuator_work``, ``positive_work``, ``negative_work``, ``copper_energy``, ``motor_loss``,
    ``gear_loss``, ``screw_loss``, ``stored_energy``, ``energy_balance``; ``rms_torque`` N m, ``rms_current`` A; ``gear_ratio``
    (at which the motor comes to its largest speed; NaN where none is given), ``largest_self_locking_lead`` m/rad,
    ``self_locking``.

    Notes
    -----
    Integrals are by the trapezoidal rule over the samples. Electrical energy = winding + motor + gear + screw + stored + work
    of the thrust; at every sample this holds exactly for the powers (`power_flow`), over a motion to the error of the rule.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"actuator": 0.01}, duration=1.0), samples=11)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> again = kt.actuators.summarise(model, demand).data  # `evaluate` has done it already
    >>> again.equals(demand.data), bool(again.self_locking.sel(active="actuator"))
    (True, True)
    """
    kept = {str(name): one for name, one in demand.arrays.items() if one.dims == ("time", "active")}
    return demand.with_(data=summarised(model, demand.arrays["time"].values, kept, demand.attrs))


def summarised(model: Model, time: NDArray[np.float64], kept: Mapping[str, Column], attrs: Mapping[str, Any]) -> Arrays:
    """Histories over (time, active) with their summary."""
    members = list(model.actuators.values())
    parts = [parts_of(model, active) for active in members]
    data = {name: one.values for name, one in kept.items()}
    found = [
        _totals(one, members[k], time, {name: values[:, k] for name, values in data.items()}) for k, one in enumerate(parts)
    ]
    totals = {
        name: variable(
            ("active",), np.array([one[name] for one in found], np.bool_ if name == "self_locking" else float), *words[:2]
        )
        for name, words in TOTALS.items()
    }
    peaks = _peaks(members, parts, time, data, found)
    return Arrays(_axes(tuple(model.actuators)), time, {**kept, **totals, **peaks}, attrs)


@lru_cache(maxsize=64)
def _axes(names: tuple[str, ...]) -> Axes:
    units = np.array([unit for unit, _ in QUANTITIES.values()])
    return Axes(
        {
            "active": np.array(names, dtype=object).astype(str),
            "quantity": np.array(list(QUANTITIES)),
            "unit": ("quantity", units),
        }
    )


def merge_summaries(first: xr.Dataset, second: xr.Dataset, durations: tuple[float, float]) -> xr.Dataset:
    """The summary of two consecutive stretches of time from those of each, and their durations (s).

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"actuator": 0.01}, duration=1.0), samples=11)
    >>> one = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion)).data
    >>> both = kt.actuators.merge_summaries(one, one, (1.0, 1.0))  # the same second twice
    >>> round(float(both.electrical_energy[0] / one.electrical_energy[0]), 6)
    2.0
    >>> round(float(both.rms_current[0] / one.rms_current[0]), 6)
    1.0
    """
    # an entry without a limit has no utilisation: its largest value counts
    one, two = (part["utilisation"].fillna(part["value"]).fillna(-1.0) for part in (first, second))
    peaks = [name for name, part in second.data_vars.items() if "quantity" in part.dims]
    merged = second.assign(first[peaks].where(one >= two, second[peaks]))
    for name, (_, _, rule) in TOTALS.items():
        a, b = first[name], second[name]
        joined: Any = b
        if rule == "sum":
            joined = a + b
        elif rule == "rms":
            joined = np.sqrt((a**2 * durations[0] + b**2 * durations[1]) / sum(durations))
        elif rule == "least":
            joined = np.fmin(a, b)
        merged[name] = joined.assign_attrs(b.attrs)
    for peak, name in (("rms current", "rms_current"), ("rms torque", "rms_torque")):
        which = {"quantity": list(QUANTITIES).index(peak)}
        merged = merged.assign({key: merged[key].copy() for key in ("value", "utilisation", "margin")})
        limit = merged["limit"].values[:, which["quantity"]]
        merged["value"][which] = merged[name].values
        merged["utilisation"][which], merged["margin"][which] = _judged(merged[name].values, limit)
    return merged


class _Column(NamedTuple):
    """Histories of one active member."""

    time: NDArray[np.float64]
    data: dict[str, NDArray[np.float64]]

    def integral(self, values: NDArray[np.float64]) -> float:
        """Trapezoidal rule along time."""
        return float(np.sum(np.diff(self.time) * (values[1:] + values[:-1])) / 2)

    def rms(self, values: NDArray[np.float64]) -> float:
        """Root mean square; of a single instant its own value."""
        duration = self.time[-1] - self.time[0] if len(self.time) > 1 else 0.0
        return float(np.sqrt(self.integral(values**2) / duration if duration else np.sum(values**2)))


def _totals(parts: Parts, active: Geared, time: NDArray[np.float64], columns: dict[str, NDArray[np.float64]]) -> dict[str, Any]:
    """Everything of TOTALS for one active member or drive of an angle."""
    column = _Column(time, columns)
    power, work = columns["electrical_power"], columns["actuator_power"]
    screw, gear, motor, _ = parts
    behind = output_of(parts, active, columns)
    fastest = 0.0 if behind is None else float(np.abs(behind.rate).max(initial=0.0)) / behind.lead
    highest = None if motor is None else motor.max_speed
    found = {
        "electrical_energy": column.integral(power),
        "drawn_energy": column.integral(np.maximum(power, 0)),
        "returned_energy": column.integral(np.maximum(-power, 0)),
        "actuator_work": column.integral(work),
        "positive_work": column.integral(np.maximum(work, 0)),
        "negative_work": column.integral(np.minimum(work, 0)),
        "rms_torque": column.rms(columns["motor_torque"]),
        "rms_current": column.rms(columns["current"]),
        "gear_ratio": np.nan if highest is None or fastest == 0 else highest / fastest,
        "largest_self_locking_lead": np.nan if screw is None else largest_self_locking_lead(screw),
        "self_locking": (screw is not None and is_self_locking(screw)) or (gear is not None and gear.self_locking),
    }
    return found | _losses(parts, behind, column, found)


def _losses(parts: Parts, behind: Output | None, column: _Column, found: dict[str, Any]) -> dict[str, float]:
    """Where the electrical energy went."""
    _, gear, motor, _ = parts
    names = ("copper_energy", "motor_loss", "gear_loss", "screw_loss", "stored_energy", "energy_balance")
    if behind is None or motor is None or not len(column.time):
        return dict.fromkeys(names, np.nan)
    data, speed = column.data, column.data["motor_speed"]
    mismatch = (motor.emf_constant - motor.torque_constant) * speed * data["current"]
    through = behind.torque * behind.speed
    carried = at_motor(gear, behind.torque, speed) * speed
    inertia = motor.inertia + (gear.inertia if gear is not None else 0.0)
    stored = 0.5 * inertia * speed**2 + 0.5 * motor.inductance * data["current"] ** 2
    spent = {
        "copper_energy": column.integral(motor.resistance * data["current"] ** 2),
        "motor_loss": column.integral(motor.friction_torque * np.abs(speed) + mismatch),
        "gear_loss": column.integral(carried - through),
        "screw_loss": column.integral(through - data["actuator_power"]),
        "stored_energy": float(stored[-1] - stored[0]),
    }
    balance = found["electrical_energy"] - found["actuator_work"] - sum(spent.values())
    return spent | {"energy_balance": balance}


def _limit(parts: Parts, active: Geared, quantity: str) -> float | None:
    motor, amplifier = parts.motor, parts.amplifier
    if quantity == "stroke":
        limits = active.limits if isinstance(active, Active) else None
        return (limits[1] - limits[0]) / 2 if limits else None
    if motor is None:
        return None
    if quantity == "break-away":
        by_current = None if motor.max_current is None else motor.max_current * motor.torque_constant
        return min((limit for limit in (motor.max_torque, by_current) if limit is not None), default=None)
    if quantity == "input":
        return None if amplifier is None else amplifier.max_input
    field = quantity.replace("rms ", "rated_") if quantity.startswith("rms ") else f"max_{quantity}"
    limit: float | None = getattr(motor, field)
    if quantity in ("voltage", "current") and amplifier is not None:
        own = getattr(amplifier, field)
        limit = own if limit is None else limit if own is None else min(limit, own)
    return limit


def _peaks(
    members: list[Geared],
    parts: list[Parts],
    time: NDArray[np.float64],
    data: Mapping[Any, NDArray[np.float64]],
    totals: list[dict[str, Any]],
) -> dict[str, Column]:
    """Largest magnitudes against limits, over (active, quantity)."""
    shape = (len(members), len(QUANTITIES))
    value, limit, when = (np.full(shape, np.nan) for _ in range(3))
    note = np.full(shape, "", dtype="<U48")
    for j, (peak, (_, history)) in enumerate(QUANTITIES.items()):
        for i, active in enumerate(members):
            magnitudes = np.abs(data[history][:, i]) if history in data else np.empty(0)
            if history is None:
                value[i, j] = totals[i][peak.replace(" ", "_")]
            elif magnitudes.size and not np.isnan(magnitudes).all():
                at = place_of_largest(magnitudes)
                value[i, j], when[i, j] = magnitudes[at], time[at]
            elif peak == "torque":
                # one line a member is enough to say that its motor is missing
                screwless = isinstance(active, Active) and parts[i].screw is None
                note[i, j] = f"not checked: no {'screw' if screwless else 'motor'}"
            if np.isnan(value[i, j]):
                continue
            allowed = _limit(parts[i], active, peak)
            limit[i, j] = np.nan if allowed is None else allowed
            note[i, j] = "no limit given" if allowed is None and peak in ALWAYS else ""
    utilisation, margin = _judged(value, limit)
    over = ("active", "quantity")
    return {
        "value": variable(over, value, "", "largest magnitude, in the quantity's unit"),
        "limit": variable(over, limit, "", "limit, in the quantity's unit"),
        "utilisation": variable(over, utilisation, "", "value over limit"),
        "margin": variable(over, margin, "", "1/utilisation - 1"),
        "time_of": variable(over, when, "s", "time of the largest magnitude"),
        "note": variable(over, note, "", "why there is no utilisation"),
    }


def _judged(value: NDArray[np.float64], limit: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Utilisation and margin."""
    utilisation = value / limit
    with np.errstate(divide="ignore"):
        return utilisation, 1 / utilisation - 1
