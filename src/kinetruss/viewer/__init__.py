"""What people look at: scenes as data, and one page that shows them in any browser without a network.

Reads models and results and computes no motion and no force. Parts are imported when first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.viewer._pack import pack, unpack
    from kinetruss.viewer._page import live_page, page
    from kinetruss.viewer._record import FORMAT, VERSION, Mode, Scene
    from kinetruss.viewer._render import render
    from kinetruss.viewer._scene import scene
    from kinetruss.viewer._write import write

__all__ = ["FORMAT", "Mode", "Scene", "VERSION", "live_page", "pack", "page", "render", "scene", "unpack", "write"]

_HOME = {
    "FORMAT": "_record", "Mode": "_record", "Scene": "_record", "VERSION": "_record", "live_page": "_page",
    "pack": "_pack", "page": "_page",
    "render": "_render", "scene": "_scene", "unpack": "_pack", "write": "_write",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.viewer.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.viewer' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
