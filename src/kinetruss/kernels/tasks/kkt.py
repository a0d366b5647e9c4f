"""The drives that meet tasks and are nearest to a reference: Newton's method, and the rates of what it finds.

Least sum of w (q - r)^2/2 with c(x(q)) = 0 and bounds of q: at the solution w (q - r) = A^T s with A the derivatives of c by q
(drives at a bound or held stand still). Its matrix K = [[W - sum s c'', -A^T], [A, 0]] also gives the rates of q and s, since
the same equations hold at all times. K is formed seldom; what it is off by is made good by repeating with exact residuals.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.coordinates.tape import Tape, forward
from kinetruss.kernels.structure.structure import Plan
from kinetruss.kernels.sweep.blocks import Workspace, factor, set_targets
from kinetruss.kernels.sweep.follow import chord, closed_block, faces, righted
from kinetruss.kernels.sweep.lu import lu_factor, lu_solve
from kinetruss.kernels.tasks.sweeps import Drives, TaskWork, carry, gradient, scales

__all__ = ["closed", "corrected", "matrix", "rates", "residual", "task_rows"]

SAME = 3e-13
"""Change of drives, as a share of the shortest bar, that is round-off."""


@kernel_inline
def _place(plan: Plan, drives: Drives, y: TaskWork) -> None:
    """Put the coordinates that drives and supports prescribe where they are now."""
    for k in range(plan.moving.size):
        y.x[0, plan.moving[k]] = y.moving[0, k]
    for d in range(drives.flat.size):
        if drives.flat[d] >= 0:
            y.x[0, drives.flat[d]] = y.q[0, d]


@kernel
def closed(plan: Plan, w: Workspace, drives: Drives, o: TaskWork, scale: float, good: bool) -> bool:
    """Positions o.x[0] for the drives o.q[0], from where they are, and factors there; False if they do not close.

    good : there are factors from near by. Determinants of blocks keep their sign in o.sign (0: any).
    """
    if not _positions(plan, w, drives, o, scale, good):
        return False
    # factors at the solution, on the same branch
    for b in range(plan.ptr.size - 1):
        sign = factor(plan, w, b, o.x, 0)
        if sign == 0.0 or sign * o.sign[b] < 0.0:
            return False
        o.sign[b] = sign
    scales(plan, o)
    return True


@kernel_inline
def _positions(plan: Plan, w: Workspace, drives: Drives, o: TaskWork, scale: float, good: bool) -> bool:
    """Positions o.x[0] for the drives o.q[0], from where they are; False if they do not close."""
    y = o
    _place(plan, drives, o)
    set_targets(plan, w, y.q, 0)
    for c in range(y.x.shape[1]):
        o.kept[0, c] = y.x[0, c]
    done = good
    # chord steps with the factors at hand, else Newton's method
    for b in range(plan.ptr.size - 1):
        done = done and chord(plan, w, b, y.x, 0, scale) and not righted(plan, b, o.kept, 0, y.x, 0)
    if not done:
        for c in range(y.x.shape[1]):
            y.x[0, c] = o.kept[0, c]
        for b in range(plan.ptr.size - 1):
            if not closed_block(plan, w, b, o.kept, 0, y.x, 0, scale):
                return False
    return faces(plan, w, y.x, 0)


@kernel
def task_rows(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork) -> None:
    """Derivatives of the tasks by the drives into o.A, one sweep back each; o.s is kept."""
    y, m = o, tape.tasks
    for j in range(m):
        o.step[j] = y.s[0, j]
    for j in range(m):
        for k in range(m):
            y.s[0, k] = 1.0 if k == j else 0.0
        gradient(plan, w, tape, y, 0, 0, drives, 0)
        for d in range(drives.row.size):
            o.A[j, d] = o.out[0, d]
    for j in range(m):
        y.s[0, j] = o.step[j]


@kernel
def matrix(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, curved: bool) -> float:
    """Form K at the present state and factor it; returns the sign of its determinant (0: singular).

    curved : with the second derivatives of the tasks; they overwrite first coefficients of the series.
    """
    y, n, m, K = o, drives.row.size, tape.tasks, o.K
    task_rows(plan, w, drives, tape, o)
    for i in range(n + m):
        for j in range(n + m):
            K[i, j] = 0.0
    for d in range(n):
        K[d, d] = drives.weight[d] if drives.held[d] == 0 else 1.0
        if drives.held[d] == 0:
            for j in range(m):
                K[d, n + j], K[n + j, d] = -o.A[j, d], o.A[j, d]
    if curved:
        _clear_first(y)
        gradient(plan, w, tape, y, 0, 0, drives, 0)
        for e in range(n):
            if drives.held[e] == 0:
                _curvature(plan, w, drives, tape, o, e)
    return lu_factor(K, o.pivot, 0, n + m)


@kernel_inline
def _clear_first(y: TaskWork) -> None:
    """No rates but those of drives."""
    for k in range(y.p.shape[1]):
        y.p[1, k] = 0.0
    for k in range(y.s.shape[1]):
        y.s[1, k] = 0.0
    for k in range(y.moving.shape[1]):
        y.moving[1, k] = 0.0
    for k in range(y.q.shape[1]):
        y.q[1, k] = 0.0


@kernel_inline
def _block(plan: Plan, drives: Drives, d: int) -> int:
    """Block of the row of a drive; the first for a coordinate that it moves."""
    b = 0
    while drives.row[d] >= plan.ptr[b + 1]:
        b += 1
    return b


@kernel_inline
def _curvature(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, e: int) -> None:
    """Column e of minus the second derivatives of s . c into K, from the block of e on, and its mirror image."""
    y, start = o, _block(plan, drives, e)
    y.q[1, e] = 1.0
    carry(plan, w, tape, y, 1, drives, start)
    forward(tape, y.x, y.p, 1, y.t)
    gradient(plan, w, tape, y, 1, 1, drives, start)
    y.q[1, e] = 0.0
    for d in range(drives.row.size):
        at = _block(plan, drives, d)
        if drives.held[d] == 0 and at >= start:
            o.K[d, e] -= o.out[1, d]
            if at > start:
                o.K[e, d] -= o.out[1, d]


@kernel_inline
def residual(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, k: int, low: int) -> float:
    """Coefficient k of the equations into o.r; returns the largest of the tasks'. Series are given up to k, `mu` below low."""
    y, n, largest = o, drives.row.size, 0.0
    gradient(plan, w, tape, y, low, k, drives, 0)
    for d in range(n):
        o.r[d] = 0.0 if drives.held[d] > 0 else drives.weight[d] * (y.q[k, d] - o.ref[k, d]) - o.out[k, d]
    for j in range(tape.tasks):
        c = y.t[k, tape.out[j]]
        if k == 0 and tape.period[j] > 0.0:
            c -= tape.period[j] * np.floor(c / tape.period[j] + 0.5)
        o.r[n + j] = c
        largest = larger(largest, abs(c))
    return largest


