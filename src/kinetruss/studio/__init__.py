"""The live studio: a local page whose sliders move the drives of a model and which shows the forces immediately.

`serve` runs it; a `Session` answers one page and needs no network. Parts are imported when first used.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.studio.messages import Session as Session
    from kinetruss.studio.serving import serve as serve

__getattr__, __dir__, __all__ = late(__name__)
