"""Cells of the plane: a triangle, a panel with its diagonal."""

from __future__ import annotations

import cmath
import math
from typing import Unpack

from kinetruss.library._placing import meet, point, refuse
from kinetruss.library.cells.fittings import Fittings, dressed
from kinetruss.library.cells.ready import ready
from kinetruss.library.cells.records import Cell
from kinetruss.model import Angle, Bar, PositiveLength

__all__ = ["panel", "triangle"]


@ready("triangle")
def triangle(
    *,
    base: PositiveLength = 1.0,
    left: PositiveLength | None = None,
    right: PositiveLength | None = None,
    **fittings: Unpack[Fittings],
) -> Cell:
    """A triangle in the plane: nodes N1, N2 and the apex N3.

    Bars ``batten1`` (N1 N2), ``longeron1`` (N1 N3), ``longeron2`` (N2 N3). Edges: ``base``, ``left`` and ``right``; the next
    cell of a stack stands on the right one, so equal triangles go round N2. Every second one mirrored along x makes a strip.

    Parameters
    ----------
    base : length of batten1, m. left, right : of the longerons, m; by default as the base.
    fittings : see `Fittings`.

    Raises
    ------
    ModelError : sides that do not close; faults of the parameters.

    Examples
    --------
    >>> [round(x, 6) for x in triangle(base=3, left=4, right=5).nodes["N3"].at]
    [0.0, 4.0]
    """
    left, right = base if left is None else left, base if right is None else right
    apex = meet(0j, left, complex(base), right)
    if apex is None:
        raise refuse(
            "base", f"sides of {base:g}, {left:g} and {right:g} m close no triangle.", "Make each shorter than the two others."
        )
    cell = Cell(
        nodes={"N1": (0.0, 0.0), "N2": (base, 0.0), "N3": point(apex)},
        bars={"batten1": Bar(ends=("N1", "N2")), "longeron1": Bar(ends=("N1", "N3")), "longeron2": Bar(ends=("N2", "N3"))},
        faces={"base": ["N1", "N2"], "top": ["N3", "N2"], "left": ["N1", "N3"], "right": ["N3", "N2"]},
    )
    return dressed(cell, fittings)


@ready("panel")
def panel(
    *,
    width: PositiveLength = 1.0,
    height: PositiveLength = 1.0,
    top: PositiveLength | None = None,
    lean: Angle = 0.0,
    **fittings: Unpack[Fittings],
) -> Cell:
    """A quadrilateral in the plane with its diagonal: N1, N2 below, N3 over N1, N4 over N2.

    Bars ``batten1`` below, ``batten2`` above, ``longeron1``, ``longeron2`` beside, ``diagonal1`` (N1 N4). Edges ``base``,
    ``top``, ``left``, ``right``.

    Parameters
    ----------
    width, height : m. top : width above, m, by default as below. lean : angle by which the top edge is turned, rad; it stays
        on the line halfway, so that equal panels close into a ring.
    fittings : see `Fittings`.

    Raises
    ------
    ModelError : a top that crosses the base; faults of the parameters.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> cell = cells.panel(width=1.0, height=0.8)
    >>> list(cell.bars), cell.nodes["N4"].at
    (['batten1', 'batten2', 'longeron1', 'longeron2', 'diagonal1'], (0.5, 0.8))
    """
    half, whole = cmath.exp(0.5j * lean), cmath.exp(1j * lean)
    middle, reach = 1j * height * half, (width if top is None else top) / 2
    three, four = middle - reach * whole, middle + reach * whole
    if min(three.imag, four.imag) <= 0:
        raise refuse("lean", f"at {math.degrees(lean):.4g} deg the top edge cuts the base.", "Lean less, or make it higher.")
    cell = Cell(
        nodes={"N1": (-width / 2, 0.0), "N2": (width / 2, 0.0), "N3": point(three), "N4": point(four)},
        bars={
            "batten1": Bar(ends=("N1", "N2")),
            "batten2": Bar(ends=("N3", "N4")),
            "longeron1": Bar(ends=("N1", "N3")),
            "longeron2": Bar(ends=("N2", "N4")),
            "diagonal1": Bar(ends=("N1", "N4")),
        },
        faces={"base": ["N1", "N2"], "top": ["N3", "N4"], "left": ["N1", "N3"], "right": ["N4", "N2"]},
    )
    return dressed(cell, fittings)
