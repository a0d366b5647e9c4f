"""The text of a file, or one fault with the reason why it cannot be read."""

from __future__ import annotations

from difflib import get_close_matches
from pathlib import Path

from kinetruss.io.formats.tree import refuse

__all__ = ["MAX_SIZE", "read_text"]

MAX_SIZE = 64_000_000
"""Largest size of a file, bytes, unless the caller allows more. A larger file is not read."""


def read_text(path: Path, max_size: int) -> str:
    """UTF-8 text of a file, without a byte-order mark.

    Raises
    ------
    ModelError : the file does not exist, is a folder, cannot be read, is larger than `max_size` bytes, or is not UTF-8.
    """
    if path.is_dir():
        raise refuse("is a folder.", "Name a model file in it, e.g. model.yaml.")
    try:
        size = path.stat().st_size
        if size <= max_size:
            with path.open("rb") as file:
                data = file.read(max_size + 1)  # one byte more: a device or pipe may not report its size
            size = len(data)
    except FileNotFoundError:
        raise refuse("there is no such file.", _offer(path)) from None
    except OSError as error:
        raise refuse(f"cannot be read: {error.strerror}.", "Change its permissions.") from None
    if size > max_size:
        mend = "Raise it with --max-size (max_size=...) if the file is meant."
        raise refuse(f"has {size:,} bytes, more than the limit of {max_size:,} bytes.", mend, (1, 1))
    return _decoded(data)


def _decoded(data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line_start = data.rfind(b"\n", 0, error.start) + 1
        place = data.count(b"\n", 0, error.start) + 1, len(data[line_start : error.start].decode("utf-8-sig")) + 1
        byte = f"byte {error.start} (0x{data[error.start]:02x})"
        looks = " It looks like UTF-16." if data[:2] in (b"\xff\xfe", b"\xfe\xff") else ""
        raise refuse(f"is not UTF-8 text: {byte} is not allowed in it.{looks}", "Save the file as UTF-8.", place) from None


def _offer(path: Path) -> str:
    try:
        names = [item.name for item in path.parent.iterdir()]
    except OSError:
        return f"There is no folder {str(path.parent)!r} either."
    near = get_close_matches(path.name, names, n=1, cutoff=0.5)
    return f"Did you mean {str(path.with_name(near[0]))!r}?" if near else f"Look in {str(path.parent)!r}."
