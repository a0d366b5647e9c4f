"""Beams as elements whose energy is quadratic in the squared distances of their nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.beams.elements import MODES, BeamElements, beam_elements
    from kinetruss.mechanics.beams.forces import beam_forces, section_forces
    from kinetruss.mechanics.beams.modes import (
        damping_forces,
        damping_tangents,
        mode_gradients,
        mode_rates,
        mode_stiffness,
        pairs_of,
    )

__all__ = [
    "MODES",
    "BeamElements",
    "beam_elements",
    "beam_forces",
    "damping_forces",
    "damping_tangents",
    "mode_gradients",
    "mode_rates",
    "mode_stiffness",
    "pairs_of",
    "section_forces",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "elements": "MODES BeamElements beam_elements",
        "forces": "beam_forces section_forces",
        "modes": "damping_forces damping_tangents mode_gradients mode_rates mode_stiffness pairs_of",
    },
)
