"""Chains of pendulums in the plane."""

from __future__ import annotations

import math
from itertools import accumulate
from typing import Annotated

from pydantic import Field

from kinetruss.library._builder import Turning, builder
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import Angle, Bar, Count, GravityVector, Mass, Model, Node, PositiveLength

__all__ = ["double_pendulum", "n_pendulum", "pendulum"]

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
