"""Worked checks of whole members: buckling by Euler or Johnson, and the interaction of compression and bending."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kinetruss import strength
from kinetruss.report.document.worked.place import Cut, constants, cuts, made_of
from kinetruss.report.document.worked.sheet import Sheet
from kinetruss.strength.verdict import beyond_euler

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Forces, Row

__all__ = ["beam_column_sheet", "buckling_sheet"]

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
    if sheet.values["n_b"] * sheet.values["P"] >= lowest:
        words = beyond_euler(sheet.values["n_b"] * sheet.values["P"], lowest, model.safety.buckling)
        sheet.notes.append(f"{words[0].upper()}{words[1:]}: the interaction has no finite value.")
        sheet.values["s"], sheet.units["s"] = math.inf, ""
    else:
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
    sheet.values["one"], sheet.units["one"] = 1.0, ""
    sheet.result, sheet.allowed = "s", "one"
    sheet.values["u"], sheet.units["u"] = sheet.values["s"], "%"
    return sheet


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
    ends = model.members[member].buckling
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
