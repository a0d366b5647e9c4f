"""Gradients of what is read at a few instants of a motion, by the adjoint of the equations that hold there.

At each instant the states x, v, a and the forces N of the rows solve the equations of `motion_rows`. These are block
triangular, so the multipliers of a response s follow one after the other from J alone:

    J zN = -ds/dN,    J^T za = d(s - zN rN)/da,    J^T zv = d(s - zN rN - za ra)/dv,    J^T zx = ...,
    ds/dp = d(s - zN rN - za ra - zv rv - zx rx)/dp    at fixed states.

Where rows are redundant, forces have the least sum of w N^2: w N = J m, with m such that J^T N balances what acts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.prescribed import flat, solve
from kinetruss.errors import AnalysisError, ModelError, few
from kinetruss.gradients.differences import Weighed, differences
from kinetruss.gradients.downstream import at_states
from kinetruss.gradients.motion_rows import Factors, Prescribed, carried, holding, row_residuals, softness, state_rows
from kinetruss.gradients.nearness import Near, parts_of, site_of_rows, sites
from kinetruss.gradients.stacked import Unknowns, Weights, by_states
from kinetruss.gradients.task_rows import task_rows
from kinetruss.gradients.varied import STEP, Varied
from kinetruss.kernels.structure.structure import States
from kinetruss.kinematics.motions import path_of
from kinetruss.kinematics.sampling import sample_from
from kinetruss.kinematics.time_tables import with_supports
from kinetruss.mechanics import System, arrange, compile, constraint_jacobian, rearrange
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.mechanics.positions import shortest
from kinetruss.mechanics.system import standing_for

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model

    Floats = NDArray[np.float64]
    Seeds = Mapping[str, Floats]

ARRAYS_ALONE = ("nodes", "loads", "cases", "gravity")
"""Tables whose numbers only the arrays of a system tell to what follows from forces."""
AGREE = 1e-7
"""Fraction by which values and equations at single instants may differ from those of the whole analysis."""
X, V, A, N = range(4)


class Solved(NamedTuple):
    """What is prescribed at the instants, states x, v, a of free coordinates (s, free), and forces of rows (s, rows)."""

    given: Prescribed
    states: States
    force: Floats

    def changed(self, k: int, values: Floats) -> Solved:
        """The same side by side, with the unknowns k (X, V, A or N) as in (g, s, m)."""
        count = len(values)
        whole = [np.tile(one, (count, 1)) for one in (*self.states, self.force)]
        whole[k] = np.ascontiguousarray(values.reshape(count * values.shape[1], -1))
        return Solved(self.given.tiled(count), States(*whole[:3]), whole[3])


class Instants:
    """The instants that responses read in one load case, with their states, and what responses read of them."""

    def __init__(self, of: Any, by: Varied, c: int, seeds: Sequence[Seeds]) -> None:
        self.of, self.by, self.system, self.model = of, by, of.system, of.model
        self.rows = holding(of.system)
        self.case, self.along, self.forces = of.cases[c], of.by_case[c], of.asked.forces
        self.names = [name for name in dict.fromkeys(n for one in seeds for n in one) if name != "mass"]
        self.mass = np.array([float(one["mass"]) if "mass" in one else 0.0 for one in seeds])
        read = [np.abs(one[name]).reshape(len(of.times), -1).max(axis=1) for one in seeds for name in self.names if name in one]
        self.at = np.flatnonzero(np.max(read, axis=0)) if read else np.zeros(0, np.int64)
        self.weight = self._weights(seeds)
        self.site = np.concatenate([self._sites(name) for name in self.names] or [np.zeros(0, np.int64)])

    def gradients(self) -> Floats:
        """Derivatives (k, numbers)."""
        found = np.zeros((len(self.mass), len(self.by.names)))
        if self.mass.any():
            found += self._masses()
        if len(self.at):
            self._check()
            found += self._by_numbers(self._multipliers())
        return found

    # Weights of what is read, and where it is.

    def _weights(self, seeds: Sequence[Seeds]) -> Floats:
        parts = [np.zeros((len(seeds), len(self.at), 0))]
        for name in self.names:
            shape = self.along[name].values.shape
            own = np.stack([one[name] if name in one else np.zeros(shape) for one in seeds])[:, self.at]
            parts.append(own.reshape(len(seeds), len(self.at), -1))
        return np.concatenate(parts, axis=2)

    def _sites(self, name: str) -> NDArray[np.int64]:
        one, at = self.along[name], sites(self.system)
        found = np.full(one.values.shape[1:], -1)
        for k, dim in enumerate(one.dims[1:]):
            if (own := self.along.site(dim, at["node"], at["member"])) is not None:
                found[...] = own.reshape([-1 if j == k else 1 for j in range(found.ndim)])
        return found.reshape(-1)

    # What is solved, values and equations.

    @cached_property
    def base(self) -> Solved:
        """The states of the motion and their forces."""
        system, given = self.system, self._prescribed(self.model, self.system)
        states = States(*(flat(system, self.of.motion, name)[self.at] for name in ("position", "velocity", "acceleration")))
        force = np.zeros((len(self.at), len(self.rows.row_member)))
        if self.forces:
            loads = case_loads(system, given.t, self.case, rotating=True).at(states.x)
            force = solve(self.rows, given.drive[0], loads, states)["N"]
        return Solved(given, States(*(y[:, system.free] for y in states)), force)

    @cached_property
    def factors(self) -> list[Factors]:
        """Of the rows at each instant."""
        system, base, tasks = self.rows, self.base, self.base.given.tasks
        places = self._placed(system, base).x.reshape(len(self.at), -1, 3)
        found: list[Factors] = []
        for x, values in zip(places, base.given.drive[0], strict=True):
            J = constraint_jacobian(system, x)[:, system.free]
            arranged = rearrange(system, x, values) if self.redundant else arrange(system)
            led = None if tasks is None else (self.held, tasks.gradients(len(found), x.reshape(-1), system.free))
            found.append(Factors(J, arranged.redundant, self._shares(system), led))
        return found

    @property
    def redundant(self) -> bool:
        """Whether there are more rows than coordinates."""
        return len(self.rows.row_member) > len(self.rows.free)

    def _shares(self, system: System) -> Floats:
        """Weights (rows,) of the sum of w N^2: l/(E A) over a constant where `Arrangement` has it, else 1."""
        stiff = arrange(self.rows).stiff
        if not stiff.any():
            return np.ones(len(stiff))
        return np.where(stiff, softness(system) / np.mean(softness(self.rows)[stiff]), 1.0)

    @cached_property
    def moved(self) -> Floats:
        """m (s, free) of w N = J m."""
        return np.stack([one.shift(force) for one, force in zip(self.factors, self.base.force, strict=True)])

    @cached_property
    def held(self) -> NDArray[np.int64]:
        """The rows that states satisfy, as indices of all."""
        return state_rows(self.rows, self.base.given.tasks)

    @property
    def per_state(self) -> int:
        """Number of equations of positions, and of velocities, and of accelerations."""
        tasks = self.base.given.tasks
        return len(self.held) + (0 if tasks is None else tasks.tasks)

    def _prescribed(self, model: Model, system: System) -> Prescribed:
        """At the instants, by the records of a model and the numbers of a system."""
        trajectory, times = (self.of.trajectory, self.of.times) if model is self.model else self.of.way.of(model)
        t = np.ascontiguousarray(times[self.at])
        if self.of.led:
            value, rate, second = (
                self.of.motion.arrays[f"drive_{name}"].values[self.at] for name in ("position", "velocity", "acceleration")
            )
            none = np.zeros((len(t), 0))
            moving = with_supports(system, t, (none, none, none))
            return Prescribed(t, (value, rate, second), moving, task_rows(system, trajectory, t))
        start = dict(zip(system.drives, system.drive_start.tolist(), strict=True))
        path = path_of(system, t, sample_from(model, trajectory, t, start))
        return Prescribed(t, path.drive, path.moving)

    def _now(self, system: System, model: Model | None = None) -> Solved:
        """The same states under what is prescribed with other numbers."""
        start = np.array_equal(system.drive_start, self.system.drive_start)
        if model is None and start and not len(self._moving) and not self.of.led:
            return self.base
        return self.base._replace(given=self._prescribed(model or self.model, system))

    @cached_property
    def _moving(self) -> NDArray[np.int64]:
        plan: Any = arrange(self.rows).plan
        return np.asarray(plan.moving)

    def _placed(self, system: System, solved: Solved) -> States:
        """States (s, 3 n) of all coordinates."""
        found = []
        for k, (one, moving) in enumerate(zip(solved.states, solved.given.moving, strict=True)):
            whole = np.zeros((len(one), system.x0.size))
            whole += system.x0.reshape(-1) if k == X else 0.0
            whole[:, self._moving] = moving
            whole[:, system.free] = one
            found.append(whole)
        return States(*found)

    def _values(self, model: Model, solved: Solved) -> Floats:
        """What is read (s, values)."""
        return self._both(model, solved)[0]

    def _both(self, model: Model, solved: Solved) -> tuple[Floats, Callable[[], Floats]]:
        """What is read (s, values), and the equations, found when they are called for."""
        system = compile(model)
        states = self._placed(system, solved)
        found = at_states(model, self.of.asked, solved.given.at(system, states), states, solved.force, self.case)
        read = np.concatenate([found[name].values.reshape(len(states.x), -1) for name in self.names], axis=1)
        return read, lambda: self._equations(system, solved, found.rest)

    def _equations(self, system: System, solved: Solved, rest: Floats | None = None) -> Floats:
        """The equations of positions, velocities, accelerations and forces (s, 3 rows + free), and of w N = J m."""
        system, states = holding(system), self._placed(system, solved)
        given = solved.given.at(system, states)
        found = [own[:, self.held] for own in row_residuals(system, given, states)]
        if given.tasks is not None:
            found = [np.hstack(pair) for pair in zip(found, given.tasks.residuals(states), strict=True)]
        if self.forces:
            if rest is None:
                rest = carried(system, solved.given.t, self.case, states, solved.force)[1]["rest"]
            found.append(rest[:, system.free])
        if self.forces and self.redundant:
            moved = np.zeros_like(states.x)
            moved[:, system.free] = np.tile(self.moved, (len(states.x) // len(self.moved), 1))
            along = row_residuals(system, given.still(), States(states.x, moved, np.zeros_like(moved)))[1]
            found.append(self._shares(system) * solved.force - along)
        return np.concatenate(found, axis=1)

    def _check(self) -> None:
        """Values and equations at these instants alone must be those of the whole analysis."""
        read, equations = self._both(self.model, self.base)
        wanted = np.concatenate([self.along[name].values[self.at].reshape(len(self.at), -1) for name in self.names], axis=1)
        used = np.abs(self.weight).max(axis=0) > 0
        if np.isinf(wanted[used]).any():
            raise AnalysisError(
                f"{few(self.names, 4)} is infinite at an instant, as the utilisation of a strut at its buckling load is, so it "
                "has no gradient. Keep variables where no member buckles, or limit utilisation[buckling], which stays finite."
            )
        off, scale = np.abs(read[used] - wanted[used]).max(initial=0.0), np.abs(wanted[used]).max(initial=0.0)
        rows, free, rest = len(self.rows.row_member), len(self.rows.free), np.abs(equations()).max(axis=0)
        sizes = self._sizes()
        count = [self.per_state] * 3 + ([free, rows] if self.forces else [0, 0])
        limit = np.repeat([*sizes, sizes[N]], count)[: len(rest)]
        if not off <= AGREE * scale or not (rest <= AGREE * limit).all():
            raise AnalysisError(
                f"{few(self.names, 4)} at single instants are not those of the whole motion here, so there is no gradient yet: "
                "something depends on neighbouring samples, or forces are shared otherwise."
            )

    # Multipliers.

    def _multipliers(self) -> Floats:
        """z (k, s, equations)."""
        rows, free = len(self.rows.row_member), len(self.rows.free)
        last = (free + rows * self.redundant) * self.forces
        each = self.per_state
        z = np.zeros((len(self.weight), len(self.at), 3 * each + last))
        if self.forces:
            right = self._values_by(N)
            for i, one in enumerate(self.factors):
                z[:, i, 3 * each :] = one.of_forces(right[:, i])
        for k in (A, V, X):
            right = self._values_by(k) - self._equations_by(k, z)
            for i, one in enumerate(self.factors):
                z[:, i, k * each : (k + 1) * each] = one.of_states(right[:, i])
        return z

    def _sizes(self) -> list[float]:
        """What changes of x, v, a and N are compared with."""
        rates = (self.of.motion.arrays[name].values for name in ("velocity", "acceleration"))
        return [shortest(self.system), *(float(np.abs(one).max(initial=0.0)) or 1.0 for one in (*rates, self.base.force))]

    def _unknowns(self, k: int) -> Unknowns:
        value = self.base.force if k == N else self.base.states[k]
        at = site_of_rows(self.rows) if k == N else np.repeat(sites(self.system)["node"], 3)[self.system.free]
        step = np.full(value.shape[1], STEP * self._sizes()[k])
        return Unknowns(value, [self._around.get(i) for i in at.tolist()], step, len(self._around))

    @cached_property
    def _around(self) -> dict[int, Near]:
        parts = parts_of(self.system)
        return {i: parts.around(("nodes", name)) for i, name in enumerate(parts.index)}

    def _values_by(self, k: int) -> Floats:
        """Derivatives of what is weighed by states k."""

        def of(values: Floats) -> Floats:
            return self._values(self.model, self.base.changed(k, values)).reshape(*values.shape[:2], -1)

        return by_states(of, Weights(self.weight, self.site), self._unknowns(k), smooth=True)

    def _equations_by(self, k: int, z: Floats) -> Floats:
        """Derivatives of the weighed equations by states k, without those whose multipliers are to be found."""
        weight = z.copy()
        weight[:, :, : (k + 1) * self.per_state] = 0.0

        def of(values: Floats) -> Floats:
            return self._equations(self.system, self.base.changed(k, values)).reshape(*values.shape[:2], -1)

        return by_states(of, Weights(weight, self._rows), self._unknowns(k))

    @cached_property
    def _rows(self) -> NDArray[np.int64]:
        """The node at which each equation is."""
        row, own = site_of_rows(self.rows), np.repeat(sites(self.system)["node"], 3)[self.system.free]
        tasks = np.full(self.per_state - len(self.held), -1)
        state = np.concatenate([row[self.held], tasks])
        found = [state, state, state, *([own] * self.forces), *([row] * (self.forces and self.redundant))]
        return np.concatenate(found).astype(np.int64)

    # Derivatives by numbers at fixed states.

    def _masses(self) -> Floats:
        weight = np.repeat(self.mass[:, None], len(self.system.nodes), axis=1)
        every = Weighed(lambda change: mass_by_nodes(self.by.changed(change)), weight, sites(self.system)["node"])
        return differences(every, self.by.near, STEP * self.by.scale, len(self._around))

    def _by_numbers(self, z: Floats) -> Floats:
        """Numbers that stand in the arrays act on the equations through these. On what is read, those of `ARRAYS_ALONE` do so
        too, the others through records, as do all others on both.
        """
        by, read, equations = self.by, (self.weight, self.site), (-z, self._rows)
        in_arrays = np.zeros(len(by.names), np.bool_)
        for _, which, slope in by.places.values():
            in_arrays[which[slope != 0.0]] = True
        alone = in_arrays & np.array([all(keys[0] in ARRAYS_ALONE for keys in own) for own in by.keys])
        used = {*self.site[np.abs(self.weight).max(axis=(0, 1), initial=0.0) > 0].tolist()}
        near = np.array([-1 in used or one is None or not used.isdisjoint(one) for one in by.near])

        def through_arrays(change: Floats) -> list[Floats]:
            system = by.changed(change)
            return [self._equations(system, self._now(system))]

        def read_from_arrays(change: Floats) -> list[Floats]:
            model = standing_for(by.changed(change))
            return [self._values(model, self._now(compile(model)))]

        def read_from_records(change: Floats) -> list[Floats]:
            return [self._values(*self._recorded(change))]

        def both_from_records(change: Floats) -> list[Floats]:
            values, rest = self._both(*self._recorded(change))
            return [values, rest()]

        found = np.zeros((len(z), len(by.names)))
        for chosen, of, parts in (
            (in_arrays, through_arrays, (equations,)),
            (alone & near, read_from_arrays, (read,)),
            (in_arrays & ~alone & near, read_from_records, (read,)),
            (~in_arrays, both_from_records, (read, equations)),
        ):
            weight = np.concatenate([value.reshape(len(z), -1) for value, _ in parts], axis=1)
            site = np.concatenate([np.tile(own, len(self.at)) for _, own in parts])
            kept = np.flatnonzero(np.abs(weight).max(axis=0, initial=0.0))
            if chosen.any() and len(kept):
                every = Weighed(_joined(of, kept), weight[:, kept], site[kept])
                step = np.where(chosen, STEP * by.scale, 0.0)
                found += differences(every, by.near, step, len(self._around), few_act=of is not through_arrays)
        return found

    def _recorded(self, change: Floats) -> tuple[Model, Solved]:
        """The model with changed numbers, and the states under what it prescribes."""
        try:
            model = self.by.model_at(change)
        except ModelError as error:
            names = few([self.by.names[k] for k in np.flatnonzero(change)], 4)
            raise AnalysisError(f"There is no derivative by {names}, which cannot change both ways: {error}") from None
        return model, self._now(compile(model), model)


def _joined(of: Callable[[Floats], list[Floats]], kept: NDArray[np.int64]) -> Callable[[Floats], Floats]:
    return lambda change: np.concatenate([one.reshape(-1) for one in of(change)])[kept]
