"""The drives that meet one task, from far away: least-squares steps with damping, then the nearest to the reference.

Damped least-squares steps (Levenberg, 1944; Marquardt, 1963) with bounds lead to the task, or to where they come nearest to
it; they also lead out of positions in which the tasks have not their full rank. Steps on the tasks' surface lead from there to
the drives of least w (q - r)^2.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.coordinates.tape import Tape, forward
from kinetruss.kernels.structure.structure import Plan
from kinetruss.kernels.sweep.blocks import Workspace, workspace
from kinetruss.kernels.sweep.lu import lu_factor, lu_solve
from kinetruss.kernels.tasks.kkt import closed, matrix, residual, task_rows
from kinetruss.kernels.tasks.sweeps import Drives, TaskWork, carry, let_go

__all__ = ["MET", "NEAREST", "SLOW", "linear", "reach"]

MET, NEAREST, SLOW = 0, 1, 2
"""Met; not met, the nearest position; met, but the drives are not yet the nearest to the reference."""
STEPS = 300


@kernel
def missed(tape: Tape, o: TaskWork) -> float:
    """Sum of squares of what the tasks are off by, which goes to the end of o.r."""
    y, total, n = o, 0.0, o.r.size - tape.tasks
    forward(tape, y.x, y.p, 0, y.t)
    for j in range(tape.tasks):
        c = y.t[0, tape.out[j]]
        if tape.period[j] > 0.0:
            c -= tape.period[j] * np.floor(c / tape.period[j] + 0.5)
        o.r[n + j] = c
        total += c * c
    return total


@kernel_inline
def _keep(o: TaskWork, n: int) -> None:
    for c in range(o.x.shape[1]):
        o.kept[1, c] = o.x[0, c]
    for d in range(n):
        o.kept[2, d] = o.q[0, d]


@kernel_inline
def _undo(o: TaskWork, n: int) -> None:
    for c in range(o.x.shape[1]):
        o.x[0, c] = o.kept[1, c]
    for d in range(n):
        o.q[0, d] = o.kept[2, d]


@kernel
def least_step(drives: Drives, tape: Tape, o: TaskWork, damping: float) -> float:
    """Step of the drives that takes the misses at the end of o.r away, least by the weights, into o.step; its largest change.

    (A W^-1 A^T + damping) y = -c, step = W^-1 A^T y. Drives that would leave their bounds go there, and the others do the rest.
    """
    n, m, M, A = drives.row.size, tape.tasks, o.K, o.A
    for d in range(n):
        o.out[2, d] = 0.0 if drives.held[d] == 3 else 1.0 / drives.weight[d]
        o.step[d] = 0.0
    for _ in range(n + 1):
        trace, again = 0.0, False
        for j in range(m):
            for k in range(m):
                total = 0.0
                for d in range(n):
                    total += A[j, d] * A[k, d] * o.out[2, d]
                M[j, k] = total
            trace = max(trace, M[j, j])
        for j in range(m):
            M[j, j] += damping * trace + 1e-300
            total = 0.0
            for d in range(n):
                if o.out[2, d] == 0.0:
                    total += A[j, d] * o.step[d]
            o.kept[3, j] = -o.r[n + j] - total
        lu_factor(M, o.pivot, 0, m)
        lu_solve(M, o.pivot, 0, m, o.kept[3])
        size = 0.0
        for d in range(n):
            if o.out[2, d] > 0.0:
                total = 0.0
                for j in range(m):
                    total += A[j, d] * o.kept[3, j]
                o.step[d] = total * o.out[2, d]
                low, high = drives.lower[d] - o.q[0, d], drives.upper[d] - o.q[0, d]
                if o.step[d] < low - 1e-12 or o.step[d] > high + 1e-12:
                    o.step[d] = low if o.step[d] < low else high
                    o.out[2, d] = 0.0
                    again = True
            size = max(size, abs(o.step[d]))
        if not again:
            break
    return size


@kernel_inline
def _go(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, share: float, scale: float) -> bool:
    """Drives by a share of o.step, within bounds, from a closed state with its factors; positions follow."""
    y = o
    for d in range(drives.row.size):
        q = o.kept[2, d] + share * o.step[d]
        if drives.held[d] != 3:
            q = min(max(q, drives.lower[d]), drives.upper[d])
        y.q[0, d], y.q[1, d] = q, q - o.kept[2, d]
    # far nodes of a chain move much more than its drives: first along their derivatives
    carry(plan, w, tape, y, 1, drives, 0)
    for c in range(y.x.shape[1]):
        y.x[0, c] += y.x[1, c]
    return closed(plan, w, drives, o, scale, False)


@kernel
def _approach(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float, most: float) -> bool:
    """Damped least-squares steps until the tasks are met; False where they come no nearer."""
    n, damping = drives.row.size, 1e-2
    miss = missed(tape, o)
    task_rows(plan, w, drives, tape, o)
    for _ in range(STEPS):
        if miss < 1e-22 * scale * scale:
            return True
        size = least_step(drives, tape, o, damping)
        share = min(1.0, most / max(size, 1e-300))
        _keep(o, n)
        good = _go(plan, w, drives, tape, o, share, scale)
        now = missed(tape, o) if good else np.inf
        if now < miss * (1.0 - 1e-11 * share):
            damping = max(0.1 * damping, 1e-14)
            miss = now
            task_rows(plan, w, drives, tape, o)
        else:
            _undo(o, n)
            closed(plan, w, drives, o, scale, True)
            missed(tape, o)
            damping = 10.0 * max(damping, 1e-10)
            if damping > 1e8:
                return miss < 1e-18 * scale * scale
    return miss < 1e-18 * scale * scale


@kernel_inline
def _cost(drives: Drives, o: TaskWork) -> float:
    total = 0.0
    for d in range(drives.row.size):
        if drives.held[d] != 3:
            gap = o.q[0, d] - o.ref[0, d]
            total += 0.5 * drives.weight[d] * gap * gap
    return total


@kernel
def _restored(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float) -> bool:
    """Back onto the tasks' surface by a few least steps."""
    n, before = drives.row.size, np.inf
    for _ in range(8):
        miss = missed(tape, o)
        if miss < 1e-22 * scale * scale:
            return True
        if not miss < 0.5 * before:
            return miss < 1e-19 * scale * scale
        before = miss
        task_rows(plan, w, drives, tape, o)
        least_step(drives, tape, o, 0.0)
        for d in range(n):
            o.kept[2, d] = o.q[0, d]
        if not _go(plan, w, drives, tape, o, 1.0, scale):
            return False
    return False


