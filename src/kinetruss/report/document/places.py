"""Where in a run an entry of the verdict stands: its instant, and section forces and constants at its section."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import strength

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.report.document.sheets import Sheet
    from kinetruss.results import Forces, Row


BESIDE = 1e-12
"""Fraction of a part's length to either side of a section, for section forces that jump there."""

ROUND_OFF, FAINT, TINY = 1e-11, 1e-9, 1e-3
"""Share of the largest moment, and of the largest force, up to which a moment and a shear force are round-off: the square of
a shear force adds to a stress. The axial force with an arm of a thousandth of the length counts as a moment there."""

SCAN = 121
"""Stations of a scan along a part."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cut:
    """Section forces of a part at one section: T, V2, V3 N, M2, M3 N m (0 in the plane), torsion N m (0 without any), and the
    member's length, m.
    """

    part: str
    T: float
    V2: float
    V3: float
    M2: float
    M3: float
    torsion: float
    length: float


def sample_of(forces: Forces, row: Row) -> int | None:
    """Index of the sample of an entry: by the name of its pose, or by its time."""
    if row.pose:
        found = np.flatnonzero(forces.whole["pose"].values == row.pose)
    else:
        found = np.flatnonzero(forces.whole["time"].values == row.time)
    return int(found[0]) if len(found) else None


def cuts(model: Model, forces: Forces, part: str, position: float) -> list[Cut]:
    """Section forces of a part at a distance from end A of its member, m, and just to either side of it; of one sample."""
    found = strength.sections(model, forces, stations=2).data
    k = found["part"].values.tolist().index(part)
    start, span = (float(found[name].values[0, k]) for name in ("part_start", "part_length"))
    xi = np.clip((position - start) / span + np.array([0.0, -BESIDE, BESIDE]), 0.0, 1.0)
    order = np.argsort(xi, kind="stable")
    data = strength.sections(model, forces, stations=xi[order]).data.isel(time=0, part=k)
    member = str(found["member"].values[k])
    length = float(forces.motion.whole["length"].values[0, list(model.whole.members).index(member)])
    at = {int(place): n for n, place in enumerate(order)}
    return [_cut(data.isel(station=at[n]), part, length) for n in range(3)]


def _cut(data: Any, part: str, length: float) -> Cut:
    V = {str(axis): float(value) for axis, value in zip(data["transverse"].values, data["section_V"].values, strict=True)}
    M = {str(axis): float(value) for axis, value in zip(data["moment"].values, data["section_M"].values, strict=True)}
    T = float(data["section_T"])
    V2, V3, _ = without_round_off(V.get("2", 0.0), V.get("3", 0.0), T, share=FAINT)
    twist = float(data["torsion"]) if "torsion" in data else 0.0
    M2, M3, torsion, _ = without_round_off(M.get("2", 0.0), M.get("3", 0.0), twist, TINY * T * length)
    return Cut(part=part, T=T, V2=V2, V3=V3, M2=M2, M3=M3, torsion=torsion, length=length)


def without_round_off(*values: float, share: float = ROUND_OFF) -> tuple[float, ...]:
    """The values, 0 for those of at most a share of the largest one.

    >>> without_round_off(22.9, -6.8e-11, 0.5)
    (22.9, 0.0, 0.5)
    """
    largest = max(map(abs, values))
    return tuple(0.0 if abs(value) <= share * largest else value for value in values)


def largest_shear(model: Model, forces: Forces, part: str) -> float:
    """Largest shear force along a part, N, of one sample: a scan of its stations, then finer ones around the best."""
    low, high, best = 0.0, 1.0, 0.0
    for _ in range(4):
        xi = np.linspace(low, high, SCAN)
        data = strength.sections(model, forces, stations=xi).data
        k = data["part"].values.tolist().index(part)
        shear = np.linalg.norm(data["section_V"].values[0, k], axis=-1)
        at = int(np.argmax(shear))
        best = max(best, float(shear[at]))
        low, high = float(xi[max(at - 1, 0)]), float(xi[min(at + 1, SCAN - 1)])
    return best


def record_of(model: Model, part: str) -> Any:
    """The bar, beam, link, base or tube of a part by its name in a verdict."""
    if part in model.bending:
        return model.bending[part]
    if part in model.whole.bars:
        return model.whole.bars[part]
    member, _, role = part.rpartition(".")
    return getattr(model.active[member], role)


def made_of(model: Model, part: str) -> tuple[Any, Any]:
    """Section and material of a part; None where it has none."""
    own = record_of(model, part)
    return model.section_of(own), model.material_of(own)


def constants(
    sheet: Sheet, model: Model, part: str, mark: str = "", *, bends: bool = True, stretches: bool = True, axes: str = "23"
) -> None:
    """Enter the constants of a part's section and material that its record has.

    mark : suffix of the symbols. bends : with the section moduli, of the axes about which it bends. stretches : with E.
    """
    section, material = made_of(model, part)
    of = f" of {part}" if mark else ""
    if section is not None:
        from kinetruss.report.document.inputs import worded

        words = worded(section)
        (I2, I3), (c2, c3) = section.second_moments, section.extreme_fibres
        sheet.give(f"A{mark}", f"area{of}", section.area, "m^2", words)
        for axis, I, c in (("", I2, c2),) if section.round else (("_2", I2, c3), ("_3", I3, c2)):
            about = f" about axis {axis[1:]}" if axis else ""
            modulus = bends and (not axis or axis[1:] in axes)
            if modulus or stretches:
                sheet.give(f"I{axis}{mark}", f"second moment of area{about}{of}", I, "m^4", words)
            if modulus:
                sheet.give(f"c{axis}{mark}", f"extreme fibre{' for bending' if axis else ''}{about}{of}", c, "m", words)
                sheet.step(f"W{axis}{mark}", f"section modulus{about}{of}", f"I{axis}{mark}/c{axis}{mark}", "m^3")
    if material is not None:
        source = material.source or "material of the model"
        if stretches:
            sheet.give(f"E{mark}", f"modulus of elasticity{of}", material.E, "Pa", source)
        if material.yield_strength is not None:
            sheet.give(f"S_y{mark}", f"yield strength{of}", material.yield_strength, "Pa", source)
