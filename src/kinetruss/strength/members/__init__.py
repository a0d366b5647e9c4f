"""Inside members and elements: section forces, stresses."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.strength.members.inputs import histories
    from kinetruss.strength.members.parts import parts_of
    from kinetruss.strength.members.skins import skin_stress

__all__ = ["histories", "parts_of", "skin_stress"]

__getattr__, __dir__ = late(
    __name__,
    {
        "inputs": "histories",
        "parts": "parts_of",
        "skins": "skin_stress",
    },
)
