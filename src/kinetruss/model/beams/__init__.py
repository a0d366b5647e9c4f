"""Beams: members that bend and twist, and the frames that carry the rotations of their ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.model.beams.framing import (
        axes_of_beam,
        carriers_of,
        chords,
        expanded,
        frame_of,
        frames,
        rigid_beams,
        rigid_groups,
        shape_bars,
    )
    from kinetruss.model.beams.shown import CHORD, FRAME, shown_kinds, shown_names

__all__ = [
    "CHORD",
    "FRAME",
    "axes_of_beam",
    "carriers_of",
    "chords",
    "expanded",
    "frame_of",
    "frames",
    "rigid_beams",
    "rigid_groups",
    "shape_bars",
    "shown_kinds",
    "shown_names",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "framing": "axes_of_beam carriers_of chords expanded frame_of frames rigid_beams rigid_groups shape_bars",
        "shown": "CHORD FRAME shown_kinds shown_names",
    },
)
