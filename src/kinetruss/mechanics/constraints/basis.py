"""What rows allow to change, as an orthonormal basis by singular values."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics.structure.constraint_gradients import RANK_TOLERANCE

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["null_basis"]


def null_basis(J: Any, tolerance: float = RANK_TOLERANCE) -> NDArray[np.float64]:
    """Orthonormal basis (f, k) of the changes that sparse J (rows, f) allows.

    Singular values up to `tolerance` times the largest count as zero.
    """
    from scipy.linalg import svd

    if not J.shape[0]:
        return np.eye(J.shape[1])
    dense = J.toarray()
    try:
        _, sizes, right = svd(dense)
    except np.linalg.LinAlgError:  # divide and conquer does not always converge
        _, sizes, right = svd(dense, lapack_driver="gesvd")
    rank = int(np.sum(sizes > tolerance * sizes.max(initial=0.0)))
    return np.asarray(right[rank:].T)
