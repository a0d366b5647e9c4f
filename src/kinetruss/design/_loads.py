"""Motions and load cases of a mission; motions are computed once, since they do not depend on the sections."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.errors import AnalysisError, InputError
from kinetruss.model import Mission, Model
from kinetruss.model.motion import FLEXIBLE, MISSION, STATIC
from kinetruss.results import Forces, Motion
from kinetruss.runs.blocks import SIMULATED, plan

MOVING = ("dynamics.inverse", "kinematics.follow")
"""Analyses whose motion does not depend on the sections."""

__all__ = ["Loading", "forces_of", "loadings"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Loading:
    """A motion under a load case. name : of the case, with the run before it where there are several runs."""

    name: str
    run: str
    case: str | None
    motion: Motion

    def at(self, samples: Iterable[int]) -> Loading:
        """The same at some samples only."""
        chosen = np.array(sorted(samples), np.int64)
        return Loading(
            name=self.name,
            run=self.run,
            case=self.case,
            motion=self.motion.with_(data=self.motion.data.isel(time=chosen)),
        )


def loadings(model: Model, mission: Mission) -> list[Loading]:
    """Every run of a mission under every load case.

    Raises
    ------
    AnalysisError : the path of a run ends early.
    InputError : a run is a simulation.
    """
    found = []
    names = mission.runs or tuple(name for name, run in model.runs.items() if run.analysis in MOVING)
    names = tuple(dict.fromkeys(one for name in names for one in _moving(model, name)))
    for name in names:
        job = plan(model, name)
        motion = job.given
        if job.run.analysis == SIMULATED:
            raise InputError(
                f"Run {name!r} is a simulation, whose motion depends on the sections. Name runs with a prescribed motion."
            )
        if motion is None:
            motion = kinematics.follow(model, model.trajectory_of(job.run), times=job.times, raise_on_failure=False)
        if not motion.status.ok:
            raise AnalysisError(f"Run {name!r} ends early: {motion.message or motion.status.value}", motion)
        for case in mission.load_cases or job.cases:
            label = case or "all"
            found.append(Loading(name=f"{name}/{label}" if len(names) > 1 else label, run=name, case=case, motion=motion))
    return found


def _moving(model: Model, name: str) -> tuple[str, ...]:
    """A run, or the runs that a mission run names as motions."""
    run = model.runs.get(name)
    if run is None or run.analysis != MISSION:
        if run is not None and (run.analysis in (*STATIC, *FLEXIBLE) or run.condition is not None):
            still = "stands still" if run.analysis in STATIC else f"is {run.analysis}"
            what = still if run.condition is None else f"has the condition {run.condition!r}"
            raise InputError(f"Run {name!r} {what}, so it cannot be sized for. Name runs of dynamics.inverse.")
        return (name,)
    if run.conditions:
        raise InputError(f"Run {name!r} has conditions, which a sizing does not take. Name its motions, or make runs of them.")
    if lacking := [motion for motion in run.motions if motion not in model.runs]:
        raise InputError(f"Run {name!r} moves along {lacking[0]!r}, which is a trajectory. Make a run of it, to be sized for.")
    return run.motions


def forces_of(model: Model, loadings: Iterable[Loading]) -> dict[str, Forces]:
    """Forces of every loading by its name."""
    return {one.name: dynamics.inverse(model, one.motion, one.case, static=False) for one in loadings}
