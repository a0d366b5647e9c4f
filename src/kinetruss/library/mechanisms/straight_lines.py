"""Linkages that draw a straight line: exact (Peaucellier, Hart) and nearly so (Watt, Chebyshev, Roberts)."""

from __future__ import annotations

import cmath
import math

from kinetruss.library.building import builder
from kinetruss.library.placing import bars_between, does_not_close, meet, on_link, places, refuse
from kinetruss.model import Angle, AngleDrive, Cyclic, Model, Number, PositiveLength, Run

Bars = list[tuple[str, str]]
Nodes = dict[str, complex]


@builder("mechanisms.peaucellier")
def peaucellier(
    *,
    arm: PositiveLength = 0.5,
    side: PositiveLength = 0.3,
    crank: PositiveLength = 0.15,
    angle: Angle = 0.6,
    title: str = "Peaucellier's straight-line linkage",
) -> Model:
    """Two arms O-S, a rhombus N-S-P-S and a crank E-N through O: node ``P`` runs on a straight line, exactly.

    O = (0, 0) and E = (crank, 0) are fixed; bars ``O-S1``, ``O-S2``, ``N-S1``, ``N-S2``, ``P-S1``, ``P-S2``, ``E-N``; drive
    ``motor`` turns the crank.

    Parameters
    ----------
    arm, side, crank : lengths, m. angle : of the crank from +x at the start, rad.

    Notes
    -----
    |ON| |OP| = arm^2 - side^2: P is the inverse of N, and the inverse of a circle through O is a straight line,
    x = (arm^2 - side^2)/(2 crank).

    Raises
    ------
    ModelError : faults of the parameters; lengths that do not close at this angle.

    Source
    ------
    C.-N. Peaucellier, Note sur une question de geometrie de compas, Nouvelles annales de mathematiques 12 (1873) 71-78.

    Examples
    --------
    >>> [round(peaucellier(angle=a).nodes["P"].at[0], 12) for a in (-0.5, 0.0, 0.5)]
    [0.533333333333, 0.533333333333, 0.533333333333]
    """
    near = crank + cmath.rect(crank, angle)
    left = meet(0j, arm, near, side) if abs(near) > 0 else None
    right = meet(near, side, 0j, arm)
    if left is None or right is None or arm <= side:
        raise does_not_close("arm", angle)
    far = near * (arm**2 - side**2) / abs(near) ** 2
    nodes = {"O": 0j, "E": complex(crank), "N": near, "S1": left, "S2": right, "P": far}
    bars = [(foot, top) for foot in ("O", "N", "P") for top in ("S1", "S2")]
    return _driven(title, nodes, ("O", "E"), [*bars, ("E", "N")], "E-N", angle, 0.25)


@builder("mechanisms.hart")
def hart(
    *,
    longer: PositiveLength = 0.5,
    shorter: PositiveLength = 0.25,
    part: Number = 0.5,
    crank: PositiveLength = 0.08,
    angle: Angle = 0.6,
    title: str = "Hart's straight-line linkage",
) -> Model:
    """Four links crossed, three points on one line parallel to their ends: node ``P`` runs on a straight line, exactly.

    Links AB = CD are the longer ones, AD = BC the shorter; O divides AB, N divides AD and P divides CB at the same part.
    O = (0, 0) and E = (crank, 0) are fixed, drive ``motor`` turns the crank ``E-N``. A point between the ends of a link is
    held by a triangle with its apex off the link (apexes XO, XN, XP): three points in one line would be stiff only to
    second order.

    Parameters
    ----------
    longer, shorter, crank : lengths, m. part : of AB from A to O, between 0 and 1. angle : of the crank from +x, rad.

    Notes
    -----
    |ON| |OP| = part (1 - part) (longer^2 - shorter^2), P on the other side of O than N, so it moves on
    x = -part (1 - part) (longer^2 - shorter^2)/(2 crank).

    Raises
    ------
    ModelError : faults of the parameters; lengths that do not close at this angle.

    Source
    ------
    H. Hart, On certain conversions of motion, Messenger of Mathematics 4 (1875) 82-88.

    Examples
    --------
    >>> [round(hart(angle=a).nodes["P"].at[0], 12) for a in (-0.5, 0.0, 0.5)]
    [-0.29296875, -0.29296875, -0.29296875]
    """
    if not 0 < part < 1:
        raise refuse("part", f"{part:g} is no part of a link.", "Give a number between 0 and 1, e.g. 0.5.")
    near = crank + cmath.rect(crank, angle)
    A = meet(near, part * shorter, 0j, part * longer) if longer > shorter else None
    if A is None:
        raise does_not_close("longer", angle)
    B, D = A - A / part, A + (near - A) / part
    # mirrored, A becomes C and B becomes D: AC is parallel to BD, and CD as long as AB
    way = (D - B) / abs(D - B)
    C = A + (abs(B - D) - 2 * ((A - B) / way).real) * way
    nodes = {"O": 0j, "E": complex(crank), "A": A, "B": B, "C": C, "D": D, "N": near, "P": B + (1 - part) * (C - B)}
    bars: Bars = [("A", "B"), ("C", "D"), ("A", "D"), ("B", "C"), ("E", "N")]
    for first, second, inner in (("A", "B", "O"), ("A", "D", "N"), ("C", "B", "P")):
        nodes, bars = _between(nodes, bars, first, second, inner)
    return _driven(title, nodes, ("O", "E"), bars, "E-N", angle, 0.25)


