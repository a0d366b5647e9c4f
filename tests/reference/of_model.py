"""Translates a model (names, sections, materials) into the oracle's truss: data only, no product arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from reference.newton_euler import Member, Rod, Truss

__all__ = ["external_forces", "truss_of"]

AXES = "xyz"


def truss_of(model: Any) -> Truss:
    """Members in the order of ``model.members``, nodes in the order of ``model.nodes``; rigid and driven bars only."""
    index = {name: i for i, name in enumerate(model.nodes)}
    supported = np.zeros((len(index), model.dim), bool)
    for node, axes in model.fixed.items():
        supported[index[node], [AXES.index(axis) for axis in axes]] = True
    gravity = np.zeros(model.dim) if model.gravity is None else np.array(model.gravity)
    lump_gravity = np.array([gravity if node.gravity is None else node.gravity for node in model.nodes.values()])
    members = tuple(_member(model, member, index) for member in model.members.values())
    names = list(model.members)
    drives = model.all_drives.values()
    turned = tuple(names.index(drive.bar) for drive in drives if drive.kind == "angle")
    pushed = tuple((index[drive.node], AXES.index(drive.axis)) for drive in drives if drive.kind == "coordinate")
    lump = np.array([node.mass for node in model.nodes.values()])
    return Truss(members, supported, gravity, lump, lump_gravity, turned, pushed)


def external_forces(model: Any) -> np.ndarray:
    """Sum of the constant nodal forces (n, dim), N."""
    index = {name: i for i, name in enumerate(model.nodes)}
    forces = np.zeros((len(index), model.dim))
    for load in model.loads.values():
        forces[index[load.node]] += load.force
    return forces


def _member(model: Any, member: Any, index: dict[str, int]) -> Member:
    a, b = (index[end] for end in member.ends)
    if hasattr(member, "tube"):
        return Member(a, b, (_rod(model, member.base, member.base.length), _rod(model, member.tube, member.tube.length)))
    at = [np.array(model.nodes[end].at) for end in member.ends]
    length = member.length or float(np.linalg.norm(at[1] - at[0]))
    return Member(a, b, (_rod(model, member, length),))


def _rod(model: Any, part: Any, length: float) -> Rod:
    section, material = model.section_of(part), model.material_of(part)
    mass = part.mass
    if mass is None:
        mass = 0.0 if section is None or material is None else material.density * section.area * length
    # in the plane the rod turns about axis 3; in space I2 = I3
    gyration = section.second_moments[1] / section.area if part.rotary_inertia else 0.0
    return Rod(mass, length, mass * gyration)
