"""Worked checks of members: yielding at the worst point of a section, buckling, interaction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import strength
from kinetruss.model.links import column_ends, length_along
from kinetruss.report.document.places import Cut, constants, cuts, largest_shear, made_of, without_round_off
from kinetruss.report.document.sheets import Sheet
from kinetruss.strength.beam_verdict import beam_histories, beam_parts
from kinetruss.strength.critical_loads import beyond_euler

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces, Row

    Array = NDArray[np.float64]


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


# Worked checks of whole members: buckling by Euler or Johnson, and the interaction of compression and bending.

EULER = "Euler's load"
JOHNSON = "Johnson's parabola (Shigley, Mechanical Engineering Design, columns)"
AISC = "AISC, Allowable Stress Design (1989), eq. H1-1"


def buckling_sheet(model: Model, forces: Forces, row: Row) -> Sheet:
    """Compression of a member against its critical load; forces : of the entry's sample."""
    sheet = Sheet(title=f"{row.part}: buckling", row=row)
    # the compression of a member is that of the part that carries it at this place
    cut = max((one for part in _parts(model, row.part) for one in cuts(model, forces, part, row.position)), key=lambda c: -c.T)
    sheet.give("P", "largest compression along the member", -cut.T, "N", "section force of the run, minus the tension")
    _critical(sheet, model, row.part, cut.length)
    sheet.step("P_allow", "allowed compression", "P_cr/n_b", "N", "critical load over its safety factor")
    return sheet.close("P", "P_allow")


def beam_column_sheet(model: Model, forces: Forces, row: Row) -> Sheet:
    """Interaction of compression and bending of a member; forces : of the entry's sample."""
    sheet = Sheet(title=f"{row.part}: beam-column", row=row)
    here = strength.utilisation(model, forces).sel(part=row.part).isel(time=0)
    push = here.sel(rule="buckling")
    squeezed = [one for part in _parts(model, row.part) for one in cuts(model, forces, part, float(push["position"]))]
    cut = max(squeezed, key=lambda one: -one.T)
    sheet.give("P", "largest compression along the member", -cut.T, "N", "section force of the run, minus the tension")
    _critical(sheet, model, row.part, cut.length, bends=True)
    sheet.give("C_m", "moment factor", 1.0, "", "loads across a member with pinned ends")
    sheet.give("n_y", "safety factor on yielding", model.safety.yielding, "", "safety of the model")
    choices = [
        (_bending(model, one), one) for part in _parts(model, row.part) for one in cuts(model, forces, part, row.position)
    ]
    bent = max(choices, key=lambda pair: pair[0])[1]
    mark = _mark(model, row.part, bent.part)
    section, _ = made_of(model, bent.part)
    lowest = min(sheet.values[name] for name in ("P_e", "P_e2", "P_e3") if name in sheet.values)
    if not _beyond(sheet, lowest):
        terms = ["n_b*P/P_cr"]
        axes = {"": math.hypot(bent.M2, bent.M3)} if section.round else {"_2": bent.M2, "_3": bent.M3}
        if model.dim == 2:
            axes.pop("_2", None)
        for axis, moment in axes.items():
            words = f"about axis {axis[1:]}" if axis else "resultant of both axes"
            about = "P_e" if not axis else f"P_e{axis[1:]}"
            sheet.give(f"M{axis}", f"bending moment, {words}, of {bent.part}", abs(moment), "N m", "section force of the run")
            sheet.step(f"M_allow{axis}", f"allowed bending moment of {bent.part}", f"S_y{mark}/n_y*W{axis}{mark}", "N m", AISC)
            terms.append(f"C_m*M{axis}/((1 - n_b*P/{about})*M_allow{axis})")
        sheet.step("s", "interaction", " + ".join(terms), "", AISC)
    return _closed(sheet)


def link_buckling_sheet(model: Model, forces: Forces, row: Row) -> Sheet:
    """Compression of a straight link against its critical load; forces : of the entry's sample."""
    sheet = Sheet(title=f"{row.part}: buckling", row=row)
    _pushed(sheet, model, forces, row.part)
    _critical(sheet, model, row.part, length_along(model, model.links[row.part]))
    sheet.step("P_allow", "allowed compression", "P_cr/n_b", "N", "critical load over its safety factor")
    return sheet.close("P", "P_allow")


def link_beam_column_sheet(model: Model, forces: Forces, row: Row) -> Sheet:
    """Compression and bending of a straight link; forces : of the entry's sample."""
    sheet = Sheet(title=f"{row.part}: beam-column", row=row)
    _pushed(sheet, model, forces, row.part)
    _critical(sheet, model, row.part, length_along(model, model.links[row.part]), bends=True)
    found = strength.beams(model, forces, stations=[row.station]).sel(beam=row.part).isel(station=0, time=0)
    bent = dict(zip(map(str, found["moment"].values), map(float, found["section_M"].values), strict=True))
    section, _ = made_of(model, row.part)
    axes = {"": math.hypot(*bent.values())} if section.round else {f"_{axis}": abs(M) for axis, M in bent.items()}
    lowest = min(sheet.values[f"P_e{axis[1:]}"] for axis in axes)
    if not _beyond(sheet, lowest):
        terms = ["n_b*P/P_cr"]
        sheet.give("C_m", "moment factor", 1.0, "", "loads across a member")
        sheet.give("n_y", "safety factor on yielding", model.safety.yielding, "", "safety of the model")
        for axis, moment in axes.items():
            words = f"about axis {axis[1:]}" if axis else "resultant of both axes"
            sheet.give(f"M{axis}", f"bending moment, {words}", moment, "N m", "section force of the run")
            sheet.step(f"M_allow{axis}", "allowed bending moment", f"S_y/n_y*W{axis}", "N m", AISC)
            terms.append(f"C_m*M{axis}/((1 - n_b*P/P_e{axis[1:]})*M_allow{axis})")
        sheet.step("s", "interaction", " + ".join(terms), "", AISC)
    return _closed(sheet)


