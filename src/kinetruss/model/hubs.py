"""Rigid hubs of finite size: the record and its cross-checks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Field, PlainValidator, WithJsonSchema, model_validator

from kinetruss.errors import Fault, shown
from kinetruss.model.common_faults import a_bar
from kinetruss.model.hub_arms import FLAT, Arm, arms_of, clamped_at, free_length, is_grounded, members_at
from kinetruss.model.hub_expansion import is_steady, perpendicular, pivots_of
from kinetruss.model.members import Active
from kinetruss.model.record import Flag, PositiveLength, Record, Series
from kinetruss.model.references import MemberName, unknown_names
from kinetruss.model.sections import MaterialOrName, SectionOrName
from kinetruss.model.table import ReadOnly, Table
from kinetruss.units import parse

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


def _offset(value: Any) -> Any:
    """A distance along the member, or the components of a vector."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, (list, tuple)):
        if len(value) not in (2, 3):
            raise ValueError(f"has {len(value)} components. Give a distance along the member, or a vector from the node.")
        vector = tuple(parse(entry, "length") for entry in value)
        if not any(vector):
            raise ValueError("is a vector of length 0. Leave the member out: it then ends at the node itself.")
        return vector
    if (distance := parse(value, "length")) <= 0:
        raise ValueError(f"{shown(value)} must be greater than 0. Leave the member out: it then ends at the node itself.")
    return distance


_NUMBER: dict[str, Any] = {"anyOf": [{"type": "number"}, {"type": "string"}]}
_SCHEMA = {
    "anyOf": [*_NUMBER["anyOf"], {"type": "array", "items": _NUMBER, "minItems": 2, "maxItems": 3}],
    "description": "length: a number in m or text with a unit, towards the member's other end; or a vector from the node",
    "x-unit": "m",
}
Offset = Annotated[Any, PlainValidator(_offset), WithJsonSchema(_SCHEMA)]
"""m: a distance from the node towards the member's other end, or a vector from the node in the start configuration."""


