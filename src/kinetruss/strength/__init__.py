"""Section forces, stress, buckling: is it strong enough?"""

from kinetruss.strength._buckling import (
    END_CONDITIONS,
    amplification,
    critical_load,
    end_condition,
    euler_load,
    johnson_load,
    transition,
)
from kinetruss.strength._check import check, table
from kinetruss.strength._compare_gauges import compare_gauges
from kinetruss.strength._components import components
from kinetruss.strength._elements import elements
from kinetruss.strength._gauges import gauges
from kinetruss.strength._sections import sections
from kinetruss.strength._stresses import stresses
from kinetruss.strength._utilisation import RULES, Options, utilisation

__all__ = [
    "END_CONDITIONS", "Options", "RULES", "amplification", "check", "compare_gauges", "components", "critical_load",
    "elements", "end_condition", "euler_load", "gauges", "johnson_load", "sections", "stresses", "table", "transition",
    "utilisation",
]  # fmt: skip