@builder("mechanisms.watt_line")
def watt_line(
    *,
    arm: PositiveLength = 0.5,
    coupler: PositiveLength = 0.2,
    angle: Angle = 0.1,
    title: str = "Watt's straight-line linkage",
) -> Model:
    """Two equal arms on opposite sides of a coupler whose middle ``P`` moves nearly straight, along the coupler.

    A = (-arm, coupler/2), D = (arm, -coupler/2); bars ``A-B``, ``B-C``, ``D-C``; P on B-C is held by a triangle with apex XP.
    Drive ``motor`` turns A-B; at angle 0 both arms are horizontal and the coupler is vertical. P traces a figure of eight.

    Parameters
    ----------
    arm, coupler : lengths, m. angle : of A-B from +x at the start, rad.

    Raises
    ------
    ModelError : faults of the parameters; lengths that do not close at this angle.

    Source
    ------
    J. Watt, British patent 1432 (1784).

    Examples
    --------
    >>> abs(watt_line(angle="10 deg").nodes["P"].at[0]) < 0.002
    True
    """
    A, D = complex(-arm, coupler / 2), complex(arm, -coupler / 2)
    B = A + cmath.rect(arm, angle)
    C = meet(D, arm, B, coupler)
    if C is None:
        raise does_not_close("coupler", angle)
    return _tracing(title, {"A": A, "D": D, "B": B, "C": C, "P": (B + C) / 2}, angle, 0.3)


@builder("mechanisms.chebyshev")
def chebyshev(*, unit: PositiveLength = 0.1, angle: Angle = 0.95, title: str = "Chebyshev's straight-line linkage") -> Model:
    """Crossed arms of 5, ground of 4, coupler of 2 units, whose middle ``P`` moves nearly straight along the ground's line.

    A = (0, 0), D = (4 unit, 0); bars ``A-B``, ``B-C``, ``D-C``; P on B-C is held by a triangle with apex XP. Drive ``motor``
    turns A-B. In the middle (crank angle atan(4/3)) P is at (2, 4) units, its line is y = 4 units.

    Parameters
    ----------
    unit : m. angle : of A-B from +x at the start, rad.

    Raises
    ------
    ModelError : faults of the parameters; an angle at which the linkage does not close.

    Source
    ------
    P. L. Chebyshev, Theorie des mecanismes connus sous le nom de parallelogrammes (1854).

    Examples
    --------
    >>> round(chebyshev(angle=0.9).nodes["P"].at[1], 4)
    0.4
    """
    B, D = cmath.rect(5 * unit, angle), complex(4 * unit)
    C = meet(D, 5 * unit, B, 2 * unit)
    if C is None:
        raise does_not_close("angle", angle)
    return _tracing(title, {"A": 0j, "D": D, "B": B, "C": C, "P": (B + C) / 2}, angle, 0.2)


@builder("mechanisms.roberts")
def roberts(
    *, half: PositiveLength = 0.2, arm: PositiveLength = 0.25, angle: Angle = 1.1, title: str = "Roberts' straight-line linkage"
) -> Model:
    """Three equal triangles in a row: the foot ``P`` of the middle one, the coupler, moves nearly along the ground A-D.

    A = (0, 0), D = (2 half, 0); arms ``A-B``, ``D-C`` as long as ``B-P``, ``C-P``; coupler ``B-C`` of length `half`. Drive
    ``motor`` turns A-B; in the middle (crank angle acos(half/(2 arm))) P is at (half, 0).

    Parameters
    ----------
    half, arm : lengths, m. angle : of A-B from +x at the start, rad.

    Raises
    ------
    ModelError : faults of the parameters; lengths that do not close at this angle.

    Source
    ------
    R. Roberts, about 1860; A. B. Kempe, How to draw a straight line (1877).

    Examples
    --------
    >>> abs(roberts(angle=1.1).nodes["P"].at[1]) < 1e-3
    True
    """
    B, D = cmath.rect(arm, angle), complex(2 * half)
    C = meet(B, half, D, arm)
    if C is None or arm <= half / 2:
        raise does_not_close("arm", angle)
    P = on_link(B, C, (half / 2, -math.sqrt(arm**2 - half**2 / 4)))
    bars = [("A", "B"), ("B", "C"), ("D", "C"), ("B", "P"), ("C", "P")]
    return _driven(title, {"A": 0j, "D": D, "B": B, "C": C, "P": P}, ("A", "D"), bars, "A-B", angle, 0.1)


def _tracing(title: str, nodes: Nodes, angle: float, swing: float) -> Model:
    """A four-bar A-B-C-D with its tracing point P between B and C."""
    nodes, bars = _between(nodes, [("A", "B"), ("B", "C"), ("D", "C")], "B", "C", "P")
    return _driven(title, nodes, ("A", "D"), bars, "A-B", angle, swing)


def _between(nodes: Nodes, bars: Bars, first: str, second: str, inner: str) -> tuple[Nodes, Bars]:
    """With an apex that holds `inner` between the ends of a link."""
    apex = f"X{inner}"
    length = abs(nodes[second] - nodes[first])
    place = on_link(nodes[first], nodes[second], (length / 2, length / 2))
    held = [(first, apex), (second, apex), (first, inner), (apex, inner)]
    return nodes | {apex: place}, [*bars, *held]


def _driven(title: str, nodes: Nodes, fixed: tuple[str, ...], bars: Bars, crank: str, angle: float, swing: float) -> Model:
    """A motor on the crank, and a run that swings it there and back."""
    there = Cyclic(moves={"motor": (angle, angle - swing)}, period=1.0)
    return Model(
        title=title,
        nodes=places(nodes),
        fixed=list(fixed),
        bars=bars_between(bars),
        drives={"motor": AngleDrive(crank)},
        runs={"swing": Run(analysis="kinematics.follow", trajectory=there)},
    )
