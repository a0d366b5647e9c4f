"""Output at wanted times from the interpolant of a step, and states between samples where something turns far."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, I1
from kinetruss.kernels.compiled.views import view
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import EVALUATE, PROJECT, Run, find, put_state, rule_of_fixed_steps
from kinetruss.kernels.integrate.dop853 import interpolate, interpolate_rate
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.structure.lengths import line_turning
from kinetruss.kernels.structure.terms import term_along, term_gradient


@kernel_bare
def state_within(memory: Memory, s: float, out: F1) -> None:
    """State at the fraction s of the last step into out."""
    F = memory.dense
    if memory.series == 0:
        interpolate(F, s, out)
        return
    # Horner's scheme for the power series of the step: highest order,
    for i in range(out.size):
        out[i] = F[F.shape[0] - 1, i]
    # then the lower ones
    for j in range(F.shape[0] - 2, -1, -1):
        for i in range(out.size):
            out[i] = out[i] * s + F[j, i]


@kernel_bare
def rate_within(memory: Memory, s: float, h: float, out: F1) -> None:
    """Rate of the state at the fraction s of the last step, of h (s), into out."""
    F = memory.dense
    if memory.series == 0:
        interpolate_rate(F, s, h, out)
        return
    # derivative of the power series by its fraction:
    for i in range(out.size):
        out[i] = 0.0
    # Horner's scheme for sum_j j F_j s^(j-1)
    for j in range(F.shape[0] - 1, 0, -1):
        for i in range(out.size):
            out[i] = out[i] * s + j * F[j, i]
    # and in time
    for i in range(out.size):
        out[i] /= h


# Output at wanted times from the interpolant of a step: projected onto the constraints, accelerations and forces evaluated.

NEAR = 1e-5
"""Smallest scaled pivot, relative to the largest one met, below which accelerations are taken from the interpolant."""
FAR = 1e-3
"""Largest correction of a sample, in lengths of members; a larger one has led to another branch."""


@kernel_bare
def gather(free: I1, work: Work, y: F1) -> None:
    """The state that was found into y."""
    nf, x, v, extra = free.size, work.x, work.v, work.extra
    # free coordinates into y = (x, v, z)
    for i in range(nf):
        y[i] = x[free[i]]
        y[nf + i] = v[free[i]]
    # extra states z
    for i in range(extra.size):
        y[2 * nf + i] = extra[i]


@kernel_bare
def put_at(run: Run, t: float) -> None:
    """Put down the state at a time t (s) of the last step for `find`; it stays in STATES[0] too."""
    memory, y = run.memory, run.work.states[0]
    h = memory.h_old
    if h == 0.0 or t == memory.t:
        # at its end, the state itself rather than its interpolant
        for i in range(y.size):
            y[i] = memory.y[0, i]
    else:
        state_within(memory, (t - memory.t_old) / h, y)
    put_state(run.control, y, t, run.work)


@kernel_bare
def restore_failed(control: Control, work: Work) -> None:
    """Where a projection failed, as it may in a singular position, go back to that in STATES[0]."""
    if work.ok == 0.0 or work.moved > FAR * control.size:
        put_state(control, work.states[0], work.ask_t, work)


@kernel_bare
def _write(control: Control, memory: Memory, samples: Samples, k: int, work: Work) -> None:
    """Fill sample k with what was found."""
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
def _as_it_is(control: Control, memory: Memory, t: float, work: Work) -> bool:
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
def write_due(run: Run, samples: Samples) -> None:
    """Write the samples within the last step, or up to an event that stops: the last one, at that time."""
    control, memory, work = run.control, run.memory, run.work
    # steps of fixed size end where samples are wanted, but for round-off
    slack = 1e-9 * memory.h_old if rule_of_fixed_steps(control) else 0.0
    while work.next_sample < work.last_sample:
        k, stop, end = work.next_sample, memory.stop, memory.t
        t = samples.times[k]
        if t <= min(end + slack, stop):
            if abs(t - end) <= slack:
                t = end
        elif stop <= memory.t:
            samples.times[k] = t = stop
            work.code = m.EVENT
        else:
            return
        put_at(run, t)
        find(run, EVALUATE if _as_it_is(control, memory, t, work) else PROJECT | EVALUATE, 0)
        _write(control, memory, samples, k, work)
        work.next_sample += 1
        if work.code == m.EVENT:
            return


# States between samples: kept where something turns so far from one sample to the next that whole turns could be lost.
#
# How fast anything turns is found at the ends and in the middle of a step: the angular rate of the line between two nodes,
# |d x d'|/d^2, and the rates of angles about axes. Wherever this adds up to TURN since the last sample or state kept, the state
# of the step's own polynomial is kept.

TURN = 0.7
"""rad."""


@kernel_bare
def turning(control: Control, work: Work) -> float:
    """The fastest turning (rad/s) in the state that was put down."""
    x, v, pairs, fastest = work.x, work.v, control.pairs, 0.0
    for k in range(pairs.shape[0]):
        fastest = max(fastest, line_turning(x, v, pairs[k, 0], pairs[k, 1]))
    ptr, form = control.angle_ptr, control.angle_form
    at, data = control.angle_at, control.angle_data
    scratch = view(work.pivots, 0, 12)
    # J v of each angle about an axis
    for j in range(ptr.size - 1):
        rate = 0.0
        for t in range(ptr[j], ptr[j + 1]):
            term_gradient(form, at, data, t, x, scratch)
            rate += term_along(at, t, scratch, v)
        if abs(rate) < math.inf:
            fastest = max(fastest, abs(rate))
    return fastest


@kernel_bare
def must_drain(memory: Memory) -> bool:
    """True where the arrays may be too full for what the next step finds."""
    return 2 * memory.states_between > memory.between.shape[0] or (
        memory.watched.size > 0 and 2 * memory.events_met > memory.events.shape[0]
    )


@kernel_bare
def _fastest(control: Control, memory: Memory, work: Work) -> float:
    """The fastest turning (rad/s) at the start, in the middle and at the end of the last step."""
    fastest, y = 0.0, work.states[0]
    # at both ends and in the middle of the step
    for k in range(3):
        state_within(memory, 0.5 * k, y)
        put_state(control, y, memory.t, work)
        fastest = max(fastest, turning(control, work))
    return fastest


@kernel_bare
def _keep(memory: Memory, s: float, work: Work) -> None:
    """Keep the state at the fraction s of the last step."""
    k, kept, y = memory.states_between, memory.between, work.states[0]
    if k >= kept.shape[0]:
        return
    if s == 1.0:
        # at its end, the state itself rather than its interpolant
        for i in range(y.size):
            y[i] = memory.y[0, i]
    else:
        state_within(memory, s, y)
    kept[k, 0] = memory.t if s == 1.0 else memory.t_old + s * memory.h_old
    # row k of the states kept: time, then the state
    for i in range(y.size):
        kept[k, 1 + i] = y[i]
    memory.states_between = k + 1


@kernel_bare
def keep_between(control: Control, memory: Memory, samples: Samples, work: Work) -> None:
    """Keep the states of the last step that are needed between its samples."""
    if control.pairs.shape[0] == 0 or memory.h_old == 0.0:
        return
    # DOP853 has its interpolant only where it was asked for
    inside = work.ends_only == 0 or memory.series != 0
    turn = (_fastest(control, memory, work) if inside else work.turning) * memory.h_old
    s, k, turned = 0.0, work.next_sample, memory.turned
    # along the step, next comes either a sample or the place where the turning since the last state adds up to TURN
    while turn > 0.0:
        sampled, kept = math.inf, s + max(0.0, TURN - turned) / turn
        if k < work.last_sample and samples.times[k] <= memory.t:
            sampled = max(s, (samples.times[k] - memory.t_old) / memory.h_old)
        if min(sampled, kept) > 1.0:
            break
        if sampled <= kept:
            s, turned, k = sampled, 0.0, k + 1
            continue
        s, turned = kept if inside else 1.0, 0.0
        _keep(memory, s, work)
        if s >= 1.0:
            break
    memory.turned = turned + (1.0 - s) * turn
