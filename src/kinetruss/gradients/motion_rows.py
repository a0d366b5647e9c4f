"""What a motion along given drives satisfies at each instant, as residuals of its states.

    phi(x) - d(t) = 0,    J v - d' = 0,    J a + J' v - d'' = 0,    f(x, v, a) - M a - J^T N = 0

with the rows of prescribed lengths, angles and sums; all three by one J, for lengths d (d.d/l - l)/2, d.d'/l - l', ...
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import block_array, csr_array, diags_array, vstack
from scipy.sparse.linalg import splu

from kinetruss.dynamics.force_tables import solved_in_space
from kinetruss.dynamics.simulation_records import solved_by
from kinetruss.errors import AnalysisError
from kinetruss.gradients.task_rows import TaskRows, drives_at
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, States
from kinetruss.mechanics import System, measured
from kinetruss.mechanics.beam_shapes import yielding_shapes
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.row_gradients import dot, row_ends

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Histories = tuple[Floats, Floats, Floats]


def holding(system: System) -> System:
    """The system whose rows hold at an instant: with those that keep loose beams in their shape."""
    held = yielding_shapes(system)
    return system if held is None else held.system


class Prescribed(NamedTuple):
    """Instants t (s,) s; values, rates and second rates of drives (s, drives) and of moving coordinates (s, k); tasks, if they
    lead the drives, whose values are then those of the motion, and are measured anew at other states.
    """

    t: Floats
    drive: Histories
    moving: Histories
    tasks: TaskRows | None = None

    def tiled(self, count: int) -> Prescribed:
        """The same so many times, one after the other."""

        def often(one: Floats) -> Floats:
            return np.tile(one, (count, *[1] * (one.ndim - 1)))

        tasks = None if self.tasks is None else self.tasks.tiled(count)
        return Prescribed(often(self.t), _each(often, self.drive), _each(often, self.moving), tasks)

    def still(self) -> Prescribed:
        """The same values at rest."""
        nothing = np.zeros_like(self.drive[0])
        return self._replace(drive=(self.drive[0], nothing, nothing))

    def at(self, system: System, states: States) -> Prescribed:
        """With the drives as they are at states (s, 3 n), if tasks lead them."""
        return self if self.tasks is None else self._replace(drive=drives_at(system, states, self.drive[0]))


def _each(of: Any, three: Histories) -> Histories:
    value, rate, second = map(of, three)
    return value, rate, second


def row_residuals(system: System, given: Prescribed, states: States) -> tuple[Floats, Floats, Floats]:
    """Residuals of positions, velocities and accelerations (s, rows), m and s, at states (s, 3 n)."""
    count, rows = len(states.x), len(system.row_member)
    x, v, a = (y.reshape(count, -1, 3) for y in states)
    target, rate, second = (
        np.broadcast_to(system.row_value, (count, rows)).copy(),
        np.zeros((count, rows)),
        np.zeros((count, rows)),
    )
    driven = np.flatnonzero(system.row_drive >= 0)
    for one, own in zip((target, rate, second), given.drive, strict=True):
        one[:, driven] = own[:, system.row_drive[driven]]
    found = np.zeros((3, count, rows))
    plain = system.row_measure < 0
    k = np.flatnonzero(plain & (system.row_kind == LENGTH))
    d, e, f = (row_ends(system, y, k) for y in (x, v, a))
    L, Ld, Ldd = (one[:, k] for one in (target, rate, second))
    found[0][:, k] = 0.5 * (dot(d, d)[..., 0] / L - L)
    found[1][:, k] = dot(d, e)[..., 0] / L - Ld
    found[2][:, k] = (dot(d, f) + dot(e, e))[..., 0] / L - Ld * Ld / L - Ldd
    k = np.flatnonzero(plain & (system.row_kind == ANGLE))
    if len(k):
        d, e, f = (row_ends(system, y, k) for y in (x, v, a))
        angle, w, wd = (one[:, k] for one in (target, rate, second))
        c, s = np.cos(angle), np.sin(angle)
        along, across = ([c * y[..., 0] + s * y[..., 1] for y in (d, e)], [c * y[..., 1] - s * y[..., 0] for y in (d, e, f)])
        found[0][:, k] = across[0]
        found[1][:, k] = across[1] - w * along[0]
        found[2][:, k] = across[2] - wd * along[0] - 2 * w * along[1] - w * w * across[0]
    for r in system.sums:
        m = system.row_measure[r]
        value, period = measured(system, m, x, v, a, along=False), system.measure_period[m]
        gap = value[:, 0] - target[:, r]
        gaps = gap - period * np.rint(gap / period) if period > 0 else gap, value[:, 1] - rate[:, r], value[:, 2] - second[:, r]
        for one, own in zip(found, gaps, strict=True):
            one[:, r] = system.measure_scale[m] * own
    return found[0], found[1], found[2]


def softness(system: System) -> Floats:
    """l/(E A) of the members of the rows (rows,), m/N; NaN where it is not known."""
    member = system.row_member
    return np.asarray(system.compliance[member] * system.length0[member] + system.yielding[member])


def state_rows(system: System, tasks: TaskRows | None) -> NDArray[np.int64]:
    """Rows that states satisfy, as indices of all: not those of drives that tasks lead."""
    rows = np.arange(len(system.row_drive))
    return rows if tasks is None else rows[system.row_drive < 0]


class Factors:
    """Factors of the rows J (rows, free) at an instant; redundant : rows, and weight (rows,) of the least sum of w N^2; led :
    the rows that states satisfy, and the gradients (tasks, free) of tasks behind them.
    """

    def __init__(
        self, J: Any, redundant: NDArray[np.int64], weight: Floats, led: tuple[NDArray[np.int64], Floats] | None = None
    ) -> None:
        self.J, self.weight, self.redundant = J, weight, redundant
        self.kept = np.setdiff1d(np.arange(J.shape[0]), redundant)
        self.count, self.at = J.shape[0], self.kept
        try:
            self.own = self.by_states = splu(J.tocsr()[self.kept].tocsc())
            if led is not None:
                rows, tasks = led
                own = np.setdiff1d(rows, redundant)
                self.count = len(rows) + len(tasks)
                self.at = np.concatenate([np.searchsorted(rows, own), len(rows) + np.arange(len(tasks))])
                self.by_states = splu(vstack([J.tocsr()[own], csr_array(tasks)]).tocsc())
            self.whole = splu(block_array([[diags_array(weight), -J], [-J.T, None]]).tocsc()) if len(redundant) else None
        except RuntimeError:
            raise AnalysisError("The position that the response reads is singular, so it has no gradient there.") from None

    def of_states(self, right: Floats) -> Floats:
        """z (k, rows and tasks) of J^T z = right (k, free), with the rows that states satisfy."""
        found = np.zeros((len(right), self.count))
        found[:, self.at] = self.by_states.solve(right.T, trans="T").T
        return found

    def of_forces(self, right: Floats) -> Floats:
        """z (k, free) of J z = -right (k, rows); of redundant rows those of J^T N and of w N = J m, (k, free + rows)."""
        if self.whole is None:
            return np.asarray(-self.own.solve(right.T).T)
        rows = right.shape[1]
        found = self.whole.solve(np.concatenate([right, np.zeros((len(right), self.J.shape[1]))], axis=1).T).T
        return np.concatenate([found[:, rows:], found[:, :rows]], axis=1)

    def shift(self, force: Floats) -> Floats:
        """m (free,) of w N = J m."""
        if self.whole is None:
            return np.zeros(self.J.shape[1])
        rows = len(force)
        return np.asarray(self.whole.solve(np.concatenate([np.zeros(rows), -(self.J.T @ force)]))[rows:])


def carried(system: System, t: Floats, case: str | None, states: States, N: Floats) -> tuple[Any, dict[str, Any]]:
    """The loads of a case at instants t (s,), and what carries them if the forces of the rows are N (s, rows), as of
    `dynamics.prescribed.solve`: ``rest`` (s, 3 n) is what is left at the nodes.
    """
    loads = case_loads(system, t, case, rotating=True).at(states.x)

    return loads, solved_in_space(system, loads, states, lambda pushed, space: solved_by(system, pushed, space, N))
