"""Cross-checks of the coordinates of drives, couplings and springs, and of joints by name."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.data import ELEMENT_FIELDS, FORCE_ELEMENTS
from kinetruss.model.drives import geared
from kinetruss.model.joints import GROUND, SHARED
from kinetruss.model.references import unknown_names

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData
    from kinetruss.model.joints import Joint
    from kinetruss.model.whole import WholeModel


ON_AXIS = 1e-9
"""A node lies on an axis if its distance is below this fraction of that from the first node of the axis."""
Path = tuple[Any, ...]


def coupling_faults(model: WholeModel) -> Iterator[Fault]:
    """Faults of couplings; dependent conditions are found by the rank of the equations."""
    for name, coupling in model.couplings.items():
        path = ("couplings", name)
        if name in model.all_drives or name in model.members:
            yield Fault(path, f"{name!r} is also the name of a drive or a member.", "Give the coupling another name.")
        if not model.members and name not in model.inner.couplings:
            yield Fault(path, "couples nodes of a model without bars.", "Give the model its bars.", about=(("bars",),))
        yield from sum_faults(model, coupling.terms, (*path, "terms"))


def element_faults(model: ModelData) -> Iterator[Fault]:
    """What the records of elements find by themselves, of those whose names are known."""
    for field in ELEMENT_FIELDS.values():
        for name, one in getattr(model, field).items():
            if not any(unknown_names(model, one, (field, name))):
                yield from one.faults(model, (field, name))


def force_element_faults(model: WholeModel) -> Iterator[Fault]:
    """Faults of elements with a law, and of the coordinates that they act on."""
    seen = dict[str, str]()
    for kind, field in FORCE_ELEMENTS.items():
        for name, one in getattr(model, field).items():
            path = (field, name)
            if name in model.all_drives or name in model.members or name in model.couplings:
                words = f"{name!r} is also the name of a drive, a coupling or a member."
                yield Fault(path, words, f"Give the {kind} another name.")
            elif seen.setdefault(name, kind) != kind:
                yield Fault(path, f"{name!r} is also the name of a {seen[name]}.", f"Give the {kind} another name.")
            if not model.members and name not in model.inner.elements:
                yield Fault(path, "acts on nodes of a model without bars.", "Give the model its bars.", about=(("bars",),))
            if one.terms is not None:
                yield from sum_faults(model, one.terms, (*path, "terms"))
            elif one.coordinate is not None:
                yield from _term_faults(model, one.coordinate, (*path, "coordinate"))


def sum_faults(model: ModelData, terms: Any, path: Path) -> Iterator[Fault]:
    """Faults of a sum of coordinates: pairs of coordinate and factor."""
    for k, (one, factor) in enumerate(terms):
        yield from _term_faults(model, one, (*path, k))
        if factor == 0:
            yield Fault((*path, k), "has the factor 0.", "Leave the term out.")
    angles = [abs(factor) for one, factor in terms if one.kind in ("angle", "hinge")]
    if len({one.model_dump_json() for one, _ in terms}) < len(terms):
        yield Fault(path, "names a coordinate twice.", "Give each coordinate one factor.")
    elif angles and 0 < min(angles) < 1e-9 * max(angles):
        yield Fault(path, "has factors of angles that differ beyond all measure.", "Mend the factors.")


def _term_faults(model: ModelData, one: Any, path: Path) -> Iterator[Fault]:
    yield from measured_faults(model, one, path)
    if geared(one):
        yield Fault(path, "has a gear or a motor, but only measures.", "Put them on a drive of that angle.")


def measured_faults(model: ModelData, one: Any, path: Path) -> Iterator[Fault]:
    """Faults of one coordinate, given as the drive that would move it."""
    dim = len(next(iter(model.nodes.values())).at)
    if one.kind == "coordinate":
        if dim == 2 and one.axis == "z":
            yield Fault((*path, "axis"), "is z in a planar model.", "Choose x or y.", about=(("nodes",),))
    elif one.kind == "cosine":
        if one.node in model.nodes and not model.nodes[one.node].scalar:
            mend = f"Make it one: {one.node}: {{at: [..], scalar: true}}."
            yield Fault((*path, "node"), f"{one.node!r} is no scalar.", mend, about=(("nodes", one.node),))
    elif one.kind == "distance":
        yield from _distance(model, one, (*path, "nodes"))
    elif one.kind == "offset":
        yield from _offset(model, one, path, dim)
    elif one.kind == "hinge":
        yield from _hinge(model, one, path, dim)
    elif one.kind == "angle" and one.bar in model.members:
        yield from _angle(model, one, path, dim)


def _angle(model: ModelData, one: Any, path: Path, dim: int) -> Iterator[Fault]:
    if dim == 2:
        if one.axis is not None or one.reference is not None:
            mend = "Leave out axis and reference: the angle is counted from +x counter-clockwise."
            yield Fault(path, "gives an axis in a planar model.", mend, about=(("nodes",),))
        return
    if one.axis is None:
        mend = "Give axis: x, y, z or three numbers; or take a hinge, whose axis may move."
        yield Fault(path, "drives an angle in space without an axis.", mend, about=(("nodes",),))
        return
    ends = [model.nodes[name] for name in model.members[one.bar].ends if name in model.nodes]
    if len(ends) < 2:
        return
    d = [b - a for a, b in zip(ends[0].at, ends[1].at, strict=True)]
    if _across(d, one.axis) <= ON_AXIS * math.hypot(*d):
        yield Fault(path, f"{one.bar!r} points along the axis, so it has no angle about it.", "Choose another axis or bar.")
    if one.reference is not None and _across(one.reference, one.axis) <= ON_AXIS:
        yield Fault((*path, "reference"), "points along the axis.", "Give a direction across it.")


def _distance(model: ModelData, one: Any, path: Path) -> Iterator[Fault]:
    first, second = one.nodes
    scalars = [name for name in one.nodes if name in model.nodes and model.nodes[name].scalar]
    if first == second:
        yield Fault(path, f"names {first!r} twice.", "Give two different nodes.")
    elif scalars:
        yield Fault(path, f"{scalars[0]!r} is a scalar, which is no place.", "Give two nodes that are places.")
    elif all(name in model.nodes for name in one.nodes) and _apart(model, first, second) == 0.0:
        words = f"{first!r} and {second!r} stand at one place in the model, so their distance has no direction."
        yield Fault(path, words, "Give nodes that are apart, or move one of them.", about=(("nodes", first), ("nodes", second)))
    elif all(model.fixed.get(name, "") == "xyz"[: model.dim] and name not in model.support_motion for name in one.nodes):
        yield Fault(path, "are both fixed, so their distance cannot change.", "Name a node that can move.")


def _offset(model: ModelData, one: Any, path: Path, dim: int) -> Iterator[Fault]:
    names = (*one.line, one.point)
    ways = [way for way in (one.axis, one.along) if way is not None]
    if dim == 2 and ways:
        yield Fault(path, "gives a direction in a planar model.", "Leave out axis and along.", about=(("nodes",),))
    elif dim == 3 and len(ways) != 1:
        words = "an offset from a line in space counts in one direction across it."
        mend = "Give axis or along: x, y, z or three numbers. A node on the line has two offsets, one of each."
        yield Fault(path, words, mend, about=(("nodes",),))
    elif len(set(names)) < 3:
        yield Fault(path, "names a node twice.", "Give three different nodes.")
    elif all(name in model.nodes for name in one.line):
        long = _apart(model, *one.line)
        d = [b - a for a, b in zip(*(model.nodes[name].at for name in one.line), strict=True)]
        if long == 0.0:
            yield Fault((*path, "line"), "joins two nodes that stand at one place.", "Give two nodes that are apart.")
        elif ways and _across(d, ways[0]) <= ON_AXIS * long:
            yield Fault(path, "has a line that points along its direction.", "Give a direction across the line.")
        elif ways and not _on_line(model, path):
            words = "is an offset in space that is not kept 0; off the line its direction would not turn with the line."
            yield Fault(path, words, "In space take it alone, in a coupling with value: 0, which keeps the node on the line.")


def _on_line(model: ModelData, path: Path) -> bool:
    """Whether a path is that of the only term of a coupling whose value is 0."""
    own = model.couplings.get(path[1]) if path[0] == "couplings" else None
    return own is not None and len(own.terms) == 1 and own.value == 0.0


def _hinge(model: ModelData, one: Any, path: Path, dim: int) -> Iterator[Fault]:
    names = (*one.axis, one.start, one.end)
    if len(one.axis) != dim - 1:
        wanted = "one node" if dim == 2 else "two nodes"
        where = "in the plane" if dim == 2 else "in space"
        mend = f"Give {wanted}."
        yield Fault(
            (*path, "axis"), f"names {len(one.axis)} nodes; {where} a hinge turns about {wanted}.", mend, about=(("nodes",),)
        )
        return
    if len(set(names)) < len(names):
        mend = "Give nodes that are all different."
        yield Fault(path, "names a node twice, so one of its half-planes is none.", mend)
        return
    if not all(name in model.nodes for name in names):
        return
    first = model.nodes[one.axis[0]].at
    axis = None if dim == 2 else [b - a for a, b in zip(first, model.nodes[one.axis[1]].at, strict=True)]
    if axis is not None and math.hypot(*axis) == 0.0:
        yield Fault((*path, "axis"), "has both nodes at one place.", "Give two nodes that are apart.")
        return
    for field in ("start", "end"):
        name = getattr(one, field)
        r = [b - a for a, b in zip(first, model.nodes[name].at, strict=True)]
        off = math.hypot(*r) if axis is None else _across(r, axis)
        if off <= ON_AXIS * max(math.hypot(*r), 1e-300):
            mend = "Name a node of the same body that is off the axis."
            yield Fault((*path, field), f"{name!r} stands on the axis, so it has no angle about it.", mend)
    if all(model.fixed.get(name, "") == "xyz"[:dim] for name in names):
        yield Fault(path, "lies between fixed nodes, so its angle cannot change.", "Name nodes that can move.")


def _apart(model: ModelData, one: str, two: str) -> float:
    return math.dist(model.nodes[one].at, model.nodes[two].at)


def _across(r: Any, axis: Any) -> float:
    """Distance of the tip of r from the line along an axis."""
    cross = (r[1] * axis[2] - r[2] * axis[1], r[2] * axis[0] - r[0] * axis[2], r[0] * axis[1] - r[1] * axis[0])
    return math.hypot(*cross) / math.hypot(*axis)


# Cross-checks of joints: their bodies must share the nodes.


def joint_faults(model: ModelData) -> Iterator[Fault]:
    """Equal bodies; nodes that do not belong to them."""
    for name, joint in model.joints.items():
        yield from _bodies(model, joint, ("joints", name))


def _bodies(model: ModelData, joint: Joint, path: tuple[Any, ...]) -> Iterator[Fault]:
    first, second = joint.bodies
    sets: list[set[str]] = []
    if first == second:
        yield Fault((*path, "bodies"), f"joins {first!r} to itself.", "Name two different bodies, or ground.")
    for body in joint.bodies:
        if body == GROUND:
            own = set(model.fixed)
        elif body in model.bodies:
            own = set(model.bodies[body].nodes)
        else:
            continue
        sets.append(own)
        if not own & set(joint.nodes):
            named = ", ".join(joint.nodes) or "none"
            there = ", ".join(sorted(own)[:6]) or "none"
            mend = f"Add the joint's nodes ({named}) to those of {body!r}, {there} (of ground: fix them)."
            yield Fault((*path, "nodes"), f"none of them belongs to {body!r}: the bodies do not meet there.", mend)
            return
    need = model.dim if joint.kind == "weld" else SHARED.get(joint.kind, 0)
    if len(sets) == 2 and need and len(both := sets[0] & sets[1] & set(joint.nodes)) < need:
        shared = f"of its nodes only {', '.join(sorted(both))}" if both else "none of its nodes"
        message = f"the bodies share {shared}; {joint.kind} needs {need}, or they do not meet there."
        mend = f"Name {need} node{'s' if need > 1 else ''} in the joint and in both bodies (of ground: fixed), "
        mend += "or let library.joints make it."
        yield Fault((*path, "nodes"), message, mend)
