"""Determines which motions have the power series that `Taylor` needs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.forward.watch import jumps
from kinetruss.errors import InputError
from kinetruss.kernels.structure.equations import SUM_FORCE
from kinetruss.kernels.structure.plan import CABLE
from kinetruss.model import DOP853, Taylor

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["by_default", "refuse_series", "without_series"]

MANY = 50
"""Number of segments of a motion above which DOP853 is the default, since every segment ends a step by series."""


def without_series(problem: Problem) -> str | None:
    """Text: what has no power series in a simulation; None if everything has one."""
    eq, system = problem.eq, problem.system
    changing = [system.members[i] for i in np.flatnonzero(system.two_rods | (system.rods[:, 2] > 0.0))[: eq.varying_A.size]]
    cables = [system.members[i] for i in eq.law_member[eq.law_kind == CABLE]]
    found = (
        (changing, "rods of {!r} change their inertia with its length"),
        (cables, "the cable {!r} may be taut or slack"),
        (eq.sum_row, "hinges, angles in space or couplings stand between bodies"),
        (np.flatnonzero(eq.force_kind == SUM_FORCE), "a torque is given between bodies"),
        (eq.follower_mode, "a load turns with its body"),
        (eq.edge_A, "membranes or solids resist"),
        (eq.pin, "there is friction about pins"),
        (system.springs, "the spring {!r} acts on a coordinate"),
        ([problem.user] if problem.user.own.given else [], "a user force is given"),
        ([problem.user] if problem.user.given else [], "the base rotates"),
        ([problem.motors] if problem.motors is not None else [], "motors have inputs"),
    )
    return next((words.format(what[0]) for what, words in found if len(what)), None)


def by_default(problem: Problem) -> DOP853 | Taylor:
    """The default method: power series if the motion has one and does not have many segments."""
    few = len(jumps(problem.eq, all_pieces=True)) <= MANY
    return Taylor() if few and without_series(problem) is None else DOP853()


def refuse_series(problem: Problem) -> None:
    """Raise InputError if `Taylor` cannot be used."""
    if (why := without_series(problem)) is not None:
        raise InputError(f"method: Taylor has no power series of this motion: {why}. Use DOP853().")
