"""The singularity measure at given positions: how far a structure is from a position in which its drives do not hold it."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.plan import ALONE, Plan
from kinetruss.mechanics import System, arrange, constraint_jacobian, rearrange
from kinetruss.mechanics.freedom import shaped

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["singularity_at"]


def singularity_at(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """The measure (times,) at flat positions x (times, 3 n), m; 0 where the drives leave anything free.

    1/|P A^-1 E| of the worst block A of the block triangular form, rows of unit length: E has a column for the length or angle
    of each row, but for a rigid part only one, its size; P leaves out nodes that only their own part depends on. Without
    rigid parts it is the smallest singular value of the block. `Motion.singularity` is the same, by iteration. Of a redundant
    structure the blocks have independent rows, chosen at each position.
    """
    system = shaped(system)
    arrangement, found = arrange(system), np.zeros(len(x))
    regular = arrangement.plan is not None and not len(arrangement.redundant)
    for i, place in enumerate(x.reshape(len(x), *system.x0.shape)):
        plan = arrangement.plan if regular else rearrange(system, place, None).plan
        if plan is not None:
            J = constraint_jacobian(system, place).tocsr()
            found[i] = min((_of_block(plan, b, J, place) for b in range(len(plan.ptr) - 1)), default=1.0)
    return found


def _of_block(plan: Plan, b: int, J: Any, x: NDArray[np.float64]) -> float:
    """The measure of one block of J at positions x (n, 3), at most 1."""
    rows, columns = slice(*plan.ptr[b : b + 2]), plan.col[plan.ptr[b] : plan.ptr[b + 1]]
    A = J[plan.row[rows]][:, columns].toarray()
    counts, seen = plan.counts[rows], plan.seen[rows]
    if (counts == ALONE).all() and seen.all():
        return min(1.0, float(np.linalg.svd(A, compute_uv=False)[-1]))
    rates = [np.eye(len(A))[:, counts == ALONE]]
    for first, last in pairwise(plan.size_ptr[plan.sized_ptr[b] : plan.sized_ptr[b + 1] + 1]):
        mine, longest = plan.size_row[first:last].T
        length = np.linalg.norm(
            x.ravel()[plan.B[mine][:, None] + range(3)] - x.ravel()[plan.A[mine][:, None] + range(3)], axis=1
        )
        column = np.zeros((len(A), 1))
        column[mine - plan.ptr[b], 0] = length / length[longest == 1].max()
        rates.append(column)
    E = np.hstack(rates)
    if not E.size or not seen.any():
        return 1.0
    try:
        moved = np.linalg.solve(A, E)[seen == 1]
    except np.linalg.LinAlgError:
        return 0.0
    return float(min(1.0, 1 / max(float(np.linalg.norm(moved, 2)), 1e-300)))
