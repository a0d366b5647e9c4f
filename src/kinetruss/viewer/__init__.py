"""What people look at: scenes as data, and one page that shows them in any browser without a network.

Reads models and results and computes no motion and no force. Parts are imported when first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.viewer.films.render import render
    from kinetruss.viewer.pages.pack import pack, unpack
    from kinetruss.viewer.pages.page import live_page, page
    from kinetruss.viewer.pages.write import write
    from kinetruss.viewer.scenes.record import FORMAT, VERSION, Mode, Scene
    from kinetruss.viewer.scenes.scene import scene

__all__ = ["FORMAT", "Mode", "Scene", "VERSION", "live_page", "pack", "page", "render", "scene", "unpack", "write"]

_HOME = {
    "FORMAT": "scenes.record", "Mode": "scenes.record", "Scene": "scenes.record", "VERSION": "scenes.record", "live_page": "pages.page",
    "pack": "pages.pack", "page": "pages.page",
    "render": "films.render", "scene": "scenes.scene", "unpack": "pages.pack", "write": "pages.write",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.viewer.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.viewer' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
