"""Cells of the plane, and cells of space whose members follow the edges of a solid."""

from __future__ import annotations

import cmath
import math
from typing import Annotated, Any, Unpack

import numpy as np
from pydantic import Field

from kinetruss.kernels.motion.placement import tilt
from kinetruss.library.cells.fittings import Fittings, dressed, ready
from kinetruss.library.cells.records import Cell
from kinetruss.library.placing import meet, point, refuse
from kinetruss.model import Angle, Bar, PositiveLength, Whole


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


# Cells of space whose members follow the edges of a solid: tetrahedron, octahedron, decahedron, prism, cube.

Sides = Annotated[Whole, Field(ge=3, le=100)]


@ready("tetrahedron")
def tetrahedron(*, side: PositiveLength = 1.0, height: PositiveLength | None = None, **fittings: Unpack[Fittings]) -> Cell:
    """A tetrahedron: base N1, N2, N3 and the apex N4; bars ``batten1`` .. ``batten3`` below, ``longeron1`` .. up from N1 ...

    Faces ``base``, ``side1`` (N1 N2 N4), ``side2``, ``side3``; the next cell of a stack stands on side2: tetrahedra then wind
    in a helix (Boerdijk and Coxeter).

    Parameters
    ----------
    side : of the base, m. height : of the apex, m; by default all edges are equal. fittings : see `Fittings`.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> cell = cells.tetrahedron(side=1.0)
    >>> list(cell.faces), round(cell.nodes["N4"].at[2], 6)  # height: sqrt(2/3)
    (['base', 'top', 'side1', 'side2', 'side3'], 0.816497)
    """
    height = side * math.sqrt(2 / 3) if height is None else height
    low = _polygon(3, side)
    cell = Cell(
        nodes=_named([*low, [0.0, 0.0, height]]),
        bars=_round("batten", [1, 2, 3]) | {f"longeron{k}": _bar(k, 4) for k in (1, 2, 3)},
        faces={"base": _face(1, 2, 3), "top": _face(2, 3, 4)} | {f"side{k}": _face(k, k % 3 + 1, 4) for k in (1, 2, 3)},
    )
    return dressed(cell, fittings)


@ready("octahedron")
def octahedron(
    *,
    side: PositiveLength = 1.0,
    height: PositiveLength | None = None,
    top: PositiveLength | None = None,
    beta: Angle = 0.0,
    gamma: Angle = 0.0,
    **fittings: Unpack[Fittings],
) -> Cell:
    """An octahedron: base N1, N2, N3, top N4, N5, N6, each over the middle of an edge of the base.

    Bars ``batten1`` .. ``batten3`` below, ``batten4`` .. ``batten6`` above, ``longeron1`` .. ``longeron6`` between, two at
    each node of the top: N4 to N1 and N2, N5 to N2 and N3, N6 to N3 and N1. Faces ``base``, ``top``, ``side1`` .. ``side3``
    (apex above), ``side4`` .. ``side6`` (apex below).

    Parameters
    ----------
    side, top : of the base and of the top, m; equal by default. height : between their centroids, m; by default that of the
        regular octahedron of this side.
    beta, gamma : tilt of the top, rad: its normal is (-sin gamma, -sin beta cos gamma, cos beta cos gamma), as of a bay.
    fittings : see `Fittings`.

    Raises
    ------
    ModelError : a top that cuts the base; faults of the parameters.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> cell = cells.octahedron(side=1.0)
    >>> len(cell.nodes), len(cell.bars), round(cell.nodes["N4"].at[2], 6)  # height of the regular one: sqrt(2/3)
    (6, 12, 0.816497)
    """
    height = side * math.sqrt(2 / 3) if height is None else height
    nodes = [*_polygon(3, side), *_tilted(_polygon(3, side if top is None else top, math.pi / 3), height, beta, gamma)]
    between = [(4, 1), (4, 2), (5, 2), (5, 3), (6, 3), (6, 1)]
    cell = Cell(
        nodes=_named(nodes),
        bars=_round("batten", [1, 2, 3])
        | _round("batten", [4, 5, 6], 4)
        | {f"longeron{k}": _bar(*ends) for k, ends in enumerate(between, start=1)},
        faces={"base": _face(1, 2, 3), "top": _face(4, 5, 6)}
        | {f"side{k}": _face(k, k % 3 + 1, k + 3) for k in (1, 2, 3)}
        | {f"side{k}": _face(k % 3 + 1, (k - 3) % 3 + 4, k) for k in (4, 5, 6)},
    )
    return dressed(cell, fittings)


