"""Lists of a structure: its nodes, its members with length, section and mass, and the mass of the whole."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Markup, counted, quantity
from kinetruss.mechanics import compile
from kinetruss.mechanics.assembly import mass_matrix
from kinetruss.model import Active, Model, inner_parts
from kinetruss.report.document.frame import Columns
from kinetruss.report.document.parts.inputs import worded

if TYPE_CHECKING:
    from collections.abc import Sequence

    Record = dict[str, Any]

__all__ = ["lists", "members_of", "nodes_of", "total_mass"]


def lists(model: Model) -> list[Markup]:
    """The tables of nodes and of members of the model as it stands."""
    return [*_nodes(model), *_members(model)]


def nodes_of(model: Model) -> list[Record]:
    """Every node that the user wrote: name, place (m), supported axes and lumped mass (kg)."""
    inner = inner_parts(model).nodes
    return [
        {"node": name, "at": list(node.at), "support": _support(model, name), "mass": node.mass or 0.0}
        for name, node in model.nodes.items()
        if name not in inner
    ]


def _support(model: Model, name: str) -> str:
    if name in model.clamped:
        return "clamped" if model.clamped[name] == "ground" else f"clamped to {model.clamped[name]}"
    return model.fixed.get(name, "")


def members_of(model: Model) -> list[Record]:
    """Every bar, active member and beam of the user, and inner bars that have a mass: name, kind, ends, length (m), section and
    mass (kg), without masses on its nodes. A bar that stands for a planar body has the mass of the body.
    """
    system, inner = compile(model), inner_parts(model).bars
    mass = system.rods[:, 0] + system.rods[:, 3] + system.body[:, 0]
    found = []
    for k, (name, member) in enumerate(model.members.items()):
        if name in inner and not mass[k]:
            continue
        rods = (member.base, member.tube) if isinstance(member, Active) else (member,)
        kind = "active" if isinstance(member, Active) else str(member.kind)
        found.append(_entry(name, kind, member.ends, float(system.length0[k]), _sections(model, rods), float(mass[k])))
    for name, beam in model.beams.items():
        length = math.dist(*(model.nodes[end].at for end in beam.ends))
        section, material = model.section_of(beam), model.material_of(beam)
        own = beam.mass
        if own is None:
            own = 0.0 if section is None or material is None else material.density * section.area * length
        kind = "beam" if beam.kind == "elastic" else f"{beam.kind} beam"
        found.append(_entry(name, kind, beam.ends, length, _sections(model, (beam,)), float(own)))
    return found


def _entry(name: str, kind: str, ends: Sequence[str], length: float, section: str, mass: float) -> Record:
    return {"member": name, "kind": kind, "ends": list(ends), "length": length, "section": section, "mass": mass}


def _sections(model: Model, rods: Sequence[Any]) -> str:
    """The sections in words, of an active member those of base and tube."""
    return "; ".join(worded(one) for rod in rods if (one := model.section_of(rod)) is not None)


def total_mass(model: Model) -> float:
    """Mass of everything in a model, kg: twice its kinetic energy in a translation at 1 m/s, from its mass matrix."""
    system = compile(model)
    moved = np.zeros_like(system.x0)
    moved[[not node.scalar for node in model.nodes.values()], 0] = 1.0
    way = moved.reshape(-1)
    return float(way @ (mass_matrix(system, system.x0) @ way))


def _nodes(model: Model) -> list[Markup]:
    rows = nodes_of(model)
    table = Columns().words("node", [row["node"] for row in rows])
    table.together(list("xyz"[: model.dim]), [[row["at"][k] for row in rows] for k in range(model.dim)], "m")
    if any(row["support"] for row in rows):
        table.words("support", [row["support"] for row in rows])
    if any(row["mass"] for row in rows):
        table.measured("mass on it", [row["mass"] or None for row in rows], "kg")
    return [table.html("Nodes, in the position of the model")] if rows else []


def _members(model: Model) -> list[Markup]:
    rows = members_of(model)
    if not rows:
        return []
    table = Columns().words("member", [row["member"] for row in rows]).words("kind", [row["kind"] for row in rows])
    table.words("ends", [" – ".join(row["ends"]) for row in rows])
    table.measured("length", [row["length"] for row in rows], "m")
    if any(row["section"] for row in rows):
        table.words("section", [row["section"] for row in rows])
    table.measured("mass", [row["mass"] for row in rows], "kg")
    own, whole = sum(row["mass"] for row in rows), total_mass(model)
    words = f"Total of {counted(len(rows), 'member')}: {quantity(own, 'kg')}."
    others = [
        *(["masses on nodes"] if any(node.mass for node in model.nodes.values()) else []),
        *(["bodies"] if model.bodies else []),
        *(["membranes and solids"] if model.membranes or model.solids else []),
    ]
    if others:
        words += f" With {', '.join(others)}, everything in the model: {quantity(whole, 'kg')}."
    return [table.html("Members, in the position of the model", words)]
