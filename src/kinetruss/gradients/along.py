"""Gradients of what is found along a given motion: of a motion, of its forces, and of all that a run tells.

At each instant the states x, v, a and the forces N of the rows solve the equations of `motion_rows`. These are block triangular,
so the multipliers of a response follow one after the other from J alone, and only at the instants that the response reads:

    J zN = -ds/dN,    J^T za = d(s - zN rN)/da,    J^T zv = d(s - zN rN - za ra)/dv,    J^T zx = ...,
    ds/dp = d(s - zN rN - za ra - zv rv - zx rx)/dp    at fixed states.

A largest value over time is that of one sample, and its derivative that at this sample.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse.linalg import splu

from kinetruss import dynamics, kinematics
from kinetruss.dynamics.bearing_friction import seats_of
from kinetruss.dynamics.prescribed import flat, solve
from kinetruss.errors import AnalysisError, InputError, few
from kinetruss.gradients.differences import Weighed, differences
from kinetruss.gradients.downstream import DEMAND, Along, Asked, at_states
from kinetruss.gradients.motion_rows import Prescribed, carried, row_residuals
from kinetruss.gradients.nearness import Near, parts_of, site_of_rows, sites
from kinetruss.gradients.stacked import Unknowns, Weights, by_states
from kinetruss.gradients.varied import STEP, Varied
from kinetruss.kernels.structure.structure import States
from kinetruss.kinematics.motions import instants, path_of
from kinetruss.kinematics.sampling import sample_from
from kinetruss.mechanics import System, arrange, compile, constraint_jacobian
from kinetruss.mechanics.beam_shapes import shaped
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.positions import shortest
from kinetruss.mechanics.rigid_motions import floats
from kinetruss.mechanics.system import standing_for
from kinetruss.runs.plans import plan

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.model import Model

    Floats = NDArray[np.float64]
    Seeds = Mapping[str, Floats]

ARRAYS_ALONE = ("nodes", "loads", "cases", "gravity")
"""Tables whose numbers only the arrays of a system tell to what follows from forces."""
AGREE = 1e-7
"""Fraction by which values and equations at single instants may differ from those of the whole analysis."""


@dataclass(frozen=True, eq=False)
class Way:
    """How a model moves: along a trajectory at so many samples or at times, or as in a run."""

    run: str | None = None
    trajectory: Any = None
    samples: int = 201
    times: ArrayLike | None = None
    is_run: bool = False

    def of(self, model: Model) -> tuple[Any, Floats]:
        """The trajectory and the instants (times,), s."""
        if self.is_run:
            found = plan(model, self.run)
            return found.run.trajectory, found.times
        trajectory = model.trajectories.get(self.trajectory) if isinstance(self.trajectory, str) else self.trajectory
        if trajectory is None:
            return kinematics.follow(model, self.trajectory), np.zeros(0)  # it tells what is wrong
        return trajectory, instants(trajectory.duration, self.samples, self.times, model)


class AlongPoint:
    """Results along a motion, with their gradients."""

    def __init__(self, system: System, way: Way, cases: tuple[str | None, ...], asked: Asked) -> None:
        self.system, self.model, self.way, self.cases, self.asked = system, system.given, way, cases, asked
        self.trajectory, self.times = way.of(self.model)
        self.motion = kinematics.follow(self.model, self.trajectory, times=self.times)
        case_forces = [
            dynamics.inverse(self.model, self.motion, case, static=False) if asked.forces else None for case in cases
        ]
        self.by_case = [Along(self.model, asked, self.motion, forces) for forces in case_forces]

    def data(self) -> xr.Dataset:
        """The names along the axes of the variables."""
        import xarray as xr

        first = self.by_case[0]
        names = first.labels()
        marks = {one: first.kept(of)[k] for one, of, k in (("node", "position", 1), ("member", "length", 1))}
        for dim, own in marks.items():
            names[dim] = [names[dim][k] for k in own.reshape(-1)]
        if len(self.cases) > 1:
            names["load_case"] = [case or "all" for case in self.cases]
        return xr.Dataset(coords={name: own for name, own in names.items() if name != "time"} | {"time": self.times})

    @cached_property
    def more(self) -> Mapping[str, Any]:
        """The variables, found when they are first read."""
        return _Users(self)

    def gradients(self, by: Varied, seeds: Sequence[Seeds]) -> Floats:
        """Derivatives (k, numbers) of k responses with seeds ds/dd by the variables that they read."""
        self._refuse(seeds)
        found = np.zeros((len(seeds), len(by.names)))
        for c in range(len(self.cases)):
            own = [{name: self._whole(name, one[name], c) for name in one} for one in seeds]
            if any(np.any(value) for one in own for value in one.values()):
                found += _Instants(self, by, c, own).gradients()
        return found

    def several(self, name: str) -> bool:
        """Whether a variable is another in each load case."""
        return len(self.cases) > 1 and name not in self.motion.arrays and name not in ("mass", "time")

    def _whole(self, name: str, seed: Floats, c: int) -> Floats:
        """Seeds of a variable in one load case, with inner parts."""
        if self.several(name):
            seed = seed[c]
        elif c:
            return np.zeros_like(seed)
        found = np.zeros(self.by_case[c][name].values.shape)
        found[self.by_case[c].kept(name)] = seed
        return found

    def _refuse(self, seeds: Sequence[Seeds]) -> None:
        system, names = self.system, {name for one in seeds for name in one}
        plan = arrange(system).plan
        why = ""
        if floats(system) is not None:
            why = "nothing holds the structure, so where it is depends on all that was before"
        elif plan is None or len(system.row_member) != len(system.free):
            why = "the structure is redundant, or parts of it are free"
        elif shaped(system) is not system:
            why = "it has beams or links that keep their shape"
        elif self.asked.forces and names - set(self.motion.arrays) and seats_of(system):
            why = "its bearings have friction, which depends on all forces together"
        elif names & set(DEMAND) and any(one.motor is not None and _inductance(self.model, one) for one in self._trains):
            why = "its motors have an inductance, by which the voltage depends on neighbouring samples"
        if why:
            raise AnalysisError(f"There is no gradient along this motion yet: {why}.")

    @property
    def _trains(self) -> list[Any]:
        return list(self.model.actuators.values())


def _inductance(model: Model, train: Any) -> bool:
    motor = model.motors.get(train.motor) if isinstance(train.motor, str) else train.motor
    return bool(getattr(motor, "inductance", None))


class _Users(Mapping[str, Any]):
    """The variables as users read them; with several load cases first along these, where they differ."""

    def __init__(self, of: AlongPoint) -> None:
        self.of = of

    def __getitem__(self, name: str) -> Any:
        of, first = self.of, self.of.by_case[0]
        own = first[name]
        kept = first.kept(name)
        if not of.several(name):
            return own._replace(values=own.values[kept])
        values = np.stack([one[name].values[kept] for one in of.by_case])
        return own._replace(dims=("load_case", *own.dims), values=values)

    def __iter__(self) -> Any:
        return iter(self.of.by_case[0])

    def __len__(self) -> int:
        return len(self.of.by_case[0])


class _Instants:
    """The instants that responses read in one load case, with their states, and what responses read of them."""

    def __init__(self, of: AlongPoint, by: Varied, c: int, seeds: Sequence[Seeds]) -> None:
        self.of, self.by, self.system, self.model = of, by, of.system, of.model
        self.case, self.along = of.cases[c], of.by_case[c]
        self.names = [name for name in dict.fromkeys(n for one in seeds for n in one) if name != "mass"]
        self.mass = np.array([float(one["mass"]) if "mass" in one else 0.0 for one in seeds])
        timed = [
            np.abs(one[name]).reshape(len(of.times), -1).max(axis=1) for one in seeds for name in self.names if name in one
        ]
        self.at = np.flatnonzero(np.max(timed, axis=0)) if timed else np.zeros(0, np.int64)
        system = self.system
        self.free = system.free
        arranged: Any = arrange(system).plan
        self.moving = arranged.moving if arranged is not None else np.zeros(0, np.int64)
        states = States(*(flat(system, of.motion, name)[self.at] for name in ("position", "velocity", "acceleration")))
        self.given = self._prescribed(self.model, system)
        self.N = np.zeros((len(self.at), len(system.row_member)))
        if of.asked.forces and len(self.at):
            loads = case_loads(system, self.given.t, self.case, rotating=True).at(states.x)
            self.N = solve(system, self.given.drive[0], loads, states)["N"]
        self.states = States(*(y[:, self.free] for y in states))
        self.weight = self._weights(seeds)
        self.site = np.concatenate([self._sites(name) for name in self.names]) if self.names else np.zeros(0, np.int64)

    def gradients(self) -> Floats:
        found = self._masses() if self.mass.any() else np.zeros((len(self.mass), len(self.by.names)))
        if len(self.at):
            self._check()
            found += self._by_numbers(self._multipliers())
        return found

    # What is prescribed, and values at states.

    def _prescribed(self, model: Model, system: System) -> Prescribed:
        """At the chosen instants, with the numbers of a model and of its arrays."""
        trajectory, times = (self.of.trajectory, self.of.times) if model is self.model else self.of.way.of(model)
        t = np.ascontiguousarray(times[self.at])
        start = dict(zip(system.drives, system.drive_start.tolist(), strict=True))
        path = path_of(system, t, sample_from(model, trajectory, t, start))
        return Prescribed(t, path.drive, path.moving)

    def _placed(self, system: System, given: Prescribed, free: States) -> States:
        """States (s, 3 n) of all coordinates from those of free ones."""
        found = []
        for k, (one, moving) in enumerate(zip(free, given.moving, strict=True)):
            whole = np.repeat(system.x0.reshape(1, -1), len(one), axis=0) if k == 0 else np.zeros((len(one), system.x0.size))
            whole[:, self.moving] = moving
            whole[:, self.free] = one
            found.append(whole)
        return States(*found)

    def _values(self, model: Model, system: System, given: Prescribed, free: States, N: Floats) -> Floats:
        """What is read (s, values)."""
        states = self._placed(system, given, free)
        found = at_states(model, self.of.asked, given, states, N, self.case)
        return np.concatenate([found[name].values.reshape(len(states.x), -1) for name in self.names], axis=1)

    def _residuals(self, system: System, given: Prescribed, free: States, N: Floats) -> Floats:
        """The equations of positions, velocities, accelerations and forces (s, 3 rows + free)."""
        states = self._placed(system, given, free)
        rows = row_residuals(system, given, states)
        if not self.of.asked.forces:
            return np.concatenate(rows, axis=1)
        rest = carried(system, given.t, self.case, states, N)[1]["rest"]
        return np.concatenate([*rows, rest[:, self.free]], axis=1)

    def _check(self) -> None:
        """Values and equations at these instants alone must be those of the whole analysis."""
        found = self._values(self.model, self.system, self.given, self.states, self.N)
        wanted = np.concatenate([self.along[name].values[self.at].reshape(len(self.at), -1) for name in self.names], axis=1)
        used = np.abs(self.weight).max(axis=0) > 0
        scale = np.abs(wanted[used]).max(initial=0.0)
        off = np.abs(found - wanted)[used].max(initial=0.0)
        rest = self._residuals(self.system, self.given, self.states, self.N)
        rows, sizes = len(self.system.row_member), self._sizes()
        limits = np.repeat([sizes[0], sizes[1], sizes[2], max(sizes[3], 1e-300)], [rows, rows, rows, rest.shape[1] - 3 * rows])
        if not off <= AGREE * scale or not (np.abs(rest) <= AGREE * limits).all():
            raise AnalysisError(
                f"{few(self.names, 4)} at single instants are not those of the whole motion here, so they have no gradient yet: "
                "something depends on neighbouring samples, or forces are shared otherwise."
            )

    # Multipliers.

    def _multipliers(self) -> Floats:
        """z (k, s, equations) of the equations."""
        rows, free, count = len(self.system.row_member), len(self.free), len(self.at)
        forces = free if self.of.asked.forces else 0
        z = np.zeros((len(self.weight), count, 3 * rows + forces))
        places = self._placed(self.system, self.given, self.states).x.reshape(count, -1, 3)
        factors = [_factors(constraint_jacobian(self.system, x)[:, self.free]) for x in places]
        cuts = [slice(k * rows, (k + 1) * rows) for k in range(3)]
        if forces:
            right = self._values_by(3)
            for i, one in enumerate(factors):
                z[:, i, 3 * rows :] = -one.solve(right[:, i].T).T
        for k in (2, 1, 0):
            right = self._values_by(k) - self._equations_by(k, z)
            for i, one in enumerate(factors):
                z[:, i, cuts[k]] = one.solve(right[:, i].T, trans="T").T
        return z

    def _sizes(self) -> list[float]:
        """What changes of x, v, a and N are compared with."""
        found = [shortest(self.system)]
        return found + [float(np.abs(one).max(initial=0.0)) or 1.0 for one in (self.states.v, self.states.a, self.N)]

    def _unknowns(self, k: int) -> Unknowns:
        value = self.N if k == 3 else self.states[k]
        at = site_of_rows(self.system) if k == 3 else np.repeat(sites(self.system)["node"], 3)[self.free]
        step = np.full(value.shape[1], STEP * self._sizes()[k])
        return Unknowns(value, [self._around.get(i) for i in at.tolist()], step, len(self._parts.index))

    @cached_property
    def _parts(self) -> Any:
        return parts_of(self.system)

    @cached_property
    def _around(self) -> dict[int, Near]:
        return {i: self._parts.around(("nodes", name)) for i, name in enumerate(self._parts.index)}

    def _at_changed(self, k: int, values: Floats) -> tuple[Prescribed, States, Floats]:
        """What is prescribed, states and forces side by side, with unknowns k as in (g, s, m)."""
        count = len(values)
        whole = [np.tile(one, (count, 1)) for one in (*self.states, self.N)]
        whole[k] = np.ascontiguousarray(values.reshape(count * values.shape[1], -1))
        return self.given.tiled(count), States(*whole[:3]), whole[3]

    def _values_by(self, k: int) -> Floats:
        def of(values: Floats) -> Floats:
            found = self._values(self.model, self.system, *self._at_changed(k, values))
            return found.reshape(*values.shape[:2], -1)

        return by_states(of, Weights(self.weight, self.site), self._unknowns(k), smooth=True)

    def _equations_by(self, k: int, z: Floats) -> Floats:
        """Derivatives of the weighed equations by states k, without those whose multipliers are to be found."""
        weight = z.copy()
        weight[:, :, : (k + 1) * len(self.system.row_member)] = 0.0

        def of(values: Floats) -> Floats:
            found = self._residuals(self.system, *self._at_changed(k, values))
            return found.reshape(*values.shape[:2], -1)

        return by_states(of, Weights(weight, self._rows), self._unknowns(k))

    @cached_property
    def _rows(self) -> NDArray[np.int64]:
        """The node at which each equation is."""
        row = site_of_rows(self.system)
        own = np.repeat(sites(self.system)["node"], 3)[self.free] if self.of.asked.forces else np.zeros(0, np.int64)
        return np.concatenate([row, row, row, own]).astype(np.int64)

    # Weights of what is read.

    def _weights(self, seeds: Sequence[Seeds]) -> Floats:
        parts = []
        for name in self.names:
            shape = self.along[name].values.shape
            own = np.stack([one[name] if name in one else np.zeros(shape) for one in seeds])[:, self.at]
            parts.append(own.reshape(len(seeds), len(self.at), -1))
        return np.concatenate(parts, axis=2) if parts else np.zeros((len(seeds), len(self.at), 0))

    def _sites(self, name: str) -> NDArray[np.int64]:
        one, at = self.along[name], sites(self.system)
        shape = one.values.shape[1:]
        found = np.full(shape, -1)
        for k, dim in enumerate(one.dims[1:]):
            if (own := self.along.site(dim, at["node"], at["member"])) is not None:
                found[...] = own.reshape([-1 if j == k else 1 for j in range(len(shape))])
        return found.reshape(-1)

    # Derivatives by numbers at fixed states.

    def _masses(self) -> Floats:
        from kinetruss.mechanics.matrices import mass_by_nodes

        weight = np.repeat(self.mass[:, None], len(self.system.nodes), axis=1)
        by = self.by
        every = Weighed(lambda change: mass_by_nodes(by.changed(change)), weight, sites(self.system)["node"])
        return differences(every, by.near, STEP * by.scale, len(self._parts.index))

    def _by_numbers(self, z: Floats) -> Floats:
        by, count = self.by, len(self._parts.index)
        in_arrays = np.zeros(len(by.names), np.bool_)
        for _, which, slope in by.places.values():
            in_arrays[which[slope != 0.0]] = True
        alone = in_arrays & np.array([all(keys[0] in ARRAYS_ALONE for keys in own) for own in by.keys])
        used = {*self.site[np.abs(self.weight).max(axis=(0, 1), initial=0.0) > 0].tolist()}
        near = np.array([-1 in used or one is None or bool(used & one) for one in by.near])

        def weighed(parts: Sequence[tuple[Floats, NDArray[np.int64]]], of: Any) -> Weighed:
            weight = np.concatenate([value.reshape(len(value), -1) for value, _ in parts], axis=1)
            site = np.concatenate([np.tile(own, len(self.at)) for _, own in parts])
            kept = np.flatnonzero(np.abs(weight).max(axis=0, initial=0.0))
            return Weighed(lambda change: of(change)[kept], weight[:, kept], site[kept])

        equations, values = (-z, self._rows), (self.weight, self.site)

        def by_arrays(change: Floats) -> Floats:
            system = by.changed(change)
            return self._residuals(system, self._now(self.model, system), self.states, self.N).reshape(-1)

        def values_by_arrays(change: Floats) -> Floats:
            model = standing_for(by.changed(change))
            return self._values_at(model).reshape(-1)

        def values_by_records(change: Floats) -> Floats:
            return self._values_at(by.model_at(change)).reshape(-1)

        def by_records(change: Floats) -> Floats:
            model = by.model_at(change)
            given = self._now(model, compile(model))
            rest = self._residuals(compile(model), given, self.states, self.N)
            return np.concatenate([rest.reshape(-1), self._values_at(model).reshape(-1)])

        found = np.zeros((len(z), len(by.names)))
        for mask, one in (
            (in_arrays, weighed([equations], by_arrays)),
            (alone & near, weighed([values], values_by_arrays)),
            (in_arrays & ~alone & near, weighed([values], values_by_records)),
            (~in_arrays, weighed([equations, values], by_records)),
        ):
            if mask.any() and one.weight.shape[1]:
                found += differences(one, by.near, np.where(mask, STEP * by.scale, 0.0), count)
        return found

    def _now(self, model: Model, system: System) -> Prescribed:
        """What is prescribed, with other numbers; the same if these do not change it."""
        still = model is self.model and np.array_equal(system.drive_start, self.system.drive_start)
        moves = len(self.moving) > 0
        return self.given if still and not moves else self._prescribed(model, system)

    def _values_at(self, model: Model) -> Floats:
        system = compile(model)
        records = self.model if _same_records(model, self.model) else model
        return self._values(model, system, self._now(records, system), self.states, self.N)


def _same_records(one: Model, two: Model) -> bool:
    return one.nodes is two.nodes


def _factors(J: Any) -> Any:
    try:
        return splu(J.tocsc())
    except RuntimeError:
        raise AnalysisError("The position that the response reads is singular, so it has no gradient there.") from None


# The analyses.


def followed(system: System, trajectory: Any, samples: int = 201, *, times: ArrayLike | None = None) -> AlongPoint:
    """`kinematics.follow` along a trajectory, or along one of the model by its name."""
    return AlongPoint(system, Way(trajectory=trajectory, samples=samples, times=times), (None,), Asked())


def inverted(
    system: System, trajectory: Any, samples: int = 201, *, times: ArrayLike | None = None, load_case: str | None = None
) -> AlongPoint:
    """`dynamics.inverse` along the motion of a trajectory."""
    way = Way(trajectory=trajectory, samples=samples, times=times)
    return AlongPoint(system, way, (load_case,), Asked(forces=True))


def ran(system: System, run: str | None = None) -> AlongPoint:
    """A run of a model along a trajectory, with all that it tells."""
    job = plan(system.given, run)
    kinds = {"kinematics.follow": Asked(), "dynamics.inverse": Asked(forces=True, judged=True, stations=job.run.stations)}
    if job.run.analysis not in kinds or job.run.trajectory is None or job.condition is not None:
        raise InputError(
            f"Results of run {job.name!r} have no responses yet: those of runs along a trajectory do "
            f"({', '.join(kinds)}), without a condition."
        )
    return AlongPoint(system, Way(run=job.name, is_run=True), job.cases, kinds[job.run.analysis])
