"""What the adjoint of a run (`RunPoint`) owes to its start: places and velocities that follow from numbers of the model."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.simulation_setup import problem_of
from kinetruss.errors import AnalysisError
from kinetruss.gradients.differences import FOUR
from kinetruss.gradients.run_adjoint import States
from kinetruss.gradients.varied import STEP, Varied
from kinetruss.kernels.solve.kkt import prepare_rows, row_gaps, row_gradients, row_rate_gaps

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MOVED = 1e-12
"""Change of the start by its projection, relative, that is round-off."""
JUMP = 0.1
"""Second difference of a start, as a share of the step of a number, from which on it is no smooth function of it."""


def of_start(point: Any, by: Varied, adjoint: Floats) -> Floats:
    """Derivatives (k, numbers) by what numbers change at the start, from its adjoint (k, 2 free)."""
    base, free, f = point.base, point.varying.free, len(point.varying.free)
    x, v = (one[free] for one in base.given)
    moved = np.abs(x - point.problem.x0[free]).max(initial=0.0) > MOVED * float(np.ptp(point.problem.x0))
    if moved or np.any(v) or np.any(point.problem.v0[free]):
        return _of_projected_start(point, by, adjoint)
    eq = base.problem.eq
    still = States(
        np.zeros(1),
        point.problem.x0[None],
        point.problem.v0[None],
        np.zeros((1, base.shift.size)),
        np.zeros((1, len(eq.row))),
    )
    tangent = point.varying.tangent(still)
    halves = np.concatenate([adjoint[:, :f], adjoint[:, f:]])[None]
    # M q + J^T n = l, J q = 0 : n is what the gaps of the rows count
    count = point.varying.weights(tangent, halves)[0][:, f:]
    k = len(adjoint)

    def of(change: Floats) -> Floats:
        at = point.at(by, change)
        place, speed = (one.copy() for one in at.given)
        prepare_rows(at.problem.eq, at.problem.ws, 0.0, place, speed)
        row_gradients(at.problem.eq, at.problem.ws, place)
        gaps, rates = np.empty(len(eq.row)), np.empty(len(eq.row))
        row_gaps(at.problem.eq, place, at.problem.ws.target, gaps)
        row_rate_gaps(at.problem.eq, at.problem.ws, place, speed, at.problem.ws.target, rates)
        by_rows = -(count[:k] * gaps + count[k:] * rates)
        return np.concatenate([adjoint[:, :f] * place[free] + adjoint[:, f:] * speed[free], by_rows], axis=1).reshape(-1)

    return np.asarray(point.by_numbers(by, of, point.varying.site, k))


def _of_projected_start(point: Any, by: Varied, adjoint: Floats) -> Floats:
    """The same where the start is moved onto the constraints: by the whole set-up at changed numbers, one by one."""
    free, found = point.varying.free, np.zeros((len(adjoint), len(by.names)))
    here = np.concatenate([point.problem.x0[free], point.problem.v0[free]])
    size = np.repeat([float(np.abs(one).max(initial=0.0)) or 1.0 for one in (point.problem.x0, point.problem.v0)], len(free))
    for j in range(len(by.names)):
        states = []
        for share, _ in FOUR:
            change = np.zeros(len(by.names))
            change[j] = share * STEP * by.scale[j]
            start = problem_of(by.model_at(change), point.t_end, point.options)
            states.append(np.concatenate([start.x0[free], start.v0[free]]))
        if (np.abs(states[0] + states[1] - 2.0 * here) > JUMP * STEP * size).any():
            raise AnalysisError(
                f"The start jumps with {by.names[j]}: velocities fit the constraints there and not beside it. Give "
                "velocities of all nodes, or none."
            )
        slope = sum(weight * state for (_, weight), state in zip(FOUR, states, strict=True))
        found[:, j] = adjoint @ slope / (STEP * by.scale[j])
    return found
