"""`flexible.frequencies` of a model in its own position at rest: with the row forces N of its loads, which stiffen.

N balances the loads best and with least norm, as N = W A+ b with A the gradients of the rows, scaled by W, and b the loads. Its
derivatives at fixed N, r = b - A n and q = A+^T n are (Golub & Pereyra, SIAM J. Numer. Anal. 10 (1973) 413, eq. 4.12)

    dn = A+ d(b - A n) + A+ A+^T d(A^T r) + (1 - A+ A) d(A^T q)
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.least_norm import apply_loads
from kinetruss.elements.caching import cached
from kinetruss.errors import AnalysisError
from kinetruss.flexible.natural_frequencies import MORE
from kinetruss.flexible.structure import Softness, instants_of, modes_of, refuse_unloaded_beams, structure_at
from kinetruss.gradients.eigenvalues import Eigenvalues
from kinetruss.gradients.kinks import refuse_kinks
from kinetruss.gradients.nearness import site_of_rows, sites
from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.mechanics import RANK_TOLERANCE, System, constraint_jacobian, rearrange
from kinetruss.mechanics.balance import Balance, balance_of
from kinetruss.statics import at_poses
from kinetruss.statics.active_set import PULLS, kinks_of
from kinetruss.statics.small_displacements import flexibility, loads_at, stiff_rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


class FrequenciesPoint(Eigenvalues):
    """A `Point` of `flexible.frequencies`, with its arguments and a load case in place of forces."""

    linear = True
    name, unit, words = "frequency", "Hz", "natural frequency"

    def __init__(
        self,
        system: System,
        load_case: str | None = None,
        modes: int = 6,
        *,
        stiffness: Mapping[str, float] | None = None,
        rigid: Collection[str] = (),
    ) -> None:
        self.system, self.case = system, load_case
        self.softness = Softness(stiffness=stiffness or {}, rigid=rigid)
        forces = at_poses(system.given, system.x0[None, :, : system.dim], load_case=load_case)
        refuse_unloaded_beams(system.given, forces)
        here = next(instants_of(system.given, forces, self.softness))
        own = forces.arrays.get("mode_force")
        self.bent = own is not None and bool(np.abs(np.nan_to_num(own.values)).max(initial=0.0) > 0.0)
        squares, self.shapes, M, K = modes_of(here, modes + MORE)
        self.values, self.shown = np.sqrt(squares) / (2 * np.pi), min(modes, len(squares))
        self.shapes, self.squares, self.hard = self.shapes[:, : self.shown], squares[: self.shown], here.f == 0.0
        hard = here.G[np.flatnonzero(self.hard)].toarray()
        left = K @ self.shapes - M @ self.shapes * self.squares
        self.held = np.linalg.lstsq(hard.T, -left, rcond=None)[0]
        self.shared = len(hard) and np.linalg.matrix_rank(hard, RANK_TOLERANCE) < len(hard)
        node = sites(system)["node"]
        free, rows = np.repeat(node, 3)[system.free], site_of_rows(system)
        self.at_terms = np.concatenate([free, rows])
        # the forces that stiffen, as N over the share that a row takes
        self.alone = here.G.shape[0] == here.G.shape[1] and not len(rearrange(system, system.x0, None).redundant)
        A, b = self._balanced(system)
        self.inverse = np.linalg.pinv(A, rcond=RANK_TOLERANCE)
        self.rank = int(np.linalg.matrix_rank(A, RANK_TOLERANCE))
        self.full = A
        self.unknown = self.inverse @ b
        self.fixed = b - A @ self.unknown, self.inverse.T @ self.unknown
        self.size = np.full(len(rows), float(np.abs(self.unknown).max(initial=0.0)) or 1.0)
        self.at = rows
        self.row = free if self.alone else np.concatenate([free, rows, rows])

    def _scale(self, system: System) -> Floats:
        """Root (rows,) of the weights of the rows in the least norm."""
        if self.alone or not len(system.row_member):
            return np.ones(len(system.row_member))
        return _roots(system)

    def _balanced(self, system: System) -> tuple[Floats, Floats]:
        """A (free, rows) and b (free,)."""
        J = constraint_jacobian(system, system.x0)[:, system.free]
        return J.toarray().T / self._scale(system), self._load(system)[system.free]

    def _load(self, system: System) -> Floats:
        loads = loads_at(system, np.zeros(1), self.case, "all").at(system.x0[None])
        x = system.x0.reshape(1, -1)
        joint, rest = np.empty((1, len(system.members), 2, 3)), np.empty_like(x)
        apply_loads(system, loads, States(x, np.zeros_like(x), np.zeros_like(x)), EndForces(joint, rest))
        return np.asarray(rest[0])

    def residual(self, system: System) -> Floats:
        """What N depends on, with other numbers."""
        A, b = self._balanced(system)
        first = b - A @ self.unknown
        return first if self.alone else np.concatenate([first, A.T @ self.fixed[0], A.T @ self.fixed[1]])

    def transposed(self, right: Floats) -> Floats:
        """z (k, m): -dn/d(residual) transposed."""
        first = right @ self.inverse
        if self.alone:
            return -first
        return -np.concatenate([first, first @ self.inverse.T, right - first @ self.full], axis=1)

    def refuse(self, seeds: Any) -> None:
        """Repeated frequencies, cables at a kink and loaded beams have no gradients."""
        self.refuse_repeated(seeds)
        if self.bent:
            raise AnalysisError("Frequencies of beams under load have no gradients yet. Leave out the loads of the beams.")
        if self.shared:
            raise AnalysisError("Inextensible members hold each other, so there is no gradient. Give them E and A.")
        if self.rank < min(self.full.shape) and self._rank_beside() != self.rank:
            raise AnalysisError("This position is singular: beside it rows are independent. So there is no gradient here.")
        held, x = stiff_rows(self.system), self.system.x0
        kinks = kinks_of(held, x, flexibility(held, x))
        short = kinks.stiffness * np.minimum(np.abs(kinks.upper), np.abs(kinks.lower))
        refuse_kinks(held, kinks.row[short <= PULLS * float(np.abs(self.unknown).max(initial=0.0))])

    def _rank_beside(self) -> int:
        x = self.system.x0.reshape(-1).copy()
        free = self.system.free
        x[free] += 1e-3 * float(np.ptp(x)) * np.random.default_rng(3).standard_normal(len(free))
        J = constraint_jacobian(self.system, x.reshape(-1, 3))[:, free]
        return int(np.linalg.matrix_rank(J.toarray(), RANK_TOLERANCE))

    def terms(self, system: System, unknown: Floats) -> Floats:
        """As of `Eigenvalues`."""
        balance = _balance(system, self.case)
        N = unknown / self._scale(system)
        at = structure_at(balance, self.softness, system.x0, N, np.zeros(system.x0.size))
        phi, w2 = self.shapes, self.squares
        inner = phi * (at.K @ phi - at.M @ phi * w2)
        e = at.G @ phi
        rows = np.empty_like(e)
        rows[~self.hard] = e[~self.hard] ** 2 / at.f[~self.hard, None]
        rows[self.hard] = 2 * self.held * e[self.hard]
        return np.asarray(np.concatenate([inner, rows]) / (4 * np.pi * np.sqrt(w2))).T


@cached()
def _roots(system: System) -> Floats:
    return np.asarray(np.sqrt(rearrange(system, system.x0, None).weight))


@cached()
def _balance(system: System, case: str | None) -> Balance:
    return balance_of(system, case)
