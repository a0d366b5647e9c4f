"""Functions of node positions as straight-line programs, in truncated Taylor arithmetic: values, rates and gradients, exact.

An operation c of a and b is a series c0 + c1 t + c2 t^2 of the time since now. Its coefficients follow from those of a and b;
backwards, the derivatives of the results by a and b (adjoints, series too) follow from those by c (Griewank & Walther,
Evaluating derivatives, 2008, chapters 3 and 13). One pass back gives the gradient of any sum of results, with its rates.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, Record, record

__all__ = [
    "ADD",
    "ANGLE_OF",
    "CONSTANT",
    "DIVIDE",
    "MULTIPLY",
    "NODE_AT",
    "PARAMETER",
    "ROOT",
    "SUBTRACT",
    "Tape",
    "backward",
    "evaluate",
    "forward",
]

NODE_AT, PARAMETER, CONSTANT, ADD, SUBTRACT, MULTIPLY, DIVIDE, ROOT, ANGLE_OF = 0, 1, 2, 3, 4, 5, 6, 7, 8


@record
class Tape(Record):
    """op (k,) what is done; a, b (k,) with what: earlier operations, or the flat coordinate of a node, or a parameter.

    number (k,) constants. out (r,) the operations that are results: `tasks` of them of tasks, then those of the sums of a plan.
    period (r,) after which results are the same (0: never).
    """

    tasks: I0
    op: I1
    a: I1
    b: I1
    number: F1
    out: I1
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
def _angle(T: F2, s: int, c: int, j: int, k: int) -> float:
    """Coefficient k of atan2(s, c)."""
    if k == 0:
        return math.atan2(T[0, s], T[0, c])
    square = T[0, s] * T[0, s] + T[0, c] * T[0, c]
    turn = T[0, c] * T[k, s] - T[0, s] * T[k, c]
    # (s^2 + c^2) q' = c s' - s c', coefficient by coefficient
    if k == 2:
        turn -= T[1, j] * (T[0, c] * T[1, c] + T[0, s] * T[1, s])
    return turn / square


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
        return _angle(T, a, b, j, k)
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
def _quotient(p: F2, a: int, q: F2, b: int, order: int, out: F2) -> None:
    """Series p[:, a]/q[:, b] into out[:, 0]."""
    for k in range(order + 1):
        total = p[k, a]
        for i in range(k):
            total -= out[i, 0] * q[k - i, b]
        out[k, 0] = total / q[0, b]


@kernel_inline
def _pass_back(tape: Tape, j: int, order: int, T: F2, B: F2, quotient: F2) -> None:
    """Add what operation j does to the adjoints of its operands; quotient (3, 2) is scratch."""
    op, a, b = tape.op[j], tape.a[j], tape.b[j]
    if op == MULTIPLY:
        # a += c' b, b += c' a, with c' the adjoint of c = a b; a = b counts twice
        for k in range(order + 1):
            B[k, a] += _times(B, j, T, b, k)
            B[k, b] += _times(B, j, T, a, k)
    elif op == DIVIDE:
        _quotient(B, j, T, b, order, quotient)
        for k in range(order + 1):
            B[k, a] += quotient[k, 0]
            B[k, b] -= _times(quotient, 0, T, j, k)
    elif op == ROOT:
        _quotient(B, j, T, j, order, quotient)
        for k in range(order + 1):
            B[k, a] += 0.5 * quotient[k, 0]
    elif op == ANGLE_OF:
        for k in range(order + 1):
            quotient[k, 1] = _times(T, a, T, a, k) + _times(T, b, T, b, k)
        _quotient(B, j, quotient, 1, order, quotient)
        for k in range(order + 1):
            B[k, a] += _times(quotient, 0, T, b, k)
            B[k, b] -= _times(quotient, 0, T, a, k)
    elif op in (ADD, SUBTRACT):
        for k in range(order + 1):
            B[k, a] += B[k, j]
            B[k, b] += B[k, j] if op == ADD else -B[k, j]


@kernel
def backward(tape: Tape, order: int, T: F2, B: F2, quotient: F2, G: F2) -> None:
    """Add the gradient of the sum of B[0] times operations, with its coefficients up to `order`, to G (3, 3 n).

    T : from `forward`. B (3, k) : the factors of operations, series too; overwritten. quotient (3, 2) is scratch.
    """
    for j in range(tape.op.size - 1, -1, -1):
        if tape.op[j] == NODE_AT:
            for k in range(order + 1):
                G[k, tape.a[j]] += B[k, j]
        elif tape.op[j] > CONSTANT:
            _pass_back(tape, j, order, T, B, quotient)


@kernel
def evaluate(tape: Tape, X: F2, P: F2, T: F2, out: F2) -> None:
    """Results (times, r) at positions X (times, 3 n) and parameters P (times, p); T (3, k) is scratch."""
    for i in range(X.shape[0]):
        forward(tape, X[i : i + 1], P[i : i + 1], 0, T)
        for j in range(tape.out.size):
            out[i, j] = T[0, tape.out[j]]
