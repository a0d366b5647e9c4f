"""Result of a sizing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from kinetruss.model import Mission, Model
from kinetruss.results import Demand, Verdict

__all__ = ["DriveRow", "GroupRow", "Sizing"]


@dataclass(frozen=True, slots=True, kw_only=True)
class GroupRow:
    """One group of members: tube and mass (kg) before and after, the governing check, and why no smaller tube is sufficient.

    utilisation_before, utilisation : the highest of its members (NaN if nothing could be checked before), by `rule` in
    `part` at `time` s under `load_case`. smaller : the tube one size smaller, "" if the tube is the smallest of the catalogue;
    with it `smaller_part` reaches `smaller_utilisation` by `smaller_rule`.
    """

    name: str
    members: tuple[str, ...]
    tube_before: str
    tube: str
    mass_before: float
    mass: float
    utilisation_before: float
    utilisation: float
    part: str
    rule: str
    time: float
    load_case: str
    smaller: str
    smaller_utilisation: float
    smaller_part: str
    smaller_rule: str


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveRow:
    """One group of active members: screw, gear and motor by name (before and after; "" none), and the governing quantity.

    utilisation : highest demand over limit, without the margin; the required margin holds if it is at most 1/margin.
    tried : number of combinations checked. against : why no smaller motor was chosen.
    """

    name: str
    members: tuple[str, ...]
    before: tuple[str, str, str]
    screw: str
    gear: str
    motor: str
    self_locking: bool
    utilisation: float
    quantity: str
    member: str
    time: float
    load_case: str
    tried: int
    against: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Sizing:
    """A sized model with its proof.

    model : with the tubes and drives chosen, and the safety factors of the mission. groups, drives : the tables.
    mass_before, mass_after : of all members, kg (no lumped masses). iterations : number of times that masses were fed back.
    settled : largest relative difference between the member forces by which the tubes were chosen and those of the model.
    verdict : of the sized model over all runs and load cases (every utilisation is at most 1); before : of the given one.
    demand : of the sized model by loading. notes : remarks for the reader.
    """

    model: Model
    mission: Mission
    groups: tuple[GroupRow, ...]
    drives: tuple[DriveRow, ...]
    mass_before: float
    mass_after: float
    iterations: int
    settled: float
    verdict: Verdict
    before: Verdict
    demand: Mapping[str, Demand] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    provenance: Mapping[str, Any] = field(default_factory=dict)

    @property
    def mass_saved(self) -> float:
        """kg; negative if the given model was too weak."""
        return self.mass_before - self.mass_after
