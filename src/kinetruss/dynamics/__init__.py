"""Equations of motion: forces along a given motion, forward dynamics, free bodies, labelled systems.

The parts that simulate are imported when first used: they load many compiled kernels.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.dynamics.actions.bar_actions import not_on_bars
from kinetruss.dynamics.actions.records import NotOnBars
from kinetruss.dynamics.free_bodies.free_body import Body, Equation, FreeBody, Term, free_body
from kinetruss.dynamics.free_bodies.newton_euler import LabelledSystem, newton_euler
from kinetruss.dynamics.prescribed.inverse import inverse
from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.prepare import Histories, Prepared, prepare
    from kinetruss.dynamics.forward.simulate import simulate
    from kinetruss.dynamics.free_bodies.joint_reaction import joint_reaction
    from kinetruss.dynamics.linear.feedback import Feedback, feedback
    from kinetruss.dynamics.linear.linearise import linearise
    from kinetruss.dynamics.linear.record import Linearisation
    from kinetruss.dynamics.linear.reduced_equations import reduced_equations
    from kinetruss.dynamics.prescribed.inverse_along import inverse_along
    from kinetruss.dynamics.prescribed.limits_kept import LimitsKept, limits_kept
    from kinetruss.dynamics.prescribed.quickest import Quickest, quickest

__all__ = [
    "Body", "Equation", "Feedback", "FreeBody", "Histories", "LabelledSystem", "LimitsKept", "Linearisation", "NotOnBars",
    "Prepared", "Quickest", "Term", "feedback", "free_body", "inverse", "inverse_along", "joint_reaction", "limits_kept",
    "linearise", "newton_euler", "not_on_bars", "prepare", "quickest", "reduced_equations", "simulate",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "forward.prepare": "Histories Prepared prepare",
        "forward.simulate": "simulate",
        "free_bodies.joint_reaction": "joint_reaction",
        "linear.feedback": "Feedback feedback",
        "linear.linearise": "linearise",
        "linear.record": "Linearisation",
        "linear.reduced_equations": "reduced_equations",
        "prescribed.inverse_along": "inverse_along",
        "prescribed.limits_kept": "LimitsKept limits_kept",
        "prescribed.quickest": "Quickest quickest",
    },
)
