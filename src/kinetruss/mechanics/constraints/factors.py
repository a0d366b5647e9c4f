"""Factors of square sparse matrices."""

from __future__ import annotations

from typing import Any

from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from kinetruss.mechanics.constraints.matchings import structural_rank

__all__ = ["SYMMETRIC", "factors_of", "matched"]

SYMMETRIC: dict[str, Any] = {"options": {"SymmetricMode": True}}
"""Options of SuperLU for matrices with a symmetric pattern: pivots on the diagonal are tried first."""


def factors_of(matrix: Any, **options: Any) -> Any:
    """Factors by SuperLU (Demmel et al., 1999), with `solve`, `U` and permutations; None if the matrix is singular.

    A matrix whose rows and columns cannot be matched is refused first: in symmetric mode SuperLU reads and writes outside
    its memory if a column has no entries left.
    """
    square = csc_array(matrix)
    if not matched(square, symmetric=options.get("options") == SYMMETRIC["options"]):
        return None
    try:
        return splu(square, **options)
    except RuntimeError:
        return None


def matched(square: Any, *, symmetric: bool) -> bool:
    """Whether every row of a square matrix has a column of its own in which it has an entry.

    With a symmetric pattern, rows with a diagonal entry need no search. If all other rows are matched, the matching
    consists of cycles and of paths that end at such a row. The rows of a path with an even number are matched in pairs; of
    a path with an odd number, in pairs and by the diagonal entry at its end. This takes a hundredth of the work for the
    matrices of statics.
    """
    if not symmetric:
        return structural_rank(square) == int(square.shape[0])
    bare = square.diagonal() == 0.0
    return bool(not bare.any() or structural_rank(square.tocsr()[bare]) == bare.sum())
