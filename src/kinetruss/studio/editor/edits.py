"""Edits of the plain data of a model: each returns new data and leaves the given data unchanged."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.model import Model, nearest, of_file

__all__ = [
    "MEMBERS", "added_bar", "added_entry", "added_node", "clamped_where_beams_are", "deleted", "ends_of", "entry_of", "moved",
    "new_name", "place_of", "renamed", "with_value", "without",
]  # fmt: skip

Data = dict[str, Any]

MEMBERS = ("bars", "active", "beams")
"""Tables of members, which are drawn as lines."""

SHORT = {"nodes": "at", "bars": "ends", "beams": "ends"}
"""Tables whose entries may be the list of one field alone."""

ROUNDS = 20
"""Largest number of rounds in which dependent entries are removed."""


def new_name(data: Data, table: str, prefix: str) -> str:
    """The first name prefix1, prefix2, ... that is free; nodes of a drawing are A to Z first."""
    tables = MEMBERS if table in MEMBERS else (table,)
    used = {name for one in tables for name in data.get(one) or {}}
    if not prefix:
        letters = [chr(code) for code in range(ord("A"), ord("Z") + 1)]
        free = [name for name in letters if name not in used]
        if free:
            return free[0]
        prefix = "N"
    number = 1
    while f"{prefix}{number}" in used:
        number += 1
    return f"{prefix}{number}"


def place_of(data: Data, node: str) -> list[Any]:
    """The place of a node as written."""
    entry = data["nodes"][node]
    return list(entry["at"] if isinstance(entry, dict) else entry)


def ends_of(entry: Any) -> list[str]:
    """The two nodes of a member as written."""
    return list(entry["ends"] if isinstance(entry, dict) else entry)


def entry_of(entry: Any) -> dict[str, Any]:
    """A member as a table of fields."""
    return dict(entry) if isinstance(entry, dict) else {"ends": list(entry)}


def added_entry(data: Data, table: str, stem: str, entry: Any) -> tuple[Data, str, str]:
    """The data with one more entry of a table, the table and the name."""
    name = new_name(data, table, stem)
    return _put(data, table, name, entry), table, name


def without(data: Data, table: str, name: str) -> Data:
    """The data without an entry; an empty table is left out."""
    rest = {other: entry for other, entry in (data.get(table) or {}).items() if other != name}
    return {**data, table: rest} if rest else {key: value for key, value in data.items() if key != table}


def clamped_where_beams_are(data: Data) -> Data:
    """The data without clamps of nodes at which no beam ends."""
    given = data.get("clamped")
    ends = {end for entry in (data.get("beams") or {}).values() for end in ends_of(entry)}
    kept: Any = {node: body for node, body in given.items() if node in ends} if isinstance(given, dict) else [
        node for node in given or () if node in ends]  # fmt: skip
    rest = {key: value for key, value in data.items() if key != "clamped"}
    return data if kept == given else {**rest, "clamped": kept} if kept else rest


def added_node(data: Data, name: str | None, at: Sequence[Any]) -> tuple[Data, str]:
    """The data with one more node, and its name."""
    name = name or new_name(data, "nodes", "")
    _refuse_taken(data, "nodes", name)
    return _put(data, "nodes", name, list(at)), name


def added_bar(data: Data, name: str | None, ends: Sequence[str]) -> tuple[Data, str]:
    """The data with one more bar, and its name."""
    for end in ends:
        _known(data, "nodes", end)
    if ends[0] == ends[1]:
        raise InputError(f"A bar needs two different nodes; both ends are {ends[0]!r}.")
    for table in MEMBERS:
        for other, entry in (data.get(table) or {}).items():
            if set(ends_of(entry)) == set(ends):
                raise InputError(f"{other!r} joins {ends[0]!r} and {ends[1]!r} already.")
    name = name or new_name(data, "bars", "b")
    _refuse_taken(data, "bars", name)
    return _put(data, "bars", name, list(ends)), name


def moved(data: Data, places: Mapping[str, Sequence[Any]]) -> Data:
    """The data with nodes at other places, m or text with units."""
    nodes = dict(data.get("nodes") or {})
    for name, place in places.items():
        _known(data, "nodes", name)
        entry = nodes[name]
        nodes[name] = {**entry, "at": list(place)} if isinstance(entry, dict) else list(place)
    return {**data, "nodes": nodes}


def with_value(data: Data, path: Sequence[str], value: Any) -> Data:
    """The data with the value at a path; None removes it. Empty tables are removed too."""
    if path[0] == "fixed":
        data = {**data, "fixed": _fixed(data)}
    found = _with(data, list(path), value, ())
    if path[0] == "bars" and len(path) > 2 and found.get("bars", {}).get(path[1]) is None:
        raise InputError(f"No bar called {path[1]!r}. {nearest(path[1], data.get('bars') or {})}")
    return found if isinstance(found, dict) else {}


def _with(here: Any, path: list[str], value: Any, before: tuple[str, ...]) -> Any:
    if not path:
        return value
    key, rest = path[0], path[1:]
    if len(before) == 2 and before[0] in SHORT and isinstance(here, list):
        here = {SHORT[before[0]]: here}
    if here is None:
        here = {}
    if isinstance(here, list):
        if not key.isdecimal() or int(key) >= len(here):
            raise InputError(f"{'.'.join(before)} is a list of {len(here)}; {key!r} is not in it.")
        return [_with(item, rest, value, (*before, key)) if k == int(key) else item for k, item in enumerate(here)]
    if not isinstance(here, dict):
        raise InputError(f"{'.'.join(before)} is a value; it has no {key!r}.")
    inner = _with(here.get(key), rest, value, (*before, key))
    found = {**here, key: inner} if inner is not None else {name: one for name, one in here.items() if name != key}
    if len(before) == 2 and before[0] in SHORT and list(found) == [SHORT[before[0]]]:
        return found[SHORT[before[0]]]
    return found if found or len(before) != 1 else None


def _fixed(data: Data) -> dict[str, str]:
    """Supports as a table node -> axes."""
    given = data.get("fixed") or {}
    if isinstance(given, dict):
        return dict(given)
    axes = "xyz"[: len(place_of(data, next(iter(data["nodes"]))))]
    return dict.fromkeys(given, axes)


def deleted(data: Data, nodes: Iterable[str], members: Iterable[str]) -> tuple[Data, list[str]]:
    """The data without nodes and members, and without what depends on them; the names of those dependent entries."""
    gone, cut = set(nodes), set(members)
    found = dict(data)
    lost: list[str] = []
    for table in MEMBERS:
        entries = found.get(table) or {}
        cut |= {name for name, entry in entries.items() if gone & set(ends_of(entry))}
        found[table] = {name: entry for name, entry in entries.items() if name not in cut}
    if found.get("fixed"):
        found["fixed"] = {name: axes for name, axes in _fixed(data).items() if name not in gone}
    found["nodes"] = {name: entry for name, entry in (data.get("nodes") or {}).items() if name not in gone}
    found = {key: value for key, value in found.items() if value not in ({}, []) or key == "nodes"}
    found = clamped_where_beams_are(found)
    known = {_place(fault) for fault in _faults(data)}
    for _ in range(ROUNDS):
        new = [fault for fault in _faults(found) if _place(fault) not in known]
        entries = {(str(f.path[0]), str(f.path[1])) for f in new if len(f.path) > 1}
        entries = {(t, e) for t, e in entries if t not in ("nodes", *MEMBERS) and e in _keys(found.get(t))}
        if not entries:
            break
        for table, entry in sorted(entries):
            found = with_value(found, (table, entry), None)
            lost.append(f"{table}.{entry}")
    return found, lost


def renamed(data: Data, table: str, old: str, new: str) -> Data:
    """The data with an entry of a table renamed, and all that refers to it.

    Raises
    ------
    InputError : no such entry, a name that is taken or not allowed.
    """
    entries = data.get(table) or {}
    _known(data, table, old)
    if new == old:
        return data
    _refuse_taken(data, table, new)
    before = {_place(fault) for fault in _faults(data)}
    found = {**data, table: {new if name == old else name: entry for name, entry in entries.items()}}
    if table == "nodes":
        found = _with_node_renamed(found, old, new)
    for _ in range(ROUNDS):
        faults = [fault for fault in _faults(found) if _place(fault) not in before]
        changes = [fault for fault in faults if _refers(found, fault, old)]
        if faults and not changes:
            raise InputError(f"{old!r} cannot be called {new!r}: {faults[0]}")
        if not changes:
            break
        for fault in changes:
            found = _replaced(found, [str(part) for part in fault.path], old, new)
    return found


def _with_node_renamed(data: Data, old: str, new: str) -> Data:
    """Members and supports of a renamed node."""
    found = dict(data)
    for table in MEMBERS:
        if table not in found:
            continue
        found[table] = {
            name: {**entry, "ends": _swapped(entry["ends"], old, new)} if isinstance(entry, dict) else _swapped(entry, old, new)
            for name, entry in found[table].items()
        }
    fixed = found.get("fixed")
    if isinstance(fixed, dict):
        found["fixed"] = {new if name == old else name: axes for name, axes in fixed.items()}
    elif fixed:
        found["fixed"] = _swapped(fixed, old, new)
    return found


def _swapped(names: Sequence[str], old: str, new: str) -> list[str]:
    return [new if name == old else name for name in names]


def _refers(data: Data, fault: Fault, old: str) -> bool:
    here: Any = data
    for part in fault.path:
        if isinstance(here, dict) and str(part) in here:
            here = here[str(part)]
        elif isinstance(here, list) and isinstance(part, int) and part < len(here):
            here = here[part]
        else:
            return False
    return here == old or (bool(fault.path) and str(fault.path[-1]) == old)


def _replaced(here: Any, path: list[str], old: str, new: str) -> Any:
    """The data with the name at a path replaced: the value there, or the key itself."""
    if not path:
        return new if here == old else here
    key, rest = path[0], path[1:]
    if isinstance(here, list):
        return [_replaced(item, rest, old, new) if k == int(key) else item for k, item in enumerate(here)]
    if not rest and key == old and here.get(key) != old:
        return {new if name == old else name: value for name, value in here.items()}
    return {name: _replaced(value, rest, old, new) if name == key else value for name, value in here.items()}


def _faults(data: Data) -> list[Fault]:
    try:
        with of_file():
            Model(**data)
    except ModelError as error:
        return error.faults
    return []


def _place(fault: Fault) -> tuple[Any, ...]:
    return (*fault.path, fault.message)


def _keys(table: Any) -> set[str]:
    return set(table) if isinstance(table, dict) else set()


def _put(data: Data, table: str, name: str, entry: Any) -> Data:
    return {**data, table: {**(data.get(table) or {}), name: entry}}


def _known(data: Data, table: str, name: str) -> None:
    tables = MEMBERS if table in MEMBERS else (table,)
    if not any(name in (data.get(one) or {}) for one in tables):
        known = [other for one in tables for other in data.get(one) or {}]
        raise InputError(f"No entry called {name!r} in {table}. {nearest(name, known)}")


def _refuse_taken(data: Data, table: str, name: str) -> None:
    if not re.fullmatch(r"[^\s/\\\x00-\x1f]{1,200}", name):
        raise InputError(f"{name!r} is no name. Write letters, digits, . _ -, without spaces.")
    tables = MEMBERS if table in MEMBERS else (table,)
    if any(name in (data.get(one) or {}) for one in tables):
        raise InputError(f"{name!r} is there already. Choose another name.")
