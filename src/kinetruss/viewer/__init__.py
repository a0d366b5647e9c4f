"""Scenes as data, and one page that shows them in any browser without a network.

Reads models and results and computes no motion and no force. Parts are imported when first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.viewer.films.render import render
    from kinetruss.viewer.pages.pack import pack, unpack
    from kinetruss.viewer.pages.page import live_page, page
    from kinetruss.viewer.pages.write import write
    from kinetruss.viewer.scenes.record import FORMAT, VERSION, Mode, Scene
    from kinetruss.viewer.scenes.scene import scene

__all__ = ["FORMAT", "Mode", "Scene", "VERSION", "live_page", "pack", "page", "render", "scene", "unpack", "write"]

__getattr__, __dir__ = late(
    __name__,
    {
        "films.render": "render",
        "pages.pack": "pack unpack",
        "pages.page": "live_page page",
        "pages.write": "write",
        "scenes.record": "FORMAT Mode Scene VERSION",
        "scenes.scene": "scene",
    },
)
