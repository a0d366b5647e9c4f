"""Positions, velocities and accelerations along a motion: one forward sweep over the blocks a sample.

Positions by Newton's method, started where the path leads on from the two samples before and first tried with the factors of
the last one (chord steps); velocities and accelerations with the factors at the solution. Where a step fails, the way between
the two samples is walked in smaller steps (step-limited continuation), so no other branch is reached in silence.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.structure.mass import between, dot
from kinetruss.kernels.structure.rows import row_rate, row_second
from kinetruss.kernels.structure.structure import ALONE, ANGLE, LENGTH, RIGID_SHAPE, Plan, States
from kinetruss.kernels.structure.sums import sum_first, sum_known, sum_second
from kinetruss.kernels.sweep.blocks import (
    Workspace,
    factor,
    known,
    newton_block,
    newton_step,
    residuals,
    set_targets,
    solve,
    solve_transposed,
    workspace,
)

__all__ = [
    "DONE",
    "FLIPPED",
    "STUCK",
    "WEAK",
    "Prescribed",
    "Start",
    "chord",
    "closed_block",
    "continuation",
    "faces",
    "follow",
    "righted",
]

DONE, STUCK, FLIPPED, WEAK = 0, 1, 2, 3


class Start(NamedTuple):
    """A configuration x (3 n,), m, and the values of drives (d,) and of moving coordinates (k,) that it satisfies."""

    x: np.ndarray
    drives: np.ndarray
    moving: np.ndarray


class Prescribed(NamedTuple):
    """Histories of drives and moving coordinates: instants t (times,), s; values, rates and accelerations, (times, d or k)."""

    t: np.ndarray
    drives: tuple[np.ndarray, ...]
    moving: tuple[np.ndarray, ...]


@kernel_inline
def _copy(source: F2, i: int, target: F2, k: int) -> None:
    """Row i of source into row k of target; Numba compiles much more for target[k] = source[i]."""
    for c in range(source.shape[1]):
        target[k, c] = source[i, c]


@kernel_inline
def faces(plan: Plan, w: Workspace, x: F2, i: int) -> bool:
    """Every angle row points where its angle says, not the opposite way (n . d = 0 holds for both)."""
    # c . d > 0 with c = (cos, sin) of the angle
    for e in range(plan.driven.size):
        k = plan.driven[e]
        if plan.kind[k] == ANGLE:
            a, b, angle = plan.A[k], plan.B[k], w.target[k]
            if math.cos(angle) * (x[i, b] - x[i, a]) + math.sin(angle) * (x[i, b + 1] - x[i, a + 1]) <= 0.0:
                return False
    return True


@kernel
def _first_step(plan: Plan, ends: F2) -> float:
    """Share of the way that turns no angle by more than half a radian."""
    turn = 0.5
    # largest change of a driven angle
    for e in range(plan.driven.size):
        k = plan.driven[e]
        if plan.kind[k] != LENGTH:
            turn = max(turn, abs(ends[1, plan.drive[k]] - ends[0, plan.drive[k]]))
    return 0.5 / turn


@kernel
def righted(plan: Plan, b: int, was: F2, k: int, x: F2, i: int) -> bool:
    """True if a rigid part of block b was mirrored from was[k] to x[i]; its node is then put where the part has it.

    Newton's method may find the other intersection of the circles about two nodes of a slim part, or of spheres about three.
    """
    mirrored = False
    for h in range(plan.hand_ptr[b], plan.hand_ptr[b + 1]):
        A, B, C, D = plan.hand[h, 0], plan.hand[h, 1], plan.hand[h, 2], plan.hand[h, 3]
        planar = D < 0
        p = C if planar else D
        u, r = between(was[k], A, B), between(was[k], A, p)
        U, R = between(x[i], A, B), between(x[i], A, p)
        # the second direction in the plane of the base: across u, or v to the third node of the base
        v, V = (0.0, 0.0, 1.0), (0.0, 0.0, 1.0)
        if not planar:
            v, V = between(was[k], A, C), between(x[i], A, C)
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        N = (U[1] * V[2] - U[2] * V[1], U[2] * V[0] - U[0] * V[2], U[0] * V[1] - U[1] * V[0])
        high = dot(r, n) / dot(n, n)
        if not high * dot(R, N) < 0.0:
            continue
        mirrored = True
        # r = s u + e v + high n, the same with U, V, N
        uu, uv, vv, ru, rv = dot(u, u), dot(u, v), dot(v, v), dot(r, u), dot(r, v)
        s, e = (ru * vv - rv * uv) / (uu * vv - uv * uv), (rv * uu - ru * uv) / (uu * vv - uv * uv)
        for axis in range(3):
            x[i, p + axis] = x[i, A + axis] + s * U[axis] + e * V[axis] + high * N[axis]
    return mirrored


@kernel_inline
def closed_block(plan: Plan, w: Workspace, b: int, was: F2, k: int, x: F2, i: int, scale: float) -> bool:
    """Close block b of x[i] by Newton's method, its rigid parts as they are in was[k]."""
    for _ in range(4):
        if not newton_block(plan, w, b, x, i, 0.2 * scale):
            return False
        if not righted(plan, b, was, k, x, i):
            return True
    return False


