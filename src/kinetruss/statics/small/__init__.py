"""Small displacements: the stiffness method with iterative refinement and error bounds; linear buckling."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.statics.small.stiffness import flexibility, stiff_rows

__all__ = ["flexibility", "stiff_rows"]

__getattr__, __dir__ = late(__name__, {"stiffness": "flexibility stiff_rows"})
