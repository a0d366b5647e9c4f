"""Results of consecutive samples of a run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from kinetruss import actuators, strength
from kinetruss.results import Demand, Forces, Motion, Result, Sections, Simulation, Verdict

if TYPE_CHECKING:
    from numpy.typing import NDArray

from kinetruss.runs.blocks.planned import Plan

__all__ = ["Block", "judged"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Block:
    """Results of consecutive samples, by load case; `verdict` over all cases.

    statics : of static analyses, with a time axis.
    simulation : for a simulated motion; `state` is the state of its integration after the block.
    """

    motion: Motion
    forces: dict[str, Forces]
    sections: dict[str, Sections]
    demand: dict[str, Demand]
    verdict: Verdict | None
    statics: Mapping[str, Result] = field(default_factory=dict)
    simulation: Simulation | None = None
    state: Mapping[str, NDArray[Any]] | None = None

    def with_(self, **changes: Any) -> Block:
        """The block with some fields changed."""
        return replace(self, **changes)


def judged(plan: Plan, motion: Motion, forces: dict[str, Forces]) -> Block:
    """Results that follow from the forces: sections, utilisation, motor demands."""
    model, stations = plan.model, plan.run.stations
    if plan.bare:
        return Block(motion=motion, forces=forces, sections={}, demand={}, verdict=None)
    if not plan.full:
        return Block(motion=motion, forces=forces, sections={}, demand={}, verdict=strength.check(model, forces))
    return Block(
        motion=motion,
        forces=forces,
        sections={case: strength.sections(model, one, stations=stations) for case, one in forces.items()},
        demand={case: actuators.evaluate(model, motion, one) for case, one in forces.items()} if model.actuators else {},
        verdict=strength.check(model, forces),
    )
