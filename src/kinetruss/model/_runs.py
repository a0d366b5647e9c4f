"""What to compute: named runs."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from kinetruss.model._record import Name, Record, Whole
from kinetruss.model._trajectories import TrajectoryOrName

__all__ = ["Run"]


class Run(Record):
    """A named run of a model.

    analysis : ``dynamics.inverse`` (motion, forces, strength, drives) or ``kinematics.follow`` (motion only).
    trajectory : a trajectory or the name of one in the model; or `motion`, a node-history CSV (t, NODE.x, NODE.vx ...).
    samples : number of equally spaced instants, both ends included.
    load_cases : names; None runs all of the model's, or its plain loads where it has none.
    stations : equally spaced sections along each member, both ends included.
    """

    analysis: Literal["dynamics.inverse", "kinematics.follow"] = "dynamics.inverse"
    trajectory: TrajectoryOrName | None = None
    motion: str | None = None
    samples: Annotated[Whole, Field(ge=2, le=10_000_000)] = 201
    load_cases: tuple[Name, ...] | None = None
    stations: Annotated[Whole, Field(ge=2, le=1001)] = 7

    @model_validator(mode="after")
    def _one_motion(self) -> Run:
        if (self.trajectory is None) == (self.motion is None):
            has = "neither trajectory nor motion" if self.motion is None else "both trajectory and motion"
            raise ValueError(f"has {has}. Give one: trajectory, or motion (a node-history CSV).")
        return self