@ready("decahedron")
def decahedron(*, side: PositiveLength = 1.0, **fittings: Unpack[Fittings]) -> Cell:
    """The pentagonal dipyramid: ten equilateral triangles; rim N1 .. N5, apexes N6 above and N7 below.

    Bars ``rim1`` .. ``rim5``, ``upper1`` .. (N1 N6 ..), ``lower1`` .. (N1 N7 ..). It stands on the face N1 N2 N7. Faces
    ``base``; ``upper1`` .. ``upper5``, ``lower2`` .. ``lower5``, each over the rim bar of its number; ``top`` is upper3.

    Parameters
    ----------
    side : of all edges, m. fittings : see `Fittings`.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> cell = cells.decahedron()
    >>> len(cell.nodes), len(cell.bars), len(cell.faces)
    (7, 15, 11)
    """
    rim = _polygon(5, side)
    h = math.sqrt(side**2 - float(rim[0] @ rim[0]))
    drawn = np.vstack([rim, [[0.0, 0.0, h], [0.0, 0.0, -h]]])
    one, two, apex = drawn[[0, 1, 6]]
    x = (two - one) / side
    z = np.cross(x, apex - one)
    z /= math.sqrt(float(z @ z))
    axes = np.stack([x, np.cross(z, x), z], axis=1)
    after = {k: k % 5 + 1 for k in range(1, 6)}
    cell = Cell(
        nodes=_named((drawn - (one + two + apex) / 3) @ axes),
        bars=_round("rim", [1, 2, 3, 4, 5])
        | {f"upper{k}": _bar(k, 6) for k in after}
        | {f"lower{k}": _bar(k, 7) for k in after},
        faces={"base": _face(1, 2, 7), "top": _face(3, 4, 6)}
        | {f"upper{k}": _face(k, after[k], 6) for k in after}
        | {f"lower{k}": _face(after[k], k, 7) for k in after if k > 1},
    )
    return dressed(cell, fittings)


@ready("prism")
def prism(
    sides: Sides = 3,
    *,
    side: PositiveLength = 1.0,
    height: PositiveLength | None = None,
    top: PositiveLength | None = None,
    beta: Angle = 0.0,
    gamma: Angle = 0.0,
    **fittings: Unpack[Fittings],
) -> Cell:
    """A prism with a diagonal in every face: base N1 .. Nn, top N(n+1) .. N(2n), one node over each other.

    Bars ``batten1`` .. round base and top, ``longeron1`` .. up, ``diagonal1`` .. in the sides (from N1 to the top node after
    that over it) and, with more than three sides, in base and top from their first nodes. Faces ``base``, ``top``, ``side1`` ..

    Parameters
    ----------
    sides : of base and top. side, top : length of the sides of base and top, m; equal by default. height : between
        their centroids, m; by default `side`. beta, gamma : tilt of the top, rad, as of `octahedron`.
    fittings : see `Fittings`.

    Raises
    ------
    ModelError : a top that cuts the base; faults of the parameters.

    Examples
    --------
    >>> mast = prism(3, side=0.6, height=0.5, active=("longeron*",))
    >>> [name for name, bar in mast.bars.items() if bar.kind == "driven"]
    ['longeron1', 'longeron2', 'longeron3']
    """
    n, height = sides, side if height is None else height
    nodes = [*_polygon(n, side), *_tilted(_polygon(n, side if top is None else top), height, beta, gamma)]
    after = {k: k % n + 1 for k in range(1, n + 1)}
    flat = [(first, first + j) for first in (1, n + 1) for j in range(2, n - 1)]
    diagonals = [*((k, n + after[k]) for k in after), *flat]
    cell = Cell(
        nodes=_named(nodes),
        bars=_round("batten", list(after))
        | _round("batten", [n + k for k in after], n + 1)
        | {f"longeron{k}": _bar(k, n + k) for k in after}
        | {f"diagonal{k}": _bar(*ends) for k, ends in enumerate(diagonals, start=1)},
        faces={"base": _face(*after), "top": _face(*(n + k for k in after))}
        | {f"side{k}": _face(k, after[k], n + after[k], n + k) for k in after},
    )
    return dressed(cell, fittings)


@ready("cube")
def cube(
    *,
    side: PositiveLength = 1.0,
    height: PositiveLength | None = None,
    top: PositiveLength | None = None,
    beta: Angle = 0.0,
    gamma: Angle = 0.0,
    **fittings: Unpack[Fittings],
) -> Cell:
    """A cube with a diagonal in every face, or a box or frustum on a square: the `prism` of four sides, with its names.

    >>> from kinetruss.library import cells
    >>> box = cells.cube(side=0.5)
    >>> len(box.nodes), len(box.bars)  # 12 edges and 6 diagonals
    (8, 18)
    """
    return prism(4, side=side, height=height, top=top, beta=beta, gamma=gamma, **fittings)


def _polygon(n: int, side: float, turned: float = 0.0) -> Any:
    """A regular polygon about the origin, (n, 3), m; its first edge is in front, along x."""
    radius = side / (2 * math.sin(math.pi / n))
    angles = turned - math.pi / 2 - math.pi / n + 2 * math.pi / n * np.arange(n)
    return radius * np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)


def _tilted(flat: Any, height: float, beta: float, gamma: float) -> Any:
    """A top in its place: its centroid at `height` on the line halfway between the normals of base and top."""
    u, turn = tilt(beta, gamma)
    top = height * u + flat @ turn.T
    if not (math.cos(beta) * math.cos(gamma) > -1 + 1e-9 and top[:, 2].min() > 0):
        text = f"tilted by {math.degrees(beta):.4g} and {math.degrees(gamma):.4g} deg, the top cuts the base."
        raise refuse("beta", text, "Tilt less, or make the cell higher.")
    return top


def _named(places: Any) -> dict[str, Any]:
    return {f"N{k}": point(np.asarray(place)) for k, place in enumerate(places, start=1)}


def _bar(first: int, second: int) -> Bar:
    return Bar(ends=(f"N{first}", f"N{second}"))


def _face(*corners: int) -> list[str]:
    return [f"N{k}" for k in corners]


def _round(name: str, corners: list[int], start: int = 1) -> dict[str, Bar]:
    """Bars round a polygon."""
    pairs = zip(corners, [*corners[1:], corners[0]], strict=True)
    return {f"{name}{k}": _bar(*ends) for k, ends in enumerate(pairs, start=start)}
