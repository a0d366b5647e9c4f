"""Worked checks of yielding: nominal stresses, and von Mises' stress at the worst point of the section."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import strength
from kinetruss.report.document.worked.place import Cut, constants, cuts, largest_shear, made_of, without_round_off
from kinetruss.report.document.worked.sheet import Sheet

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces, Row

    Array = NDArray[np.float64]

__all__ = ["beam_yield_sheet", "yield_sheet"]

MECHANICS = "Timoshenko and Gere, Mechanics of Materials"
MISES = "von Mises: √(σ² + 3 τ²)"
POINTS = 721
PASSES = 40
WORST = "where the equivalent stress is largest"
LEVEL = 1e-6
"""Angle, rad, below which the worst point is that of the most bending: the stress differs by less than round-off."""


def yield_sheet(model: Model, forces: Forces, row: Row) -> Sheet:
    """Yielding of a bar or rod; forces : of the entry's sample."""
    sheet = Sheet(title=f"{row.part}: yield", row=row)
    constants(sheet, model, row.part, stretches=False, axes="23" if model.dim == 3 else "3")
    section, _ = made_of(model, row.part)
    there = cuts(model, forces, row.part, row.position)
    found = [_stress(model, row.part, cut) for cut in there]
    cut = there[0 if found[0] >= max(found) * (1 - 1e-7) else found.index(max(found))]  # section forces may jump here
    if section.round:
        _round(sheet, cut, section.shear_factor)
    else:
        _nominal(sheet, cut, section.shear_factor, space=model.dim == 3)
        (_box if section.kind == "rectangle" else _bound)(sheet)
    result = "sigma_v"
    if cut.torsion:
        _torsion(sheet, cut, section, largest_shear(model, forces, row.part))
        result = "sigma_t"
    _allowed(sheet, model)
    return sheet.close(result, "sigma_allow")


def _torsion(sheet: Sheet, cut: Cut, section: Any, shear: float) -> None:
    """Torsion of an arm or of an active member, added as a bound."""
    where = "section force of the run"
    sheet.give("T_t", "torque about the axis of the member", cut.torsion, "N m", where)
    sheet.give("J", "torsion constant", float(section.torsion_constant or math.nan), "m^4", "shape of the section")
    sheet.give("r_t", "arm of the largest shear stress of torsion", float(section.torsion_arm or math.nan), "m", "shape")
    sheet.give("V_m", "largest shear force along the part", shear, "N", where)
    sheet.step("tau_t", "shear stress of torsion", "abs(T_t)*r_t/J", "Pa", MECHANICS)
    sheet.step("tau_m", "largest shear stress of V", "k*V_m/A", "Pa", MECHANICS)
    bound = "bound: both shear stresses at the worst point"
    sheet.step("sigma_t", "equivalent stress with torsion", "sqrt(sigma_v**2 + 3*tau_t*(2*tau_m + tau_t))", "Pa", bound)


def _allowed(sheet: Sheet, model: Model) -> None:
    sheet.give("n_y", "safety factor on yielding", model.safety.yielding, "", "safety of the model")
    sheet.step("sigma_allow", "allowed stress", "S_y/n_y", "Pa", "yield strength over its safety factor")


def _nominal(sheet: Sheet, cut: Cut, factor: float, *, space: bool) -> None:
    """Nominal stresses about both axes; without axis 2 in the plane."""
    where = "section force of the run"
    sheet.give("T", "axial force, tension positive", cut.T, "N", where)
    sheet.give("k", "largest over mean shear stress", factor, "", "shape of the section")
    axes = (("3", cut.M3, "2", cut.V2), ("2", cut.M2, "3", cut.V3))[: 2 if space else 1]
    for axis, moment, across, shear in axes:
        sheet.give(f"M_{axis}", f"bending moment about axis {axis}", moment, "N m", where)
        sheet.give(f"V_{across}", f"shear force along axis {across}", shear, "N", where)
    sheet.step("sigma_a", "axial stress", "T/A", "Pa", MECHANICS)
    for axis, _, across, _ in axes:
        sheet.step(f"sigma_b{axis}", f"bending stress at the edge, axis {axis}", f"abs(M_{axis})/W_{axis}", "Pa", MECHANICS)
        sheet.step(f"tau_{across}", f"largest shear stress of V_{across}", f"k*abs(V_{across})/A", "Pa", MECHANICS)
    if not space:
        for name, unit in (("sigma_b2", "Pa"), ("tau_3", "Pa")):
            sheet.values[name], sheet.units[name] = 0.0, unit


