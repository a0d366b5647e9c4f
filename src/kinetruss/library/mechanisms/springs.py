"""Mechanisms and trusses with springs whose equilibrium has a closed form."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from kinetruss.library._builder import builder
from kinetruss.model import Angle, Bar, Force, GravityVector, Mass, Model, NodalForce, Node, Of, PositiveLength

__all__ = ["rhombus_with_spring", "von_mises"]

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
