"""Finds a static equilibrium: descent of the potential energy on the rigid rows, Newton's method at the end.

Every step solves the saddle-point system with the whole tangent stiffness; a shift is added if the energy does not decrease
(Levenberg, 1944; Marquardt, 1963), and the step is projected onto the rows before the energy is evaluated. If this ends in an
unstable equilibrium, the search continues along the unstable mode, unless it started there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.elements.beam_matrices import mode_rates, mode_stiffness, mode_values
from kinetruss.elements.continua_matrices import continua_stiffness, densities, squared_changes
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics import System, constraint_jacobian, ends_of, measure_gradients, row_scales
from kinetruss.mechanics.balance import Balance
from kinetruss.mechanics.elements import element_forces
from kinetruss.mechanics.positions import row_values, shortest
from kinetruss.statics.saddle_point import DENSE, LOOKED_AT, NEUTRAL, Rows, Saddle, inertia, modes, rows_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import Continua


NEAR = 1e-6
"""Below this fraction of the largest force, the residual forces decide about a step, not the energy."""

CLOSED = 1e-9
"""Tolerance of closed lengths, as a fraction of the size of the structure."""

ROUND_OFF = 1e-15
"""Round-off of forces, as a fraction of stiffness times size."""

NEWTON = 25
"""Largest number of plain Newton steps to one equilibrium."""

LARGEST_TURN = 0.5
"""Largest rotation of a frame in one such step, rad."""

SMALL = 1e-2
"""Residual below which steps whose residual has grown twice go on without predicted forces."""

PARTS = (1, 4, 16, 64)
"""Numbers of parts in which the residual forces of the start are taken off."""

FAR = 1e-7
"""Steps below this fraction of the longest step end a search."""

CLEAR = 100.0
"""Residual forces below this multiple of round-off end a search."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Stability:
    """values (k,) N/m ascending and shapes (k, n, 3) of the reduced stiffness, the lowest only; counts of negative and none."""

    values: NDArray[np.float64]
    shapes: NDArray[np.float64]
    negative: int
    neutral: int


@dataclass(frozen=True, kw_only=True, eq=False)
class SearchResult:
    """x (n, 3) m, N (rows,) N; residual: largest residual force, on node `worst`, as a fraction of the largest force; number
    of steps; good: True in equilibrium.
    """

    x: NDArray[np.float64]
    N: NDArray[np.float64]
    residual: float
    worst: int
    steps: int
    good: bool
    stability: Stability


def row_errors(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64]) -> NDArray[np.float64]:
    """Residuals of the rows, (rows,) m; angles times the length."""
    period = np.where(system.row_kind == ANGLE, 2 * np.pi, 0.0)
    period[system.sums] = system.measure_period[system.row_measure[system.sums]]
    off = row_values(system, x) - wanted
    turns = period > 0
    off[turns] -= period[turns] * np.rint(off[turns] / period[turns])
    return np.asarray(row_scales(system, x) * off)


