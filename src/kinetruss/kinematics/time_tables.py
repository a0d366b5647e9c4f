"""Tables in time: interpolation, overshoot, their range; supports that follow a given history."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.motion.profiles import spline
from kinetruss.kinematics.measured_motions import measured_notes
from kinetruss.mechanics import System
from kinetruss.model import History, Measured, Model, Spline

if TYPE_CHECKING:
    from numpy.typing import NDArray


Floats = Any
Law = tuple[Floats, Floats, Floats]

SWING = 1e-3
"""A spline that leaves its table by more than this share of the table's range is reported."""


def through(t: Floats, times: Floats, values: Floats, shape: str) -> Law:
    """Value, rate and acceleration (n, m) at t (n,) of the interpolant of a table: times (k,), values (k, m)."""
    if shape == "spline":
        return spline(t, times, values)
    curve = monotone(times, values)
    inside = np.clip(t, times[0], times[-1])
    outside = (t != inside)[:, None]
    rate, acceleration = (np.where(outside, 0.0, curve(inside, order)) for order in (1, 2))
    return curve(inside), rate, acceleration


def monotone(times: Floats, values: Floats) -> Any:
    """Quintics through a table, with continuous acceleration, that rise only where the table rises (scipy BPoly).

    Rates d and accelerations s at the points are those of the spline through them, reduced until in every interval of
    length h and rise r the derivative has Bernstein coefficients of one sign: d, d + h s/4, the same from the other end, and
    5 r/h less these four. Without a reduction this is the spline; at a turn of the table, or where it is constant, the rate is
    0. Between the rows the error decreases as for the spline, except in the two intervals next to a turn, which is moved to a
    row: there the acceleration does not converge unless a row is at the turn itself. Source: Dougherty, Edelman & Hyman
    (1989), Math. Comp. 52, 471.
    """
    from scipy.interpolate import BPoly, make_interp_spline

    degree = 5 if times.size >= 6 else 3 if times.size >= 4 else times.size - 1
    scale = (times[-1] - times[0]) / (times.size - 1)
    u = (times - times[0]) / scale
    curve = make_interp_spline(u, values, k=degree)
    rate, second = curve(u, 1) / scale, curve(u, 2) / scale**2 if degree > 1 else np.zeros_like(values)
    for column in range(values.shape[1]):
        _limit(np.diff(times), np.diff(values[:, column]), rate[:, column], second[:, column])
    return BPoly.from_derivatives(times, np.stack([values, rate, second], axis=1))


def _limit(h: Floats, rise: Floats, rate: Floats, second: Floats) -> None:
    """Reduce rates and accelerations (k,) at the points, in place; h and rise (k - 1,) of the intervals."""
    sign = np.sign(rise)
    left, right = np.r_[sign[0], sign], np.r_[sign, sign[-1]]  # of the intervals on both sides of each point
    rate[(left * right <= 0) | (left * rate < 0)] = 0.0
    # sign (d - h s/4) >= 0 on the left, sign (d + h s/4) >= 0 on the right
    ways = ((left[1:], -h, slice(1, None)), (right[:-1], h, slice(None, -1)))
    for side, way, part in ways:
        short = side * (rate[part] + way * second[part] / 4) < 0
        second[part] = np.where(short, -4 * rate[part] / way, second[part])
    first, last = (side * (2 * rate[part] + way * second[part] / 4) for side, way, part in (ways[1], ways[0]))
    wanted, most = first + last, 5 * np.abs(rise) / h
    share = np.where(wanted > most, most / np.where(wanted > 0, wanted, 1.0), 1.0) * (sign != 0)
    cut = np.minimum(np.r_[1.0, share], np.r_[share, 1.0])
    rate *= cut
    second *= cut


