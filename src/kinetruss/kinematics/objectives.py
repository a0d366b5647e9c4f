"""Objectives of redundant drives without a closed form: what they cost, their least values, and along a motion."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kinematics.drive_limits import holding, holding_rates
from kinetruss.kinematics.task_problem import MET, Problem, State
from kinetruss.kinematics.time_tables import monotone
from kinetruss.mechanics.quadratic import least_quadratic

if TYPE_CHECKING:
    from numpy.typing import NDArray


STEP = 1e-5
"""Of central differences, as a fraction of the shortest bar, or in rad."""


class Cost(Protocol):
    """An objective, of order one at the start, and its derivatives by the drives."""

    def value(self, state: State) -> float:
        """The objective at a state."""

    def slope(self, state: State) -> tuple[NDArray[np.float64], NDArray[np.float64] | None]:
        """Its derivatives (d,) by the drives, and a positive (d, d) approximation of the second ones, or None."""


def cost_of(given: Problem, objective: str, parameters: NDArray[np.float64]) -> Cost:
    """The objective of a problem with parameters (p,) of its tasks.

    Raises
    ------
    InputError : effort without forces.
    """
    if objective == "conditioning":
        return Conditioning(given=given, parameters=parameters)
    forces = holding(given.system)
    cost = Effort(given=given, parameters=parameters, forces=forces, rates=holding_rates(given.system), unit=1.0)
    unit = cost.value(given.begin)
    if not unit > 0:
        raise InputError("No forces act on the drives, so there is no effort to keep small. Give gravity or loads.")
    return Effort(given=given, parameters=parameters, forces=forces, rates=cost.rates, unit=unit)


@dataclass(frozen=True, kw_only=True, eq=False)
class Conditioning:
    """-log sqrt det A W^-1 A^T: manipulability (Yoshikawa, 1985), A the derivatives of the tasks by the drives."""

    given: Problem
    parameters: NDArray[np.float64]

    def value(self, state: State) -> float:
        """The objective at a state."""
        sizes = np.linalg.svd(self._weighted(self.given.linear(state, self.parameters)[1]), compute_uv=False)
        return float(-np.log(np.maximum(sizes, 1e-300)).sum())

    def slope(self, state: State) -> tuple[NDArray[np.float64], None]:
        """Derivatives -tr(A+ dA), A+ the pseudoinverse; dA by central differences."""
        given = self.given
        free = given.drives.held != 3
        inverse = np.linalg.pinv(self._weighted(given.linear(state, self.parameters)[1]))
        change = np.diag(given.units)[free] * STEP
        A = self._weighted(given.linears(state, state.q + np.vstack([change, -change]), self.parameters))
        found, count = np.zeros(len(state.q)), len(change)
        found[free] = -np.einsum("dt,ktd->k", inverse, A[:count] - A[count:]) / (2 * STEP * given.units[free])
        return found, None

    def _weighted(self, A: NDArray[np.float64]) -> NDArray[np.float64]:
        """A W^-1/2 of the free drives."""
        free = self.given.drives.held != 3
        return np.asarray(A[..., free] / np.sqrt(self.given.drives.weight[free]))


@dataclass(frozen=True, kw_only=True, eq=False)
class Effort:
    """Sum of w F^2 of the drive forces at rest over its value at the start."""

    given: Problem
    parameters: NDArray[np.float64]
    forces: Any
    rates: Any
    unit: float

    def value(self, state: State) -> float:
        """The objective at a state."""
        return float(self._weight @ self.forces(state.x[None])[0] ** 2) / self.unit

    def slope(self, state: State) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Derivatives 2 F^T W dF, and 2 dF^T W dF, the second ones without the curvature of F (Gauss and Newton)."""
        F, change = self.rates(state.x) if self.rates is not None else self._differences(state)
        weighted = 2.0 * self._weight[:, None] * change / self.unit
        return np.asarray(F @ weighted), np.asarray(change.T @ weighted)

    @property
    def _weight(self) -> NDArray[np.float64]:
        return np.where(self.given.drives.held != 3, self.given.drives.weight, 0.0)

    def _differences(self, state: State) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """F (d,) and dF/dq (d, d), by central differences."""
        step = np.diag(self.given.units) * STEP
        x = self.given.positions(state, state.q + np.vstack([0 * state.q[None], step, -step]), self.parameters)
        F, count = self.forces(x), len(state.q)
        return F[0], np.asarray((F[1 : count + 1] - F[count + 1 :]).T / (2 * STEP * self.given.units))


def bounded_least(
    B: NDArray[np.float64], g: NDArray[np.float64], A: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64]
) -> NDArray[np.float64]:
    """p (n,) of least p^T B p/2 + g^T p with A p = 0 and low <= p <= high, where low <= 0 <= high.

    B (n, n) positive definite; A (m, n).
    """
    if not g.any():
        return np.zeros(len(g))
    # in units in which B and g are 1: steps become small where the objective is least
    one, n = float(np.abs(g).max() / np.abs(B).max()), np.eye(len(g))
    G, h = np.vstack([A, n, -n]), np.concatenate([np.zeros(len(A)), high / one, -low / one])
    bounded = np.isfinite(h)
    u = least_quadratic(B / np.abs(B).max(), g / np.abs(g).max(), G[bounded], h[bounded], equal=len(A))[0]
    return np.clip(one * u, low, high)


