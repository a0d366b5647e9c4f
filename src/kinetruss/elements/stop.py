"""Stops on coordinates: contact beyond a gap, V = k d^(n + 1)/(n + 1), R = k d^n damping d', never a pull.

K. H. Hunt, F. R. E. Crossley, J. Appl. Mech. 42 (1975) 440-445, eq. 8.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.elements.numbers import one_copy
from kinetruss.elements.scalars import DAMPED, KEPT, STIFF, STORED, TAKEN, Part, measures_of, terms_of
from kinetruss.errors import InputError
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.model.simulation import Event

if TYPE_CHECKING:
    from kinetruss.mechanics.system import System

LOWER, UPPER, STIFFNESS, EXPONENT, DAMPING = range(5)
"""Numbers of a stop; both ends as distances from the value in the model."""
ROUND_OFF = 1e-14
"""How far beyond its stop a coordinate of the model may be, m or rad: it touches where its nodes are only written down so."""


@kernel_bare
def law(numbers: F1, table: F2, first: int, last: int, e: float, rate: float, out: F1) -> None:  # noqa: ARG001
    """As elements.scalars.law."""
    for k in range(5):
        out[k] = 0.0
    side = 1.0 if e > numbers[UPPER] else -1.0
    d = e - numbers[UPPER] if side > 0.0 else numbers[LOWER] - e
    if d <= 0.0:
        return
    k, n, moving = numbers[STIFFNESS], numbers[EXPONENT], numbers[DAMPING] * side * rate
    push = k * d**n
    out[KEPT], out[STORED] = side * push, push * d / (n + 1.0)
    if moving <= -1.0:
        # the surfaces part faster than the contact follows
        out[TAKEN] = -side * push
        return
    out[TAKEN] = side * push * moving
    out[STIFF] = k * n * d ** (n - 1.0) * (1.0 + moving)
    out[DAMPED] = push * numbers[DAMPING]


def stops(system: System) -> Part:
    """The stops of a model."""
    records, measures = system.model.stops, measures_of(system, "stop")
    start, switches = system.measure_start[..., measures], {}
    numbers = system.numbers("stop", "lower", "upper", "stiffness", "exponent", "damping")
    here = start[(0,) * (start.ndim - 1)].real
    for k, (name, one) in enumerate(records.items()):
        ends = {"lower": one.lower, "upper": one.upper}
        for end, sign in (("lower", 1.0), ("upper", -1.0)):
            if (value := ends[end]) is None:
                continue
            if sign * (here[k] - value) < -ROUND_OFF * max(1.0, abs(value)):
                raise InputError(
                    f"stops.{name}.{end}: the coordinate is {here[k]:.6g} in the model, beyond the stop at {value:.6g}. "
                    "Move the nodes or the stop."
                )
            switches[f"{name}.{end}"] = Event(coordinate=one.coordinate, terms=one.terms, value=value, stop=False)
    for column, none_there in ((LOWER, -math.inf), (UPPER, math.inf)):
        given = numbers[..., column]
        numbers[..., column] = np.where(np.isnan(given), none_there, given - start)
    none = np.zeros(len(records), np.int64)
    return Part(
        names=tuple(records),
        law=law,
        bent="the stop {!r} is met or left",
        loses=one_copy(numbers)[:, DAMPING] > 0.0,
        linear=none,
        rest=start,
        numbers=numbers,
        table_ptr=np.zeros(len(records) + 1, np.int64),
        table=np.zeros((0, 4)),
        switches=switches,
        **terms_of(system, measures),
    )
