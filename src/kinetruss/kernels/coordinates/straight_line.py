"""Compiled code of the kinds of coordinates, made from their expressions, reached by address and compiled when first asked for.

A kind has a value, a gradient, and the rates of its gradient along a motion: what an operation c of a and b is as a series in
time, c0 + c1 t + ..., and backwards the derivatives of the result by a and b (adjoints, series too), follows from those of its
operands (Griewank & Walther, Evaluating derivatives, 2008, chapters 3 and 13). Written out for every operation, what is known
to be zero is left out.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from numba import types
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel_entry
from kinetruss.kernels.coordinates import forms
from kinetruss.kernels.coordinates.forms import FORMS, Form
from kinetruss.kernels.coordinates.programs import (
    ABOVE,
    ADD,
    ANGLE_OF,
    CHOICE,
    CONSTANT,
    COSINE,
    DIVIDE,
    EXPONENTIAL,
    LOGARITHM,
    MULTIPLY,
    NODE_AT,
    PARAMETER,
    ROOT,
    SINE,
    SUBTRACT,
    TANH,
    Operation,
    Program,
)

_INTS: Any = types.CPointer(types.int64)  # type: ignore[no-untyped-call]
_REALS: Any = types.CPointer(types.float64)  # type: ignore[no-untyped-call]
_STATE = ("x", "v", "a")
VALUE = types.float64(_INTS, _REALS, _REALS)
"""at, data, x -> factor times the value."""
GRADIENT = types.void(_INTS, _REALS, _REALS, _REALS)
"""at, data, x, out: the gradient by P, 1, 2 and B, factor and all, into out (12,)."""
RATES = types.void(_INTS, _REALS, _REALS, _REALS, _REALS)
"""at, data, x, v, out: the gradient into out[:12], the Hessian times v into out[12:24]."""
SECOND = types.void(_INTS, _REALS, _REALS, _REALS, _REALS, _REALS)
"""at, data, x, v, a, out: the same, and the second rate of the gradient into out[24:36]."""


@cache
def addresses(kind: int) -> tuple[int, int, int]:
    """Addresses of value, gradient and rates of a kind."""
    return _compiled(kind, -1, VALUE), _compiled(kind, 0, GRADIENT), _compiled(kind, 1, RATES)


@cache
def address_of_second(kind: int) -> int:
    """Address of the second rates of a kind."""
    return _compiled(kind, 2, SECOND)


def addresses_of(kinds: NDArray[np.int64]) -> NDArray[np.int64]:
    """`addresses` of the kinds of terms, (terms, 3)."""
    found = np.zeros((len(FORMS), 3), np.int64)
    for kind in np.unique(kinds).tolist():
        found[kind] = addresses(kind)
    return found[kinds]


def _compiled(kind: int, order: int, signature: Any) -> int:
    """The address of the compiled text of a kind; order : of the rates of the gradient, -1 for the value."""
    form = FORMS[kind]
    name = f"{form.make.__name__}_{('value', 'gradient', 'rates', 'second')[order + 1]}"
    return address_of(name, lambda own: text(form, own, order), signature, forms)


def address_of(name: str, made_text: Callable[[str], str], signature: Any, module: Any) -> int:
    """The address of a compiled text, which is made from the name of its function; module : from whose file it follows."""
    # machine code is kept by the name, which says what the text is: it depends on this file, on `programs` and on the module
    name += "_" + hashlib.sha256(made_text(name).encode()).hexdigest()[:12]
    made: dict[str, Any] = {"math": math, "__name__": module.__name__}
    exec(compile(made_text(name), module.__file__, "exec"), made)  # noqa: S102
    function: Callable[..., Any] = made[name]
    return int(kernel_entry(signature)(function).address)


def text(form: Form, name: str, order: int) -> str:
    """Source of a function of the flat first coordinates `at` of the nodes, `data` (factor, six numbers) and of states."""
    program = Program()
    nodes = [program.node(i, 3) for i in range(form.nodes)]
    value = form.make(nodes, [program.parameter() for _ in range(6)])
    lines = Lines(program.operations, max(order, 0), _read, "data[{}]", first=1)
    lines.forward()
    if order < 0:
        lines.add(f"return data[0] * {lines.of(value.index, 0)}")
    else:
        lines.backward({value.index: "data[0]"})
        lines.write_gradient(range(12))
    given = ["at", "data", *_STATE[: max(order, 0) + 1], *(["out"] if order >= 0 else [])]
    head = [f"n{i} = at[{i}]" for i in range(form.nodes)]
    return "\n    ".join([f"def {name}({', '.join(given)}):", *head, *lines.text]) + "\n"


def _read(a: int, k: int) -> str:
    """Coefficient k of a flat coordinate of the nodes."""
    read = f"{_STATE[k]}[n{a // 3} + {a % 3}]"
    return f"0.5 * {read}" if k == 2 else read


class Lines:
    """Lines of code for the coefficients 0 to `order` of operations, and backwards of their adjoints.

    read : the code of coefficient k of coordinate a. parameter : that of a parameter, of whose number `first` more is put in.
    """

    def __init__(
        self, operations: list[Operation], order: int, read: Callable[[int, int], str], parameter: str, *, first: int
    ) -> None:
        self.operations, self.order = operations, order
        self._read, self._parameter, self._first = read, parameter, first
        self.text: list[str] = []
        self._known: dict[tuple[int, int], str] = {}
        self._adjoint: dict[tuple[int, int], str] = {}
        self._slope: dict[int, tuple[str, str]] = {}
        self._count = 0

    def add(self, line: str) -> None:
        """Append a line."""
        self.text.append(line)

    def named(self, expression: str) -> str:
        """A new variable of this value."""
        self._count += 1
        self.add(f"t{self._count} = {expression}")
        return f"t{self._count}"

    def of(self, j: int, k: int) -> str:
        """Coefficient k of operation j; empty if it is zero."""
        return self._known.get((j, k), "")

    def forward(self) -> None:
        """All coefficients of all operations."""
        for k in range(self.order + 1):
            for j, operation in enumerate(self.operations):
                if found := self._coefficient(j, operation, k):
                    self._known[j, k] = found if found.isidentifier() else self.named(found)

    def _coefficient(self, j: int, one: Operation, k: int) -> str:
        a, b = one.a, one.b
        if one.op == NODE_AT:
            return self._read(a, k)
        if one.op == PARAMETER:
            return self._parameter.format(a + self._first) if k == 0 else ""
        if one.op == CONSTANT:
            return repr(one.number) if k == 0 else ""
        if one.op in (ADD, SUBTRACT):
            return _sum([self.of(a, k)], [self.of(b, k)]) if one.op == SUBTRACT else _sum([self.of(a, k), self.of(b, k)])
        if one.op == MULTIPLY:
            return _sum(self._product(a, b, k))
        if one.op == CHOICE:
            then, other = self.of(b, k), self.of(one.c, k)
            return f"({then or 0.0} if {self.of(a, 0)} > 0.0 else {other or 0.0})" if then or other else ""
        if k == 0:
            x = self.of(a, 0)
            if one.op == DIVIDE:
                return f"{x} / {self.of(b, 0)}"
            angle = f"math.atan2({x}, {self.of(b, 0)})" if one.op == ANGLE_OF else ""
            above = f"({x} ** {self.of(b, 0)} if {x} > 0.0 else 0.0)" if one.op == ABOVE else ""
            return {
                ROOT: f"math.sqrt({x})",
                SINE: f"math.sin({x})",
                COSINE: f"math.cos({x})",
                ANGLE_OF: angle,
                ABOVE: above,
                EXPONENTIAL: f"math.exp({x})",
                LOGARITHM: f"math.log({x})",
                TANH: f"math.tanh({x})",
            }[one.op]
        return self._later(j, one, k)

    def _later(self, j: int, one: Operation, k: int) -> str:
        """Coefficients above 0 of what is no polynomial."""
        a, b, c = one.a, one.b, one.c
        if one.op in _OF_LAWS:
            return _times(self._slopes(j, one)[0], self.of(a, k)) if k == 1 else _no_second(one)
        if one.op == DIVIDE:
            # c b = a
            total = _sum([self.of(a, k)], [_times(self.of(j, i), self.of(b, k - i)) for i in range(k)])
            return f"({total}) / {self.of(b, 0)}" if total else ""
        if one.op == ROOT:
            # c c = a
            total = _sum([self.of(a, k)], [_times(self.of(j, i), self.of(j, k - i)) for i in range(1, k)])
            return f"0.5 * ({total}) / {self.of(j, 0)}" if total else ""
        if one.op == ANGLE_OF:
            # (s^2 + c^2) q' = c s' - s c'
            plus = [_scaled(i / k, _times(self.of(b, k - i), self.of(a, i))) for i in range(1, k + 1)]
            less = [_scaled(i / k, _times(self.of(a, k - i), self.of(b, i))) for i in range(1, k + 1)]
            less += [_scaled(i / k, _times(self.of(j, i), self.of(c, k - i))) for i in range(1, k)]
            total = _sum(plus, less)
            return f"({total}) / {self.of(c, 0)}" if total else ""
        # sine' = cosine a', cosine' = -sine a'
        parts = [_scaled(i / k, _times(self.of(a, i), self.of(c, k - i))) for i in range(1, k + 1)]
        return _sum(parts) if one.op == SINE else _sum([], parts)

    def _slopes(self, j: int, one: Operation) -> tuple[str, str]:
        """First and second derivative by its operand of an operation of laws."""
        if j not in self._slope:
            x, y = self.of(one.a, 0), self.of(j, 0)
            if one.op == ABOVE:
                p = self.of(one.b, 0)
                first = f"({p} * {x} ** ({p} - 1.0) if {x} > 0.0 else 0.0)"
                second = f"({p} * ({p} - 1.0) * {x} ** ({p} - 2.0) if {x} > 0.0 else 0.0)"
            elif one.op == TANH:
                first, second = f"1.0 - {y} * {y}", f"-2.0 * {y} * (1.0 - {y} * {y})"
            else:
                first, second = (y, y) if one.op == EXPONENTIAL else (f"1.0 / {x}", f"-1.0 / ({x} * {x})")
            self._slope[j] = self.named(first), self.named(second) if self.order else ""
        return self._slope[j]

    def _product(self, a: int, b: int, k: int) -> list[str]:
        """The terms of coefficient k of a product."""
        return [_times(self.of(a, i), self.of(b, k - i)) for i in range(k + 1)]

    # -- adjoints --------------------------------------------------------------------------------------------------

    def adjoint(self, j: int, k: int) -> str:
        """Coefficient k of the adjoint of operation j; empty if it is zero."""
        return self._adjoint.get((j, k), "")

    def _pass(self, j: int, k: int, plus: list[str], less: list[str] | None = None) -> None:
        """Add to the adjoint of an operation."""
        if self.operations[j].op in (CONSTANT, PARAMETER):
            return
        total = _sum([self.adjoint(j, k), *plus], less)
        if total:
            self._adjoint[j, k] = total if total.isidentifier() else self.named(total)

    def backward(self, factors: dict[int, str]) -> None:
        """The adjoints of the sum of some operations times constant factors."""
        for j, factor in factors.items():
            self._adjoint[j, 0] = self.named(factor)
        for j in range(len(self.operations) - 1, -1, -1):
            one = self.operations[j]
            if one.op > CONSTANT and any(self.adjoint(j, k) for k in range(self.order + 1)):
                self._back(j, one)

    def gradient(self, place: int, k: int) -> str:
        """Coefficient k of the derivative by a coordinate, after `backward`; empty if it is zero."""
        read = [j for j, one in enumerate(self.operations) if one.op == NODE_AT and one.a == place]
        return self.adjoint(read[0], k) if read else ""

    def write_gradient(self, places: range) -> None:
        """Lines that put the derivatives by coordinates, and their rates, into out."""
        for k in range(self.order + 1):
            for i, place in enumerate(places):
                found = self.gradient(place, k) or "0.0"
                self.add(f"out[{len(places) * k + i}] = {f'2.0 * {found}' if k == 2 else found}")

    def _back(self, j: int, one: Operation) -> None:
        a, b, orders = one.a, one.b, range(self.order + 1)
        own = [self.adjoint(j, k) for k in orders]
        if one.op in (ADD, SUBTRACT):
            for k in orders:
                self._pass(a, k, [own[k]])
                self._pass(b, k, [own[k]] if one.op == ADD else [], [own[k]] if one.op == SUBTRACT else [])
        elif one.op == MULTIPLY:
            for k in orders:
                self._pass(a, k, [_times(own[i], self.of(b, k - i)) for i in range(k + 1)])
                self._pass(b, k, [_times(own[i], self.of(a, k - i)) for i in range(k + 1)])
        elif one.op == CHOICE:
            for k in orders:
                if own[k]:
                    self._pass(b, k, [f"({own[k]} if {self.of(a, 0)} > 0.0 else 0.0)"])
                    self._pass(one.c, k, [f"(0.0 if {self.of(a, 0)} > 0.0 else {own[k]})"])
        elif one.op in _OF_LAWS:
            first, second = self._slopes(j, one)
            bent = _times(second, self.of(a, 1))
            for k in orders:
                self._pass(a, k, [_times(own[k], first), *([_times(own[0], bent)] if k == 1 else [])])
        elif one.op in (SINE, COSINE):
            for k in orders:
                parts = [_times(own[i], self.of(one.c, k - i)) for i in range(k + 1)]
                self._pass(a, k, parts if one.op == SINE else [], parts if one.op == COSINE else [])
        else:
            self._quotients(j, one, own)

    def _quotients(self, j: int, one: Operation, own: list[str]) -> None:
        """Operations whose adjoint is divided: by the divisor, by the root, by the square of the radius."""
        a, b = one.a, one.b
        divisor = {DIVIDE: b, ROOT: j, ANGLE_OF: one.c}[one.op]
        quotient: list[str] = []
        for k in range(self.order + 1):
            total = _sum([own[k]], [_times(quotient[i], self.of(divisor, k - i)) for i in range(k)])
            quotient.append(self.named(f"({total}) / {self.of(divisor, 0)}") if total else "")
        for k in range(self.order + 1):
            if one.op == ROOT:
                self._pass(a, k, [_scaled(0.5, quotient[k])])
                continue
            if one.op == DIVIDE:
                self._pass(a, k, [quotient[k]])
                self._pass(b, k, [], [_times(quotient[i], self.of(j, k - i)) for i in range(k + 1)])
                continue
            self._pass(a, k, [_times(quotient[i], self.of(b, k - i)) for i in range(k + 1)])
            self._pass(b, k, [], [_times(quotient[i], self.of(a, k - i)) for i in range(k + 1)])


_OF_LAWS = (ABOVE, EXPONENTIAL, LOGARITHM, TANH)


def _no_second(one: Operation) -> str:
    # never called: second rates are those of coordinates, whose expressions have no operations of laws
    raise AssertionError(f"operation {one.op} is one of laws: it has no second rates")


def _times(a: str, b: str) -> str:
    return f"{a} * {b}" if a and b else ""


def _scaled(factor: float, a: str) -> str:
    return a if factor == 1.0 or not a else f"{factor!r} * {a}"


def _sum(plus: list[str], less: list[str] | None = None) -> str:
    """a + b - c - d of those that are not zero."""
    found = " + ".join(one for one in plus if one)
    for one in less or []:
        if one:
            found = f"{found} - {one}" if found else f"-{one}"
    return found
