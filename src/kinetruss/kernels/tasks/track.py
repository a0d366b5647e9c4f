"""Drives along a path of tasks, sample by sample from where the path leads on, with exact rates; bounds by an active set."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, Floats
from kinetruss.kernels.coordinates.tape import Tape
from kinetruss.kernels.structure.structure import Plan
from kinetruss.kernels.sweep.blocks import Workspace, workspace
from kinetruss.kernels.tasks.kkt import corrected, matrix, rates
from kinetruss.kernels.tasks.sweeps import Drives, TaskWork, gradient, let_go

__all__ = ["DONE", "FAST", "STUCK", "Given", "Tracked", "track"]

DONE, STUCK, FAST = 0, 1, 2
"""How a path ended: at its end; where the next sample cannot be reached; where rates are not bounded."""
AGE = 12
"""Samples for which K serves at least."""


class Given(NamedTuple):
    """Instants t (times,), s; Taylor coefficients (3, times, ...) of parameters, of the reference of drives, of supports.

    scale : shortest bar, m.
    """

    t: np.ndarray
    parameters: np.ndarray
    reference: np.ndarray
    moving: np.ndarray
    scale: float


class Tracked(NamedTuple):
    """Taylor coefficients x (3, times, 3 n) of nodes and z (3, times, d + m) of drives and factors; held (times, d)."""

    x: np.ndarray
    z: np.ndarray
    held: np.ndarray


@kernel_inline
def _load(o: TaskWork, given: Given, i: int, share: float) -> None:
    """Parameters, reference and supports of sample i, or at a share of the way to it from sample i - 1."""
    y = o
    for k in range(3):
        before = i > 0 and k == 0
        for c in range(given.parameters.shape[2]):
            b = given.parameters[k, i, c]
            y.p[k, c] = b if not before or share == 1.0 else b + (share - 1.0) * (b - given.parameters[k, i - 1, c])
        for c in range(given.reference.shape[2]):
            b = given.reference[k, i, c]
            o.ref[k, c] = b if not before or share == 1.0 else b + (share - 1.0) * (b - given.reference[k, i - 1, c])
        for c in range(given.moving.shape[2]):
            b = given.moving[k, i, c]
            y.moving[k, c] = b if not before or share == 1.0 else b + (share - 1.0) * (b - given.moving[k, i - 1, c])


@kernel_inline
def _ahead(t: F1, z: Floats, i: int, c: int, k: int) -> float:
    """Coefficient k < 2 at sample i of a polynomial of degree 5 through samples i - 2 and i - 1 and two rates (z: Taylor)."""
    h, a, b = t[i - 1] - t[i - 2], i - 2, i - 1
    s = (t[i] - t[i - 1]) / h
    slope, second = h * z[1, b, c], 2.0 * h * h * z[2, b, c]
    D = z[0, a, c] - z[0, b, c] + slope - 0.5 * second
    E = h * z[1, a, c] - slope + second
    F = 2.0 * h * h * z[2, a, c] - second
    third, fourth, fifth = -(0.5 * F + 4.0 * E + 10.0 * D), -(F + 7.0 * E + 15.0 * D), -(0.5 * F + 3.0 * E + 6.0 * D)
    if k == 0:
        return z[0, b, c] + s * (slope + s * (0.5 * second + s * (third + s * (fourth + s * fifth))))
    return (slope + s * (second + s * (3.0 * third + s * (4.0 * fourth + 5.0 * s * fifth)))) / h


@kernel_inline
def _second_ahead(t: F1, z: Floats, i: int, c: int, rate: float) -> float:
    """Second coefficient at sample i by the polynomial of degree 4 of the rate: two samples with their slopes, and `rate`.

    Positions would add their round-off over the square of the step. The term that `rate` adds grows like s^2 (s + 1)^2.
    """
    h, a, b = t[i - 1] - t[i - 2], i - 2, i - 1
    s = (t[i] - t[i - 1]) / h
    slope = 2.0 * h * z[2, b, c]
    D, E = z[1, a, c] - z[1, b, c] + slope, 2.0 * h * z[2, a, c] - slope
    second, third = E + 3.0 * D, E + 2.0 * D
    miss = rate - (z[1, b, c] + s * (slope + s * (second + s * third)))
    change = slope + s * (2.0 * second + 3.0 * s * third) + 2.0 * (2.0 * s + 1.0) / (s * (s + 1.0)) * miss
    return 0.5 * change / h


@kernel_inline
def _guess(given: Given, o: TaskWork, out: Tracked, i: int, n: int, m: int) -> None:
    """Where the path leads on: positions, drives and factors at sample i."""
    y, t = o, given.t
    for c in range(out.x.shape[2]):
        y.x[0, c] = _ahead(t, out.x, i, c, 0)
    for c in range(n):
        y.q[0, c] = _ahead(t, out.z, i, c, 0)
    for c in range(m):
        y.s[0, c] = _ahead(t, out.z, i, n + c, 0)


@kernel_inline
def _guess_rate(given: Given, o: TaskWork, out: Tracked, i: int, k: int, n: int, m: int) -> None:
    """Coefficient k of drives and factors at sample i: first rates from where the path leads on, second ones with the first.

    The polynomial misses like s^3 (s + 1)^3, with s the distance from sample i - 1 in steps before it.
    """
    y, t = o, given.t
    for c in range(n + m):
        guess = 0.0
        if i > 1 and k == 1:
            h = t[i - 1] - t[i - 2]
            s = (t[i] - t[i - 1]) / h
            value = y.q[0, c] if c < n else y.s[0, c - n]
            miss = value - _ahead(t, out.z, i, c, 0)
            guess = _ahead(t, out.z, i, c, 1) + 3.0 * (2.0 * s + 1.0) / (s * (s + 1.0) * h) * miss
        elif i > 1:
            guess = _second_ahead(t, out.z, i, c, y.q[1, c] if c < n else y.s[1, c - n])
        elif i == 1:
            guess = out.z[k, 0, c]
        if c < n:
            y.q[k, c] = guess
        else:
            y.s[k, c - n] = guess


@kernel_inline
def _stand(drives: Drives, o: TaskWork) -> None:
    """Held drives stand still, those at a bound on it."""
    y = o
    for d in range(drives.row.size):
        if drives.held[d] == 1:
            y.q[0, d] = drives.lower[d]
        elif drives.held[d] == 2:
            y.q[0, d] = drives.upper[d]
        if drives.held[d] > 0:
            y.q[1, d] = y.q[2, d] = 0.0


@kernel
def _back_to(o: TaskWork, out: Tracked, i: int, n: int, m: int) -> None:
    """The state of sample i."""
    for c in range(out.x.shape[2]):
        o.x[0, c] = out.x[0, i, c]
    for c in range(n):
        o.q[0, c] = out.z[0, i, c]
    for c in range(m):
        o.s[0, c] = out.z[0, i, n + c]


@kernel
def _walked(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, given: Given, out: Tracked, i: int) -> bool:
    """Sample i from sample i - 1 in steps that adapt."""
    y, n, m = o, drives.row.size, tape.tasks
    coordinates = y.x.shape[1]
    done, step = 0.0, 1.0
    _back_to(o, out, i - 1, n, m)
    while done < 1.0:
        for c in range(coordinates):
            o.kept[1, c] = y.x[0, c]
        for c in range(n + m):
            o.kept[2, c] = y.q[0, c] if c < n else y.s[0, c - n]
        reach = min(1.0, done + step)
        _load(o, given, i, reach)
        _stand(drives, o)
        if corrected(plan, w, drives, tape, o, given.scale, True):
            done, step = reach, 2.0 * step
            continue
        for c in range(coordinates):
            y.x[0, c] = o.kept[1, c]
        for c in range(n + m):
            if c < n:
                y.q[0, c] = o.kept[2, c]
            else:
                y.s[0, c - n] = o.kept[2, c]
        step *= 0.5
        if step < 1e-4:
            return False
    return True


@kernel
def _change(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, scale: float) -> bool:
    """Hold the drive that is farthest beyond a bound, or let one go that would leave its own; True if there was one."""
    y, worst, at, how = o, 1e-9 * scale, -1, 0
    for d in range(drives.row.size):
        if drives.held[d] == 0:
            low, high = drives.lower[d] - y.q[0, d], y.q[0, d] - drives.upper[d]
            if max(low, high) > worst:
                worst, at, how = max(low, high), d, 1 if low > high else 2
    if at >= 0:
        drives.held[at] = how
        return True
    for d in range(drives.row.size):
        if drives.held[d] == 1 or drives.held[d] == 2:
            at = d
    if at < 0:
        return False
    gradient(plan, w, tape, o, 0, 0, drives, 0)
    return let_go(drives, o, scale)


@kernel
def _moved(plan: Plan, w: Workspace, drives: Drives, tape: Tape, o: TaskWork, given: Given, out: Tracked, i: int) -> int:
    """Rates of sample i; how often their equations were repeated, 0 where they do not converge."""
    n, m, y, repeated = drives.row.size, tape.tasks, o, 0
    for attempt in range(2):
        if attempt == 1:
            matrix(plan, w, drives, tape, o, True)
        _load(o, given, i, 1.0)
        for k in range(1, 3):
            if k == 1 or repeated > 0:
                _guess_rate(given, o, out, i, k, n, m)
                _stand(drives, o)
                repeated = rates(plan, w, drives, tape, o, k, given.scale)
        if repeated > 0:
            break
    if repeated == 0:
        return 0
    for k in range(3):
        for c in range(y.x.shape[1]):
            out.x[k, i, c] = y.x[k, c]
        for c in range(n + m):
            out.z[k, i, c] = y.q[k, c] if c < n else y.s[k, c - n]
    for d in range(n):
        out.held[i, d] = drives.held[d]
    return repeated


@kernel
def track(plan: Plan, drives: Drives, tape: Tape, o: TaskWork, given: Given, out: Tracked) -> tuple[int, int]:
    """Fill out along a path from the state in o (x[0], q[0], s[0]), which meets the first sample.

    Returns how it ended, and the number of good samples. `drives.held` is kept up to date.
    """
    n, m, w, repeated, formed = drives.row.size, tape.tasks, workspace(plan), 0, 0
    for b in range(o.sign.size):
        o.sign[b] = 0.0
    for i in range(given.t.size):
        _load(o, given, i, 1.0)
        if i == 1:
            _back_to(o, out, 0, n, m)
        elif i > 1:
            _guess(given, o, out, i, n, m)
        _stand(drives, o)
        # K is formed anew where it has become slow
        fresh = i == 0 or (repeated > 2 and i > formed + AGE)
        formed = i if fresh else formed
        good = corrected(plan, w, drives, tape, o, given.scale, fresh)
        if not good and i > 0:
            good = _walked(plan, w, drives, tape, o, given, out, i)
        for _ in range(2 * n):
            if not good or not _change(plan, w, drives, tape, o, given.scale):
                break
            if i > 0:
                good = _walked(plan, w, drives, tape, o, given, out, i)
            else:
                _stand(drives, o)
                good = corrected(plan, w, drives, tape, o, given.scale, True)
        if not good:
            return STUCK, i
        repeated = _moved(plan, w, drives, tape, o, given, out, i)
        if repeated == 0:
            return FAST, i
    return DONE, given.t.size
