"""What every cell of the library takes besides its shape: sections, active members, its place in an assembly."""

from __future__ import annotations

from typing import Annotated, Any, TypedDict

from pydantic import BeforeValidator

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.library._builder import named
from kinetruss.library.cells.mirroring import mirror
from kinetruss.library.cells.records import Axis, Cell, Triple, changed
from kinetruss.library.materials import ALUMINIUM_LACY, MATERIALS
from kinetruss.library.sections import SECTIONS, TUBE_LACY_SPATIAL
from kinetruss.model import (
    Active,
    Bar,
    Compliance,
    Flag,
    Gear,
    LeadScrew,
    Mass,
    Material,
    Motor,
    Name,
    Part,
    PositiveLength,
    Record,
    Whole,
    matched,
    nearest,
)
from kinetruss.model.parts import EndCondition, Section

__all__ = ["Actuator", "Fittings", "Placing", "dressed", "placed"]


class Actuator(Record):
    """An active member of a cell, by the name or pattern of the bars that it takes the place of.

    With `base` and `tube` it becomes an `Active` member with two rods, without them a driven bar. ends : of a member that the
    cell does not have. The other fields are those of `Active`; a tube without mass and section has those of the bars.
    """

    ends: tuple[Name, Name] | None = None
    base: Part | None = None
    tube: Part | None = None
    screw: LeadScrew | Name | None = None
    gear: Gear | Name | None = None
    motor: Motor | Name | None = None
    limits: tuple[PositiveLength, PositiveLength] | None = None
    compliance: Compliance | None = None
    buckling: EndCondition | None = None


def _by_pattern(value: Any) -> Any:
    """A list of patterns: driven bars."""
    if isinstance(value, str):
        return {value: {}}
    if isinstance(value, (list, tuple)) and all(isinstance(one, str) for one in value):
        return {one: {} for one in value}
    return value


Actuators = Annotated[dict[Name, Actuator], BeforeValidator(_by_pattern)]
"""Pattern -> what drives the bars; or patterns alone."""


class Placing(TypedDict, total=False):
    """Place of a cell in an assembly, see `Cell`; mirrored : the axis along which it is mirrored, see `mirror`."""

    on: Name
    by: Name
    turn: Whole
    at: Triple
    towards: Triple
    mirrored: Axis


class Fittings(Placing, total=False):
    """Of all bars that have none of their own: section, material, mass (kg), rotary inertia, end condition; active members."""

    section: Section | Name | None
    material: Material | Name | None
    mass: Mass | None
    rotary_inertia: Flag
    buckling: EndCondition
    active: Actuators


_BARS = {"section": TUBE_LACY_SPATIAL, "material": ALUMINIUM_LACY}


def placed(cell: Cell, placing: Any) -> Cell:
    """The cell with its place in an assembly, mirrored first if wanted."""
    rest = {key: value for key, value in placing.items() if key != "mirrored" and value is not None}
    cell = mirror(cell, placing["mirrored"]) if placing.get("mirrored") else cell
    return changed(cell, **rest) if rest else cell


def dressed(cell: Cell, fittings: Fittings, groups: dict[str, tuple[str, ...]] | None = None) -> Cell:
    """A bare cell with its fittings. groups : more names for some of its bars, which `active` may use."""
    given: dict[str, Any] = {**_BARS, **fittings}
    section = named(SECTIONS, given["section"], "section")
    material = named(MATERIALS, given["material"], "material")
    own = {"section": None if section is None else "bar", "material": None if material is None else "bar"}
    own |= {key: given[key] for key in ("mass", "rotary_inertia", "buckling") if key in given}
    bars = {name: _own(bar, own) for name, bar in cell.bars.items()}
    bars, active = _driven(bars, given.get("active", {}), groups or {}, own)
    used = changed(
        cell,
        bars=bars,
        active={**cell.active, **active},
        sections=({} if section is None else {"bar": section}) | cell.sections,
        materials=({} if material is None else {"bar": material}) | cell.materials,
        poses={} if given.get("active") else cell.poses,
    )
    return placed(used, {key: given.get(key) for key in Placing.__annotations__})


def _own(bar: Bar, fields: dict[str, Any]) -> Bar:
    """A bar with what it does not have yet."""
    rest = {key: value for key, value in fields.items() if value is not None and key not in bar.model_fields_set}
    return bar if bar.body is not None or bar.brace else changed(bar, **rest)


def _driven(
    bars: dict[str, Bar], actuators: dict[str, Actuator], groups: dict[str, tuple[str, ...]], own: dict[str, Any]
) -> tuple[dict[str, Bar], dict[str, Active]]:
    """The bars, some of them driven now, and the active members that take the place of others."""
    bars, active = dict(bars), {}
    for pattern, actuator in actuators.items():
        names = [*matched(list(bars), pattern), *(one for group in matched(list(groups), pattern) for one in groups[group])]
        if actuator.ends is not None:
            bars[pattern] = _own(Bar(ends=actuator.ends), own)
            names = [pattern]
        if not names:
            known = [*groups, *bars]
            raise ModelError([Fault(("active", pattern), f"{shown(pattern)} matches no bar.", nearest(pattern, known))])
        for name in dict.fromkeys(names):
            if actuator.base is None and actuator.tube is None:
                bars[name] = changed(bars[name], kind="driven")
                _no_train(pattern, actuator)
            else:
                active[name] = _rods(pattern, actuator, bars.pop(name))
    return bars, active


def _rods(pattern: str, actuator: Actuator, bar: Bar) -> Active:
    if actuator.base is None or actuator.tube is None:
        lacks = "base" if actuator.base is None else "tube"
        raise ModelError([Fault(("active", pattern), f"has no {lacks}.", "Give base and tube, or neither: a driven bar.")])
    tube = actuator.tube
    if tube.mass is None and tube.section is None:
        tube = changed(tube, section=bar.section, material=bar.material)
    kept = {key: getattr(actuator, key) for key in ("base", "screw", "gear", "motor", "limits", "compliance")}
    return Active(ends=bar.ends, orientation=bar.orientation, tube=tube, buckling=actuator.buckling or bar.buckling, **kept)


def _no_train(pattern: str, actuator: Actuator) -> None:
    if odd := [key for key in ("screw", "gear", "motor", "limits", "compliance") if getattr(actuator, key) is not None]:
        mend = "Give its two rods: base: {length: .., mass: ..}, tube: {length: ..}."
        raise ModelError([Fault(("active", pattern), f"has {odd[0]}, but no rods.", mend)])
