"""Large displacements: equilibria and paths of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.statics.large.settle import row_errors

__all__ = ["row_errors"]

__getattr__, __dir__ = late(__name__, {"settle": "row_errors"})
