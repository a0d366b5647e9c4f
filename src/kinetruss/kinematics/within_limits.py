"""Drives along a task that keep limits of rates and accelerations by redundancy: a smooth curve of drives to be near to.

The drives that meet the task and are nearest to a curve r(t) move with P r, P the projector on the drives' motions that the
task does not see. To first order about a motion, rates are v + P r' + P' r and accelerations a + P r'' + 2 P' r' + P'' r.
So with a cubic spline r the least of the objective within all limits is a quadratic problem. It is solved about the exact
motion again until that keeps the limits and the objective no longer falls.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.motion.profiles import spline
from kinetruss.kernels.tasks import track as warm
from kinetruss.kernels.tasks.sweeps import Drives
from kinetruss.kinematics.drive_limits import Limits, motion_uses
from kinetruss.mechanics.quadratic import least_quadratic

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.task_problem import Problem, State


INTERVALS = 24
"""Polynomials of the spline."""
INSTANTS = 8 * INTERVALS
"""Smallest number of intervals between the instants at which limits are compared."""
EVERY = 2
"""Of these instants, one in so many has rows in the quadratic problem."""
ROUNDS = 10
"""Quadratic problems at most."""
FLAT = 2e-3
"""Change of the objective in one round, as a share of it, below which it counts as least."""
INSET, MOST = 1e-4, 0.02
"""Share of a limit that the quadratic problem leaves for what it does not see, at first and at most."""
DAMPING = 1e-6
"""Added to the quadratic function, as a share of its largest diagonal entry."""
EDGE = 1e-5
"""Distance from the ends of strokes that the quadratic problem leaves, in units of the shortest bar."""
STILL = 1e-9
"""Rates or accelerations of all drives, as a share of the largest, that count as none at the ends of a motion."""


@dataclass(frozen=True, kw_only=True, eq=False)
class _Course:
    """Values, rates and accelerations (times, d) of the drives; states x (times, 3 n).

    cost : mean of w (q - goal)^2 + w h^4 (q'' - bend)^2 with h an interval of the spline.
    """

    drive: tuple[NDArray[np.float64], ...]
    x: NDArray[np.float64]
    cost: float


@dataclass(frozen=True, kw_only=True, eq=False)
class _Task:
    """What stays the same from round to round. goal (times, d) : what drives are to be near to; bend (times, d) : what their
    accelerations are to be near to.
    """

    given: Problem
    limits: Limits
    t: NDArray[np.float64]
    parameters: NDArray[np.float64]
    state: State
    goal: NDArray[np.float64]
    bend: NDArray[np.float64]

    @property
    def smooth(self) -> float:
        """Weight of accelerations over that of drives, s^4: one interval of the spline to the fourth."""
        return float((self.t[-1] - self.t[0]) / INTERVALS) ** 4

    def followed(self, reference: Any) -> _Course | None:
        """The drives nearest to a curve, with Taylor coefficients (3, times, d); None if the path ends early."""
        state = self.state
        if reference is not None:
            state = replace(state, s=np.zeros_like(state.s))
        reason, good, out = self.given.track(self.t, self.parameters, state, reference)
        if reason != warm.DONE or good < len(self.t):
            return None
        d = self.goal.shape[1]
        drive = (out.z[0, :, :d], out.z[1, :, :d], 2.0 * out.z[2, :, :d])
        off = (drive[0] - self.goal) ** 2 + self.smooth * (drive[2] - self.bend) ** 2
        cost = float(np.mean(off @ self.given.drives.weight))
        return _Course(drive=drive, x=out.x[0], cost=cost)

    def use(self, course: _Course) -> float:
        """Largest use of a limit, strokes included: those by the shortest bar."""
        q, v, a = course.drive
        uses = motion_uses(self.limits, self.given.system.drives, self.t, (v, a))
        beyond = np.maximum(self.given.drives.lower - q, q - self.given.drives.upper).max() / self.given.scale
        return max(uses[0].ratio if uses else 0.0, 1.0 + float(beyond))


def references_within(
    given: Problem, limits: Limits, t: NDArray[np.float64], parameters: NDArray[np.float64], state: State, reference: Any
) -> Any:
    """Taylor coefficients (3, times, d) of what drives are to be near to, so that they keep their limits along a task.

    As given (possibly None) where the motion keeps the limits without, where the task leaves no freedom, or where nothing
    better is found. If not all limits can be kept, their largest use is the smallest found.
    """
    free = given.drives.held != 3
    if np.count_nonzero(free) <= len(given.tasks.labels) or len(t) < INSTANTS:
        return reference
    goal = np.tile(given.reference, (len(t), 1)) if reference is None else reference[0]
    own = _Task(given=given, limits=limits, t=t, parameters=parameters, state=state, goal=goal, bend=np.zeros_like(goal))
    first = own.followed(reference)
    if first is not None and own.use(first) <= 1.0:
        return reference
    # strokes are rows of the quadratic problem: drives that stop at a bound would make rates jump
    open_ended = Drives.of({name: getattr(given.drives, name) for name in ("row", "flat", "held", "weight")}
                           | {"lower": np.full(len(free), -np.inf), "upper": np.full(len(free), np.inf)})  # fmt: skip
    wide = replace(own, given=replace(given, drives=open_ended))
    course = wide.followed(reference)
    if course is None:
        return reference
    own, wide = replace(own, bend=course.drive[2]), replace(wide, bend=course.drive[2])
    best = _improved(own, wide, course)
    if first is not None and own.use(first) <= own.use(best):
        return reference
    q, v, a = best.drive
    return np.stack([q, v, 0.5 * a])


def _improved(own: _Task, wide: _Task, course: _Course) -> _Course:
    """The best motion of some rounds: of least use, and within the limits of least cost."""
    best, inset = course, INSET
    basis = _basis(own.t, course)
    for _ in range(ROUNDS):
        change = _change(own, course, basis, inset)
        found = None if change is None else _changed(wide, course, change)
        if found is None:
            break
        use, least_use = max(1.0, own.use(found)), max(1.0, own.use(best))
        best = found if use < least_use or (use == least_use and found.cost <= best.cost) else best
        if abs(found.cost - course.cost) <= FLAT * course.cost:
            if use == 1.0 or inset > MOST:
                break
            inset += 1.2 * (use - 1.0)
        course = found
    return best


def _changed(wide: _Task, course: _Course, change: list[NDArray[np.float64]]) -> _Course | None:
    """The motion nearest to the changed drives, or to a share of the change; None if none is found."""
    for share in (1.0, 0.5, 0.25):
        value, rate, second = (y + share * dy for y, dy in zip(course.drive, change, strict=True))
        if (found := wide.followed(np.stack([value, rate, 0.5 * second]))) is not None:
            return found
    return None


def _basis(t: NDArray[np.float64], course: _Course) -> tuple[NDArray[np.float64], ...]:
    """Cubic B-splines (times, k) with two derivatives; at the ends of the motion they keep what stands still."""
    from scipy.interpolate import BSpline

    knots = np.concatenate([[t[0]] * 3, np.linspace(t[0], t[-1], INTERVALS + 1), [t[-1]] * 3])
    curve = BSpline(knots, np.eye(INTERVALS + 3), 3)
    values = [np.asarray(curve(t, order)) for order in range(3)]
    begin, end = (1 + _orders_at_rest(course, k) for k in (0, -1))
    # begin coefficients are zero (no change at the start, its rates neither); the last `end` ones are equal
    last = INTERVALS + 3 - end
    return tuple(np.hstack([one[:, begin:last], one[:, last:].sum(axis=1, keepdims=True)]) for one in values)


def _orders_at_rest(course: _Course, k: int) -> int:
    """How many of rates and accelerations, in this order, are zero at sample k."""
    sizes = [float(np.abs(y[k]).max()) <= STILL * float(np.abs(y).max()) for y in course.drive[1:]]
    return 0 if not sizes[0] else 1 + int(sizes[1])


def _change(
    own: _Task, course: _Course, basis: tuple[NDArray[np.float64], ...], inset: float
) -> list[NDArray[np.float64]] | None:
    """Change of drives, rates and accelerations (times, d) of least objective within the limits, to first order."""
    given, d = own.given, course.drive[0].shape[1]
    k = basis[0].shape[1]
    P, Pd, Pdd = _projectors(own, course)
    B, Bd, Bdd = basis
    at = np.arange(0, len(own.t), EVERY)
    first, near = _near(basis, at)

    def rows(*terms: tuple[Any, Any]) -> NDArray[np.float64]:
        # sum of P_i b_ik over the terms, at the instants of the problem, of the splines that are not zero there
        found = [np.einsum("iab,ik->iakb", p[at], b) for p, b in terms]
        return np.asarray(np.sum(found, axis=0).reshape(len(at), d, -1))

    maps = rows((P, near[0])), rows((P, near[1]), (Pd, near[0])), rows((P, near[2]), (2.0 * Pd, near[1]), (Pdd, near[0]))
    w, scale = given.drives.weight, given.scale
    H, g = np.zeros((k * d, k * d)), np.zeros(k * d)
    weight = np.tile(w / (float(np.mean(w)) * len(at)), len(at))
    for share, part, off in ((1.0, maps[0], course.drive[0] - own.goal), (own.smooth, maps[2], course.drive[2] - own.bend)):
        drawn = _rows(part, d * first, k * d)
        H += share * (drawn.T @ (drawn * weight[:, None])).toarray()
        g += share * (drawn.T @ (weight * off[at].reshape(-1))) / scale
    # motions that the task sees have no effect; damping makes them none and does not change where the rounds end
    H += DAMPING * float(np.abs(np.diag(H)).max()) * np.eye(k * d)
    G, *rooms = _limit_rows(own, course, maps, at, inset)
    c = _within(H, g, *_limited(_rows(G, d * first, k * d), rooms))
    if c is None:
        return None
    r = (scale * c).reshape(k, d)

    def applied(*terms: tuple[Any, Any]) -> NDArray[np.float64]:
        return np.asarray(np.sum([np.einsum("iab,ib->ia", p, b @ r) for p, b in terms], axis=0))

    return [applied((P, B)), applied((P, Bd), (Pd, B)), applied((P, Bdd), (2.0 * Pd, Bd), (Pdd, B))]


def _near(basis: tuple[NDArray[np.float64], ...], at: NDArray[np.int64]) -> tuple[NDArray[np.int64], list[NDArray[np.float64]]]:
    """The first of the four splines (instants,) that are not zero at an instant, and these with their derivatives."""
    found = [one[at] for one in basis]
    count = found[0].shape[1]
    wide = min(4, count)
    first = np.minimum(np.argmax(np.any(np.array(found) != 0.0, axis=0), axis=1), count - wide)
    places = first[:, None] + np.arange(wide)
    return first, [np.take_along_axis(one, places, axis=1) for one in found]


def _rows(blocks: NDArray[np.float64], first: NDArray[np.int64], size: int) -> Any:
    """Sparse rows of blocks (instants, m, b) on unknowns (size,), each from `first` (instants,) on."""
    from scipy.sparse import csr_array

    n, m, b = blocks.shape
    columns = np.broadcast_to((first[:, None] + np.arange(b))[:, None], blocks.shape)
    return csr_array((blocks.reshape(-1), columns.reshape(-1), np.arange(0, n * m * b + 1, b)), shape=(n * m, size))


def _limited(rows: Any, rooms: list[NDArray[np.float64]]) -> tuple[Any, NDArray[np.float64]]:
    """G and h of G c <= h: rows c <= rooms[0] and -rows c <= rooms[1], those without a limit left out."""
    from scipy.sparse import vstack

    flat = [one.reshape(-1) for one in rooms]
    pick = [np.flatnonzero(np.isfinite(one)) for one in flat]
    G = vstack([rows[pick[0]], -rows[pick[1]]], format="csr")
    return G, np.concatenate([one[some] for one, some in zip(flat, pick, strict=True)])


def _limit_rows(
    own: _Task, course: _Course, maps: Any, at: NDArray[np.int64], inset: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Blocks (instants, m, b) of rows G, and the largest values (instants, m) of G c and of -G c, infinite without a limit.

    In units of each limit, drives in units of the shortest bar.
    """
    scale, drives = own.given.scale, own.given.drives
    G, most, least_room = [], [], []
    for k, limit in ((1, own.limits.rate), (2, own.limits.acceleration)):
        some = np.isfinite(limit)
        now = course.drive[k][np.ix_(at, some)] / limit[some]
        G.append(maps[k][:, some] * (scale / limit[some])[:, None])
        most.append(1.0 - inset - now)
        least_room.append(1.0 - inset + now)
    G.append(maps[0])
    for sign, bound, found in ((1.0, drives.upper, most), (-1.0, drives.lower, least_room)):
        room = sign * (bound - course.drive[0][at]) / scale
        found.append(room - np.clip(room[0], 0.0, EDGE))
    return np.concatenate(G, axis=1), np.concatenate(most, axis=1), np.concatenate(least_room, axis=1)


