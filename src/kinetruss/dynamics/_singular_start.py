"""A start in a singular position: its acceleration is the limit of those beside it.

There rows of the Jacobian depend on each other, and what they leave open is settled only by the motion through the position.
Along a smooth motion a(t) is smooth, so that a(0) = (4 A(e) - A(2 e))/3 + O(e^4) with A(e) the mean of a(e) and a(-e).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels import _march_state as m
from kinetruss.kernels._kkt import evaluate, project
from kinetruss.kernels._march_state import Memory, Samples

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics._problem import Problem

__all__ = ["limit_acceleration", "start_beside"]

SINGULAR = 1e-7
"""Scaled pivot at the start below which the equations do not give the acceleration."""
TURN = 0.01
"""Way to the first of the states beside the start, in parts of the shortest member."""
TURNS = 4
"""Times that the states beside the start are set up with the acceleration found last."""
LONGER = 5.0
"""First step over the cautious one, so that its stages lie well beside the singular position."""


def start_beside(problem: Problem, march: Any, control: Any, memory: Memory, samples: Samples) -> NDArray[np.float64] | None:
    """Give the memory of an integration the acceleration that the motion has in a singular start; that, (3 n,) m/s^2, or None.

    Nothing is done where the start is regular, or where all is at rest: then there is no motion to tell the branch.
    """
    a, N = np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x, v = problem.x0.copy(), problem.v0.copy()
    pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
    if pivot > SINGULAR or not np.abs(v).max() > 0 or not len(N):
        return None
    found = limit_acceleration(problem, x, v, a)
    if found is None:
        return None
    a, N, most = found
    march(problem.eq, problem.ws, problem.user.call, control, memory, samples, 0, 0, 0)
    free = problem.eq.free
    memory.y[1, len(free) : 2 * len(free)] = a[free]
    memory.multiplier[:], memory.real[m.PIVOT_MOST] = N, most
    if getattr(problem.method, "first_step", None) is None:
        memory.real[m.H] *= LONGER
    return a


def limit_acceleration(
    problem: Problem, x: NDArray[np.float64], v: NDArray[np.float64], a: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], float] | None:
    """Acceleration (3 n,) and row forces (rows,) at the start x, v, from states on both sides of it, and the largest pivot.

    None where no state beside it can be closed, or all of them are as singular.
    """
    places, A, B = x.reshape(-1, 3), problem.system.p, problem.system.q
    size = float(np.linalg.norm(places[B] - places[A], axis=1).min())
    e, most, rows = TURN * size / float(np.abs(v).max()), 0.0, len(problem.eq.row)
    pulls = np.zeros(rows)
    for _ in range(TURNS):
        means = []
        for step in (e, 2 * e):
            mean = np.zeros(x.size + rows)
            for t in (-step, step):
                y, w = x + t * v + 0.5 * t * t * a, v + t * a
                there, N = np.zeros(x.size), np.zeros(rows)
                project(problem.eq, problem.ws, 0.0, y, w, 1e-15)
                pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, y, w, there, N)
                most = max(most, float(pivot))
                if pivot < SINGULAR or not np.all(np.isfinite(there)):
                    return None
                mean += 0.5 * np.concatenate([there, N])
            means.append(mean)
        a, pulls = np.split((4 * means[0] - means[1]) / 3, [x.size])
    return a, pulls, most
