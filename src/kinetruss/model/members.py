"""Nodes, bars and active members, and the constitutive laws of elastic bars and cables."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import PlainValidator, WithJsonSchema, model_validator

from kinetruss.errors import Fault, shown
from kinetruss.model.drivetrain import AmplifierOrName, GearOrName, MotorOrName, ScrewOrName
from kinetruss.model.record import (
    Damping,
    Flag,
    Force,
    GravityVector,
    Inertia,
    Length,
    LumpMass as Mass,
    Of,
    Point,
    PositiveLength,
    Record,
    RotaryFrictions,
    Stiffness,
    positive,
    short_form,
)
from kinetruss.model.references import NodeName
from kinetruss.model.sections import MaterialOrName, SectionOrName
from kinetruss.units import NUMBER, parse

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


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
    (m or rad, as couplings use it): for instance an unwrapped angle that serves as a degree of freedom.

    at : place, m: two coordinates in the plane, three in space.
    mass : lumped mass, kg; of a scalar that is an angle the moment of inertia, kg m^2.
    gravity : acceleration of this mass, m/s^2; by default that of the model, of a scalar none.
    coincident : it may stand where another node stands.
    scalar : it is a single coordinate, its x, and no point.

    >>> import kinetruss as kt
    >>> kt.Node(at=("100 mm", 0), mass="2 kg")
    Node(at=(0.1, 0.0), mass=2.0)
    """

    at: Point
    mass: Mass = 0.0
    gravity: GravityVector | None = None
    coincident: Flag = False
    scalar: Flag = False

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

    ends: tuple[NodeName, NodeName]
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
    rotary_inertia: Flag = False
    friction: RotaryFrictions = (0.0, 0.0)
    orientation: NodeName | None = None
    buckling: EndCondition = "pinned-pinned"

    @model_validator(mode="before")
    @classmethod
    def _from_pair(cls, value: Any) -> Any:
        return short_form(value, "ends")


class Brace(Bar):
    """A bar that stands for no bar of the user (`inner`): it has no section, also where the model has one for all bars."""


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

    ends: tuple[NodeName, NodeName]
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
    orientation: NodeName | None = None
    buckling: EndCondition = "pinned-pinned"

    @model_validator(mode="after")
    def _ordered(self) -> Active:
        if self.limits and self.limits[0] >= self.limits[1]:
            raise ValueError(f"limits {self.limits} must be [least, largest]. Swap them.")
        return self


# Stiffness and natural length of elastic bars and cables, and faults of their constitutive laws.

ELASTIC_KINDS = ("elastic", "cable")


def axial_stiffness(model: ModelData, part: Any) -> float | None:
    """E A (N) of a bar or part, or None if section or material is unknown."""
    section, material = model.section_of(part), model.material_of(part)
    return None if section is None or material is None else float(material.E * section.area)


def stiffness(model: ModelData, bar: Bar, natural: float) -> float:
    """k = `stiffness`, or E A/l0, N/m.

    >>> import kinetruss as kt
    >>> section = kt.Rectangle(width=0.01, height=0.01)
    >>> bar = kt.Bar(ends=("A", "B"), kind="elastic", section=section, material=kt.Material(E=200e9, density=7800.0))
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A", "B"], bars={"b": bar})
    >>> round(kt.model.stiffness(model, bar, 2.0), 3)  # N/m: E A/l0
    10000000.0
    """
    if bar.stiffness is not None:
        return bar.stiffness
    EA = axial_stiffness(model, bar)
    return math.nan if EA is None else EA / natural


def natural_length(model: ModelData, bar: Bar, distance: float) -> float:
    """l0 (m) of an elastic bar or cable whose ends stand `distance` apart; NaN if its pretension admits none.

    Of a pretension N0: with k given, l0 = l - N0/k, or l0 = l/sqrt(1 + 2 N0/(k l)) with Green's strain; with E A,
    l0 = l/(1 + N0/(E A)), or l0 = l/s with s^3 - s = 2 N0/(E A) and s > 1/sqrt(3), where the slope of the law is positive.

    >>> import kinetruss as kt
    >>> cable = kt.Bar(ends=("A", "B"), kind="elastic", stiffness=1000.0, pretension=50.0)
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A", "B"], bars={"cable": cable})
    >>> kt.model.natural_length(model, cable, 1.0)  # m: l - N0/k
    0.95
    """
    if bar.pretension is None:
        return distance if bar.natural_length is None else bar.natural_length
    green = bar.strain == "green"
    if bar.stiffness is not None:
        share = bar.pretension / (bar.stiffness * distance)
        if green:
            return distance / math.sqrt(1 + 2 * share) if 1 + 2 * share > 0 else math.nan
        return distance * (1 - share) if share < 1 else math.nan
    EA = axial_stiffness(model, bar)
    if EA is None:
        return math.nan
    stretch = _green_stretch(bar.pretension / EA) if green else 1 + bar.pretension / EA
    return distance / stretch if stretch > 0 else math.nan


