"""Springs on coordinates: stiffness or a table, play, preload, damping, friction.

V' is preload + k s with s = e less what the play takes of it, or a table (s, V', V'', V) of piecewise cubics;
R(q') = damping q' + friction tanh(q'/slip).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.elements.numbers import one_copy
from kinetruss.elements.scalars import DAMPED, KEPT, STIFF, STORED, TAKEN, Part, measures_of, terms_of
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, Vector

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System

STIFFNESS, DAMPING, FRICTION, SLIP, PLAY, PRELOAD = range(6)
"""Numbers of a spring."""


@kernel_bare
def _cubic(table: F2, first: int, last: int, s: float) -> Vector:
    """V', V'' and V of the points first:last of a table at the deflection s."""
    low, high = first, last - 1
    end = low if s < table[low, 0] else (high if s >= table[high, 0] else -1)
    if end >= 0:
        # straight on behind the last point
        d = s - table[end, 0]
        force, slope = table[end, 1], table[end, 2]
        return force + slope * d, slope, table[end, 3] + force * d + 0.5 * slope * d * d
    # bisection for the piece that holds s
    while high - low > 1:
        middle = (low + high) // 2
        if table[middle, 0] <= s:
            low = middle
        else:
            high = middle
    h = table[high, 0] - table[low, 0]
    t, f0, f1, m0, m1 = (s - table[low, 0]) / h, table[low, 1], table[high, 1], h * table[low, 2], h * table[high, 2]
    # Hermite's cubic f0 + m0 t + a t^2 + b t^3
    a, b = 3.0 * (f1 - f0) - 2.0 * m0 - m1, 2.0 * (f0 - f1) + m0 + m1
    energy = table[low, 3] + h * t * (f0 + t * (m0 / 2.0 + t * (a / 3.0 + t * b / 4.0)))
    return f0 + t * (m0 + t * (a + t * b)), (m0 + t * (2.0 * a + 3.0 * t * b)) / h, energy


@kernel_bare
def _resisting(numbers: F1, rate: float) -> tuple[float, float]:
    """R and dR/dq'."""
    c, friction = numbers[DAMPING], numbers[FRICTION]
    if friction == 0.0:
        return c * rate, c
    share = math.tanh(rate / numbers[SLIP])
    return c * rate + friction * share, c + friction * (1.0 - share * share) / numbers[SLIP]


@kernel_bare
def law(numbers: F1, table: F2, first: int, last: int, e: float, rate: float, out: F1) -> None:
    """As elements.scalars.law."""
    play = numbers[PLAY]
    deflection, free = e - min(max(e, -play), play), play > 0.0 and abs(e) <= play
    if last > first:
        force, slope, energy = _cubic(table, first, last, deflection)
    else:
        slope = numbers[STIFFNESS]
        force, energy = slope * deflection, 0.5 * slope * deflection * deflection
    out[KEPT], out[STIFF] = numbers[PRELOAD] + force, 0.0 if free else slope
    out[STORED] = numbers[PRELOAD] * e + energy
    out[TAKEN], out[DAMPED] = _resisting(numbers, rate)


def springs(system: System) -> Part:
    """The springs of a model."""
    records = system.model.springs
    measures = measures_of(system, "spring")
    numbers = system.numbers("spring", "stiffness", "damping", "friction", "slip", "play", "preload")
    points, ptr = [np.zeros((0, 4))], [0]
    for one in records.values():
        if one.table is not None:
            points.append(_points(np.array(one.table, float)))
        ptr.append(sum(map(len, points)))
    first = one_copy(numbers)
    straight = (first[:, FRICTION] == 0.0) & (first[:, PLAY] == 0.0) & (np.diff(ptr) == 0)
    rest = system.numbers("spring", "rest")[..., 0]
    return Part(
        names=tuple(records),
        law=law,
        bent="the spring {!r} has friction, play or a table",
        loses=(first[:, DAMPING] != 0.0) | (first[:, FRICTION] != 0.0),
        linear=straight,
        rest=np.where(np.isnan(rest), system.measure_start[..., measures], rest),
        numbers=numbers,
        table_ptr=np.array(ptr),
        table=np.concatenate(points),
        **terms_of(system, measures),
    )


def _points(given: NDArray[np.float64]) -> NDArray[np.float64]:
    """Deflection, force, slope and energy (k, 4) at the points (k, 2) of a monotone cubic; the energy is 0 at deflection 0."""
    from scipy.interpolate import PchipInterpolator

    s, force = given.T
    cubic = PchipInterpolator(s, force)
    slope, energy = cubic.derivative()(s), cubic.antiderivative()(s)
    end = int(np.clip(np.searchsorted(s, 0.0), 0, len(s) - 1))
    at_zero = (
        cubic.antiderivative()(0.0)
        if s[0] <= 0.0 <= s[-1]
        else energy[end] - force[end] * s[end] + 0.5 * slope[end] * s[end] ** 2
    )
    return np.stack([s, force, slope, energy - at_zero], axis=1)
