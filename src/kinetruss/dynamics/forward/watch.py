"""Events as the integrators need them, and the times of jumps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.constraints.motions import POLYNOMIAL
from kinetruss.kernels.integrate.state import COORDINATE, FORCE, LENGTH
from kinetruss.kernels.structure.plan import CABLE, ENGINEERING, GREEN
from kinetruss.kernels.structure.plan import LENGTH as LENGTH_KIND
from kinetruss.mechanics import System

if TYPE_CHECKING:
    from kinetruss.kernels.structure.equations import Equations

__all__ = ["described", "jumps", "watched"]

WAYS = {"rising": 1, "falling": -1, "both": 0}
SAME = 1e-9
"""Relative tolerance below which two adjacent segments of a motion count as continuous."""


def watched(system: System, eq: Equations, events: Mapping[str, Any]) -> list[tuple[int, int, int, float, int, bool]]:
    """Kind, coordinates or constraint, value, direction and stop flag of every event.

    The force of an elastic bar is a function of its length, so its length is watched instead.

    Raises
    ------
    InputError : the force of a damped, slack or free bar, or of a free drive: no multiplier of the equations gives it.
    """
    return [(*_quantity(system, eq, name, event), WAYS[event.direction], bool(event.stop)) for name, event in events.items()]


def _quantity(system: System, eq: Equations, name: str, event: Any) -> tuple[int, int, int, float]:
    if event.coordinate is not None:
        node, _, axis = event.coordinate.rpartition(".")
        return COORDINATE, 3 * system.node_index(node) + "xyz".index(axis), 0, event.value
    i = system.members.index(event.length if event.length is not None else event.force)
    a, b = 3 * int(system.p[i]), 3 * int(system.q[i])
    if event.length is not None:
        return LENGTH, a, b, event.value
    rows = np.flatnonzero((system.row_member[eq.row] == i) & (system.row_kind[eq.row] == LENGTH_KIND))
    if len(rows):
        return FORCE, int(rows[0]), 0, event.value
    return LENGTH, a, b, _length_at(system, i, name, event)


def _length_at(system: System, i: int, name: str, event: Any) -> float:
    """The length at which an elastic bar has the force of the event."""
    k, l0, law, N = system.spring[i], system.natural[i], system.law[i], event.value
    if law == ENGINEERING and not system.damping[i]:
        return float(l0 + N / k)
    if law == CABLE and not system.damping[i] and N >= 0:
        return float(l0 + N / k)
    if law == GREEN and not system.damping[i]:
        # N = k (l^2 - l0^2) l/(2 l0^2) has one root above the length of greatest compression
        roots = np.roots([1.0, 0.0, -(l0**2), -2.0 * N * l0**2 / k])
        real = roots[np.abs(roots.imag) < 1e-9 * l0].real
        if real.max() > l0 / np.sqrt(3.0):
            return float(real.max())
    raise InputError(
        f"events.{name}: the force of {event.force!r} cannot be watched. "
        "Forces of rigid and driven members, of undamped elastic bars and, from 0 N on, of cables can be. "
        "Watch a length or a coordinate instead."
    )


def described(name: str, event: Any) -> str:
    """An event as text."""
    what = next(field for field in ("length", "coordinate", "force") if getattr(event, field) is not None)
    way = {"rising": "rises through", "falling": "falls through", "both": "crosses"}[event.direction]
    unit = "N" if what == "force" else "m"
    return f"{name} ({what} {getattr(event, what)} {way} {event.value:g} {unit})"


def jumps(eq: Equations, all_pieces: bool = False) -> list[float]:
    """Times (s) at which the slope of a load, or the value, rate or acceleration of a drive or support, may jump."""
    found = {float(t) for t in (*eq.force_time, *eq.follower_time)}
    for d in range(len(eq.motion_kind)):
        if eq.motion_kind[d] != POLYNOMIAL:
            continue
        first, last = eq.motion_ptr[d], eq.motion_ptr[d + 1]
        for k in range(first, last - 1):
            curve = np.polynomial.Polynomial(eq.piece[k])
            s = eq.piece_start[k + 1] - eq.piece_start[k]
            if all_pieces:
                found.add(float(eq.piece_start[k + 1]))
            for order in range(0 if all_pieces else 3):
                before, after = curve.deriv(order)(s) if order else curve(s), eq.piece[k + 1, order] * (1, 1, 2)[order]
                if abs(after - before) > SAME * max(1.0, abs(before), abs(after)):
                    found.add(float(eq.piece_start[k + 1]))
    return sorted(found)
