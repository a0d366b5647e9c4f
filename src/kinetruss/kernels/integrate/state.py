"""What the integrators remember between calls, what they are told, and how they end.

All memory is in the arrays of `Memory`: saved and restored, a run goes on bit for bit as if never interrupted.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Record, record

__all__ = ["Control", "Memory", "Room", "Samples", "new_memory"]

# how a call ends
DONE = 0
PAUSED = 1
EVENT = 2
STEP_TOO_SMALL = 3
STIFF = 4
NOT_FINITE = 5
ENERGY_GROWS = 6
TOO_MANY_STEPS = 7
NOT_CONVERGED = 8
BLIND = 9

# places in Memory.real; PIVOT_0, PIVOT_1 : at the starts of the last two steps of fixed size; TURNED : by how much, at most,
# anything has turned since the last sample or state between samples, rad
(T, H, T_OLD, H_OLD, ERROR_OLD, ENERGY_LEAST, KINETIC_MOST, PIVOT_MOST, PIVOT, CONSTRAINT, STIFFNESS, T_START, STOP, PIVOT_0,
 PIVOT_1, TURNED) = range(16)  # fmt: skip
REALS = 16
# places in Memory.count; ALONE : a step is taken whatever round-off does to it; LAUNCHED : a step was taken from outside;
# SERIES : the last step was taken by a power series; BETWEEN : states between samples in memory
(STARTED, STEPS, REJECTED, EVALUATIONS, STIFF_STEPS, PASSAGES, EVENTS, BREAK, NEWTONS, CARRIED, ALONE, LAUNCHED, SERIES,
 BETWEEN) = range(14)  # fmt: skip
COUNTS = 16
# places in Control.real
(RTOL, ATOL, FIRST_STEP, FIXED_STEP, T_END, MAX_STEPS, ISOLATED, STAGES_PROJECTED, TOLERANCE, RHO, PIVOT_LIMIT, SIZE, METHOD,
 ORDERS) = range(14)  # fmt: skip
CONTROLS = 16
# methods
EXPLICIT_RK, MIDPOINT, ALPHA, RATTLE, TAYLOR = range(5)
_KEPT = 2_000_000
"""Numbers of states between samples that are kept before they are taken away."""
# columns of Samples.diagnostics
DIAGNOSTICS = ("step_size", "smallest_pivot", "constraint_error", "steps", "rejected", "evaluations")
# kinds of watched quantities, and columns of Control.events; PLACE_A : of the first of six coordinates in a state, or -1
LENGTH, COORDINATE, FORCE = 0, 1, 2
KIND, NODE_A, NODE_B, VALUE, DIRECTION, STOPS, SAMPLED, PLACE_A = range(8)
WATCH_WIDTH = 13

# other sizes tried for a step whose stages come near a singular position
TRIES = 8
# Room.at[EXPLICIT]: 0 where steps are of fixed size, 1 for DOP853
BY_SERIES = 2
# what the machine asks of the driver; PROJECT comes before EVALUATE; PIVOT_ONLY is the smallest one without accelerations
PROJECT, EVALUATE, ENERGY, STEP, FINISH, PIVOT_ONLY = 1, 2, 4, 8, 16, 32
# places in Room.at
(PHASE, SAMPLE, LAST, BUDGET, CODE, STAGE, END_STAGE, NEAR, SPOILT, REPEATED, LOOK, WATCH, TURN, BEFORE, EXPLICIT,
 BLURS, FOUND, TOP) = range(18)  # fmt: skip
PLACES = 24
# places in Room.num: the question, the answers, the step that is tried, the search for a passage or an event
ASK_T, OK, MOVED, NEW_PIVOT, KINETIC, POTENTIAL = range(6)
TRY_H, TRY_T, SIZE_H, SHARE, LOWEST, WHERE, NEAR_T, ERROR, END_PIVOT, MOST_H, CAP = range(6, 17)
LEFT, LEFT_F, RIGHT, RIGHT_F, BEST, BEST_F, WIDTH, SIDE_F = range(17, 25)
# the same: accelerations lost in round-off by a stage, by the start of the step, and in parts of what its error may be
BLUR, START_BLUR, BLURRED, LEAST_BLURRED, CLEAR_H, MOST = range(25, 31)
# smallest pivot of the factors at hand where they are of the state at the end of the last step, else -1
FACTORED = 31
PIVOTS = 32
# how far, at most, anything turns in the step at hand, rad
TURNING = 46
NUMBERS = 48
# phases: who takes the answer
(BEGIN, START_RATE, START_ENERGY, START_WATCH, LOOP, GOT_SAMPLE, GOT_LAST, TRY, GOT_STAGE, GOT_NEW, GOT_STEP, COMMITTED,
 PASSAGE_MIDDLE, PASSAGE_LEFT, PASSAGE_RIGHT, PASSAGE_VERTEX, SCAN, GOT_LOOK, CROSSINGS, GOT_ROOT, CHECKS, GOT_ENERGY, JUMP,
 GOT_JUMP, END) = range(25)  # fmt: skip


class Memory(NamedTuple):
    """State of an integration.

    real (16,), count (16,) : numbers named above. y (4, ny) : state, its rate, what the method adds; a state is free positions
    (m), free velocities (m/s), extra states. dense (8 or more, ny) : interpolant of the last step. multiplier (rows,) : its N.
    passages (k, 3) : time, smallest scaled pivot, 1 where the branch is certain.
    events (k, 4) : index of the event, time, direction, value. watched (events,) : the side of their values on which they were
    last, 1 above, -1 below, 0 where they have arrived. between (k, 1 + ny) : time and state, kept between samples that are so
    far apart that something turns far from one to the next.
    """

    real: NDArray[np.float64]
    count: NDArray[np.int64]  # type: ignore[assignment]  # hides tuple.count, which nobody needs
    y: NDArray[np.float64]
    dense: NDArray[np.float64]
    multiplier: NDArray[np.float64]
    passages: NDArray[np.float64]
    events: NDArray[np.float64]
    watched: NDArray[np.float64]
    between: NDArray[np.float64]


PATTERN = ("ptr", "below", "target", "place", "row_place", "law_at", "row_at", "gradient_at", "base", "values", "space",
           "sum_at")  # fmt: skip
"""Fields of `Control` that hold the pattern of the matrix of an implicit method (kernels.steps.tangent)."""
_TURNING = {"pairs": (0, 2), "angle_ptr": (1,), "angle_kind": (0,), "angle_at": (0, 4), "angle_data": (0, 7)}
"""Shapes of those that say what turns, where nothing does."""


@record
class Control(Record):
    """What a method is told, in one record.

    real (16,) : numbers named above. stand (3 n,) : where prescribed coordinates stand, m. free (nf,) : flat coordinates of a
    state. length (nf,) : m, what errors in position are measured in. breaks (3, k + 1) : start, times at which something
    jumps, end of the run, s; first and last time of the interval behind each at which equations are evaluated. events (e, 13) :
    kind, flat coordinates or row a, b, value, direction (1 rising, -1 falling, 0 both), 1 to stop, 1 where it is no polynomial
    in a step, places in a state of the coordinates of both ends. pairs (k, 2) : flat coordinates of the ends of what turns;
    angles angle_ptr[j]:angle_ptr[j + 1] of terms (see _terms) that do.
    """

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
    real: F1
    stand: F1
    length: F1
    breaks: F2
    events: F2
    edge_at: I2
    pairs: I2
    angle_ptr: I1
    angle_kind: I1
    angle_at: I2
    angle_data: F2

    @classmethod
    def told(cls, pattern: Mapping[str, NDArray[Any]], told: Mapping[str, NDArray[Any]]) -> Control:
        """The record of named arrays; an explicit method has an empty pattern."""
        empty = {name: np.zeros((0, 0)[: cls.FIELDS[name].axes]) for name in (*PATTERN, "edge_at")}
        return cls.of({**empty, **{name: np.zeros(shape) for name, shape in _TURNING.items()}, **pattern, **told})


class Samples(NamedTuple):
    """Room for output. times (s,); x, v, a (s, 3 n); N (s, rows); z (s, extra); diagnostics (s, 6)."""

    times: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    N: NDArray[np.float64]
    z: NDArray[np.float64]
    diagnostics: NDArray[np.float64]


@record
class Room(Record):
    """Scratch of a call, in two buffers; nothing in it lasts.

    AT (24,), NUM (48,) : places of the machine, named above. STAGES (16, ny); STATES (5, ny); X, V, A (3 n,), PULLS (rows,),
    EXTRA : question and answer. For events, D the highest degree: POLYNOMIALS (5, D + 1), STACK (., D + 3), PIECE_ROOTS and
    ROOTS (., 3), SPANS (., 2).
    """

    at: I1
    num: F1
    stages: F2
    states: F2
    x: F1
    v: F1
    a: F1
    pulls: F1
    extra: F1
    polynomials: F2
    stack: F2
    piece_roots: F2
    roots: F2
    spans: F2


def new_memory(
    free: int, extra: int, rows: int, events: int, passages_kept: int = 4096, events_kept: int = 4096, orders: int = 8
) -> Memory:  # fmt: skip
    """Empty memory for `free` coordinates, `extra` states, `rows` multipliers, events, and `orders` rows of an interpolant."""
    size = 2 * free + extra
    return Memory(
        real=np.zeros(REALS),
        count=np.zeros(COUNTS, np.int64),
        y=np.zeros((4, size)),
        dense=np.zeros((orders, size)),
        multiplier=np.zeros(rows),
        passages=np.zeros((passages_kept, 3)),
        events=np.zeros((events_kept, 4)),
        watched=np.zeros(events),
        between=np.zeros((max(8, min(512, _KEPT // (1 + size))), 1 + size)),
    )
