"""Scenes as data, and one page that shows them in any browser without a network.

Reads models and results and computes no motion and no force. Parts are imported when first used.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.viewer.moving import FORMAT as FORMAT, VERSION as VERSION, Mode as Mode, Scene as Scene
    from kinetruss.viewer.packing import pack as pack, unpack as unpack
    from kinetruss.viewer.pictures import render as render
    from kinetruss.viewer.scenes import scene as scene
    from kinetruss.viewer.self_contained import live_page as live_page, page as page, write as write

__getattr__, __dir__, __all__ = late(__name__)
