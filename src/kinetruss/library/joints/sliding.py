"""Joints that slide: chains of hinges, parallelograms, and Peaucellier's linkage twice."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from kinetruss.library.building import own_arguments
from kinetruss.library.joints.joining import Draft, anchored, direction, hinge, pair_of, sized, start
from kinetruss.library.mechanisms.loops import CHAINS, SARRUS_BARS, chain_bars, sarrus_places
from kinetruss.model import GROUND, Coupling, Hinge, Model, OffsetCoordinate

APEX = 0.7
"""Height of the apex of a plate as a fraction of its length: best conditioned with hinges as long as the plates."""


@own_arguments
def prismatic(
    model: Model,
    name: str,
    *,
    bodies: Sequence[str],
    at: Any,
    axis: Any,
    size: float | None = None,
    across: Any = None,
    form: Literal["linkage", "direct"] = "linkage",
) -> Model:
    """A slider: the second body moves along the axis and does not turn. One relative freedom.

    In space a Sarrus linkage: 29 bars and 8 free nodes of its own, three nodes on each body. The distance of the nodes
    ``NAME.B`` (first body, at the place given) and ``NAME.G`` (second body), `slide` of its record, starts at `size` and can go
    from near 0 to near 2 `size`; a driven bar between them is the actuator.

    In the plane two of Peaucellier's cells side by side, whose points ``NAME.P1`` and ``NAME.P2`` on the second body run on
    one straight line of the first: 14 bars, 6 free nodes, a stroke of `size` to either side. The slide is the distance of
    ``NAME.P1`` from ``NAME.F`` on that line, at first 2 `size`. Or directly, without bars: two couplings keep the offsets
    of ``NAME.P1`` and ``NAME.P2`` from the line at 0.

    Parameters
    ----------
    model, name, bodies : as of `spherical`. at : of the corner of the linkage on the first body, in the plane of the point on
        the line, m. axis : of the slide, a letter or numbers, from the first body to the second.
    size : length of the plates and of their hinges, in the plane half the stroke, m; by default the best conditioned of some
        fractions of the size of the smaller body.
    across : direction of the hinges of the first chain, normal to the axis; by default any.
    form : in the plane ``linkage`` or ``direct``.

    Raises
    ------
    ModelError : unknown or equal bodies, a name that is in use, a place far from a body, an axis without direction. Warns
        `JointWarning` if the size makes it ill-conditioned.

    Source
    ------
    P. F. Sarrus, Comptes rendus de l'Academie des Sciences 36 (1853) 1036; C.-N. Peaucellier, Nouvelles annales de
    mathematiques 12 (1873) 71-78.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> slider = kt.library.joints.prismatic(block, "slide", bodies=("ground", "block"), at="O", axis="z")
    >>> kt.kinematics.mobility(slider).degrees_of_freedom
    1
    """
    if model.dim == 2:
        return prismatic_in_plane(model, name, bodies=bodies, at=at, axis=axis, size=size, form=form)
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 3)
    frame = _frame(name, axis, across)
    low, high = [f"{name}.{key}" for key in "BEF"], [f"{name}.{key}" for key in "GHK"]

    def draft(_: Model, length: float) -> Draft:
        places, bars = _sarrus(name, place, frame, length)
        bars.remove((f"{name}.N2", f"{name}.K"))  # with a rigid triangle on top, one of the 32 bars is redundant
        return Draft(kind="prismatic", places=places, first=low, second=high, bars=bars, slide=(low[0], high[0]))

    return sized(model, name, pair, size, draft)


@own_arguments
def cylindrical(
    model: Model, name: str, *, bodies: Sequence[str], at: Any, axis: Any, size: float | None = None, across: Any = None
) -> Model:
    """A sliding and turning joint: a Sarrus linkage whose upper end is hinged to the second body on the axis. Two freedoms.

    34 bars. Parameters and errors as of `prismatic`; the axis runs through the place. `slide` of its record is the distance of
    the nodes ``NAME.B`` and ``NAME.G`` on the axis, its hinge the angle from the upper end, which does not turn, to the second
    body.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> free = kt.library.joints.cylindrical(block, "bush", bodies=("ground", "block"), at="O", axis="z")
    >>> kt.kinematics.mobility(free).degrees_of_freedom  # along the axis and about it
    2
    """
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 3)
    frame = _frame(name, axis, across)
    low, turning = [f"{name}.{key}" for key in "BEF"], [f"{name}.G", f"{name}.T"]

    def draft(now: Model, length: float) -> Draft:
        places, bars = _sarrus(name, place, frame, length)
        places[turning[1]] = places[turning[0]] + length * frame[:, 1]
        (_, end), more = anchored(now, name, pair, place, frame[:, 1], length)
        return Draft(
            kind="cylindrical",
            places=places | (more if pair[1] == GROUND else {}),
            first=low,
            second=turning,
            bars=[*bars, (turning[1], f"{name}.H"), (turning[1], f"{name}.K")],
            hinges=hinge((turning[0], turning[1]), f"{name}.H", end),
            slide=(low[0], turning[0]),
            ground=list(more) if pair[1] == GROUND else (),
        )

    return sized(model, name, pair, size, draft)


@own_arguments
def planar(
    model: Model, name: str, *, bodies: Sequence[str], at: Any, axis: Any, size: float | None = None, across: Any = None
) -> Model:
    """Motion in a plane: a chain of three parallel hinges along its normal. Three relative freedoms.

    17 bars, 6 nodes of its own with those of the hinges. The hinges on the two bodies start 1.4 `size` apart about the place
    given and can go from near 0 to near 2 `size`; stretched out the chain is singular.

    Parameters
    ----------
    axis : normal of the plane. across : direction from the first body's hinge to the second's; by default any in the plane.
        The others as of `prismatic`.

    Raises
    ------
    ModelError, JointWarning : as of `prismatic`.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> puck = kt.library.joints.planar(block, "table", bodies=("ground", "block"), at="O", axis="z")
    >>> kt.kinematics.mobility(puck).degrees_of_freedom  # two displacements and a rotation
    3
    """
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 3)
    u = direction(name, "axis", axis, 3)
    frame = _frame(name, u, across)
    ends = [[f"{name}.{k}1", f"{name}.{k}2"] for k in "AMB"]

    def draft(_: Model, length: float) -> Draft:
        # the first chain of a Sarrus linkage: slide along `across`, hinges along the normal
        own = np.column_stack([u, frame[:, 0], np.cross(u, frame[:, 0])])
        local = sarrus_places(np.sqrt(2) * length, length, length, APEX * length)
        middle = (local["G"] + local["H"]) / 2 - local["G"] / 2
        roles = dict(zip([*CHAINS[0][0], *CHAINS[0][1], *CHAINS[0][2]], itertools.chain(*ends), strict=True))
        roles |= dict(zip(CHAINS[0][3], (f"{name}.Q1", f"{name}.Q2"), strict=True))
        places = {key: place + own @ (local[role] - middle) for role, key in roles.items()}
        bars = [(roles[a], roles[b]) for a, b in chain_bars(*CHAINS[0]) if (a, b) != CHAINS[0][2]]
        hinges = [
            Hinge(axis=tuple(ends[0]), start=f"{name}.B1", end=f"{name}.M1"),
            Hinge(axis=tuple(ends[1]), start=f"{name}.A1", end=f"{name}.B1"),
            Hinge(axis=tuple(ends[2]), start=f"{name}.M1", end=f"{name}.A1"),
        ]
        return Draft(kind="planar", places=places, first=ends[0], second=ends[2], bars=bars, hinges=hinges)

    return sized(model, name, pair, size, draft)


def _frame(name: str, axis: Any, across: Any) -> Any:
    """Columns: across, along the axis, the third, right-handed."""
    y = direction(name, "axis", axis, 3)
    given = np.eye(3)[int(np.argmin(np.abs(y)))] if across is None else direction(name, "across", across, 3)
    x = direction(name, "across", given - (given @ y) * y, 3)
    return np.column_stack([x, y, np.cross(x, y)])


def _sarrus(name: str, place: Any, frame: Any, length: float) -> tuple[dict[str, Any], list[tuple[str, str]]]:
    """Nodes and bars of the linkage; the bars between the nodes of the second body are left to it."""
    local = sarrus_places(length, length, length, APEX * length)
    places = {f"{name}.{key}": place + frame @ at for key, at in local.items()}
    return places, [(f"{name}.{a}", f"{name}.{b}") for a, b in SARRUS_BARS]


# Joints of the plane that slide: parallelograms, and Peaucellier's linkage twice.

RATIO = 0.5
"""|ON|/|OP| of Peaucellier's cell in its middle position: best conditioned over a stroke of |OP| to either side."""

