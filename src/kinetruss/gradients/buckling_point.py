"""`statics.buckling` at its solution: the state without the load, x and N, and what the load adds to first order, dx and dN.

r = (f(x) - J^T N,  phi(x),  F - K dx - J^T dN,  J dx)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError
from kinetruss.gradients.differences import Weighed
from kinetruss.gradients.eigenvalues import Eigenvalues
from kinetruss.gradients.equilibrium_point import EquilibriumPoint
from kinetruss.gradients.points import by_unknowns
from kinetruss.mechanics import System, constraint_jacobian
from kinetruss.mechanics.balance import Balance, balance_of
from kinetruss.mechanics.rows import null_basis
from kinetruss.statics.linear_buckling import by_load, factors_and_shapes, of_load
from kinetruss.statics.paths import scaled_force, scaled_loads, without

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


class BucklingPoint(Eigenvalues, EquilibriumPoint):
    """A `Point` of `statics.buckling`, with the arguments of that function."""

    name, unit, words = "load_factor", "", "load factor at which it buckles"

    def __init__(
        self,
        system: System,
        load: str | Mapping[str, float],
        *,
        start: Any = None,
        load_case: str | None = None,
        lengths: Mapping[str, float] | None = None,
        tasks: Mapping[str, Any] | None = None,
        modes: int = 6,
    ) -> None:
        self.load, self.case, self.left_out = load, load_case, (system.given, without(system, load, load_case))
        EquilibriumPoint.__init__(self, system, start, load_case, lengths=lengths, tasks=tasks)
        if self.reached.stability.negative or self.reached.stability.neutral:
            raise AnalysisError("The structure is unstable, or left free, already without the load. See statics.equilibrium.")
        x, balance, free = self.reached.x, self.balance, self.free
        K, J = balance.stiffness(x, self.reached.N)[free][:, free], constraint_jacobian(balance.system, x)[:, free]
        moved, added = by_load(balance, x, K, J, scaled_force(system, scaled_loads(system, load)))
        geometric, Z = of_load(balance, x, moved, added)[1][free][:, free], null_basis(J)
        self.values, shapes = factors_and_shapes(Z.T @ (K @ Z), Z.T @ (geometric @ Z))
        self.shown = min(modes, len(self.values))
        if not self.shown:
            raise AnalysisError("No factor of this load makes the structure unstable, so there is no factor to respond.")
        self.shapes, self.factor = Z @ shapes[:, : self.shown], self.values[: self.shown]
        left = K @ self.shapes + (geometric @ self.shapes) * self.factor
        self.rigid = np.linalg.lstsq(J.toarray().T, -left, rcond=None)[0]
        self.modal = -np.einsum("nk,nk->k", self.shapes, geometric @ self.shapes)
        self.at_terms = self.at
        moved, size = moved.reshape(-1)[free], self.size
        self.unknown = np.concatenate([self.unknown, moved, added])
        sizes = [np.full(len(one), float(np.abs(one).max(initial=0.0)) or 1.0) for one in (moved, added)]
        self.size, self.at = np.concatenate([size, *sizes]), np.tile(self.at, 2)
        self.row = self.at

    def forces(self, system: System) -> Balance:
        """The forces at rest without the load, with the numbers of a system."""
        given, left = self.left_out
        same = system.given is given
        own = replace(system, given=left.given, model=left.model) if same else without(system, self.load, self.case)
        return balance_of(own, self.case, self.tasks)

    def residual(self, system: System) -> Floats:
        """r at other numbers."""
        balance, push = self.forces(system), scaled_force(system, scaled_loads(system, self.load))
        return np.concatenate([self.left(balance, self.unknown), self._added(balance, self.unknown, push)])

    def _added(self, balance: Balance, unknown: Floats, push: Floats) -> Floats:
        """The part of r that says what the load adds."""
        held, free, count = balance.system, self.free, self.state
        x, N, _ = self.placed(held, unknown)
        dx, dN = unknown[count : count + len(free)], unknown[count + len(free) :]
        K, J = balance.stiffness(x, N)[free][:, free], constraint_jacobian(held, x)[:, free]
        return np.concatenate([push[free] - K @ dx - J.T @ dN, J @ dx])

    def transposed(self, right: Floats) -> Floats:
        """z: first of what the load adds, then of the state, on which that depends."""
        later = super().transposed(right[:, self.state :])
        push, row = self._push, self.row[self.state :]
        given = Weighed(lambda change: self._added(self.balance, self.unknown + change, push), later, row)
        first = right[:, : self.state] - by_unknowns(self, given)[:, : self.state]
        return np.concatenate([super().transposed(first), later], axis=1)

    @cached_property
    def _push(self) -> Floats:
        return scaled_force(self.system, scaled_loads(self.system, self.load))

    def refuse(self, seeds: Any) -> None:
        """Also repeated factors have no gradients."""
        self.refuse_repeated(seeds)
        EquilibriumPoint.refuse(self, seeds)

    def terms(self, system: System, unknown: Floats) -> Floats:
        """Of (K + s K_N) phi + J^T m = 0: ds = -(phi^T (dK + s dK_N) phi + 2 m^T dJ phi)/(phi^T K_N phi)."""
        balance, free, count = self.forces(system), self.free, self.state
        held = balance.system
        x, N, _ = self.placed(held, unknown)
        moved = np.zeros(x.size)
        moved[free] = unknown[count : count + len(free)]
        geometric = of_load(balance, x, moved.reshape(-1, 3), unknown[count + len(free) :])[1][free][:, free]
        K, J = balance.stiffness(x, N)[free][:, free], constraint_jacobian(held, x)[:, free]
        phi = self.shapes
        inner = phi * (K @ phi + (geometric @ phi) * self.factor)
        return np.asarray(np.concatenate([inner, 2 * self.rigid * (J @ phi)]) / self.modal).T
