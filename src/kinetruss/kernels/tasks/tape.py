"""Functions of node positions in truncated Taylor arithmetic: straight-line programs, and sweeps from drives to nodes and back.

An operation c of a and b is a series c0 + c1 t + c2 t^2 of the time since now. Its coefficients follow from those of a and b;
backwards, the derivatives of the results by a and b (adjoints, series too) follow from those by c (Griewank & Walther,
Evaluating derivatives, 2008, chapters 3 and 13). One pass back gives the gradient of any sum of results, with its rates.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, Floats, Record, Vector, record
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
from kinetruss.kernels.structure.mass import between, dot
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SUM, Plan
from kinetruss.kernels.structure.sums import add_sum_force, sum_known
from kinetruss.kernels.sweep.blocks import Workspace, known, solve, solve_transposed


@record
class Tape(Record):
    """op, a, b, c, number (k,) : see kernels.coordinates.programs.

    out (r,) the operations that are results: `tasks` of them of tasks, then those of the sums of a plan.
    period (r,) after which results are the same (0: never).
    """

    tasks: I0
    op: I1
    a: I1
    b: I1
    c: I1
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
def _quotient(p: F2, a: int, q: F2, b: int, order: int, out: F2) -> None:
    """Series p[:, a]/q[:, b] into out[:, 0]."""
    for k in range(order + 1):
        total = p[k, a]
        for i in range(k):
            total -= out[i, 0] * q[k - i, b]
        out[k, 0] = total / q[0, b]


@kernel_inline
def _pass_back(tape: Tape, j: int, order: int, T: F2, B: F2, quotient: F2) -> None:
    """Add what operation j does to the adjoints of its operands; quotient (3, 1) is scratch."""
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
        _quotient(B, j, T, tape.c[j], order, quotient)
        for k in range(order + 1):
            B[k, a] += _times(quotient, 0, T, b, k)
            B[k, b] -= _times(quotient, 0, T, a, k)
    elif op in (SINE, COSINE):
        for k in range(order + 1):
            change = _times(B, j, T, tape.c[j], k)
            B[k, a] += change if op == SINE else -change
    elif op in (ADD, SUBTRACT):
        for k in range(order + 1):
            B[k, a] += B[k, j]
            B[k, b] += B[k, j] if op == ADD else -B[k, j]


@kernel
def backward(tape: Tape, order: int, T: F2, B: F2, quotient: F2, G: F2) -> None:
    """Add the gradient of the sum of B[0] times operations, with its coefficients up to `order`, to G (3, 3 n).

    T : from `forward`. B (3, k) : the factors of operations, series too; overwritten. quotient (3, 1) is scratch.
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


def tape_of(program: Program, tasks: int) -> Tape:
    """The tape of a program; `tasks` of its results are of tasks."""
    op, a, b, number, c = zip(*program.operations, strict=True)
    out, period = zip(*((value.index, period) for value, period in program.results), strict=True)
    return Tape.of({"tasks": tasks, "op": op, "a": a, "b": b, "c": c, "number": number, "out": out, "period": period})


def values(tape: Tape, x: Floats, p: Floats) -> Floats:
    """Results (times, r) at flat positions x (times, 3 n) and parameters p (times, parameters)."""
    out = np.zeros((len(x), len(tape.out)))
    evaluate(tape, np.ascontiguousarray(x), np.ascontiguousarray(p), np.zeros((3, len(tape.op))), out)
    return out


# Sweeps over the blocks in Taylor arithmetic: from drives to nodes, and from the gradient of tasks back to drives.
#
# With coordinates x(q) that meet all rows, the derivative of s . c(x) by the drives q is mu of the rows that they drive, from
# J^T mu = gradient of s . c: one sweep from the tip down. As series in time, order by order: the factors of J are those of the
# present state, and what lower orders of mu make of higher ones of J goes to the right-hand side.