SIDE = 0.9
"""Side of the rhombus of this cell over |OP|, likewise."""


@own_arguments
def parallelogram(
    model: Model,
    name: str,
    *,
    bodies: Sequence[str],
    at: Any,
    axis: Any,
    size: float | None = None,
    length: float | None = None,
    double: bool = False,
) -> Model:
    """Keeps the relative orientation of two bodies in the plane: two like parallel links. One relative freedom; doubled, two.

    Links run from ``NAME.1``, ``NAME.2`` on the first body to ``NAME.3``, ``NAME.4`` on the second, along the axis. Doubled,
    there is a massless triangle between two pairs of links at right angles, and the second body may move in both directions.
    With the links along the line of their feet the parallelogram is singular and may change its branch.

    Parameters
    ----------
    model : planar. name : of the joint. bodies : two names, either may be ``ground``. at : middle of the links, m, or of the
        first pair's feet when doubled; or a node's name, for its place.
    axis : direction of the links from the first body to the second, x, y or two numbers.
    size : distance of the links, m; by default the best conditioned of some fractions of the size of the smaller body.
    length : of the links, m; by default `size`.

    Raises
    ------
    ModelError : unknown or equal bodies, a name that is taken, a place far off a body, an axis without direction. Warns
        `JointWarning` if the size makes it ill-conditioned.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"A": (0, 0), "B": (1, 0), "C": (0, 1)}
    >>> plate = kt.Model(nodes=corners, bodies={"plate": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> table = kt.library.joints.parallelogram(plate, "lift", bodies=("ground", "plate"), at=(0.5, -0.2), axis="y", size=0.5)
    >>> kt.kinematics.mobility(table).degrees_of_freedom
    1
    """
    pair, place, u, v = _stand(model, name, bodies, at, axis)

    def draft(_: Model, wide: float) -> Draft:
        along = (wide if length is None else length) * u
        if double:
            return _double(name, place, along, wide * v)
        places = dict(
            zip(_names(name, 4), (place + s * along / 2 + t * wide / 2 * v for s in (-1, 1) for t in (-1, 1)), strict=True)
        )
        one, two, three, four = places
        return Draft(
            kind="parallelogram",
            places=places,
            first=[one, two],
            second=[three, four],
            bars=[(one, three), (two, four)],
            hinges=[Hinge(axis=(one,), start=two, end=three)],
        )

    return sized(model, name, pair, size, draft)


