"""Finds where a structure comes to rest: descent of the potential energy along the rigid rows, Newton's method at the end.

Every step solves the saddle-point system with the whole tangent stiffness; a shift is added where the energy does not fall
(Levenberg, 1944; Marquardt, 1963), and the step is drawn back onto the rows before the energy is asked. Where this ends in an
unstable equilibrium, it goes on along the mode that gives way, unless it was started there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.mechanics import System, constraint_jacobian, ends_of, measure_gradients, row_scales
from kinetruss.mechanics.assembly import Balance, resting_forces
from kinetruss.mechanics.configuration import row_values, shortest
from kinetruss.statics.large.saddle import DENSE, LOOKED_AT, NEUTRAL, Rows, Saddle, inertia, modes, rows_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "CLOSED",
    "ROUND_OFF",
    "Rest",
    "Stability",
    "closed",
    "drawn",
    "force_scale",
    "row_errors",
    "row_force",
    "settle",
    "stability",
]

NEAR = 1e-6
"""Share of the largest force below which what is left of the forces says more than the energy does."""

CLOSED = 1e-9
"""Share of the size of the structure to which lengths are closed."""

ROUND_OFF = 1e-15
"""Forces are no better than stiffness times size times this."""

FAR, CLEAR = 1e-7, 100.0
"""Step, in parts of the longest one, and forces left, in parts of round-off, beyond which a search goes on."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Stability:
    """values (k,) N/m ascending and shapes (k, n, 3) of the reduced stiffness, the lowest only; counts of negative and none."""

    values: NDArray[np.float64]
    shapes: NDArray[np.float64]
    negative: int
    neutral: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Rest:
    """x (n, 3) m, N (rows,) N; residual: largest force left, of the largest force, on node `worst`; steps taken; good: True at
    rest.
    """

    x: NDArray[np.float64]
    N: NDArray[np.float64]
    residual: float
    worst: int
    steps: int
    good: bool
    stability: Stability


