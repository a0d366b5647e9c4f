"""What pictures show of beams: their chords. The nodes and bars of frames are left out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.model.beams.framing import chords
from kinetruss.model.parts.bracing import CHORD
from kinetruss.model.parts.members import Active

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData

__all__ = ["CHORD", "FRAME", "shown_kinds", "shown_names"]

FRAME = "frame"
"""Kind of the bars of frames, which pictures leave out."""


def shown_kinds(model: ModelData) -> dict[str, str]:
    """The kind that pictures show of each member: ``active``, or the kind of the bar; of the chord of a beam ``beam``, or
    ``rigid``; ``frame`` of bars that end at a node of a frame.
    """
    found = {name: "active" if isinstance(one, Active) else one.kind for name, one in model.members.items()}
    if not model.beams:
        return found
    beams = zip(chords(model), (beam.kind for beam in model.beams.values()), strict=False)
    found |= {chord: "beam" if kind == "elastic" else "rigid" for chord, kind in beams if chord in found}
    directors = {name for name, node in model.nodes.items() if node.director}
    found |= {name: FRAME for name, one in model.members.items() if directors & set(one.ends)}
    return found


def shown_names(model: ModelData) -> dict[str, str]:
    """The name that pictures show of each member: of the chord of a beam that of the beam."""
    beams = {f"{name}{CHORD}": name for name in model.beams}
    return {name: beams.get(name, name) for name in model.members}
