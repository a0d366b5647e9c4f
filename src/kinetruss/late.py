"""Names of a package that are imported when first used, so that a light call loads nothing heavy."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Mapping
from typing import Any

__all__ = ["late"]


def late(package: str, homes: Mapping[str, str], modules: str = "") -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """The `__getattr__` and the `__dir__` of a package.

    homes : module below the package (dotted), or of the library by its whole name -> the names that it gives, in one text.
    modules : modules of the package that are names themselves, in one text. The package lists all in `__all__`.
    """
    home = {name: module for module, names in homes.items() for name in names.split()}
    own = frozenset(modules.split())

    def find(name: str) -> Any:
        if name in home:
            whole = home[name].startswith("kinetruss.")
            return getattr(importlib.import_module(home[name] if whole else f"{package}.{home[name]}"), name)
        if name in own:
            return importlib.import_module(f"{package}.{name}")
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    def known() -> list[str]:
        return list(sys.modules[package].__all__)

    return find, known
