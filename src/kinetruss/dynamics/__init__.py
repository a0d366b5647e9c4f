"""Equations of motion: forces along a given motion, forward dynamics, free bodies, labelled systems.

The parts that simulate are imported when first used: they load many compiled kernels.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.dynamics.actions import NotOnBars as NotOnBars
    from kinetruss.dynamics.bar_actions import not_on_bars as not_on_bars
    from kinetruss.dynamics.closed_loop import Feedback as Feedback
    from kinetruss.dynamics.drive_limits import (
        LimitsKept as LimitsKept,
        Quickest as Quickest,
        inverse_along as inverse_along,
        limits_kept as limits_kept,
        quickest as quickest,
    )
    from kinetruss.dynamics.free_bodies import (
        Body as Body,
        Equation as Equation,
        FreeBody as FreeBody,
        Term as Term,
        free_body as free_body,
    )
    from kinetruss.dynamics.joint_reactions import joint_reaction as joint_reaction
    from kinetruss.dynamics.labelled_system import LabelledSystem as LabelledSystem, newton_euler as newton_euler
    from kinetruss.dynamics.linearisation import Linearisation as Linearisation, linearise as linearise
    from kinetruss.dynamics.prescribed import inverse as inverse
    from kinetruss.dynamics.reduction import reduced_equations as reduced_equations
    from kinetruss.dynamics.simulation import (
        Histories as Histories,
        Prepared as Prepared,
        prepare as prepare,
        simulate as simulate,
    )
    from kinetruss.dynamics.state_feedback import feedback as feedback

__getattr__, __dir__, __all__ = late(__name__)