@record
class Drives(Record):
    """Where drives act: row (d,) of the plan, or -1 and flat (d,) the coordinate that they move; weight (d,), lower, upper
    (d,) bounds; held (d,): 0 free, 1 at the lower bound, 2 at the upper bound, 3 always.
    """

    row: I1
    flat: I1
    held: I1
    weight: F1
    lower: F1
    upper: F1


@record
class TaskWork(Record):
    """Taylor coefficients (3, ...) at one instant: x (3, 3 n) of nodes, p of parameters, t of operations, back their adjoints,
    g (3, 3 n) of the gradient, mu of rows, s of the factors of tasks, q of drives, moving (3, k) of prescribed coordinates that
    move; scale (rows,) of a row over what it is the row of (1 of lengths, L of angles). K (d + m, d + m), pivot its factors;
    A (m, d); r, step (d + m,); ref (3, d) what drives are to be near to; kept (4, 3 n or d) states to go back to; sign
    (blocks,) of determinants; rows (3, 3), out (3, d), quotient (3, 1) scratch.
    """

    pivot: I1
    x: F2
    p: F2
    t: F2
    back: F2
    g: F2
    mu: F2
    s: F2
    q: F2
    moving: F2
    scale: F1
    K: F2
    A: F2
    r: F1
    step: F1
    ref: F2
    kept: F2
    sign: F1
    rows: F2
    out: F2
    quotient: F2


def workspace_of(plan: Plan, tape: Tape, coordinates: int, drives: int, parameters: int) -> TaskWork:
    """Room for a task of a structure."""
    m, k, rows = tape.tasks, len(tape.op), len(plan.row)
    n = drives + m
    shapes = {
        "pivot": (n + 1,),
        "x": (3, coordinates),
        "p": (3, max(1, parameters)),
        "t": (3, k),
        "back": (3, k),
        "g": (3, coordinates),
        "mu": (3, rows + 1),
        "s": (3, m),
        "q": (3, drives),
        "moving": (3, len(plan.moving)),
        "scale": (rows + 1,),
        "K": (n, n),
        "A": (m, drives),
        "r": (n,),
        "step": (n,),
        "ref": (3, drives),
        "kept": (4, max(coordinates, n)),
        "sign": (len(plan.ptr),),
        "rows": (3, 3),
        "out": (3, drives),
        "quotient": (3, 1),
    }
    room = TaskWork.zeros(shapes)
    room.scale[:] = 1.0
    return room


@kernel_inline
def scales(plan: Plan, y: TaskWork) -> None:
    """Gradients of rows over those of what drives prescribe: L of an angle, the scale of a sum, else 1."""
    for k in range(plan.ptr[-1]):
        if plan.kind[k] == ANGLE:
            d = between(y.x[0], plan.A[k], plan.B[k])
            y.scale[k] = math.sqrt(dot(d, d))
    for j in range(plan.sum_row.size):
        y.scale[plan.sum_row[j]] = plan.sum_scale[j]


@kernel_inline
def _second(plan: Plan, w: Workspace, y: TaskWork, k: int, order: int) -> float:
    """What coefficient `order` of a length or an angle has from lower ones of the nodes, times the scale of the row."""
    if order < 2 or plan.kind[k] == SUM:
        return 0.0
    e = between(y.x[1], plan.A[k], plan.B[k])
    if plan.kind[k] == LENGTH:
        # 2 L0 L2 + L1^2 = 2 d0 d2 + d1 d1
        along = dot(w.gradient[k], e)
        return 0.5 * w.inverse[k] * (dot(e, e) - along * along)
    d = between(y.x[0], plan.A[k], plan.B[k])
    square = dot(d, d)
    turn = (d[0] * e[1] - d[1] * e[0]) / square
    return -turn * dot(d, e) / math.sqrt(square)


