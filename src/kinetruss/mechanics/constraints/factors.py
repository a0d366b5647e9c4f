"""Factors of square sparse matrices."""

from __future__ import annotations

from typing import Any

from scipy.sparse import csc_array
from scipy.sparse.csgraph import structural_rank
from scipy.sparse.linalg import splu

__all__ = ["SYMMETRIC", "factors_of", "matched"]

SYMMETRIC: dict[str, Any] = {"options": {"SymmetricMode": True}}
"""Of matrices with a symmetric pattern: pivots are looked for on the diagonal first."""


def factors_of(matrix: Any, **options: Any) -> Any:
    """Factors by SuperLU (Demmel et al., 1999), with `solve`, `U` and permutations; None where the matrix is singular.

    A matrix whose rows and columns cannot be matched is refused before: in its symmetric mode SuperLU reads and writes outside
    its memory where a column is left without entries.
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

    Where the pattern is symmetric, rows with an entry on the diagonal need no look: if all others have columns of their own,
    these make cycles, and paths that end at such a row; a path of an even number of rows is matched by pairs, one of an odd
    number by pairs and the diagonal entry at its end. That is a hundredth of the work for the matrices of statics.
    """
    if not symmetric:
        return bool(structural_rank(square) == square.shape[0])
    bare = square.diagonal() == 0.0
    return bool(not bare.any() or structural_rank(square.tocsr()[bare]) == bare.sum())
