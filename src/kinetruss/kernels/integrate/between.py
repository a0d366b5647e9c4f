"""States between samples: kept where something turns so far from one sample to the next that whole turns could be lost.

How fast anything turns is found at the ends and in the middle of a step: the angular rate of the line between two nodes,
|d x d'|/d^2, and the rates of angles about axes. Wherever this adds up to TURN since the last sample or state kept, the state
of the step's own polynomial is kept.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.parts import view
from kinetruss.kernels.constraints.terms import term_along, term_gradient
from kinetruss.kernels.integrate.samples import ask_state
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.steps.interpolants import state_within

__all__ = ["keep_between", "must_drain", "turning"]

TURN = 0.7
"""rad."""


@kernel_bare
def turning(control: Control, work: Work) -> float:
    """The fastest turning (rad/s) in the state of the last reply."""
    x, v, pairs, fastest = work.x, work.v, control.pairs, 0.0
    # |d x d'|/|d|^2: angular rate of each line between two nodes
    for k in range(pairs.shape[0]):
        a, b = pairs[k, 0], pairs[k, 1]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        ex, ey, ez = v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2]
        square = dx * dx + dy * dy + dz * dz
        px, py, pz = dy * ez - dz * ey, dz * ex - dx * ez, dx * ey - dy * ex
        if square > 0.0:
            fastest = max(fastest, math.sqrt(px * px + py * py + pz * pz) / square)
    ptr, kind = control.angle_ptr, control.angle_kind
    at, data = control.angle_at, control.angle_data
    scratch = view(work.pivots, 0, 10)
    # J v of each angle about an axis
    for j in range(ptr.size - 1):
        rate = 0.0
        for t in range(ptr[j], ptr[j + 1]):
            term_gradient(kind, at, data, t, x, scratch)
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
        ask_state(control.free, y, memory.t, work)
        fastest = max(fastest, turning(control, work))
    return fastest


@kernel_bare
def _kept(memory: Memory, s: float, work: Work) -> None:
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
    inside = work.end_stage != 12 or memory.series != 0
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
        _kept(memory, s, work)
        if s >= 1.0:
            break
    memory.turned = turned + (1.0 - s) * turn
