"""Copies of parts of a drawing: shifted, mirrored, and stacks of cells; each returns new data of the model."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from kinetruss.errors import InputError
from kinetruss.io.emitting import plain_model
from kinetruss.library import cells
from kinetruss.model import nearest
from kinetruss.studio.edits import MEMBERS, Data, ends_of, joining, moved, new_name, place_of
from kinetruss.units import parse

NEAR = 1e-9
"""Distance below which two nodes are the same, as a fraction of the size of the drawing."""

CELLS = ("triangle", "panel", "tetrahedron", "octahedron", "decahedron", "prism", "cube", "double_octahedron",
         "quadruple_octahedron")  # fmt: skip
"""Cells that are offered."""

TABLES = ("sections", "materials", "screws", "gears", "motors", "amplifiers")
"""Tables that cells may need."""


def copied(data: Data, nodes: Sequence[str], by: Sequence[Any], count: int) -> Data:
    """`count` copies, each shifted by a vector (m or text with units) from the last; nodes that meet are shared."""
    step = [parse(value, "length") for value in by]
    for k in range(1, count + 1):
        data = _imaged(data, nodes, partial(_shifted, [k * value for value in step]))
    return data


def _shifted(by: list[float], place: list[float]) -> list[float]:
    if len(by) != len(place):
        raise InputError(f"Give {len(place)} components of the shift, not {len(by)}.")
    return [a + b for a, b in zip(place, by, strict=True)]


def mirrored(data: Data, nodes: Sequence[str], axis: str, at: Any) -> Data:
    """The image in the plane axis = at (m or text with units); nodes in the plane are shared."""
    k, where = "xyz".index(axis), parse(at, "length")
    if data.get("nodes") and k >= len(place_of(data, next(iter(data["nodes"])))):
        raise InputError("A planar drawing is mirrored along x or y.")
    return _imaged(data, nodes, lambda place: [2 * where - value if i == k else value for i, value in enumerate(place)])


def _imaged(data: Data, nodes: Sequence[str], image: Callable[[list[float]], list[float]]) -> Data:
    """The data with an image of nodes and of the members among them."""
    missing = [name for name in nodes if name not in (data.get("nodes") or {})]
    if missing or not nodes:
        raise InputError(f"No node called {missing[0]!r}." if missing else "Pick the nodes to copy first.")
    places = {name: [parse(value, "length") for value in place_of(data, name)] for name in data["nodes"]}
    size = max((max(abs(value) for value in place) for place in places.values()), default=1.0) or 1.0
    found = {**data, "nodes": dict(data["nodes"])}
    twin: dict[str, str] = {}
    for name in nodes:
        there = image(places[name])
        met = [other for other, place in places.items() if max(map(abs, _apart(place, there))) <= NEAR * size]
        if met:
            twin[name] = met[0]
            continue
        twin[name] = name_like(found, "nodes", name)
        entry = data["nodes"][name]
        found["nodes"][twin[name]] = {**entry, "at": there} if isinstance(entry, dict) else there
    return _with_members(found, twin)


def _with_members(data: Data, twin: Mapping[str, str]) -> Data:
    joined = {frozenset(ends_of(entry)) for table in MEMBERS for entry in (data.get(table) or {}).values()}
    found = dict(data)
    for table in MEMBERS:
        for name, entry in (data.get(table) or {}).items():
            ends = ends_of(entry)
            if not all(end in twin for end in ends):
                continue
            there = [twin[end] for end in ends]
            if frozenset(there) in joined or there[0] == there[1]:
                continue
            joined.add(frozenset(there))
            found[table] = {**found[table], name_like(found, table, name): joining(table, entry, there)}
    fixed = data.get("fixed")
    if isinstance(fixed, dict):
        found["fixed"] = {**fixed, **{twin[name]: axes for name, axes in fixed.items() if name in twin}}
    elif fixed:
        found["fixed"] = [*fixed, *(twin[name] for name in fixed if name in twin and twin[name] not in fixed)]
    return found


def stacked(data: Data, cell: str, count: int, arguments: Mapping[str, Any]) -> Data:
    """The drawing with a stack of cells of the library beside it; it keeps its own supports, if it has any."""
    if cell not in CELLS:
        raise InputError(f"No cell called {cell!r}. {nearest(cell, CELLS)}")
    used = [*(data.get("nodes") or {}), *(name for table in MEMBERS for name in data.get(table) or {})]
    prefix = "B"
    while any(name.startswith(f"{prefix}1.") for name in used):
        prefix = chr(ord(prefix) + 1) if prefix < "Y" else f"{prefix}Z"
    more = plain_model(cells.stack([{"kind": cell, **arguments, "count": count}], names=prefix))
    places = {name: [parse(value, "length") for value in place_of(more, name)] for name in more["nodes"]}
    if used:
        drawn = [[parse(value, "length") for value in place_of(data, name)] for name in data["nodes"]]
        if len(drawn[0]) != len(next(iter(places.values()))):
            raise InputError("A planar drawing takes planar cells (triangle, panel), a spatial one the others.")
        right, left = max(place[0] for place in drawn), min(place[0] for place in places.values())
        width = max(place[0] for place in places.values()) - left
        places = {name: [place[0] + right - left + 0.5 * width, *place[1:]] for name, place in places.items()}
    if count == 1:  # the library gives a single cell no prefix
        more = _prefixed(more, f"{prefix}1.")
        places = {f"{prefix}1.{name}": place for name, place in places.items()}
    found = dict(data)
    for table in TABLES:
        if more.get(table):
            found[table] = {**more[table], **(found.get(table) or {})}
    for table in ("nodes", *MEMBERS):
        if more.get(table):
            found[table] = {**(found.get(table) or {}), **more[table]}
    for key in ("fixed", "gravity", "section", "material"):
        if key in more and not found.get(key):
            found[key] = more[key]
    return moved(found, places) if used else found


def _prefixed(more: Data, prefix: str) -> Data:
    """The data with a prefix before the names of nodes and members."""
    found = {**more, "nodes": {prefix + name: entry for name, entry in more["nodes"].items()}}
    for table in MEMBERS:
        found[table] = {}
        for name, entry in (more.get(table) or {}).items():
            record = joining(table, entry, [prefix + end for end in ends_of(entry)])
            if isinstance(record, dict) and isinstance(record.get("orientation"), str):
                record["orientation"] = prefix + record["orientation"]
            found[table][prefix + name] = record
    if "fixed" in more:
        fixed = more["fixed"]
        found["fixed"] = {prefix + name: axes for name, axes in fixed.items()} if isinstance(fixed, dict) else [
            prefix + name for name in fixed]  # fmt: skip
    return found


def name_like(data: Data, table: str, name: str) -> str:
    """A free name that begins as another one does."""
    stem = name.rstrip("0123456789") or name
    return new_name(data, table, stem if stem != name or table in MEMBERS else f"{name}_")


def _apart(a: Sequence[float], b: Sequence[float]) -> list[float]:
    return [x - y for x, y in zip(a, b, strict=True)]
