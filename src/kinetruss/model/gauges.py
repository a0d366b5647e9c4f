"""Strain gauges on members, and their cross-checks."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, field_validator, model_validator

from kinetruss.errors import Fault
from kinetruss.model.drives import CoordinateName
from kinetruss.model.members import Brace
from kinetruss.model.record import (
    Angle,
    Coordinate,
    Distance,
    Flag,
    Name,
    Number,
    PositiveLength,
    PositiveNumber,
    PositiveResistance,
    Record,
    Resistance,
    SignedVoltage,
    Time,
    Voltage,
)
from kinetruss.model.references import LoadCaseName, MemberName
from kinetruss.model.table import ReadOnly, Table

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


class Bridge(Record):
    """The bridge of a gauge, for records in volts.

    kind : the active arms. ``quarter``: the gauge alone; ``half_bending``: a second one with the opposite strain, beside it;
    ``half_axial``: one across the axis; ``half_opposite``: one with the same strain, opposite; ``full_bending`` and
    ``full_axial``: two such pairs; ``half_dummy``: a second one on a piece of the same material without load, beside it, that
    compensates the temperature. excitation, V. gain : of the amplifier. linear : True if the readings are to be taken as
    proportional to strain (an instrument that corrects them). poisson : ratio of the strains across and along.
    resistance : of the gauge, lead : of one lead of three, ohm. zero : reading at zero strain, zero_end : the same after the
    record, V; between them it drifts linearly. shunt : resistor across the gauge, ohm, and shunt_reading : the change of the
    reading that it made, V.
    """

    kind: Literal["quarter", "half_bending", "half_axial", "half_opposite", "half_dummy", "full_bending", "full_axial"] = (
        "quarter"
    )
    excitation: Voltage
    gain: PositiveNumber = 1.0
    linear: Flag = False
    poisson: Number = 0.3
    resistance: PositiveResistance | None = None
    lead: Resistance = 0.0
    zero: SignedVoltage = 0.0
    zero_end: SignedVoltage | None = None
    shunt: PositiveResistance | None = None
    shunt_reading: SignedVoltage | None = None

    @model_validator(mode="after")
    def _whole(self) -> Bridge:
        if (self.shunt is None) != (self.shunt_reading is None):
            raise ValueError("has one of shunt and shunt_reading. Give both: the resistor, and the change of reading it made.")
        if self.shunt_reading == 0:
            raise ValueError("shunt_reading is 0 V: the shunt did nothing. Give the change of reading it made.")
        if self.resistance is None and (self.shunt is not None or self.lead):
            raise ValueError("has a shunt or a lead, but no resistance. Give the resistance of the gauge, e.g. 120 ohm.")
        return self


class Gauge(Record):
    """A strain gauge on a bar, or on base or tube of an active member, by default parallel to its axis.

    member : name of the bar or active member.
    distance : place in m from the end at A, in place of `at`.
    part : ``base`` or ``tube``, of an active member. at : place as a fraction of the length, from the end at A; or
    `distance` from that end, m; by default the middle. angle : place around the section, rad, from member axis 2 towards 3.
    radius : distance from the axis, m; by default the gauge sits on the surface. factor : gauge factor, relative change of
    resistance over strain. direction : of the gauge from the axis, towards growing `angle`, rad (shear gauges: +-45 deg).
    bridge : for records in volts. group : gauges of one name, at one section, whose readings are split into axial strain,
    bending and shear.
    temperature : of the gauge and the part under it, difference from that at which the gauge reads zero, K; a condition of a
    run adds its own. matched_expansion : thermal expansion of the material that the gauge is matched to, 1/K: it reads
    (expansion of the part - matched_expansion) temperature besides the strain by forces. By default it is matched to the part.
    Of a gauge without compensation it is that of its grid less temperature coefficient of its resistance over `factor`.
    """

    member: MemberName
    part: Literal["base", "tube"] | None = None
    at: Annotated[Number, Field(ge=0, le=1)] | None = None
    distance: Distance | None = None
    angle: Angle = 0.0
    radius: PositiveLength | None = None
    factor: PositiveNumber = 2.0
    group: Name | None = None
    direction: Angle = 0.0
    bridge: Bridge | None = None
    temperature: Number = 0.0
    matched_expansion: Number | None = None

    @field_validator("matched_expansion")
    @classmethod
    def _expansion(cls, value: float | None) -> float | None:
        if value is not None and not abs(value) < 1e-3:
            raise ValueError(f"{value:g} is no coefficient of expansion, 1/K. A gauge for steel: 11e-6.")
        return value

    @model_validator(mode="after")
    def _one_place(self) -> Gauge:
        if self.at is not None and self.distance is not None:
            raise ValueError("has both at and distance. Give one: at (a fraction), or distance (m).")
        return self


class GaugeZero(Record):
    """The reference state of all gauges: a pose at rest, under gravity, with the loads of `load_case` (by default none).

    time : instant of the run, s, in place of `at`.
    load_case : whose loads act in the reference state; by default none.
    at : drive or pose coordinates -> value (m or rad), the others as in the model; or `time` of the run, s.
    """

    at: Table[CoordinateName, Coordinate] = ReadOnly()
    time: Time | None = None
    load_case: LoadCaseName | None = None

    @model_validator(mode="after")
    def _one_pose(self) -> GaugeZero:
        if self.at and self.time is not None:
            raise ValueError("has both at and time. Give one: at (coordinates of a pose), or time (of the run).")
        return self


# Cross-checks of strain gauges: their places, and whether a group separates axial strain from bending.

Path = tuple[str, ...]


def gauge_faults(model: ModelData) -> Iterator[Fault]:
    """Faults of all gauges; unknown members and coordinates are reported by other checks."""
    for name, gauge in model.gauges.items():
        if gauge.member in model.members:
            yield from _place(model, name, gauge)
    for group in dict.fromkeys(gauge.group for gauge in model.gauges.values() if gauge.group is not None):
        yield from _group(model, group)


def part_of(model: ModelData, gauge: Any) -> Any:
    """The bar, or the part of an active member, under a gauge; None if the part is not given."""
    if gauge.member in model.bars:
        return model.bars[gauge.member]
    return None if gauge.part is None else getattr(model.active[gauge.member], gauge.part)


def part_path(model: ModelData, gauge: Any) -> Path:
    """The place of that part in the model."""
    return ("bars", gauge.member) if gauge.member in model.bars else ("active", gauge.member, gauge.part or "tube")


def _place(model: ModelData, name: str, gauge: Any) -> Iterator[Fault]:
    path = ("gauges", name)
    if gauge.member in model.bars and gauge.part is not None:
        yield Fault((*path, "part"), f"is given, but {gauge.member!r} is a bar.", "Remove it.")
        return
    part = part_of(model, gauge)
    if part is None:
        yield Fault(path, f"sits on the active member {gauge.member!r}, which has two rods.", "Say part: base, or part: tube.")
        return
    at = part_path(model, gauge)
    if isinstance(part, Brace):
        message = f"sits on {gauge.member!r}, which only holds or shows a beam or a body: it has no strain."
        yield Fault(path, message, "Put it on a bar. Stresses along beams: strength.beams.")
        return
    if getattr(part, "body", None) is not None:
        message = f"sits on {gauge.member!r}, a planar body whose inside is not known."
        yield Fault(path, message, "Put it on a bar.", about=((*at, "body"),))
        return
    about = (at, (*at, "section"), (*at, "material"), ("section",), ("material",))
    section = part.section if part.section is not None else model.section
    lacking = [word for word, own in (("section", section), ("material", part.material or model.material)) if own is None]
    if lacking:
        mend = f"Give {'.'.join(at)} a {' and a '.join(lacking)}: strain needs E, area and second moments."
        yield Fault(path, f"sits on {_called(gauge)}, which has no {' and no '.join(lacking)}.", mend, about=about)
    record = model.sections.get(section) if isinstance(section, str) else section
    if gauge.radius is None and getattr(record, "kind", None) == "general":
        mend = "Give radius: its distance from the axis."
        yield Fault(path, "sits on a general section, whose surface is not known.", mend, about=about)
    elif gauge.radius is not None and record is not None and not isinstance(record, str):
        yield from _radius((*path, "radius"), gauge, record)
    if gauge.direction and (gauge.radius is not None or getattr(record, "kind", None) == "general"):
        mend = "Leave out radius, and use a round or rectangular section: shear is known on their surface only."
        yield Fault((*path, "direction"), "is given where the shear of the surface is not known.", mend, about=about)
    if gauge.temperature and gauge.matched_expansion is not None:
        named = part.material or model.material
        material = model.materials.get(named) if isinstance(named, str) else named
        if material is not None and material.thermal_expansion is None:
            mend = "Give it thermal_expansion, 1/K."
            message = f"reads a temperature on {_called(gauge)}, whose material has no thermal expansion."
            yield Fault(path, message, mend, about=(*about, ("materials",)))
    if gauge.distance is not None:
        yield from _distance(model, name, gauge, part)


def _radius(path: Path, gauge: Any, section: Any) -> Iterator[Fault]:
    """A distance from the axis at which there is no material."""
    most = section.extreme_fibres[0] if section.round else math.hypot(*section.extreme_fibres)
    least = getattr(section, "inner", 0.0) / 2
    if not least * (1 - 1e-9) <= gauge.radius <= most * (1 + 1e-9):
        between = f"up to {most:g} m" if not least else f"{least:g} m to {most:g} m"
        mend = f"Give {between}, or leave it out for the surface."
        yield Fault(path, f"{gauge.radius:g} m is not in the section of {_called(gauge)}.", mend)


def _distance(model: ModelData, name: str, gauge: Any, part: Any) -> Iterator[Fault]:
    path = ("gauges", name, "distance")
    if gauge.member in model.bars:
        driven = {getattr(drive, "bar", None) for drive in model.all_drives.values() if drive.kind == "length"}
        if part.kind != "rigid" or gauge.member in driven:
            yield Fault(path, f"is given on {gauge.member!r}, whose length changes.", "Give at: a fraction of the length.")
            return
        ends = [model.nodes[end].at for end in part.ends if end in model.nodes]
        length = part.length or (math.dist(*ends) if len(ends) == 2 else math.inf)
    else:
        length = part.length
    if gauge.distance > length * (1 + 1e-9):
        mend = "Give a distance from its end towards A, or at: a fraction."
        yield Fault(path, f"{gauge.distance:g} m is beyond {_called(gauge)}, which is {length:g} m long.", mend)


def _called(gauge: Any) -> str:
    return repr(gauge.member if gauge.part is None else f"{gauge.member}.{gauge.part}")


def _group(model: ModelData, group: str) -> Iterator[Fault]:
    gauges = {name: gauge for name, gauge in model.gauges.items() if gauge.group == group}
    (first, one), *others = gauges.items()
    about = tuple(("gauges", name) for name in gauges)
    for name, other in others:
        if (other.member, other.part, other.at, other.distance) != (one.member, one.part, one.at, one.distance):
            mend = "Put gauges of one group at one section, or give them groups of their own."
            message = f"is of group {group!r} like {first!r}, but sits at another place."
            yield Fault(("gauges", name), message, mend, about=about)
    if any(gauge.direction for gauge in gauges.values()):
        return
    if not _separates([gauge.angle for gauge in gauges.values()], model.dim == 2):
        angles = ", ".join(f"{math.degrees(gauge.angle):g}" for gauge in gauges.values())
        mend = "Add gauges: two opposite each other, or three around the section."
        message = f"group {group!r}: axial strain cannot be distinguished from bending with gauges at {angles} deg."
        yield Fault(("gauges", first, "group"), message, mend, about=about)


def _separates(angles: list[float], planar: bool) -> bool:
    """True if some mean of the readings is free of bending: the axis lies on the line or plane through the gauges."""
    points = [(math.cos(angle), 0.0 if planar else math.sin(angle)) for angle in angles]
    distinct = [p for k, p in enumerate(points) if all(math.dist(p, q) > 1e-6 for q in points[:k])]
    if len(distinct) > 2:
        return True
    if len(distinct) == 1:
        return math.hypot(*distinct[0]) < 1e-6
    (a, b), (c, d) = distinct
    return abs(a * d - b * c) < 1e-6
