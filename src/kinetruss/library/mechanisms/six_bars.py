"""Six-bar linkages with one freedom: Watt's, whose ternary links meet, and Stephenson's, whose ternary links do not."""

from __future__ import annotations

import cmath
import math
from typing import Any

from kinetruss.library._builder import builder, named
from kinetruss.library._placing import bars_between, does_not_close, meet, on_link, places, refuse
from kinetruss.library.materials import MATERIALS, STEEL_S235
from kinetruss.model import (
    Angle,
    AngleDrive,
    ConstantRate,
    GravityVector,
    Length,
    Material,
    Model,
    Name,
    PositiveLength,
    Rectangle,
    Run,
)
from kinetruss.model.parts import Section

__all__ = ["stephenson_six_bar", "watt_six_bar"]

FLAT = 1e-3
"""A point nearer to the line of its link than this fraction of the link is held to second order only."""


@builder("mechanisms.watt_six_bar")
def watt_six_bar(
    *,
    ground: PositiveLength = 0.4,
    crank: PositiveLength = 0.1,
    coupler: PositiveLength = 0.35,
    rocker: PositiveLength = 0.25,
    joint: tuple[Length, Length] = (0.15, -0.15),
    link: PositiveLength = 0.4,
    output: PositiveLength = 0.3,
    output_at: tuple[Length, Length] = (0.85, 0.0),
    angle: Angle = math.pi / 2,
    section: Section = Rectangle(width=0.020, height=0.005),
    material: Material | Name = STEEL_S235,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Watt's six-bar linkage",
) -> Model:
    """A four-bar A-B-C-D whose rocker D-C-E drives a second one D-E-F-G: the ternary links, ground and rocker, meet in D.

    A = (0, 0), D = (ground, 0) and G = `output_at` are fixed. Bars ``A-B``, ``B-C``, ``D-C``, ``D-E``, ``C-E`` (with D-C the
    ternary rocker), ``E-F``, ``G-F``; drive ``motor`` turns the crank A-B, run ``turn`` once a second.

    Parameters
    ----------
    ground, crank, coupler, rocker : of the first four-bar, m. joint : E on the rocker, along D -> C and to its left, m.
    link, output : lengths of E-F and G-F, m. output_at : G, m. F lies on the left of E to G.
    angle : of the crank from +x at the start, rad; C lies on the left of B to D.
    section, material : of all bars. gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters; loops that do not close at this angle; E on the line D-C.

    Examples
    --------
    >>> model = watt_six_bar()
    >>> len(model.bars), [round(x, 6) for x in model.nodes["F"].at]
    (7, [0.880446, 0.298451])
    """
    nodes = _first_loop(ground, crank, coupler, rocker, angle)
    nodes["E"] = _third(nodes["D"], nodes["C"], joint, "joint")
    return _closed(title, nodes, "D", link, output, complex(*output_at), (section, material, gravity))


@builder("mechanisms.stephenson_six_bar")
def stephenson_six_bar(
    *,
    ground: PositiveLength = 0.4,
    crank: PositiveLength = 0.1,
    coupler: PositiveLength = 0.35,
    rocker: PositiveLength = 0.25,
    joint: tuple[Length, Length] = (0.2, 0.2),
    link: PositiveLength = 0.4,
    output: PositiveLength = 0.35,
    output_at: tuple[Length, Length] = (0.65, 0.2),
    angle: Angle = math.pi / 2,
    section: Section = Rectangle(width=0.020, height=0.005),
    material: Material | Name = STEEL_S235,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Stephenson's six-bar linkage",
) -> Model:
    """A four-bar A-B-C-D whose coupler B-C-E drives a dyad E-F-G (Stephenson III): the ternary links do not meet.

    A = (0, 0), D = (ground, 0) and G = `output_at` are fixed. Bars ``A-B``, ``B-C``, ``D-C``, ``B-E``, ``C-E`` (with B-C the
    ternary coupler), ``E-F``, ``G-F``; drive ``motor`` turns the crank A-B, run ``turn`` once a second.

    Parameters
    ----------
    joint : E on the coupler, along B -> C and to its left, m. The others as in `watt_six_bar`.

    Raises
    ------
    ModelError : faults of the parameters; loops that do not close at this angle; E on the line B-C.

    Examples
    --------
    >>> model = stephenson_six_bar()
    >>> len(model.bars), sorted(model.fixed)
    (7, ['A', 'D', 'G'])
    """
    nodes = _first_loop(ground, crank, coupler, rocker, angle)
    nodes["E"] = _third(nodes["B"], nodes["C"], joint, "joint")
    return _closed(title, nodes, "B", link, output, complex(*output_at), (section, material, gravity))


def _first_loop(ground: float, crank: float, coupler: float, rocker: float, angle: float) -> dict[str, complex]:
    B, D = cmath.rect(crank, angle), complex(ground)
    C = meet(B, coupler, D, rocker)
    if C is None:
        raise does_not_close("coupler", angle)
    return {"A": 0j, "B": B, "C": C, "D": D}


def _third(first: complex, second: complex, at: tuple[float, float], parameter: str) -> complex:
    """The third point of a ternary link."""
    length = abs(second - first)
    if abs(at[1]) < FLAT * length:
        text = f"{at[1]:g} m beside a link of {length:g} m: three points in one line are stiff only to second order."
        raise refuse(parameter, text, f"Move the point off the line, e.g. ({at[0]:g}, {0.3 * length:.3g}).")
    return on_link(first, second, at)


def _closed(
    title: str, nodes: dict[str, complex], foot: str, link: float, output: float, G: complex, own: tuple[Any, Any, Any]
) -> Model:
    F = meet(nodes["E"], link, G, output)
    if F is None:
        raise does_not_close("link", cmath.phase(nodes["B"]))
    pairs = [("A", "B"), ("B", "C"), ("D", "C"), (foot, "E"), ("C", "E"), ("E", "F"), ("G", "F")]
    section, material, gravity = own
    return Model(
        title=title,
        nodes=places(nodes | {"F": F, "G": G}),
        fixed=["A", "D", "G"],
        section=section,
        material=named(MATERIALS, material, "material"),
        bars=bars_between(pairs, mass=None),
        drives={"motor": AngleDrive("A-B")},
        gravity=gravity,
        runs={"turn": Run(trajectory=ConstantRate(rates={"motor": 2 * math.pi}, duration=1.0))},
    )
