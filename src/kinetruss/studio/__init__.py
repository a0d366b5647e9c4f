"""The live studio: a local page whose sliders move the drives of a model and show forces at once.

`serve` runs it; `Session` is what one page talks to, without any network. Parts are imported when first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.studio._serve import serve
    from kinetruss.studio._session import Session

__all__ = ["Session", "serve"]

_HOME = {"Session": "_session", "serve": "_serve"}


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.studio.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.studio' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
