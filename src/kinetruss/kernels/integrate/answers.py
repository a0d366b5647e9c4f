"""What an integrator asks the equations of motion for a state: to bring it onto the rows, accelerations, pivots, energies.

A call of an integrator is one tuple. All that ask reach the equations at one address: they are compiled once, for all methods.
"""

from __future__ import annotations

from typing import NamedTuple

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel_inline
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Control, Memory, Work
from kinetruss.kernels.solve.accelerations import accelerate
from kinetruss.kernels.solve.kkt import factor, kinetic, potential, prepare_rows, project_near
from kinetruss.kernels.structure.equations import Equations, Workspace

PROJECT, PIVOT, EVALUATE, ENERGY = 1, 2, 4, 8
"""What is asked, as bits; the first comes before the others. PIVOT : the smallest one, without accelerations."""


class Run(NamedTuple):
    """A call of an integrator; user : address of a force."""

    eq: Equations
    ws: Workspace
    user: int
    control: Control
    memory: Memory
    work: Work


asking = Apart("run.control.find_at")
"""What all methods ask."""


@kernel_inline
def rule_of_fixed_steps(control: Control) -> bool:
    """True for the methods that do not estimate their error."""
    return control.method == m.MIDPOINT or control.method == m.ALPHA or control.method == m.RATTLE


@kernel_inline
def largest_pivot(run: Run) -> None:
    """What explicit steps tell the solver: the largest pivot so far."""
    if run.control.method == m.EXPLICIT_RK or run.control.method == m.TAYLOR:
        run.ws.pivot[1] = run.memory.pivot_most


@kernel_inline
def put_state(control: Control, y: F1, t: float, work: Work) -> None:
    """Put down the state y at t (s) for `find`."""
    free, x, v, extra = control.free, work.x, work.v, work.extra
    nf = free.size
    # free coordinates of y = (x, v, z)
    for i in range(nf):
        x[free[i]] = y[i]
        v[free[i]] = y[nf + i]
    # extra states z
    for i in range(extra.size):
        extra[i] = y[2 * nf + i]
    work.ask_t = t


@kernel_inline
def take_rate(control: Control, work: Work, rate: F1) -> None:
    """y' = (v, a) of the state that was found into rate."""
    free, v, a = control.free, work.v, work.a
    for i in range(free.size):
        rate[i], rate[free.size + i] = v[free[i]], a[free[i]]


@asking
def find(run: Run, asked: int, near: int) -> None:
    """Answer for the state that was put down. near : 1 where factors of nearly the same positions are at hand."""
    eq, ws, memory, work = run.eq, run.ws, run.memory, run.work
    t, x, v, pivot = work.ask_t, work.x, work.v, -1.0
    largest_pivot(run)
    if asked == ENERGY:
        work.kinetic, work.potential = kinetic(eq, ws, x, v), potential(eq, x)
        return
    work.factored = -1.0
    if asked & PROJECT:
        ok, work.moved, _, pivot = project_near(eq, ws, t, x, v, work.tolerance, near != 0)
        work.ok = 1.0 if ok else 0.0
    if asked & (EVALUATE | PIVOT):
        if pivot == -1.0:  # no factors of these places are left by a projection
            prepare_rows(eq, ws, t, x, v)
            pivot = factor(eq, ws, x)
        work.new_pivot = pivot
    if asked & EVALUATE:
        accelerate(eq, ws, run.user, t, x, v, work.a, work.N)
        memory.evaluations += 1
