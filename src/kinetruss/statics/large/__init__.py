"""Large displacements: equilibria and equilibrium paths."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.statics.large.search import projected, row_errors

__all__ = ["projected", "row_errors"]

__getattr__, __dir__ = late(__name__, {"search": "projected row_errors"})
