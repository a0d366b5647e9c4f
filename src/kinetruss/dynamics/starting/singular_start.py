"""Starts in or near a singular position: the first segment of the motion, and the note on it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.assembly.equations import held_by_none
from kinetruss.dynamics.starting.crossing import advance_by, segment_from, sizes
from kinetruss.dynamics.starting.first_segment import State
from kinetruss.dynamics.starting.singular import EXACTLY, Singular
from kinetruss.kernels.integrate.state import Memory, Samples
from kinetruss.kernels.solve.kkt import evaluate, project
from kinetruss.mechanics.constraints import moves_text
from kinetruss.mechanics.freedom import beam_deformations, mobility_at, released
from kinetruss.model import ERROR_CONTROLLED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["First", "singular_note", "singular_start", "start_beside"]

LOW = 0.1
"""Scaled pivot at the start below which it is compared with pivots of nearby positions."""
BESIDE = 0.1
"""Distance of the nearby positions as a fraction of the shortest member."""
PLACES = 3
"""Number of nearby positions."""
LARGEST = 400
"""Number of free coordinates up to which the degrees of freedom at the start are named."""
SHOWN = 3
"""Largest number of degrees of freedom that are named."""


class First(NamedTuple):
    """Values at the start that the equations do not give: accelerations a (3 n,), m/s^2, constraint forces N (rows,), N."""

    a: NDArray[np.float64]
    N: NDArray[np.float64]


def singular_start(problem: Problem) -> Singular | None:
    """Data of a start that may be near a singular position; None for any other start."""
    a, N = np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x, v = problem.x0.copy(), problem.v0.copy()
    pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
    if not len(N) or problem.motors is not None or not pivot < LOW:
        return None
    size, tolerance = sizes(problem)
    most, gain = _beside(problem, size, tolerance)
    return Singular(float(pivot), most, gain, a, size)


def singular_note(problem: Problem) -> tuple[str, ...]:
    """The note on a singular start at rest; empty if a velocity determines the motion."""
    found = problem.singular
    if found is None or found.pivot > EXACTLY * found.most or np.abs(problem.v0).max() > 0:
        return ()
    where = (
        f"The start is a singular position, at rest{_freedoms(problem)}: "
        "nothing determines which of the possible motions it takes."
    )
    fix = f"To choose a motion, start {1e-2 * found.size:.2g} m away from it, or with velocities."
    return (f"{where} The motion computed is the one nearest to the accelerations of the forces. {fix}",)


def _freedoms(problem: Problem) -> str:
    """The degrees of freedom at the start as text."""
    system = released(problem.system, held_by_none(problem.system, dict(problem.tasks)))
    if len(system.free) > LARGEST:
        return ""
    there = mobility_at(system, problem.x0.reshape(-1, 3), beam_deformations)
    texts = [moves_text(system, mode) for mode in there.mechanisms[:SHOWN]]
    more = f", and {there.undriven - SHOWN} more" if there.undriven > SHOWN else ""
    return f", with {there.undriven} degrees of freedom ({'; '.join(texts)}{more})"


def start_beside(problem: Problem, integrate: Any, control: Any, memory: Memory, samples: Samples) -> First | None:
    """Advance the memory of an integration by the first segment of a motion that starts near a singular position.

    Methods with fixed steps still begin at the start, with the accelerations of the motion there. Returns None if the start
    is regular, or if no segment is found.
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
        advance_by(problem, memory, found)
    return First(found.a0, found.N0)


def _beside(problem: Problem, size: float, tolerance: float) -> tuple[float, float]:
    """Largest scaled pivot near the start, and the smallest of the largest accelerations there, m/s^2; 0 if none can close."""
    free, rng, most, gain = problem.eq.free, np.random.default_rng(0), 0.0, np.inf
    # a direction without symmetry, and the one of weights in a row
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
