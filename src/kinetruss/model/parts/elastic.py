"""Stiffness and natural length of elastic bars and cables, and faults of their constitutive laws."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData
    from kinetruss.model.parts.members import Bar

__all__ = ["ELASTIC_KINDS", "elastic_faults", "natural_length", "stiffness"]

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