def _green_stretch(share: float) -> float:
    """The stretch ratio s = l/l0 > 1/sqrt(3) of s^3 - s = 2 `share` (Newton on a convex branch); NaN if there is none."""
    if 2 * share <= -2 / math.sqrt(27):
        return math.nan
    s = float((1 + 2 * abs(share)) ** (1 / 3) + 1)
    for _ in range(100):
        step = (s**3 - s - 2 * share) / (3 * s * s - 1)
        s -= step
        if abs(step) <= 1e-16 * s:
            break
    return s


def elastic_faults(model: ModelData, name: str, bar: Bar) -> Iterator[Fault]:
    """Faults of the fields of elastic bars and cables, and of such fields on other bars."""
    path = ("bars", name)
    kind = ((*path, "kind"),)
    if bar.kind in ELASTIC_KINDS:
        yield from _law(model, bar, path)
        return
    for field in ("natural_length", "pretension", "stiffness"):
        if getattr(bar, field) is not None:
            yield Fault((*path, field), f"is given for a {bar.kind} bar.", "Only elastic bars and cables have one.", about=kind)
    if bar.strain != "engineering":
        yield Fault((*path, "strain"), f"is given for a {bar.kind} bar.", "Only elastic bars have one.", about=kind)
    if bar.damping and bar.kind != "free":
        mend = "Damp an elastic, cable or free bar, or add one beside it."
        yield Fault((*path, "damping"), f"is given for a {bar.kind} bar, whose length is prescribed.", mend, about=kind)


def _law(model: ModelData, bar: Bar, path: tuple[str, str]) -> Iterator[Fault]:
    kind = ((*path, "kind"),)
    parts = tuple((*place, field) for place in (path, ()) for field in ("section", "material"))
    lacks = [
        word
        for word, found in (("section", model.section), ("material", model.material))
        if found is None and getattr(bar, word) is None
    ]
    if bar.stiffness is None and lacks:
        what = "is elastic" if bar.kind == "elastic" else "is a cable"
        mend = "Give both, for E A, or give stiffness, e.g. '2 kN/m'."
        about = (*kind, (*path, "stiffness"), *parts)
        yield Fault(path, f"{what} but has no {' and no '.join(lacks)}.", mend, about=about)
    if bar.pretension is not None and bar.natural_length is not None:
        mend = "Give one: each follows from the other."
        yield Fault((*path, "pretension"), "is given together with natural_length.", mend, about=((*path, "natural_length"),))
    elif bar.kind == "cable" and bar.pretension is not None and bar.pretension < 0:
        mend = "Give a tension, or a natural_length longer than the cable's ends are apart."
        yield Fault(
            (*path, "pretension"), f"{bar.pretension:g} N is compression; a cable carries tension only.", mend, about=kind
        )
    elif bar.pretension is not None and not (bar.stiffness is None and lacks):
        yield from _stretch(model, bar, path, parts)
    if bar.kind == "cable" and bar.strain != "engineering":
        yield Fault((*path, "strain"), "is given for a cable.", "A cable has engineering strain; remove it.", about=kind)


def _stretch(model: ModelData, bar: Bar, path: tuple[str, str], parts: Any) -> Iterator[Fault]:
    """A pretension for which there is no positive natural length."""
    if not all(end in model.nodes for end in bar.ends) or any(
        isinstance(chosen, str) and chosen not in table
        for chosen, table in (
            (bar.section if bar.section is not None else model.section, model.sections),
            (bar.material if bar.material is not None else model.material, model.materials),
        )
    ):
        return
    a, b = (model.nodes[end].at for end in bar.ends)
    distance = math.dist(a, b) if len(a) == len(b) else 0.0
    if distance > 0 and math.isnan(natural_length(model, bar, distance)):
        message = f"{bar.pretension:g} N is more than the bar can carry at its length of {distance:g} m."
        mend = "Give a smaller pretension, or a stiffer bar."
        yield Fault((*path, "pretension"), message, mend, about=((*path, "stiffness"), *parts))
