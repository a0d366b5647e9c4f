"""A model into a file, and its text and plain data for programs that change one and show the other."""

from __future__ import annotations

import os
import re
from pathlib import Path, PureWindowsPath
from typing import Any

from kinetruss.errors import Fault, InputError, KinetrussError, ModelError
from kinetruss.io.earlier import without_inner_parts
from kinetruss.io.emitting import plain_model, to_json, to_yaml
from kinetruss.io.patching import patched
from kinetruss.io.reading import model_of
from kinetruss.io.yaml_text import MAX_SIZE, locate, parse_yaml, plain, refuse
from kinetruss.model import Model
from kinetruss.results.folder import whole_file

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


# The text of a model file and its plain data, for programs that change one and show the other.

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def data_of(text: str, folder: Path, max_size: int = MAX_SIZE, *, within: bool = False) -> tuple[dict[str, Any], list[Fault]]:
    """The plain data of a text, and faults that do not stop parsing; library models and tables in files are written out.

    Numbers without units are floats, unless the text is also the name of an entry. within : only files of the folder are read.

    Raises
    ------
    ModelError : the text is not YAML, or is no table; a library model or a file that cannot be used. Each with its line.
    """
    tree, faults = parse_yaml(text)
    if tree is None:
        return {}, faults
    if tree.table is None:
        raise refuse("is not a table of names.", "Start with kinetruss: 1, then nodes, bars, ...", tree.place)
    data: dict[str, Any] = without_inner_parts(plain(tree))
    if "library" in data or _uses_files(data):
        if within and (outside := _outside(data)):
            raise refuse(
                f"names {outside!r}, which is not in the folder.",
                "Put the file beside the model, and name it without its path.",
            )
        try:
            data = plain_model(model_of(data, faults, folder, max_size))
        except ModelError as error:
            raise ModelError([locate(fault, tree) for fault in error.faults]) from None
    names = {name for table in data.values() if isinstance(table, dict) for name in table}
    return {key: _numbers(value, names) for key, value in data.items()}, faults


def value_of(text: str, names: set[str]) -> Any:
    """The plain data of a value typed as YAML, e.g. ``[1, 20 mm]``. names : of entries, which are not read as numbers.

    Raises
    ------
    ModelError : it is not YAML.
    """
    tree, faults = parse_yaml(f"value: {text}")
    if faults or tree is None or tree.table is None or list(tree.table) != ["value"]:
        raise refuse(f"holds {text!r}, which is no value.", "Write a number, a text, [a, list] or {a: table}.", (1, 1))
    return _numbers(plain(tree)["value"], names)


def text_of(data: dict[str, Any] | Model) -> str:
    """YAML text of plain data or of a model."""
    return to_yaml(plain_model(data) if isinstance(data, Model) else data)


def changed_text(
    text: str, before: dict[str, Any] | Model, after: dict[str, Any] | Model, folder: Path, *, within: bool = False
) -> str | None:
    """The text of changed data: with its comments, its order and the entries that did not change as they are written.

    text : of `before`, both as plain data or both as models. folder, within : as of `data_of`. None if the result would not
    read as `after`, e.g. because of aliases or a model of the library.
    """
    plain_before, plain_after = (plain_model(one) if isinstance(one, Model) else one for one in (before, after))
    found = patched(text, plain_before, plain_after)
    if found is None:
        return None
    try:
        data, faults = data_of(found, folder, within=within)
        read = Model(**data) if isinstance(after, Model) else data
    except KinetrussError:
        return None
    return found if not faults and read == after else None


def head_of(text: str) -> str:
    """The comment at the head of a text."""
    found = re.match(r"(?:[ \t]*#[^\n]*\n|[ \t]*\n)*", text)
    return found[0] if found else ""


def located(text: str, faults: list[Fault]) -> list[Fault]:
    """Faults of the data of a text, with line and column, in the order of the text."""
    tree = parse_yaml(text)[0] if faults else None
    found = faults if tree is None else [locate(fault, tree) for fault in faults]
    return sorted(found, key=lambda fault: (fault.line or 0, fault.column or 0))


def _uses_files(data: dict[str, Any]) -> bool:
    entries = [entry for table in data.values() if isinstance(table, dict) for entry in table.values()]
    inner = [entry.get("trajectory") for entry in entries if isinstance(entry, dict)]
    return any(isinstance(entry, dict) and "file" in entry for entry in [*entries, *inner])


def _outside(value: Any) -> str:
    """A text in the data that is a path out of the folder, or nothing."""
    if isinstance(value, str):
        path = PureWindowsPath(value)  # knows both slashes
        return value if path.anchor or ".." in path.parts else ""
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return next((found for one in inner if (found := _outside(one))), "")


def _numbers(value: Any, names: set[str]) -> Any:
    """The value with numbers in place of texts that are numbers, except names."""
    if isinstance(value, dict):
        return {key: _numbers(item, names) for key, item in value.items()}
    if isinstance(value, list):
        return [_numbers(item, names) for item in value]
    if isinstance(value, str) and value not in names and NUMBER.fullmatch(value):
        number = float(value)
        return int(value) if number.is_integer() and value.isdecimal() and abs(number) < 1e15 else number
    return value
