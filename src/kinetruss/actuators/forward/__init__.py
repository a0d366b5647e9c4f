"""Drive trains fed with a voltage, a current or a torque."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.actuators.forward.integrate import STIFF, felt
    from kinetruss.actuators.forward.pieces import in_currents, kinks, longest_step, piece_of, source_of
    from kinetruss.actuators.forward.place_poles import gains_of
    from kinetruss.actuators.forward.plant import Feed, Mode, Piece, Plant, Seen, feed, observe, plant_of

__all__ = [
    "Feed", "Mode", "Piece", "Plant", "STIFF", "Seen", "feed", "felt", "gains_of", "in_currents", "kinks",
    "longest_step", "observe", "piece_of", "plant_of", "source_of",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "integrate": "STIFF felt",
        "pieces": "in_currents kinks longest_step piece_of source_of",
        "place_poles": "gains_of",
        "plant": "Feed Mode Piece Plant Seen feed observe plant_of",
    },
)