@kernel_inline
def _reached(plan: Plan, w: Workspace, trial: F2, x: F2, i: int, scale: float, sign: F1) -> bool:
    """Close all blocks from trial[0]; True if that came near x[i] and on its branch: signs of determinants as in `sign`."""
    # positions block by block
    for b in range(plan.ptr.size - 1):
        if not closed_block(plan, w, b, x, i, trial, 0, scale):
            return False
        if sign[b] != 0.0 and factor(plan, w, b, trial, 0) * sign[b] <= 0.0:
            return False
    good = faces(plan, w, trial, 0)
    # no coordinate has jumped
    for c in range(x.shape[1]):
        good = good and abs(trial[0, c] - x[i, c]) < 0.5 * scale
    return good


@kernel_inline
def _straight_on(rate: F1, trial: F2, x: F2, i: int, share: float, noise: float) -> bool:
    """From x[i] to trial[0], this share of the way, each node has its rate of the step before, within a fifth or `noise`, m.

    Where branches cross, one of the others may have the same signs of determinants, but none has the same direction.
    """
    fastest = 0.0
    # square of the largest rate of a node
    for c in range(0, rate.size, 3):
        fastest = max(fastest, rate[c] ** 2 + rate[c + 1] ** 2 + rate[c + 2] ** 2)
    # change of the rates; nodes that hardly move may turn
    for c in range(0, rate.size, 3):
        change, new = 0.0, 0.0
        for axis in range(3):
            now = (trial[0, c + axis] - x[i, c + axis]) / share
            change, new = change + (now - rate[c + axis]) ** 2, new + now * now
        if change > 0.04 * max(new, rate[c] ** 2 + rate[c + 1] ** 2 + rate[c + 2] ** 2, 1e-4 * fastest) + (noise / share) ** 2:
            return False
    return True


@kernel
def continuation(
    plan: Plan, x: F2, i: int, ends: F2, from_moving: F1, to_moving: F1, scale: float, sign: F1, straight: bool
) -> float:
    """Walk row i of x from drive values ends[0] to ends[1] in steps that adapt.

    sign (blocks,) : of the determinants of the blocks, which no step may change; 0 for any. straight : no node may change its
    direction suddenly either, as it does where another branch crosses.
    Returns the fraction of the way reached: 1 when done; x[i] is then the solution, else the last good state.
    """
    w = workspace(plan)
    trial, now = np.empty((1, x.shape[1])), np.empty((1, ends.shape[1]))
    _copy(x, i, trial, 0)
    largest = _first_step(plan, ends)
    # the first step only tells the direction
    done, step, rate, begun = 0.0, 1e-4 * largest if straight else largest, np.zeros(x.shape[1]), False
    # continuation: step doubled after a success, halved after a failure
    while done < 1.0:
        reach = min(1.0, done + step)
        for d in range(ends.shape[1]):
            now[0, d] = ends[0, d] + reach * (ends[1, d] - ends[0, d]) if reach < 1.0 else ends[1, d]
        set_targets(plan, w, now, 0)
        for k in range(plan.moving.size):
            trial[0, plan.moving[k]] = from_moving[k] + reach * (to_moving[k] - from_moving[k])
        reached = _reached(plan, w, trial, x, i, scale, sign)
        if reached and (not begun or _straight_on(rate, trial, x, i, reach - done, 1e-9 * scale)):
            for c in range(x.shape[1]):
                rate[c] = (trial[0, c] - x[i, c]) / (reach - done)
            done, begun = reach, straight
            _copy(trial, 0, x, i)
            step = min(2.0 * step, largest)
        else:
            _copy(x, i, trial, 0)
            step *= 0.5
            if step < (1e-7 if reached else 1e-6):
                return done
    return 1.0


