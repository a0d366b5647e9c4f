"""The solvers that search: SLSQP and trust-constr of SciPy, MMA of NLopt, and a sequence of linear programs by HiGHS.

All see scaled variables z between 0 and 1, an objective of the size 1 and limits as g <= 0, each divided by its size.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from scipy.optimize import Bounds, NonlinearConstraint, linprog, minimize

from kinetruss.design.optimum.certificate import worst_of_families
from kinetruss.design.optimum.evaluations import FEASIBLE, BeyondError, Evaluations, OutsideError
from kinetruss.errors import AnalysisError, InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

Method = Literal["slsqp", "trust-constr", "mma", "highs"]
SHORTEST = 1e-4
"""Reach of a search, of the range of a variable, at which it ends between values that are not known."""
FAR = 1.0
"""Excess, of the size of a limit, from which on a place without gradient is left again."""
PENALTY = 10.0
"""Of an excess of 1 over an objective of 1, at the beginning of a sequence of linear programs."""


def joining(asked: Evaluations, p: NDArray[np.float64], rows: NDArray[np.int64]) -> NDArray[np.int64]:
    """The limits that are exceeded at a point and not among these."""
    return np.setdiff1d(worst_of_families(asked.values(p)[1], asked.problem.family, -FEASIBLE), rows)


class Scaled:
    """The problem as solvers see it, with some rows of its limits."""

    def __init__(self, asked: Evaluations, rows: NDArray[np.int64], start: NDArray[np.float64]) -> None:
        self.asked, self.rows = asked, rows
        self.whole = len(rows) == len(asked.problem.limits)
        self.size = abs(self.at(start)[0]) or 1.0

    def at(self, z: NDArray[np.float64]) -> tuple[float, NDArray[np.float64]]:
        """Objective, not divided by its size, and excess (rows,)."""
        found, excess = self.asked.values(self.asked.problem.real(np.asarray(z)), None if self.whole else self.rows)
        return found, excess

    def objective(self, z: NDArray[np.float64]) -> float:
        """Of the size 1."""
        return self.at(z)[0] / self.size

    def slope(self, z: NDArray[np.float64]) -> NDArray[np.float64]:
        """Its derivatives (n,)."""
        return self.slopes(z)[0] / self.size

    def slopes(self, z: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Derivatives of objective and excess."""
        return self.asked.gradients(self.asked.problem.real(np.asarray(z)), self.rows)


def search(
    asked: Evaluations, rows: NDArray[np.int64], z: NDArray[np.float64], method: Method, iterations: int, tolerance: float
) -> tuple[NDArray[np.float64], str]:
    """The place (n,) where a solver ends that starts at z, and what it says."""
    return _SOLVERS[method](Scaled(asked, rows, z), z, iterations, tolerance)


def _slsqp(scaled: Scaled, z: NDArray[np.float64], iterations: int, tolerance: float) -> tuple[NDArray[np.float64], str]:
    """From where a step led to a place without gradient, or where the analysis fails, it goes back, and on with shorter reach,
    if no limits are to join.
    """
    reach, known, problem = 1.0, z, scaled.asked.problem
    beyond: BeyondError | None = None

    def slopes(z: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        nonlocal known
        worst = scaled.at(z)[1].max(initial=0.0)
        try:
            found = scaled.slopes(z)
        except BeyondError:
            raise
        except AnalysisError:
            if worst > FAR:
                raise BeyondError(problem.real(np.asarray(z))) from None
            raise
        known = np.array(z)
        return found

    limits: Any = {"type": "ineq", "fun": lambda z: -scaled.at(z)[1], "jac": lambda z: -slopes(z)[1]}
    while reach > SHORTEST:
        z = known
        low, high = np.clip(z - reach, 0.0, 1.0), np.clip(z + reach, 0.0, 1.0)
        try:
            found = minimize(
                scaled.objective, z, jac=lambda z: slopes(z)[0] / scaled.size, method="SLSQP",
                bounds=list(zip(low, high, strict=True)), constraints=[limits] if len(scaled.rows) else [],
                options={"maxiter": iterations, "ftol": tolerance},
            )  # fmt: skip
        except BeyondError as error:
            if not isinstance(error, OutsideError) and len(joining(scaled.asked, error.p, scaled.rows)):
                raise
            reach, beyond = 0.5 * reach, error
            continue
        end = np.clip(found.x, low, high)
        short = ((end <= low + SHORTEST * reach) & (low > 0.0)) | ((end >= high - SHORTEST * reach) & (high < 1.0))
        if not short.any():
            return end, str(found.message)
        known = end
    assert beyond is not None  # noqa: S101 - the reach was shortened
    raise beyond


def _trust(scaled: Scaled, z: NDArray[np.float64], iterations: int, tolerance: float) -> tuple[NDArray[np.float64], str]:
    limits = NonlinearConstraint(lambda z: scaled.at(z)[1], -np.inf, 0.0, jac=lambda z: scaled.slopes(z)[1])
    options = {"maxiter": iterations, "gtol": tolerance, "xtol": tolerance, "barrier_tol": tolerance}
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "delta_grad == 0.0")  # of an objective that is linear
        found = minimize(
            scaled.objective, z, jac=scaled.slope, method="trust-constr", bounds=Bounds(0.0, 1.0, keep_feasible=True),
            constraints=[limits] if len(scaled.rows) else [], options=options,
        )  # fmt: skip
    return np.clip(found.x, 0.0, 1.0), str(found.message)