def _axis(value: Any) -> Any:
    """A direction in space: x, y, z, or three numbers."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, str) and value in ("x", "y", "z"):
        return tuple(float(value == one) for one in "xyz")
    numbers = tuple(parse(entry, "number") for entry in value) if isinstance(value, (list, tuple)) else ()
    if len(numbers) != 3 or not any(numbers):
        raise ValueError(f"{shown(value)} is no axis in space. Give x, y, z or three numbers, not all 0.")
    return numbers


_AXIS_SCHEMA = {
    "anyOf": [{"enum": ["x", "y", "z"]}, {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}],
    "description": "axis in the start configuration: x, y, z or three numbers",
}
HingeAxis = Annotated[Any, PlainValidator(_axis), WithJsonSchema(_AXIS_SCHEMA)]
"""A direction in space, in the start configuration."""


class Hub(Record):
    """A node of finite size: a rigid hub with an arm to the joint of each member (plane: pin; space: ball joint or hinge).

    In `Model.hubs` by the name of its node, which is the centre. Members end at it in the model. In its whole (`Model.whole`)
    they end at the tips of arms, rigid bars ``NODE.MEMBER`` to nodes of the same name. A member becomes shorter by its arms;
    its `length`, `natural_length` and `limits` are those between its joints.

    reach : length of the arms of all members at the node that are neither in `arms` nor in `clamped`, m.
    arms : by member, the length of its arm towards its other end, m, or the vector of its joint from the node, m, in the
        start configuration. A member that no field names ends at the centre.
    hinges : by member with an arm, in space, the axis of its joint in the start configuration, ``x``, ``y``, ``z`` or three
        numbers: the member turns about it only, relative to the hub. Without it the joint is a ball.
    clamped : rigid members that are fixed to the hub, without a joint; the hub turns with them, and they bend.
    section, material : of the arms; by default those of the model, as for any bar.
    turns : the hub of a fixed node turns about it. Otherwise it is bolted to the ground, and its arms do not move.

    >>> import kinetruss as kt
    >>> ideal = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (0.5, 0.5)}, fixed=["A", "B"],
    ...                  bars={"a": ("A", "C"), "b": ("B", "C")})
    >>> real = ideal.with_(hubs={"A": kt.Hub(reach=0.05), "B": kt.Hub(reach="50 mm")})
    >>> real.whole.bars["a"].ends, [round(c, 6) for c in real.whole.nodes["A.a"].at]
    (('A.a', 'C'), [0.035355, 0.035355])
    """

    reach: PositiveLength | None = None
    arms: Table[MemberName, Offset] = ReadOnly()
    hinges: Table[MemberName, HingeAxis] = ReadOnly()
    clamped: Annotated[tuple[MemberName, ...], Field(), Series] = ()
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    turns: Flag = False

    @model_validator(mode="after")
    def _apart(self) -> Hub:
        if both := [name for name in self.clamped if name in self.arms]:
            raise ValueError(f"{shown(both[0])} is clamped and has an arm. Keep one of the two.")
        if both := [name for name in self.clamped if name in self.hinges]:
            raise ValueError(f"{shown(both[0])} is clamped and has a hinge. Keep one of the two.")
        if self.reach is None and not self.arms and not self.clamped:
            raise ValueError("has no arms. Give reach (all members), arms: {MEMBER: 50 mm}, or clamped: [MEMBER].")
        return self


# Cross-checks of hubs: their members, their places, and what they leave of the lengths of members.

LEAN = 0.1
"""Least sine of the angle between the axis of a hinge and its member."""
SQUARE = 1e-9
"""How much less than 1 the sine may be where the length of the member changes."""
SAME = 1e-9
"""Lengths that differ by less than this fraction are one."""


def hub_faults(model: ModelData) -> list[Fault]:
    """Faults of the hubs of a model."""
    if not model.hubs:
        return []
    found = unknown_names(model, model.hubs, ("hubs",), (type(model), "hubs"))
    lost = bool(missing_nodes(model))  # reported with the members and bodies
    for hub in model.hubs if not lost else ():
        found += [*_places(model, hub)]
    if found or lost:
        return found
    arms = [arm for hub in model.hubs for arm in arms_of(model, hub)]
    for hub in model.hubs:
        found += [*_clamped(model, hub), *_hinges(model, hub), *_on_line(model, hub)]
    for arm in arms:
        found += [*_place(model, arm)]
    for name in dict.fromkeys(arm.member for arm in arms):
        found += [*_lengths(model, name, [arm.hub for arm in arms if arm.member == name])]
    return found


def missing_nodes(model: ModelData) -> set[str]:
    """Nodes that members, and bodies, of a model with hubs name, and that it does not have."""
    named = {end for member in model.members.values() for end in member.ends}
    named |= {node for body in model.bodies.values() for node in body.nodes}
    return {name for name in named if name not in model.nodes and not _is_tip(model, name)}


def _is_tip(model: ModelData, name: str) -> bool:
    """Whether a node may be the tip of an arm."""
    return any(name.startswith(f"{hub}.") and name[len(hub) + 1 :] in model.members for hub in model.hubs)


def _places(model: ModelData, hub: str) -> Iterator[Fault]:
    """Members that end elsewhere, vectors of another dimension."""
    path, record = ("hubs", hub), model.hubs[hub]
    if hub not in model.nodes:
        return
    here, dim = members_at(model, hub), len(model.nodes[hub].at)
    for field, names in (("arms", record.arms), ("clamped", record.clamped), ("hinges", record.hinges)):
        for name in names:
            if name in model.members and name not in here:
                ends = " and ".join(model.members[name].ends)
                mend = f"Name one of those that do: {', '.join(here) or 'none'}."
                yield Fault((*path, field, name), f"does not end at {hub!r} but at {ends}.", mend)
    for name, offset in record.arms.items():
        if isinstance(offset, tuple) and len(offset) != dim:
            mend = f"Give {dim}, or a distance along the member."
            yield Fault((*path, "arms", name), f"has {len(offset)} components in a model of dimension {dim}.", mend)
    if not here:
        yield Fault(path, "is a node at which no member ends.", "Name a node with members.")


def _clamped(model: ModelData, hub: str) -> Iterator[Fault]:
    """Only a rigid bar can be clamped, and not to a hub on the ground."""
    path, record = ("hubs", hub, "clamped"), model.hubs[hub]
    for name in record.clamped:
        member = model.members[name]
        kind = "driven" if isinstance(member, Active) or name in model.driven_members else member.kind
        if kind != "rigid":
            mend = "Clamp a rigid bar at this node, and give this member an arm."
            yield Fault((*path, name), f"is {a_bar(kind)}, whose length changes.", mend, about=(("bars", name),))
        elif is_grounded(model, hub):
            far = next(node for node in member.ends if node != hub)
            mend = f"Fix {far!r} too; or say turns: true, if the hub turns about its node."
            yield Fault((*path, name), "is clamped to a hub on the ground, so that it cannot move.", mend)


def _hinges(model: ModelData, hub: str) -> Iterator[Fault]:
    """Hinges of the plane, without an arm, about the axis of the member, or of members that cannot bear their moments."""
    record, arms = model.hubs[hub], {arm.member: arm for arm in arms_of(model, hub)}
    for name, axis in record.hinges.items():
        path, member = ("hubs", hub, "hinges", name), model.members[name]
        if len(model.nodes[hub].at) == 2:
            yield Fault(path, "is in a planar model, where every joint is a pin.", "Leave it out.")
            continue
        if name not in arms:
            yield Fault(path, f"has a hinge at {hub!r}, but no arm.", f"Give it one: arms: {{{name}: 50 mm}}.")
            continue
        kind = getattr(member, "kind", "active")
        if kind in ("cable", "free"):
            yield Fault(path, f"is {a_bar(kind)}, which bears no moment.", "Leave the hinge out.", about=(("bars", name),))
            continue
        other = member.ends[1 - arms[name].end]
        far = {one.member: one.at for one in arms_of(model, other)}.get(name) if other in model.hubs else None
        along = np.array(far or model.nodes[other].at) - np.array(arms[name].at)
        along /= np.linalg.norm(along) or 1.0
        unit = np.array(axis) / np.linalg.norm(axis)
        across = perpendicular(unit, along)
        size = float(np.linalg.norm(across))
        if size < LEAN:
            yield Fault(path, "has its axis along the member, which would not swing.", "Turn the axis across the member.")
        elif not is_steady(model, name) and size < 1 - SQUARE:
            mend = f"Give ({', '.join(f'{c:.6g}' for c in across / size)}); or keep its length, and drive another member."
            yield Fault(path, "is not square to the member, whose length changes.", mend)


def _on_line(model: ModelData, hub: str) -> Iterator[Fault]:
    """In space bars do not hold three nodes on a line, and nothing keeps what stands beside them from turning about it."""
    places = [model.nodes[hub].at, *(arm.at for arm in arms_of(model, hub))]
    places += [model.nodes[node].at for node in clamped_at(model, hub).values()]
    places += [at for one in pivots_of(model) if one.hub == hub for at in one.at]
    if len(places[0]) == 2 or len(places) < 3 or is_grounded(model, hub):
        return
    spread = np.linalg.svd(np.array(places) - np.mean(places, axis=0), compute_uv=False)
    if spread[1] <= FLAT * spread[0]:
        mend = "Give it an arm off that line (a vector); or two members on one line: make them one bar."
        yield Fault(("hubs", hub), "has its centre and all its joints on one line, about which it would turn freely.", mend)


def _place(model: ModelData, arm: Arm) -> Iterator[Fault]:
    """A tip whose name is taken."""
    for table in ("nodes", "bars", "active"):
        if arm.name in getattr(model, table):
            message = f"needs the name {arm.name!r} for the arm of {arm.member!r}, which is in use."
            yield Fault(("hubs", arm.hub), message, f"Rename it in {table}.", about=((table, arm.name),))


def _lengths(model: ModelData, name: str, hubs: list[str]) -> Iterator[Fault]:
    """Hubs that overlap, rods longer than what is left, lengths that are still those from node to node."""
    whole, rest = free_length(model, name)
    table = "active" if name in model.active else "bars"
    about: Any = ((table, name), *(("nodes", node) for node in model.members[name].ends))
    path = ("hubs", hubs[0])
    if rest <= SAME * whole:
        others = "overlaps its other node" if len(hubs) == 1 else f"overlaps that of {hubs[1]!r}"
        mend = f"Shorten the arms to less than {whole:.6g} m together, or lengthen the member."
        yield Fault(
            path, f"{others}: {name!r} is {whole:.6g} m long from node to node, and its arms are longer.", mend, about=about
        )
        return
    member: Any = model.members[name]
    rods = (("base", member.base.length), ("tube", member.tube.length)) if isinstance(member, Active) else ()
    for role, length in rods:
        now = rest if member.length is None else member.length
        if length > now * (1 + SAME):
            message = f"leaves {name!r} {now:.6g} m between its joints, but its {role} is {length:.6g} m long."
            mend = f"Shorten the {role}, or the arms of the hub."
            yield Fault(path, message, mend, about=((table, name),))
    for field in ("length", "natural_length"):
        stated = getattr(member, field, None)
        if stated is not None and abs(stated - whole) <= SAME * whole < abs(stated - rest):
            message = f"leaves {name!r} {rest:.6g} m between its joints; its {field} is that from node to node, {whole:.6g} m."
            yield Fault(path, message, f"Give {field}: {rest:.6g} m, or leave it out.", about=((table, name),))
