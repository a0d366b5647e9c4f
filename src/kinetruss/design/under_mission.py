"""A task of an optimum for a mission: its limits in all runs and load cases; parts of the catalogues for what was found."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kinetruss.design.model_function import ModelFunction
from kinetruss.design.sizing import size
from kinetruss.design.sizing_result import Sizing
from kinetruss.design.tube_choice import runs_of
from kinetruss.errors import Fault, ModelError
from kinetruss.io import read_mission
from kinetruss.model import Mission, Model, OptimumTask, mission_faults


@dataclass(frozen=True, kw_only=True, eq=False)
class Listed:
    """An optimum with parts from catalogues.

    sizing : the parts, with their proof. objective : of the sized model; NaN if it was a number of a part that is replaced.
    excess : the largest of all limits of the task, of their sizes; limit : which.
    """

    sizing: Sizing
    objective: float
    excess: float
    limit: str


def under(model: Model, task: OptimumTask, mission: Mission | str | Path) -> tuple[Model, OptimumTask, Mission]:
    """The model with the safety factors and load cases of a mission, and the task with each limit in every run.

    Raises
    ------
    ModelError : faults of the mission; a task that names load cases, or an analysis for all of its limits.
    """
    mission = mission if isinstance(mission, Mission) else read_mission(mission)
    if found := mission_faults(model, mission):
        raise ModelError(found)
    faults = []
    if task.analysis != OptimumTask.model_fields["analysis"].default or task.arguments:
        where = "arguments" if task.arguments else "analysis"
        faults.append(Fault((where,), "is given by the runs of the mission.", "Leave it out, or name it in single limits."))
    places: list[tuple[str, ...]]
    places = [("limits", name, "load_cases") for name, one in task.limits.items() if one.analysis is None and one.load_cases]
    places += [("load_cases",)] if task.load_cases else []
    faults += [Fault(place, "are those of the mission.", "Name them there.") for place in places]
    if faults:
        raise ModelError(faults)
    runs = runs_of(model, mission)
    limits = {}
    for name, one in task.limits.items():
        if one.analysis is not None:
            limits[name] = one
            continue
        for run in runs:
            own = one.with_(analysis="runs.run", arguments={**one.arguments, "run": run})
            limits[name if len(runs) == 1 else f"{name}.{run}"] = own
    if len(limits) < sum(1 if one.analysis is not None else len(runs) for one in task.limits.values()):
        raise ModelError([Fault(("limits",), "has a name that is also that of another limit in a run.", "Rename one of them.")])
    changed = {name: model.runs[name].with_(load_cases=mission.load_cases) for name in runs if mission.load_cases}
    given = model.with_(safety=mission.safety or model.safety, runs={**model.runs, **changed})
    return given, task.with_(analysis="runs.run", arguments={"run": runs[0]}, limits=limits), mission


def listed(function: ModelFunction, model: Model, mission: Mission) -> Listed:
    """The parts of the catalogues that serve a model, its objective with them, and whether it keeps the limits.

    Raises
    ------
    AnalysisError : no part of a catalogue is sufficient.
    """
    sizing = size(model, mission)
    objective, excess, limit = function.judged(sizing.model)
    return Listed(sizing=sizing, objective=objective, excess=excess, limit=limit)
