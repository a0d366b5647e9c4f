"""Choice of the solver, and its work that is done once: orders, patterns, blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.planning.solvers import LARGEST_DENSE, mark_dropped, solver_arrays, workspace_for
    from kinetruss.mechanics.planning.tangent_pattern import tangent_record

__all__ = ["LARGEST_DENSE", "mark_dropped", "workspace_for", "solver_arrays", "tangent_record"]

__getattr__, __dir__ = late(
    __name__,
    {
        "solvers": "LARGEST_DENSE mark_dropped workspace_for solver_arrays",
        "tangent_pattern": "tangent_record",
    },
)
