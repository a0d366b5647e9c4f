"""Motions and load cases of a mission; motions are computed once, since they do not depend on the sections."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.errors import AnalysisError, InputError
from kinetruss.model import Mission, Model
from kinetruss.results import Forces, Motion
from kinetruss.runs.blocks import SIMULATED, plan

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
    names = mission.runs or tuple(name for name, run in model.runs.items() if run.analysis != SIMULATED)
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


def forces_of(model: Model, loadings: Iterable[Loading]) -> dict[str, Forces]:
    """Forces of every loading by its name."""
    return {one.name: dynamics.inverse(model, one.motion, one.case, static=False) for one in loadings}
