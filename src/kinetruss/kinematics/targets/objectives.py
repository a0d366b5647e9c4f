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
from kinetruss.kinematics.limited.holding import holding_forces
from kinetruss.kinematics.targets.solve import MET, Problem, State, drive_path

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["KNOTTED", "best_state", "knots_of", "reference_along"]

KNOTTED = ("least_effort", "conditioning")
KNOTS = 9
"""Knots of a motion."""
FAR = 0.5
"""Largest change of a drive at a knot, in units of the shortest bar."""
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
    InputError : a knot that is not reached.
    """
    at, found = knots_of(t), []
    for k in at:
        if (state := given.reach(parameters[0, k], state)).far > MET * given.scale:
            raise InputError(
                f"At t = {t[k]:g} s no drives that meet the task are found from the best ones before. Give the drives "
                "limits, or hold some of them; the objective 'least_change' says whether the task is within reach."
            )
        state = best_state(given, parameters[0, k], state, objective)
        found.append(state)
    values = np.stack([one.q for one in found])
    if len(at) < 2:
        return np.stack([values, 0 * values, 0 * values]), found[0]
    value, rate, second = spline(t, t[at], values)
    return np.stack([value, rate, 0.5 * second]), found[0]


def best_state(given: Problem, parameters: NDArray[np.float64], state: State, objective: str) -> State:
    """The drives of least objective that meet the tasks, from drives that meet them."""
    from scipy.optimize import minimize

    free = np.flatnonzero(given.drives.held != 3)
    cost, scale, start = _costs(given, objective, parameters), given.scale, state
    last = [state]

    def at(u: NDArray[np.float64]) -> State:
        q = start.q.copy()
        q[free] += scale * u
        if np.array_equal(q, last[0].q):
            return last[0]
        there = drive_path(given.system, np.stack([last[0].q, q]), last[0].x)
        if there is None:
            raise FloatingPointError
        last[0] = replace(start, x=there, q=q)
        return last[0]

    def slope(u: NDArray[np.float64]) -> NDArray[np.float64]:
        here, found = u.copy(), np.zeros(len(u))
        for k in range(len(u)):
            pair = []
            for sign in (1.0, -1.0):
                moved = here.copy()
                moved[k] += sign * STEP
                pair.append(cost(at(moved)))
            found[k] = (pair[0] - pair[1]) / (2 * STEP)
        return found

    limits = np.stack([given.drives.lower, given.drives.upper])[:, free]
    within = np.clip((limits - start.q[free]) / scale, -FAR, FAR)
    tasks = {
        "type": "eq",
        "fun": lambda u: given.linear(at(u), parameters)[0] / scale,
        "jac": lambda u: given.linear(at(u), parameters)[1][:, free],
    }
    options = {"maxiter": 60, "ftol": 1e-12}
    try:
        found = minimize(lambda u: cost(at(u)), np.zeros(len(free)), jac=slope, bounds=within.T, constraints=[tasks],
                         method="SLSQP", options=options)  # fmt: skip
        best = at(found.x)
    except FloatingPointError:
        return start
    # exactly onto the tasks, by the least change from there
    near = replace(given, reference=best.q.copy())
    settled = near.reach(parameters, best, tries=0)
    better = settled.far <= MET * scale and cost(settled) <= cost(start)
    return settled if better else start


def _costs(given: Problem, objective: str, parameters: NDArray[np.float64]) -> Any:
    """The objective as a function of the state; of order one at the start."""
    system, weight = given.system, given.drives.weight
    free = given.drives.held != 3
    if objective == "conditioning":

        def shape(state: State) -> float:
            # -log sqrt det A W^-1 A^T: manipulability (Yoshikawa, 1985)
            A = given.linear(state, parameters)[1][:, free] / np.sqrt(weight[free])
            return -float(np.log(np.maximum(np.linalg.svd(A, compute_uv=False), 1e-300)).sum())

        return shape

    def effort(state: State) -> float:
        F = holding_forces(system, state.x[None])[0]
        return float((weight * F**2)[free].sum())

    unit = effort(given.begin)
    if not unit > 0:
        raise InputError("No forces act on the drives, so there is no effort to keep small. Give gravity or loads.")
    return lambda state: effort(state) / unit
