"""Edits of the plain data of a model: each returns new data and leaves the given data unchanged."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.scalars import measures_of
from kinetruss.elements.spring import springs
from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.io.writing import value_of
from kinetruss.mechanics import compile
from kinetruss.mechanics.measures import measured
from kinetruss.model import Bar, Model, natural_length, nearest, of_file
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray

Data = dict[str, Any]

SOFT = ("elastic", "cable")

MEMBERS = ("bars", "active", "beams", "links")
"""Tables of members, which are drawn as lines."""

NAMED = (*MEMBERS, "cylinders", "drives", "couplings", "springs", "stops")
"""Tables of which no two entries have one name."""

SHORT = {"nodes": "at", "bars": "ends", "beams": "ends", "links": "nodes"}
"""Tables whose entries may be the list of one field alone."""

ROUNDS = 20
"""Largest number of rounds in which dependent entries are removed."""


def new_name(data: Data, table: str, prefix: str) -> str:
    """The first name prefix1, prefix2, ... that is free; nodes of a drawing are A to Z first."""
    tables = NAMED if table in NAMED else (table,)
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
    """The nodes of a member as written: two, or of a link more."""
    return list(entry["nodes" if "nodes" in entry else "ends"] if isinstance(entry, dict) else entry)


def joining(table: str, entry: Any, nodes: Sequence[str]) -> Any:
    """A member with other nodes."""
    return {**entry, "nodes" if table == "links" else "ends": list(nodes)} if isinstance(entry, dict) else list(nodes)


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
    """The data without clamps of nodes at which no beam ends, and no link is welded or hinged."""
    given = data.get("clamped")
    ends = {end for entry in (data.get("beams") or {}).values() for end in ends_of(entry)}
    links = (entry for entry in (data.get("links") or {}).values() if isinstance(entry, dict))
    ends |= {node for entry in links for key in ("weld", "hinges") for node in entry.get(key) or ()}
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


def at_pose(data: Data, model: Model, position: NDArray[np.float64]) -> Data:
    """The data with nodes at a pose (n_nodes, dim), m, of the model of the data, and what follows the drives.

    Given lengths of driven members are those there. What is drawn without force, or with a pretension, keeps its free length
    or angle as a number.
    """
    old = {name: np.array(node.at) for name, node in model.nodes.items()}
    new = {name: np.array(place) for name, place in zip(model.nodes, position, strict=False)}
    found = moved(data, {name: place.tolist() for name, place in new.items() if not np.array_equal(place, old[name])})
    for table in ("bars", "active"):
        rows = dict(found.get(table) or {})
        for name, entry in rows.items():
            member = model.members[name]
            a, b = member.ends
            if isinstance(entry, dict) and entry.get("length") is not None and name in model.all_drives:
                rows[name] = {**entry, "length": float(np.linalg.norm(new[b] - new[a]))}
            elif isinstance(member, Bar) and member.kind in SOFT and member.natural_length is None:
                own = natural_length(model, member, float(np.linalg.norm(old[b] - old[a])))
                kept = {key: value for key, value in entry_of(entry).items() if key != "pretension"}
                rows[name] = {**kept, "natural_length": own}
        if rows and rows != found.get(table):
            found = {**found, table: rows}
    return _with_rests(found, model, position)


def _with_rests(data: Data, model: Model, position: NDArray[np.float64]) -> Data:
    """The data with the rest of springs whose coordinate is another one at a pose, where it is that drawn."""
    if not any(one.rest is None for one in model.springs.values()):
        return data
    system, rows = compile(model), dict(data.get("springs") or {})
    x = np.zeros_like(system.x0)
    x[:, : system.dim] = position
    part = springs(system)
    for name, rest, m in zip(part.names, part.rest, measures_of(system, "spring"), strict=True):
        if name in rows and model.springs[name].rest is None and measured(system, m, x[None], along=False)[0, 0] != rest:
            rows[name] = {**rows[name], "rest": float(rest)}
    return {**data, "springs": rows} if rows else data


def with_load(data: Data, name: str, node: str, force: Sequence[float]) -> Data:
    """A constant force (N) on a node; zero removes it. Load cases that list their loads include it with factor 1."""
    cases = data.get("load_cases") or {}
    listing = {key: case for key, case in cases.items() if isinstance(case, dict) and case.get("loads") is not None}
    if not any(force):
        found = without(data, "loads", name)
        changed = {
            key: {**case, "loads": {k: v for k, v in case["loads"].items() if k != name}} for key, case in listing.items()
        }
    else:
        new = name not in (data.get("loads") or {})
        found = _put(data, "loads", name, {"node": node, "force": list(force)})
        changed = {key: {**case, "loads": {**case["loads"], name: 1.0}} for key, case in listing.items() if new}
    return {**found, "load_cases": {**cases, **changed}} if changed else found


def with_mass(data: Data, model: Model, node: str, mass: float) -> Data:
    """The lumped mass (kg) of a node of the model."""
    if node not in model.nodes:
        raise InputError(f"No node called {node!r}. {nearest(node, model.nodes)}")
    return with_value(data, ("nodes", node, "mass"), mass or None)


def with_value(data: Data, path: Sequence[str], value: Any) -> Data:
    """The data with the value at a path; None removes it. Empty tables are removed too."""
    if path[0] == "fixed":
        data = {**data, "fixed": supports(data)}
    found = _with(data, list(path), value, ())
    if path[0] == "bars" and len(path) > 2 and found.get("bars", {}).get(path[1]) is None:
        raise InputError(f"No bar called {path[1]!r}. {nearest(path[1], data.get('bars') or {})}")
    return found if isinstance(found, dict) else {}


def typed(data: Data, value: Any) -> Any:
    """A value of a form, in which each text is YAML."""
    if isinstance(value, dict):
        return {key: typed(data, one) for key, one in value.items()}
    if isinstance(value, list):
        return [typed(data, one) for one in value]
    names = {name for table in data.values() if isinstance(table, dict) for name in table}
    return value_of(value, names) if isinstance(value, str) else value


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


def supports(data: Data) -> dict[str, str]:
    """Supports as a table node -> axes."""
    given = data.get("fixed") or {}
    if isinstance(given, dict):
        return dict(given)
    nodes = data.get("nodes")
    axes = "xyz"[: len(place_of(data, next(iter(nodes)))) if nodes else 2]
    return dict.fromkeys(given, axes)


def deleted(data: Data, nodes: Iterable[str], members: Iterable[str]) -> tuple[Data, list[str]]:
    """The data without nodes and members, and without what depends on them; the names of those dependent entries."""
    gone, cut = set(nodes), set(members)
    found = dict(data)
    lost: list[str] = []
    for table in MEMBERS:
        entries = found.get(table) or {}
        left = {name: [end for end in ends_of(entry) if end not in gone] for name, entry in entries.items()}
        if table == "links":  # which goes on without a pin
            entries = {name: _shortened(entry, left[name], gone) for name, entry in entries.items()}
        cut |= {name for name, ends in left.items() if len(set(ends)) < 2}
        found[table] = {name: entry for name, entry in entries.items() if name not in cut}
    if found.get("fixed"):
        found["fixed"] = {name: axes for name, axes in supports(data).items() if name not in gone}
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


def _shortened(entry: Any, nodes: Sequence[str], gone: set[str]) -> Any:
    """A link without some of its pins."""
    found = joining("links", entry, nodes)
    if isinstance(found, dict):
        for key in ("weld", "hinges"):
            if given := found.get(key):
                found[key] = {one: given[one] for one in given if one not in gone} if isinstance(given, dict) else [
                    one for one in given if one not in gone]  # fmt: skip
    return found


def pinned(data: Data, member: str, node: str) -> tuple[Data, str]:
    """The data with a node that lies on a bar or link as a further pin of it; the bar becomes a link. And its name.

    Raises
    ------
    InputError : no such bar, link or node; a bar that is no rigid one.
    """
    _known(data, "nodes", node)
    table = next((one for one in ("bars", "links") if member in (data.get(one) or {})), None)
    if table is None:
        known = [*_keys(data.get("bars")), *_keys(data.get("links"))]
        raise InputError(f"No bar or link called {member!r}. {nearest(member, known)}")
    entry = data[table][member]
    nodes = ends_of(entry)
    if node in nodes:
        raise InputError(f"{node!r} is a pin of {member!r} already.")
    if isinstance(entry, dict) and table == "bars" and (odd := sorted(set(entry) - {"ends", "section", "material", "mass"})):
        raise InputError(f"{member!r} has {', '.join(odd)}, which a link has not. Remove what it has besides section and mass.")
    place = {name: [parse(value, "length") for value in place_of(data, name)] for name in (node, *nodes)}

    def detour(pair: tuple[str, str]) -> float:
        """How much longer the way over the node is."""
        a, b = (place[one] for one in pair)
        return math.dist(a, place[node]) + math.dist(place[node], b) - math.dist(a, b)

    at = min(range(len(nodes) - 1), key=lambda k: detour((nodes[k], nodes[k + 1])))
    nodes = [*nodes[: at + 1], node, *nodes[at + 1 :]]
    fields = {key: value for key, value in entry.items() if key not in ("ends", "nodes")} if isinstance(entry, dict) else {}
    link = {"nodes": nodes, **fields} if fields else nodes
    return _put(without(data, table, member), "links", member, link), member


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
        found[table] = {name: joining(table, entry, _swapped(ends_of(entry), old, new)) for name, entry in found[table].items()}
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
    tables = MEMBERS if table in MEMBERS else (*MEMBERS, "drives", "couplings", table) if table == "springs" else (table,)
    if not any(name in (data.get(one) or {}) for one in tables):
        known = [other for one in tables for other in data.get(one) or {}]
        raise InputError(f"No entry called {name!r} in {table}. {nearest(name, known)}")


def _refuse_taken(data: Data, table: str, name: str) -> None:
    if not re.fullmatch(r"[^\s/\\\x00-\x1f]{1,200}", name):
        raise InputError(f"{name!r} is no name. Write letters, digits, . _ -, without spaces.")
    tables = MEMBERS if table in MEMBERS else (*MEMBERS, "drives", "couplings", table) if table == "springs" else (table,)
    if any(name in (data.get(one) or {}) for one in tables):
        raise InputError(f"{name!r} is there already. Choose another name.")
