"""The command line: verbs, each a few lines over the Python interface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.cli._main import main

__all__ = ["main"]


def __getattr__(name: str) -> Any:
    if name == "main":
        from kinetruss.cli._main import main

        return main
    raise AttributeError(f"module 'kinetruss.cli' has no attribute {name!r}")
