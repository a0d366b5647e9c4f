"""Sweeps over the blocks in Taylor arithmetic: from drives to nodes, and from the gradient of tasks back to drives.

With coordinates x(q) that meet all rows, the derivative of s . c(x) by the drives q is mu of the rows that they drive, from
J^T mu = gradient of s . c: one sweep from the tip down. As series in time, order by order: the factors of J are those of the
present state, and what lower orders of mu make of higher ones of J goes to the right-hand side.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1, Record, Vector, record
from kinetruss.kernels.coordinates.tape import Tape, backward, forward
from kinetruss.kernels.structure.mass import between, dot
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SUM, Plan
from kinetruss.kernels.structure.sums import add_sum_force, sum_known
from kinetruss.kernels.sweep.blocks import Workspace, known, solve, solve_transposed


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
    (blocks,) of determinants; rows (3, 3), out (3, d), quotient (3, k) scratch.
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
        "quotient": (3, k),
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