@kernel_inline
def _direction(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, curved: bool) -> float:
    """Newton's step along the tasks' surface into o.step; returns its slope (negative: downhill), 0 if it is none.

    curved : with the second derivatives of the tasks. The factors become those of the solution.
    """
    n, m = drives.row.size, tape.tasks
    matrix(plan, w, drives, tape, o, False)
    # factors of tasks by least squares: K with the weights alone
    for d in range(n):
        o.r[d] = 0.0 if drives.held[d] > 0 else drives.weight[d] * (o.q[0, d] - o.ref[0, d])
    for j in range(m):
        o.r[n + j] = 0.0
    for i in range(n + m):
        o.step[i] = o.r[i]
    lu_solve(o.K, o.pivot, 0, n + m, o.step)
    for j in range(m):
        o.s[0, j] = -o.step[n + j]
    if curved:
        for i in range(n + m):
            o.kept[3, i] = o.r[i]
        if matrix(plan, w, drives, tape, o, True) == 0.0:
            return 0.0
        for i in range(n + m):
            o.r[i] = o.step[i] = o.kept[3, i]
        lu_solve(o.K, o.pivot, 0, n + m, o.step)
    slope = 0.0
    for d in range(n):
        o.step[d] = -o.step[d]
        slope += o.r[d] * o.step[d]
    return slope


