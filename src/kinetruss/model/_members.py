"""Nodes, bars and active members."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import PlainValidator, WithJsonSchema, model_validator

from kinetruss.model._drivetrain import AmplifierOrName, GearOrName, MotorOrName, ScrewOrName
from kinetruss.model._record import Flag, GravityVector, Mass, Name, Point, PositiveLength, Record, short_form
from kinetruss.model._sections import MaterialOrName, SectionOrName
from kinetruss.units import NUMBER, parse, shown

__all__ = ["Active", "Bar", "EndCondition", "Node", "Part"]

_ENDS = ("pinned-pinned", "clamped-pinned", "clamped-clamped", "clamped-free")


def _end_condition(value: Any) -> Any:
    if isinstance(value, str) and not NUMBER.fullmatch(value):
        if value not in _ENDS:
            raise ValueError(f"{shown(value)} is no end condition. Write one of {', '.join(_ENDS)}, or the constant C.")
        return value
    if (constant := parse(value, "number")) <= 0:
        raise ValueError(f"end-condition constant {constant:g} must be greater than 0. Pinned ends: 1, clamped ends: 4.")
    return constant


_ENDS_SCHEMA = {"anyOf": [{"enum": list(_ENDS)}, {"type": "number", "exclusiveMinimum": 0}, {"type": "string"}]}
EndCondition = Annotated[str | float, PlainValidator(_end_condition), WithJsonSchema(_ENDS_SCHEMA)]
"""Ends for buckling: a name, or the end-condition constant C of P = C pi^2 E I / l^2."""


class Node(Record):
    """A joint at a point (m), with an optional lumped mass (kg) that may have its own gravity (m/s^2).

    A plain list of two or three coordinates is enough: ``A: [0, 100 mm]``. `coincident` allows a node to stand where
    another stands (two joints at one place); otherwise that is a fault.
    """

    at: Point
    mass: Mass = 0.0
    gravity: GravityVector | None = None
    coincident: Flag = False

    @model_validator(mode="before")
    @classmethod
    def _from_point(cls, value: Any) -> Any:
        return short_form(value, "at")


class Bar(Record):
    """A straight member between two nodes.

    kind : ``rigid`` keeps its length, ``driven`` has a length prescribed in time, ``elastic`` pulls by
        N = E A (l - natural length)/natural length, ``free`` only measures (its mass still counts).
    mass : total, kg; by default density x area x length, or 0 without section or material.
    length : the length to keep (rigid) or to start from (driven), m; by default the distance of the nodes.
    natural_length : of an elastic bar, m; by default the distance of the nodes.
    rotary_inertia : count the rotary inertia of the finite diameter.
    orientation : a node that, with the bar, spans the plane of local axes 1 and 2 (in space).
    """

    ends: tuple[Name, Name]
    kind: Literal["rigid", "driven", "elastic", "free"] = "rigid"
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    mass: Mass | None = None
    length: PositiveLength | None = None
    natural_length: PositiveLength | None = None
    rotary_inertia: Flag = False
    orientation: Name | None = None
    buckling: EndCondition = "pinned-pinned"

    @model_validator(mode="before")
    @classmethod
    def _from_pair(cls, value: Any) -> Any:
        return short_form(value, "ends")


class Part(Record):
    """One rod of an active member: length (m), mass (kg, by default density x area x length), section, material."""

    length: PositiveLength
    mass: Mass | None = None
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    rotary_inertia: Flag = False


class Active(Record):
    """An active member: a base rod clamped at its first end and a tube clamped at its second, overlapping.

    The screw between them drives the length. `limits` are the least and largest length (m).
    """

    ends: tuple[Name, Name]
    base: Part
    tube: Part
    screw: ScrewOrName | None = None
    gear: GearOrName | None = None
    motor: MotorOrName | None = None
    amplifier: AmplifierOrName | None = None
    length: PositiveLength | None = None
    limits: tuple[PositiveLength, PositiveLength] | None = None
    orientation: Name | None = None
    buckling: EndCondition = "pinned-pinned"

    @model_validator(mode="after")
    def _ordered(self) -> Active:
        if self.limits and self.limits[0] >= self.limits[1]:
            raise ValueError(f"limits {self.limits} must be [least, largest]. Swap them.")
        return self