def _round(sheet: Sheet, cut: Cut, factor: float) -> None:
    """A tube or rod: the worst point of the circumference, at the angle psi from the point of most bending."""
    where = "section force of the run"
    M, V = math.hypot(cut.M2, cut.M3), math.hypot(cut.V2, cut.V3)
    # components of the shear stress along the circumference at the point of most bending, and a quarter turn from it
    p, q = ((cut.V3 * cut.M2 - cut.V2 * cut.M3) / M, (cut.V2 * cut.M2 + cut.V3 * cut.M3) / M) if M else (V, 0.0)
    sheet.give("T", "axial force, tension positive", cut.T, "N", where)
    sheet.give("M", "bending moment, resultant of both axes", M, "N m", where)
    sheet.give("V_p", "shear force in the plane of bending", p, "N", where)
    sheet.give("V_q", "shear force across it", q, "N", where)
    sheet.give("k", "largest over mean shear stress", factor, "", "shape of the section")
    a = sheet.step("sigma_a", "axial stress", "T/A", "Pa", MECHANICS)
    b = sheet.step("sigma_b", "bending stress at the outer fibre", "M/W", "Pa", MECHANICS)
    tau_p = sheet.step("tau_p", "largest shear stress of V_p", "k*V_p/A", "Pa", MECHANICS)
    tau_q = sheet.step("tau_q", "largest shear stress of V_q", "k*V_q/A", "Pa", MECHANICS)
    psi = _highest(
        lambda x: (abs(a) + b * np.cos(x)) ** 2 + 3 * (tau_p * np.sin(x) + tau_q * np.cos(x)) ** 2, -math.pi, math.pi
    )
    if abs(psi) < LEVEL:
        psi = 0.0
    sheet.give("psi", "angle from the point of most bending to the worst point", psi, "rad", WORST)
    sheet.step("sigma", "normal stress there", "abs(sigma_a) + sigma_b*cos(psi)", "Pa", MECHANICS)
    sheet.step("tau", "shear stress there", "tau_p*sin(psi) + tau_q*cos(psi)", "Pa", MECHANICS)
    sheet.step("sigma_v", "equivalent stress", "sqrt(sigma**2 + 3*tau**2)", "Pa", MISES)


def _box(sheet: Sheet) -> None:
    """A rectangle: the worst point, at y and z of the half sides."""
    a, b2, b3, k2, k3 = (abs(sheet.values[name]) for name in ("sigma_a", "sigma_b2", "sigma_b3", "tau_2", "tau_3"))

    def equivalent(y: Array | float, z: Array | float) -> Array:
        return np.asarray((a + b3 * y + b2 * z) ** 2 + 3 * ((k2 * (1 - y**2)) ** 2 + (k3 * (1 - z**2)) ** 2))

    best = (-1.0, 0.0, 0.0)
    for corner in range(4):
        y, z = float(corner & 1), float(corner >> 1)
        for _ in range(PASSES):  # coordinate ascent
            y = _highest(lambda x, z=z: equivalent(x, z), 0.0, 1.0)  # type: ignore[misc]
            z = _highest(lambda x, y=y: equivalent(y, x), 0.0, 1.0)  # type: ignore[misc]
        best = max(best, (float(equivalent(y, z)), y, z))
    sheet.give("y", "place of the worst point along axis 2, of the half side", best[1], "", WORST)
    if sheet.values.get("M_2") is not None:
        sheet.give("z", "the same along axis 3", best[2], "", WORST)
        sheet.step("sigma", "normal stress there", "abs(sigma_a) + sigma_b3*y + sigma_b2*z", "Pa", MECHANICS)
        sheet.step("tau", "shear stress there", "sqrt((tau_2*(1 - y**2))**2 + (tau_3*(1 - z**2))**2)", "Pa", MECHANICS)
    else:
        sheet.step("sigma", "normal stress there", "abs(sigma_a) + sigma_b3*y", "Pa", MECHANICS)
        sheet.step("tau", "shear stress there", "tau_2*(1 - y**2)", "Pa", MECHANICS)
    sheet.step("sigma_v", "equivalent stress", "sqrt(sigma**2 + 3*tau**2)", "Pa", MISES)


