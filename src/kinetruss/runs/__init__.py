"""Named runs: from a model to everything that is asked about a motion, streamed to a folder that survives a kill.

Opening a stored run needs none of the physics; it is loaded when something is run.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from kinetruss.runs._result import RunResult, load

if TYPE_CHECKING:
    from kinetruss.runs._run import resume, run
    from kinetruss.runs.blocks.forces_at import forces_at, forces_at_peak, forces_at_rest
    from kinetruss.runs.blocks.gauge_strains import gauge_strains
    from kinetruss.runs.many.run_variants import VariantRuns, run_variants
    from kinetruss.runs.many.variants import variants

__all__ = [
    "RunResult", "VariantRuns", "forces_at", "forces_at_peak", "forces_at_rest", "gauge_strains", "load", "resume", "run",
    "run_variants", "variants",
]  # fmt: skip

_HOME = {
    "forces_at": "blocks.forces_at", "forces_at_peak": "blocks.forces_at", "forces_at_rest": "blocks.forces_at",
    "gauge_strains": "blocks.gauge_strains", "resume": "_run", "run": "_run",
    "VariantRuns": "many.run_variants", "run_variants": "many.run_variants", "variants": "many.variants",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.runs.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.runs' has no attribute {name!r}")