@kernel
def _settled(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float, most: float) -> bool:
    """From drives that meet the tasks to the nearest to the reference."""
    n, curved = drives.row.size, True
    for _ in range(STEPS):
        closed(plan, w, drives, o, scale, False)
        forward(tape, o.x, o.p, 0, o.t)
        slope = _direction(plan, w, drives, tape, o, curved)
        if not slope < 0.0:
            if not curved:
                return True
            curved = False
            continue
        size, limit = 0.0, 1.0
        for d in range(n):
            size = max(size, abs(o.step[d]))
        if size < 1e-9 * scale:
            # a bound that holds a drive back without need
            if not _released(plan, w, drives, tape, o, scale):
                return True
            curved = True
            continue
        share, at = min(1.0, most / size), -1
        for d in range(n):
            if drives.held[d] == 0:
                q, ahead = o.q[0, d], o.step[d]
                room = drives.upper[d] - q if ahead > 0.0 else q - drives.lower[d]
                if abs(ahead) * share > room:
                    share, at = max(0.0, room / abs(ahead)), d
        if not _descent(plan, w, drives, tape, o, scale, share, slope):
            if share > 0.0:
                if not curved:
                    return size < 1e-6 * scale
                curved = False
                continue
        else:
            curved = True
        if at >= 0:
            near_low = abs(o.q[0, at] - drives.lower[at]) < abs(o.q[0, at] - drives.upper[at])
            edge = drives.lower[at] if near_low else drives.upper[at]
            if abs(o.q[0, at] - edge) < 1e-7 * scale:
                drives.held[at] = 1 if near_low else 2
                o.q[0, at] = edge
                closed(plan, w, drives, o, scale, False)
                _restored(plan, w, drives, tape, o, scale)
        limit = share
    return limit < 0.0


@kernel
def _descent(
    plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float, share: float, slope: float
) -> bool:
    """A share of o.step along which the cost falls, back on the tasks' surface; False if there is none."""
    n, cost = drives.row.size, _cost(drives, o)
    for c in range(o.x.shape[1]):
        o.kept[1, c] = o.x[0, c]
    start, step = np.empty(n), np.empty(n)
    for d in range(n):
        start[d], step[d] = o.q[0, d], o.step[d]
    for _ in range(12):
        for c in range(o.x.shape[1]):
            o.x[0, c] = o.kept[1, c]
        for d in range(n):
            o.q[0, d], o.kept[2, d], o.step[d] = start[d], start[d], step[d]
        closed(plan, w, drives, o, scale, True)
        good = _go(plan, w, drives, tape, o, share, scale) and _restored(plan, w, drives, tape, o, scale)
        if good and _cost(drives, o) < cost + 1e-4 * share * slope + 1e-15 * cost:
            return True
        share *= 0.5
    for c in range(o.x.shape[1]):
        o.x[0, c] = o.kept[1, c]
    for d in range(n):
        o.q[0, d] = start[d]
    closed(plan, w, drives, o, scale, False)
    return False


@kernel
def _released(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float) -> bool:
    """Let the drive go that its bound holds back most without need; False if there is none."""
    forward(tape, o.x, o.p, 0, o.t)
    residual(plan, w, drives, tape, o, 0, 0)
    return let_go(drives, o, scale)


@kernel
def reach(plan: Plan, drives: Drives, tape: Tape, o: TaskWork, scale: float) -> int:
    """State that meets the tasks, from the one in o: positions o.x[0], drives o.q[0]; the factors of the tasks there, o.s[0].

    o.p[0], o.ref[0], o.moving[0] : parameters, what drives are to be near to, prescribed coordinates that move. Returns MET,
    NEAREST or SLOW. Steps change no drive by more than a fifth of `scale`, m.
    """
    w, most = workspace(plan), 0.2 * scale
    for b in range(o.sign.size):
        o.sign[b] = 0.0
    if not closed(plan, w, drives, o, scale, False) or not _approach(plan, w, drives, tape, o, scale, most):
        return NEAREST
    return MET if _settled(plan, w, drives, tape, o, scale, most) else SLOW


@kernel
def linear(plan: Plan, drives: Drives, tape: Tape, o: TaskWork, scale: float) -> bool:
    """What tasks are off by at the state in o, at the end of o.r, and their derivatives by the drives, o.A."""
    w = workspace(plan)
    for b in range(o.sign.size):
        o.sign[b] = 0.0
    good = closed(plan, w, drives, o, scale, False)
    missed(tape, o)
    task_rows(plan, w, drives, tape, o)
    return good
