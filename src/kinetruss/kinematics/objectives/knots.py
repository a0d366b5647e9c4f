"""Objectives that have no closed form along a motion: drives that are best at knots, and a curve through them to be near to.

At knots f(q) is least with the tasks met and strokes kept (`descent`); between them the drives are those that meet the tasks
and are nearest to the monotone curve through the knots.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kinematics.given.tables import monotone
from kinetruss.kinematics.objectives.costs import cost_of
from kinetruss.kinematics.objectives.descent import Curvature, descended
from kinetruss.kinematics.targets.solve import MET, Problem, State

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["KNOTTED", "best_state", "knots_of", "nearest_along", "reference_along"]

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
