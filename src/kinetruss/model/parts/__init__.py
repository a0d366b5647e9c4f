"""The parts of a structure: nodes, bars, bodies, membranes, sections, loads, gauges."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.model.parts.body_mass import (
        barycentric,
        carried,
        fixed_vector,
        inertia_of,
        on_carriers,
        placed,
        principal,
        quality,
        second_moments,
    )
    from kinetruss.model.parts.members import EndCondition
    from kinetruss.model.parts.sections import Section

__all__ = [
    "EndCondition",
    "Section",
    "barycentric",
    "carried",
    "fixed_vector",
    "inertia_of",
    "on_carriers",
    "placed",
    "principal",
    "quality",
    "second_moments",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "body_mass": "barycentric carried fixed_vector inertia_of on_carriers placed principal quality second_moments",
        "members": "EndCondition",
        "sections": "Section",
    },
)