@kernel_inline
def chord(plan: Plan, w: Workspace, b: int, x: F2, i: int, scale: float) -> bool:
    """Newton steps on a block with the factors at hand; True when they converge to round-off."""
    before = 0.05 * scale
    # simplified Newton's method (fixed Jacobian)
    for _ in range(5):
        residuals(plan, w, b, x, i)
        solve(plan, w, b, w.work)
        step = newton_step(plan, w, b, x, i)
        # the factors are one sample old: what is left is this step times their relative change
        if step < 1e-11 * scale:
            return True
        if not step < 0.3 * before:
            return False
        before = step
    return False


@kernel_inline
def _solved(plan: Plan, w: Workspace, b: int, y: F2, i: int) -> None:
    """Coordinates of block b in y[i] from the right-hand sides in w.work, less what the others contribute."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    # unknowns of the block count as zero
    for k in range(first, last):
        y[i, plan.col[k]] = 0.0
    # right-hand side less J y of the known coordinates
    for k in range(first, last):
        w.work[k - first] -= known(plan, w, k, y, i)
    if plan.sum_ptr[b] < plan.sum_ptr[b + 1]:
        sum_known(plan, b, first, y[i], w.terms, w.work)
    solve(plan, w, b, w.work)
    # solution back to its coordinates
    for k in range(first, last):
        y[i, plan.col[k]] = w.work[k - first]


@kernel_inline
def _velocity(plan: Plan, w: Workspace, b: int, states: States, i: int, given: Prescribed) -> None:
    """J v = L' (an angle: angular rate times length) for one block."""
    first, x, rates = plan.ptr[b], states.x, given.drives[1]
    # right-hand sides of J v
    for k in range(first, plan.ptr[b + 1]):
        d = plan.drive[k]
        rate = rates[i, d] if d >= 0 else 0.0
        w.work[k - first] = row_rate(plan.kind[k], w.gradient[k], between(x[i], plan.A[k], plan.B[k]), rate)
    sum_first(plan, b, first, w.work)
    _solved(plan, w, b, states.v, i)


@kernel_inline
def _acceleration(plan: Plan, w: Workspace, b: int, states: States, i: int, given: Prescribed) -> None:
    """J a = L'' + (L'^2 - |v_B - v_A|^2)/L (an angle: its own terms) for one block."""
    first, x, v, rates, seconds = plan.ptr[b], states.x, states.v, given.drives[1], given.drives[2]
    # right-hand sides of J a
    for k in range(first, plan.ptr[b + 1]):
        m, p, q = plan.drive[k], plan.A[k], plan.B[k]
        rate, second = 0.0, 0.0
        if m >= 0:
            rate, second = rates[i, m], seconds[i, m]
        d, e = between(x[i], p, q), between(v[i], p, q)
        w.work[k - first] = row_second(plan.kind[k], w.gradient[k], d, e, rate, second, w.inverse[k])
    if plan.sum_ptr[b] < plan.sum_ptr[b + 1]:
        sum_second(plan, b, first, x[i], v[i], seconds[i], w.work, w.scratch)
    _solved(plan, w, b, states.a, i)