def _mma(scaled: Scaled, z: NDArray[np.float64], iterations: int, tolerance: float) -> tuple[NDArray[np.float64], str]:
    """The method of moving asymptotes in its convergent form (Svanberg, SIAM J. Optim. 12 (2002) 555)."""
    try:
        import nlopt
    except ImportError:
        raise InputError("The method mma needs NLopt: pip install 'kinetruss[optimum]'. Or take slsqp.") from None
    solver = nlopt.opt(nlopt.LD_MMA, len(z))

    def objective(z: Any, slope: Any) -> float:
        if slope.size:
            slope[:] = scaled.slope(z.copy())
        return scaled.objective(z.copy())

    def limits(result: Any, z: Any, slope: Any) -> None:
        result[:] = scaled.at(z.copy())[1]
        if slope.size:
            slope[:] = scaled.slopes(z.copy())[1]

    solver.set_min_objective(objective)
    if len(scaled.rows):
        solver.add_inequality_mconstraint(limits, np.full(len(scaled.rows), 0.1 * FEASIBLE))
    solver.set_lower_bounds(np.zeros(len(z)))
    solver.set_upper_bounds(np.ones(len(z)))
    solver.set_ftol_rel(tolerance)
    solver.set_xtol_rel(1e-3 * tolerance)
    solver.set_maxeval(iterations)
    try:
        found = solver.optimize(z.copy())
    except nlopt.RoundoffLimited:
        found = np.asarray(z)
    return np.clip(found, 0.0, 1.0), f"NLopt ended with {solver.last_optimize_result()}"


def _linear_programs(
    scaled: Scaled, z: NDArray[np.float64], iterations: int, tolerance: float
) -> tuple[NDArray[np.float64], str]:
    """Steps to the optimum of the linearised problem within a region of trust (Fletcher and Sainz de la Maza, Math. Program. 43
    (1989) 235). A linear problem is solved by its first step, wherever it starts.
    """
    reach, penalty, said = 1.0, PENALTY, "it took as many steps as were allowed"
    value, excess = scaled.at(z)
    for _ in range(iterations):
        slope_f, slope_g = scaled.slopes(z)
        step, slack, price = _step(slope_f / scaled.size, slope_g, excess, z, reach, penalty)
        penalty = max(penalty, 2 * price)
        merit = value / scaled.size + penalty * max(float(excess.max(initial=0.0)), 0.0)
        expected = merit - (value + slope_f @ step) / scaled.size - penalty * slack
        try:
            new_value, new_excess = scaled.at(z + step)
            gained = merit - new_value / scaled.size - penalty * max(float(new_excess.max(initial=0.0)), 0.0)
        except OutsideError:
            gained = -np.inf
        if expected <= tolerance:
            return z, "no linear step is better"
        if gained > 0.1 * expected:
            z, value, excess = np.clip(z + step, 0.0, 1.0), new_value, new_excess
            reach = min(2 * reach, 1.0) if gained > 0.75 * expected else reach
        else:
            reach = 0.3 * float(np.abs(step).max())
        if reach < 1e-12:
            return z, "the region of trust has closed"
    return z, said


def _step(
    slope_f: NDArray[np.float64], slope_g: NDArray[np.float64], excess: NDArray[np.float64], z: NDArray[np.float64],
    reach: float, penalty: float,
) -> tuple[NDArray[np.float64], float, float]:  # fmt: skip
    """The best step, the excess that is left by it, and the sum of the prices of the limits."""
    n = len(z)
    A = np.hstack([slope_g, -np.ones((len(slope_g), 1))]) if len(slope_g) else None
    bounds = [*zip(np.maximum(-reach, -z), np.minimum(reach, 1 - z), strict=True), (0.0, None)]
    found = linprog(np.append(slope_f, penalty), A_ub=A, b_ub=-excess if len(slope_g) else None, bounds=bounds, method="highs")
    if found.x is None:
        return np.zeros(n), max(float(excess.max(initial=0.0)), 0.0), 0.0
    price = float(-found.ineqlin.marginals.sum()) if len(slope_g) else 0.0
    return found.x[:n], float(found.x[n]), price if found.x[n] > 0 else 0.0


_SOLVERS: dict[str, Callable[..., tuple[NDArray[np.float64], str]]] = {
    "slsqp": _slsqp,
    "trust-constr": _trust,
    "mma": _mma,
    "highs": _linear_programs,
}
METHODS = tuple(_SOLVERS)
