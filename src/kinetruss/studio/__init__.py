"""The live studio: a local page whose sliders move the drives of a model and which shows the forces immediately.

`serve` runs it; a `Session` answers one page and needs no network. Parts are imported when first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.studio._serve import serve
    from kinetruss.studio._session import Session

__all__ = ["Session", "serve"]

__getattr__, __dir__ = late(
    __name__,
    {
        "_serve": "serve",
        "_session": "Session",
    },
)
