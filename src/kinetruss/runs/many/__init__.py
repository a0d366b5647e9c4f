"""One run of many variants of a model."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.runs.many.beside import processors
    from kinetruss.runs.many.variants import short_paths

__all__ = ["processors", "short_paths"]

__getattr__, __dir__ = late(__name__, {"beside": "processors", "variants": "short_paths"})
