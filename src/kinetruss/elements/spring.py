"""Springs on coordinates: stiffness or a table, play, preload, damping, friction.

V' is preload + k s with s = e less what the play takes of it, or a table (s, V', V'', V) of piecewise cubics;
R(q') = damping q' + friction tanh(q'/slip).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.elements.scalars import DAMPED, KEPT, STIFF, STORED, TAKEN, Part
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, Vector

if TYPE_CHECKING:
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
    spans = [np.arange(*system.measure_ptr[m : m + 2]) for m in system.spring_measure]
    terms = np.concatenate([*spans, np.zeros(0)]).astype(np.int64)
    stiffness, rest, *others = system.spring_law.T
    damping, friction, _, play, _ = others
    return Part(
        names=system.springs,
        law=law,
        bent="the spring {!r} has friction, play or a table",
        loses=(damping != 0.0) | (friction != 0.0),
        linear=(friction == 0.0) & (play == 0.0) & (np.diff(system.spring_table_ptr) == 0),
        ptr=np.cumsum([0, *map(len, spans)]),
        kind=system.term_kind[terms],
        at=system.term_at[terms],
        data=system.term_data[terms],
        rest=rest,
        period=system.measure_period[system.spring_measure],
        numbers=np.column_stack([stiffness, *others]),
        table_ptr=system.spring_table_ptr,
        table=system.spring_table,
    )