def _beyond(sheet: Sheet, lowest: float) -> bool:
    """Whether the compression times its safety factor reaches the lowest of Euler's loads, N: the interaction is infinite."""
    push = sheet.values["n_b"] * sheet.values["P"]
    if push < lowest:
        return False
    words = beyond_euler(push, lowest, sheet.values["n_b"])
    sheet.notes.append(f"{words[0].upper()}{words[1:]}: the interaction has no finite value.")
    sheet.values["s"], sheet.units["s"] = math.inf, ""
    return True


def _closed(sheet: Sheet) -> Sheet:
    """The sheet of an interaction s, of 1."""
    sheet.values["one"], sheet.units["one"] = 1.0, ""
    sheet.result, sheet.allowed = "s", "one"
    sheet.values["u"], sheet.units["u"] = sheet.values["s"], "%"
    return sheet


def _pushed(sheet: Sheet, model: Model, forces: Forces, link: str) -> None:
    """Enter the largest compression along a link."""
    P = float(beam_histories(model, forces)["compression"][0][0, beam_parts(model).index(link)])
    sheet.give("P", "largest compression along the link", P, "N", "section force of the run, minus the tension")


def _parts(model: Model, member: str) -> list[str]:
    return [f"{member}.base", f"{member}.tube"] if member in model.active else [member]


def _mark(model: Model, member: str, part: str) -> str:
    """Suffix of the symbols of a part of an active member, if both of its parts have a section."""
    both = [one for one in _parts(model, member) if _known(model, one)]
    return f"_{part.rpartition('.')[2]}" if len(both) > 1 else ""


def _known(model: Model, part: str) -> bool:
    return None not in made_of(model, part)


def _critical(sheet: Sheet, model: Model, member: str, length: float, *, bends: bool = False) -> None:
    """The critical load of a member: of the weaker of its parts that have a section. bends : section moduli are needed."""
    known = [part for part in _parts(model, member) if _known(model, part)]
    ends = column_ends(model, member) if member in model.links else model.whole.members[member].buckling
    sheet.give("L", "length of the member at this instant", length, "m", "pose of the run")
    sheet.give("C", "end-condition constant", strength.end_condition(ends), "", f"ends: {ends}")
    sheet.give("n_b", "safety factor on buckling", model.safety.buckling, "", "safety of the model")
    loads = []
    for part in known:
        mark = _mark(model, member, part)
        constants(sheet, model, part, mark, bends=bends, axes="3" if bends and model.dim == 2 else "23")
        loads.append(_load(sheet, model, part, mark))
    if len(known) == 1:
        return
    # the weaker of base and tube, over the whole length
    for name, words in (("P_cr", "critical load"), ("P_e", EULER), ("P_e2", "of axis 2"), ("P_e3", "of axis 3")):
        named = [f"{name}_{part.rpartition('.')[2]}" for part in known]
        if all(one in sheet.values for one in named):
            sheet.step(name, f"{words}, the weaker part", f"min({', '.join(named)})", "N", "the real member is stepped")


def _load(sheet: Sheet, model: Model, part: str, mark: str) -> str:
    """Critical load of one part over the length of the member; the symbol."""
    section, _ = made_of(model, part)
    of = f" of {part}" if mark else ""
    if section.round:
        I, euler = f"I{mark}", f"P_e{mark}"
    else:
        for axis in "23":
            formula = f"C*pi**2*E{mark}*I_{axis}{mark}/L**2"
            sheet.step(f"P_e{axis}{mark}", f"Euler's load, bending about axis {axis}{of}", formula, "N", EULER)
        weak = "2" if section.second_moments[0] <= section.second_moments[1] else "3"
        I, euler = f"I_{weak}{mark}", f"P_e{weak}{mark}"
    sheet.step(f"r{mark}", f"radius of gyration{of}", f"sqrt({I}/A{mark})", "m")
    slender = sheet.step(f"lambda{mark}", f"slenderness{of}", f"L/r{mark}", "")
    if section.round:
        sheet.step(euler, f"Euler's load{of}", f"C*pi**2*E{mark}*{I}/L**2", "N", EULER)
    load = f"P_cr{mark}"
    if f"S_y{mark}" in sheet.values:
        limit = sheet.step(
            f"lambda_t{mark}", f"slenderness where both formulas meet{of}", f"pi*sqrt(2*C*E{mark}/S_y{mark})", "", JOHNSON
        )
        if slender < limit:
            squash = f"A{mark}*S_y{mark}"
            sheet.step(load, f"critical load{of}: λ < λ_t, Johnson", f"{squash}*(1 - {squash}/(4*{euler}))", "N", JOHNSON)
            return load
        sheet.step(load, f"critical load{of}: λ ≥ λ_t, Euler", euler, "N", EULER)
        return load
    sheet.step(load, f"critical load{of}: Euler, no yield strength", euler, "N", EULER)
    return load


def _bending(model: Model, cut: Cut) -> float:
    """Bending over its capacity, by which parts and sides of a jump are compared; -1 if the part has no section."""
    if not _known(model, cut.part):
        return -1.0
    section, material = made_of(model, cut.part)
    (I2, I3), (c2, c3) = section.second_moments, section.extreme_fibres
    b2, b3 = abs(cut.M2) * c3 / I2, abs(cut.M3) * c2 / I3
    bending = math.hypot(b2, b3) if section.round else b2 + b3
    return bending / (material.yield_strength or math.nan)
