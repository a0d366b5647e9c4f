"""The kinds of coordinates of nodes. Each is an expression of the positions of up to four nodes and of some numbers.

A new kind is a function here and an entry in FORMS; value, gradient, curvature, series, what it depends on, and code for
kernels follow from it (kernels.coordinates.programs, straight_line).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from kinetruss.kernels.coordinates.programs import Vector, angle, cosine, cross, dot, minus, root, size

Numbers = Sequence[Any]


class Form(NamedTuple):
    """make : the value from the positions of the nodes and six numbers. nodes : how many it reads."""

    make: Callable[[Sequence[Vector], Numbers], Any]
    nodes: int


def along(nodes: Sequence[Vector], numbers: Numbers) -> Any:  # noqa: ARG001
    """Length of the line from node 1 to P."""
    P, one = nodes
    return size(minus(P, one))


def fixed_axis(nodes: Sequence[Vector], numbers: Numbers) -> Any:
    """Angle of the line from node 1 to P about a fixed axis: from the first unit vector towards the second."""
    P, one = nodes
    r = minus(P, one)
    return angle(dot(r, _second(numbers)), dot(r, _first(numbers)))


def around(nodes: Sequence[Vector], numbers: Numbers) -> Any:  # noqa: ARG001
    """Angle about the axis from node 1 to node 2, from the half-plane of B to that of P (Blondel & Karplus 1996)."""
    P, one, two, B = nodes
    b = minus(two, one)
    p, q = cross(b, minus(B, one)), cross(b, minus(P, one))
    return angle(dot(b, cross(p, q)) / size(b), dot(p, q))


def offset(nodes: Sequence[Vector], numbers: Numbers) -> Any:  # noqa: ARG001
    """Distance of P from the line from node 1 to node 2 in the plane, to its left."""
    P, one, two = nodes
    b, r = minus(two, one), minus(P, one)
    return (b[0] * r[1] - b[1] * r[0]) / root(b[0] * b[0] + b[1] * b[1])


def beside(nodes: Sequence[Vector], numbers: Numbers) -> Any:
    """Distance of P from the line from node 1 to node 2 in space, along normals of the line.

    With the first unit vector n and the line b they are n x b and what of n is normal to b, both as unit vectors; the fourth
    and the fifth number are their shares.
    """
    P, one, two = nodes
    b, r, n = minus(two, one), minus(P, one), _first(numbers)
    side, long = cross(n, b), size(b)
    toward = dot(n, r) * long - dot(n, b) * dot(r, b) / long
    return (numbers[3] * dot(side, r) + numbers[4] * toward) / size(side)


def place(nodes: Sequence[Vector], numbers: Numbers) -> Any:
    """The coordinate of P along a direction."""
    return dot(nodes[0], _first(numbers))


def cosine_of(nodes: Sequence[Vector], numbers: Numbers) -> Any:
    """Cosine of the x coordinate of P, which is an angle, and a phase."""
    return cosine(nodes[0][0] + numbers[0])


def product(nodes: Sequence[Vector], numbers: Numbers) -> Any:  # noqa: ARG001
    """Scalar product of the edges from node 1 to P and from node B to node 2."""
    P, one, two, B = nodes
    return dot(minus(P, one), minus(two, B))


def _first(numbers: Numbers) -> Vector:
    return numbers[0], numbers[1], numbers[2]


def _second(numbers: Numbers) -> Vector:
    return numbers[3], numbers[4], numbers[5]


ALONG, FIXED_AXIS, AROUND, OFFSET, NODE, COSINE, PRODUCT, BESIDE = range(8)
FORMS = (
    Form(along, 2), Form(fixed_axis, 2), Form(around, 4), Form(offset, 3), Form(place, 1), Form(cosine_of, 1), Form(product, 4),
    Form(beside, 3),
)  # fmt: skip