@kernel_inline
def _gauge(plan: Plan, w: Workspace, b: int, weak: F1, turns: int) -> float:
    """Singularity measure of a block, 1/|P A^-1 E|, by iteration with A^-T and A^-1 in turn; `weak` keeps the vector.

    The columns of E are rates of length: of each row that counts alone, and of the sizes of rigid parts. P leaves out nodes
    that only their own part depends on. Without rigid parts it is the smallest singular value of A. From above: exact but for
    the share of other directions left in the vector, which two turns a sample keep small. 1 where nothing counts.
    """
    first, last = plan.ptr[b], plan.ptr[b + 1]
    size = 1.0
    # start with the vector of the sample before
    for k in range(first, last):
        w.work[k - first] = weak[k]
    # iteration on P A^-1 E E^T A^-T P: the norm of the solution is 1/measure
    for turn in range(turns):
        if turn % 2 == 0:
            solve_transposed(plan, w, b, w.work)
            total = _sized(plan, w, b)
        else:
            solve(plan, w, b, w.work)
            total = 0.0
            for k in range(last - first):
                w.work[k] *= plan.seen[first + k]
                total += w.work[k] * w.work[k]
        if total == 0.0:
            return 1.0
        size = 1.0 / math.sqrt(total)
        for k in range(last - first):
            w.work[k] *= size
    # keep it for the next sample
    for k in range(first, last):
        weak[k] = w.work[k - first]
    return size


@kernel_inline
def _sized(plan: Plan, w: Workspace, b: int) -> float:
    """E E^T z of block b in place of z in w.work; returns |E^T z|^2."""
    first, total = plan.ptr[b], 0.0
    for k in range(first, plan.ptr[b + 1]):
        if plan.counts[k] == ALONE:
            total += w.work[k - first] * w.work[k - first]
        elif plan.counts[k] == RIGID_SHAPE:
            w.work[k - first] = 0.0
    # a part that grows in all directions: its bars in proportion to their lengths, the longest by 1
    for g in range(plan.sized_ptr[b], plan.sized_ptr[b + 1]):
        longest, along = 0.0, 0.0
        for j in range(plan.size_ptr[g], plan.size_ptr[g + 1]):
            k = plan.size_row[j, 0]
            along += w.target[k] * w.work[k - first]
            if plan.size_row[j, 1] == 1:
                longest = max(longest, w.target[k])
        along /= longest
        total += along * along
        for j in range(plan.size_ptr[g], plan.size_ptr[g + 1]):
            k = plan.size_row[j, 0]
            w.work[k - first] = w.target[k] / longest * along
    return total


@kernel_inline
def _predict(states: States, i: int, t: F1) -> None:
    """The polynomial of degree 5 through samples i - 1 and i - 2 with their velocities and accelerations, at sample i.

    With s = (time - t_(i-1))/h and D, E, F the differences at s = -1 of value, slope and curvature from the parabola at s = 0
    (Hermite's interpolation): c5 = -(F/2 + 3 E + 6 D), c4 = -(F + 7 E + 15 D), c3 = -(F/2 + 4 E + 10 D).
    """
    x, v, a = states.x, states.v, states.a
    if i == 1:
        h = t[1] - t[0]
        # second sample: Taylor's formula to the acceleration
        for c in range(x.shape[1]):
            x[1, c] = x[0, c] + h * (v[0, c] + 0.5 * h * a[0, c])
        return
    h = t[i - 1] - t[i - 2]
    s = (t[i] - t[i - 1]) / h
    # Hermite's polynomial of degree 5, extrapolated
    for c in range(x.shape[1]):
        slope, second = h * v[i - 1, c], h * h * a[i - 1, c]
        D = x[i - 2, c] - x[i - 1, c] + slope - 0.5 * second
        E = h * v[i - 2, c] - slope + second
        F = h * h * a[i - 2, c] - second
        third, fourth, fifth = 0.5 * F + 4.0 * E + 10.0 * D, F + 7.0 * E + 15.0 * D, 0.5 * F + 3.0 * E + 6.0 * D
        x[i, c] = x[i - 1, c] + s * (slope + s * (0.5 * second - s * (third + s * (fourth + s * fifth))))


