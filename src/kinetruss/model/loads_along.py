"""Loads between the ends of members: forces and couples along them, and at a place of them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

from pydantic import Field, model_validator
from pydantic_core import core_schema

from kinetruss.errors import Fault, shown
from kinetruss.model.in_time import InTime, MomentOf, Times, amounts_of, moment_faults, vector_faults
from kinetruss.model.links import bends, is_sound, is_straight, length_along
from kinetruss.model.record import ForceVector, Name, Number, Of, Series
from kinetruss.model.references import Ref
from kinetruss.units import NUMBER, parse

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData
    from kinetruss.model.links import Link

CARRIERS = {"bars": "bar", "active": "active member", "beams": "beam", "links": "link"}
"""Tables whose entries take loads between their ends, and what one of them is called."""


def carrier(model: ModelData, name: str) -> tuple[str, Any] | None:
    """The table and the record of the member that takes a load; None if there is none of that name."""
    return next(((table, one) for table in CARRIERS if (one := getattr(model, table).get(name)) is not None), None)


class PlaceOf:
    """Annotation of a place along a member: a length, or a share in percent, which stays text."""

    quantity = "length"

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(_place)

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        what = "distance from the first end: a number in m, text with a unit, or a share of the length, e.g. 50 %"
        return {"anyOf": [{"type": "number"}, {"type": "string"}], "description": what, "x-unit": "m"}


def _place(value: Any) -> float | str:
    if isinstance(value, str) and value.rstrip().endswith("%"):
        number = value.rstrip()[:-1].strip()
        if not NUMBER.fullmatch(number) or not 0.0 <= float(number) <= 100.0:
            raise ValueError(f"{shown(value)} is no share of a length. Write one from 0 % to 100 %, e.g. 50 %.")
        return f"{float(number)!r} %".replace(".0 %", " %")
    found = parse(value, "length")
    if found < 0.0:
        raise ValueError(f"{found:g} m is before the first end. Give a distance from there, or a share, e.g. 50 %.")
    return float(found)


Place = Annotated[float | str, PlaceOf()]


def fraction(place: Any, length: Any) -> Any:
    """A place as a fraction of the length, m, of its member."""
    return float(place[:-1]) / 100.0 if isinstance(place, str) else place / length


class BetweenEnds(InTime):
    """What loads between the ends of members have in common."""

    member: Annotated[Name, Ref("bar, active member, beam or link", *CARRIERS)]
    times: Times = None
    axes: Literal["global", "member"] = "global"


class AlongMember(BetweenEnds):
    """What loads along members have in common."""

    shape: Annotated[tuple[Number, Number], Series] = (1.0, 1.0)
    start: Place | None = None
    end: Place | None = None


class AtPlace(BetweenEnds):
    """What loads at a place of a member have in common."""

    at: Place

    @model_validator(mode="before")
    @classmethod
    def _no_part(cls, data: Any) -> Any:
        if isinstance(data, dict) and (along := [name for name in ("start", "end", "shape", "per") if name in data]):
            raise ValueError(f"has at, the place of a load, and {along[0]}, of one along a member. Leave out one of them.")
        return data


LineLoad = Annotated[tuple[Annotated[float, Of("force per length")], ...], Field(min_length=2, max_length=3), Series]
Couple = Annotated[Any, MomentOf("torque")]
LineCouple = Annotated[Any, MomentOf("moment per length")]


class MemberLoad(AlongMember):
    """A force along a member, N/m: uniform or trapezoidal, on all of it or on a part.

    force : constant force a length, N/m. Lengths are those of the model: the whole does not change when the member does.
    times, forces : a table in place of `force`, s and N/m.
    member : name of a bar that is rigid, driven or elastic, of an active member, of an elastic beam, or of a link with section
        and material. On an active member it reaches from joint to joint: the tube takes it where there is one, the base
        before it.
    shape : factors of the force where it begins and where it ends, linear in between; (0, 1) is a triangle.
    start, end : where it begins and ends, m from the first end of the member, or a share as ``25 %``; by default at the ends.
    axes : ``global``: it keeps its direction; ``member``: its components are along the axes of the member, with which it turns
        (1 from the first end to the second; the others as in `strength.sections`).
    per : ``length`` of the member, or ``projection``: of the member as seen along the force, as snow is given. The projection
        is that of the present position: q L |sin| of the angle between force and member.

    >>> import kinetruss as kt
    >>> kt.MemberLoad(member="arm", force=(0, "-2 kN/m"), shape=(0, 1)).force
    (0.0, -2000.0)
    """

    force: LineLoad | None = None
    forces: Annotated[tuple[LineLoad, ...], Series] | None = None
    per: Literal["length", "projection"] = "length"

    @model_validator(mode="after")
    def _projected(self) -> Self:
        if self.per == "projection" and self.axes == "member":
            raise ValueError("counts on the projection along a force that turns with the member. Leave out per, or axes.")
        return self


class MemberCouple(AlongMember):
    """A couple along a bar of a planar model or along a beam, N m/m: uniform or trapezoidal, on all of it or on a part.

    moment : constant couple a length, N m/m: one number in the plane, counter-clockwise; three in space.
    times, moments : a table in place of `moment`, s and N m/m.
    member : name of a bar of a planar model that is rigid, driven or elastic, or of an elastic beam.
    shape : factors of the couple where it begins and where it ends, linear in between; their sum is not 0.
    start, end : where it begins and ends, m from the first end of the member, or a share as ``25 %``; by default at the ends.
    axes : of its components in space: ``global``, or ``member``, with which it turns.

    >>> import kinetruss as kt
    >>> kt.MemberCouple(member="crank", moment="30 N m/m", start=0.1).moment
    30.0
    """

    amount, amounts = "moment", "moments"
    moment: LineCouple | None = None
    moments: Annotated[tuple[LineCouple, ...], Series] | None = None

    @model_validator(mode="after")
    def _whole(self) -> Self:
        if not sum(self.shape):
            raise ValueError(f"has the shape {self.shape}, whose sum is 0. Give two couples, each on its part of the member.")
        return self


class MemberPointForce(AtPlace):
    """A force at a place between the ends of a member, N: the shear force jumps there.

    force : constant force, N.
    times, forces : a table in place of `force`, s and N.
    member : name of a bar that is rigid, driven or elastic, of an elastic beam, or of a link with section and material.
    at : where it acts, m from the first end of the member, or a share as ``50 %``.
    axes : ``global``: it keeps its direction; ``member``: its components are along the axes of the member, with which it turns.

    >>> import kinetruss as kt
    >>> kt.MemberPointForce(member="arm", force=(0, "-2 kN"), at="50 %").at
    '50 %'
    """

    force: ForceVector | None = None
    forces: Annotated[tuple[ForceVector, ...], Series] | None = None


class MemberPointCouple(AtPlace):
    """A couple at a place of a bar of a planar model or of a beam, N m: the bending moment jumps there.

    moment : constant couple, N m: one number in the plane, counter-clockwise; three in space.
    times, moments : a table in place of `moment`, s and N m.
    member : name of a bar of a planar model that is rigid, driven or elastic, or of an elastic beam.
    at : where it acts, m from the first end of the member, or a share as ``50 %``.
    axes : of its components in space: ``global``, or ``member``, with which it turns.

    >>> import kinetruss as kt
    >>> kt.MemberPointCouple(member="crank", moment="30 N m", at="1.2 m").at
    1.2
    """

    amount, amounts = "moment", "moments"
    moment: Couple | None = None
    moments: Annotated[tuple[Couple, ...], Series] | None = None


# What does not fit a model.

BEYOND = 1e-9
"""Places behind the end by less than this fraction of the length are at the end."""


def along_faults(load: BetweenEnds, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:
    """What does not fit the model: the member, the vector, or a place beyond its ends."""
    found = carrier(model, load.member)
    about = tuple((table, load.member) for table in CARRIERS)
    if load.amount == "force":
        yield from vector_faults(load, model, dim, path)
    else:
        yield from moment_faults(load, dim, path, (*about, ("nodes",)))
    if found is None or not all(node in model.nodes for node in found[1].ends):
        return
    table, one = found
    if table == "links":
        yield from _on_link(load, model, one, path, about)
        return
    what = CARRIERS[table]
    if load.amount == "moment" and (table == "active" or (table == "bars" and dim == 3)):
        message = f"is a couple on {'an active member' if table == 'active' else 'a bar in space'}."
        yield Fault(
            (*path, "member"), message, "Name a bar of a planar model or a beam, or give couples on bodies.", about=about
        )
    elif table != "active" and one.kind not in (("elastic",) if table == "beams" else ("rigid", "driven", "elastic")):
        message = f"acts between the ends of the {one.kind} {what} {load.member!r}."
        mend = (
            "Name an elastic beam."
            if table == "beams"
            else "Name a rigid, driven or elastic bar: others carry nothing across them."
        )
        yield Fault((*path, "member"), message, mend, about=about)
    if table == "active":
        yield from _on_active(load, path, about)
        return
    yield from _places(load, math.dist(*(model.nodes[node].at for node in one.ends)), path, about)


def _places(load: BetweenEnds, length: float, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    if isinstance(load, AlongMember):
        yield from _span(load, length, path, about)
    elif isinstance(load, AtPlace):
        yield from _beyond(load, "at", length, path, about)
    if isinstance(load, MemberLoad) and load.per == "projection":
        yield from _one_direction(load, path)


def _on_link(load: BetweenEnds, model: ModelData, link: Link, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    bent = len(link.nodes) > 2 and not is_straight(model, link)
    if load.amount == "moment":
        yield Fault((*path, "member"), "is a couple on a link.", "Name a bar of a planar model or a beam.", about=about)
    elif not bends(model, link):
        message = f"acts between the ends of the link {load.member!r}, which has no section or no material."
        yield Fault((*path, "member"), message, "Give the link both, or forces at its nodes.", about=about)
    elif bent and load.axes == "member":
        message = f"has axes: member, and the link {load.member!r} is bent."
        yield Fault((*path, "axes"), message, "Give the load in global axes.", about=about)
    elif bent and isinstance(load, MemberLoad) and load.per == "projection":
        message = f"counts on the projection of the link {load.member!r}, which is bent."
        yield Fault((*path, "per"), message, "Give it per length.", about=about)
    elif is_sound(model, link):
        yield from _places(load, length_along(model, link), path, about)


def _on_active(load: BetweenEnds, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    """Places on an active member move with its base or its tube, and the model does not say with which."""
    for field in ("at", "start", "end"):
        if getattr(load, field, None) is not None:
            message = f"is a place on the active member {load.member!r}, whose length changes."
            mend = "Leave it out: a load acts on the whole of it." if field != "at" else "Give a MemberLoad on the whole of it."
            yield Fault((*path, field), message, mend, about=about)
            return
    if isinstance(load, MemberLoad) and not sum(load.shape):
        message = f"is {load.shape}, whose sum is 0, on the active member {load.member!r}."
        yield Fault((*path, "shape"), message, "Give two loads, e.g. (1, 0) and (0, -1).", about=about)
    if isinstance(load, MemberLoad) and load.per == "projection":
        yield from _one_direction(load, path)


def _beyond(load: BetweenEnds, field: str, length: float, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    place = getattr(load, field)
    if isinstance(place, float) and place > (1.0 + BEYOND) * length:
        message = f"is {place:.6g} m along {load.member!r}, which is {length:.6g} m long."
        yield Fault((*path, field), message, "Stay between its ends: places count from the first.", about=about)


def _span(load: AlongMember, length: float, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    ends = {"start": 0.0 if load.start is None else load.start, "end": length if load.end is None else load.end}
    start, end = (fraction(place, length) * length if length else 0.0 for place in ends.values())
    beyond = [
        fault for field in ("end", "start") for fault in _beyond(load, field, length, path, about) if getattr(load, field)
    ]
    if beyond:
        yield beyond[0]
    elif length and start >= end:
        message = f"is {start:.6g} m, not before the end at {end:.6g} m."
        yield Fault((*path, "start"), message, "Give start a smaller value than end.", about=about)


def _one_direction(load: MemberLoad, path: tuple[Any, ...]) -> Iterator[Fault]:
    """A projection is along a force that keeps its line."""
    rows = [value for _, value in amounts_of(load, path) if any(value)]
    for row in rows[1:]:
        square = math.fsum(a * a for a in row) * math.fsum(a * a for a in rows[0])
        if len(row) != len(rows[0]) or math.fsum(a * b for a, b in zip(row, rows[0], strict=True)) ** 2 < (1 - 1e-12) * square:
            message = "has forces in several directions, and counts on the projection along one."
            yield Fault((*path, "forces"), message, "Give one load for each direction.")
            return
