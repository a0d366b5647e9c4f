"""Mobility: rank, coordinates by name, chosen degrees of freedom, and transfer functions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.freedom.named import (
        Coordinate,
        coordinate_gradients,
        coordinate_rows,
        coordinate_values,
        coordinates,
        is_prescribed,
        row_of,
    )
    from kinetruss.mechanics.freedom.rank import Mobility, afloat, mobility, mobility_at, underdriven
    from kinetruss.mechanics.freedom.rows import (
        Basis,
        chosen_dofs,
        derivatives_of,
        dof_basis,
        first_order_of,
        released,
        second_order_of,
    )
    from kinetruss.mechanics.freedom.shapes import HeldShapes, held_shapes, shaped
    from kinetruss.mechanics.freedom.strained import Deformations, beam_deformations, deformations
    from kinetruss.mechanics.freedom.transfer import contradicted, displacements, flat_positions, transfers

__all__ = [
    "Basis",
    "Coordinate",
    "Deformations",
    "HeldShapes",
    "Mobility",
    "afloat",
    "beam_deformations",
    "chosen_dofs",
    "contradicted",
    "coordinate_gradients",
    "coordinate_rows",
    "coordinate_values",
    "coordinates",
    "deformations",
    "displacements",
    "dof_basis",
    "first_order_of",
    "flat_positions",
    "held_shapes",
    "is_prescribed",
    "derivatives_of",
    "mobility",
    "mobility_at",
    "released",
    "row_of",
    "second_order_of",
    "shaped",
    "transfers",
    "underdriven",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "strained": "Deformations beam_deformations deformations",
        "named": "Coordinate coordinate_gradients coordinate_rows coordinate_values coordinates is_prescribed row_of",
        "rank": "Mobility afloat mobility mobility_at underdriven",
        "rows": "Basis chosen_dofs dof_basis first_order_of derivatives_of released second_order_of",
        "shapes": "HeldShapes held_shapes shaped",
        "transfer": "contradicted displacements flat_positions transfers",
    },
)
