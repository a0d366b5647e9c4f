"""Functions of node positions written as arithmetic: straight-line programs, an operation a line, each made once.

Who runs them: kernels.coordinates.tape, operation by operation, for series in time and for programs made at run time;
kernels.coordinates.straight_line, as compiled code, for those that are known beforehand.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

NODE_AT, PARAMETER, CONSTANT, ADD, SUBTRACT, MULTIPLY, DIVIDE, ROOT, ANGLE_OF, SINE, COSINE = range(11)
ABOVE, EXPONENTIAL, LOGARITHM, TANH, CHOICE = range(11, 16)
"""Operations of laws (kernels.coordinates.node_laws) besides; coordinates, which need second rates and series, have none."""
TWO = (ADD, SUBTRACT, MULTIPLY, DIVIDE, ANGLE_OF, ABOVE)
"""Operations on two others."""


class Operation(NamedTuple):
    """op : what is done. a, b : with which earlier operations, or the flat coordinate of a node, or a parameter. number : of a
    constant. c : of an angle, the square of its radius; of a sine its cosine, of a cosine its sine; of a choice the other.
    """

    op: int
    a: int = 0
    b: int = 0
    number: float = 0.0
    c: int = 0


class Scalar:
    """A number that the program computes: operation `index`; constants are folded."""

    __slots__ = ("constant", "index", "program")

    def __init__(self, program: Program, index: int, constant: float | None = None) -> None:
        self.program, self.index, self.constant = program, index, constant

    def __add__(self, other: Any) -> Scalar:
        return self.program.made(ADD, self, other)

    def __sub__(self, other: Any) -> Scalar:
        return self.program.made(SUBTRACT, self, other)

    def __mul__(self, other: Any) -> Scalar:
        return self.program.made(MULTIPLY, self, other)

    def __truediv__(self, other: Any) -> Scalar:
        return self.program.made(DIVIDE, self, other)

    def __rsub__(self, other: Any) -> Scalar:
        return self.program.made(SUBTRACT, other, self)

    def __neg__(self) -> Scalar:
        return self * -1.0

    def __rtruediv__(self, other: Any) -> Scalar:
        return self.program.made(DIVIDE, other, self)

    __radd__, __rmul__ = __add__, __mul__


Vector = tuple[Any, Any, Any]
_FOLDED: dict[int, Callable[[float, float], float]] = {
    ADD: lambda a, b: a + b,
    SUBTRACT: lambda a, b: a - b,
    MULTIPLY: lambda a, b: a * b,
    DIVIDE: lambda a, b: a / b,
    ROOT: lambda a, _: math.sqrt(a),
    ANGLE_OF: math.atan2,
    COSINE: lambda a, _: math.cos(a),
    ABOVE: lambda a, p: a**p if a > 0.0 else 0.0,
    EXPONENTIAL: lambda a, _: math.exp(a),
    LOGARITHM: lambda a, _: math.log(a),
    TANH: lambda a, _: math.tanh(a),
}


class Program:
    """Operations one after the other, each made once; results with their periods (0: none)."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self.results: list[tuple[Scalar, float]] = []
        self.parameters = 0
        self._known: dict[Operation, int] = {}

    def _put(self, operation: Operation) -> int:
        if operation not in self._known:
            self._known[operation] = len(self.operations)
            self.operations.append(operation)
        return self._known[operation]

    def number(self, value: float) -> Scalar:
        """A constant."""
        return Scalar(self, self._put(Operation(CONSTANT, number=float(value))), float(value))

    def coordinate(self, flat: int) -> Scalar:
        """A flat coordinate of the nodes."""
        return Scalar(self, self._put(Operation(NODE_AT, flat)))

    def node(self, i: int, dim: int) -> Vector:
        """Position of node i; z is 0 in the plane."""
        z = self.coordinate(3 * i + 2) if dim == 3 else self.number(0.0)
        return (self.coordinate(3 * i), self.coordinate(3 * i + 1), z)

    def parameter(self) -> Scalar:
        """A new number that is given in time."""
        self.parameters += 1
        return Scalar(self, self._put(Operation(PARAMETER, self.parameters - 1)))

    def scalar(self, value: Any) -> Scalar:
        """A number of the program, or a constant."""
        return value if isinstance(value, Scalar) else self.number(value)

    def made(self, op: int, a: Any, b: Any) -> Scalar:
        """The result of an operation; of constants a constant, and what 0 and 1 leave as it is stays."""
        left, right = self.scalar(a), self.scalar(b)
        p, q = left.constant, right.constant
        if p is not None and q is not None:
            return self.number(_FOLDED[op](p, q))
        if (op in (ADD, SUBTRACT) and q == 0.0) or (op in (MULTIPLY, DIVIDE) and q == 1.0):
            return left
        if (op == ADD and p == 0.0) or (op == MULTIPLY and p == 1.0):
            return right
        if op in (MULTIPLY, DIVIDE) and p == 0.0:
            return left
        if op == MULTIPLY and q == 0.0:
            return right
        if op == ANGLE_OF:
            # its series needs that of the square of the radius
            return Scalar(self, self._put(Operation(op, left.index, right.index, c=(left * left + right * right).index)))
        if op == COSINE:
            return Scalar(self, self._cosine(left.index))
        return Scalar(self, self._put(Operation(op, left.index, right.index)))

    def choice(self, a: Any, b: Any, c: Any) -> Scalar:
        """b where a > 0, else c."""
        of, then, other = self.scalar(a), self.scalar(b), self.scalar(c)
        if of.constant is not None:
            return then if of.constant > 0.0 else other
        return Scalar(self, self._put(Operation(CHOICE, of.index, then.index, c=other.index)))

    def _cosine(self, a: int) -> int:
        """A cosine, behind the sine that its series needs, and that needs its own."""
        for j, one in enumerate(self.operations):
            if one.op == COSINE and one.a == a:
                return j
        sine = len(self.operations)
        self._put(Operation(SINE, a, c=sine + 1))
        return self._put(Operation(COSINE, a, c=sine))

    def result(self, value: Scalar, period: float = 0.0) -> None:
        """A coordinate that is to be 0, or a whole number of periods."""
        self.results.append((value, period))

    def reads(self, value: Any) -> list[int]:
        """Flat coordinates on which a value depends, ascending."""
        if not isinstance(value, Scalar):
            return []
        found, seen, new = set[int](), set[int](), {value.index}
        while new:
            seen |= new
            ones = [self.operations[j] for j in new]
            found |= {one.a for one in ones if one.op == NODE_AT}
            new = {j for one in ones if one.op > CONSTANT for j in operands(one)} - seen
        return sorted(found)