def projected(
    system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], limit: float, steps: int = 60, rows: Rows | None = None
) -> tuple[NDArray[np.float64], float]:
    """The nearest positions with rows at their values (Gauss-Newton, least changes), and the largest remaining error, m."""
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
    """Positions with rows at their values near x (n, 3), the largest remaining error, m, and the size of the structure, m.

    places : (3 n,) m, values of the coordinates that are not free.

    Lengths change in small steps, so that the configuration is connected to the start. If the values cannot be reached to
    first order, for instance with bars on one line, a fixed small perturbation of the start is used.
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
        again, left = projected(system, beside, wanted, 0.1 * span, 300, rows_of(system, beside))
        if left < error:
            found, error = again, left
    return found, error, span


def _walked(
    system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], places: NDArray[np.float64], span: float
) -> tuple[NDArray[np.float64], float]:
    """`projected` in steps of lengths and coordinates that are small compared with the shortest length."""
    away = row_errors(system, x, wanted) / row_scales(system, x)
    moved = np.where(system.prescribed, places - x.reshape(-1), 0.0).reshape(-1, 3)
    far = max(float(np.abs(away).max(initial=0.0)), float(np.abs(moved).max()))
    steps = int(np.clip(np.ceil(far / (0.1 * shortest(system))), 1, 100))
    rows = rows_of(system, x)
    for k in range(1, steps):
        x, _ = projected(system, x + moved / steps, wanted + (1 - k / steps) * away, 0.1 * span, 20, rows)
    x = np.where(system.prescribed, places, (x + moved / steps).reshape(-1)).reshape(-1, 3)
    return projected(system, x, wanted, 0.1 * span, 300, rows)


def row_force(balance: Balance, x: NDArray[np.float64], rows: Rows) -> tuple[NDArray[np.float64], Any]:
    """Row forces N (rows,) that balance the applied forces best, and the gradients J of the rows by the free coordinates."""
    system = balance.system
    J = constraint_jacobian(system, x)[:, system.free]
    if not J.shape[0]:
        return np.zeros(0), J
    _, N = Saddle(_identity(J.shape[1]), J, rows).solve(balance.applied(x)[system.free], np.zeros(J.shape[0]))
    return rows.shared(J, N), J


def force_scale(balance: Balance, x: NDArray[np.float64], N: NDArray[np.float64]) -> float:
    """The largest force in the structure, N."""
    parts = [balance.force, N, balance.tension(x), balance.push, balance.pushing(x)]
    parts.append(balance.following(x) if balance.followers else np.zeros(0))
    parts += [balance.turn[m] * measure_gradients(balance.system, m, x[None]) for m in np.flatnonzero(balance.turn)]
    if np.any(balance.torque):
        parts.append(balance.torque / ends_of(balance.system, x)[1])
    scale = max(float(np.abs(part).max(initial=0.0)) for part in parts)
    # strained, but without load: it returns to its stress-free configuration
    if not scale:
        scale = float(np.abs(element_forces(balance.system, x)).max(initial=0.0))
    return scale


def find_equilibrium(
    balance: Balance, x: NDArray[np.float64], wanted: NDArray[np.float64], tolerance: float, max_steps: int
) -> SearchResult:
    """The equilibrium found from positions x (n, 3) that satisfy the rows."""
    walk = _Walk(balance, wanted, tolerance, max_steps, rows_of(balance.system, x))
    if balance.system.continua is not None and balance.system.continua.beams is not None and (direct := walk.direct(x)):
        return direct
    x, good = walk.down(x)
    N, J = row_force(balance, x, walk.rows)
    found = stability(balance, x, N, J, walk.rows)
    for _ in range(6):
        if not good or not found.negative or not walk.steps or not len(found.shapes):
            break
        x, good = walk.down(walk.displaced(x, found.shapes[0]))
        N, J = row_force(balance, x, walk.rows)
        found = stability(balance, x, N, J, walk.rows)
    residual = walk.residual(x, N, J)
    return SearchResult(x=x, N=N, residual=residual, worst=walk.worst(x, N, J), steps=walk.steps, good=good, stability=found)


def _stresses(found: Continua, x: NDArray[np.float64], moved: NDArray[np.float64] | None = None) -> list[NDArray[np.float64]]:
    """Force densities of edges and forces of the modes of beams at x, and what small displacements from x add to them."""
    made = []
    if found.patches:
        change = squared_changes(found, x)
        if moved is not None:
            p, q = found.ends
            # squared lengths change by 2 d . (u_q - u_p)
            change += 2 * np.einsum("ec,ec->e", x[q] - x[p], moved[q] - moved[p])
        made.append(densities(found, change))
    if (beams := found.beams) is not None:
        values = mode_values(beams, x[None])[0]
        if moved is not None:
            values += mode_rates(beams, x[None], moved[None])[0]
        made.append(beams.rigidity * values)
    return made


def _of_stresses(found: Continua, x: NDArray[np.float64], stresses: list[NDArray[np.float64]]) -> Any:
    """The stiffness of such stresses at x, (3 n, 3 n)."""
    parts = [continua_stiffness(found, x, stresses[0], material=False)] if found.patches else []
    if found.beams is not None:
        parts.append(mode_stiffness(found.beams, x, stresses[-1]))
    return sum(parts[1:], parts[0])


class _Walk:
    """The descent: its constants, and the number of steps so far."""

    def __init__(self, balance: Balance, wanted: NDArray[np.float64], tolerance: float, max_steps: int, rows: Rows) -> None:
        self.balance, self.wanted, self.tolerance, self.max_steps, self.rows = balance, wanted, tolerance, max_steps, rows
        self.system = balance.system
        d = self.system.x0[self.system.q] - self.system.x0[self.system.p]
        self.limit = 0.5 * float(np.linalg.norm(d, axis=1).min(initial=np.inf)) if len(d) else 1.0
        self.steps = 0

    def choose(self, x: NDArray[np.float64]) -> bool:
        """Choose the independent rows again: those of one position may be dependent at the next. False if all are kept."""
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
        """Largest residual force as a fraction of the largest force."""
        scale = force_scale(self.balance, x, N)
        g = self._left(x, N, J)
        return float(np.abs(g).max(initial=0.0)) / scale if scale else 0.0

    def worst(self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any) -> int:
        """Node with the largest residual force."""
        g = np.abs(self._left(x, N, J))
        return int(self.system.free[g.argmax()]) // 3 if len(g) else 0

    def direct(self, x: NDArray[np.float64]) -> SearchResult | None:
        """A stable equilibrium by plain Newton steps, with less energy than at x; None if they do not find one.

        Slender beams are stiff along and soft across: a straight step strains them along, so the energy falls on short steps
        only, while the residual forces of a full step are gone with the next one. Where that fails, the residual forces of the
        start are taken off in parts (continuation, Allgower and Georg, 1990, chapter 2).
        """
        N, J = row_force(self.balance, x, self.rows)
        if self.residual(x, N, J) <= self.tolerance:
            return None
        first, without = np.zeros(x.size), _Walk(self.balance.with_share(0.0), self.wanted, 0.0, 0, self.rows)
        first[self.system.free] = without._left(x, row_force(without.balance, x, self.rows)[0], J)
        for parts in PARTS:
            y: NDArray[np.float64] | None = x
            for k in range(1, parts + 1):
                held = self.balance.with_share(k / parts)
                held = held.with_force(held.force - (1 - k / parts) * first)
                walk = _Walk(held, self.wanted, self.tolerance if k == parts else NEAR, self.max_steps, self.rows)
                y = None if y is None else walk.newton(y)
                self.steps += walk.steps
            if y is None:
                continue
            N, J = row_force(self.balance, y, self.rows)
            found = stability(self.balance, y, N, J, self.rows)
            if not found.negative and (self.balance.followers or self.balance.energy_change(x, y) < 0.0):
                left, worst = self.residual(y, N, J), self.worst(y, N, J)
                return SearchResult(x=y, N=N, residual=left, worst=worst, steps=self.steps, good=True, stability=found)
        return None

    def newton(self, x: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Positions in balance by full steps from x, or None.

        The geometric stiffness takes the forces that the last step predicts, not those of the strains that its straight line
        leaves (mixed points: Magisano, Leonetti and Garcea, Int. J. Numer. Methods Eng. 111 (2017) 1049-1073).
        """
        system, span = self.system, float(np.ptp(x, axis=0).max()) or 1.0
        free, found = system.free, cast("Continua", system.continua)
        N, J = row_force(self.balance, x, self.rows)
        stress = here = _stresses(found, x)
        close: tuple[NDArray[np.float64], float] | None = None
        last, grown = np.inf, 0
        for _ in range(NEWTON):
            # tangent at x, with the geometric part of the predicted stresses in place of those at x
            K = self.balance.stiffness(x, N) + _of_stresses(found, x, [a - b for a, b in zip(stress, here, strict=True)])
            g = self.balance.applied(x)[free] - J.T @ N
            p, dN = Saddle(K[free][:, free], J, self.rows).solve(g, np.zeros(J.shape[0]))
            if not np.all(np.isfinite(p)):
                return None if close is None else close[0]
            step = np.zeros(x.size)
            step[free] = p
            moved = step.reshape(-1, 3)
            # a step that turns no member by more than the limit
            turned = np.linalg.norm(moved[system.q] - moved[system.p], axis=1) / ends_of(system, x)[1]
            part = min(1.0, LARGEST_TURN / max(float(turned.max(initial=0.0)), 1e-300))
            moved = part * moved
            stress = _stresses(found, x, moved)
            x, off = projected(system, x + moved, self.wanted, span, rows=self.rows)
            here = _stresses(found, x)
            self.steps += 1
            if not off <= CLOSED * span:
                return None if close is None else close[0]
            best, J = row_force(self.balance, x, self.rows)
            left = self.residual(x, best, J)
            if left <= self.tolerance:
                return x
            if close is not None:
                return x if left < close[1] else close[0]
            # round-off of positions is mostly left in stiff directions: one step more takes the others far below it
            close = (x, left) if left <= self.floor(x, best) else None
            N, grown, last = N + part * dN, grown + (left > last), left
            # beside a bifurcation predicted forces lead to and fro; those at x lead to it, by a third of the rest at a time
            if grown > 1 and left < SMALL:
                stress, N = here, best
        return None

    def down(self, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], bool]:
        """Take steps until the forces balance; True if they do."""
        shift, stuck = 0.0, 0
        N, J = row_force(self.balance, x, self.rows)
        left = self.residual(x, N, J)
        while left > self.tolerance and stuck < 3 and self.steps < self.max_steps:
            y, shift = self._step(x, N, J, left, shift)
            if y is None:
                break
            N_y, J_y = row_force(self.balance, y, self.rows)
            left_y = self.residual(y, N_y, J_y)
            # near round-off the residual decides whether a step improves; next to a limit point it stays small over a long way
            gained = left >= NEAR or not 0.5 * left <= left_y < NEAR
            stuck = 0 if gained or self._on_its_way(x, N, y, left) else stuck + 1
            if stuck == 0 or left_y < left:
                x, N, J, left = y, N_y, J_y, left_y
                if len(self.rows.kept) <= DENSE:
                    self.choose(x)
            self.steps += 1
        return x, left <= max(self.tolerance, 1e-9) or left <= self.floor(x, N)

    def _on_its_way(self, x: NDArray[np.float64], N: NDArray[np.float64], y: NDArray[np.float64], left: float) -> bool:
        """True if neither the step to y nor the residual forces at x are round-off."""
        return float(np.abs(y - x).max()) > FAR * self.limit and left > CLEAR * self.floor(x, N)

    def _step(
        self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any, left: float, shift: float
    ) -> tuple[NDArray[np.float64] | None, float]:
        """The next positions, and the shift (N/m) with which the energy decreases; None if it does with no shift."""
        free = self.system.free
        K = self.balance.stiffness(x, N)[free][:, free]
        g = self._left(x, N, J)
        still = np.zeros(J.shape[0])
        shift, fresh = shift if left >= NEAR else 0.0, len(self.rows.kept) <= DENSE
        scale = force_scale(self.balance, x, N)
        # a body without contact has no stiffness at all: then what takes a step of the longest length
        stiff = max(float(np.abs(K.data).max(initial=0.0)), scale / self.limit)
        noise = ROUND_OFF * scale * float(np.abs(x).max())
        while shift <= 1e12 * stiff:
            p, _ = Saddle(K, J, self.rows, shift).solve(g, still)
            if not (fresh or np.all(np.isfinite(p))) and self.choose(x):
                fresh = True
                continue
            if left < NEAR and not shift and p @ (K @ p) <= 0:
                # the energy is too flat here to show the descent from an unstable equilibrium; the unstable mode shows it
                found = stability(self.balance, x, N, J, self.rows)
                if found.negative and len(found.shapes):
                    return self.displaced(x, found.shapes[0]), shift
            if np.all(np.isfinite(p)) and g @ p > 0 and (shift or p @ (K @ p) > 0):
                part = min(1.0, self.limit / max(float(np.abs(p).max()), 1e-300))
                y = x.copy()
                y.reshape(-1)[free] += part * p
                y, off = projected(self.system, y, self.wanted, self.limit, rows=self.rows)
                if not (fresh or off <= CLOSED * self.limit) and self.choose(x):
                    fresh = True
                    continue
                fall = -self.balance.energy_change(x, y)
                falls = fall >= 1e-4 * part * (g @ p) or (left < NEAR and part == 1.0)
                if off <= CLOSED * self.limit and (falls or (g @ p < CLEAR * noise and self._balances(y, left))):
                    return y, 0.0 if shift < 1e-9 * stiff else 0.1 * shift
            shift = max(10 * shift, 1e-9 * stiff)
        return None, shift

    def _balances(self, y: NDArray[np.float64], left: float) -> bool:
        """True if less than a residual is left at y: where the fall of the energy is lost in round-off of the positions."""
        return self.residual(y, *row_force(self.balance, y, self.rows)) < left

    def _left(self, x: NDArray[np.float64], N: NDArray[np.float64], J: Any) -> NDArray[np.float64]:
        g = self.balance.applied(x)[self.system.free]
        return np.asarray(g - J.T @ N if len(N) else g)

    def displaced(self, x: NDArray[np.float64], mode: NDArray[np.float64]) -> NDArray[np.float64]:
        """A small displacement along a mode (n, 3), in the direction in which the energy decreases more."""
        step = 0.1 * self.limit * mode / np.abs(mode).max()
        both = [projected(self.system, x + sign * step, self.wanted, self.limit, rows=self.rows)[0] for sign in (1.0, -1.0)]
        return min(both, key=lambda y: self.balance.energy_change(x, y))


def stability(balance: Balance, x: NDArray[np.float64], N: NDArray[np.float64], J: Any, rows: Rows) -> Stability:
    """Eigenvalues of the reduced stiffness in equilibrium: the lowest six, and the numbers of negative and of zero ones."""
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
