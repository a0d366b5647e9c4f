"""Constraints along a motion, their rank, null spaces and what these mean in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.constraints.basis import null_basis
    from kinetruss.mechanics.constraints.derivatives import Derivatives, held_rows
    from kinetruss.mechanics.constraints.elimination import Elimination
    from kinetruss.mechanics.constraints.factors import SYMMETRIC, factors_of
    from kinetruss.mechanics.constraints.matchings import matching, structural_rank
    from kinetruss.mechanics.constraints.moves import moves_text, ranked
    from kinetruss.mechanics.constraints.null_space import Spaces

__all__ = [
    "Derivatives",
    "Elimination",
    "SYMMETRIC",
    "Spaces",
    "factors_of",
    "held_rows",
    "matching",
    "moves_text",
    "null_basis",
    "ranked",
    "structural_rank",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "elimination": "Elimination",
        "factors": "SYMMETRIC factors_of",
        "matchings": "matching structural_rank",
        "derivatives": "Derivatives held_rows",
        "moves": "moves_text ranked",
        "basis": "null_basis",
        "null_space": "Spaces",
    },
)