@kernel
def carry(plan: Plan, w: Workspace, tape: Tape, y: TaskWork, order: int, drives: Drives, start: int) -> None:
    """Coefficient `order` of all nodes, y.x[order], from those of drives, y.q[order], of supports, y.moving[order], and from
    lower ones.

    w : factors at y.x[0]; y.scale is given. start : the first block whose nodes move.
    """
    for c in range(y.x.shape[1]):
        y.x[order, c] = 0.0
    if plan.sum_row.size > 0 and order == 2:
        # what first coefficients make of the second ones of sums
        forward(tape, y.x, y.p, 2, y.t)
    for k in range(plan.moving.size):
        y.x[order, plan.moving[k]] = y.moving[order, k]
    for d in range(drives.flat.size):
        if drives.flat[d] >= 0:
            y.x[order, drives.flat[d]] = y.q[order, d]
    for b in range(start, plan.ptr.size - 1):
        first, last = plan.ptr[b], plan.ptr[b + 1]
        for k in range(first, last):
            d = plan.drive[k]
            wanted = y.scale[k] * y.q[order, d] if d >= 0 else 0.0
            w.work[k - first] = wanted - _second(plan, w, y, k, order) - known(plan, w, k, y.x, order)
        if plan.sum_ptr[b] < plan.sum_ptr[b + 1]:
            if order == 2:
                for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
                    w.work[plan.sum_row[j] - first] -= plan.sum_scale[j] * y.t[2, tape.out[tape.tasks + j]]
            sum_known(plan, b, first, y.x[order], w.terms, w.work)
        solve(plan, w, b, w.work)
        for k in range(first, last):
            y.x[order, plan.col[k]] = w.work[k - first]


@kernel_inline
def _angle_series(plan: Plan, y: TaskWork, k: int, order: int, out: F2) -> None:
    """Gradient n/L = (-d_y, d_x)/|d|^2 of an angle by the position of B, coefficients 0 ... order into out (3, 3)."""
    A, B = plan.A[k], plan.B[k]
    d, e, f = between(y.x[0], A, B), between(y.x[1], A, B), between(y.x[2], A, B)
    r0, r1 = dot(d, d), 2.0 * dot(d, e)
    r2 = 2.0 * dot(d, f) + dot(e, e) if order > 1 else 0.0
    # c r = a, coefficient by coefficient
    for c in range(2):
        at, sign = 1 - c, 2.0 * c - 1.0
        out[0, c] = sign * (y.x[0, B + at] - y.x[0, A + at]) / r0
        out[1, c] = (sign * (y.x[1, B + at] - y.x[1, A + at]) - out[0, c] * r1) / r0
        out[2, c] = (sign * (y.x[2, B + at] - y.x[2, A + at]) - out[0, c] * r2 - out[1, c] * r1) / r0


@kernel_inline
def _row_force(plan: Plan, w: Workspace, y: TaskWork, k: int, order: int) -> Vector:
    """Coefficient `order` of mu times the gradient of a length, of mu below that order: u' = (d' - L' u)/L and so on."""
    u, A, B, inverse = w.gradient[k], plan.A[k], plan.B[k], w.inverse[k]
    e, first = between(y.x[1], A, B), y.mu[order - 1, k]
    L1 = dot(u, e)
    vx, vy, vz = (e[0] - L1 * u[0]) * inverse, (e[1] - L1 * u[1]) * inverse, (e[2] - L1 * u[2]) * inverse
    if order == 1:
        return first * vx, first * vy, first * vz
    f, second = between(y.x[2], A, B), y.mu[0, k] * inverse
    L2 = dot(u, f) + 0.5 * (dot(e, e) - L1 * L1) * inverse
    return (
        second * (f[0] - L2 * u[0] - L1 * vx) + first * vx,
        second * (f[1] - L2 * u[1] - L1 * vy) + first * vy,
        second * (f[2] - L2 * u[2] - L1 * vz) + first * vz,
    )