def _within(H: Any, g: Any, G: Any, h: Any) -> NDArray[np.float64] | None:
    """The least of the quadratic function with G c <= h, or with the least common excess u of all rows."""
    from scipy.sparse import hstack, vstack

    n = len(g)
    # least u >= 0 with G c - u <= h; a small multiple of H makes c unique
    wider = np.zeros((n + 1, n + 1))
    wider[:n, :n], wider[n, n] = 1e-6 * H + 1e-12 * np.eye(n), 1e-9
    last = np.append(np.zeros(n), 1.0)
    eased = vstack([hstack([G, -np.ones((len(h), 1))]), -last[None]])
    first = least_quadratic(wider, last, eased, np.append(h, 0.0))[0][:n]
    if not np.isfinite(first).all():
        return None
    excess = max(0.0, float((G @ first - h).max()))
    found, good = least_quadratic(H, g, G, h + excess + 0.1 * EDGE)
    return found if good else first


def _projectors(own: _Task, course: _Course) -> tuple[NDArray[np.float64], ...]:
    """P = 1 - W^-1 A^T (A W^-1 A^T)^-1 A (times, d, d) of the drives that are not held, with its first two derivatives."""
    given, state = own.given, own.state
    free = given.drives.held != 3
    inverse = np.where(free, 1.0 / given.drives.weight, 0.0)
    n, d = course.drive[0].shape
    P = np.empty((n, d, d))
    for i in range(n):
        here = replace(state, x=course.x[i], q=course.drive[0][i])
        A = given.linear(here, own.parameters[0, i])[1]
        back = inverse[:, None] * A.T
        P[i] = np.diag(free.astype(float)) - back @ np.linalg.pinv(A @ back) @ (A * free)
    return tuple(one.reshape(n, d, d) for one in spline(own.t, own.t, P.reshape(n, -1)))
