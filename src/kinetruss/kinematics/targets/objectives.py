"""Objectives that have no closed form along a motion: drives that are best at knots, and a curve through them to be near to.

At knots f(q) is least with the tasks met and strokes kept (sequential quadratic programming: Kraft, 1988, as in SciPy's SLSQP);
between them the drives are those that meet the tasks and are nearest to the spline through the knots.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.motion.profiles import spline
from kinetruss.kinematics.limited.holding import holding, holding_rates
from kinetruss.kinematics.targets.solve import MET, Problem, State, drive_path

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["KNOTTED", "best_state", "knots_of", "reference_along"]

KNOTTED = ("least_effort", "conditioning")
KNOTS = 9
"""Knots of a motion."""
ROOM = 0.5
"""Largest change of a length without limits, in units of the shortest bar (of an angle: a quarter turn); a minimum beyond
counts as none."""
FAR, SMALLEST_BOX = 0.2, 1e-4
"""Trust region of one step, at first and at the end, in units of the shortest bar, or rad."""
STEPS = 30
"""Steps at a knot at most."""
FLAT = 1e-9
"""Fall of the objective in one step that counts as none."""
CLOSE = 1e-2
"""Change of drives, in units of the shortest bar, or rad, up to which positions follow without continuation."""
STEP = 1e-5
"""Of central differences of the objective, as a fraction of the shortest bar."""


def knots_of(t: NDArray[np.float64]) -> NDArray[np.int64]:
    """Samples at which the objective is minimised."""
    return np.unique(np.round(np.linspace(0, len(t) - 1, KNOTS)).astype(np.int64))


def reference_along(
    given: Problem, t: NDArray[np.float64], parameters: Any, state: State, objective: str
) -> tuple[NDArray[np.float64], State]:
    """Taylor coefficients (3, times, d) of what drives are to be near to, and the state at the start.

    Raises
    ------
    InputError : a knot that is not reached, an objective without a minimum.
    """
    at, found = knots_of(t), []
    for k in at:
        if (state := given.reach(parameters[0, k], state)).far > MET * given.scale:
            raise InputError(
                f"At t = {t[k]:g} s no drives that meet the task are found from the best ones before. Give the drives "
                "limits, or hold some of them; the objective 'least_change' says whether the task is within reach."
            )
        try:
            state = best_state(given, parameters[0, k], state, objective)
        except InputError as error:
            raise InputError(f"At t = {t[k]:g} s: {error}") from None
        found.append(state)
    values = np.stack([one.q for one in found])
    if len(at) < 2:
        return np.stack([values, 0 * values, 0 * values]), found[0]
    value, rate, second = spline(t, t[at], values)
    return np.stack([value, rate, 0.5 * second]), found[0]


def best_state(given: Problem, parameters: NDArray[np.float64], state: State, objective: str) -> State:
    """The drives of least objective that meet the tasks, from drives that meet them.

    Steps within a trust region, halved where a step fails, until the objective no longer falls.

    Raises
    ------
    InputError : it still falls where a drive without limits is farthest from its own value (`ROOM`), so it has no minimum.
    """
    costs, box = _costs(given, objective, parameters), FAR
    cost = costs[0]
    value = cost([state])[0]
    for _ in range(STEPS):
        found = _stepped(given, parameters, state, costs, box)
        lower = value if found is None else cost([found])[0]
        if found is None or not lower < value:
            box *= 0.25
            if box < SMALLEST_BOX:
                break
            continue
        flat = value - lower <= FLAT * max(1.0, abs(value))
        state, value = found, lower
        if flat:
            break
    _refuse_endless(given, state, objective)
    return state


def _stepped(given: Problem, parameters: NDArray[np.float64], start: State, costs: Any, box: float) -> State | None:
    """Drives of least objective that meet the tasks, no farther from given ones than a box; None where none is found."""
    from scipy.optimize import minimize

    free, scale = np.flatnonzero(given.drives.held != 3), given.scale
    units, last = given.units[free], [start]
    cost, exact = costs

    def at(u: NDArray[np.float64]) -> State:
        q = start.q.copy()
        q[free] += units * u
        if not np.array_equal(q, last[0].q):
            last[0] = _moved(given, last[0], q, parameters)
        return last[0]

    def slope(u: NDArray[np.float64]) -> NDArray[np.float64]:
        here, shifts = at(u), np.vstack([np.diag(units), -np.diag(units)]) * STEP
        if exact is not None:
            return np.asarray(units * exact(here)[free])
        pairs = np.tile(here.q, (len(shifts), 1))
        pairs[:, free] += shifts
        values = cost([_moved(given, here, q, parameters) for q in pairs])
        return np.asarray((values[: len(u)] - values[len(u) :]) / (2 * STEP))

    limits = np.stack(_room(given))[:, free]
    within = np.clip((limits - start.q[free]) / units, -box, box)
    tasks = {
        "type": "eq",
        "fun": lambda u: given.linear(at(u), parameters)[0] / scale,
        "jac": lambda u: given.linear(at(u), parameters)[1][:, free] * units / scale,
    }
    try:
        found = minimize(lambda u: cost([at(u)])[0], np.zeros(len(free)), jac=slope, bounds=within.T, constraints=[tasks],
                         method="SLSQP", options={"maxiter": 60, "ftol": 1e-12})  # fmt: skip
        best = at(found.x)
    except FloatingPointError:
        return None
    # exactly onto the tasks, by the least change from there
    near = replace(given, reference=best.q.copy())
    settled = near.reach(parameters, best, starts=1)
    return settled if settled.far <= MET * scale else None


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


def _moved(given: Problem, near: State, q: NDArray[np.float64], parameters: NDArray[np.float64]) -> State:
    """The state of other drives, from one near by.

    Raises
    ------
    FloatingPointError : the structure cannot be closed with them.
    """
    if np.abs((q - near.q) / given.units).max() <= CLOSE:
        found = given.closed(near, q, parameters)
    else:
        x = drive_path(given.system, np.stack([near.q, q]), near.x)
        found = None if x is None else replace(near, x=x, q=q)
    if found is None:
        raise FloatingPointError
    return found


def _costs(given: Problem, objective: str, parameters: NDArray[np.float64]) -> Any:
    """The objective (k,) as a function of k states, of order one at the start; and its derivatives (d,) at a state, or None."""
    system, weight = given.system, given.drives.weight
    free = given.drives.held != 3
    if objective == "conditioning":

        def shape(states: list[State]) -> NDArray[np.float64]:
            # -log sqrt det A W^-1 A^T: manipulability (Yoshikawa, 1985)
            A = [given.linear(one, parameters)[1][:, free] / np.sqrt(weight[free]) for one in states]
            return np.asarray(-np.log(np.maximum(np.linalg.svd(np.stack(A), compute_uv=False), 1e-300)).sum(axis=1))

        return shape, None
    forces, rates = holding(system), holding_rates(system)

    def effort(states: list[State]) -> NDArray[np.float64]:
        F = forces(np.stack([one.x for one in states]))
        return np.asarray((weight * F**2)[:, free].sum(axis=1))

    unit = float(effort([given.begin])[0])
    if not unit > 0:
        raise InputError("No forces act on the drives, so there is no effort to keep small. Give gravity or loads.")

    def slope(state: State) -> NDArray[np.float64]:
        # d(sum of w F^2)/dq_j = 2 sum of w F_i dF_i/dq_j
        F, change = rates(state.x) if rates is not None else (np.zeros(0), np.zeros((0, 0)))
        return np.asarray(2.0 * (weight * F * free) @ change) / unit

    return lambda states: effort(states) / unit, slope if rates is not None else None
