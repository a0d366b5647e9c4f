"""Chains of pendulums, and mechanisms with springs whose equilibrium has a closed form."""

from __future__ import annotations

import math
from itertools import accumulate
from typing import Annotated, Literal

from pydantic import Field

from kinetruss.library.building import Turning, builder
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import Angle, Bar, Count, Force, GravityVector, Mass, Model, NodalForce, Node, Of, PositiveLength

Link = tuple[float, float, float, float, float]
Links = Annotated[Count, Field(le=MOST_ENTRIES - 1)]


@builder("mechanisms.pendulum")
def pendulum(
    *,
    length: PositiveLength = 1.0,
    bob: Mass = 1.0,
    mass: Mass = 0.0,
    angle: Angle = math.pi / 2,
    rate: Turning = 0.0,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Pendulum",
) -> Model:
    """A bob at the end of a rigid bar: node ``O`` is fixed, bar ``link1`` carries node ``P1``.

    Parameters
    ----------
    length : m. bob : lumped at the end, kg. mass : of the bar, uniform, kg.
    angle, rate : of the bar at the start, from hanging, towards +x, rad and rad/s.
    gravity : m/s^2; None for none.

    Notes
    -----
    A massless bar (the default) has the period 4 sqrt(l/g) K(sin(angle/2)), K the complete elliptic integral.

    Raises
    ------
    ModelError : faults of the parameters.

    Examples
    --------
    >>> model = pendulum(angle="-90 deg")
    >>> [round(x, 12) for x in model.nodes["P1"].at]
    [-1.0, -0.0]
    """
    return _chain([(length, mass, bob, angle, rate)], gravity, title)


@builder("mechanisms.double_pendulum")
def double_pendulum(
    *,
    lengths: tuple[PositiveLength, PositiveLength] = (1.0, 1.0),
    bobs: tuple[Mass, Mass] = (1.0, 1.0),
    masses: tuple[Mass, Mass] = (0.0, 0.0),
    angles: tuple[Angle, Angle] = (math.pi / 2, math.pi / 2),
    rates: tuple[Turning, Turning] = (0.0, 0.0),
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Double pendulum",
) -> Model:
    """Two bars in a chain with bobs; released from high up, it is the best-known chaotic mechanism.

    Node ``O`` is fixed, bars ``link1`` O-P1 and ``link2`` P1-P2.

    Parameters
    ----------
    lengths : m. bobs : lumped at P1 and P2, kg. masses : of the bars, uniform, kg.
    angles, rates : of the bars at the start, each from hanging, towards +x, rad and rad/s.
    gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters.

    Examples
    --------
    >>> model = double_pendulum(angles=("90 deg", "180 deg"))
    >>> [round(x, 12) for x in model.nodes["P2"].at]
    [1.0, 1.0]
    """
    return _chain(list(zip(lengths, masses, bobs, angles, rates, strict=True)), gravity, title)


@builder("mechanisms.n_pendulum")
def n_pendulum(
    links: Links = 3,
    *,
    length: PositiveLength = 1.0,
    bob: Mass = 0.0,
    mass: Mass = 1.0,
    angle: Angle = math.pi / 2,
    rate: Turning = 0.0,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "",
) -> Model:
    """A straight chain of equal links, by default a triple pendulum of uniform rods, horizontal and at rest.

    Node ``O`` is fixed, bars ``link1`` ... ``linkN`` end in nodes ``P1`` ... ``PN``.

    Parameters
    ----------
    links : how many. length : of each, m. bob : lumped at the end of each, kg. mass : of each bar, uniform, kg.
    angle, rate : of all bars at the start, from hanging, towards +x, rad and rad/s.
    gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters.

    Examples
    --------
    >>> list(n_pendulum(links=2).bars)
    ['link1', 'link2']
    """
    return _chain([(length, mass, bob, angle, rate)] * links, gravity, title or f"Pendulum of {links} links")


def _chain(links: list[Link], gravity: GravityVector | None, title: str) -> Model:
    """Nodes and velocities follow from (length, mass, bob, angle, rate) of every link."""
    at = list(accumulate((l * math.sin(a) for l, _, _, a, _ in links)))
    down = list(accumulate((-l * math.cos(a) for l, _, _, a, _ in links)))
    right = list(accumulate((l * w * math.cos(a) for l, _, _, a, w in links)))
    up = list(accumulate((l * w * math.sin(a) for l, _, _, a, w in links)))
    names = ["O", *(f"P{k}" for k in range(1, len(links) + 1))]
    moving = any(w for *_, w in links)
    return Model(
        title=title,
        nodes={"O": (0.0, 0.0)}
        | {name: Node(at=(x, y), mass=link[2]) for name, x, y, link in zip(names[1:], at, down, links, strict=True)},
        fixed=["O"],
        bars={
            f"link{k}": Bar(ends=(names[k - 1], names[k]), mass=link[1], length=link[0])
            for k, link in enumerate(links, start=1)
        },
        velocities={name: v for name, *v in zip(names[1:], right, up, strict=True)} if moving else {},
        gravity=gravity,
    )


