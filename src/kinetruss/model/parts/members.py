"""Nodes, bars and active members."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import PlainValidator, WithJsonSchema, model_validator

from kinetruss.model._record import (
    Damping,
    Flag,
    Force,
    GravityVector,
    Inertia,
    Length,
    Name,
    Of,
    Point,
    PositiveLength,
    Record,
    RotaryFrictions,
    Stiffness,
    positive,
    short_form,
)
from kinetruss.model._record import LumpMass as Mass
from kinetruss.model.motion.drivetrain import AmplifierOrName, GearOrName, MotorOrName, ScrewOrName
from kinetruss.model.parts.sections import MaterialOrName, SectionOrName
from kinetruss.units import NUMBER, parse, shown

__all__ = ["Active", "Bar", "Compliance", "EndCondition", "Node", "Part", "PlanarBody", "PointMass"]

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

    A plain list of two or three coordinates is enough: ``A: [0, 100 mm]``. `coincident` allows a node at the position of
    another one (two joints at one place); otherwise that is a fault. A `scalar` is not a point but a single coordinate, its x
    (m or rad, as couplings use it): for instance an unwrapped angle that serves as a degree of freedom. A `director` belongs
    to the frame of another node, whose rotation beams share (added automatically, see `Beam`).

    at : place, m: two coordinates in the plane, three in space.
    mass : lumped mass, kg.
    gravity : acceleration of this mass, m/s^2; by default that of the model.
    coincident : it may stand where another node stands.
    scalar : it is a single coordinate, its x, and no point.
    director : it belongs to the frame of another node (added automatically).

    >>> import kinetruss as kt
    >>> kt.Node(at=("100 mm", 0), mass="2 kg")
    Node(at=(0.1, 0.0), mass=2.0)
    """

    at: Point
    mass: Mass = 0.0
    gravity: GravityVector | None = None
    coincident: Flag = False
    scalar: Flag = False
    director: Flag = False

    @model_validator(mode="before")
    @classmethod
    def _from_point(cls, value: Any) -> Any:
        return short_form(value, "at")


class PlanarBody(Record):
    """A planar body represented by one rigid bar: mass (kg), centre of mass and central moment of inertia (kg m^2).

    center : (e, f), m: e along the bar from its first to its second end, f to its left. Swapping the ends turns (e, f) into
        (l - e, -f).

    The mass matrix of the bar's four coordinates is constant; the concept: J. P. Meijaard and V. van der Wijk, Multibody
    System Dynamics 48 (2020) 259-282.
    """

    mass: Mass
    center: tuple[Length, Length]
    inertia: Inertia