def swings(what: str, times: Floats, columns: dict[str, Floats]) -> Iterator[str]:
    """A sentence for each column whose spline overshoots a constant or monotone part of its table."""
    if len(times) < 3:
        return
    fine = np.concatenate([a + (b - a) * np.linspace(0, 1, 17)[1:-1] for a, b in pairwise(times)])
    curve = spline(fine, times, np.stack(list(columns.values()), axis=1))[0].reshape(len(times) - 1, 15, -1)
    for j, (name, column) in enumerate(columns.items()):
        rise, reach = np.sign(np.diff(column)), np.ptp(column)
        around = np.stack([np.r_[rise[0], rise[:-1]], rise, np.r_[rise[1:], rise[-1]]])
        one_way = (around.min(axis=0) >= 0) | (around.max(axis=0) <= 0)
        low, high = np.minimum(column[:-1], column[1:]), np.maximum(column[:-1], column[1:])
        beyond = np.maximum(low - curve[:, :, j].min(axis=1), curve[:, :, j].max(axis=1) - high)
        beyond = np.where(one_way, beyond, 0.0)
        k = int(beyond.argmax())
        if beyond[k] > SWING * reach > 0:
            yield (
                f"The spline of {what} {name!r} swings {beyond[k]:.3g} beyond its table between {times[k]:g} s and "
                f"{times[k + 1]:g} s ({beyond[k] / reach:.1%} of its range), where the table goes one way or stands still. "
                "Give shape: monotone, or more rows there."
            )


def table_notes(model: Model, *trajectories: Any) -> str:
    """The messages on tables of trajectories and of moving supports."""
    said: list[str] = []
    for one in trajectories:
        if isinstance(one, Spline) and one.shape == "spline":
            said += swings("", np.array(one.times), {name: np.array(column) for name, column in one.values.items()})
        if isinstance(one, Measured):
            said.append(measured_notes(one))
    for node, history in model.support_motion.items():
        if history.shape == "spline" and node in model.fixed:
            table = np.array(history.displacements)
            axes = {f"{node}.{axis}": table[:, "xyz".index(axis)] for axis in model.fixed[node]}
            said += swings("support", np.array(history.times), axes)
    return " ".join(said).replace("of  '", "of '")


def check_reach(what: str, first: float, last: float, begin: float, end: float) -> None:
    """Refuse a run from `begin` to `end` (s) that goes beyond a table from `first` to `last`.

    Raises
    ------
    InputError : it does; the message names the table and both ranges.
    """
    slack = 1e-9 * max(last - first, abs(last), abs(first))
    if begin < first - slack or end > last + slack:
        raise InputError(
            f"The table of {what} goes from {first:g} s to {last:g} s, the run from {begin:g} s to {end:g} s: what it does "
            "outside is not known. Give a table over the whole run (where it stands still: repeat the last row, with "
            "shape: monotone), or end the run with it."
        )


# Supports that follow a given history.

Histories = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]


def with_supports(system: System, t: NDArray[np.float64], moving: Histories) -> Histories:
    """Value, rate and acceleration (times, coordinates) of given coordinates and, after them, of moving supports."""
    if system.model.support_motion:
        value, rate, second = (np.hstack(pair) for pair in zip(moving, support_history(system, t), strict=True))
        moving = value, rate, second
    value, rate, second = map(np.ascontiguousarray, moving)
    return value, rate, second


def support_history(system: System, t: NDArray[np.float64]) -> Histories:
    """Position, velocity, acceleration (times, coordinates) of the supports' moving coordinates, in the order of the plan.

    Quintic spline through the table (lower degree below 6 entries), or monotone.

    Raises
    ------
    InputError : times outside the table of a support that moves.
    """
    columns: list[list[NDArray[np.float64]]] = [[], [], []]
    for node, history in system.model.support_motion.items():
        start = system.x0[system.node_index(node)]
        table = np.array(history.displacements)
        if len(t):
            check_support(node, history, float(t[0]), float(t[-1]))
        for order, values in enumerate(through(t, np.array(history.times), table, history.shape)):
            for axis in system.model.fixed[node]:
                k = "xyz".index(axis)
                columns[order].append(values[:, k] + (start[k] if order == 0 else 0.0))
    empty = np.zeros((len(t), 0))
    position, velocity, acceleration = (np.stack(c, axis=1) if c else empty for c in columns)
    return position, velocity, acceleration


def check_supports(model: Model, begin: float, end: float) -> None:
    """InputError if a run from `begin` to `end` (s) goes beyond the table of a support that moves."""
    for node, history in model.support_motion.items():
        check_support(node, history, begin, end)


def check_support(node: str, history: History, begin: float, end: float) -> None:
    """InputError if a run from `begin` to `end` (s) goes beyond the table of a support that moves."""
    if any(row != history.displacements[0] for row in history.displacements):
        check_reach(f"support {node!r}", history.times[0], history.times[-1], begin, end)