def _double(name: str, place: Any, along: Any, across: Any) -> Draft:
    """Feet 1, 2; triangle 3, 4, 5; heads 6, 7: links 1-3, 2-4 along, links 4-6, 5-7 across."""
    aside = np.array([-along[1], along[0]])
    three, four = along - across / 2, along + across / 2
    five = four + along
    spots = (-across / 2, across / 2, three, four, five, four + aside, five + aside)
    places = {key: place + spot for key, spot in zip(_names(name, 7), spots, strict=True)}
    n = list(places)
    links = [(n[0], n[2]), (n[1], n[3]), (n[3], n[5]), (n[4], n[6])]
    triangle = [(n[2], n[3]), (n[3], n[4]), (n[2], n[4])]
    hinges = [Hinge(axis=(n[0],), start=n[1], end=n[2]), Hinge(axis=(n[3],), start=n[4], end=n[5])]
    return Draft(kind="double_parallelogram", places=places, first=n[:2], second=n[5:], bars=[*links, *triangle], hinges=hinges)


def prismatic_in_plane(
    model: Model,
    name: str,
    *,
    bodies: Sequence[str],
    at: Any,
    axis: Any,
    size: float | None = None,
    form: Literal["linkage", "direct"] = "linkage",
) -> Model:
    """`joints.prismatic` of a planar model."""
    pair, place, u, v = _stand(model, name, bodies, at, axis)

    def draft(_: Model, length: float) -> Draft:
        return _cells(name, place, u, v, length) if form == "linkage" else _direct(name, place, u, length)

    return sized(model, name, pair, size, draft)


def _cells(name: str, place: Any, u: Any, v: Any, size: float) -> Draft:
    """Two cells side by side whose points P and R move on one line through the place; each has its O at `size` from it."""
    side, near = SIDE * size, RATIO * size
    arm = math.sqrt(RATIO * size**2 + side**2)
    along = (arm**2 - side**2 + near**2) / (2 * near)
    off = math.sqrt(arm**2 - along**2)
    places: dict[str, Any] = {}
    bars = []
    for k, shift in (("1", 0.0), ("2", size)):
        foot = place + shift * u - size * v
        local = {"O": (0, 0), "E": (near / 2, 0), "N": (near, 0), "S": (along, off), "T": (along, -off), "P": (size, 0)}
        places |= {f"{name}.{key}{k}": foot + a * v + b * u for key, (a, b) in local.items()}
        bars += [(f"{name}.{foot_}{k}", f"{name}.{top}{k}") for foot_ in "ONP" for top in "ST"] + [
            (f"{name}.E{k}", f"{name}.N{k}")
        ]
    places[f"{name}.F"] = place - 2 * size * u
    own = [f"{name}.{key}{k}" for k in "12" for key in "OE"] + [f"{name}.F"]
    heads = [f"{name}.P1", f"{name}.P2"]
    return Draft(kind="prismatic", places=places, first=own, second=heads, bars=bars, slide=(f"{name}.F", heads[0]))


def _direct(name: str, place: Any, u: Any, size: float) -> Draft:
    """Two points of the second body on a line of the first, kept there by couplings."""
    line, points = (f"{name}.F", f"{name}.R"), (f"{name}.P1", f"{name}.P2")
    spots = (place - 2 * size * u, place - size * u, place, place + size * u)
    return Draft(
        kind="prismatic",
        places=dict(zip((*line, *points), spots, strict=True)),
        first=line,
        second=points,
        slide=(line[0], points[0]),
        couplings={point: Coupling(terms=((OffsetCoordinate(line=line, point=point), 1.0),), value=0.0) for point in points},
    )


def _stand(model: Model, name: str, bodies: Sequence[str], at: Any, axis: Any) -> tuple[tuple[str, str], Any, Any, Any]:
    """The bodies, the place, the direction of the axis, and the one to its left."""
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 2)
    u = direction(name, "axis", axis, 2)
    return pair, place, u, np.array([-u[1], u[0]])


def _names(name: str, count: int) -> list[str]:
    return [f"{name}.{k + 1}" for k in range(count)]
