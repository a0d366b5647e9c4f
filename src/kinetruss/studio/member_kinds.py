"""What kind a member is, and a member of another kind in its place."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, ModelError
from kinetruss.io.emitting import plain_record
from kinetruss.model import Active, Bar, Model, nearest
from kinetruss.studio.drawing import State, model_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.studio.edits import Data


LEAN = ("runs", "trajectories", "poses", "gauges", "gauge_zero", "drives", "load_cases", "combinations")
"""Tables whose entries may be removed if their member no longer exists or is no longer driven."""

ROUNDS = 20
"""Largest number of rounds in which such entries are removed."""


def role_of(model: Model, name: str) -> str:
    """Rigid, driven, elastic, cable, free or cut."""
    member = model.members.get(name)
    if member is None:
        return "cut"
    return "driven" if isinstance(member, Active) else member.kind


def switched(state: State, original: State, position: NDArray[np.float64], name: str, to: str) -> tuple[Data, Data]:
    """The data with a member made rigid, driven, elastic, cut, or as in the file; and all entries that were removed for it.

    A member made rigid or driven keeps its present length; an elastic one has no force at that length. An active
    member made rigid or elastic becomes a uniform bar of its tube's section with the mass of both rods. Entries that were
    removed return when they are valid again.

    Raises
    ------
    InputError : no such member. ModelError : data missing in the model, e.g. E and A of an elastic bar.
    """
    first = original.model
    if first is None or name not in first.members:
        raise InputError(f"No member called {name!r}. {nearest(name, () if first is None else first.members)}")
    nodes = () if state.model is None else state.model.nodes
    places = dict(zip(nodes, position, strict=False))
    if to != "cut" and (gone := [end for end in first.members[name].ends if end not in places]):
        raise InputError(f"{name!r} ends at {gone[0]!r}, which is not in the model any more. Undo, or cut the member.")
    data = {table: rows for table, rows in state.data.items() if table not in ("bars", "active")}
    record = None if to == "cut" else _record(first, places, name, to)
    for table in ("bars", "active"):
        rows = {other: row for other, row in (state.data.get(table) or {}).items() if other != name}
        if record is not None and isinstance(record, Active) == (table == "active"):
            own = (original.data.get(table) or {}).get(name)
            rows[name] = own if record is first.members[name] and own is not None else plain_record(record)
        if rows:
            data[table] = _in_order(rows, first.members)
    return _lean(data, state, original)


def _record(original: Model, places: Mapping[str, NDArray[np.float64]], name: str, to: str) -> Bar | Active:
    own = original.members[name]
    if to == "own" or (isinstance(own, Active) and to == "driven"):
        return own
    a, b = (places[end] for end in own.ends)
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


def _lean(data: Data, state: State, original: State) -> tuple[Data, Data]:
    """The data with what was removed before, as far as it is valid; and what is removed now, by table."""
    data = dict(data)
    for table in LEAN:
        if rows := {**state.lost.get(table, {}), **_names(data, table)}:
            data[table] = _in_order(rows, _names(original.data, table))
    lost: Data = {}
    for _ in range(ROUNDS):
        try:
            model_of(data, state.folder)
        except ModelError as error:
            gone = {(str(fault.path[0]), str(fault.path[1])) for fault in error.faults if len(fault.path) > 1}
            gone = {(table, entry) for table, entry in gone if table in LEAN and entry in _names(data, table)}
            if not gone:
                raise
            for table, entry in sorted(gone):
                rows = dict(data[table])
                lost.setdefault(table, {})[entry] = rows.pop(entry)
                data = {**data, table: rows} if rows else {key: value for key, value in data.items() if key != table}
        else:
            return data, lost
    raise InputError("This change leaves nothing of the model.")


def _names(data: Data, table: str) -> dict[str, Any]:
    rows = data.get(table)
    return rows if isinstance(rows, dict) else {}


def _in_order(rows: Mapping[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """Entries in the order of some names; others follow."""
    rank = {name: k for k, name in enumerate(names)}
    return {name: rows[name] for name in sorted(rows, key=lambda name: rank.get(name, len(rank)))}
