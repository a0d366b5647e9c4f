"""Positions along prescribed histories: the kernel's sweep, and the treatment of redundant constraints.

For a redundant structure the kernel uses independent constraints only. One set of them may become dependent during the
motion, or allow another branch, although all constraints together do neither. So the redundant constraints are checked,
and a new independent set is chosen if the present one becomes badly conditioned.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, few
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.lengths import distances
from kinetruss.kernels.structure.structure import LENGTH, States
from kinetruss.kernels.sweep import follow as kernel
from kinetruss.mechanics import RANK_TOLERANCE, System, jacobian, measured, rearrange
from kinetruss.mechanics.mobility import mobility_at
from kinetruss.mechanics.positions import shortest
from kinetruss.model.beam_frames import shared_rotations

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import Arrangement


LEAST = 1e-6
"""Smallest singular value of a block (unit rows) at which a path counts as singular."""

AGREE = 1e-8
"""Tolerance of redundant constraints: their residual as a fraction of the shortest length."""

INTERVAL = 64
"""Number of samples of a redundant structure between two checks of the redundant constraints."""

PARTED = -1
"""Return code: the redundant constraints cannot be satisfied at the next sample."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Path:
    """Prescribed histories on a common time axis: drives (times, drives) and moving coordinates (times, moving)."""

    t: NDArray[np.float64]
    drive: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
    moving: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]


def sweep_redundant(
    system: System,
    arrangement: Arrangement,
    path: Path,
    at: NDArray[np.float64],
    exact: bool,
    least: float,
    histories: tuple[NDArray[np.float64], ...],
    between: bool = True,
) -> tuple[int, int, float]:
    """Sweep with independent constraints as long as the redundant ones agree; then with another independent set.

    The intervals are short at first. Each is accepted up to the sample at which a redundant constraint is not satisfied, or
    the singularity measure falls to a tenth of its largest value. If no set reaches the next sample, it is approached in
    smaller steps. Returns what the kernel returns, or PARTED if redundant constraints cannot be satisfied. Raises
    `InputError` if drives contradict each other.
    """
    x, _, _, gauge = histories
    count, done, ahead, best, fresh = len(path.t), 0, INTERVAL, 0.0, True
    while True:
        stop = min(count, done + ahead)
        reason, good, reached = sweep(system, arrangement.plan, path, at, exact, slice(done, stop), least, histories)
        agreed = done + _agreeing(system, path, arrangement.redundant, slice(done, good), x)
        if agreed == 0 < good:
            raise _fight(system, path, arrangement.redundant, 0, x)
        best = float(max(best, *gauge[done:agreed])) if agreed > done else best
        weak = done + 1 + np.flatnonzero(gauge[done + 1 : agreed] < 0.1 * best)[:1]
        end = int(weak[0]) + 1 if len(weak) else agreed
        if end == count:
            return kernel.DONE, count, 1.0
        if end <= done + 1 and fresh:
            if done < agreed < good and contradicts(system, arrangement, path, done, x[done]):
                raise _fight(system, path, arrangement.redundant, done + 1, x)
            there, share = walked(system, path, x[done], done, least) if between and end == done + 1 else (x[done], 0.0)
            if share < 1:
                return (PARTED, end, 0.0) if agreed < good else (reason, good, reached)
            x[done + 1], end = there, done + 2
        if end < stop or end <= done + 1:
            arrangement = rearrange(system, x[end - 1].reshape(-1, 3), path.drive[0][end - 1])
            if arrangement.plan is None:
                return kernel.WEAK, end, 0.0
            best, fresh, ahead = 0.0, True, INTERVAL
        else:
            fresh, ahead = False, 2 * ahead
        exact, done = True, end - 1
        at = x[done].reshape(-1, 3).copy()


def walked(system: System, path: Path, at: NDArray[np.float64], done: int, least: float) -> tuple[NDArray[np.float64], float]:
    """From positions at (3 n,) at sample `done` to the values at the next sample, in smaller and smaller steps.

    Returns the last good positions (3 n,) and the fraction of the change that they have reached.
    """
    good = 1
    for parts in (8, 64, 512):
        inner = _straight(path, done, parts)
        histories = allocate(*[(parts + 1, system.x0.size)] * 3, (parts + 1,))
        start = at.reshape(-1, 3).copy()
        arrangement = rearrange(system, start, path.drive[0][done])
        if arrangement.plan is None:
            return at, 0.0
        try:
            reason, good, _ = sweep_redundant(system, arrangement, inner, start, True, least, histories, between=False)
        except InputError:
            return at, 0.0
        if reason == kernel.DONE:
            return histories[0][-1], 1.0
    return (histories[0][good - 1], (good - 1) / parts) if good > 1 else (at, 0.0)


def _straight(path: Path, done: int, parts: int) -> Path:
    """The path from sample `done` to the next at constant rates, in equal parts."""
    share, h = np.linspace(0.0, 1.0, parts + 1)[:, None], path.t[done + 1] - path.t[done]
    laws = []
    for here, there in ((y[0][done], y[0][done + 1]) for y in (path.drive, path.moving)):
        value = here + share * (there - here)
        laws.append((value, np.tile((there - here) / h, (parts + 1, 1)), np.zeros_like(value)))
    return Path(t=path.t[done] + h * share[:, 0], drive=laws[0], moving=laws[1])


