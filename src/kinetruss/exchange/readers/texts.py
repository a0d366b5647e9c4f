"""Texts and tables of files, with the file named in every fault."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from kinetruss.errors import Fault, ModelError
from kinetruss.io.formats import Tree, parse, read_text

__all__ = ["text_of", "tree_of"]


def text_of(path: Path, max_size: int) -> str:
    """UTF-8 text of a file; ModelError if it cannot be read."""
    try:
        return read_text(path, max_size)
    except ModelError as error:
        raise ModelError([replace(fault, file=str(path)) for fault in error.faults]) from None


def tree_of(path: Path, max_size: int) -> Tree:
    """The values of a YAML or JSON file with their lines; ModelError if it is not one, or empty."""
    try:
        tree, faults = parse(path, text_of(path, max_size))
        if faults:
            raise ModelError(faults)
    except ModelError as error:
        raise ModelError([replace(fault, file=fault.file or str(path)) for fault in error.faults]) from None
    if tree is None:
        raise ModelError([Fault((), "is empty.", "Name another file.", 1, 1, file=str(path))])
    return tree
