"""Straight-line programs in truncated Taylor arithmetic, operation by operation.

An operation c of a and b is a series c0 + c1 t + c2 t^2 + ... of the time since now. Its coefficients follow from those of
a and b; backwards, the derivatives of the results by a and b (adjoints, series too) follow from those by c (Griewank & Walther,
Evaluating derivatives, 2008, chapters 3 and 13). One pass back gives the gradient of any sum of results, with its rates.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, Floats, Record, record
from kinetruss.kernels.coordinates.programs import (
    ADD,
    ANGLE_OF,
    CONSTANT,
    COSINE,
    DIVIDE,
    MULTIPLY,
    NODE_AT,
    PARAMETER,
    ROOT,
    SINE,
    SUBTRACT,
    Program,
)


@record
class Tape(Record):
    """op, a, b, c, number (k,) : see kernels.coordinates.programs.

    out (r,) the operations that are results: `tasks` of them of tasks, then those of the sums of a plan.
    period (r,) after which results are the same (0: never). series : addresses of the kernels for the orders of a motion
    (series.measured), or none.
    """

    tasks: I0
    op: I1
    a: I1
    b: I1
    c: I1
    number: F1
    out: I1
    series: I1
    period: F1


@kernel_inline
def _times(p: F2, a: int, q: F2, b: int, k: int) -> float:
    """Coefficient k of the product of the series p[:, a] and q[:, b]."""
    total = 0.0
    # sum of p_i q_(k - i)
    for i in range(k + 1):
        total += p[i, a] * q[k - i, b]
    return total


@kernel_inline
def _angle(T: F2, s: int, c: int, square: int, j: int, k: int) -> float:
    """Coefficient k of atan2(s, c), operation j; square : the operation s^2 + c^2."""
    if k == 0:
        return math.atan2(T[0, s], T[0, c])
    turn = 0.0
    # (s^2 + c^2) q' = c s' - s c', coefficient by coefficient
    for i in range(1, k + 1):
        turn += i * (T[k - i, c] * T[i, s] - T[k - i, s] * T[i, c])
    for i in range(1, k):
        turn -= i * T[i, j] * T[k - i, square]
    return turn / (k * T[0, square])


@kernel_inline
def _wave(T: F2, op: int, a: int, other: int, k: int) -> float:
    """Coefficient k of the sine or cosine of operation a; other : the operation that is the other of the two."""
    if k == 0:
        return math.sin(T[0, a]) if op == SINE else math.cos(T[0, a])
    total = 0.0
    # sine' = cosine a', cosine' = -sine a'
    for i in range(1, k + 1):
        total += i * T[i, a] * T[k - i, other]
    return total / k if op == SINE else -total / k


@kernel_inline
def _operation(tape: Tape, j: int, k: int, T: F2) -> float:
    """Coefficient k of operation j, one of those on earlier operations."""
    op, a, b = tape.op[j], tape.a[j], tape.b[j]
    if op == ADD:
        return T[k, a] + T[k, b]
    if op == SUBTRACT:
        return T[k, a] - T[k, b]
    if op == MULTIPLY:
        return _times(T, a, T, b, k)
    if op == ANGLE_OF:
        return _angle(T, a, b, tape.c[j], j, k)
    if op in (SINE, COSINE):
        return _wave(T, op, a, tape.c[j], k)
    total = T[k, a]
    if op == DIVIDE:
        # c b = a: c_k b_0 = a_k - sum of c_i b_(k - i)
        for i in range(k):
            total -= T[i, j] * T[k - i, b]
        return total / T[0, b]
    if k == 0:
        return math.sqrt(total)
    # c c = a
    for i in range(1, k):
        total -= T[i, j] * T[k - i, j]
    return total / (2.0 * T[0, j])


@kernel
def forward(tape: Tape, X: F2, P: F2, k: int, T: F2) -> None:
    """Coefficient k of all operations into T[k], from those of coordinates X (3, 3 n), of parameters P (3, p), and T[:k]."""
    for j in range(tape.op.size):
        op = tape.op[j]
        if op == NODE_AT:
            T[k, j] = X[k, tape.a[j]]
        elif op == PARAMETER:
            T[k, j] = P[k, tape.a[j]]
        elif op == CONSTANT:
            T[k, j] = tape.number[j] if k == 0 else 0.0
        else:
            T[k, j] = _operation(tape, j, k, T)


@kernel_inline
def _quotient(B: F2, j: int, T: F2, divisor: int, k: int, Q: F2) -> float:
    """Coefficient k of the adjoint of operation j over the series T[:, divisor]; those below stand in Q[:, j]."""
    total = B[k, j]
    # q d = b
    for i in range(k):
        total -= Q[i, j] * T[k - i, divisor]
    Q[k, j] = total / T[0, divisor]
    return Q[k, j]


@kernel_inline
def _pass_back(tape: Tape, j: int, k: int, T: F2, B: F2, Q: F2) -> None:
    """Add coefficient k of what operation j does to the adjoints of its operands."""
    op, a, b = tape.op[j], tape.a[j], tape.b[j]
    if op == MULTIPLY:
        # a += c' b, b += c' a, with c' the adjoint of c = a b; a = b counts twice
        B[k, a] += _times(B, j, T, b, k)
        B[k, b] += _times(B, j, T, a, k)
    elif op == DIVIDE:
        B[k, a] += _quotient(B, j, T, b, k, Q)
        B[k, b] -= _times(Q, j, T, j, k)
    elif op == ROOT:
        B[k, a] += 0.5 * _quotient(B, j, T, j, k, Q)
    elif op == ANGLE_OF:
        _quotient(B, j, T, tape.c[j], k, Q)
        B[k, a] += _times(Q, j, T, b, k)
        B[k, b] -= _times(Q, j, T, a, k)
    elif op in (SINE, COSINE):
        change = _times(B, j, T, tape.c[j], k)
        B[k, a] += change if op == SINE else -change
    elif op in (ADD, SUBTRACT):
        B[k, a] += B[k, j]
        B[k, b] += B[k, j] if op == ADD else -B[k, j]


@kernel
def backward_order(tape: Tape, k: int, T: F2, B: F2, Q: F2, g: F1) -> None:
    """Add coefficient k of the gradient of the sum of B times operations to g (3 n,).

    T : from `forward`. B (orders, ops) : in B[k] the factors of operations, overwritten by adjoints; in B[:k], and in Q of the
    same shape, what this function left of the coefficients below.
    """
    for j in range(tape.op.size - 1, -1, -1):
        if tape.op[j] == NODE_AT:
            g[tape.a[j]] += B[k, j]
        elif tape.op[j] > CONSTANT:
            _pass_back(tape, j, k, T, B, Q)


@kernel
def backward(tape: Tape, order: int, T: F2, B: F2, Q: F2, G: F2) -> None:
    """The same for all coefficients up to `order`, added to G (orders, 3 n)."""
    for k in range(order + 1):
        backward_order(tape, k, T, B, Q, G[k])


@kernel
def evaluate(tape: Tape, X: F2, P: F2, T: F2, out: F2) -> None:
    """Results (times, r) at positions X (times, 3 n) and parameters P (times, p); T (3, k) is scratch."""
    for i in range(X.shape[0]):
        forward(tape, X[i : i + 1], P[i : i + 1], 0, T)
        for j in range(tape.out.size):
            out[i, j] = T[0, tape.out[j]]


def tape_of(program: Program, tasks: int) -> Tape:
    """The tape of a program; `tasks` of its results are of tasks."""
    if any(one.op > COSINE for one in program.operations):
        # never so: elements with laws on nodes say that they have no series (Element.without_series)
        raise AssertionError("a program of series has operations of laws, which have none")
    op, a, b, number, c = zip(*program.operations, strict=True)
    out, period = zip(*((value.index, period) for value, period in program.results), strict=True)
    operations = {"op": op, "a": a, "b": b, "c": c, "number": number}
    return Tape.of({"tasks": tasks, **operations, "out": out, "series": [], "period": period})


def values(tape: Tape, x: Floats, p: Floats) -> Floats:
    """Results (times, r) at flat positions x (times, 3 n) and parameters p (times, parameters)."""
    out = np.zeros((len(x), len(tape.out)))
    evaluate(tape, np.ascontiguousarray(x), np.ascontiguousarray(p), np.zeros((3, len(tape.op))), out)
    return out
