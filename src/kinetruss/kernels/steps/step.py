"""A step of fixed size as its methods see it: what is known of it, what they look for, and workspace to do so."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F0, F1, F2, I1, Record, record
from kinetruss.kernels.integrate.state import Control
from kinetruss.kernels.solve.kkt import prepare_rows
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["MOST", "Step", "change_by", "hold_end", "new_step", "converged"]

MOST = 60
"""Iterations of Newton's method."""
CONVERGED = 1e-14
"""Change of a position, in lengths of members, below which nothing is left to gain."""


@record
class Step(Record):
    """h : size, s; t_1 : its end, s. s (s^2), c (s) : what accelerations add to the end, x1 = p + s a, v1 = q + c a.

    x0, x1 (3 n,) : places at both ends, m; v0, v1 : velocities; xe, ve : where the equations of motion hold. a (3 n,) :
    accelerations, N (rows,) row forces that are looked for; p, q (3 n,) : the end without accelerations. target (3, rows) :
    what rows are held to at the end. Workspace: f (3 n,) forces without balance, da, work (3 n,), dN, gap (rows,).
    """

    h: F0
    t_1: F0
    s: F0
    c: F0
    x0: F1
    v0: F1
    x1: F1
    v1: F1
    xe: F1
    ve: F1
    a: F1
    p: F1
    q: F1
    f: F1
    da: F1
    work: F1
    target: F2
    N: F1
    dN: F1
    gap: F1


_, INTEGERS, REALS = Step.COUNT


@kernel
def new_step(n: int, rows: int) -> Step:
    """A step with n coordinates and so many rows."""
    # in the order of the fields
    shapes = (
        (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1),
        (3, rows), (rows, 1), (rows, 1), (rows, 1),
    )  # fmt: skip
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    return Step(ints, reals)


@kernel_bare
def hold_end(eq: Equations, ws: Workspace, step: Step) -> None:
    """What rows are held to at the end into target; prescribed coordinates of x1 and v1 are set."""
    prepare_rows(eq, ws, step.t_1, step.x1, step.v1)
    now, target = ws.target, step.target
    # targets at the end of the step
    for k in range(3):
        for j in range(target.shape[1]):
            target[k, j] = now[k, j]


@kernel_inline
def change_by(free: I1, step: Step) -> float:
    """a += da, N += dN; returns the largest change of a place at the end, m."""
    a, da, N, dN, s, change = step.a, step.da, step.N, step.dN, step.s, 0.0
    # Newton's correction of a; positions change by s da
    for i in range(free.size):
        a[free[i]] += da[free[i]]
        change = larger(change, abs(da[free[i]]) * s)
    # and of the multipliers
    for k in range(N.size):
        N[k] += dN[k]
    return change


@kernel_inline
def converged(control: Control, turn: int, change: float, last: float) -> bool:
    """True where nothing is left to gain, or little and no iteration gains much more; change, last : of two iterations, m."""
    tight = control.tolerance * control.size
    return change <= CONVERGED * control.size or (turn > 1 and change <= tight and change > 0.3 * last)
