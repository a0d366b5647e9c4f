"""Models and runs in a notebook: ``%load_ext kinetruss`` shows them as pictures, `live` gives a model with sliders.

Parts are imported when first used; nothing below knows of notebooks.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.notebook._live import live
    from kinetruss.notebook._register import register
    from kinetruss.notebook._show import show

__all__ = ["live", "register", "show"]

_HOME = {"live": "_live", "register": "_register", "show": "_show"}


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.notebook.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.notebook' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
