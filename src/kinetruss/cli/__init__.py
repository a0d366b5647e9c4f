"""The command line: each command calls the Python interface."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.cli._main import main

__all__ = ["main"]

__getattr__, __dir__ = late(__name__, {"_main": "main"})
