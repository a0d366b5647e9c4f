"""Model files and tables: read, write, check; the JSON Schema; a value set by its path; export of stored runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kinetruss.io._check import check
from kinetruss.io._history import NodeHistory, read_history
from kinetruss.io._read import read
from kinetruss.io._set_value import set_value
from kinetruss.io._text import MAX_SIZE
from kinetruss.io._write import write

if TYPE_CHECKING:
    from kinetruss.io._export import export

__all__ = ["MAX_SIZE", "NodeHistory", "check", "export", "read", "read_history", "set_value", "write"]


def __getattr__(name: str) -> Any:
    if name == "export":  # the run store is not needed to read a model
        from kinetruss.io._export import export

        return export
    raise AttributeError(f"module 'kinetruss.io' has no attribute {name!r}")
