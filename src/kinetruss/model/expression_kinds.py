"""What expressions measure, and in which unit: their constants, and functions of places and numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from kinetruss.kernels.coordinates.programs import angle, cosine, cross, dot, minus, root, size, unit
from kinetruss.model.measured_forces import ExpressionError
from kinetruss.units import dimension_of, parse, text_of


class Kind(NamedTuple):
    """What a tree measures: a vector or a number, of the unit m^length s^time rad^turn kg^mass A^current."""

    vector: bool = False
    length: Fraction = Fraction(0)
    time: Fraction = Fraction(0)
    turn: Fraction = Fraction(0)
    mass: Fraction = Fraction(0)
    current: Fraction = Fraction(0)

    @property
    def unit(self) -> str:
        """SI unit, as text; empty for a plain number. Radians of a length are none: r times an angle is in m."""
        return text_of(self.mass, self.length, self.time, self.current, self.turn)

    def times(self, other: Kind, sign: int = 1) -> Kind:
        """The kind of a product, or of a quotient."""
        powers = (a + sign * b for a, b in zip(self[1:], other[1:], strict=True))
        return Kind(self.vector or other.vector, *powers)

    def to(self, power: Fraction) -> Kind:
        """The kind of a power."""
        return Kind(self.vector, *(power * one for one in self[1:]))


class Frequency(Kind):
    """1/s that are cycles in a second: in Hz, until they are multiplied by something, such as 2 pi."""

    @property
    def unit(self) -> str:
        """Hz."""
        return "Hz"


def in_unit(text: str, vector: bool = False) -> Kind:
    """The kind of what is measured in a unit."""
    mass, length, time, current, turn = map(Fraction, dimension_of(text))
    return (Frequency if text == "Hz" else Kind)(vector, length, time, turn, mass, current)


NUMBER, LENGTH, ANGLE = Kind(), Kind(length=Fraction(1)), Kind(turn=Fraction(1))
PLACE = Kind(vector=True, length=Fraction(1))
CONSTANTS: dict[str, tuple[float, Kind]] = {
    "pi": (math.pi, NUMBER),
    "deg": (math.pi / 180, ANGLE),
    "rad": (1.0, ANGLE),
    "m": (1.0, LENGTH),
    "mm": (1e-3, LENGTH),
    "s": (1.0, Kind(time=Fraction(1))),
}
FORCE_UNITS: dict[str, tuple[float, Kind]] = {
    name: (parse(f"1 {name}", "measure"), in_unit(name)) for name in ("N", "kN", "Pa", "MPa", "bar", "W", "kW")
}
"""Constants that give way to a part of the model with their name."""
AXES = {"ex": (1.0, 0.0, 0.0), "ey": (0.0, 1.0, 0.0), "ez": (0.0, 0.0, 1.0)}


# Functions: what they take, what they give, and how their expression is made.


class Function(NamedTuple):
    """given : of the arguments, ``v`` a vector, ``s`` a number; choices are several. kind : of the result from those of the
    arguments, and whether the model is planar. make : the result from the arguments.
    """

    given: tuple[str, ...]
    kind: Callable[[Sequence[Kind]], Kind]
    make: Callable[..., Any]
    says: str
    only: int = 0
    """The only number of dimensions in which it has a meaning; 0: any."""


def _sine(a: Any) -> Any:
    return cosine(a - 0.5 * math.pi)


def _meeting(A: Any, B: Any, C: Any, D: Any, n: Any) -> Any:
    """The point of the line A B that, seen along n, is on the line C D."""
    along, across = minus(B, A), minus(D, C)
    s = dot(n, cross(minus(C, A), across)) / dot(n, cross(along, across))
    return tuple(a + s * d for a, d in zip(A, along, strict=True))


def _about(u: Any, v: Any, n: Any) -> Any:
    """Angle from u to v, right-handed about n, both seen along n (Blondel & Karplus, J. Comput. Chem. 17 (1996) 1132)."""
    p, q = cross(n, u), cross(n, v)
    return angle(dot(n, cross(p, q)) / size(n), dot(p, q))


def _like(k: int) -> Callable[[Sequence[Kind]], Kind]:
    return lambda given: given[k]


def _angle_kind(_: Sequence[Kind]) -> Kind:
    return ANGLE


def _plain(given: Sequence[Kind]) -> Kind:
    """A plain number of an angle or a plain number."""
    if given[0].length or given[0].time or given[0].mass or given[0].current:
        raise ExpressionError(
            f"takes an angle or a plain number, not one in {given[0].unit}.", "Divide by a quantity of that unit."
        )
    return NUMBER


def _of_plain(given: Sequence[Kind]) -> Kind:
    _plain(given)
    return ANGLE


def _alike(given: Sequence[Kind]) -> Kind:
    """That of the first, of arguments of one unit."""
    for one in given[1:]:
        same_unit(given[0], one)
    return given[0]


def _no_vector(kind: Kind) -> Kind:
    return kind._replace(vector=False)


FUNCTIONS: dict[str, tuple[Function, ...]] = {
    "length": (Function(("v",), lambda k: _no_vector(k[0]), size, "of a vector, or of a member"),),
    "distance": (Function(("v", "v"), lambda k: _no_vector(_alike(k)), lambda a, b: size(minus(b, a)), "of two places"),),
    "dot": (Function(("v", "v"), lambda k: _no_vector(k[0].times(k[1])), dot, "scalar product"),),
    "cross": (Function(("v", "v"), lambda k: k[0].times(k[1]), cross, "vector product"),),
    "unit": (Function(("v",), lambda _: Kind(vector=True), unit, "direction of a vector"),),
    "normal": (
        Function(
            ("v", "v", "v"),
            lambda _: Kind(vector=True),
            lambda a, b, c: unit(cross(minus(b, a), minus(c, a))),
            "direction normal to the plane of three places, right-handed",
        ),
    ),
    "angle": (
        Function(("v",), _angle_kind, lambda u: angle(u[1], u[0]), "in the plane from +x counter-clockwise", only=2),
        Function(
            ("v", "v"),
            _angle_kind,
            lambda u, v: angle(u[0] * v[1] - u[1] * v[0], dot(u, v)),
            "in the plane from the first to the second, counter-clockwise",
            only=2,
        ),
        Function(("v", "v"), _angle_kind, lambda u, v: angle(size(cross(u, v)), dot(u, v)), "of two directions, 0 to pi"),
        Function(("v", "v", "v"), _angle_kind, _about, "from the first to the second, right-handed about the third", only=3),
    ),
    "meet": (
        Function(
            ("v", "v", "v", "v"),
            _alike,
            lambda A, B, C, D: _meeting(A, B, C, D, (0.0, 0.0, 1.0)),
            "the point where the line of the first two places meets that of the others",
            only=2,
        ),
        Function(
            ("v", "v", "v", "v", "v"),
            lambda k: _alike(k[:4]),
            _meeting,
            "the point of the line of the first two places that, seen along the last, is on the line of the others",
            only=3,
        ),
    ),
    "sqrt": (Function(("s",), lambda k: k[0].to(Fraction(1, 2)), root, "square root"),),
    "abs": (Function(("s",), _like(0), lambda a: root(a * a), "magnitude"),),
    "sin": (Function(("s",), _plain, _sine, "sine"),),
    "cos": (Function(("s",), _plain, cosine, "cosine"),),
    "tan": (Function(("s",), _plain, lambda a: _sine(a) / cosine(a), "tangent"),),
    "asin": (Function(("s",), _of_plain, lambda a: angle(a, root(1.0 - a * a)), "arc sine"),),
    "acos": (Function(("s",), _of_plain, lambda a: angle(root(1.0 - a * a), a), "arc cosine"),),
    "atan": (Function(("s",), _of_plain, lambda a: angle(a, 1.0), "arc tangent, over any number of turns"),),
    "atan2": (
        Function(("s", "s"), lambda k: (_alike(k), ANGLE)[1], angle, "angle of (second, first), over any number of turns"),
    ),
}


def function_of(op: str, given: Sequence[Kind], dim: int) -> Function:
    """The function of this name for these arguments; ExpressionError if there is none."""
    chosen = "".join("v" if one.vector else "s" for one in given)
    # in the plane the one with a sign comes first
    known: dict[str, Function] = {"".join(one.given): one for one in reversed(FUNCTIONS[op]) if one.only in (0, dim)}
    if chosen in known:
        return known[chosen]
    words = {"v": "vector", "s": "number"}
    has = ", ".join(f"a {words[letter]}" for letter in chosen) or "nothing"
    takes = (
        "; or ".join(", ".join(f"a {words[letter]}" for letter in letters) for letters in sorted(known, key=len))
        or "nothing here"
    )
    where = " in the plane" if dim == 2 else " in space"
    raise ExpressionError(f"{op}(...) takes {takes}{where if len(FUNCTIONS[op]) > 1 else ''}; it has {has}.", _written(op, dim))


def _written(op: str, dim: int) -> str:
    """How to write a function."""
    if op == "angle" and dim == 3:
        return "Write for example angle(one, other), or angle(one, other, ez)."
    return {"meet": "Write meet(A, B, C, D), in space meet(A, B, C, D, ex)."}.get(
        op, "A vector is a node, a member, a difference of places; a number is a component, as A.x, or a length."
    )


def same_unit(a: Kind, b: Kind) -> None:
    """Raise ExpressionError if two units do not match; angles are plain numbers."""
    if (a.length, a.time, a.mass, a.current) != (b.length, b.time, b.mass, b.current):
        one, other = (kind.unit or "plain" for kind in (a, b))
        mend = "Give a plain number its unit, as in 0.3*m, 20*mm, 5*deg." if NUMBER in (a, b) else "Mend one of them."
        raise ExpressionError(f"puts together what is in {one} and what is in {other}.", mend)
