"""Names of a package that are imported at first use, so that light calls stay fast.

A package names what it exports once, as imports that type checkers and editors read and that Python never executes::

    if TYPE_CHECKING:
        from kinetruss.dynamics.simulation import simulate as simulate

    __getattr__, __dir__, __all__ = late(__name__)
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable
from itertools import pairwise, takewhile
from typing import Any

MOST = 16
"""Largest number of names that a message lists."""


def late(package: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """The `__getattr__`, `__dir__` and `__all__` of a package, from the imports under `if TYPE_CHECKING` in its file."""
    homes = _homes(package)
    modules = [name for name, home in homes.items() if home == package]
    exported = sorted(homes)

    def find(name: str) -> Any:
        if name not in homes:
            hint = "" if name.startswith("_") else offered(name)
            raise AttributeError(f"module {package!r} has no attribute {name!r}{hint}")
        if homes[name] == package:
            return importlib.import_module(f"{package}.{name}")
        found = getattr(importlib.import_module(homes[name]), name)
        setattr(sys.modules[package], name, found)  # the next use finds it without this function
        return found

    def offered(name: str) -> str:
        """The most similar name; or the submodule that has this one."""
        from difflib import get_close_matches  # it costs time, and no name is wrong in a light call

        near = get_close_matches(name, exported, n=1, cutoff=0.75)
        found = [f"{package}.{module}.{name}" for module in modules if name in _exported(f"{package}.{module}")] or near
        if not found and len(public := [one for one in exported if one not in modules]) <= MOST:
            return f". It has: {', '.join(public)}"
        return f". Did you mean {found[0]!r}?" if found else ""

    return find, lambda: list(exported), exported


def listed(module: str) -> Callable[[], list[str]]:
    """The `__dir__` of a module that users know: what it exports, without what it imports."""
    return lambda: list(sys.modules[module].__all__)


def _homes(package: str) -> dict[str, str]:
    """Name -> module that defines it; a submodule that is exported itself -> the package.

    From the words of the file, ``from MODULE import NAME as NAME``: a parser would take longer than all else that a light call
    does.
    """
    face: Any = sys.modules[package]
    text = face.__loader__.get_data(face.__file__).decode()
    block = text.partition("\nif TYPE_CHECKING:\n")[2].splitlines()
    lines = (line.partition("#")[0] for line in takewhile(lambda line: not line or line[0].isspace(), block))
    words = " ".join(lines).replace("(", " ").replace(")", " ").replace(",", " ").split()
    homes, module = {}, ""
    for word, following in pairwise(words):
        if word == "from":
            module = following
        elif word == "as":
            homes[following] = module
    return homes


def _exported(module: str) -> list[str]:
    try:
        return list(importlib.import_module(module).__all__)
    except (ImportError, AttributeError):  # of a package that is not installed; a module that exports nothing by name
        return []
