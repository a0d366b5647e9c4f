"""Four-bars, chains of them, slider-cranks, and six-bar linkages with one freedom."""

from __future__ import annotations

import cmath
import math
from typing import Annotated, Any

from pydantic import Field

from kinetruss.library.building import Turning, builder, named
from kinetruss.library.materials import MATERIALS, STEEL_S235
from kinetruss.library.placing import bars_between, does_not_close, meet, on_link, places, point, refuse
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import (
    Angle,
    AngleDrive,
    Bar,
    ConstantRate,
    Count,
    GravityVector,
    Length,
    Mass,
    Material,
    Model,
    Name,
    Node,
    PositiveLength,
    Rectangle,
    Run,
)
from kinetruss.model.sections import Section

Loops = Annotated[Count, Field(le=MOST_ENTRIES // 2 - 1)]
"""Loops of two bars each, and one more bar."""


@builder("mechanisms.four_bar")
def four_bar(
    *,
    ground: PositiveLength = 0.4,
    crank: PositiveLength = 0.1,
    coupler: PositiveLength = 0.35,
    rocker: PositiveLength = 0.25,
    angle: Angle = math.pi / 2,
    section: Section = Rectangle(width=0.020, height=0.005),
    material: Material | Name = STEEL_S235,
    coupler_mass: Mass = 0.0,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Four-bar linkage",
) -> Model:
    """A crank A-B, a coupler B-C and a rocker D-C over the ground A-D on the x axis; drive ``motor`` turns the crank.

    Parameters
    ----------
    ground, crank, coupler, rocker : lengths, m. The crank makes full turns if the crank is the shortest link and the shortest
        and longest together are shorter than the other two (Grashof).
    angle : of the crank from +x at the start, rad; C lies on the left of B to D, the open linkage.
    section, material : of the three bars; heights lie in the plane.
    coupler_mass : lumped at C, kg.
    gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters; lengths that do not close at this angle.

    Examples
    --------
    >>> model = four_bar(angle="90 deg")
    >>> [round(x, 6) for x in model.nodes["C"].at]
    [0.321869, 0.237478]
    """
    b = cmath.rect(crank, angle)
    c = meet(b, coupler, complex(ground), rocker)
    if c is None:
        raise does_not_close("coupler", angle, "Lengthen coupler or rocker, or turn the crank.")
    return Model(
        title=title,
        nodes={"A": (0.0, 0.0), "B": point(b), "C": Node(at=point(c), mass=coupler_mass), "D": (ground, 0.0)},
        fixed=["A", "D"],
        section=section,
        material=named(MATERIALS, material, "material"),
        bars={"crank": Bar(ends=("A", "B")), "coupler": Bar(ends=("B", "C")), "rocker": Bar(ends=("D", "C"))},
        drives={"motor": AngleDrive("crank")},
        gravity=gravity,
    )


@builder("mechanisms.n_four_bar")
def n_four_bar(
    loops: Loops = 2,
    *,
    side: PositiveLength = 1.0,
    mass: Mass = 1.0,
    angle: Angle = 0.0,
    rate: Turning = 1.0,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "",
) -> Model:
    """A row of square four-bars that share their sides: `loops` windows, the A02 problem of the IFToMM library.

    Nodes ``A0`` ... ``AN`` are fixed on the x axis, ``B0`` ... ``BN`` are above them; bars ``post0`` ... ``postN`` are A-B,
    ``beam1`` ... ``beamN`` join neighbours B. One degree of freedom, and singular positions with all bars on one line.

    Parameters
    ----------
    loops : number of loops, N. side : length of every bar, m. mass : of every bar, uniform, kg.
    angle, rate : of the posts at the start, from upright, towards +x, rad and rad/s.
    gravity : m/s^2; None for none.

    Notes
    -----
    theta'' = (g/side) ((N + 1)/2 + N)/((N + 1)/3 + N) sin theta, whose solution from upright with the rate w is
    theta = 2 am(w t/2 | -4 k/w^2), k the factor before sin theta.

    Raises
    ------
    ModelError : faults of the parameters.

    Source
    ------
    IFToMM library of computational benchmark problems, A02; M. Gonzalez, D. Dopico, U. Lugris, J. Cuadrado, Multibody
    System Dynamics 16 (2006) 179-190.

    Examples
    --------
    >>> model = n_four_bar(loops=40)
    >>> len(model.bars), model.velocities["B0"][0]
    (81, 1.0)
    """
    top = side * math.sin(angle), side * math.cos(angle)
    speed = side * rate * math.cos(angle), -side * rate * math.sin(angle)
    posts, beams = range(loops + 1), range(1, loops + 1)
    return Model(
        title=title or f"Four-bar with {loops} windows",
        nodes={f"A{k}": (k * side, 0.0) for k in posts} | {f"B{k}": (k * side + top[0], top[1]) for k in posts},
        fixed=[f"A{k}" for k in posts],
        bars={f"post{k}": Bar(ends=(f"A{k}", f"B{k}"), mass=mass, length=side) for k in posts}
        | {f"beam{k}": Bar(ends=(f"B{k - 1}", f"B{k}"), mass=mass, length=side) for k in beams},
        velocities={f"B{k}": speed for k in posts} if rate else {},
        gravity=gravity,
    )


@builder("mechanisms.slider_crank")
def slider_crank(
    *,
    crank: PositiveLength = 0.1,
    rod: PositiveLength = 0.3,
    offset: Length = 0.0,
    angle: Angle = math.pi / 2,
    rate: Turning = 0.0,
    crank_mass: Mass = 1.0,
    rod_mass: Mass = 2.0,
    slider_mass: Mass = 3.0,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Slider-crank",
) -> Model:
    """A crank O-P about the origin, a connecting rod P-S and a slider S on the line y = `offset`.

    Drive ``motor`` turns the crank; a force on the slider is a load on S.

    Parameters
    ----------
    crank, rod : lengths, m. offset : of the slider's line from the crank's axis, m.
    angle, rate : of the crank at the start, from +x, rad and rad/s; S lies on the far side, x > 0.
    crank_mass, rod_mass : uniform bars, kg. slider_mass : lumped at S, kg.
    gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters; a rod too short to reach the slider's line at this angle.

    Examples
    --------
    >>> model = slider_crank(angle=0)
    >>> [round(x, 12) for x in model.nodes["S"].at]
    [0.4, 0.0]
    """
    p = crank * math.cos(angle), crank * math.sin(angle)
    s = p[0] + _reach(rod, p[1] - offset), offset
    turn = -rate * p[1], rate * p[0]
    slide = turn[0] - turn[1] * (p[1] - offset) / (s[0] - p[0])
    return Model(
        title=title,
        nodes={"O": (0.0, 0.0), "P": p, "S": Node(at=s, mass=slider_mass)},
        fixed={"O": "xy", "S": "y"},
        bars={
            "crank": Bar(ends=("O", "P"), mass=crank_mass, length=crank),
            "rod": Bar(ends=("P", "S"), mass=rod_mass, length=rod),
        },
        velocities={"P": turn, "S": (slide, 0.0)} if rate else {},
        drives={"motor": AngleDrive("crank")},
        gravity=gravity,
    )


@builder("mechanisms.spatial_slider_crank")
def spatial_slider_crank(
    *,
    crank: PositiveLength = 0.08,
    rod: PositiveLength = 0.3,
    axis: tuple[Length, Length] = (0.1, 0.12),
    angle: Angle = 0.0,
    rate: Turning = 6.0,
    crank_mass: Mass = 0.12,
    rod_mass: Mass = 0.5,
    slider_mass: Mass = 2.0,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    title: str = "Spatial slider-crank",
) -> Model:
    """A crank that turns about an axis along x, a rod with ball joints, a slider S on the x axis.

    The crank is bar O-P in the plane x = 0, where P is held; the rod is bar P-S.

    Parameters
    ----------
    crank, rod : lengths, m. axis : (y, z) of the crank's axis, m.
    angle, rate : of the crank at the start, from +z, towards -y (right-handed about +x), rad and rad/s; S lies at x > 0.
    crank_mass, rod_mass : uniform bars, kg. slider_mass : lumped at S, kg.
    gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters; a rod too short to reach the slider's line at this angle.

    Source
    ------
    Dimensions and total masses of E. J. Haug, Computer-Aided Kinematics and Dynamics of Mechanical Systems (1989), whose
    bodies are not thin bars.

    Examples
    --------
    >>> model = spatial_slider_crank()
    >>> [round(x, 12) for x in model.nodes["S"].at]
    [0.2, 0.0, 0.0]
    """
    y, z = axis[0] - crank * math.sin(angle), axis[1] + crank * math.cos(angle)
    reach = _reach(rod, math.hypot(y, z))
    turn = -rate * crank * math.cos(angle), -rate * crank * math.sin(angle)
    slide = -(y * turn[0] + z * turn[1]) / reach
    return Model(
        title=title,
        nodes={"O": (0.0, *axis), "P": (0.0, y, z), "S": Node(at=(reach, 0.0, 0.0), mass=slider_mass)},
        fixed={"O": "xyz", "P": "x", "S": "yz"},
        bars={
            "crank": Bar(ends=("O", "P"), mass=crank_mass, length=crank),
            "rod": Bar(ends=("P", "S"), mass=rod_mass, length=rod),
        },
        velocities={"P": (0.0, *turn), "S": (slide, 0.0, 0.0)} if rate else {},
        gravity=gravity,
    )


def _reach(rod: float, off: float) -> float:
    """Distance along the slider's line that a rod bridges from a point `off` that line."""
    if rod <= abs(off):
        mend = f"At this angle it must be longer than {abs(off):g} m."
        raise refuse("rod", f"{rod:g} m does not reach the slider's line.", mend)
    return math.sqrt(rod**2 - off**2)


# Six-bar linkages with one freedom: Watt's, whose ternary links meet, and Stephenson's, whose ternary links do not.

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
