"""Starts in a singular position, or right beside one: what leads away from it, and what is to be said of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics._equations import held_by_none
from kinetruss.dynamics._launch import Launch, launch
from kinetruss.kernels import _march_state as m
from kinetruss.kernels._dop853 import interpolate
from kinetruss.kernels._kkt import evaluate, project
from kinetruss.kernels._march_state import Memory, Samples
from kinetruss.kinematics._freedom import released
from kinetruss.kinematics._mobility import mobility_at, moves_text
from kinetruss.model import DOP853, Taylor

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics._problem import Problem

__all__ = ["First", "Singular", "singular_note", "singular_start", "start_beside"]

SINGULAR = 1e-3
"""Scaled pivot at the start, in parts of those beside it, below which the equations do not give a good acceleration."""
BESIDE = 0.1
"""How far beside the start is, in parts of the shortest member."""
PLACES = 3
EXACTLY = 1e-7
"""The same below which the start counts as one right in a singular position."""
LOOKS = 65
"""Places of the first stretch at which its singular positions are looked for."""
LARGEST, SHOWN = 400, 3
"""Free coordinates up to which, and number in which freedoms that meet are named."""
STRETCH = 0.3
"""Length of the first stretch, in parts of the time in which a member moves by its length."""


class First(NamedTuple):
    """What the equations do not give at the start: accelerations a (3 n,), m/s^2, and row forces N (rows,), N."""

    a: NDArray[np.float64]
    N: NDArray[np.float64]


class Singular(NamedTuple):
    """A start next to a singular position.

    pivot, most : scaled pivots there and beside it. gain : largest acceleration beside it, m/s^2; a (3 n,) : what the equations
    give at the start. size : of the shortest member, m. tolerance : of projections.
    """

    pivot: float
    most: float
    gain: float
    a: NDArray[np.float64]
    size: float
    tolerance: float


def singular_start(problem: Problem) -> Singular | None:
    """What is known of a start next to a singular position; None of any other."""
    a, N = np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x, v = problem.x0.copy(), problem.v0.copy()
    pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
    if not len(N) or problem.motors is not None or not pivot < SINGULAR:
        return None
    places = problem.system.x0
    size = float(np.linalg.norm(places[problem.system.q] - places[problem.system.p], axis=1).min())
    tolerance = max(1e-15, 2.2e-16 * (1.0 + float(np.abs(places).max()) / size))
    most, gain = _beside(problem, size, tolerance)
    return Singular(float(pivot), most, gain, a, size, tolerance) if pivot < SINGULAR * most else None


def singular_note(problem: Problem) -> tuple[str, ...]:
    """What is to be said of a start that is singular, and at rest; nothing where a velocity chooses the way."""
    found = problem.singular
    if found is None or found.pivot > EXACTLY * found.most or np.abs(problem.v0).max() > 0:
        return ()
    where = f"The start is a singular position, at rest{_freedoms(problem)}: nothing says which of the ways on it takes."
    mend = f"To choose, start {1e-2 * found.size:.2g} m off it, or with velocities."
    return (f"{where} Followed is the one nearest to what the forces ask for. {mend}",)


def _freedoms(problem: Problem) -> str:
    """In words, the freedoms that meet there."""
    system = released(problem.system, held_by_none(problem.system, dict(problem.tasks)))
    if len(system.free) > LARGEST:
        return ""
    there = mobility_at(system, problem.x0.reshape(-1, 3))
    texts = [moves_text(mode, there.node_names) for mode in there.mechanisms[:SHOWN]]
    more = f", and {there.undriven - SHOWN} more" if there.undriven > SHOWN else ""
    return f", where {there.undriven} freedoms meet ({'; '.join(texts)}{more})"


def start_beside(problem: Problem, march: Any, control: Any, memory: Memory, samples: Samples) -> First | None:
    """Put the memory of an integration behind the first stretch of a motion that starts next to a singular position.

    Steps of fixed size begin at the start nevertheless, with the acceleration that the motion has there. None where the start
    is regular, or where no motion leads away from it.
    """
    start = problem.singular
    if start is None:
        return None
    pace = max(float(np.abs(problem.v0).max()) / start.size, float(np.sqrt(start.gain / start.size)))
    if not pace > 0:
        return None
    fixed = problem.isolated and not problem.user.given
    # the motion may be foreseen farther than it is asked for, but not through a jump
    span = STRETCH / pace if fixed else min(STRETCH / pace, float(control.breaks[0, 1]))
    found = launch(problem, start.a, span, both=fixed, size=start.size, tolerance=start.tolerance)
    if found is None:
        return None
    march(problem.eq, problem.ws, problem.user.call, control, memory, samples, 0, 0, 0)
    memory.real[m.PIVOT_MOST] = start.most
    _put(problem, memory, found)
    _record(problem, memory, found)
    return First(found.a0, found.N0)


def _beside(problem: Problem, size: float, tolerance: float) -> tuple[float, float]:
    """Largest scaled pivot beside the start; the least of the largest accelerations there, m/s^2; 0 where none closes."""
    free, rng, most, gain = problem.eq.free, np.random.default_rng(0), 0.0, np.inf
    # any way, and that which weights in a row ask for
    ways = [*rng.standard_normal((PLACES, len(free))), *(np.equal(free % 3, axis) * 1.0 for axis in range(problem.system.dim))]
    for way in ways:
        x, v = problem.x0.copy(), problem.v0.copy()
        x[free] += BESIDE * size * way
        a, N = np.zeros(x.size), np.zeros(len(problem.eq.row))
        good, _, _ = project(problem.eq, problem.ws, 0.0, x, v, tolerance)
        pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
        if good and np.isfinite(a).all() and pivot > 0:
            most, gain = max(most, float(pivot)), min(gain, float(np.abs(a).max()))
    return most, gain if most > 0 else 0.0


def _put(problem: Problem, memory: Memory, found: Launch) -> None:
    """The memory behind the first stretch, as behind a step; steps of fixed size stay at the start."""
    free, real = problem.eq.free, memory.real
    nf = len(free)
    if not isinstance(problem.method, DOP853 | Taylor) or problem.method.step is not None:
        memory.y[1, nf : 2 * nf], memory.multiplier[:] = found.a0[free], found.N0
        return
    memory.y[0] = np.concatenate([found.x[free], found.v[free]])
    memory.y[1] = np.concatenate([found.v[free], found.a[free]])
    memory.dense[: len(found.dense)] = found.dense
    memory.multiplier[:] = found.N
    real[m.T], real[m.T_OLD], real[m.H_OLD], real[m.PIVOT] = found.end, 0.0, found.end, found.pivot
    real[m.H] = min(real[m.H], 0.3 * found.end) if problem.method.first_step else 0.3 * found.end
    memory.count[m.STEPS], memory.count[m.EVALUATIONS] = 1, memory.count[m.EVALUATIONS] + found.evaluations


def _record(problem: Problem, memory: Memory, found: Launch) -> None:
    """Enter the passages of the first stretch: where its scaled pivot is least, if that counts as singular."""
    from scipy.optimize import minimize_scalar

    if not memory.count[m.STEPS]:
        return
    times, limit = np.linspace(0.0, found.end, LOOKS), SINGULAR * memory.real[m.PIVOT_MOST]
    pivots = np.array([_pivot(problem, found, t) for t in times])
    places = [(0.0, pivots[0])] if pivots[0] < EXACTLY * memory.real[m.PIVOT_MOST] else []
    for k in range(1, LOOKS - 1):
        if pivots[k] == pivots[k - 1 : k + 2].min() or (k == 1 and not places and pivots[0] < pivots[1]):
            least = minimize_scalar(lambda t: _pivot(problem, found, t), bounds=(times[k - 1], times[k + 1]), method="bounded",
                                    options={"xatol": 1e-9 * found.end})  # fmt: skip
            places.append((float(least.x), float(least.fun)))
    for when, least in places:
        if least < limit and memory.count[m.PASSAGES] < len(memory.passages):
            memory.passages[memory.count[m.PASSAGES]] = when, least, float(np.abs(problem.v0).max() > 0)
            memory.count[m.PASSAGES] += 1


def _pivot(problem: Problem, found: Launch, t: float) -> float:
    """Scaled pivot at t (s) of the first stretch."""
    y, free = np.zeros(found.dense.shape[1]), problem.eq.free
    interpolate(found.dense, min(max(t / found.end, 0.0), 1.0), y)
    x, v, a, N = problem.x0.copy(), problem.v0.copy(), np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x[free], v[free] = y[: len(free)], y[len(free) :]
    project(problem.eq, problem.ws, t, x, v, 1e-13)
    return float(evaluate(problem.eq, problem.ws, problem.user.call, t, x, v, a, N))