def sweep(
    system: System,
    plan: Any,
    path: Path,
    at: NDArray[np.float64],
    exact: bool,
    here: slice,
    least: float,
    histories: tuple[NDArray[np.float64], ...],
) -> tuple[int, int, float]:
    """Run the kernel over the samples `here`; `at` (n, 3) are positions at the first of them (exact) or at the start."""
    flat = np.ascontiguousarray(at.reshape(-1))
    values = path.drive[0][here.start] if exact else system.drive_start
    given = kernel.Prescribed(path.t[here], *(tuple(y[here] for y in one) for one in (path.drive, path.moving)))
    x, v, a, gauge = (y[here] for y in histories)
    start, states = kernel.Start(flat, values, flat[plan.moving]), States(x, v, a)
    reason, good, reached = kernel.follow(plan, start, given, shortest(system), least, states, gauge)
    return reason, here.start + good, reached


def _agreeing(system: System, path: Path, extra: NDArray[np.int64], good: slice, x: NDArray[np.float64]) -> int:
    """Number of samples of an interval before the first at which a redundant constraint is not satisfied."""
    off = np.abs(misses(system, extra, path.drive[0][good], x[good])).max(axis=1, initial=0.0)
    far = off > AGREE * shortest(system)
    return int(np.argmax(far)) if far.any() else len(far)


def contradicts(system: System, arrangement: Arrangement, path: Path, done: int, x: NDArray[np.float64]) -> bool:
    """True if the drives contradict each other to first order after sample `done` at positions x (3 n,).

    If they do not and the next sample still cannot be reached, the path ends at the reach of the structure.
    """
    rows, part = np.arange(len(system.row_member)), 1e-4
    here, drive = x.copy(), path.drive[0]
    moving = arrangement.plan.moving  # type: ignore[union-attr]
    here[moving] += part * (path.moving[0][done + 1] - path.moving[0][done])
    values = drive[done] + part * (drive[done + 1] - drive[done])
    # J dx = wanted in the least-squares sense: a remainder means that no displacement dx satisfies all constraints
    wanted = -misses(system, rows, values[None], here[None])[0]
    J = jacobian(system, here.reshape(-1, 3), values)
    left = wanted - J @ np.linalg.lstsq(J, wanted, rcond=RANK_TOLERANCE)[0]
    return bool(np.abs(left).max() > 0.01 * np.abs(wanted).max())


def _fight(system: System, path: Path, extra: NDArray[np.int64], k: int, x: NDArray[np.float64]) -> InputError:
    """The error if redundant constraints do not agree with the others at sample k."""
    miss = np.abs(misses(system, extra, path.drive[0][k : k + 1], x[k : k + 1])[0])
    r = int(extra[np.argmax(miss)])
    others, driven = _partners(system, r)
    said = [shared_rotations(system.model)]
    if driven or system.row_drive[r] >= 0:
        said.append("Drive one of them less.")
    else:
        said.append("No drive is among them: remove one of them, or let a bar of them change its length.")
    return InputError(
        f"The drives contradict each other: {system.part_of(r)!r} is fixed by the others ({few(others, 8)}) and "
        f"cannot follow its prescribed values from t = {path.t[k]:g} s on (off by {miss.max():.3g} m). "
        f"{' '.join(filter(None, said))}"
    )


def misses(system: System, rows: NDArray[np.int64], values: NDArray[np.float64], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Residuals (times, rows), m, of some constraints at x, with drives at `values` (times, drives): value minus target."""
    member, drive = system.row_member[rows], system.row_drive[rows]
    wanted = np.broadcast_to(system.row_value[rows], (len(x), len(rows))).copy()
    wanted[:, drive >= 0] = values[:, drive[drive >= 0]]
    miss = np.empty(wanted.shape)
    # length of a member: |B - A| minus its target
    distances(system.p[member], system.q[member], x, miss)
    miss -= wanted
    nodes = x.reshape(len(x), len(system.nodes), 3)
    for e in np.flatnonzero((system.row_kind[rows] != LENGTH) | (system.row_measure[rows] >= 0)):
        # a sum of coordinates: its value minus its target, without whole periods
        m, angle = system.row_measure[rows[e]], wanted[:, e]
        if m >= 0:
            gap, period = measured(system, m, nodes)[:, 0] - angle, system.measure_period[m]
            miss[:, e] = system.measure_scale[m] * (gap - period * np.rint(gap / period) if period > 0 else gap)
        else:
            # angle of a member: component of B - A normal to the prescribed direction
            d = nodes[:, system.q[member[e]]] - nodes[:, system.p[member[e]]]
            miss[:, e] = d[:, 1] * np.cos(angle) - d[:, 0] * np.sin(angle)
    return miss


def _partners(system: System, r: int) -> tuple[list[str], bool]:
    """Names of the drives (or, if none, other parts) in a state of self-stress with constraint r; whether they are drives."""
    states = mobility_at(system, system.x0).self_stress_states
    shared = np.any(np.abs(states[np.abs(states[:, r]) > 1e-9]) > 1e-9, axis=0)
    shared[r] = False
    drives = [k for k in np.flatnonzero(shared) if system.row_drive[k] >= 0]
    own, names = system.parts_of([r]), system.parts_of(drives or np.flatnonzero(shared))
    return [name for name in names if name not in own] or ["its supports"], bool(drives)
