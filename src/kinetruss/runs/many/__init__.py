"""One run of many variants of a model."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.runs.many.variants import short_paths

__all__ = ["short_paths"]

__getattr__, __dir__ = late(__name__, {"variants": "short_paths"})