@kernel_inline
def _lower_orders(plan: Plan, w: Workspace, tape: Tape, y: TaskWork, order: int, start: int) -> None:
    """Take what lower orders of mu make of y.g[order] off it."""
    rows = y.rows
    for k in range(plan.ptr[start], plan.ptr[-1]):
        A, B = plan.A[k], plan.B[k]
        if plan.kind[k] == LENGTH:
            fx, fy, fz = _row_force(plan, w, y, k, order)
            y.g[order, B] -= fx
            y.g[order, B + 1] -= fy
            y.g[order, B + 2] -= fz
            y.g[order, A] += fx
            y.g[order, A + 1] += fy
            y.g[order, A + 2] += fz
        elif plan.kind[k] == ANGLE:
            _angle_series(plan, y, k, order, rows)
            for c in range(2):
                force = 0.0
                for i in range(order):
                    force += rows[order - i, c] * y.mu[i, k]
                y.g[order, B + c] -= force
                y.g[order, A + c] += force
    if plan.sum_row.size == 0:
        return
    _clear(y.back, order)
    for j in range(plan.sum_row.size):
        for i in range(order):
            if plan.sum_row[j] < plan.ptr[-1]:
                y.back[i, tape.out[tape.tasks + j]] -= y.mu[i, plan.sum_row[j]]
    backward(tape, order, y.t, y.back, y.quotient, y.g)


@kernel_inline
def _clear(y: F2, order: int) -> None:
    for k in range(order + 1):
        for c in range(y.shape[1]):
            y[k, c] = 0.0


@kernel_inline
def _back(plan: Plan, w: Workspace, y: TaskWork, order: int, start: int) -> None:
    """J^T mu = y.g[order] over the blocks from the last to `start`; the rest stays at prescribed coordinates."""
    rest = y.g[order]
    for b in range(plan.ptr.size - 2, start - 1, -1):
        first, last = plan.ptr[b], plan.ptr[b + 1]
        for k in range(first, last):
            w.work[k - first] = rest[plan.col[k]]
        solve_transposed(plan, w, b, w.work)
        for k in range(first, last):
            amount = w.work[k - first]
            y.mu[order, k] = y.scale[k] * amount
            for c in range(3):
                force = amount * w.gradient[k, c]
                rest[plan.A[k] + c] += force
                rest[plan.B[k] + c] -= force
        for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
            k = plan.sum_row[j]
            add_sum_force(plan, j, w.terms, y.mu[order, k] / y.scale[k], rest)


@kernel
def gradient(plan: Plan, w: Workspace, tape: Tape, y: TaskWork, low: int, order: int, drives: Drives, start: int) -> None:
    """Derivatives of y.s . (results of tasks) by the drives, coefficients low ... order, into y.out (3, drives).

    y.x, y.t up to `order`, y.mu below `low`; w : factors at y.x[0]. start : only those by drives of this block and later ones,
    where nodes of earlier blocks do not move.
    """
    _clear(y.g, order)
    _clear(y.back, order)
    for j in range(tape.tasks):
        for k in range(order + 1):
            y.back[k, tape.out[j]] += y.s[k, j]
    backward(tape, order, y.t, y.back, y.quotient, y.g)
    for k in range(low, order + 1):
        if k > 0:
            _lower_orders(plan, w, tape, y, k, start)
        _back(plan, w, y, k, start)
        for d in range(drives.row.size):
            y.out[k, d] = y.mu[k, drives.row[d]] if drives.row[d] >= 0 else y.g[k, drives.flat[d]]


@kernel
def let_go(drives: Drives, o: TaskWork, scale: float) -> bool:
    """Let the drive go that its bound holds back most without need; False if there is none.

    o.out[0] : A^T s, the gradient of the tasks' factors by the drives. w (q - r) - A^T s of a drive at a bound: the sum would
    fall with a step inwards.
    """
    worst, at = 1e-9 * scale, -1
    for d in range(drives.row.size):
        if drives.held[d] == 1 or drives.held[d] == 2:
            excess = (o.q[0, d] - o.ref[0, d]) - o.out[0, d] / drives.weight[d]
            excess = -excess if drives.held[d] == 1 else excess
            if excess > worst:
                worst, at = excess, d
    if at >= 0:
        drives.held[at] = 0
    return at >= 0
