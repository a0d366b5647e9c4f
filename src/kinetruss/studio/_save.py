"""A model into the chosen folder, and nowhere else."""

from __future__ import annotations

import re
from pathlib import Path

from kinetruss.errors import InputError
from kinetruss.io import write
from kinetruss.model import Model

__all__ = ["save"]

PLAIN = re.compile(r"[^\W.][\w .+-]{0,120}\.(yaml|yml|json)", re.IGNORECASE)


def save(model: Model, folder: Path | None, name: str) -> Path:
    """Write a model as a file of a folder, whole or not at all.

    Raises
    ------
    InputError : no folder was chosen, or the name is not that of a plain .yaml, .yml or .json file.
    StoreError : the file cannot be written.
    """
    if folder is None:
        raise InputError("No folder was chosen to write to.")
    if not PLAIN.fullmatch(name):
        raise InputError(f"{name!r} is no plain file name. Write for example bay.yaml; it goes into {folder.name or folder}.")
    path = folder.resolve() / name
    if path.is_symlink() or (path.exists() and not path.is_file()):
        raise InputError(f"{name} is a link or a folder. Choose another name.")
    return write(model, path)
