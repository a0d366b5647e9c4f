"""The pairs of a mission: which motion is done under which condition and load case."""

from __future__ import annotations

from dataclasses import dataclass

from kinetruss.errors import InputError
from kinetruss.model import Model, Run

__all__ = ["Pair", "pairs_of"]

GOVERNING = "pair"
"""Start of the name that a pair has as a run of its own."""


@dataclass(frozen=True, slots=True)
class Pair:
    """A motion under a condition and a load case; None: the model as it is, and all loads."""

    number: int
    motion: str
    condition: str | None
    load_case: str | None

    @property
    def label(self) -> str:
        """What people read: motion, condition, load case."""
        return ", ".join(one for one in (self.motion, self.condition, self.load_case) if one)

    def run_of(self, model: Model, mission: Run) -> Run:
        """The pair as a run of its own."""
        cases = None if self.load_case is None else (self.load_case,)
        if self.motion in model.runs:
            return model.runs[self.motion].with_(condition=self.condition, load_cases=cases)
        run = Run(trajectory=self.motion, samples=mission.samples, stations=mission.stations)
        return run.with_(condition=self.condition, load_cases=cases)

    def alone(self, model: Model, mission: Run) -> tuple[Model, str]:
        """A model with the pair as a run, and the name of that run."""
        name = f"{GOVERNING}{self.number + 1}"
        while name in model.runs:
            name += "_"
        run = self.run_of(model, mission)
        if run.analysis == "kinematics.follow":
            run = run.with_(analysis="dynamics.inverse")
        return model.with_(runs={**model.runs, name: run}), name


def pairs_of(model: Model, name: str) -> list[Pair]:
    """All pairs of a mission, motion by motion, then condition by condition.

    Raises
    ------
    InputError : the run is no mission.
    """
    mission = model.runs[name]
    if not mission.motions:
        raise InputError(f"Run {name!r} is no mission. Give it analysis: mission and motions.")
    conditions: tuple[str | None, ...] = mission.conditions or (None,)
    found: list[Pair] = []
    for motion in mission.motions:
        own = model.runs[motion].load_cases if motion in model.runs else None
        cases: tuple[str | None, ...] = mission.load_cases or own or tuple(model.load_cases) or (None,)
        for condition in conditions:
            for case in cases:
                found.append(Pair(len(found), motion, condition, case))
    return found
