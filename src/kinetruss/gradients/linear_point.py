"""`statics.linear` at its solution: forces N of the rows and displacements u, with the matrix of the stiffness method.

r = (f N + given - G u,  G^T (N + N0) + K u - F),    z from the same symmetric matrix
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError
from kinetruss.gradients.judged import judged_axes, judged_sites, utilisation
from kinetruss.gradients.kinks import refuse_kinks
from kinetruss.gradients.nearness import site_of_rows, sites
from kinetruss.gradients.responses import Beside
from kinetruss.gradients.told import Told
from kinetruss.mechanics import System, constraint_jacobian
from kinetruss.mechanics.arguments import number_of, positions_of
from kinetruss.results import variable
from kinetruss.statics.active_set import PULLS, Kinks, given_displacements, kinks_of, solve_one_sided, stored_energy
from kinetruss.statics.linear_statics import Known, known_forces, rigid_rows, variables
from kinetruss.statics.small_displacements import (
    Solved,
    Weight,
    beam_rows,
    elements_only,
    flexibility,
    loads_at,
    solve_each,
    stiff_rows,
    weight_word,
    with_beams,
)

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Equations:
    """What stands in r: flexible, tension, given (rows,) of the rows of `stiff_rows`; rows: gradients of these and of the
    deformations of beams, and the flexibilities of the latter; only: stiffness of elements without rows.
    """

    held: System
    x: Floats
    known: Known
    kinks: Kinks
    flexible: Floats
    tension: Floats
    rows: tuple[Any, Floats]
    only: Any
    given: Floats

    @cached_property
    def gradients(self) -> Any:
        """Of the rows, (rows, 3 n)."""
        return constraint_jacobian(self.held, self.x)


class LinearPoint(Told):
    """A `Point` of `statics.linear`, with the arguments of that function."""

    linear = True

    def __init__(
        self,
        system: System,
        position: ArrayLike | None = None,
        load_case: str | None = None,
        *,
        weight: Weight = True,
        rigid: Collection[str] = (),
        time: float = 0.0,
    ) -> None:
        self.system, self.place = system, position
        self.case, self.word, self.rigid, self.time = load_case, weight_word(weight), rigid, number_of(time, "time", "s")
        self._last: tuple[System, _Equations] | None = None
        held, x = stiff_rows(system), positions_of(system, position)
        flexible, known = self._forces(system, held, x)
        self.found = solve_one_sided(held, x, flexible, known.tension, known.load + known.continua_force)
        self.before = kinks_of(held, x, flexible).before
        whole, soft = with_beams(held, x)
        on_beams = (whole[len(flexible) :] @ self.found.solved.displacement[held.free]) / soft
        self.unknown = np.concatenate([self.found.solved.force, on_beams, self.found.solved.displacement[held.free]])
        self.rows, self.forces = len(flexible), whole.shape[0]
        force, moved = self.unknown[: self.forces], self.unknown[self.forces :]
        size = [np.full(len(one), float(np.abs(one).max(initial=0.0)) or 1.0) for one in (force, moved)]
        self.size = np.concatenate(size)
        at = sites(system)
        beams = system.continua.beams if system.continua is not None else None
        of_beams: Any = [] if beams is None else np.repeat(at["node"][beams.nodes[:, 0]], beams.rigidity.shape[1])
        self.at = np.concatenate([site_of_rows(held), of_beams, np.repeat(at["node"], 3)[held.free]]).astype(np.int64)
        self.row = self.at

    def _forces(self, system: System, held: System, x: Floats) -> tuple[Floats, Known]:
        loads = loads_at(system, np.array([self.time]), self.case, self.word).at(x[None])
        flexible = flexibility(held, x)
        flexible[rigid_rows(held, self.rigid)] = 0.0
        return flexible, known_forces(system, held, x, loads)

    def _equations(self, system: System) -> _Equations:
        """Those at other numbers, with the rows with kinks in the state that they have."""
        if self._last is None or self._last[0] is not system:
            held, x = stiff_rows(system), positions_of(system, self.place)
            flexible, known = self._forces(system, held, x)
            kinks = kinks_of(held, x, flexible)
            laws = kinks.laws(self.found.state, flexible, known.tension)
            rows, only = with_beams(held, x), elements_only(held, x)
            self._last = system, _Equations(held, x, known, kinks, *laws, rows, only, given_displacements(held, x))
        return self._last[1]

    def residual(self, system: System) -> Floats:
        """r at other numbers."""
        at = self._equations(system)
        whole, soft = at.rows
        N, u = self.unknown[: self.forces], self.unknown[self.forces :]
        slack = np.append(np.isinf(at.flexible), np.zeros(len(soft), np.bool_))
        f = np.concatenate([np.where(slack[: self.rows], 0.0, at.flexible), soft])
        given = np.append(at.given, np.zeros(len(soft)))
        push = at.known.load + at.known.continua_force
        rows = np.where(slack, N, f * N + given - whole @ u)
        inner = (at.only @ self._whole(at.held, u) - push)[at.held.free]
        return np.concatenate([rows, whole.T @ N + whole[: self.rows].T @ at.tension + inner])

    def _whole(self, held: System, u: Floats) -> Floats:
        found = np.zeros(held.x0.size)
        found[held.free] = u
        return found

    def transposed(self, right: Floats) -> Floats:
        """z: the matrix for (N, -u) is symmetric, so z has the forces and displacements under the seeds as loads."""
        at = self._equations(self.system)
        load = np.zeros((len(right), at.x.size))
        load[:, at.held.free] = -right[:, self.forces :]
        moved, force = solve_each(at.held, at.x, self.found.flexible, load, -right[:, : self.forces])
        return np.concatenate([force, -moved[:, at.held.free]], axis=1)

    def told(self, system: System, unknown: Floats) -> tuple[dict[str, Any], dict[str, Any]]:
        """As `statics.linear` tells."""
        return variables(*self._solved(system, unknown))

    @cached_property
    def more(self) -> Beside:
        """The utilisation of members."""

        def found() -> dict[str, Any]:
            values = utilisation(self.system, self.told(self.system, self.unknown), self.case)
            return {"utilisation": variable(("part", "rule"), values, "", "demand over capacity")}

        return Beside({"utilisation": found})

    def data(self) -> xr.Dataset:
        """The results as users read them, with the names of what is judged."""
        return super().data().assign_coords(judged_axes(self.system))

    def columns(self, system: System, unknown: Floats, names: Sequence[str]) -> dict[str, Floats]:
        """The named results; entries of the utilisation that do not apply are 0."""
        found = super().columns(system, unknown, [name for name in names if name != "utilisation"])
        if "utilisation" in names:
            values = utilisation(system, self.told(system, unknown), self.case)
            found["utilisation"] = np.where(np.isfinite(values), values, 0.0)
        return found

    def sites(self, name: str) -> NDArray[np.int64]:
        """By the node, member or support of each value."""
        return judged_sites(self.system) if name == "utilisation" else super().sites(name)

    def _solved(self, system: System, unknown: Floats) -> tuple[Any, ...]:
        """The arguments of `linear_statics.variables` at other numbers and unknowns."""
        at, whole = self._equations(system), self._equations(system).rows[0]
        N, u = unknown[: self.rows], self._whole(at.held, unknown[self.forces :])
        slack = np.isinf(at.flexible)
        inner = at.only @ u
        if self.forces > self.rows:
            inner = inner + beam_rows(at.held, at.x).T @ unknown[self.rows : self.forces]
        stretched = np.where(slack, 0.0, at.flexible) * N + at.given
        elongation = np.where(slack, whole[: self.rows] @ u[at.held.free], stretched)
        solved = Solved(displacement=u, elongation=elongation, force=N, errors=(0.0, 0.0), inner=inner)
        stored = stored_energy(at.kinks, solved, at.tension, at.given, self.before)
        laws: Any = {"flexible": at.flexible, "tension": at.tension, "given": at.given}
        found = replace(self.found, solved=solved, stored=stored, **laws)
        return system, at.held, at.x, found, at.known, at.gradients

    def refuse(self, seeds: Any) -> None:
        """No gradients at a kink of cables, springs with play and stops, and of a beam-column beyond its Euler load."""
        used = [np.flatnonzero(one["utilisation"]) for one in seeds if "utilisation" in one]
        if used and np.isinf(self.more["utilisation"].values.reshape(-1)[np.concatenate(used)]).any():
            raise AnalysisError("A compression reaches the Euler load, where a beam-column has an infinite utilisation.")
        kinks, solved = self._equations(self.system).kinks, self.found.solved
        row, on = kinks.row, self.found.state != 0
        force = (self.found.tension + solved.force)[row]
        e = np.where(
            on, np.where(self.found.state > 0, kinks.upper, kinks.lower) + force / kinks.stiffness, solved.elongation[row]
        )
        short = kinks.stiffness * np.minimum(np.abs(e - kinks.upper), np.abs(e - kinks.lower))
        least = PULLS * float(np.abs(solved.force).max(initial=0.0))
        refuse_kinks(self._equations(self.system).held, row[short <= least])

    def _energies(self, system: System, unknown: Floats) -> tuple[Floats, Floats]:
        """The terms of the energy: of rows, then of the elements without rows by coordinates."""
        *_, found, known, _ = self._solved(system, unknown)
        inner = (0.5 * found.solved.inner - known.continua_force) * found.solved.displacement
        return np.concatenate([found.stored, inner]), self._of_sums

    def _works(self, system: System, unknown: Floats) -> tuple[Floats, Floats]:
        """The terms of the work: of settlements by rows, of loads by coordinates."""
        *_, found, known, _ = self._solved(system, unknown)
        settled, loaded = -0.5 * found.solved.force * found.given, 0.5 * known.load * found.solved.displacement
        return np.concatenate([settled, loaded]), self._of_sums

    @cached_property
    def _of_sums(self) -> Any:
        return np.concatenate([self.at[: self.rows], np.repeat(sites(self.system)["node"], 3)])

    sums = MappingProxyType(
        {
            "energy": (_energies, "J", "strain energy that the load adds"),
            "work": (_works, "J", "half the loads times their displacements"),
        }
    )
