"""Results along a given motion: of the motion, of its forces, and all that a run tells, with their gradients.

A largest value over time is that of one sample, and its derivative that at this sample: only the instants that a response reads
are computed again (`at_instants`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.dynamics.bearing_friction import seats_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.gradients.at_instants import Instants
from kinetruss.gradients.downstream import DEMAND, Along, Asked
from kinetruss.gradients.motion_rows import holding
from kinetruss.gradients.task_rows import task_rows
from kinetruss.gradients.varied import Varied, varied
from kinetruss.kinematics.motions import instants
from kinetruss.mechanics import System, arrange, compile
from kinetruss.mechanics.rigid_motions import floats
from kinetruss.model.load_cases import acting_cases
from kinetruss.runs.plans import chosen_run, conditioned

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.model import Model

    Floats = NDArray[np.float64]
    Seeds = Mapping[str, Floats]


@dataclass(frozen=True, eq=False)
class Way:
    """How a model moves: along a trajectory at so many samples or at times, or as in a run, by a trajectory or for a task."""

    run: str | None = None
    trajectory: Any = None
    samples: int = 201
    times: ArrayLike | None = None

    def of(self, model: Model) -> tuple[Any, Floats]:
        """The trajectory or task, and the instants (times,), s."""
        if self.run is not None:
            run = model.runs[self.run]
            given = run.targets or model.trajectory_of(run)
            return given, np.linspace(0.0, given.duration, run.samples)
        trajectory = model.trajectories.get(self.trajectory) if isinstance(self.trajectory, str) else self.trajectory
        if trajectory is None:
            return kinematics.follow(model, self.trajectory), np.zeros(0)  # it tells what is wrong
        return trajectory, instants(trajectory.duration, self.samples, self.times, model)


@dataclass(frozen=True)
class Conditioned:
    """Makes of a model the one under the condition of one of its runs, which then is a run without."""

    run: str

    def __call__(self, model: Model) -> Model:
        """The model under it.

        Raises
        ------
        AnalysisError : it changes lengths, holds drives or takes parts out, so that the motion is another.
        """
        found, run, condition = conditioned(model, model.runs[self.run])
        if condition is not None and condition.moves_otherwise:
            raise AnalysisError(
                f"Run {self.run!r} is under the condition {model.runs[self.run].condition!r}, which changes the motion "
                "(temperature; locked, released or failed parts); along such motions there are no gradients yet."
            )
        return found.with_(runs={self.run: run.with_(condition=None)})


class AlongPoint:
    """Results along a motion, with their gradients; through : as of `Varied`."""

    def __init__(
        self, system: System, way: Way, cases: tuple[str | None, ...], asked: Asked, through: Conditioned | None = None
    ) -> None:
        self.through = through
        self.system, self.model, self.way, self.cases, self.asked = system, system.given, way, cases, asked
        self.trajectory, self.times = way.of(self.model)
        self.led = way.run is not None and self.model.runs[way.run].targets is not None
        """Whether tasks lead the drives."""
        found = kinematics.inverse if self.led else kinematics.follow
        self.motion = found(self.model, self.trajectory, times=self.times)
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
        coords: dict[str, Any] = {name: own for name, own in names.items() if name != "time"} | {"time": self.times}
        return xr.Dataset(coords=coords | first.units())

    @cached_property
    def more(self) -> Mapping[str, Any]:
        """The variables, found when they are first read."""
        return _Users(self)

    def gradients(self, by: Varied, seeds: Sequence[Seeds]) -> Floats:
        """Derivatives (k, numbers) of k responses with seeds ds/dd by the variables that they read."""
        self._refuse(seeds)
        if self.through is not None:
            by = varied(by.model, by.paths, self.through)
        found = np.zeros((len(seeds), len(by.names)))
        for c in range(len(self.cases)):
            own = [{name: self._whole(name, one[name], c) for name in one} for one in seeds]
            if any(np.any(value) for one in own for value in one.values()):
                found += Instants(self, by, c, own).gradients()
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
        plan = arrange(holding(system)).plan
        why = ""
        if floats(system) is not None:
            why = "nothing holds the structure, so where it is depends on all that was before"
        elif self.led and len(system.coordinate_drive):
            why = "it is that of a task, for which drives move coordinates of nodes"
        elif self.led and (count := task_rows(system, self.trajectory, self.times[:1]).tasks) != len(system.drives):
            why = f"{len(system.drives)} drives do a task of {count} coordinates, and which of them moves how is a choice"
        elif plan is None:
            why = "drives and bars leave some of its coordinates free"
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

    def __iter__(self) -> Iterator[str]:
        return iter(self.of.by_case[0])

    def __len__(self) -> int:
        return len(self.of.by_case[0])


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
    """A run of a model along a trajectory or for a task, with all that it tells."""
    model = system.given
    name = chosen_run(model, run)
    own = model.runs[name]
    kinds = {"kinematics.follow": Asked(), "dynamics.inverse": Asked(forces=True, judged=True, stations=own.stations)}
    moves = own.targets is not None or model.trajectory_of(own) is not None
    if own.analysis not in kinds or not moves:
        raise InputError(
            f"Results of run {name!r} have no responses yet: those of runs along a trajectory or for a task do "
            f"({', '.join(kinds)})."
        )
    cases, through = acting_cases(model, own.load_cases), None
    if own.condition is not None:
        through = Conditioned(name)
        system = compile(through(model))
    return AlongPoint(system, Way(run=name), cases, kinds[own.analysis], through)
