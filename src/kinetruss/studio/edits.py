"""Changes of a model: the kind of a member, gravity, a load, a payload; and saving it."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, ModelError
from kinetruss.io import write
from kinetruss.model import Active, Bar, LoadCase, Model, NodalForce, nearest
from kinetruss.results.folder import whole_file

if TYPE_CHECKING:
    from numpy.typing import NDArray


LEAN = ("runs", "trajectories", "poses", "gauges", "gauge_zero", "drives", "load_cases")
"""Tables whose entries may be removed if their member no longer exists or is no longer driven."""


def role_of(model: Model, name: str) -> str:
    """Rigid, driven, elastic, cable, free or cut."""
    member = model.members.get(name)
    if member is None:
        return "cut"
    return "driven" if isinstance(member, Active) else member.kind


def switched(model: Model, original: Model, position: NDArray[np.float64], name: str, to: str) -> tuple[Model, list[str]]:
    """The model with a member made rigid, driven, elastic, cut, or as in the file; and the names of removed entries.

    A member made rigid or driven keeps its present length; an elastic one has no force at that length. An active
    member made rigid or elastic becomes a uniform bar of its tube's section with the mass of both rods.

    Raises
    ------
    InputError : no such member. ModelError : data missing in the model, e.g. E and A of an elastic bar.
    """
    if name not in original.members:
        raise InputError(f"No member called {name!r}. {nearest(name, original.members)}")
    present = {**model.bars, **model.active}
    record = None if to == "cut" else _record(original, position, name, to)
    tables: dict[str, dict[str, Any]] = {"bars": {}, "active": {}}
    for other in original.members:
        one = record if other == name else present.get(other)
        if one is not None:
            tables["active" if isinstance(one, Active) else "bars"][other] = one
    return _lean(model, original, tables)


def _record(original: Model, position: NDArray[np.float64], name: str, to: str) -> Bar | Active:
    own = original.members[name]
    if to == "own" or (isinstance(own, Active) and to == "driven"):
        return own
    nodes = list(original.nodes)
    a, b = (position[nodes.index(end)] for end in own.ends)
    length = float(np.linalg.norm(b - a))
    if isinstance(own, Active):
        own = _uniform(original, own)
    kept = {field: getattr(own, field) for field in own.model_fields_set}
    for field in ("kind", "length", "natural_length", "pretension", "strain", "body"):
        kept.pop(field, None)
    if to != "elastic":
        kept.pop("stiffness", None)
        kept.pop("damping", None)
    return Bar(**kept | {"kind": to} | {"natural_length" if to == "elastic" else "length": length})


def _uniform(model: Model, own: Active) -> Bar:
    masses = [part.mass for part in (own.base, own.tube)]
    for k, part in enumerate((own.base, own.tube)):
        section, material = model.section_of(part), model.material_of(part)
        if masses[k] is None and section is not None and material is not None:
            masses[k] = section.area * material.density * part.length
    fields: dict[str, Any] = {"ends": own.ends, "mass": sum(mass or 0.0 for mass in masses), "buckling": own.buckling}
    for field in ("section", "material"):
        if (value := getattr(own.tube, field)) is not None:
            fields[field] = value
    if own.orientation is not None:
        fields["orientation"] = own.orientation
    return Bar(**fields)


def _lean(model: Model, original: Model, changes: Mapping[str, Any]) -> tuple[Model, list[str]]:
    """The model with changes. Entries of other tables that depend on removed members return when they are valid again."""
    tables = {name: dict(getattr(original, name)) for name in LEAN if isinstance(getattr(original, name), dict)}
    if "load_cases" in tables:
        tables["load_cases"] = dict(model.load_cases)
    lost: list[str] = []
    for _ in range(20):
        try:
            return model.with_(**changes, **tables), lost
        except ModelError as error:
            gone = {(str(f.path[0]), str(f.path[1])) for f in error.faults if len(f.path) > 1 and f.path[0] in tables}
            gone = {(table, entry) for table, entry in gone if entry in tables[table]}
            if not gone:
                raise
            for table, entry in sorted(gone):
                del tables[table][entry]
                lost.append(f"{table}.{entry}")
    raise InputError("This change leaves nothing of the model.")


def with_gravity(model: Model, value: list[float]) -> Model:
    """Gravity, m/s^2, of the model; load cases with their own keep it."""
    return model.with_(gravity=tuple(value))


def with_load(model: Model, name: str, node: str, force: list[float]) -> Model:
    """A constant force (N) on a node; zero removes it. Load cases that list their loads include it with factor 1."""
    rest = {key: load for key, load in model.loads.items() if key != name}
    if not any(force):
        cases = {key: _without(case, name) for key, case in model.load_cases.items()}
        return model.with_(loads=rest, load_cases=cases)
    new = name not in model.loads
    loads = {**model.loads, name: NodalForce(node=node, force=tuple(force))}
    cases = {key: _with(case, name) if new else case for key, case in model.load_cases.items()}
    return model.with_(loads=loads, load_cases=cases)


def _with(case: LoadCase, name: str) -> LoadCase:
    return case if case.loads is None else case.model_copy(update={"loads": {**case.loads, name: 1.0}})


def _without(case: LoadCase, name: str) -> LoadCase:
    if case.loads is None:
        return case
    return case.model_copy(update={"loads": {key: factor for key, factor in case.loads.items() if key != name}})


def with_mass(model: Model, node: str, mass: float) -> Model:
    """The lumped mass (kg) of a node."""
    if node not in model.nodes:
        raise InputError(f"No node called {node!r}. {nearest(node, model.nodes)}")
    return model.with_(nodes={**model.nodes, node: model.nodes[node].model_copy(update={"mass": mass})})


def posed(model: Model, position: NDArray[np.float64], values: Mapping[str, float]) -> Model:
    """The model in another pose: with its node positions, and driven members with their lengths there."""
    nodes = {
        name: node.model_copy(update={"at": tuple(map(float, position[k]))})
        for k, (name, node) in enumerate(model.nodes.items())
    }
    # a rigid bar without a given length has that of its node positions; keep it to the last bit
    lengths = {name: math.dist(*(model.nodes[end].at for end in bar.ends)) for name, bar in model.bars.items()}
    bars = {
        name: bar.model_copy(update={"length": lengths[name]})
        if bar.kind == "rigid" and bar.length is None
        else bar.model_copy(update={"length": values.get(name)})
        if bar.kind == "driven" and name in values
        else bar.model_copy(update={"natural_length": lengths[name]})
        if bar.kind in ("elastic", "cable") and bar.natural_length is None and bar.pretension is None
        else bar
        for name, bar in model.bars.items()
    }
    active = {
        name: member.model_copy(update={"length": values[name]}) if name in values else member
        for name, member in model.active.items()
    }
    return model.with_(nodes=nodes, bars=bars, active=active)


# Saves a model in the chosen folder only; replaces another file only after confirmation.

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