def _bound(sheet: Sheet) -> None:
    """Any other section: all bending and all shear at one point, a bound."""
    space = "M_2" in sheet.values
    more = " + sigma_b2" if space else ""
    sheet.step("sigma", "normal stress, both edges at one point", f"abs(sigma_a) + sigma_b3{more}", "Pa", "bound")
    sheet.step("tau", "shear stress", "sqrt(tau_2**2 + tau_3**2)" if space else "abs(tau_2)", "Pa", "bound")
    sheet.step("sigma_v", "equivalent stress", "sqrt(sigma**2 + 3*tau**2)", "Pa", MISES)


def _stress(model: Model, part: str, cut: Cut) -> float:
    """A measure by which section forces on both sides of a jump are compared: the bound of von Mises' stress, Pa."""
    section, _ = made_of(model, part)
    (I2, I3), (c2, c3) = section.second_moments, section.extreme_fibres
    b2, b3 = abs(cut.M2) * c3 / I2, abs(cut.M3) * c2 / I3
    bending = math.hypot(b2, b3) if section.round else b2 + b3
    shear = section.shear_factor * math.hypot(cut.V2, cut.V3) / section.area
    return math.hypot(abs(cut.T) / section.area + bending, math.sqrt(3) * shear)


def _highest(function: Callable[[Array], Array], low: float, high: float) -> float:
    """Where a function of one variable is largest: a scan, then smaller and smaller scans around the best point."""
    for _ in range(6):
        x = np.linspace(low, high, POINTS)
        values = function(x)
        best = int(np.argmax(values))
        step = x[1] - x[0]
        low, high = max(low, x[best] - step), min(high, x[best] + step)
    ends = np.array([low, high, x[best]])
    return float(ends[int(np.argmax(function(ends)))])


def beam_yield_sheet(model: Model, forces: Forces, row: Row) -> Sheet:
    """Yielding of an elastic beam: all shear at the point of the largest normal stress, a bound."""
    sheet = Sheet(title=f"{row.part}: yield", row=row)
    constants(sheet, model, row.part, stretches=False, axes="23" if model.dim == 3 else "3")
    section, _ = made_of(model, row.part)
    found = strength.beams(model, forces, stations=[row.station]).sel(beam=row.part).isel(station=0, time=0)
    where = "section force of the run"
    V = float(np.linalg.norm(np.atleast_1d(found["section_V"].values)))
    twist = float(found["torsion"]) if "torsion" in found else 0.0
    *bending, twist = without_round_off(*map(float, found["section_M"].values), twist)
    moment = dict(zip(map(str, found["moment"].values), bending, strict=True))
    sheet.give("T", "axial force, tension positive", float(found["section_T"]), "N", where)
    sheet.give("V", "shear force, resultant", V, "N", where)
    sheet.give("k", "largest over mean shear stress", section.shear_factor, "", "shape of the section")
    sheet.step("sigma_a", "axial stress", "abs(T)/A", "Pa", MECHANICS)
    if section.round:
        sheet.give("M", "bending moment, resultant", math.hypot(*moment.values()), "N m", where)
        sheet.step("sigma_b", "bending stress", "M/W", "Pa", MECHANICS)
        normal = "sigma_a + sigma_b"
    else:
        for axis, value in moment.items():
            sheet.give(f"M_{axis}", f"bending moment about axis {axis}", value, "N m", where)
            sheet.step(f"sigma_b{axis}", f"bending stress, axis {axis}", f"abs(M_{axis})/W_{axis}", "Pa", MECHANICS)
        normal = " + ".join(["sigma_a", *(f"sigma_b{axis}" for axis in moment)])
    sheet.step("sigma", "largest normal stress", normal, "Pa", MECHANICS)
    shear = "k*V/A"
    if "torsion" in found:
        sheet.give("T_t", "torque about the beam's axis", twist, "N m", where)
        sheet.give("J", "torsion constant", float(section.torsion_constant or math.nan), "m^4", "shape of the section")
        sheet.give("r_t", "arm of the largest shear stress of torsion", float(section.torsion_arm or math.nan), "m", "shape")
        shear += " + abs(T_t)*r_t/J"
    sheet.step("tau", "shear stress", shear, "Pa", "bound: at the same point")
    sheet.step("sigma_v", "equivalent stress", "sqrt(sigma**2 + 3*tau**2)", "Pa", MISES)
    _allowed(sheet, model)
    return sheet.close("sigma_v", "sigma_allow")