@kernel_inline
def _improved(drives: Drives, tape: Tape, o: TaskWork, k: int) -> float:
    """Take K^-1 r off coefficient k of drives and factors; returns the largest change of a drive."""
    y, n, m, size = o, drives.row.size, tape.tasks, 0.0
    for i in range(n + m):
        o.step[i] = o.r[i]
    lu_solve(o.K, o.pivot, 0, n + m, o.step)
    for d in range(n):
        y.q[k, d] -= o.step[d]
        size = larger(size, abs(o.step[d]))
    for j in range(m):
        y.s[k, j] -= o.step[n + j]
    return size


@kernel
def corrected(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float, fresh: bool) -> bool:
    """Newton's method on drives and factors, o.q[0] and o.s[0], for the parameters o.p[0]; positions follow.

    fresh : K is formed at the start; else the one at hand is used while it serves. It ends where the next step, from the share
    that one step leaves of the one before, would be below round-off.
    """
    before, good, formed, left = scale, not fresh, 0, 0.1
    for step in range(40):
        if not closed(plan, w, drives, o, scale, good):
            return False
        good = True
        forward(tape, o.x, o.p, 0, o.t)
        if fresh:
            formed += 1
            if formed > 12 or matrix(plan, w, drives, tape, o, True) == 0.0:
                return False
            fresh = False
            forward(tape, o.x, o.p, 0, o.t)
        miss = residual(plan, w, drives, tape, o, 0, 0)
        size = _improved(drives, tape, o, 0)
        if not size < scale:
            return False
        if step > 0:
            left = max(1e-3, size / before)
        if miss < 1e-4 * scale and (size * left < 3e-14 * scale or (size < 1e-9 * scale and left > 0.3)):
            # factors stay where they would change by round-off only
            if size < SAME * scale:
                return _positions(plan, w, drives, o, scale, True)
            return closed(plan, w, drives, o, scale, True)
        fresh = step > 0 and left > 0.2
        before = size
    return False


@kernel
def rates(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, k: int, scale: float) -> int:
    """Coefficient k of drives and factors, o.q[k] and o.s[k], from what is guessed there; those of the nodes follow.

    The lower ones belong to the present state; those below k - 1 in `mu` too. Returns the number of repetitions, 0 where they
    do not converge. Second rates may cancel: their round-off is that of squares of first rates, over the size `scale`, m.
    """
    before, left, squares = np.inf, 0.1, 0.0
    if k == 2:
        for d in range(drives.row.size):
            squares = larger(squares, o.q[1, d] * o.q[1, d] * larger(1.0, 1.0 / scale))
    forward(tape, o.x, o.p, k - 1, o.t)
    for step in range(25):
        carry(plan, w, tape, o, k, drives, 0)
        forward(tape, o.x, o.p, k, o.t)
        # `mu` of the order below is new at first
        residual(plan, w, drives, tape, o, k, k - 1 if step == 0 else k)
        size, largest = _improved(drives, tape, o, k), 1e-9
        for d in range(drives.row.size):
            largest = larger(largest, abs(o.q[k, d]))
        if step > 0:
            left = max(1e-3, size / before)
        if size * left < 1e-13 * largest or (size < 1e-8 * largest and left > 0.3):
            carry(plan, w, tape, o, k, drives, 0)
            return step + 1
        if step > 0 and not left < 0.7:
            if not size < 1e-12 * squares:
                return 0
            carry(plan, w, tape, o, k, drives, 0)
            return step + 1
        before = size
    return 0