def operands(one: Operation) -> tuple[int, ...]:
    """The operations on which one depends."""
    if one.op == CHOICE:
        return one.a, one.b, one.c
    return (one.a, one.b) if one.op in TWO else (one.a,)


def dot(a: Vector, b: Vector) -> Any:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def total(vectors: Sequence[Vector], factors: Sequence[float]) -> Vector:
    """Sum of factors times vectors."""
    x, y, z = (sum((one[c] * f for one, f in zip(vectors[1:], factors[1:], strict=True)), vectors[0][c] * factors[0])
               for c in range(3))  # fmt: skip
    return (x, y, z)


def root(a: Scalar) -> Scalar:
    """Square root."""
    return a.program.made(ROOT, a, 0.0)


def angle(s: Scalar, c: Any) -> Scalar:
    """atan2(s, c)."""
    return s.program.made(ANGLE_OF, s, c)


def cosine(a: Scalar) -> Scalar:
    """cos(a)."""
    return a.program.made(COSINE, a, 0.0)


def above(a: Scalar, power: Any = 1.0) -> Scalar:
    """max(a, 0)^power."""
    return a.program.made(ABOVE, a, power)


def exponential(a: Scalar) -> Scalar:
    """exp(a)."""
    return a.program.made(EXPONENTIAL, a, 0.0)


def logarithm(a: Scalar) -> Scalar:
    """Natural logarithm."""
    return a.program.made(LOGARITHM, a, 0.0)


def tanh(a: Scalar) -> Scalar:
    """tanh(a)."""
    return a.program.made(TANH, a, 0.0)


def choice(a: Scalar, b: Any, c: Any) -> Scalar:
    """b where a > 0, else c. Both are computed: where one is not taken it must still be a number."""
    return a.program.choice(a, b, c)


def size(a: Vector) -> Scalar:
    """Length of a vector."""
    return root(dot(a, a))


def speed(v: Vector) -> Scalar:
    """Length of a velocity, which may be 0: then its derivatives are 0 too."""
    square = dot(v, v)
    return choice(square, root(choice(square, square, 1.0)), 0.0)


def unit(a: Vector) -> Vector:
    """Direction of a vector."""
    length = size(a)
    return (a[0] / length, a[1] / length, a[2] / length)
