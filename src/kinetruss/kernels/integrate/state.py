"""State, settings and workspace of the integrators, and how a call ends.

All memory is in the arrays of `Memory`: saved and restored, a run goes on bit for bit as if never interrupted.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.record import F0, F1, F2, I0, I1, I2, Record, record
from kinetruss.kernels.coordinates.tape import Tape

__all__ = ["Control", "Memory", "Work", "Samples", "new_memory"]

# how a call ends
GOING = -1
DONE = 0
PAUSED = 1
EVENT = 2
STEP_TOO_SMALL = 3
STIFF = 4
NOT_FINITE = 5
ENERGY_GROWS = 6
TOO_MANY_STEPS = 7
NOT_CONVERGED = 8
UNDETERMINED = 9
ASIDE = 10

# methods
EXPLICIT_RK, MIDPOINT, ALPHA, RATTLE, TAYLOR, RADAU = range(6)
_KEPT = 2_000_000
"""Numbers of all states between samples that are kept before the caller takes them."""
# columns of Samples.diagnostics
DIAGNOSTICS = ("step_size", "smallest_pivot", "constraint_error", "steps", "rejected", "evaluations")
# kinds of watched quantities
LENGTH, COORDINATE, FORCE, SUM = 0, 1, 2, 3

# other sizes tried for a step whose stages come near a singular position
TRIES = 8


@record
class Memory(Record):
    """State of an integration.

    t, t_old : end and begin of the last step, s; h, h_old : size of the next and of the last one. pivot_0, pivot_1 : smallest
    scaled pivots at the starts of the last two steps of fixed size. turned : by how much, at most, anything has turned since
    the last sample or state between samples, rad. interval : between jumps. alone : a step is taken whatever round-off does
    to it. launched : a step was taken from outside. series : the interpolant of the last step is in powers, that of a series or
    of Radau IIA. passages_met, events_met, states_between : how many are kept.
    y (4, ny) : state, its rate, what the method adds; a state is free positions (m), free velocities (m/s), extra states.
    dense (8 or more, ny) : interpolant of the last step. multiplier (rows,) : its N.
    passages (k, 3) : time, smallest scaled pivot, 1 where the branch is certain.
    events (k, 4) : index of the event, time, direction, value. watched (events,) : the side of their values on which they were
    last, 1 above, -1 below, 0 where they have arrived. between (k, 1 + ny) : time and state, kept between samples that are so
    far apart that something turns far from one to the next.
    """

    t: F0
    h: F0
    t_old: F0
    h_old: F0
    error_old: F0
    energy_least: F0
    kinetic_most: F0
    pivot_most: F0
    pivot: F0
    constraint: F0
    stiffness: F0
    t_start: F0
    stop: F0
    pivot_0: F0
    pivot_1: F0
    turned: F0
    started: I0
    steps: I0
    rejected: I0
    evaluations: I0
    stiff_steps: I0
    passages_met: I0
    events_met: I0
    interval: I0
    newtons: I0
    carried: I0
    alone: I0
    launched: I0
    series: I0
    states_between: I0
    y: F2
    dense: F2
    multiplier: F1
    passages: F2
    events: F2
    watched: F1
    between: F2


PATTERN = (
    "ptr",
    "below",
    "target",
    "place",
    "row_place",
    "law_at",
    "row_at",
    "gradient_at",
    "base",
    "values",
    "space",
    "sum_at",
)
"""Fields of `Control` that hold the pattern of the matrix of an implicit method (kernels.integrate.tangent)."""
_TURNING = {"pairs": (0, 2), "angle_ptr": (1,), "angle_form": (0, 3), "angle_at": (0, 4), "angle_data": (0, 7)}
"""Shapes of those that say what turns, where nothing does."""


@record
class Control(Record):
    """What a method is asked for, in one record.

    Numbers: what the method is asked for; steps_at : address of its steps (integrate.loop), find_at : of integrate.answers,
    aside_at : of what takes a step of another method (integrate.dop853_step), 0 until it is wanted. stand (3 n,) : where
    prescribed coordinates stand, m. free (nf,) : flat coordinates of a state. length (nf,) : m, what errors in position are
    measured in. breaks (3, k + 1) : start, times at which something jumps, end of the run, s; first and last time of the
    interval behind each at which equations are evaluated. pairs (k, 2) : flat coordinates of the ends of what turns; angles
    angle_ptr[j]:angle_ptr[j + 1] of terms (see structure.terms) that do.
    tape_ints, tape_reals : buffers of the tape of all sums, for power series; tape_laws (k, 5) : rest, period, force at rest,
    stiffness and damping of the elements on coordinates among them.
    Watched quantities: watching, addresses of kernels (integrate.events), if there are any; event_kind (e,) LENGTH, COORDINATE,
    FORCE, SUM; event_A, event_B (e,) flat coordinates, A of a force its row; event_value (e,) m, rad or N; event_direction (e,)
    1 rising, -1 falling, 0 both; event_stops (e,) 1 where the run ends there; event_sampled (e,) 1 where it is no polynomial in
    a step; event_at (e, 6) places in a state of the coordinates of both ends, -1 where prescribed; of a SUM terms
    event_ptr[e]:event_ptr[e + 1] in event_form, event_term, event_data (see structure.terms), and event_period (e,) after which
    it is the same, or 0.
    """

    rtol: F0
    atol: F0
    first_step: F0
    fixed_step: F0
    t_end: F0
    max_steps: F0
    isolated: F0
    stages_projected: F0
    tolerance: F0
    rho: F0
    pivot_limit: F0
    size: F0
    method: F0
    orders: F0
    steps_at: I0
    find_at: I0
    aside_at: I0
    watching: I1
    ptr: I1
    below: I1
    target: I1
    place: I1
    row_place: I1
    law_at: I2
    row_at: I2
    gradient_at: I2
    base: F1
    values: F1
    space: F1
    sum_at: I2
    free: I1
    stand: F1
    length: F1
    breaks: F2
    event_kind: I1
    event_A: I1
    event_B: I1
    event_value: F1
    event_direction: I1
    event_stops: I1
    event_sampled: I1
    event_at: I2
    event_ptr: I1
    event_form: I2
    event_term: I2
    event_data: F2
    event_period: F1
    element_at: I1
    element_ptr: I2
    pairs: I2
    angle_ptr: I1
    angle_form: I2
    angle_at: I2
    angle_data: F2
    tape_ints: I1
    tape_reals: F1
    tape_laws: F2

    @classmethod
    def of_method(cls, pattern: Mapping[str, NDArray[Any]], given: Mapping[str, Any]) -> Control:
        """The record of named arrays; an explicit method has an empty pattern."""
        empty = {name: np.zeros((0, 0)[: field.axes]) for name, field in cls.FIELDS.items()}
        nothing = Tape.zeros({})
        at_rest = {name: np.zeros(shape) for name, shape in _TURNING.items()}
        tape = {"tape_ints": nothing.ints, "tape_reals": nothing.reals, "tape_laws": np.zeros((0, 5))}
        return cls.of({**empty, **at_rest, **tape, **pattern, **given})


class Samples(NamedTuple):
    """Output arrays. times (s,); x, v, a (s, 3 n); N (s, rows); z (s, extra); diagnostics (s, 6)."""

    times: F1
    x: F2
    v: F2
    a: F2
    N: F2
    z: F2
    diagnostics: F2

    def part(self, first: int, last: int | None = None) -> Samples:
        """The output arrays of the samples first:last alone, a view."""
        return Samples(*(one[first:last] for one in self))


@record
class Work(Record):
    """Scratch of a call; nothing in it lasts.

    code : how the call ends, GOING until then; begun : 1 behind its first look; next_sample, last_sample; next_time : when the
    next one is due, s; budget : steps left. Question: ask_t; answers: ok, moved, new_pivot, kinetic, potential; tolerance : of
    projections. The step that is tried: try_h, try_t, size_h, error, ...; ends_only : 1 where it has no interpolant. The search
    for a passage or an event: left, right, best, and their values.
    Accelerations lost in round-off: round_off by a stage, start_round_off by the start of the step, round_off_error in parts of
    what its error may be. factored : smallest pivot of the factors at hand where they are of the state at the end of the last
    step, else -1. turning : how far, at most, anything turns in the step at hand, rad. pivots (14,) of the stages.
    stages (16, ny); states (5, ny); x, v, a (3 n,), N (rows,), extra : question and answer. For events, D the highest
    degree: polynomials (5, D + 1), stack (., D + 3), piece_roots and roots (., 3), spans (., 2).
    """

    next_sample: I0
    last_sample: I0
    budget: I0
    code: I0
    begun: I0
    near: I0
    spoilt: I0
    repeated: I0
    resized: I0
    ends_only: I0
    roots_found: I0
    next_time: F0
    tolerance: F0
    ask_t: F0
    ok: F0
    moved: F0
    new_pivot: F0
    kinetic: F0
    potential: F0
    try_h: F0
    try_t: F0
    size_h: F0
    share: F0
    lowest: F0
    where: F0
    near_t: F0
    error: F0
    end_pivot: F0
    most_h: F0
    cap: F0
    left: F0
    left_f: F0
    right: F0
    right_f: F0
    best: F0
    best_f: F0
    width: F0
    round_off: F0
    start_round_off: F0
    round_off_error: F0
    least_round_off: F0
    clear_h: F0
    most: F0
    factored: F0
    turning: F0
    pivots: F1
    stages: F2
    states: F2
    x: F1
    v: F1
    a: F1
    N: F1
    extra: F1
    polynomials: F2
    stack: F2
    piece_roots: F2
    roots: F2
    spans: F2


def new_memory(
    free: int, extra: int, rows: int, events: int, passages_kept: int = 4096, events_kept: int = 4096, orders: int = 8
) -> Memory:
    """Empty memory for `free` coordinates, `extra` states, `rows` multipliers, events, and `orders` rows of an interpolant."""
    size = 2 * free + extra
    return Memory.zeros(
        {
            "y": (4, size),
            "dense": (orders, size),
            "multiplier": (rows,),
            "passages": (passages_kept, 3),
            "events": (events_kept, 4),
            "watched": (events,),
            "between": (max(8, min(512, _KEPT // (1 + size))), 1 + size),
        }
    )
