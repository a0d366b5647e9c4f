"""Ready-made trusses and mechanisms, materials, sections, drive trains; examples. Parts are imported when first used."""

from __future__ import annotations

import importlib
from typing import Any

__all__ = [
    "bodies",
    "build",
    "builders",
    "drives",
    "example_files",
    "joints",
    "materials",
    "mechanisms",
    "meshes",
    "sections",
    "vgt",
]

_MODULES = ("bodies", "drives", "joints", "materials", "mechanisms", "meshes", "sections", "vgt")
_HOME = {"build": "_build", "builders": "_build", "example_files": "_examples"}


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return importlib.import_module(f"kinetruss.library.{name}")
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.library.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.library' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
