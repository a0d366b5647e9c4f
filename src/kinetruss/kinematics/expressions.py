"""Functions of node positions written as arithmetic, and the straight-line program that kernels run for them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.tasks import tape as kernel
from kinetruss.kernels.tasks.tape import Tape

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray


class Scalar:
    """A number that the program computes: operation `index`; constants are folded."""

    __slots__ = ("constant", "index", "program")

    def __init__(self, program: Program, index: int, constant: float | None = None) -> None:
        self.program, self.index, self.constant = program, index, constant

    def __add__(self, other: Any) -> Scalar:
        return self.program.made(kernel.ADD, self, other)

    def __sub__(self, other: Any) -> Scalar:
        return self.program.made(kernel.SUBTRACT, self, other)

    def __mul__(self, other: Any) -> Scalar:
        return self.program.made(kernel.MULTIPLY, self, other)

    def __truediv__(self, other: Any) -> Scalar:
        return self.program.made(kernel.DIVIDE, self, other)

    def __neg__(self) -> Scalar:
        return self * -1.0

    __radd__, __rmul__ = __add__, __mul__


Vector = tuple[Any, Any, Any]
_FOLDED = {
    kernel.ADD: lambda a, b: a + b,
    kernel.SUBTRACT: lambda a, b: a - b,
    kernel.MULTIPLY: lambda a, b: a * b,
    kernel.DIVIDE: lambda a, b: a / b,
    kernel.ROOT: lambda a, _: math.sqrt(a),
    kernel.ANGLE_OF: math.atan2,
}


class Program:
    """Operations one after the other, each made once."""

    def __init__(self) -> None:
        self.operations: list[tuple[int, int, int, float]] = []
        self.results: list[tuple[Scalar, float]] = []
        self.parameters = 0
        self._known: dict[tuple[int, int, int, float], int] = {}

    def _put(self, op: int, a: int = 0, b: int = 0, number: float = 0.0) -> int:
        key = (op, a, b, number)
        if key not in self._known:
            self._known[key] = len(self.operations)
            self.operations.append(key)
        return self._known[key]

    def number(self, value: float) -> Scalar:
        """A constant."""
        return Scalar(self, self._put(kernel.CONSTANT, number=float(value)), float(value))

    def node(self, i: int, dim: int) -> Vector:
        """Position of node i; z is 0 in the plane."""
        places = [Scalar(self, self._put(kernel.NODE_AT, 3 * i + c)) for c in range(dim)]
        return (places[0], places[1], places[2] if dim == 3 else self.number(0.0))

    def parameter(self) -> Scalar:
        """A new number that is given in time."""
        self.parameters += 1
        return Scalar(self, self._put(kernel.PARAMETER, self.parameters - 1))

    def _scalar(self, value: Any) -> Scalar:
        return value if isinstance(value, Scalar) else self.number(value)

    def made(self, op: int, a: Any, b: Any) -> Scalar:
        """The result of an operation; of constants a constant, and what 0 and 1 leave as it is stays."""
        left, right = self._scalar(a), self._scalar(b)
        p, q = left.constant, right.constant
        if p is not None and q is not None:
            return self.number(_FOLDED[op](p, q))
        if (op in (kernel.ADD, kernel.SUBTRACT) and q == 0.0) or (op in (kernel.MULTIPLY, kernel.DIVIDE) and q == 1.0):
            return left
        if (op == kernel.ADD and p == 0.0) or (op == kernel.MULTIPLY and p == 1.0):
            return right
        if op in (kernel.MULTIPLY, kernel.DIVIDE) and p == 0.0:
            return left
        if op == kernel.MULTIPLY and q == 0.0:
            return right
        return Scalar(self, self._put(op, left.index, right.index))

    def result(self, value: Scalar, period: float = 0.0) -> None:
        """A coordinate that is to be 0, or a whole number of periods."""
        self.results.append((value, period))

    def tape(self, tasks: int) -> Tape:
        """The program; `tasks` of its results are of tasks."""
        op, a, b, number = zip(*self.operations, strict=True)
        out, period = zip(*((value.index, period) for value, period in self.results), strict=True)
        return Tape.of({"tasks": tasks, "op": op, "a": a, "b": b, "number": number, "out": out, "period": period})

    def values(self, tape: Tape, x: NDArray[np.float64], p: NDArray[np.float64]) -> NDArray[np.float64]:
        """Results (times, r) at flat positions x (times, 3 n) and parameters p (times, parameters)."""
        out = np.zeros((len(x), len(tape.out)))
        kernel.evaluate(tape, np.ascontiguousarray(x), np.ascontiguousarray(p), np.zeros((3, len(tape.op))), out)
        return out


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
    return a.program.made(kernel.ROOT, a, 0.0)


def angle(s: Scalar, c: Any) -> Scalar:
    """atan2(s, c)."""
    return s.program.made(kernel.ANGLE_OF, s, c)


def size(a: Vector) -> Scalar:
    """Length of a vector."""
    return root(dot(a, a))


def unit(a: Vector) -> Vector:
    """Direction of a vector."""
    length = size(a)
    return (a[0] / length, a[1] / length, a[2] / length)
