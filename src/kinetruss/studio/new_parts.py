"""Parts made from what is picked, and the forms of all records of a model file."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from functools import cache
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, ModelError
from kinetruss.io import schema
from kinetruss.model import Model
from kinetruss.studio.edits import (
    MEMBERS,
    Data,
    added_entry,
    clamped_where_beams_are,
    ends_of,
    entry_of,
    place_of,
    without,
)
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray


Spec = dict[str, Any]

SHORT = {"nodes": "Node", "bars": "Bar", "beams": "Beam", "links": "Link"}
"""Tables whose entries may be plain lists -> their record."""


@cache
def forms() -> dict[str, Any]:
    """What the page needs to show any entry.

    tables : name -> about, spec of an entry. records : name -> about, kind, fields: name -> spec, with ``needed``.
    A spec has a ``type``: value (unit), choice (of, free: other texts too), flag, text, list (of, count), table (of, keys),
    record (of: names of records), any (YAML text). names : tables whose entries, also those of the library, the text or the
    keys may name; also : other words for them.
    """
    made = schema()
    tables = {}
    for name, one in made["else"]["properties"].items():
        entry = one.get("additionalProperties")
        if isinstance(entry, dict):
            spec = {"type": "record", "of": [SHORT[name]]} if name in SHORT else _spec(entry)
            tables[name] = {"about": one.get("description", ""), **spec}
    return {"tables": tables, "records": {name: _record(one) for name, one in made["$defs"].items()}}


def _record(one: dict[str, Any]) -> dict[str, Any]:
    one = next(part for part in (one, *one.get("anyOf", ())) if "properties" in part)
    needed = set(one.get("required", ()))
    fields = {name: _spec(part) | {"needed": name in needed} for name, part in one["properties"].items()}
    kind = one["properties"].get("kind", {}).get("const")
    if kind is not None:
        del fields["kind"]
    return {"about": one.get("description", ""), "kind": kind, "fields": fields}


def _spec(part: dict[str, Any]) -> Spec:
    """The form of one field."""
    extra = {"default": part["default"]} if part.get("default") not in (None, [], {}) else {}
    ways = _ways(part)
    extra |= next((_named(way) for way in ways if "x-names" in way), {})
    records = [way["$ref"].rpartition("/")[2] for way in ways if "$ref" in way]
    chosen = next((way["enum"] for way in ways if "enum" in way), None)
    if records:
        return {"type": "record", "of": records} | extra
    if chosen is not None:
        if any(one is True for one in chosen):
            return {"type": "flag"} | extra
        return {"type": "choice", "of": chosen, "free": len(ways) > 1} | extra
    if len(ways) != 1:
        return {"type": "any"} | extra
    return _plain(ways[0]) | extra


def _plain(way: dict[str, Any]) -> Spec:
    if "x-unit" in way and way.get("type") != "array":
        said = re.search(r"a number in (.*?),? or text", way.get("description", ""))
        return {"type": "value", "unit": said[1] if said else way["x-unit"]}
    if way.get("type") == "array":
        items = way.get("prefixItems")
        return {"type": "list", "of": _spec(items[0] if items else way.get("items", {})), "count": len(items or ()) or None}
    if way.get("type") == "object" and isinstance(way.get("additionalProperties"), dict):
        return {"type": "table", "of": _spec(way["additionalProperties"]), "keys": _named(way.get("propertyNames", {}))}
    return {"type": "text" if way.get("type") == "string" else "any"}


def _named(way: dict[str, Any]) -> Spec:
    """What a name may refer to."""
    return {key: way[f"x-{key}"] for key in ("names", "also") if f"x-{key}" in way}


def _ways(part: dict[str, Any]) -> list[dict[str, Any]]:
    """The forms that a value may have, without 'not given'."""
    if "x-unit" in part:
        return [part]
    if "anyOf" in part or "oneOf" in part:
        return [way for one in part.get("anyOf") or part["oneOf"] for way in _ways(one)]
    return [] if part.get("type") == "null" else [part]


# Parts made from what is picked: active members, beams, bodies, springs of angles, runs; each a whole entry to be changed.

MATERIAL = "aluminium_6082_t6"
OUTER, INNER = (0.04, 0.032), (0.03, 0.024)
"""Outer and inner diameter of base and tube of a new active member, as fractions of its length."""

FLAT = 0.1
"""Thickness of a body over its size below which it counts as flat; its square for areas and volumes."""

MOST_TRIED = 16
"""Largest number of nodes of a body among which its carriers are looked for."""

MOVING = ("dynamics.inverse", "kinematics.follow", "statics.at_poses", "statics.deflection")
"""Analyses whose motion a mission can take."""

SHARED = ("ends", "section", "material", "mass")
"""Fields that bars and beams both have."""


def made(
    data: Data, what: str, nodes: Sequence[str], members: Sequence[str], drives: Mapping[str, Any], axis: str = "z"
) -> tuple[Data, str, str]:
    """The data with a new entry, the table of it and its name.

    what : active, beam, link, bar (of the picked member, in its place), angle_spring (between the picked members, or of one
    to the ground), body (of the picked nodes), run (of all drives). drives : name -> present value and unit, m or rad.
    axis : in space, about which the angle of one member counts.

    Raises
    ------
    InputError : something else must be picked.
    """
    if what in ("active", "beam", "bar", "link"):
        return _member(data, what, members)
    if what == "angle_spring":
        entry = {"coordinate": _angle(data, nodes, members, axis), "stiffness": "10 N m/rad"}
        return added_entry(data, "springs", "spring", entry)
    if what == "body":
        ends = [end for name in members for end in ends_of(_found(data, name)[1])]
        carried = list(dict.fromkeys([*nodes, *ends]))
        if len(carried) < 2:
            raise InputError("Pick the nodes of the body first, two or more: Shift-click them, or Shift-drag a box.")
        found, table, name = added_entry(data, "bodies", "body", {"nodes": carried, "mass": "1 kg"})
        return (_in_space(found, name, carried) if len(carried) > 3 else found), table, name
    return added_entry(data, "runs", "run", new_run(drives))


def with_analysis(data: Data, name: str, analysis: str) -> Data:
    """The data with another analysis of a run: without the fields that it does not use, and with those that it needs.

    Raises
    ------
    InputError : a mission without other runs or trajectories.
    """
    entry = (data.get("runs") or {}).get(name) or {}
    needed = _needed(data, name, analysis)
    found = data
    for kept in (tuple(entry), ("trajectory", "samples"), ("samples", "load_cases", "condition"), ()):
        run = {**needed, **{key: entry[key] for key in entry if key in kept}, "analysis": analysis}
        found = {**data, "runs": {**(data.get("runs") or {}), name: run}}
        try:
            Model(**found)
        except ModelError as error:
            if any(fault.path[:2] == ("runs", name) for fault in error.faults):
                continue
        break
    return found


def _needed(data: Data, name: str, analysis: str) -> dict[str, Any]:
    """Fields without which a run of this analysis is refused."""
    runs = data.get("runs") or {}
    if analysis == "dynamics.simulate":
        given = (runs.get(name) or {}).get("trajectory")
        return {"t_end": (given.get("duration") if isinstance(given, Mapping) else None) or "2 s"}
    if analysis == "flexible.corrected":
        fixed = data.get("fixed") or {}
        moving = [node for node in data["nodes"] if node not in fixed] or list(data["nodes"])
        return {"elastic": {"at": [f"{moving[-1]}.x"]}}
    if analysis == "mission":
        moving = [other for other, one in runs.items() if other != name and _prescribed(one)] or list(
            data.get("trajectories") or {}
        )
        if not moving:
            raise InputError("A mission does the motions of other runs. Make a run that moves the drives first: New run.")
        return {"motions": moving}
    return {}


def _prescribed(run: Mapping[str, Any]) -> bool:
    """Whether a mission can take the motion of a run."""
    return run.get("analysis", MOVING[0]) in MOVING and "condition" not in run


def _found(data: Data, name: str) -> tuple[str, Any]:
    for table in MEMBERS:
        if name in (data.get(table) or {}):
            return table, data[table][name]
    raise InputError(f"No member called {name!r}.")


def _member(data: Data, what: str, members: Sequence[str]) -> tuple[Data, str, str]:
    """The member in another table, with what both records have."""
    if len(members) != 1:
        raise InputError("Pick one member.")
    name = members[0]
    table, given = _found(data, name)
    to = {"bar": "bars", "beam": "beams", "active": "active", "link": "links"}[what]
    if to == table:
        return data, table, name
    nodes, record = ends_of(given), entry_of(given)
    if len(nodes) > 2:
        raise InputError(f"{name!r} is a link through {', '.join(nodes)}; a {what} joins two nodes. Delete pins of it first.")
    record = {"ends": nodes, **{key: value for key, value in record.items() if key != "nodes"}}
    entry: Any = {key: record[key] for key in SHARED if key in record}
    if what == "active":
        entry = {"ends": record["ends"], **_rods(data, record)}
    elif what == "beam":
        if not (entry.get("section") or data.get("section")):
            entry["section"] = _tube(_length(data, record), OUTER)
        if not (entry.get("material") or data.get("material")):
            entry["material"] = MATERIAL
    rest = without(data, table, name)
    if what == "link":
        entry["nodes"] = entry.pop("ends")
    found = {**rest, to: {**(rest.get(to) or {}), name: entry if len(entry) > 1 else nodes}}
    return clamped_where_beams_are(found), to, name


def _length(data: Data, record: Mapping[str, Any]) -> float:
    places = [[float(parse(value, "length")) for value in place_of(data, end)] for end in record["ends"]]
    return math.dist(*places)


def _rods(data: Data, record: Mapping[str, Any]) -> dict[str, Any]:
    """Rods of three quarters of the length each, which overlap, with the screw and the motor of the library."""
    length = _length(data, record)
    if length == 0:
        raise InputError("A member of length zero cannot be active.")
    material = record.get("material") or data.get("material") or MATERIAL
    rod = float(f"{0.75 * length:.3g}")
    return {
        "base": {"length": rod, "section": _tube(length, OUTER), "material": material},
        "tube": {"length": rod, "section": _tube(length, INNER), "material": material},
        "screw": "screw_lacy_slewing", "gear": "gear_lacy_slewing", "motor": "motor_lacy_slewing",
        "limits": [float(f"{0.8 * length:.3g}"), float(f"{1.4 * length:.3g}")],
    }  # fmt: skip


def _tube(length: float, share: tuple[float, float]) -> dict[str, Any]:
    outer, inner = (f"{1000 * part * length:.2g} mm" for part in share)
    return {"kind": "tube", "outer": outer, "inner": inner}


def _in_space(data: Data, name: str, nodes: Sequence[str]) -> Data:
    """The data with a body of four nodes or more carried by nodes that span it, with their centre near that of all.

    If all lie in a plane, three carry it, and a node without mass beside the plane makes it stiff out of the plane too.
    """
    places = np.array([[float(parse(value, "length")) for value in place_of(data, node)] for node in nodes])
    if places.shape[1] != 3:
        return data
    size = float(np.ptp(places, axis=0).max()) or 1.0
    four, volume = _spread(places / size, 4)
    three, area = _spread(places / size, 3)
    if area < FLAT**2:
        return data  # nearly on a line: the model says what such a body lacks
    record = {**data["bodies"][name], "carriers": [nodes[k] for k in (four if volume > FLAT**2 else three)]}
    if volume <= FLAT**2:
        normal = np.cross(*(places[three[1:]] - places[three[0]]))
        normal *= np.copysign(0.5 * size / np.linalg.norm(normal), normal[int(np.argmax(np.abs(normal)))])
        digits, apex = 4 - math.floor(math.log10(size)), f"{name}.apex"
        place = [round(float(one), digits) + 0.0 for one in places.mean(axis=0) + normal]
        data = {**data, "nodes": {**data["nodes"], apex: place}}
        record["nodes"] = [*nodes, apex]
    return {**data, "bodies": {**data["bodies"], name: record}}


def _spread(places: NDArray[np.float64], count: int) -> tuple[list[int], float]:
    """Of the triples (quadruples) that span at least half of the largest area (volume) that with its centre nearest the mean.

    Returns their numbers, and twice their area (six times their volume).
    """
    chosen = np.linspace(0, len(places) - 1, min(len(places), MOST_TRIED)).astype(int)
    groups = np.array(list(combinations(chosen.tolist(), count)))
    edges = places[groups[:, 1:]] - places[groups[:, :1]]
    spans = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) if count == 3 else np.abs(np.linalg.det(edges))
    off = np.linalg.norm(places[groups].mean(axis=1) - places.mean(axis=0), axis=1)
    off[spans < 0.5 * spans.max()] = np.inf
    best = int(np.argmin(off.round(9)))
    return [int(k) for k in groups[best]], float(spans[best])


def _angle(data: Data, nodes: Sequence[str], members: Sequence[str], axis: str) -> dict[str, Any]:
    """The angle between two members at their common node, in space about the line to a picked node; or of one member."""
    dim = len(place_of(data, next(iter(data["nodes"])))) if data.get("nodes") else 2
    ends = [ends_of(_found(data, name)[1]) for name in members]
    if len(members) == 1:
        return {"kind": "angle", "bar": members[0], **({"axis": axis} if dim == 3 else {})}
    shared = [end for end in ends[0] if end in ends[1]] if len(ends) == 2 else []
    if len(shared) != 1:
        raise InputError("Pick the two members that meet in the hinge, or one whose angle to the ground is meant.")
    hinge = shared[0]
    start, end = (next(other for other in pair if other != hinge) for pair in ends)
    if dim == 2:
        return {"kind": "hinge", "axis": [hinge], "start": start, "end": end}
    if len(nodes) != 1 or nodes[0] in (hinge, start, end):
        raise InputError(f"In space pick one more node: the axis of the hinge goes from {hinge} to it.")
    return {"kind": "hinge", "axis": [hinge, nodes[0]], "start": start, "end": end}


def new_run(drives: Mapping[str, Any]) -> dict[str, Any]:
    """A motion of all drives within two seconds: a tenth longer, or a turn of 30 degrees; without drives, the equilibrium."""
    if not drives:
        return {"analysis": "statics.equilibrium"}
    moves: dict[str, list[Any]] = {}
    for name, (value, unit) in drives.items():
        if unit == "rad":
            moves[name] = [f"{math.degrees(value + turn):.9g} deg" for turn in (0.0, math.pi / 6)]
        else:
            moves[name] = [float(f"{value:.9g}"), float(f"{value + 0.1 * (abs(value) or 1.0):.4g}")]
    return {
        "analysis": "dynamics.inverse",
        "trajectory": {"kind": "quintic", "moves": moves, "duration": "2 s"},
        "samples": 101,
    }
