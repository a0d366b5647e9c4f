"""A model compiled to flat arrays, and the order in which its constraints are solved."""

from kinetruss.kernels.structure.plan import CABLE, ENGINEERING, GREEN, NONE
from kinetruss.mechanics.beams import BeamElements
from kinetruss.mechanics.kept import kept
from kinetruss.mechanics.structure.arrange import Arrangement, arrange, eliminated, not_unique_note, plan_of, rearrange
from kinetruss.mechanics.structure.blocks import block_triangular
from kinetruss.mechanics.structure.constraint_gradients import (
    RANK_TOLERANCE,
    constraint_curvature,
    constraint_gradients,
    constraint_jacobian,
    direction_rates,
    ends_of,
    jacobian,
    row_directions,
    row_ends,
    row_scales,
    turned,
)
from kinetruss.mechanics.structure.continua import Continua, Patch, element_points, gradients, law_matrix, without_beams
from kinetruss.mechanics.structure.hessians import measure_curvature, measure_hessian, measure_turning
from kinetruss.mechanics.structure.measure_arrays import axes_of, is_measured
from kinetruss.mechanics.structure.measures import coordinate_derivatives, flats_of, measure_gradients, measured
from kinetruss.mechanics.structure.system import DRIVEN, ELASTIC, FREE, RIGID, ByIdentity, System, compile

__all__ = [
    "BeamElements",
    "CABLE",
    "Continua",
    "DRIVEN",
    "ELASTIC",
    "ENGINEERING",
    "FREE",
    "GREEN",
    "NONE",
    "RANK_TOLERANCE",
    "Patch",
    "RIGID",
    "Arrangement",
    "ByIdentity",
    "System",
    "arrange",
    "axes_of",
    "block_triangular",
    "compile",
    "constraint_curvature",
    "constraint_gradients",
    "constraint_jacobian",
    "coordinate_derivatives",
    "direction_rates",
    "element_points",
    "eliminated",
    "ends_of",
    "flats_of",
    "gradients",
    "is_measured",
    "jacobian",
    "kept",
    "law_matrix",
    "measure_curvature",
    "measure_gradients",
    "measure_hessian",
    "measure_turning",
    "measured",
    "not_unique_note",
    "plan_of",
    "rearrange",
    "row_directions",
    "row_ends",
    "row_scales",
    "turned",
    "without_beams",
]
