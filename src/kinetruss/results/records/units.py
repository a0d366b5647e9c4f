"""Units of drives, couplings and springs: those of lengths or of angles, and where a structure has both, one for each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.mechanics import kept

if TYPE_CHECKING:
    from kinetruss.mechanics import System

__all__ = ["drive_unit", "force_units", "unit_along"]

Found = tuple[str, dict[str, tuple[str, list[str]]]]


def unit_along(axis: str, units: Sequence[str], name: str, none: str) -> Found:
    """The unit of values along an axis: that of all entries; or, where they differ, the name of a coordinate of units.

    units : of the entries. name : of that coordinate. none : the unit where there are no entries.

    >>> unit_along("drive", ["N", "N"], "drive_force_unit", "N")
    ('N', {})
    >>> unit_along("drive", ["N", "N m"], "drive_force_unit", "N")
    ('drive_force_unit', {'drive_force_unit': ('drive', ['N', 'N m'])})
    """
    if len(set(units)) < 2:
        return (units[0] if units else none), {}
    return name, {name: (axis, list(units))}


@kept()
def drive_unit(system: System) -> Found:
    """The unit of the positions of drives, as of `unit_along`."""
    return unit_along("drive", [_unit(system.model.all_drives.get(name)) for name in system.drives], "drive_unit", "m")


@kept()
def force_units(system: System, *axes: str) -> tuple[dict[str, str], dict[str, tuple[str, list[str]]]]:
    """The units of ``drive``, ``coupling`` and ``spring`` forces and of ``spring_value``, and the coordinates that they name.

    axes : of the coordinates; by default all. A coupling and a spring have the unit of their first coordinate.
    """
    model = system.model
    firsts = {
        "drive": [_unit(model.all_drives.get(name)) for name in system.drives],
        "coupling": [_unit(one.terms[0][0]) for one in model.couplings.values()],
        "spring": [_unit(model.springs[name].parts[0][0]) for name in system.springs],
    }
    found = {
        axis: unit_along(axis, [_force(one) for one in units], f"{axis}_force_unit", "N") for axis, units in firsts.items()
    }
    value, named = unit_along("spring", firsts["spring"], "spring_unit", "m")
    for _, coordinate in found.values():
        named = {**named, **coordinate}
    units = {axis: unit for axis, (unit, _) in found.items()} | {"spring_value": value}
    return units, {name: one for name, one in named.items() if one[0] in (axes or firsts)}


def _unit(coordinate: Any) -> str:
    """The unit of a coordinate as a drive would move it."""
    kind = getattr(coordinate, "kind", "length")
    return "rad" if kind in ("angle", "hinge") else "1" if kind == "cosine" else "m"


def _force(unit: str) -> str:
    return "N" if unit == "m" else "N m"
