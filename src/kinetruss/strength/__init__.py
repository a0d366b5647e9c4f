"""Strength of members: section forces, stress, buckling, utilisation."""

from kinetruss.late import listed
from kinetruss.strength.members.beams import beams
from kinetruss.strength.members.components import components
from kinetruss.strength.members.elements import elements
from kinetruss.strength.members.sections import sections
from kinetruss.strength.members.stresses import stresses
from kinetruss.strength.strain_gauges.bridge import bridge_output, bridge_strain, shunt_strain
from kinetruss.strength.strain_gauges.compare_gauges import compare_gauges
from kinetruss.strength.strain_gauges.gauges import gauges
from kinetruss.strength.strain_gauges.measured_strains import measured_strains
from kinetruss.strength.strain_gauges.rosette import Rosette, rosette
from kinetruss.strength.verdict.buckling import (
    END_CONDITIONS,
    amplification,
    critical_load,
    end_condition,
    euler_load,
    johnson_load,
    transition,
)
from kinetruss.strength.verdict.check import check, table
from kinetruss.strength.verdict.utilisation import Options, utilisation

__all__ = [
    "END_CONDITIONS",
    "Options",
    "Rosette",
    "amplification",
    "beams",
    "bridge_output",
    "bridge_strain",
    "check",
    "compare_gauges",
    "components",
    "critical_load",
    "elements",
    "end_condition",
    "euler_load",
    "gauges",
    "johnson_load",
    "measured_strains",
    "rosette",
    "sections",
    "shunt_strain",
    "stresses",
    "table",
    "transition",
    "utilisation",
]

__dir__ = listed(__name__)