class Bar(Record):
    """A straight member between two nodes.

    ends : names of its two nodes, A and B.
    section : of the whole bar, a record or a name; by default that of the model.
    material : likewise.
    pretension : force of an elastic bar or cable in the start configuration, N, in place of `natural_length`.
    kind : ``rigid`` keeps its length, ``driven`` has a length prescribed in time, ``elastic`` has a constitutive law,
        ``cable`` is elastic in tension only, ``free`` has no stiffness (but its mass and damping count).
    mass : total, kg; by default density x area x length, or 0 without section or material.
    length : the length to keep (rigid) or to start from (driven), m; by default the distance of the nodes.
    natural_length : l0 of an elastic bar or cable, m; by default the distance of the nodes; or `pretension` (N), its force in
        the start configuration.
    stiffness : k, N/m; by default E A/l0. damping : c, N s/m, of elastic bars, cables and free bars.
    strain : law of an elastic bar, ``engineering``: N = k (l - l0) + c l', or ``green``: N = k (l^2 - l0^2) l/(2 l0^2) + c l'.
        A cable longer than l0 has the tension max(0, k (l - l0) + c l'), a shorter one none.
    body : extended planar mass in place of the mass of the bar (rigid bars of planar models).
    brace : holds the nodes of a body together (added automatically, see `Body`): no section, and no mass unless given here; it
        is removed when its ends are no longer in one rigid body.
    rotary_inertia : count the rotary inertia of the finite diameter.
    friction : viscous friction of the bearings at its ends, N m s: the torque for each rad/s that the bar turns about its pin,
        in the plane. The pin of a fixed, guided or driven node does not turn; any other turns so that the torques of its bars
        are in balance: two bars with c each resist with c/2 for each rad/s between them.
    orientation : a node that, with the bar, spans the plane of local axes 1 and 2 (in space).
    buckling : how its ends are held: ``pinned-pinned``, ``clamped-pinned``, ``clamped-clamped``, ``clamped-free``, or the
        constant C of P = C pi^2 E I/l^2.

    >>> import kinetruss as kt
    >>> kt.Bar(ends=("A", "B"), section=kt.Rod(diameter="20 mm"), material="steel_s235")
    Bar(ends=('A', 'B'), section=Rod(diameter=0.02), material='steel_s235')
    """

    ends: tuple[Name, Name]
    kind: Literal["rigid", "driven", "elastic", "cable", "free"] = "rigid"
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    mass: Mass | None = None
    length: PositiveLength | None = None
    natural_length: PositiveLength | None = None
    pretension: Force | None = None
    stiffness: Stiffness | None = None
    damping: Damping = 0.0
    strain: Literal["engineering", "green"] = "engineering"
    body: PlanarBody | None = None
    brace: Flag = False
    rotary_inertia: Flag = False
    friction: RotaryFrictions = (0.0, 0.0)
    orientation: Name | None = None
    buckling: EndCondition = "pinned-pinned"

    @model_validator(mode="before")
    @classmethod
    def _from_pair(cls, value: Any) -> Any:
        return short_form(value, "ends")


class PointMass(Record):
    """A mass (kg) clamped on a rod, such as its motor: at this distance from the clamped end of the rod, m, on its axis."""

    at: Length
    mass: Mass


class Part(Record):
    """One rod of an active member.

    length : m. mass : kg, by default density x area x length. section, material : records or names of the library.
    rotary_inertia : count the rotary inertia of the finite diameter. masses : clamped on it besides its own.
    """

    length: PositiveLength
    mass: Mass | None = None
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    rotary_inertia: Flag = False
    masses: tuple[PointMass, ...] = ()


class Compliance(Record):
    """What an active member gives way by besides its tube, in series: screw, nut and base. In elastic analyses.

    screw : E A of the screw, N, by default that of the base rod; it is loaded from the base to the nut, over the length of the
        member less that of the tube. nut : stiffness of nut and thread, N/m. base : of bearing and housing, N/m. Those that are
        not given are rigid.
    """

    screw: Annotated[float, Of("force", positive)] | None = None
    nut: Stiffness | None = None
    base: Stiffness | None = None


class Active(Record):
    """An active member: a base rod clamped at its first end and a tube clamped at its second, overlapping.

    The screw between them drives the length.

    ends : names of its two nodes; the base is clamped at the first, the tube at the second.
    base, tube : the two rods. screw, gear, motor, amplifier : records, or names.
    length : at the start, m; by default the distance of the nodes. limits : least and largest length, m.
    friction : as of a `Bar`. orientation, buckling : as of a `Bar`; the whole member buckles.
    compliance : of screw, nut and base; its flexibility is then (l - l_t)/E A + l_t/E A_t + 1/k_nut + 1/k_base with the lengths
        l of the member and l_t of the tube. Without it, l/E A with the weaker of base and tube.
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
    compliance: Compliance | None = None
    friction: RotaryFrictions = (0.0, 0.0)
    orientation: Name | None = None
    buckling: EndCondition = "pinned-pinned"

    @model_validator(mode="after")
    def _ordered(self) -> Active:
        if self.limits and self.limits[0] >= self.limits[1]:
            raise ValueError(f"limits {self.limits} must be [least, largest]. Swap them.")
        return self
