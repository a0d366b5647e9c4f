"""Passing singular positions: where no step should set foot, and where exactly they were.

In a singular position rows of the Jacobian become dependent; motion through it is smooth, but accelerations next to it are
differences of small numbers. Stages are kept away from it, on both sides; the error estimate then vouches for the branch.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.dop853 import C
from kinetruss.kernels.integrate.samples import ask_at
from kinetruss.kernels.integrate.state import Control, Memory, Work

__all__ = ["begin_passage", "crossed", "passage_left", "passage_middle", "passage_right", "passage_vertex", "size_avoiding"]

SINGULAR = 1e-3
"""Scaled pivot, in parts of the largest one met, of a position that counts as singular."""
ORDER = np.array([0, 1, 2, 3, 6, 4, 7, 5, 9, 8, 10, 12])
"""Stages by their place in the step."""
NEAR = 1e-6
"""Correction of the step's end, in lengths of members, below which the interpolant tells pivots without being projected."""
TURNS = 3
"""Parabolas laid through the square of the pivot."""


@kernel_bare
def size_avoiding(d: float, most: float) -> float:
    """Step size (s) that keeps all stages away from an instant d (s) ahead; most : largest size, s.

    The instant is put into the middle of a gap between the nodes 0.118, 0.25 | 0.333, 0.6 | 0.651, 0.857; one very near the
    start into the first gap; one near the end is left to the next step, which will have it in its widest gap.
    """
    if d <= 0.0263 * most:
        return d / 0.0263
    if d <= 0.1834 * most:
        return d / 0.1834
    if d <= 0.4666 * most:
        return d / 0.4666
    if d <= 0.7542 * most:
        return d / 0.7542
    return d - 0.44 * most


@kernel_bare
def crossed(pivots: F1, most: float) -> float:
    """Fraction of the step at which the pivot touches zero, by its sizes at the nodes of the stages; -1 where it does not.

    It is the size of a number that changes its sign: between two neighbours the sum, not the difference, fits the slope that
    is seen beside them. Only steep ones are believed; the place itself is then sought.
    """
    found, smallest = -1.0, 0.4 * most
    # the pivot as |p(c)| between neighbouring stages: a zero crossing where the slope fits the sum of both
    for k in range(11):
        left, right, width = pivots[ORDER[k]], pivots[ORDER[k + 1]], C[ORDER[k + 1]] - C[ORDER[k]]
        slope = 0.0
        if k > 0:
            slope = abs(left - pivots[ORDER[k - 1]]) / (C[ORDER[k]] - C[ORDER[k - 1]])
        if k < 10:
            slope = max(slope, abs(right - pivots[ORDER[k + 2]]) / (C[ORDER[k + 2]] - C[ORDER[k + 1]]))
        if left + right < smallest and abs(left + right - slope * width) < abs(abs(left - right) - slope * width):
            smallest = left + right
            found = C[ORDER[k]] + width * left / max(left + right, 1e-300)
    return found


@kernel_bare
def _ask(control: Control, memory: Memory, work: Work, t: float, phase: int) -> int:
    ask_at(control, memory, min(max(t, memory.t_old), memory.t), work)
    work.phase = phase
    near = work.explicit != 0 and memory.constraint < NEAR * control.size
    return m.PIVOT_ONLY if near else m.PROJECT | m.PIVOT_ONLY


@kernel_late
def begin_passage(control: Control, memory: Memory, work: Work) -> int:
    """Look for the time of the smallest scaled pivot in the last step, near `Work.near_t`.

    The pivot falls and rises in proportion to the distance: its square is a parabola, whose vertex is found from three points.
    """
    work.width = 0.1 * memory.h_old
    work.turn = 0
    low, high = memory.t_old + work.width, memory.t - work.width
    return _ask(control, memory, work, min(max(work.near_t, low), high), m.PASSAGE_MIDDLE)


@kernel_late
def passage_middle(control: Control, memory: Memory, work: Work) -> int:
    """The first of three points."""
    work.best, work.best_f = work.ask_t, work.new_pivot**2
    return _ask(control, memory, work, work.best - work.width, m.PASSAGE_LEFT)


@kernel_late
def passage_left(control: Control, memory: Memory, work: Work) -> int:
    """The second of three points."""
    work.left_f = work.new_pivot**2
    return _ask(control, memory, work, work.best + work.width, m.PASSAGE_RIGHT)


@kernel_late
def passage_right(control: Control, memory: Memory, work: Work) -> int:
    """The third of three points: on to the vertex."""
    left, right = work.left_f, work.new_pivot**2
    second = left - 2.0 * work.best_f + right
    if not second > 0.0:
        return _keep(memory, work)
    return _ask(control, memory, work, work.best + 0.5 * work.width * (left - right) / second, m.PASSAGE_VERTEX)


@kernel_late
def passage_vertex(control: Control, memory: Memory, work: Work) -> int:
    """A better time; three nearer points around it, or the end of the search."""
    square = work.new_pivot**2
    if square < work.best_f:
        work.best, work.best_f = work.ask_t, square
    work.width *= 0.1
    work.turn += 1
    inside = work.best - work.width > memory.t_old and work.best + work.width < memory.t
    if work.turn == TURNS or not inside or work.best_f < 1e-10:
        return _keep(memory, work)
    return _ask(control, memory, work, work.best - work.width, m.PASSAGE_LEFT)


@kernel_bare
def _keep(memory: Memory, work: Work) -> int:
    """Enter the passage; its branch is certain where all stages kept their distance."""
    k = memory.passages_met
    work.phase = m.SCAN
    if work.best_f > (SINGULAR * memory.pivot_most) ** 2:
        return 0
    if k < memory.passages.shape[0]:
        row = memory.passages[k]
        row[0], row[1], row[2] = work.best, work.best_f**0.5, 1.0 if work.near < m.TRIES else 0.0
    memory.passages_met = k + 1
    return 0
