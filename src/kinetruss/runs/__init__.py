"""Named runs: all results of a motion of a model, written block by block to a folder that stays readable after a kill.

Opening a stored run does not load the analyses; they are loaded when a run is computed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late
from kinetruss.runs._result import RunResult

if TYPE_CHECKING:
    from kinetruss.runs._run import resume, run
    from kinetruss.runs.accuracy.budget import Budget, budget
    from kinetruss.runs.accuracy.standard_errors import standard_errors
    from kinetruss.runs.blocks.forces_at import forces_at, forces_at_peak, forces_at_rest
    from kinetruss.runs.blocks.gauge_strains import gauge_strains
    from kinetruss.runs.many.run_variants import VariantRuns, run_variants
    from kinetruss.runs.many.variants import variants
    from kinetruss.runs.missions.governing import governing
    from kinetruss.runs.missions.record import MissionRun, load

__all__ = [
    "Budget",
    "MissionRun",
    "RunResult",
    "VariantRuns",
    "budget",
    "forces_at",
    "forces_at_peak",
    "forces_at_rest",
    "gauge_strains",
    "governing",
    "load",
    "resume",
    "run",
    "run_variants",
    "standard_errors",
    "variants",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "_run": "resume run",
        "accuracy.budget": "Budget budget",
        "accuracy.standard_errors": "standard_errors",
        "blocks.forces_at": "forces_at forces_at_peak forces_at_rest",
        "blocks.gauge_strains": "gauge_strains",
        "missions.governing": "governing",
        "missions.record": "MissionRun load",
        "many.run_variants": "VariantRuns run_variants",
        "many.variants": "variants",
    },
)
