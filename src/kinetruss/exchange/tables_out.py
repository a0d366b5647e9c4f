"""What of a model a file of another program does not have: every table that its writer does not carry is named."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from kinetruss.errors import few
from kinetruss.exchange.robots import LeftOut
from kinetruss.model import Model
from kinetruss.model.data import ModelData

SHOWN = 6
"""Names of a table that are said."""

LINES = frozenset({"nodes", "bars", "active", "bodies", "joints", "hubs"})
MATTER = frozenset({"section", "material", "sections", "materials"})
ROBOT = LINES | MATTER | {"fixed", "links", "clamped", "supports", "gravity", "drives", "couplings", "springs"}
DRIVETRAINS = frozenset({"screws", "gears", "motors", "amplifiers"})

CARRIED: Mapping[str, frozenset[str]] = {
    ".xml": ROBOT | DRIVETRAINS,
    ".urdf": ROBOT | DRIVETRAINS,
    ".dxf": LINES | {"fixed"},
    ".stl": LINES | MATTER,
    ".vtu": LINES | {"membranes", "solids"},
    ".pvd": LINES | {"membranes", "solids"},
}
"""Suffix -> fields of the model that its writer carries, or whose entries it names one by one where it cannot."""

WHY: Mapping[str, str] = {
    ".xml": "is not carried",
    ".urdf": "is not carried",
    ".dxf": "a drawing has the lines of members, and points at supports",
    ".stl": "a surface has the shapes of bars and bodies alone",
    ".vtu": "a mesh has lines, triangles and tetrahedra, with what a run found on them",
    ".pvd": "a mesh has lines, triangles and tetrahedra, with what a run found on them",
}


def not_carried(model: Model, suffix: str, named: Iterable[LeftOut]) -> Iterator[LeftOut]:
    """The fields of a model that a file with this suffix lacks, besides what its writer has named."""
    said = {one.what for one in named}
    for field, about in ModelData.model_fields.items():
        value: Any = getattr(model, field)
        if field in ("kinetruss", "title") or field in CARRIED[suffix] or field in said:
            continue
        if value is None or value == about.get_default(call_default_factory=True):
            continue
        where = few(list(value), SHOWN) if isinstance(value, Mapping) else "model"
        yield LeftOut(field, where, WHY[suffix])
