"""Rules and the verdict."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.strength.verdict.beams import beam_sections, middle_forces
    from kinetruss.strength.verdict.by_member import highest, strength_histories, unchecked, worst_of
    from kinetruss.strength.verdict.governing import Governing, Headline, headline
    from kinetruss.strength.verdict.notes import beyond_euler

__all__ = [
    "Governing",
    "Headline",
    "beam_sections",
    "beyond_euler",
    "headline",
    "highest",
    "middle_forces",
    "strength_histories",
    "unchecked",
    "worst_of",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "beams": "beam_sections middle_forces",
        "by_member": "highest strength_histories unchecked worst_of",
        "notes": "beyond_euler",
        "governing": "Governing Headline headline",
    },
)