# Mechanisms and trusses with springs whose equilibrium has a closed form.

Stiffness = Annotated[float, Of("stiffness")]


@builder("mechanisms.rhombus_with_spring")
def rhombus_with_spring(
    *,
    side: PositiveLength = 1.0,
    mass: Mass = 1.0,
    stiffness: Stiffness = 60.0,
    natural_length: PositiveLength = 1.2,
    angle: Angle = math.pi / 3,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Rhombus with a spring",
) -> Model:
    """Three equal rods on a ground of the same length, supported by a spring along a diagonal.

    Nodes A0 = (0, 0) and A1 = (side, 0) are fixed; rods ``left`` A0-B0, ``top`` B0-B1, ``right`` A1-B1; ``spring`` A1-B0.

    Parameters
    ----------
    side, mass : of every rod, uniform, m and kg. stiffness, natural_length : of the spring, N/m and m.
    angle : of the side rods at the start, from +x, rad. gravity : m/s^2; None for none.

    Notes
    -----
    With angle t: T = (5/6) m s^2 t'^2, V = 2 m g s sin t + k (2 s sin(t/2) - l0)^2/2. With the defaults the equilibrium is at
    t = 1.0662472589998337 and the frequency about it is 4.251519555206327 rad/s.

    Raises
    ------
    ModelError : faults of the parameters.

    Examples
    --------
    >>> model = rhombus_with_spring(angle="90 deg")
    >>> [round(x, 12) for x in model.nodes["B1"].at]
    [1.0, 1.0]
    """
    x, y = side * math.cos(angle), side * math.sin(angle)
    return Model(
        title=title,
        nodes={"A0": (0.0, 0.0), "A1": (side, 0.0), "B0": (x, y), "B1": (side + x, y)},
        fixed=["A0", "A1"],
        bars={
            "left": Bar(ends=("A0", "B0"), mass=mass, length=side),
            "top": Bar(ends=("B0", "B1"), mass=mass, length=side),
            "right": Bar(ends=("A1", "B1"), mass=mass, length=side),
            "spring": Bar(ends=("A1", "B0"), kind="elastic", stiffness=stiffness, natural_length=natural_length, mass=0.0),
        },
        gravity=gravity,
    )


@builder("mechanisms.von_mises")
def von_mises(
    *,
    half_span: PositiveLength = 1.0,
    rise: PositiveLength = 0.3,
    stiffness: Stiffness = 1.0,
    strain: Literal["engineering", "green"] = "engineering",
    mass: Mass = 1.0,
    load: Force = 0.0,
    title: str = "Von Mises truss",
) -> Model:
    """Two inclined elastic bars that snap through: the standard example of a limit load.

    Nodes L, R = (-+half_span, 0) are fixed, T = (0, rise) carries the mass and the load; bars ``left`` L-T, ``right`` R-T.

    Parameters
    ----------
    half_span, rise : a, h, m. stiffness : k = E A/l0 of each bar, N/m. strain : measure of its elongation.
    mass : lumped at T, kg. load : downward on T, N; the load is called ``load``.

    Notes
    -----
    Height y of T under the load P: 2 k (l0 - l) y/l = P with l^2 = a^2 + y^2; greatest at l^3 = l0 a^2, where
    P = 2 k a ((l0/a)^(2/3) - 1)^(3/2). With Green's strain P = k (h^2 - y^2) y/l0^2, greatest at y = h/sqrt(3).

    Raises
    ------
    ModelError : faults of the parameters.

    Source
    ------
    R. von Mises, Ueber die Stabilitaetsprobleme der Elastizitaetstheorie, ZAMM 3 (1923) 406-422.

    Examples
    --------
    >>> model = von_mises(load=0.005)
    >>> list(model.bars), model.loads["load"].force
    (['left', 'right'], (0.0, -0.005))
    """
    bar = {"kind": "elastic", "stiffness": stiffness, "strain": strain, "mass": 0.0}
    return Model(
        title=title,
        nodes={"L": (-half_span, 0.0), "R": (half_span, 0.0), "T": Node(at=(0.0, rise), mass=mass)},
        fixed=["L", "R"],
        bars={"left": Bar(ends=("L", "T"), **bar), "right": Bar(ends=("R", "T"), **bar)},
        loads={"load": NodalForce(node="T", force=(0.0, -load))},
    )
