"""Joints of the plane that slide: parallelograms, and Peaucellier's linkage twice."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from kinetruss.library._arguments import own_arguments
from kinetruss.library.joints.joining import Draft, direction, pair_of, sized, start
from kinetruss.model import Coupling, Hinge, Model, OffsetCoordinate

__all__ = ["parallelogram", "prismatic_in_plane"]

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
