"""Output at wanted times from the interpolant of a step: projected onto the constraints, accelerations and forces evaluated."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_inline, kernel_inner
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Control, Room
from kinetruss.kernels.steps.interpolants import rate_within, state_within

__all__ = ["ask_at", "ask_state", "gather", "got_last", "got_sample", "next_sample", "settle"]

NEAR = 1e-5
"""Smallest scaled pivot, in parts of the largest one met, below which accelerations are taken from the interpolant."""
FAR = 1e-3
"""Correction of a sample, in lengths of members, that cannot be one: it led to another branch."""


@kernel_inline
def ask_state(free, y, t, room: Room):  # type: ignore[no-untyped-def]
    """Put the state y at t (s) before the driver."""
    nf, x, v, extra = free.size, room.x, room.v, room.extra
    for i in range(nf):
        x[free[i]] = y[i]
        v[free[i]] = y[nf + i]
    for i in range(extra.size):
        extra[i] = y[2 * nf + i]
    room.num[m.ASK_T] = t


@kernel_inner
def gather(free, room: Room, y):  # type: ignore[no-untyped-def]
    """The state that came back from the driver into y."""
    nf, x, v, extra = free.size, room.x, room.v, room.extra
    for i in range(nf):
        y[i] = x[free[i]]
        y[nf + i] = v[free[i]]
    for i in range(extra.size):
        y[2 * nf + i] = extra[i]


@kernel_inner
def ask_at(control: Control, memory, t, room: Room):  # type: ignore[no-untyped-def]
    """Put the state at a time t (s) of the last step before the driver; it stays in STATES[0] too."""
    h, y = memory.real[m.H_OLD], room.states[0]
    if h == 0.0 or t == memory.real[m.T]:
        for i in range(y.size):
            y[i] = memory.y[0, i]
    else:
        state_within(memory, (t - memory.real[m.T_OLD]) / h, y)
    ask_state(control.free, y, t, room)


@kernel_inner
def settle(control: Control, room: Room):  # type: ignore[no-untyped-def]
    """Where a projection failed, as it may in a singular position, go back to that in STATES[0]."""
    if room.num[m.OK] == 0.0 or room.num[m.MOVED] > FAR * control.real[m.SIZE]:
        ask_state(control.free, room.states[0], room.num[m.ASK_T], room)


@kernel_inner
def _write(control: Control, memory, samples, k, room: Room):  # type: ignore[no-untyped-def]
    """Fill sample k with the answer of the driver."""
    real, count, t, pivot = memory.real, memory.count, room.num[m.ASK_T], room.num[m.NEW_PIVOT]
    settle(control, room)
    if pivot < NEAR * real[m.PIVOT_MOST] and real[m.H_OLD] != 0.0:
        # next to a singular position the interpolant knows the acceleration better than the equations do
        rate_within(memory, (t - real[m.T_OLD]) / real[m.H_OLD], real[m.H_OLD], room.states[1])
        for i in range(control.free.size):
            room.a[control.free[i]] = room.states[1, control.free.size + i]
    x, v, a, pulls = room.x, room.v, room.a, room.pulls
    for i in range(x.size):
        samples.x[k, i], samples.v[k, i], samples.a[k, i] = x[i], v[i], a[i]
    for i in range(pulls.size):
        samples.N[k, i] = pulls[i]
    for i in range(room.extra.size):
        samples.z[k, i] = room.extra[i]
    row = samples.diagnostics[k]
    row[0], row[1], row[2] = real[m.H_OLD], pivot, real[m.CONSTRAINT]
    row[3], row[4], row[5] = count[m.STEPS], count[m.REJECTED], count[m.EVALUATIONS]


@kernel_inner
def next_sample(control, memory, samples, room: Room):  # type: ignore[no-untyped-def]
    """Ask for the next sample within the last step, or for the state at an event that stops: the last one, at that time.

    Returns what is asked, 0 where there is none.
    """
    at, stop, k = room.at, memory.real[m.STOP], room.at[m.SAMPLE]
    if k >= at[m.LAST]:
        return 0
    t, end = samples.times[k], memory.real[m.T]
    # steps of fixed size end where samples are wanted, but for round-off
    slack = 0.0 if at[m.EXPLICIT] else 1e-9 * memory.real[m.H_OLD]
    if t <= min(end + slack, stop):
        at[m.PHASE] = m.GOT_SAMPLE
        if abs(t - end) <= slack:
            t = end
    elif stop <= memory.real[m.T]:
        samples.times[k] = t = stop
        at[m.PHASE] = m.GOT_LAST
    else:
        return 0
    ask_at(control, memory, t, room)
    return m.EVALUATE if _kept(control, memory, t, room) else m.PROJECT | m.EVALUATE


@kernel_inner
def _kept(control: Control, memory, t, room: Room):  # type: ignore[no-untyped-def]
    """True for a state that is to be told as it is.

    One is the end of an explicit step, which is projected, the other that of a step of the midpoint rule, whose own velocities
    keep energy and momenta; projected ones do not.
    """
    real, num = memory.real, room.num
    h, method = real[m.H_OLD], control.real[m.METHOD]
    if h == 0.0 or method not in (m.EXPLICIT_RK, m.MIDPOINT):
        return False
    if (method == m.EXPLICIT_RK and t != real[m.T]) or min(t - real[m.T_OLD], real[m.T] - t) > 1e-9 * h:
        return False
    num[m.OK], num[m.MOVED] = 1.0, 0.0
    return True


@kernel_inner
def got_sample(control, memory, samples, room: Room):  # type: ignore[no-untyped-def]
    """Write a sample; look for the next."""
    _write(control, memory, samples, room.at[m.SAMPLE], room)
    room.at[m.SAMPLE] += 1
    room.at[m.PHASE] = m.LOOP
    return 0


@kernel_inner
def got_last(control, memory, samples, room: Room):  # type: ignore[no-untyped-def]
    """Write the state at an event that stops."""
    got_sample(control, memory, samples, room)
    room.at[m.CODE] = m.EVENT
    room.at[m.PHASE] = m.END
    return m.FINISH
