"""Named runs: from a model to everything that is asked about a motion, streamed to a folder that survives a kill.

Opening a stored run needs none of the physics; it is loaded when something is run.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kinetruss.runs._result import RunResult, load

if TYPE_CHECKING:
    from kinetruss.runs._run import resume, run

__all__ = ["RunResult", "load", "resume", "run"]


def __getattr__(name: str) -> Any:
    if name in ("resume", "run"):
        from kinetruss.runs import _run

        return getattr(_run, name)
    raise AttributeError(f"module 'kinetruss.runs' has no attribute {name!r}")
