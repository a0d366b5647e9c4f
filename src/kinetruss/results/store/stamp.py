"""The stamp that distinguishes a file from a later one with the same path."""

from __future__ import annotations

from pathlib import Path

__all__ = ["Stamp", "stamp_of"]

Stamp = tuple[int, int]
"""Number of the file on its disk, and the time of its last change, ns."""


def stamp_of(file: Path) -> Stamp | None:
    """The stamp of a file; None if it does not exist."""
    try:
        found = file.stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns
