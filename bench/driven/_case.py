"""The driven truss as plain data, and its right bar forces by dense algebra of its own.

A chain of double-octahedral bays, half of each bar's mass at each of its nodes, so that codes without consistent mass answer
the same question. The bars of the middle triangles are driven: each length follows a quintic from its start, at rest at
both ends. A code fills `state` with the tensions (samples, bars) at `times`, N; NaN where it was not asked.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from _cases import Bars, chain_bars

STEPS, DURATION = 1000, 1.0
CHANGE = (0.10, -0.05, 0.08)  # of the three driven lengths of a bay, relative
SETTLED = 100  # first steps that do not count: integrators take them to settle


@lru_cache(maxsize=4)
def truss(bays: int) -> Bars:
    return chain_bars(bays, lumped=True)


def driven(bars: Bars) -> np.ndarray:
    """Numbers of the driven bars."""
    return np.flatnonzero(~bars.rigid)


def times() -> np.ndarray:
    return np.linspace(0.0, DURATION, STEPS + 1)


def changes(bars: Bars) -> np.ndarray:
    """Change of length of each bar from start to end, m."""
    change = np.zeros(len(bars.ends))
    own = driven(bars)
    change[own] = np.resize(CHANGE, len(own)) * bars.lengths[own]
    return change


def course(t: np.ndarray) -> np.ndarray:
    """10 s^3 - 15 s^4 + 6 s^5 of s = t/DURATION with its two derivatives, (3, times)."""
    s = np.asarray(t) / DURATION
    value, rate, second = s**3 * (10 - 15 * s + 6 * s**2), 30 * s**2 * (1 - s) ** 2, 60 * s * (1 - s) * (1 - 2 * s)
    return np.stack([value, rate / DURATION, second / DURATION**2])


@lru_cache(maxsize=4)
def right(bays: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Positions, velocities, accelerations (samples, nodes, 3) and tensions (samples, bars).

    Newton's method on the squared lengths; J v and J a from their derivatives; J'N = loads - M a.
    """
    bars = truss(bays)
    free, change = ~bars.fixed, changes(bars)
    p, q = bars.ends.T
    x, found = bars.points.copy(), []
    for s, rate, second in course(times()).T:
        length, speed, pull = bars.lengths + change * s, change * rate, change * second
        for _ in range(20):
            step = np.linalg.solve(_rows(bars, x), _flat(length**2 - _squared(x[q] - x[p])) / 2)
            x[free] += step.reshape(-1, 3)
            if np.abs(step).max() < 1e-13:
                break
        rows = _rows(bars, x)
        v, a = np.zeros_like(x), np.zeros_like(x)
        v[free] = np.linalg.solve(rows, length * speed).reshape(-1, 3)
        a[free] = np.linalg.solve(rows, speed**2 + length * pull - _squared(v[q] - v[p])).reshape(-1, 3)
        load = bars.force + bars.lump[:, None] * (bars.gravity - a)
        density = np.linalg.solve(rows.T, load[free].reshape(-1))
        found.append((x.copy(), v, a, density * length))
    position, velocity, acceleration, tension = (np.array(each) for each in zip(*found, strict=True))
    return position, velocity, acceleration, tension


def error_of(bays: int, state: list[float]) -> float:
    """Largest difference of a tension over the largest tension, where the code was asked, after the first steps."""
    tension = right(bays)[3]
    found = np.reshape(state, tension.shape)[SETTLED:]
    asked = ~np.isnan(found)
    return float(np.abs(found - tension[SETTLED:])[asked].max() / np.abs(tension).max())


def _rows(bars: Bars, x: np.ndarray) -> np.ndarray:
    """Half the derivatives of the squared lengths to the free coordinates: square, as the truss is determinate."""
    p, q = bars.ends.T
    k, rows = np.arange(len(p)), np.zeros((len(p), *x.shape))
    rows[k, q], rows[k, p] = x[q] - x[p], x[p] - x[q]
    return rows[:, ~bars.fixed].reshape(len(p), -1)


def _squared(d: np.ndarray) -> np.ndarray:
    return np.einsum("ij,ij->i", d, d)


def _flat(values: np.ndarray) -> np.ndarray:
    return values.reshape(-1)
