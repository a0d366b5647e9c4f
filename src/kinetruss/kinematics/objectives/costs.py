"""What redundant drives cost: the effort at rest, and the distance from singular positions, with their derivatives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kinematics.limited.holding import holding, holding_rates

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.targets.solve import Problem, State

__all__ = ["Cost", "cost_of"]

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
