"""A run at given instants: its forces without computing the whole run, and results that follow from motion and forces."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kinematics.motions import instants
from kinetruss.model import Model
from kinetruss.model.runs import STATIC
from kinetruss.model.table import missing
from kinetruss.runs.at_rest import along, standing
from kinetruss.runs.plans import SIMULATED, Plan, followed, plan

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.results import Demand, Forces, Motion, Sections


# Forces of a run at given instants, without computing the whole run.

STEPS = 200
"""Number of instants before the first requested one, so that the path is followed in the same way as in the run."""


def forces_at(model: Model, name: str | None, times: ArrayLike, *, load_case: str | None = None) -> Forces:
    """Forces of a named run exactly at the given instants.

    Parameters
    ----------
    name : a run of the model; may be omitted if there is only one. times : s, increasing.
    load_case : name; by default the run's first.

    Returns
    -------
    Forces with one sample per instant, with their motion and static forces. For a run that follows a motion file, at its
    samples nearest to the instants.

    Raises
    ------
    InputError : no such run or load case, an instant outside the run.
    AnalysisError : the path ends early.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> forces = kt.runs.forces_at(model, "turn", [0.25, 0.75])
    >>> forces.time.values.tolist()  # s
    [0.25, 0.75]
    """
    job = plan(model, name)
    t = instants(0.0, 2, times)
    _inside(job, t)
    return _forces(job, t, load_case)


def forces_at_peak(model: Model, name: str | None, members: tuple[str, ...], *, load_case: str | None = None) -> Forces:
    """Forces of a named run at its sample with the largest member force of `members` (if empty, of all).

    Raises as `forces_at`.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> forces = kt.runs.forces_at_peak(model, "turn", ("coupler",))
    >>> forces.time.values.round(2).tolist()  # s
    [0.3]
    """
    job = plan(model, name)
    every = max(1, len(job.times) // 2000)  # of a long run, only equally spaced samples are checked
    forces = _forces(job, job.times[::every], load_case)
    shown = forces.whole["member_force"].sel(member=list(members) or list(model.members))
    k = int(np.argmax(np.abs(shown.values).max(axis=1, initial=0.0)))
    return _only(forces, np.array([k]))


def forces_at_rest(model: Model, *, load_case: str | None = None) -> Forces:
    """Forces of a model in its own pose at rest, for models without a run.

    Raises
    ------
    InputError : no such load case, a mechanism with fewer drives than freedoms.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> forces.member_force.values.round(3).tolist()  # N: compression of the strut, tension of the tie
    [[-1000.0, 1414.214]]
    """
    position = kinematics.assemble(model)
    still = np.zeros((1, *position.shape))
    return dynamics.inverse(model, kinematics.from_arrays(model, [0.0], position[None], still, still), load_case)


def _only(forces: Forces, samples: NDArray[np.int64]) -> Forces:
    """Some of the samples, with their motion and static forces."""
    here = {"time": samples}
    static = None if forces.static is None else forces.static.with_(data=forces.static.whole.isel(here))
    motion = forces.motion.with_(data=forces.motion.whole.isel(here))
    return forces.with_(data=forces.whole.isel(here), motion=motion, static=static)


def _forces(job: Plan, t: NDArray[np.float64], load_case: str | None) -> Forces:
    """Forces at the instants t; those of a simulation come from its integration, those of a static run are without inertia."""
    case = _case(job, load_case)
    if job.run.analysis in STATIC and job.run.analysis != "statics.deflection":
        one = replace(job, cases=(case,))
        if job.given is not None or job.run.trajectory is not None:
            return next(iter(along(one, _motion(job, t)).forces.values()))
        found = standing(one)
        if not found.forces:
            raise AnalysisError(found.motion.message, found.motion)
        nearest = np.unique(np.abs(job.times[:, None] - t).argmin(axis=0))
        return _only(next(iter(found.forces.values())), nearest)
    if job.run.analysis != SIMULATED:
        return dynamics.inverse(job.model, _motion(job, t), case)

    if load_case is not None and case != job.cases[0]:
        raise InputError(f"Run {job.name!r} is simulated under load case {job.cases[0] or 'all'!r} only.")
    from kinetruss.runs.simulated import simulated_at

    return simulated_at(job, t).forces


def _case(job: Plan, load_case: str | None) -> str | None:
    if load_case is None:
        return job.cases[0]
    return None if load_case == "all" and not job.model.cases else load_case


def _inside(job: Plan, t: NDArray[np.float64]) -> None:
    first, last = job.times[0], job.times[-1]
    slack = 1e-9 * (last - first)
    outside = t[~((t >= first - slack) & (t <= last + slack))]
    if len(outside):
        raise InputError(f"{outside[0]:g} s is outside the run {job.name!r}, {first:g} s to {last:g} s. Choose a time inside.")


def _motion(job: Plan, t: NDArray[np.float64]) -> Motion:
    """The motion at the instants t."""
    if job.given is not None:
        nearest = np.unique(np.abs(job.times[:, None] - t).argmin(axis=0))
        return job.given.with_(data=job.given.whole.isel(time=nearest))
    # from the start of the path, not directly from the model's pose to the requested one
    lead = np.linspace(job.times[0], t[0], STEPS, endpoint=False) if t[0] > job.times[0] else np.zeros(0)
    t = np.clip(t, job.times[0], job.times[-1])
    motion = followed((job.origin, job.model), job.condition, job.run.trajectory, np.concatenate([lead, t]))
    return motion.with_(data=motion.whole.isel(time=slice(len(lead), None)))


# Results of short variants that are not stored because they follow from motion and forces; computed on first access.

T = TypeVar("T")
DERIVED = ("static", "sections", "demand")
"""Kinds of results that may be under ``derived`` in a ledger."""


class Later(Mapping[str, T]):
    """A mapping whose values are computed on first access."""

    def __init__(self, names: Sequence[str], make: Callable[[str], T]) -> None:
        self._names, self._make = tuple(names), make
        self._made: dict[str, T] = {}

    def __getitem__(self, name: str) -> T:
        if name not in self._names:
            raise missing(name, self._names)
        if name not in self._made:
            self._made[name] = self._make(name)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def derived(
    model: Model, motion: Motion, stored: Mapping[str, Forces], stations: int
) -> tuple[Mapping[str, Forces], Mapping[str, Sections], Mapping[str, Demand]]:
    """Forces with those at rest, section forces and motor demands by load case, from motion and stored forces."""

    def with_static(case: str) -> Forces:
        from kinetruss import dynamics

        again = dynamics.inverse(model, motion, case if case in model.cases else None)
        return stored[case].with_(static=again.static)

    def sections(case: str) -> Sections:
        from kinetruss import strength

        return strength.sections(model, stored[case], stations=stations)

    def demand(case: str) -> Demand:
        from kinetruss import actuators

        return actuators.evaluate(model, motion, stored[case])

    cases = list(stored)
    return Later(cases, with_static), Later(cases, sections), Later(cases if model.actuators else (), demand)
