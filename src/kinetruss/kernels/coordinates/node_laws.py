"""Laws of elements on nodes, written once, as expressions of positions, velocities, numbers and time.

A law may have an energy, from which its conservative forces follow; other forces, which do not follow from one; and values that
a person reads. The energy's gradient and curvature, the derivatives of the forces and values along any change of positions and
velocities, and code for kernels are made from the expressions (kernels.coordinates.straight_line), so a law is exact to
round-off in all engines.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

from numba import types

from kinetruss.kernels.coordinates import straight_line
from kinetruss.kernels.coordinates.programs import Program, Scalar, Vector
from kinetruss.kernels.coordinates.straight_line import Lines, address_of

Numbers = Sequence[Any]
_INTS: Any = types.CPointer(types.int64)  # type: ignore[no-untyped-call]
_REALS: Any = types.CPointer(types.float64)  # type: ignore[no-untyped-call]
ENERGY = types.float64(_INTS, _REALS, _REALS)
"""at, data, x -> the energy, J."""
GRADIENT = types.void(_INTS, _REALS, _REALS, _REALS)
"""at, data, x, out: its gradient by the coordinates of the nodes into out (3 n,)."""
CURVATURE = types.void(_INTS, _REALS, _REALS, _REALS, _REALS)
"""at, data, x, dx, out: the same, and the Hessian times dx behind it."""
VALUES = types.void(_INTS, _REALS, types.float64, _REALS, _REALS, _REALS)
"""at, data, t, x, v, out: forces on the nodes (3 n,), or values."""
SLOPES = types.void(_INTS, _REALS, types.float64, _REALS, _REALS, _REALS, _REALS, _REALS)
"""at, data, t, x, v, dx, dv, out: the same, and behind them their change to first order with dx and dv."""


class Value(NamedTuple):
    """What a person reads of an element: make(t, nodes, rates, numbers) -> a number or a vector; its unit, and what it is."""

    make: Callable[[Any, Sequence[Vector], Sequence[Vector], Numbers], Any]
    unit: str
    words: str


class NodeLaw(NamedTuple):
    """energy(nodes, numbers) -> J, from the positions of the nodes. force(t, nodes, rates, numbers) -> the forces (N) on the
    nodes, one vector each, besides those of the energy. values : by name. The numbers are those of an element.
    """

    energy: Callable[[Sequence[Vector], Numbers], Any] | None = None
    force: Callable[[Any, Sequence[Vector], Sequence[Vector], Numbers], Sequence[Vector]] | None = None
    values: Mapping[str, Value] = {}


@cache
def addresses(energy: Any, force: Any, count: int, width: int) -> tuple[int, ...]:
    """Addresses of energy, gradient, curvature, force and its slopes, 0 where there is none: of `count` nodes and `width`
    numbers.
    """
    found = [0] * 5
    if energy is not None:
        for order, signature in enumerate((ENERGY, GRADIENT, CURVATURE), -1):
            found[order + 1] = _made("energy", _text_of(_energy_text, energy, count, width, order), signature)
    if force is not None:
        found[3:] = _outputs("force", force, count, width)
    return tuple(found)


@cache
def addresses_of_value(make: Any, count: int, width: int) -> tuple[int, int]:
    """Addresses of a value and of its slopes."""
    return _outputs("value", make, count, width)


@cache
def size_of(make: Any, count: int, width: int) -> int:
    """How many numbers a value has: 1, or 3 of a vector."""
    return len(_found(Program(), make, count, width))


def _outputs(name: str, make: Any, count: int, width: int) -> tuple[int, int]:
    first, second = (_made(name, _text_of(_output_text, make, count, width, order), form) for order, form in _FORMS)
    return first, second


_FORMS = ((0, VALUES), (1, SLOPES))


def _text_of(text: Callable[..., str], *given: Any) -> Callable[[str], str]:
    """The text of a function, from its name."""
    return lambda name: text(name, *given)


def _made(name: str, text: Callable[[str], str], signature: Any) -> int:
    return address_of(f"law_{name}", text, signature, straight_line)


def _vectors(program: Program, first: int, count: int) -> list[Vector]:
    """Positions of the nodes, which come first, or their velocities, which come behind them."""
    return [program.node(first + i, 3) for i in range(count)]


def _numbers(program: Program, width: int) -> list[Scalar]:
    return [program.parameter() for _ in range(width)]


def _found(program: Program, make: Any, count: int, width: int) -> list[Any]:
    """The numbers that a function of time, positions, velocities and numbers gives; the time is the last parameter."""
    numbers = _numbers(program, width)
    return _flat(make(program.parameter(), _vectors(program, 0, count), _vectors(program, count, count), numbers))


def _flat(found: Any) -> list[Any]:
    """Numbers, and those of vectors and of several, one behind the other."""
    return [number for one in found for number in _flat(one)] if isinstance(found, list | tuple) else [found]


def _lines(program: Program, count: int, order: int) -> Lines:
    def read(a: int, k: int) -> str:
        kind, node = ("v", a // 3 - count) if a >= 3 * count else ("x", a // 3)
        return f"{'d' * k}{kind}[n{node} + {a % 3}]"

    lines = Lines(program.operations, order, read, "data[{}]", first=0)
    lines.forward()
    return lines


def _whole(name: str, given: str, count: int, lines: Lines) -> str:
    """The text of a function of these arguments."""
    head = [f"n{i} = at[{i}]" for i in range(count)]
    return "\n    ".join([f"def {name}({given}):", *head, *lines.text]) + "\n"


def _energy_text(name: str, make: Any, count: int, width: int, order: int) -> str:
    program = Program()
    value = program.scalar(make(_vectors(program, 0, count), _numbers(program, width)))
    lines = _lines(program, count, max(order, 0))
    if order < 0:
        lines.add(f"return {lines.of(value.index, 0)}")
    else:
        lines.backward({value.index: "1.0"})
        lines.write_gradient(range(3 * count))
    return _whole(name, f"at, data, x{', dx' * (order > 0)}{', out' * (order >= 0)}", count, lines)


def _output_text(name: str, make: Any, count: int, width: int, order: int) -> str:
    program = Program()
    found = [program.scalar(one) for one in _found(program, make, count, width)]
    lines = _lines(program, count, order)
    for k in range(order + 1):
        for i, one in enumerate(found):
            lines.add(f"out[{len(found) * k + i}] = {lines.of(one.index, k) or 0.0}")
    # the parameter behind the numbers is the time
    return _whole(name, f"at, data, t, x, v{', dx, dv' * order}, out", count, lines).replace(f"data[{width}]", "t")
