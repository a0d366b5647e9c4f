"""Passing singular positions: where no step should set foot, and where exactly they were.

In a singular position rows of the Jacobian become dependent; motion through it is smooth, but accelerations next to it are
differences of small numbers. Stages are kept away from it, on both sides; the error estimate then vouches for the branch.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import PIVOT, PROJECT, Run, find, rule_of_fixed_steps
from kinetruss.kernels.integrate.dop853 import C
from kinetruss.kernels.integrate.samples import put_at

__all__ = ["crossed", "enter_passage", "size_avoiding"]

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
def _pivot_at(run: Run, t: float) -> float:
    """The smallest scaled pivot at a time t (s) of the last step; the time itself is left in `ask_t`."""
    control, memory = run.control, run.memory
    put_at(run, min(max(t, memory.t_old), memory.t))
    near = not rule_of_fixed_steps(control) and memory.constraint < NEAR * control.size
    find(run, PIVOT if near else PROJECT | PIVOT, 0)
    return run.work.new_pivot


@kernel_bare
def enter_passage(run: Run) -> None:
    """Enter the time of the smallest scaled pivot in the last step, near `Work.near_t`, if it is small enough.

    The pivot falls and rises in proportion to the distance: its square is a parabola, whose vertex is found from three points.
    The branch is certain where all stages kept their distance.
    """
    memory, work = run.memory, run.work
    # what is kept in `work` is rounded there: a product that goes on in a sum would not be
    work.width = 0.1 * memory.h_old
    low, high = memory.t_old + work.width, memory.t - work.width
    work.best_f = _pivot_at(run, min(max(work.near_t, low), high)) ** 2
    work.best = work.ask_t
    for _ in range(TURNS):
        work.left_f = _pivot_at(run, work.best - work.width) ** 2
        left, right = work.left_f, _pivot_at(run, work.best + work.width) ** 2
        second = left - 2.0 * work.best_f + right
        if not second > 0.0:
            break
        square = _pivot_at(run, work.best + 0.5 * work.width * (left - right) / second) ** 2
        if square < work.best_f:
            work.best, work.best_f = work.ask_t, square
        work.width *= 0.1
        inside = work.best - work.width > memory.t_old and work.best + work.width < memory.t
        if not inside or work.best_f < 1e-10:
            break
    if work.best_f > (SINGULAR * memory.pivot_most) ** 2:
        return
    k = memory.passages_met
    if k < memory.passages.shape[0]:
        row = memory.passages[k]
        row[0], row[1], row[2] = work.best, work.best_f**0.5, 1.0 if work.near < m.TRIES else 0.0
    memory.passages_met = k + 1
