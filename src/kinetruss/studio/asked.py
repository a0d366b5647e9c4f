"""Linkages that a page asks for, with their small pictures, and one of them put into a drawing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.io.emitting import plain_model
from kinetruss.kinematics import follow, synthesis
from kinetruss.studio.copies import name_like
from kinetruss.studio.edits import MEMBERS, Data, place_of
from kinetruss.studio.small_pictures import small_picture
from kinetruss.units import parse

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kinetruss.kinematics.synthesis import Linkage, Linkages
    from kinetruss.kinematics.synthesis.found import Kind
    from kinetruss.model import Model

ADDING = "the choice of a"
"""What the step says that adds a linkage, before its kind."""

NEAR = 1e-9
"""Distance below which nodes stand at one place, of the size of the linkage."""

PLACES = 61
"""Places of a path that a small picture shows."""


def asked(
    positions: Sequence[Sequence[float]],
    path: Sequence[Sequence[float]],
    kinds: tuple[Kind, ...],
    *,
    closed: bool,
    point: float,
) -> Linkages:
    """Linkages for positions (x, y, angle; m, rad), or along a path; point : distance of the second point of a position, m."""
    if bool(positions) == bool(path):
        raise InputError("Give positions, or a path.")
    if positions:
        return synthesis.through(positions, kinds=kinds, point=point)
    return synthesis.along(path, closed=closed, kinds=kinds)


def rows(linkages: Linkages) -> list[dict[str, Any]]:
    """What a page shows of each."""
    return [
        {
            "kind": one.kind,
            "type": one.type,
            "error": one.error,
            "transmission": one.transmission,
            "size": one.size,
            "picture": small_picture(one.model, _path(one.model)),
        }
        for one in linkages
    ]


def _path(model: Model) -> list[list[float]]:
    motion = follow(model, model.runs["through"].trajectory, samples=PLACES)
    path: list[list[float]] = motion.position.sel(node="P").values.tolist()
    return path


def with_linkage(data: Data, linkage: Linkage) -> tuple[Data, str]:
    """The drawing with a linkage beside what it has, under names that are free, and the name of its crank.

    Raises
    ------
    InputError : the drawing is spatial.
    """
    more = plain_model(linkage.model)
    there = [[parse(value, "length") for value in place_of(data, name)] for name in data.get("nodes") or {}]
    if there and len(there[0]) != 2:
        raise InputError("A linkage lies in the plane; this drawing is in space. Begin a planar one.")
    found = dict(data)
    nodes: dict[str, str] = {}
    for name, place in more["nodes"].items():
        nodes[name] = name_like(found, "nodes", name) if name in (found.get("nodes") or {}) else name
        meets = any(max(map(abs, _apart(place, other))) < NEAR * linkage.size for other in there)
        found["nodes"] = {**(found.get("nodes") or {}), nodes[name]: {"at": place, "coincident": True} if meets else place}
    found["fixed"] = _held(data.get("fixed"), [nodes[name] for name in more["fixed"]])
    for node, one in (more.get("supports") or {}).items():
        found["supports"] = {**(found.get("supports") or {}), nodes[node]: one}
    taken = {name for table in MEMBERS for name in found.get(table) or {}}
    members = {name: _free(name, taken) for name in ("crank", "rocker", "coupler")}
    for table, key in (("bars", "ends"), ("links", "nodes")):
        for name, entry in more.get(table, {}).items():
            ends = [nodes[node] for node in (entry[key] if isinstance(entry, dict) else entry)]
            record = {**entry, key: ends} if isinstance(entry, dict) else ends
            found[table] = {**(found.get(table) or {}), members[name]: record}
    motor = _free("motor", set(found.get("drives") or {}))
    found["drives"] = {**(found.get("drives") or {}), motor: {**more["drives"]["motor"], "bar": members["crank"]}}
    run = more["runs"]["through"]
    course = {key: {motor: value["motor"]} if key in ("moves", "rates") else value for key, value in run["trajectory"].items()}
    name = _free("through", set(found.get("runs") or {}))
    found["runs"] = {**(found.get("runs") or {}), name: {**run, "trajectory": course}}
    return found, members["crank"]


def _apart(a: Sequence[float], b: Sequence[float]) -> list[float]:
    return [x - y for x, y in zip(a, b, strict=True)]


def _held(fixed: Any, nodes: list[str]) -> Any:
    """What is fixed already, and more nodes."""
    if isinstance(fixed, dict):
        return {**fixed, **dict.fromkeys(nodes, "xy")}
    return [*(fixed or ()), *nodes]


def _free(name: str, taken: set[str]) -> str:
    return next(new for new in (name, *(f"{name}{number}" for number in range(2, len(taken) + 3))) if new not in taken)
