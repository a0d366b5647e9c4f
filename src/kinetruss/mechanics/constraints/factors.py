"""Factors of square sparse matrices."""

from __future__ import annotations

from typing import Any

from scipy.sparse import csc_array
from scipy.sparse.csgraph import structural_rank
from scipy.sparse.linalg import splu

__all__ = ["SYMMETRIC", "factors_of"]

SYMMETRIC: dict[str, Any] = {"options": {"SymmetricMode": True}}
"""Of matrices with a symmetric pattern: pivots are looked for on the diagonal first."""


def factors_of(matrix: Any, **options: Any) -> Any:
    """Factors by SuperLU (Demmel et al., 1999), with `solve`, `U` and permutations; None where the matrix is singular.

    A matrix whose rows and columns cannot be matched is refused before: in its symmetric mode SuperLU reads and writes outside
    its memory where a column is left without entries.
    """
    square = csc_array(matrix)
    if structural_rank(square) < square.shape[0]:
        return None
    try:
        return splu(square, **options)
    except RuntimeError:
        return None