# The least of an objective among the drives that meet the tasks: sequential quadratic programming on their surface.
#
# A step is least for a quadratic model of the objective, along the surface to first order, within the strokes and a trust
# region (Conn, Gould and Toint, 2000); the nearest drives that meet the tasks follow it. So every state on the way meets
# them.

FIRST, LARGEST, SMALLEST = 0.2, 0.5, 1e-6
"""Trust region at first, at most and at the end, in units of the shortest bar, or rad."""
STEPS = 200
"""Steps at most."""
FLAT = 1e-11
"""Expected fall of the objective in one step that counts as none."""
ENOUGH, GOOD = 0.05, 0.7
"""Shares of the expected fall with which a step is taken, and the trust region grows."""
REST = 1e-6
"""Smallest curvature of the model, as a share of the largest."""


def descended(
    given: Problem,
    parameters: NDArray[np.float64],
    state: State,
    cost: Cost,
    model: Curvature,
    room: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> tuple[State, bool]:
    """Drives of least cost that meet the tasks, from drives that meet them; and whether it was found that no way leads down.

    model : of second derivatives, that learns on the way. room : least and largest values (d,) of the drives.
    """
    if np.count_nonzero(given.drives.held != 3) <= len(given.tasks.labels):
        return state, True
    value, box = cost.value(state), FIRST
    slope, A = _seen(given, parameters, state, cost, model)
    for _ in range(STEPS):
        step = _step(given, state, (slope, A, model.matrix), room, box)
        fall = -float(slope @ step + 0.5 * step @ model.matrix @ step)
        if fall <= FLAT * max(1.0, abs(value)):
            return state, True
        found = _onto(given, parameters, state, step)
        lower = value if found is None else cost.value(found)
        size = float(np.abs(step).max())
        if found is None or not value - lower >= ENOUGH * fall:
            box = 0.3 * min(size, box)
            if box < SMALLEST:
                return state, False
            continue
        if value - lower >= GOOD * fall and size > 0.9 * box:
            box = min(2.0 * box, LARGEST)
        before, old, state, value = state, (slope, A), found, lower
        slope, A = _seen(given, parameters, state, cost, model)
        model.learn((state.q - before.q) / given.units, old, (slope, A))
    return state, False


class Curvature:
    """Second derivatives (d, d) of the objective along the surface of the tasks, positive, in units of the drives.

    Those that the objective knows, and what the steps show besides (BFGS; damped: Powell, 1978).
    """

    def __init__(self, given: Problem) -> None:
        self.matrix: NDArray[np.float64] = np.eye(len(given.reference))
        self.fresh = True
        self.free = given.drives.held != 3

    def start(self, known: NDArray[np.float64] | None) -> None:
        """Begin with what the objective knows."""
        if self.fresh and known is not None:
            self.matrix = known + REST * np.abs(known).max() * np.eye(len(known))
            self.fresh = False

    def learn(
        self,
        step: NDArray[np.float64],
        old: tuple[NDArray[np.float64], NDArray[np.float64]],
        new: tuple[NDArray[np.float64], NDArray[np.float64]],
    ) -> None:
        """See how the gradient of the Lagrangian changed along a step."""
        free, s = self.free, np.where(self.free, step, 0.0)
        factors = np.linalg.lstsq(new[1][:, free].T, new[0][free], rcond=None)[0]
        y = np.where(free, (new[0] - new[1].T @ factors) - (old[0] - old[1].T @ factors), 0.0)
        if (along := float(s @ y)) > 0 and self.fresh:
            self.matrix, self.fresh = np.eye(len(s)) * float(y @ y) / along, False
        Bs = self.matrix @ s
        curved = float(s @ Bs)
        if not curved > 0:
            return
        if along < 0.2 * curved:
            share = 0.8 * curved / (curved - along)
            y = share * y + (1 - share) * Bs
        self.matrix = self.matrix - np.outer(Bs, Bs) / curved + np.outer(y, y) / float(s @ y)


def _seen(
    given: Problem, parameters: NDArray[np.float64], state: State, cost: Cost, model: Curvature
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Slopes (d,) of the objective and derivatives (m, d) of the tasks at a state, in units of the drives."""
    slope, known = cost.slope(state)
    model.start(None if known is None else given.units[:, None] * known * given.units)
    return slope * given.units, given.linear(state, parameters)[1] * given.units / given.scale


def _step(
    given: Problem,
    state: State,
    seen: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
    room: tuple[NDArray[np.float64], NDArray[np.float64]],
    box: float,
) -> NDArray[np.float64]:
    """The step (d,) of least quadratic model along the tasks, in units of the drives."""
    free = np.flatnonzero(given.drives.held != 3)
    slope, A, B = seen
    low = np.clip((room[0] - state.q)[free] / given.units[free], -box, 0.0)
    high = np.clip((room[1] - state.q)[free] / given.units[free], 0.0, box)
    step = np.zeros(len(state.q))
    step[free] = bounded_least(B[np.ix_(free, free)], slope[free], A[:, free], low, high)
    return step


def _onto(given: Problem, parameters: NDArray[np.float64], state: State, step: NDArray[np.float64]) -> State | None:
    """The drives nearest to those behind a step that meet the tasks; None where none is found."""
    wanted = state.q + step * given.units
    start = given.near(state, wanted, parameters)
    if start is None:
        return None
    settled = replace(given, reference=wanted).reach(parameters, start, starts=1)
    return settled if settled.far <= MET * given.scale else None


# Objectives that have no closed form along a motion: drives that are best at knots, and a curve through them to be near to.
#
# At knots f(q) is least with the tasks met and strokes kept (`descent`); between them the drives are those that meet the tasks
# and are nearest to the monotone curve through the knots.

KNOTTED = ("least_effort", "conditioning")
KNOTS, CLOSER = 9, 33
"""Knots of a motion, for objectives that take long and for others."""
ROOM = 0.5
"""Largest change of a length without limits, in units of the shortest bar (of an angle: a quarter turn); a minimum beyond
counts as none."""


def knots_of(t: NDArray[np.float64], count: int = KNOTS) -> NDArray[np.int64]:
    """Samples at which drives are chosen."""
    return np.unique(np.round(np.linspace(0, len(t) - 1, count)).astype(np.int64))


def reference_along(
    given: Problem, t: NDArray[np.float64], parameters: Any, state: State, objective: str
) -> tuple[NDArray[np.float64], State]:
    """Taylor coefficients (3, times, d) of what drives are to be near to, and the state at the start.

    Raises
    ------
    InputError : a knot that is not reached, an objective without a minimum.
    """
    at, found, model = knots_of(t), [], Curvature(given)
    for k in at:
        # from the best drives before, not from those of the model
        if (state := replace(given, reference=state.q.copy()).reach(parameters[0, k], state)).far > MET * given.scale:
            raise InputError(
                f"At t = {t[k]:g} s no drives that meet the task are found from the best ones before. Give the drives "
                "limits, or hold some of them; the objective 'least_change' says whether the task is within reach."
            )
        try:
            state = best_state(given, parameters[0, k], state, objective, model)
        except InputError as error:
            raise InputError(f"At t = {t[k]:g} s: {error}") from None
        found.append(state)
    return _curve(t, at, np.stack([one.q for one in found])), found[0]


def nearest_along(given: Problem, t: NDArray[np.float64], parameters: Any, state: State) -> NDArray[np.float64] | None:
    """Taylor coefficients (3, times, d) of a curve of drives each nearest to those before; None if one is not reached.

    state : that meets the tasks at the start.
    """
    at, found = knots_of(t, CLOSER), [state.q]
    for k in at[1:]:
        state = replace(given, reference=state.q.copy()).reach(parameters[0, k], state, starts=1)
        if state.far > MET * given.scale:
            return None
        found.append(state.q)
    return _curve(t, at, np.stack(found))


def _curve(t: NDArray[np.float64], at: NDArray[np.int64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Taylor coefficients (3, times, d) of the curve through values (knots, d) at the samples `at`."""
    if len(at) < 2:
        return np.stack([values, 0 * values, 0 * values])
    # a curve that overshoots would take drives past their strokes
    curve = monotone(t[at], values)
    return np.stack([curve(t), curve(t, 1), 0.5 * curve(t, 2)])


def best_state(
    given: Problem, parameters: NDArray[np.float64], state: State, objective: str, model: Curvature | None = None
) -> State:
    """The drives of least objective that meet the tasks, from drives that meet them: the least that is found from there.

    model : of the second derivatives, if there is one from a pose before.

    Raises
    ------
    InputError : it still falls where a drive without limits is farthest from its own value (`ROOM`), so it has no minimum.
    """
    cost = cost_of(given, objective, parameters)
    state, _ = descended(given, parameters, state, cost, model or Curvature(given), _room(given))
    _refuse_endless(given, state, objective)
    return state


def _room(given: Problem) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Least and largest values of the drives: their strokes, and of those without limits `ROOM` about the start."""
    lower, upper, own = given.drives.lower, given.drives.upper, given.begin.q
    room = np.where(given.turning, 0.5 * np.pi, ROOM * given.scale)
    return np.where(np.isfinite(lower), lower, own - room), np.where(np.isfinite(upper), upper, own + room)


def _refuse_endless(given: Problem, state: State, objective: str) -> None:
    lower, upper = _room(given)
    limited = np.isfinite(given.drives.lower) & np.isfinite(given.drives.upper)
    edge = np.minimum(state.q - lower, upper - state.q) < 1e-6 * given.units
    if len(over := np.flatnonzero(edge & ~limited & (given.drives.held != 3))):
        names = ", ".join(f"{given.system.drives[d]} {state.q[d]:.4g} (start {given.begin.q[d]:.4g})" for d in over)
        raise InputError(
            f"The objective {objective!r} has no minimum near by: it still falls at {names}. Give the drives limits, or hold "
            "some of them."
        )
