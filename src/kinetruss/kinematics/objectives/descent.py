"""The least of an objective among the drives that meet the tasks: sequential quadratic programming on their surface.

A step is least for a quadratic model of the objective, along the surface to first order, within the strokes and a trust region
(Conn, Gould and Toint, 2000); the nearest drives that meet the tasks follow it. So every state on the way meets them.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kinematics.objectives.bounded import bounded_least
from kinetruss.kinematics.targets.solve import MET

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.objectives.costs import Cost
    from kinetruss.kinematics.targets.solve import Problem, State

__all__ = ["Curvature", "descended"]

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
