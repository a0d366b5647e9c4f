"""Saves a model in the chosen folder only; replaces another file only after confirmation."""

from __future__ import annotations

import re
from pathlib import Path

from kinetruss.errors import InputError
from kinetruss.io import write
from kinetruss.model import Model
from kinetruss.results.store import whole_file

__all__ = ["FileThereError", "Seen", "save", "seen_now"]

PLAIN = re.compile(r"[^\W.][\w .+-]{0,120}\.(yaml|yml|json)", re.IGNORECASE)
DEVICE = re.compile(r"(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9\u00b9\u00b2\u00b3])[ .].*", re.IGNORECASE)
"""Names of devices: on Windows a file with such a name cannot be opened, moved or deleted as usual."""

Seen = dict[Path, tuple[int, int]]
"""Size and modification time (ns) of files that a page has opened or written."""


class FileThereError(InputError):
    """Raised if a file with that name exists and would be lost."""


def seen_now(*paths: Path | None) -> Seen:
    """The present stamps of files; files that do not exist are omitted."""
    return {path.resolve(): _stamp(path) for path in paths if path is not None and path.is_file()}


def save(model: Model, folder: Path | None, name: str, seen: Seen, *, replace: bool = False, text: str | None = None) -> Path:
    """Write a model to a file in a folder, completely or not at all, and store its stamp in `seen`.

    replace : also replace a file that is not in `seen` or was changed since. text : the model as YAML, written as it is.

    Raises
    ------
    InputError : no folder was chosen, or the name is not a plain .yaml, .yml or .json file name.
    FileThereError : it would replace another file.
    StoreError : the file cannot be written.
    """
    if folder is None:
        raise InputError("No folder was chosen to write to.")
    if not PLAIN.fullmatch(name):
        raise InputError(
            f"{name!r} is not a plain file name. Write for example bay.yaml; it goes into {folder.name or folder}."
        )
    if DEVICE.fullmatch(name):
        raise InputError(f"{name!r} is the name of a device on Windows. Choose another name, for example my_{name}.")
    path = folder.resolve() / name
    if path.is_symlink() or (path.exists() and not path.is_file()):
        raise InputError(f"{name} is a link or a folder. Choose another name.")
    if path.exists() and not replace:
        _check(path, seen)
    if text is None or path.suffix.lower() == ".json":
        write(model, path)
    else:
        with whole_file(path) as draft:
            draft.write_text(text, encoding="utf-8", newline="\n")
    seen[path] = _stamp(path)
    return path


def _check(path: Path, seen: Seen) -> None:
    """Raise an error if the file was not opened or written by this page, or was changed since."""
    if path not in seen:
        raise FileThereError(
            f"{path.name} exists already, and is not the file that was opened. Overwrite it, or choose another name."
        )
    if seen[path] != _stamp(path):
        raise FileThereError(
            f"{path.name} was changed by another program since it was opened or saved here. "
            "Overwrite it, or choose another name."
        )


def _stamp(path: Path) -> tuple[int, int]:
    found = path.stat()
    return found.st_size, found.st_mtime_ns