def row_errors(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far rows are from their values, (rows,) m, angles times the length."""
    period = np.where(system.row_kind == ANGLE, 2 * np.pi, 0.0)
    period[system.sums] = system.measure_period[system.row_measure[system.sums]]
    off = row_values(system, x) - wanted
    turns = period > 0
    off[turns] -= period[turns] * np.rint(off[turns] / period[turns])
    return np.asarray(row_scales(system, x) * off)


def drawn(
    system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], limit: float, steps: int = 60, rows: Rows | None = None
) -> tuple[NDArray[np.float64], float]:
    """The nearest positions with rows at their values (Gauss-Newton, least changes), and the largest error left, m."""
    error = row_errors(system, x, wanted)
    worst = float(np.abs(error).max(initial=0.0))
    rows = rows_of(system, x) if rows is None else rows
    for _ in range(steps):
        if worst <= 1e-15 * limit:
            break
        J = constraint_jacobian(system, x)[:, system.free]
        dx, _ = Saddle(_identity(J.shape[1]), J, rows).solve(np.zeros(J.shape[1]), -error)
        if not np.all(np.isfinite(dx)):
            break
        dx *= min(1.0, limit / max(float(np.abs(dx).max()), 1e-300))
        y = x.copy()
        y.reshape(-1)[system.free] += dx
        error_y = row_errors(system, y, wanted)
        left = float(np.abs(error_y).max())
        if left >= worst and left < 1e-10 * limit:
            break
        x, error, worst = y, error_y, left
    return x, worst


def closed(
    system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], places: NDArray[np.float64]
) -> tuple[NDArray[np.float64], float, float]:
    """Positions with rows at their values near x (n, 3), the largest error left, m, and the size of the structure, m.

    places : (3 n,) m, where the coordinates are that are not free.

    Lengths go there in small steps, so the configuration is the one connected to the start. Where bars lie in one line, say,
    they cannot be reached to first order: then it starts from a little beside, always alike.
    """
    span = float(np.ptp(system.x0, axis=0).max()) or 1.0
    found, error = _walked(system, x, wanted, places, span)
    x = np.where(system.prescribed, places, x.reshape(-1)).reshape(-1, 3)
    chance = np.random.default_rng(1)
    for size in (1e-3, 1e-2, 0.1):
        if error <= CLOSED * span:
            break
        beside = x.copy()
        beside.reshape(-1)[system.free] += size * span * chance.standard_normal(len(system.free))
        again, left = drawn(system, beside, wanted, 0.1 * span, 300, rows_of(system, beside))
        if left < error:
            found, error = again, left
    return found, error, span


def _walked(
    system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], places: NDArray[np.float64], span: float
) -> tuple[NDArray[np.float64], float]:
    """`drawn` in steps of lengths and coordinates that are small against the shortest length."""
    away = row_errors(system, x, wanted) / row_scales(system, x)
    moved = np.where(system.prescribed, places - x.reshape(-1), 0.0).reshape(-1, 3)
    far = max(float(np.abs(away).max(initial=0.0)), float(np.abs(moved).max()))
    steps = int(np.clip(np.ceil(far / (0.1 * shortest(system))), 1, 100))
    rows = rows_of(system, x)
    for k in range(1, steps):
        x, _ = drawn(system, x + moved / steps, wanted + (1 - k / steps) * away, 0.1 * span, 20, rows)
    x = np.where(system.prescribed, places, (x + moved / steps).reshape(-1)).reshape(-1, 3)
    return drawn(system, x, wanted, 0.1 * span, 300, rows)


def row_force(balance: Balance, x: NDArray[np.float64], rows: Rows) -> tuple[NDArray[np.float64], Any]:
    """Row forces N (rows,) that carry the applied forces best, and the gradients J of the rows by the free coordinates."""
    system = balance.system
    J = constraint_jacobian(system, x)[:, system.free]
    if not J.shape[0]:
        return np.zeros(0), J
    _, N = Saddle(_identity(J.shape[1]), J, rows).solve(balance.applied(x)[system.free], np.zeros(J.shape[0]))
    return rows.shared(J, N), J


def force_scale(balance: Balance, x: NDArray[np.float64], N: NDArray[np.float64]) -> float:
    """The largest force about, N."""
    parts = [balance.force, N, balance.tension(x), balance.push, balance.following(x) if balance.followers else np.zeros(0)]
    parts += [balance.turn[m] * measure_gradients(balance.system, m, x[None]) for m in np.flatnonzero(balance.turn)]
    if np.any(balance.torque):
        parts.append(balance.torque / ends_of(balance.system, x)[1])
    scale = max(float(np.abs(part).max(initial=0.0)) for part in parts)
    if not scale and balance.system.continua is not None:  # strained, but under no load: on its way back
        scale = float(np.abs(resting_forces(balance.system.continua, x)).max(initial=0.0))
    return scale


def settle(balance: Balance, x: NDArray[np.float64], wanted: NDArray[np.float64], tolerance: float, max_steps: int) -> Rest:
    """Come to rest from positions x (n, 3) on the rows."""
    walk = _Walk(balance, wanted, tolerance, max_steps, rows_of(balance.system, x))
    x, good = walk.down(x)
    N, J = row_force(balance, x, walk.rows)
    found = stability(balance, x, N, J, walk.rows)
    for _ in range(6):
        if not good or not found.negative or not walk.steps or not len(found.shapes):
            break
        x, good = walk.down(walk.pushed(x, found.shapes[0]))
        N, J = row_force(balance, x, walk.rows)
        found = stability(balance, x, N, J, walk.rows)
    residual = walk.residual(x, N, J)
    return Rest(x=x, N=N, residual=residual, worst=walk.worst(x, N, J), steps=walk.steps, good=good, stability=found)


class _Walk:
    """The way down: what stays the same on it, and how many steps it took."""

    def __init__(self, balance: Balance, wanted: NDArray[np.float64], tolerance: float, max_steps: int, rows: Rows) -> None:
        self.balance, self.wanted, self.tolerance, self.max_steps, self.rows = balance, wanted, tolerance, max_steps, rows
        self.system = balance.system
        d = self.system.x0[self.system.q] - self.system.x0[self.system.p]
        self.limit = 0.5 * float(np.linalg.norm(d, axis=1).min(initial=np.inf)) if len(d) else 1.0
        self.steps = 0

    def choose(self, x: NDArray[np.float64]) -> bool:
        """Choose anew which rows are kept: those of one place may depend on each other in the next. False where all are."""
        if len(self.rows.redundant):
            self.rows = rows_of(self.system, x)
        return bool(len(self.rows.redundant))

    def floor(self, x: NDArray[np.float64], N: NDArray[np.float64]) -> float:
        """What round-off of the positions alone leaves of the forces, of the largest force."""
        free = self.system.free
        K = self.balance.stiffness(x, N)[free][:, free]
        scale = force_scale(self.balance, x, N)
        return ROUND_OFF * float(np.abs(K.data).max(initial=0.0)) * float(np.abs(x).max()) / scale if scale else 0.0

    def residual(self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any) -> float:
        """Largest force left, of the largest force."""
        scale = force_scale(self.balance, x, N)
        g = self._left(x, N, J)
        return float(np.abs(g).max(initial=0.0)) / scale if scale else 0.0

    def worst(self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any) -> int:
        """Node on which most is left."""
        g = np.abs(self._left(x, N, J))
        return int(self.system.free[g.argmax()]) // 3 if len(g) else 0

    def down(self, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], bool]:
        """Steps until the forces balance; True where they do."""
        shift, stuck = 0.0, 0
        N, J = row_force(self.balance, x, self.rows)
        left = self.residual(x, N, J)
        while left > self.tolerance and stuck < 3 and self.steps < self.max_steps:
            y, shift = self._step(x, N, J, left, shift)
            if y is None:
                break
            N_y, J_y = row_force(self.balance, y, self.rows)
            left_y = self.residual(y, N_y, J_y)
            # near round-off the residual says whether anything is gained; next to a limit point it stays small on a long way
            gained = left >= NEAR or not 0.5 * left <= left_y < NEAR
            stuck = 0 if gained or self._on_its_way(x, N, y, left) else stuck + 1
            if stuck == 0 or left_y < left:
                x, N, J, left = y, N_y, J_y, left_y
                if len(self.rows.kept) <= DENSE:
                    self.choose(x)
            self.steps += 1
        return x, left <= max(self.tolerance, 1e-9) or left <= self.floor(x, N)

    def _on_its_way(self, x: NDArray[np.float64], N: NDArray[np.float64], y: NDArray[np.float64], left: float) -> bool:
        """True where the step to y is no round-off, and what is left of the forces at x neither."""
        return float(np.abs(y - x).max()) > FAR * self.limit and left > CLEAR * self.floor(x, N)

    def _step(
        self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any, left: float, shift: float
    ) -> tuple[NDArray[np.float64] | None, float]:
        """The next positions, and the shift that let the energy fall; None where no shift does."""
        free = self.system.free
        K = self.balance.stiffness(x, N)[free][:, free]
        g = self._left(x, N, J)
        still = np.zeros(J.shape[0])
        shift, fresh = shift if left >= NEAR else 0.0, len(self.rows.kept) <= DENSE
        while shift <= 1e12:
            p, _ = Saddle(K, J, self.rows, shift).solve(g, still)
            if not (fresh or np.all(np.isfinite(p))) and self.choose(x):
                fresh = True
                continue
            if left < NEAR and not shift and p @ (K @ p) <= 0:
                # the energy is too flat here to show the way down from an unstable equilibrium; its mode does
                found = stability(self.balance, x, N, J, self.rows)
                if found.negative and len(found.shapes):
                    return self.pushed(x, found.shapes[0]), shift
            if np.all(np.isfinite(p)) and g @ p > 0 and (shift or p @ (K @ p) > 0):
                part = min(1.0, self.limit / max(float(np.abs(p).max()), 1e-300))
                y = x.copy()
                y.reshape(-1)[free] += part * p
                y, off = drawn(self.system, y, self.wanted, self.limit, rows=self.rows)
                if not (fresh or off <= CLOSED * self.limit) and self.choose(x):
                    fresh = True
                    continue
                fall = -self.balance.energy_change(x, y)
                if off <= CLOSED * self.limit and (fall >= 1e-4 * part * (g @ p) or (left < NEAR and part == 1.0)):
                    return y, 0.0 if shift < 1e-9 else 0.1 * shift
            shift = max(10 * shift, 1e-9)
        return None, shift

    def _left(self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any) -> NDArray[np.float64]:
        g = self.balance.applied(x)[self.system.free]
        return np.asarray(g - J.T @ N if len(N) else g)

    def pushed(self, x: NDArray[np.float64], mode: NDArray[np.float64]) -> NDArray[np.float64]:
        """A little along a mode (n, 3), the way on which the energy falls more."""
        step = 0.1 * self.limit * mode / np.abs(mode).max()
        both = [drawn(self.system, x + sign * step, self.wanted, self.limit, rows=self.rows)[0] for sign in (1.0, -1.0)]
        return min(both, key=lambda y: self.balance.energy_change(x, y))


def stability(balance: Balance, x: NDArray[np.float64], N: NDArray[np.float64], J: Any, rows: Rows) -> Stability:
    """Eigenvalues of the reduced stiffness at rest: the lowest six, and how many are negative or none."""
    system = balance.system
    free = system.free
    if rows.kept.size == free.size:
        return Stability(values=np.zeros(0), shapes=np.zeros((0, *x.shape)), negative=0, neutral=0)
    K = balance.stiffness(x, N)[free][:, free]
    if len(free) > LOOKED_AT:
        negative, neutral = inertia(K, J)
        return Stability(values=np.zeros(0), shapes=np.zeros((0, *x.shape)), negative=negative, neutral=neutral)
    values, vectors = modes(K, J)
    size = float(np.abs(values).max(initial=0.0)) or 1.0
    shapes = np.zeros((min(6, len(values)), x.size))
    shapes[:, free] = vectors.T[: len(shapes)]
    return Stability(
        values=values[: len(shapes)],
        shapes=shapes.reshape(-1, *x.shape),
        negative=int(np.sum(values < -NEUTRAL * size)),
        neutral=int(np.sum(np.abs(values) <= NEUTRAL * size)),
    )


def _identity(size: int) -> Any:
    from scipy.sparse import eye_array

    return eye_array(size, format="csr")
