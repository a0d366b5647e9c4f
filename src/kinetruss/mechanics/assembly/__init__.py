"""Elements of a structure and what they give: masses, loads, stiffness."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.assembly.balance import (
        Balance,
        balance_of,
        balanced_rows,
        measure_forces,
        row_tensions,
        sum_stiffness,
    )
    from kinetruss.mechanics.assembly.cases import ROTATES, Loads, case_loads
    from kinetruss.mechanics.assembly.continua import (
        beam_losses,
        continua_arrays,
        continua_geometric,
        continua_stiffness,
        densities,
        material_stiffness,
        resting_forces,
        squared_changes,
        strain_balance,
    )
    from kinetruss.mechanics.assembly.followers import Follower, history_of, on_ground, unit_loads_of
    from kinetruss.mechanics.assembly.laws import bar_laws
    from kinetruss.mechanics.assembly.massless import refuse_massless
    from kinetruss.mechanics.assembly.matrices import (
        body_and_continua_mass,
        mass_matrix,
        tangents,
        turning_inertia,
        turning_members,
    )
    from kinetruss.mechanics.assembly.springs import (
        SpringHistories,
        refuse_turns,
        spring_forces,
        spring_laws,
        spring_motions,
    )
    from kinetruss.mechanics.assembly.tables import (
        body_masses,
        continua_mass,
        elements,
        nodal_loads,
        pair_weights,
        pins_of,
        structure_of,
    )

__all__ = [
    "Balance",
    "Follower",
    "Loads",
    "ROTATES",
    "SpringHistories",
    "balance_of",
    "balanced_rows",
    "bar_laws",
    "body_masses",
    "body_and_continua_mass",
    "case_loads",
    "beam_losses",
    "continua_arrays",
    "continua_geometric",
    "continua_mass",
    "continua_stiffness",
    "densities",
    "elements",
    "history_of",
    "mass_matrix",
    "material_stiffness",
    "nodal_loads",
    "pair_weights",
    "pins_of",
    "with_continua_forces",
    "on_ground",
    "unit_loads_of",
    "refuse_massless",
    "refuse_turns",
    "resting_forces",
    "row_tensions",
    "spring_forces",
    "spring_laws",
    "spring_motions",
    "squared_changes",
    "strain_balance",
    "structure_of",
    "sum_stiffness",
    "measure_forces",
    "tangents",
    "turning_inertia",
    "turning_members",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "balance": "Balance balance_of balanced_rows row_tensions measure_forces sum_stiffness",
        "cases": "ROTATES Loads case_loads",
        "continua": (
            "beam_losses continua_arrays continua_geometric continua_stiffness densities material_stiffness resting_forces "
            "squared_changes strain_balance with_continua_forces"
        ),
        "followers": "Follower history_of on_ground unit_loads_of",
        "laws": "bar_laws",
        "massless": "refuse_massless",
        "matrices": "body_and_continua_mass mass_matrix tangents turning_inertia turning_members",
        "springs": "SpringHistories refuse_turns spring_forces spring_laws spring_motions",
        "tables": "body_masses continua_mass elements nodal_loads pair_weights pins_of structure_of",
    },
)
