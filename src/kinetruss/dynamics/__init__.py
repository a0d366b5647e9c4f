"""Equations of motion: forces along a given motion, forward dynamics, free bodies, labelled systems.

What simulates is imported when first used: it loads many compiled kernels.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from kinetruss.dynamics._actions import NotOnBars
from kinetruss.dynamics._bar_actions import not_on_bars
from kinetruss.dynamics._free_body import Body, Equation, FreeBody, Term, free_body
from kinetruss.dynamics._inverse import inverse
from kinetruss.dynamics._newton_euler import LabelledSystem, newton_euler

if TYPE_CHECKING:
    from kinetruss.dynamics._feedback import Feedback, feedback
    from kinetruss.dynamics._inverse_along import inverse_along
    from kinetruss.dynamics._joint_reaction import joint_reaction
    from kinetruss.dynamics._linear_record import Linearisation
    from kinetruss.dynamics._linearise import linearise
    from kinetruss.dynamics._prepare import Histories, Prepared, prepare
    from kinetruss.dynamics._reduced_equations import reduced_equations
    from kinetruss.dynamics._simulate import simulate

__all__ = [
    "Body", "Equation", "Feedback", "FreeBody", "Histories", "LabelledSystem", "Linearisation", "NotOnBars", "Prepared", "Term",
    "feedback", "free_body", "inverse", "inverse_along", "joint_reaction", "linearise", "newton_euler", "not_on_bars",
    "prepare", "reduced_equations", "simulate",
]  # fmt: skip

_HOME = {
    "Feedback": "_feedback", "Histories": "_prepare", "Linearisation": "_linear_record", "Prepared": "_prepare",
    "feedback": "_feedback", "inverse_along": "_inverse_along",
    "joint_reaction": "_joint_reaction", "linearise": "_linearise", "prepare": "_prepare",
    "reduced_equations": "_reduced_equations", "simulate": "_simulate",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.dynamics.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.dynamics' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
