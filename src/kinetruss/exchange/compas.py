"""A model from a graph or mesh of COMPAS, as its JSON files hold them: nodes and edges become nodes and bars.

A file of COMPAS 2 holds ``dtype``, ``data`` and ``inheritance``, the classes from which that of ``dtype`` is derived. One of
COMPAS 1 holds ``dtype`` and ``value``, or ``datatype`` and ``data``, or the bare data; defaults of attributes are ``dva`` and
``dna``; the faces of old meshes may be tables from each corner to the next; old networks have vertices.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.exchange.drawings import Names, length_of, model_of, supported_nodes, text_of
from kinetruss.exchange.imported import Imported
from kinetruss.exchange.robots import LeftOut
from kinetruss.limits import LARGEST
from kinetruss.model import Bar

GRAPHS, MESHES = ("Graph", "Network"), ("Mesh",)
SUPPORTS = ("is_support", "is_anchor", "is_fixed")
"""Attributes of nodes that mark supports."""


def compas(path: Path, *, max_size: int, unit: str = "m", fixed: Sequence[str] = ()) -> Imported:
    """The model of the one graph, network or mesh in a file of COMPAS. unit : of its lengths, which the file does not name."""
    return _File(path, max_size).imported(length_of(unit, "unit"), fixed)


def _classes(record: Mapping[str, Any]) -> list[str]:
    """The class of a record and those from which it is derived, nearest first; none of a table without a class."""
    own = record.get("dtype", record.get("datatype"))
    if own is None:
        return []
    more = record.get("inheritance")
    return [str(one) for one in (own, *(more if isinstance(more, list) else []))]


def _kind(record: Mapping[str, Any]) -> str:
    """``graph``, ``mesh``, or nothing. Without a class, or with one that does not say, the tables of its data decide."""
    classes = _classes(record)
    for name in (re.split(r"[/.]", one)[-1] for one in classes):
        if name in (*GRAPHS, *MESHES):
            return "mesh" if name in MESHES else "graph"
    data = (record.get("data", record.get("value")) if classes else record) or {}
    if "inheritance" in record or not isinstance(data, dict) or "cell" in data:
        return ""
    tables = {word for word in ("node", "vertex", "edge", "face") if isinstance(data.get(word), dict)}
    if {"vertex", "face"} <= tables and (data["face"] or not data.get("edge")):
        return "mesh"
    return "graph" if "edge" in tables and tables & {"node", "vertex"} else ""


class _File:
    def __init__(self, path: Path, max_size: int) -> None:
        self.path = str(path)
        text = text_of(path, max_size)
        try:
            self.root = json.loads(text, parse_constant=self._no_number)
        except json.JSONDecodeError as error:
            mend = "Give a whole file as compas.json_dump writes it."
            raise ModelError([Fault((), f"is not JSON: {error.msg}.", mend, error.lineno, error.colno, self.path)]) from None
        except RecursionError:
            raise self.fault((), "is nested too deep.", "Give a file as compas.json_dump writes it.") from None
        self.names, self.left = Names(), list[LeftOut]()

    def _no_number(self, text: str) -> float:
        raise self.fault((), f"holds {text}.", "Give finite numbers.")

    def fault(self, where: Sequence[str | int], message: str, mend: str) -> ModelError:
        return ModelError([Fault(tuple(where), message, mend, file=self.path)])

    def table(self, value: Any, *where: str) -> Mapping[str, Any]:
        if not isinstance(value, dict):
            raise self.fault(where, f"is {shown(value)}; expected a table.", "Give a file as compas.json_dump writes it.")
        return value

    def imported(self, scale: float, fixed: Sequence[str]) -> Imported:
        found = list(self._structures(self.root, ()))
        if len(found) != 1:
            mend = "Save one Graph, Network or Mesh in a file: compas.json_dump(graph, path)."
            raise self.fault((), f"holds {len(found)} graphs, networks and meshes.", mend)
        record, where = found[0]
        within = next((word for word in ("data", "value") if word in record), "") if _classes(record) else ""
        where = (*where, within) if within else where
        data = self.table(record[within] if within else record, *where)
        table = "node" if "node" in data else "vertex"
        places, name_of, supports = self._nodes(data, table, where, scale)
        pairs = self._sides(data, where) if _kind(record) == "mesh" else self._edges(data, where)
        bars: dict[str, Bar] = {}
        for a, b, place in pairs:
            for key in (a, b):
                if key not in name_of:
                    raise self.fault(place, f"names {table} {shown(key)}, which is not there.", "Correct the file.")
            ends = name_of[a], name_of[b]
            if ends[0] == ends[1]:
                self.left.append(LeftOut("edge", f"{self.path}: {'.'.join(place)}", "joins a node to itself"))
                continue
            bars[self.names.of(f"{ends[0]}-{ends[1]}", self.path, "bar")] = Bar(ends=ends)
        marked = [*supports, *supported_nodes(fixed, places, self.path)]
        model = model_of(
            self.path, places, bars, dict.fromkeys(marked), title=str(record.get("name") or Path(self.path).stem)[:200]
        )
        return Imported(model=model, source=self.path, left_out=[*self.left, *self.names.renamed])

    def _structures(self, value: Any, where: tuple[str, ...]) -> Iterator[tuple[Mapping[str, Any], tuple[str, ...]]]:
        """Graphs and meshes in lists and tables."""
        if isinstance(value, dict) and _kind(value):
            yield value, where
        elif isinstance(value, dict) and _classes(value):
            place = ".".join(where) or "root"
            self.left.append(LeftOut(shown(_classes(value)[0]), f"{self.path}: {place}", "is no graph or mesh"))
        elif isinstance(value, dict):
            for key, one in value.items():
                yield from self._structures(one, (*where, key))
        elif isinstance(value, list):
            for index, one in enumerate(value):
                yield from self._structures(one, (*where, str(index)))

    def _nodes(
        self, data: Mapping[str, Any], table: str, where: tuple[str, ...], scale: float
    ) -> tuple[dict[str, Any], dict[str, str], list[str]]:
        """Places (3,) m by name, names by the key in the file, names of supports."""
        given_defaults = data.get(f"default_{table}_attributes") or data.get("dna" if table == "node" else "dva") or {}
        default = {"x": 0.0, "y": 0.0, "z": 0.0} | dict(self.table(given_defaults, *where))
        places: dict[str, Any] = {}
        names: dict[str, str] = {}
        supports, others = [], set[str]()
        for key, given in self.table(data.get(table), *where, table).items():
            own = default | dict(self.table(given, *where, table, key))
            place = [own[axis] for axis in "xyz"]
            if not all(isinstance(x, (int, float)) and not isinstance(x, bool) and abs(x) <= LARGEST for x in place):
                raise self.fault((*where, table, key), f"has the coordinates {shown(place)}.", "Give three finite numbers.")
            text = key.strip("'\"")
            names[key] = self.names.of(f"{'n' if text.isdigit() else ''}{text}", f"{self.path}: {table} {key}", "node")
            places[names[key]] = [scale * float(x) for x in place]
            supports += [names[key]] * any(own.get(word) is True for word in SUPPORTS)
            others |= set(given) - {"x", "y", "z", *SUPPORTS}
        self.names.renamed = []  # numbers become names as a rule
        self.left += [
            LeftOut(f"attribute {word}", f"{self.path}: {table}", "has no place in a node") for word in sorted(others)
        ]
        return places, names, supports

    def _edges(self, data: Mapping[str, Any], where: tuple[str, ...]) -> Iterator[tuple[str, str, tuple[str, ...]]]:
        others = set[str]()
        seen = set[frozenset[str]]()
        for a, ends in self.table(data.get("edge"), *where, "edge").items():
            for b, given in self.table(ends, *where, "edge", a).items():
                others |= set(self.table(given, *where, "edge", a, b))
                if frozenset((a, b)) in seen:
                    self.left.append(LeftOut("edge", f"{self.path}: edge {a} {b}", "is there in the other direction"))
                    continue
                seen.add(frozenset((a, b)))
                yield a, b, (*where, "edge", a, b)
        self.left += [LeftOut(f"attribute {word}", f"{self.path}: edge", "has no place in a bar") for word in sorted(others)]

    def _sides(self, data: Mapping[str, Any], where: tuple[str, ...]) -> Iterator[tuple[str, str, tuple[str, ...]]]:
        """Sides of the faces of a mesh, each once."""
        seen = set[frozenset[str]]()
        faces = self.table(data.get("face") or {}, *where, "face")
        for face, corners in faces.items():
            if isinstance(corners, dict):  # corner -> the next one
                sides = [(a, str(b)) for a, b in corners.items()]
            elif isinstance(corners, list) and len(corners) > 1 and all(isinstance(c, (int, str)) for c in corners):
                keys = [str(one) for one in corners]
                sides = list(zip(keys, [*keys[1:], keys[0]], strict=True))
            else:
                raise self.fault((*where, "face", face), f"is {shown(corners)}; expected corners.", "Give a list of vertices.")
            for a, b in sides:
                if a != b and frozenset((a, b)) not in seen:
                    seen.add(frozenset((a, b)))
                    yield a, b, (*where, "face", face)
        if faces:
            self.left.append(
                LeftOut("face", f"{self.path}: face", f"{len(faces)} faces are carried as the bars of their sides")
            )
