"""Which kinds of elements, laws, loads, drives and conditions a case has: read off its model, not what was meant to be made."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from models import Case, is_brace, whole

import kinetruss as kt

EVERY = (
    "plane", "space", "large", "in its own configuration", "off its conditions",
    "bar rigid", "bar driven", "bar elastic", "bar cable", "bar free", "law engineering", "law green", "cable taut",
    "cable slack",
    "damper", "damped elastic bar", "damped cable", "natural length", "pretension", "stiffness given", "stiffness of section",
    "length of rigid bar", "length of active member", "mass of bar given", "mass of section", "massless bar", "rotary inertia",
    "planar body on a bar", "brace", "active member", "active rods of section", "rotary inertia of rods", "motor and screw",
    "lump", "gravity of a lump", "scalar node", "node without mass", "support of one axis", "no gravity",
    "body on 2 of plane", "body on 3 of plane", "body on 2 of space", "body on 3 of space", "body on 4 of space",
    "straining body", "body spread evenly", "inertia tensor", "frame of a body", "body with more nodes",
    "membrane plane stress", "membrane plane strain", "membrane in space", "membrane orthotropic", "three-node triangles",
    "six-node constant", "six-node linear", "solid", "solid orthotropic",
    "load constant", "load in time", "force on body constant", "force on body follows", "force on body in time",
    "force on a bar", "couple constant", "couple follows", "couple in time", "pressure on edge", "pressure on face",
    "pressure in time", "load case", "factors of a load case", "gravity of a load case", "support motion",
    "drive length", "drive of a rigid bar", "drive angle of plane", "drive angle of space", "drive with reference",
    "drive hinge of plane", "drive hinge of space", "drive coordinate",
    "term length", "term angle", "term hinge", "term coordinate", "term offset", "coupling at a value", "gear of two angles",
    "coupling of three terms", "length and angle coupled", "joint", "pose",
    "task free", "task hold", "task force", "task torque", "task in time", "task none",
    "motion sine", "motion constant_rate", "motion quintic", "motion trapezoid", "motion cyclic", "motion step_response",
    "motion spline", "motion monotone",
    "beam elastic", "beam rigid", "damped beam", "released beam", "beam on a hinge", "orientation of a beam", "clamped node",
    "hub with arms", "hub with hinges", "hub that clamps", "bearing", "bearing against a member",
    "spring on angle", "spring on hinge", "spring on coordinate", "spring on length", "spring on a sum", "spring by a table",
    "spring with play", "spring with friction", "preloaded spring", "damped spring", "base rotation",
)  # fmt: skip
"""What a campaign must have met."""


def covers(case: Case) -> tuple[str, ...]:
    """The kinds in a case."""
    found = {*_whole(case), *_bars(case), *_nodes(whole(case.model)), *_bodies(whole(case.model)), *_continua(case.model)}
    found |= {*_beams(case.model), *_hubs(case.model), *_springs(case.model)}
    return tuple(sorted(found | {*_loads(case.model), *_drives(case), *_couplings(case.model)}))


def _whole(case: Case) -> Iterator[str]:
    model = case.model
    yield "plane" if model.dim == 2 else "space"
    if len(whole(model).members) > 60:
        yield "large"
    at = np.array([node.at for node in whole(model).nodes.values()])
    yield "in its own configuration" if np.array_equal(at, case.x) else "off its conditions"
    if model.gravity is None:
        yield "no gravity"
    if model.base_rotation is not None:
        yield "base rotation"
    if case.load_case:
        one = model.load_cases[case.load_case]
        yield "load case"
        if one.loads is not None:
            yield "factors of a load case"
        if one.gravity is not None:
            yield "gravity of a load case"


def _bars(case: Case) -> Iterator[str]:
    model = whole(case.model)
    place = {name: case.x[i] for i, name in enumerate(model.nodes)}
    for bar in model.bars.values():
        yield f"bar {bar.kind}"
        yield from _law(model, bar, float(np.linalg.norm(place[bar.ends[1]] - place[bar.ends[0]])))
        if is_brace(bar):
            yield "brace"
        if bar.rotary_inertia:
            yield "rotary inertia"
        if bar.body is not None:
            yield "planar body on a bar"
        elif bar.mass is not None:
            yield "mass of bar given" if bar.mass else "massless bar"
        elif model.section_of(bar) is not None and model.material_of(bar) is not None:
            yield "mass of section"
        if bar.kind == "rigid" and bar.length is not None:
            yield "length of rigid bar"
    for member in model.active.values():
        rods = (member.base, member.tube)
        yield "active member"
        for word, true in (
            ("rotary inertia of rods", any(rod.rotary_inertia for rod in rods)), ("length of active member", member.length),
            ("active rods of section", any(rod.mass is None for rod in rods)), ("motor and screw", member.motor),
        ):  # fmt: skip
            if true:
                yield word


def _law(model: kt.Model, bar: Any, length: float) -> Iterator[str]:
    if bar.kind in ("elastic", "cable"):
        if bar.kind == "elastic":
            yield f"law {bar.strain}"
        else:
            yield "cable slack" if bar.natural_length is not None and length < bar.natural_length else "cable taut"
        yield "stiffness given" if bar.stiffness is not None else "stiffness of section"
        if bar.natural_length is not None:
            yield "natural length"
        if bar.pretension is not None:
            yield "pretension"
        if bar.damping:
            yield "damped cable" if bar.kind == "cable" else "damped elastic bar"
    elif bar.kind == "free" and bar.damping:
        yield "damper"


def _nodes(model: kt.Model) -> Iterator[str]:
    ends = {end for member in model.members.values() for end in member.ends}
    massive = {end for member in model.members.values() if getattr(member, "mass", 1) != 0 for end in member.ends}
    for name, node in model.nodes.items():
        if node.mass:
            yield "lump"
        elif name in ends - massive and name not in model.fixed:
            yield "node without mass"
        if node.gravity is not None:
            yield "gravity of a lump"
        if node.scalar:
            yield "scalar node"
    if any(len(axes) < model.dim for axes in model.fixed.values()):
        yield "support of one axis"


def _bodies(model: kt.Model) -> Iterator[str]:
    for body in model.bodies.values():
        where, carriers = ("plane", "space")[model.dim - 2], body.carriers or body.nodes[: model.dim + 1]
        yield f"body on {len(carriers)} of {where}"
        if len(body.nodes) > len(carriers):
            yield "body with more nodes"
        if body.kind == "straining":
            yield "straining body"
        if body.inertia is None:
            yield "body spread evenly"
        elif np.ndim(body.inertia) == 2:
            yield "inertia tensor"
        if body.frame is not None:
            yield "frame of a body"


def _continua(model: kt.Model) -> Iterator[str]:
    for one in model.membranes.values():
        yield f"membrane plane {one.plane}" if model.dim == 2 else "membrane in space"
        yield "three-node triangles" if len(one.elements[0]) == 3 else f"six-node {one.strain}"
        if one.orthotropic is not None:
            yield "membrane orthotropic"
    for other in model.solids.values():
        yield "solid" if other.orthotropic is None else "solid orthotropic"


def _beams(model: kt.Model) -> Iterator[str]:
    for beam in model.beams.values():
        yield f"beam {beam.kind}"
        for word, true in (
            ("damped beam", beam.damping), ("released beam", beam.release), ("beam on a hinge", beam.hinges),
            ("orientation of a beam", beam.orientation is not None),
        ):  # fmt: skip
            if true:
                yield word
    if model.clamped:
        yield "clamped node"


def _hubs(model: kt.Model) -> Iterator[str]:
    for hub in model.hubs.values():
        for word, true in (("hub with arms", hub.arms), ("hub with hinges", hub.hinges), ("hub that clamps", hub.clamped)):
            if true:
                yield word
    for bearing in model.bearings.values():
        yield "bearing" if bearing.against is None else "bearing against a member"


def _springs(model: kt.Model) -> Iterator[str]:
    for spring in model.springs.values():
        yield "spring on a sum" if spring.coordinate is None else f"spring on {spring.coordinate.kind}"
        for word, true in (
            ("spring by a table", spring.table), ("spring with play", spring.play), ("spring with friction", spring.friction),
            ("preloaded spring", spring.preload), ("damped spring", spring.damping),
        ):  # fmt: skip
            if true:
                yield word


def _loads(model: kt.Model) -> Iterator[str]:
    for load in model.loads.values():
        kind, tabled = type(load).__name__, load.times is not None
        if kind == "NodalForce":
            yield "load in time" if tabled else "load constant"
        elif kind == "Pressure":
            yield "pressure on edge" if len(load.face) == 2 else "pressure on face"
            if tabled:
                yield "pressure in time"
        else:
            word = "couple" if kind == "BodyCouple" else "force on body"
            yield f"{word} follows" if load.follows else f"{word} constant"
            if tabled:
                yield f"{word} in time"
            if load.body in whole(model).bars:
                yield "force on a bar"
    if model.support_motion:
        yield "support motion"


def _drives(case: Case) -> Iterator[str]:
    model = case.model
    for name, drive in model.all_drives.items():
        where = {"angle": " of plane", "hinge": " of plane"} if model.dim == 2 else {"angle": " of space", "hinge": " of space"}
        yield f"drive {drive.kind}{where.get(drive.kind, '')}"
        if drive.kind == "length" and name in model.drives and getattr(whole(model).members[drive.bar], "kind", "") == "rigid":
            yield "drive of a rigid bar"
        if getattr(drive, "reference", None) is not None:
            yield "drive with reference"
        task = case.tasks.get(name)
        if task is None:
            yield "task none"
        else:
            yield "task torque" if getattr(task, "turns", False) else f"task {task.kind}"
            if getattr(task, "times", None):
                yield "task in time"
    if case.trajectory is not None:
        yield f"motion {case.trajectory.kind}"
        if getattr(case.trajectory, "shape", "") == "monotone":
            yield "motion monotone"


def _couplings(model: kt.Model) -> Iterator[str]:
    for coupling in whole(model).couplings.values():
        kinds = [term.kind for term, _ in coupling.terms]
        yield from (f"term {kind}" for kind in kinds)
        if coupling.value is not None:
            yield "coupling at a value"
        if kinds == ["angle", "angle"]:
            yield "gear of two angles"
        if len(kinds) == 3:
            yield "coupling of three terms"
        if {"length", "angle"} <= {*kinds}:
            yield "length and angle coupled"
    if model.joints:
        yield "joint"
    if model.poses:
        yield "pose"
