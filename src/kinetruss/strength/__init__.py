"""Strength of members: section forces, stress, buckling, utilisation."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.strength.beam_stresses import beams as beams
    from kinetruss.strength.critical_loads import (
        END_CONDITIONS as END_CONDITIONS,
        amplification as amplification,
        critical_load as critical_load,
        end_condition as end_condition,
        euler_load as euler_load,
        johnson_load as johnson_load,
        transition as transition,
    )
    from kinetruss.strength.deflection_limits import deflections as deflections
    from kinetruss.strength.element_stresses import elements as elements
    from kinetruss.strength.findings import Finding as Finding, find as find
    from kinetruss.strength.gauge_records import (
        bridge_output as bridge_output,
        bridge_reading as bridge_reading,
        bridge_strain as bridge_strain,
        compare_gauges as compare_gauges,
        measured_strains as measured_strains,
        shunt_strain as shunt_strain,
    )
    from kinetruss.strength.section_forces import components as components, sections as sections, stresses as stresses
    from kinetruss.strength.strain_gauges import Rosette as Rosette, gauges as gauges, rosette as rosette
    from kinetruss.strength.utilisations import Options as Options, utilisation as utilisation
    from kinetruss.strength.verdict import check as check, table as table

__getattr__, __dir__, __all__ = late(__name__)
