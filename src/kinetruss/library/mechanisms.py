"""Planar mechanisms."""

from __future__ import annotations

import math

from kinetruss.errors import Fault, ModelError
from kinetruss.library._builder import builder, named
from kinetruss.library.materials import MATERIALS, STEEL_S235
from kinetruss.model import AngleDrive, Bar, Material, Model, Node, Rectangle
from kinetruss.model._record import Angle, GravityVector, Mass, Name, PositiveLength
from kinetruss.model._sections import Section

__all__ = ["four_bar"]


@builder("mechanisms.four_bar")
def four_bar(
    *,
    ground: PositiveLength = 0.4,
    crank: PositiveLength = 0.1,
    coupler: PositiveLength = 0.35,
    rocker: PositiveLength = 0.25,
    angle: Angle = math.pi / 2,
    section: Section = Rectangle(width=0.020, height=0.005),  # noqa: B008 - frozen
    material: Material | Name = STEEL_S235,
    coupler_mass: Mass = 0.0,
    gravity: GravityVector | None = (0.0, -9.81),
    title: str = "Four-bar linkage",
) -> Model:
    """A crank A-B, a coupler B-C and a rocker D-C over the ground A-D on the x axis; drive ``motor`` turns the crank.

    Parameters
    ----------
    ground, crank, coupler, rocker : lengths, m. The crank turns fully where the shortest and the longest together are
        shorter than the other two (Grashof) and the crank is the shortest.
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
    b = crank * math.cos(angle), crank * math.sin(angle)
    reach = math.dist(b, (ground, 0.0))
    along = (coupler**2 - rocker**2 + reach**2) / (2 * reach) if reach > 0 else math.inf
    if coupler**2 <= along**2:
        mend = "Lengthen coupler or rocker, or turn the crank."
        raise ModelError([Fault(("coupler",), f"the linkage does not close at {math.degrees(angle):.4g} deg.", mend)])
    ux, uy = (ground - b[0]) / reach, -b[1] / reach
    off = math.sqrt(coupler**2 - along**2)
    c = b[0] + along * ux - off * uy, b[1] + along * uy + off * ux
    return Model(
        title=title,
        nodes={"A": (0.0, 0.0), "B": b, "C": Node(at=c, mass=coupler_mass), "D": (ground, 0.0)},
        fixed=["A", "D"],
        section=section,
        material=named(MATERIALS, material, "material"),
        bars={"crank": Bar(ends=("A", "B")), "coupler": Bar(ends=("B", "C")), "rocker": Bar(ends=("D", "C"))},
        drives={"motor": AngleDrive("crank")},
        gravity=gravity,
    )
