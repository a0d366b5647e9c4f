"""Starts in a singular position, or right beside one: what leads away from it, and what is to be said of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.assembly.equations import held_by_none
from kinetruss.dynamics.starting.crossing import put_behind, segment_from, sizes
from kinetruss.dynamics.starting.first_segment import State
from kinetruss.dynamics.starting.singular import EXACTLY, Singular
from kinetruss.kernels.integrate.state import Memory, Samples
from kinetruss.kernels.solve.kkt import evaluate, project
from kinetruss.mechanics.constraints import moves_text
from kinetruss.mechanics.freedom import mobility_at, released
from kinetruss.model import ERROR_CONTROLLED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["First", "singular_note", "singular_start", "start_beside"]

LOW = 0.1
"""Scaled pivot at the start below which it is compared with those beside the start."""
BESIDE = 0.1
"""How far beside the start is, in parts of the shortest member."""
PLACES = 3
LARGEST, SHOWN = 400, 3
"""Free coordinates up to which, and number in which freedoms that meet are named."""


class First(NamedTuple):
    """What the equations do not give at the start: accelerations a (3 n,), m/s^2, and row forces N (rows,), N."""

    a: NDArray[np.float64]
    N: NDArray[np.float64]


def singular_start(problem: Problem) -> Singular | None:
    """What is known of a start that may be next to a singular position; None of any other."""
    a, N = np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x, v = problem.x0.copy(), problem.v0.copy()
    pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
    if not len(N) or problem.motors is not None or not pivot < LOW:
        return None
    size, tolerance = sizes(problem)
    most, gain = _beside(problem, size, tolerance)
    return Singular(float(pivot), most, gain, a, size)


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


def start_beside(problem: Problem, integrate: Any, control: Any, memory: Memory, samples: Samples) -> First | None:
    """Put the memory of an integration behind the first segment of a motion that starts next to a singular position.

    Steps of fixed size begin at the start nevertheless, with the acceleration that the motion has there. None where the start
    is regular, or where no motion leads away from it.
    """
    start = problem.singular
    if start is None:
        return None
    if not start.near:
        integrate(problem.eq, problem.ws, problem.user.call, control, memory, samples.part(0, 0), 0)
        memory.pivot_most = max(start.pivot, start.most)
        return None
    found = segment_from(problem, control, State(0.0, problem.x0, problem.v0, start.a), 0, start.gain)
    if found is None:
        return None
    integrate(problem.eq, problem.ws, problem.user.call, control, memory, samples.part(0, 0), 0)
    memory.pivot_most = start.most
    if not isinstance(problem.method, ERROR_CONTROLLED) or problem.method.step is not None:
        nf = len(problem.eq.free)
        memory.y[1, nf : 2 * nf], memory.multiplier[:] = found.a0[problem.eq.free], found.N0
    else:
        put_behind(problem, memory, found)
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