@kernel
def _walk(plan: Plan, x: F2, i: int, start: Start, given: Prescribed, scale: float, sign: F1, straight: bool) -> float:
    """Sample i by continuation from sample i - 1 (signs of determinants as there), or from the start; the fraction reached."""
    values, moving = given.drives[0], given.moving[0]
    ends = np.empty((2, values.shape[1]))
    _copy(values, i, ends, 1)
    if i == 0:
        # from the start configuration:
        for c in range(start.x.size):
            x[0, c] = start.x[c]
        # its drive positions to those of the first sample
        for d in range(start.drives.size):
            ends[0, d] = start.drives[d]
        return continuation(plan, x, 0, ends, start.moving, moving[0], scale, sign, straight)
    _copy(x, i - 1, x, i)
    _copy(values, i - 1, ends, 0)
    return continuation(plan, x, i, ends, moving[i - 1], moving[i], scale, sign, straight)


@kernel_inline
def _chased(plan: Plan, w: Workspace, states: States, i: int, given: Prescribed, scale: float) -> bool:
    """Sample i from where the path leads on, with the factors of sample i - 1; True if that converged."""
    x, moving = states.x, given.moving[0]
    _predict(states, i, given.t)
    # prescribed coordinates at this sample
    for k in range(plan.moving.size):
        x[i, plan.moving[k]] = moving[i, k]
    # positions block by block with the factors at hand
    for b in range(plan.ptr.size - 1):
        if not chord(plan, w, b, x, i, scale) or righted(plan, b, x, i - 1, x, i):
            return False
    return faces(plan, w, x, i)


@kernel
def follow(
    plan: Plan, start: Start, given: Prescribed, scale: float, least: float, states: States, gauge: F1
) -> tuple[int, int, float]:
    """Fill states (times, 3 n) and gauge (times,) for the histories `given` of drives and moving coordinates.

    start : a Start. given : Prescribed. scale : shortest bar, m.
    least : stop where the singularity measure of a block falls below it.
    Returns (reason, number of good samples, fraction of the way to the next sample reached).
    """
    w, x, v, a = workspace(plan), states.x, states.v, states.a
    weak, sign, any_sign = np.ones(plan.row.size + 1), np.zeros(plan.ptr.size), np.zeros(plan.ptr.size)
    # position, velocity and acceleration sample by sample
    for i in range(given.t.size):
        set_targets(plan, w, given.drives[0], i)
        chased = i > 0 and _chased(plan, w, states, i, given, scale)
        if not chased:
            # beside a singular position nodes turn quickly on their own branch too
            straight = i > 0 and gauge[i - 1] > 1e-2
            reached = _walk(plan, x, i, start, given, scale, sign if i > 0 else any_sign, straight)
            if reached < 1.0:
                return STUCK, i, reached
        for c in range(x.shape[1]):
            v[i, c] = a[i, c] = 0.0
        for k in range(plan.moving.size):
            v[i, plan.moving[k]] = given.moving[1][i, k]
            a[i, plan.moving[k]] = given.moving[2][i, k]
        smallest = 1.0
        b = 0
        while b < plan.ptr.size - 1:
            now = factor(plan, w, b, x, i)
            if i > 0 and now != sign[b]:
                if not chased:
                    return FLIPPED, i, 1.0
                # another branch, or a singular position in between: smaller steps tell
                chased = False
                reached = _walk(plan, x, i, start, given, scale, sign, True)
                if reached < 1.0:
                    return STUCK, i, reached
                b, smallest = 0, 1.0
                continue
            sign[b] = now
            smallest = min(smallest, _gauge(plan, w, b, weak, 2 if i > 0 else 100))
            _velocity(plan, w, b, states, i, given)
            _acceleration(plan, w, b, states, i, given)
            b += 1
        gauge[i] = smallest
        if not smallest >= least:
            return WEAK, i, 0.0
    return DONE, given.t.size, 1.0
