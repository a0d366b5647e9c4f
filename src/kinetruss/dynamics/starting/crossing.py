"""Steps across singular positions, computed outside the kernels, if explicit steps cannot determine the branch."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.starting.first_segment import Segment, State, segment
from kinetruss.dynamics.starting.singular import EXACTLY, SINGULAR
from kinetruss.kernels.integrate.state import Memory
from kinetruss.kernels.solve.kkt import evaluate, project
from kinetruss.kernels.steps.dop853 import interpolate

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["advance_by", "sizes", "cross_singular", "segment_from"]

SEGMENT = 0.3
"""Duration of a segment as a fraction of the time in which a member moves by its length."""
LOOKS = 65
"""Number of instants of a segment at which singular positions are searched."""
NEXT = 0.3
"""First step after a segment, as a fraction of the segment."""


def sizes(problem: Problem) -> tuple[float, float]:
    """Length of the shortest member, m, and the smallest tolerance of projections that round-off allows."""
    places = problem.system.x0
    size = float(np.linalg.norm(places[problem.system.q] - places[problem.system.p], axis=1).min())
    return size, max(1e-15, 2.2e-16 * (1.0 + float(np.abs(places).max()) / size))


def cross_singular(problem: Problem, control: Any, memory: Memory) -> None:
    """Advance the memory by one segment from its present state. If there is none, the next step is taken without it."""
    memory.alone = 1
    if len(problem.z0):
        return
    free, nf = problem.eq.free, len(problem.eq.free)
    x, v, a = problem.x0.copy(), problem.v0.copy(), np.zeros(problem.x0.size)
    x[free], v[free], a[free] = memory.y[0, :nf], memory.y[0, nf : 2 * nf], memory.y[1, nf : 2 * nf]
    here = State(float(memory.t), x, v, a)
    found = segment_from(problem, control, here, int(memory.interval), float(np.abs(a).max()))
    if found is not None:
        memory.alone = 0
        advance_by(problem, memory, found)


def segment_from(problem: Problem, control: Any, start: State, interval: int, gain: float) -> Segment | None:
    """A segment from a state, in an interval without jumps; gain : size of the accelerations near the state, m/s^2."""
    size, tolerance = sizes(problem)
    pace = max(float(np.abs(start.v).max()) / size, float(np.sqrt(gain / size)))
    if not pace > 0:
        return None
    fixed = problem.isolated and not problem.user.given
    # the segment may end after the last sample, but not after a jump
    left = np.inf if fixed else 0.9 * (float(control.breaks[0, interval + 1]) - start.t)
    return segment(problem, start, min(SEGMENT / pace, left), both=fixed, size=size, tolerance=tolerance)


def advance_by(problem: Problem, memory: Memory, found: Segment) -> None:
    """Advance the memory to the end of a segment as after a step; the work after every step is still to be done."""
    free = problem.eq.free
    memory.y[0] = np.concatenate([found.x[free], found.v[free]])
    memory.y[1] = np.concatenate([found.v[free], found.a[free]])
    memory.dense[: len(found.dense)], memory.multiplier[:] = found.dense, found.N
    span = found.end - found.begin
    memory.t, memory.t_old, memory.h_old, memory.pivot = found.end, found.begin, span, found.pivot
    memory.h, memory.error_old, memory.constraint = NEXT * span, 1e-4, 0.0
    memory.pivot_most = max(memory.pivot_most, found.pivot)
    memory.steps, memory.evaluations = memory.steps + 1, memory.evaluations + found.evaluations
    memory.launched, memory.series = 1, 0
    _record(problem, memory, found)


def _record(problem: Problem, memory: Memory, found: Segment) -> None:
    """Store the singular passages of a segment: minima of its scaled pivot below the limit of singularity."""
    from scipy.optimize import minimize_scalar

    times, most = np.linspace(found.begin, found.end, LOOKS), float(memory.pivot_most)
    pivots = np.array([_pivot(problem, found, t) for t in times])
    places = [(found.begin, pivots[0])] if found.begin == 0.0 and pivots[0] < EXACTLY * most else []
    for k in range(1, LOOKS - 1):
        if pivots[k] == pivots[k - 1 : k + 2].min() or (k == 1 and not places and pivots[0] < pivots[1]):
            least = minimize_scalar(
                lambda t: _pivot(problem, found, t),
                bounds=(times[k - 1], times[k + 1]),
                method="bounded",
                options={"xatol": 1e-9 * (found.end - found.begin)},
            )
            places.append((float(least.x), float(least.fun)))
    for when, least in places:
        if least < SINGULAR * most:
            if (k := memory.passages_met) < len(memory.passages):
                memory.passages[k] = when, least, float(when > 0 or np.abs(problem.v0).max() > 0)
            memory.passages_met += 1


def _pivot(problem: Problem, found: Segment, t: float) -> float:
    """Scaled pivot of the equations at t (s) of a segment."""
    y, free = np.zeros(found.dense.shape[1]), problem.eq.free
    interpolate(found.dense, min(max((t - found.begin) / (found.end - found.begin), 0.0), 1.0), y)
    x, v, a, N = problem.x0.copy(), problem.v0.copy(), np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x[free], v[free] = y[: len(free)], y[len(free) :]
    project(problem.eq, problem.ws, t, x, v, 1e-13)
    return float(evaluate(problem.eq, problem.ws, problem.user.call, t, x, v, a, N))
