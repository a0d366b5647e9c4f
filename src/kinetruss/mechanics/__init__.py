"""A model compiled to flat arrays, and the order in which its constraints are solved."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.elements.beams import BeamElements as BeamElements
    from kinetruss.elements.caching import cached as cached
    from kinetruss.elements.continua_arrays import (
        Continua as Continua,
        Patch as Patch,
        element_points as element_points,
        gradients as gradients,
        law_matrix as law_matrix,
    )
    from kinetruss.elements.local_axes import turned as turned
    from kinetruss.kernels.structure.structure import CABLE as CABLE, ENGINEERING as ENGINEERING, GREEN as GREEN, NONE as NONE
    from kinetruss.mechanics.arrangement import (
        Arrangement as Arrangement,
        arrange as arrange,
        block_triangular as block_triangular,
        eliminated as eliminated,
        not_unique_at_notes as not_unique_at_notes,
        not_unique_note as not_unique_note,
        plan_of as plan_of,
        rearrange as rearrange,
    )
    from kinetruss.mechanics.measure_arrays import axes_of as axes_of, is_measured as is_measured
    from kinetruss.mechanics.measures import (
        coordinate_derivatives as coordinate_derivatives,
        flats_of as flats_of,
        measure_curvature as measure_curvature,
        measure_gradients as measure_gradients,
        measure_hessian as measure_hessian,
        measure_of as measure_of,
        measure_turning as measure_turning,
        measured as measured,
    )
    from kinetruss.mechanics.members import DRIVEN as DRIVEN, ELASTIC as ELASTIC, FREE as FREE, RIGID as RIGID
    from kinetruss.mechanics.row_gradients import (
        RANK_TOLERANCE as RANK_TOLERANCE,
        constraint_curvature as constraint_curvature,
        constraint_gradients as constraint_gradients,
        constraint_jacobian as constraint_jacobian,
        direction_rates as direction_rates,
        ends_of as ends_of,
        jacobian as jacobian,
        row_directions as row_directions,
        row_ends as row_ends,
        row_scales as row_scales,
    )
    from kinetruss.mechanics.system import ByIdentity as ByIdentity, System as System, compile as compile

__getattr__, __dir__, __all__ = late(__name__)
