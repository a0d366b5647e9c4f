"""Models and runs in a notebook: ``%load_ext kinetruss`` shows them as pictures, `live` shows a model with sliders.

Parts are imported when first used. No other package depends on notebooks.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.notebook._live import live
    from kinetruss.notebook._register import register
    from kinetruss.notebook._show import show

__all__ = ["live", "register", "show"]

__getattr__, __dir__ = late(
    __name__,
    {
        "_live": "live",
        "_register": "register",
        "_show": "show",
    },
)
