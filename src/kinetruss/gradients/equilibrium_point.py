"""`statics.equilibrium` at its solution: positions x of the free coordinates, and forces N of the rows.

r = (f(x) - J^T N,  phi(x)),    z from the transposed tangent, which is not symmetric where loads turn with bodies
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, csc_array

from kinetruss.elements.kinds import present
from kinetruss.elements.scalars import Scalars
from kinetruss.errors import AnalysisError, few
from kinetruss.gradients.kinks import refuse_kinks
from kinetruss.gradients.nearness import site_of_rows, sites
from kinetruss.gradients.told import Told
from kinetruss.kernels.structure.element_table import ENERGY
from kinetruss.mechanics import System, constraint_jacobian, ends_of
from kinetruss.mechanics.arguments import number_of, positions_of
from kinetruss.mechanics.balance import Balance, balance_of
from kinetruss.mechanics.elements import named_motions
from kinetruss.mechanics.matrices import bar_laws
from kinetruss.mechanics.mode_texts import moves_text
from kinetruss.mechanics.rows import factors_of
from kinetruss.results import Result
from kinetruss.statics.active_set import PULLS, kinks_of
from kinetruss.statics.large_displacements import must_begin, prescribed_values, state_columns
from kinetruss.statics.saddle_point import rows_of
from kinetruss.statics.search import SearchResult, find_equilibrium, force_scale, row_errors
from kinetruss.statics.small_displacements import flexibility, stiff_rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


class EquilibriumPoint(Told):
    """A `Point` of `statics.equilibrium`, with the arguments of that function."""

    linear = False

    def __init__(
        self,
        system: System,
        start: Any = None,
        load_case: str | None = None,
        *,
        lengths: Mapping[str, float] | None = None,
        tasks: Mapping[str, Any] | None = None,
        time: float = 0.0,
        tolerance: float = 1e-13,
        max_steps: int = 500,
    ) -> None:
        self.system, self.case, self.tasks, self.time = system, load_case, tasks, number_of(time, "time", "s")
        self.start = start.whole["position"].values if isinstance(start, Result) else start
        self.lengths = lengths or {}
        balance = self.balance = self.forces(system)
        x, wanted, _ = must_begin(balance, self.start, self.lengths)
        self.reached: SearchResult = find_equilibrium(balance, x, wanted, tolerance, max_steps)
        if not self.reached.good:
            raise AnalysisError("There is no equilibrium near the start, so no response. See statics.equilibrium.")
        held = balance.system
        self.free = held.free
        self.unknown = np.concatenate([self.reached.x.reshape(-1)[self.free], self.reached.N])
        self.state = len(self.unknown)
        size = float(np.ptp(self.reached.x, axis=0).max()) / len(self.reached.x) ** 0.5 or 1.0
        force = float(np.abs(self.reached.N).max(initial=0.0)) or 1.0
        self.size = np.concatenate([np.full(len(self.free), size), np.full(len(self.reached.N), force)])
        node = sites(system)["node"]
        self.at = np.concatenate([np.repeat(node, 3)[self.free], site_of_rows(held)]).astype(np.int64)
        self.row = self.at

    def forces(self, system: System) -> Balance:
        """The forces at rest with the numbers of a system."""
        return balance_of(system, self.case, self.tasks, self.time)

    def placed(self, held: System, unknown: Floats) -> tuple[Floats, Floats, Floats]:
        """Positions (n, 3), row forces and prescribed values (rows,) of the rows with other numbers and unknowns."""
        x = positions_of(held, self.start)
        wanted, places = prescribed_values(held, x, self.lengths)
        places[self.free] = unknown[: len(self.free)]
        return places.reshape(x.shape), unknown[len(self.free) : self.state], wanted

    def residual(self, system: System) -> Floats:
        """r at other numbers."""
        return self.left(self.forces(system), self.unknown)

    def left(self, balance: Balance, unknown: Floats) -> Floats:
        """r with other forces and unknowns."""
        held = balance.system
        x, N, wanted = self.placed(held, unknown)
        pull = constraint_jacobian(held, x)[:, self.free].T @ N
        return np.concatenate([balance.applied(x)[self.free] - pull, row_errors(held, x, wanted)])

    def transposed(self, right: Floats) -> Floats:
        """z: of [[K, J^T], [J, 0]]^T (z_x, -z_N) = -right."""
        solve, size, count = *self.factors, len(self.free)
        scale = np.concatenate([np.full(count, size), np.ones(self.state - count)])
        found = np.array([-solve(one) for one in right / scale])
        found[:, count:] *= -size
        return found

    @cached_property
    def factors(self) -> tuple[Any, float]:
        """Solver of the transposed tangent with K over its size, and that size."""
        x, N, held = self.reached.x, self.reached.N, self.balance.system
        K = self.balance.stiffness(x, N)[self.free][:, self.free]
        J = constraint_jacobian(held, x)[:, self.free]
        size = float(np.abs(K.data).max(initial=0.0)) or 1.0
        matrix: Any = csc_array(block_array([[K / size, J.T], [J, None]]) if J.shape[0] else K / size).T.tocsc()
        factors = factors_of(matrix)
        if factors is None:
            raise AnalysisError(f"{_SINGULAR}.")

        def solve(b: Floats) -> Floats:
            y = factors.solve(b)
            return np.asarray(y + factors.solve(b - matrix @ y))

        return solve, size

    def refuse(self, seeds: Any) -> None:  # noqa: ARG002
        """Where something moves without stiffness, rigid members share a force, or a law has a kink there are no gradients."""
        held, x, found = self.balance.system, self.reached.x, self.reached.stability
        if found.neutral:
            ways = [moves_text(self.system, shape) for shape in found.shapes[found.negative :][: found.neutral]]
            raise AnalysisError(f"{_SINGULAR}: {'; '.join(ways[:3]) or 'a mode without stiffness'}.")
        if len(shared := rows_of(held, x).redundant):
            raise AnalysisError(
                f"The forces of rigid members are not unique, so they have no gradients: {few(held.parts_of(shared), 4)} and "
                "others hold each other. Make one of them elastic."
            )
        whole = stiff_rows(self.system)
        kinks = kinks_of(whole, x, flexibility(whole, x))
        short = kinks.stiffness * np.minimum(np.abs(kinks.upper), np.abs(kinks.lower))
        refuse_kinks(whole, kinks.row[short <= PULLS * force_scale(self.balance, x, self.reached.N)])

    def told(self, system: System, unknown: Floats) -> tuple[dict[str, Any], dict[str, Any]]:
        """As `statics.equilibrium` tells, without modes."""
        balance = self.forces(system)
        x, N, _ = self.placed(balance.system, unknown)
        return state_columns(system, balance, x, N)

    def _energies(self, system: System, unknown: Floats) -> tuple[Floats, NDArray[np.int64]]:
        """The terms of the strain energy: of bars, of elements on coordinates, of all others of a kind."""
        x = self.placed(self.forces(system).system, unknown)[0]
        bars, at = bar_laws(system, ends_of(system, x)[1]).energy, sites(system)
        others = [one.kernels[ENERGY][1](own, x.reshape(-1)) for one, own in present(system) if not isinstance(own, Scalars)]
        place = at["measure"][system.force_element_measure]
        terms = [bars, named_motions(system, x[None]).energy[0], np.array(others, float)]
        return np.concatenate(terms), np.concatenate([at["member"], place, np.full(len(others), -1)])

    sums = MappingProxyType({"energy": (_energies, "J", "strain energy of bars, springs and elements")})


_SINGULAR = "There is no gradient here: something moves without stiffness"
