"""Output at wanted times from the interpolant of a step: projected onto the constraints, accelerations and forces evaluated."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, I1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.steps.interpolants import rate_within, state_within

__all__ = ["ask_at", "ask_state", "gather", "got_last", "got_sample", "next_sample", "restore_failed"]

NEAR = 1e-5
"""Smallest scaled pivot, relative to the largest one met, below which accelerations are taken from the interpolant."""
FAR = 1e-3
"""Largest correction of a sample, in lengths of members; a larger one has led to another branch."""


@kernel_inline
def ask_state(free: I1, y: F1, t: float, work: Work) -> None:
    """Request the driver for the state y at t (s)."""
    nf, x, v, extra = free.size, work.x, work.v, work.extra
    # free coordinates of y = (x, v, z)
    for i in range(nf):
        x[free[i]] = y[i]
        v[free[i]] = y[nf + i]
    # extra states z
    for i in range(extra.size):
        extra[i] = y[2 * nf + i]
    work.ask_t = t


@kernel_bare
def gather(free: I1, work: Work, y: F1) -> None:
    """The state of the reply into y."""
    nf, x, v, extra = free.size, work.x, work.v, work.extra
    # free coordinates into y = (x, v, z)
    for i in range(nf):
        y[i] = x[free[i]]
        y[nf + i] = v[free[i]]
    # extra states z
    for i in range(extra.size):
        y[2 * nf + i] = extra[i]


@kernel_bare
def ask_at(control: Control, memory: Memory, t: float, work: Work) -> None:
    """Request the driver for the state at a time t (s) of the last step; it stays in STATES[0] too."""
    h, y = memory.h_old, work.states[0]
    if h == 0.0 or t == memory.t:
        # at its end, the state itself rather than its interpolant
        for i in range(y.size):
            y[i] = memory.y[0, i]
    else:
        state_within(memory, (t - memory.t_old) / h, y)
    ask_state(control.free, y, t, work)


@kernel_bare
def restore_failed(control: Control, work: Work) -> None:
    """Where a projection failed, as it may in a singular position, go back to that in STATES[0]."""
    if work.ok == 0.0 or work.moved > FAR * control.size:
        ask_state(control.free, work.states[0], work.ask_t, work)


@kernel_bare
def _write(control: Control, memory: Memory, samples: Samples, k: int, work: Work) -> None:
    """Fill sample k with the reply of the driver."""
    t, pivot = work.ask_t, work.new_pivot
    restore_failed(control, work)
    if pivot < NEAR * memory.pivot_most and memory.h_old != 0.0:
        # next to a singular position the interpolant knows the acceleration better than the equations do
        rate_within(memory, (t - memory.t_old) / memory.h_old, memory.h_old, work.states[1])
        # accelerations from the derivative of the interpolant
        for i in range(control.free.size):
            work.a[control.free[i]] = work.states[1, control.free.size + i]
    x, v, a, N = work.x, work.v, work.a, work.N
    # positions, velocities and accelerations of the sample
    for i in range(x.size):
        samples.x[k, i], samples.v[k, i], samples.a[k, i] = x[i], v[i], a[i]
    # multipliers N
    for i in range(N.size):
        samples.N[k, i] = N[i]
    # extra states z
    for i in range(work.extra.size):
        samples.z[k, i] = work.extra[i]
    row = samples.diagnostics[k]
    row[0], row[1], row[2] = memory.h_old, pivot, memory.constraint
    row[3], row[4], row[5] = memory.steps, memory.rejected, memory.evaluations


@kernel_bare
def next_sample(control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Ask for the next sample within the last step, or for the state at an event that stops: the last one, at that time.

    Returns what is asked, 0 where there is none.
    """
    stop, k = memory.stop, work.next_sample
    if k >= work.last_sample:
        return 0
    t, end = samples.times[k], memory.t
    # steps of fixed size end where samples are wanted, but for round-off
    slack = 0.0 if work.explicit else 1e-9 * memory.h_old
    if t <= min(end + slack, stop):
        work.phase = m.GOT_SAMPLE
        if abs(t - end) <= slack:
            t = end
    elif stop <= memory.t:
        samples.times[k] = t = stop
        work.phase = m.GOT_LAST
    else:
        return 0
    ask_at(control, memory, t, work)
    return m.EVALUATE if _kept(control, memory, t, work) else m.PROJECT | m.EVALUATE


@kernel_bare
def _kept(control: Control, memory: Memory, t: float, work: Work) -> bool:
    """True for a state that is reported as it is.

    One is the end of an explicit step, which is projected, the other that of a step of the midpoint rule, whose own velocities
    keep energy and momenta; projected ones do not.
    """
    h, method = memory.h_old, control.method
    if h == 0.0 or method not in (m.EXPLICIT_RK, m.MIDPOINT):
        return False
    if (method == m.EXPLICIT_RK and t != memory.t) or min(t - memory.t_old, memory.t - t) > 1e-9 * h:
        return False
    work.ok, work.moved = 1.0, 0.0
    return True


@kernel_bare
def got_sample(control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Write a sample; look for the next."""
    _write(control, memory, samples, work.next_sample, work)
    work.next_sample += 1
    work.phase = m.LOOP
    return 0


@kernel_bare
def got_last(control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Write the state at an event that stops."""
    got_sample(control, memory, samples, work)
    work.code = m.EVENT
    work.phase = m.END
    return m.FINISH
