"""Named runs: all results of a motion of a model, written block by block to a folder that stays readable after a kill.

Opening a stored run does not load the analyses; they are loaded when a run is computed.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.runs.budgets import Budget as Budget, budget as budget
    from kinetruss.runs.governing_pair import governing as governing
    from kinetruss.runs.instants import (
        forces_at as forces_at,
        forces_at_peak as forces_at_peak,
        forces_at_rest as forces_at_rest,
    )
    from kinetruss.runs.joining import gauge_strains as gauge_strains
    from kinetruss.runs.many import VariantRuns as VariantRuns, run_variants as run_variants
    from kinetruss.runs.mission_results import MissionRun as MissionRun, load as load
    from kinetruss.runs.results import RunResult as RunResult
    from kinetruss.runs.running import resume as resume, run as run
    from kinetruss.runs.uncertain import standard_errors as standard_errors
    from kinetruss.runs.variant_sets import variants as variants

__getattr__, __dir__, __all__ = late(__name__)
