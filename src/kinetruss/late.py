"""Names of a package that are imported at first use, so that light calls stay fast."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Any

__all__ = ["late", "listed"]

MOST = 16
"""Largest number of names that a message lists."""


def late(package: str, homes: Mapping[str, str], modules: str = "") -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """The `__getattr__` and the `__dir__` of a package.

    homes : module, relative to the package (dotted) or by its full name -> the names that it exports, in one text. modules :
        submodules that are exported themselves, in one text. The package lists all names in `__all__`.
    """
    home = {name: module for module, names in homes.items() for name in names.split()}
    own = frozenset(modules.split())

    def find(name: str) -> Any:
        if name in home:
            whole = home[name].startswith("kinetruss.")
            return getattr(importlib.import_module(home[name] if whole else f"{package}.{home[name]}"), name)
        if name in own:
            return importlib.import_module(f"{package}.{name}")
        raise AttributeError(f"module {package!r} has no attribute {name!r}{'' if name.startswith('_') else offered(name)}")

    def offered(name: str) -> str:
        """The most similar name; or the submodule that has this one."""
        near = get_close_matches(name, sys.modules[package].__all__, n=1, cutoff=0.75)
        places = [f"{package}.{module}.{name}" for module in modules.split() if name in _exported(f"{package}.{module}")]
        found = places or near
        if not found and len(public := [one for one in sys.modules[package].__all__ if one not in own]) <= MOST:
            return f". It has: {', '.join(public)}"
        return f". Did you mean {found[0]!r}?" if found else ""

    return find, listed(package)


def listed(package: str) -> Callable[[], list[str]]:
    """The `__dir__` of a package: what it exports, without its submodules and imports."""

    def known() -> list[str]:
        return list(sys.modules[package].__all__)

    return known


def _exported(module: str) -> list[str]:
    try:
        return list(importlib.import_module(module).__all__)
    except ImportError:  # of a package that is not installed
        return []
