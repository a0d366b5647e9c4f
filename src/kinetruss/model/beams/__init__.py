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
        hinges,
        rigid_beams,
        rigid_groups,
        shape_bars,
    )
    from kinetruss.model.beams.free_spins import SPIN, Spin, spin_note, spins
    from kinetruss.model.beams.links import line_advice, middle_pins, shared_rotations
    from kinetruss.model.beams.shown import CHORD, FRAME, shown_kinds, shown_names

__all__ = [
    "CHORD",
    "FRAME",
    "SPIN",
    "Spin",
    "axes_of_beam",
    "carriers_of",
    "chords",
    "expanded",
    "frame_of",
    "frames",
    "hinges",
    "line_advice",
    "middle_pins",
    "rigid_beams",
    "rigid_groups",
    "shape_bars",
    "shared_rotations",
    "shown_kinds",
    "shown_names",
    "spin_note",
    "spins",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "framing": "axes_of_beam carriers_of chords expanded frame_of frames hinges rigid_beams rigid_groups shape_bars",
        "links": "line_advice middle_pins shared_rotations",
        "free_spins": "SPIN Spin spin_note spins",
        "shown": "CHORD FRAME shown_kinds shown_names",
    },
)
