"""A model into a file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.io.formats.emit import to_json, to_yaml
from kinetruss.io.formats.plain import plain_model
from kinetruss.model import Model
from kinetruss.results.store import whole_file

__all__ = ["write"]

_TEXT = {".yaml": to_yaml, ".yml": to_yaml, ".json": to_json}


def write(model: Model, path: str | Path) -> Path:
    """Write a model as YAML or JSON; `read` gives the same model back, every number to the last bit.

    The file appears completely or not at all: a temporary file in the same folder replaces it at the end.

    Parameters
    ----------
    model : the model; default values are omitted, tables from CSV files are written out.
    path : file to write; its suffix ``.yaml``, ``.yml`` or ``.json`` chooses the form. An existing file is replaced.

    Returns
    -------
    The path.

    Raises
    ------
    InputError : another suffix. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> model = kt.library.vgt.triangular()
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = kt.write(model, Path(folder, "truss.yaml"))
    ...     kt.read(file) == model
    True
    """
    path = Path(path)
    if path.suffix.lower() not in _TEXT:
        raise InputError(f"{path} has the suffix {path.suffix!r}. Name a file that ends in {', '.join(_TEXT)}.")
    text = _TEXT[path.suffix.lower()](_relative(plain_model(model), path.parent))
    with whole_file(path) as draft, draft.open("w", encoding="utf-8", newline="\n") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    return path


def _relative(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Relative paths of motion files: relative to the working folder in a model, to the model file in a file."""
    for run in data.get("runs", {}).values():
        if "motion" in run and not Path(run["motion"]).is_absolute():
            run["motion"] = os.path.relpath(run["motion"], folder)
    return data
