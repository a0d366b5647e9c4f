"""Whether a conservative system keeps its energy along a run, and the message if it does not."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.solve.balance import balance
from kinetruss.kernels.structure.plan import CABLE, NONE
from kinetruss.mechanics.assembly import spring_laws
from kinetruss.model import ERROR_CONTROLLED, EnergyMomentum, GeneralizedAlpha, Radau
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.integration import Integration
    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["energy_kept", "resting"]

PROMISED = 1e3
"""Allowed error of the energy as a multiple of the error tolerance: some hundred steps contribute one tolerance each."""
NEARLY = 1e-2
"""A position counts as near-singular if its scaled pivot is below this fraction of the largest one in the run."""
NOTHING = 1e-24
"""Energy of springs at their natural lengths, as a fraction of k l0^2: round-off."""
FIXED = 1e-3
"""Allowed error of the energy with fixed steps, as a fraction of the largest kinetic energy: visible in a figure."""


def resting(problem: Problem) -> bool:
    """True if nothing moves and no stored energy could cause motion: all energy is then round-off."""
    if problem.v0.any() or problem.eq.constant.any() or problem.motors is not None or len(problem.z0):
        return False
    if problem.system.springs and np.any(spring_laws(problem.system, problem.x0.reshape(-1, 3))[:, 0]):
        return False
    start = np.empty((1, 8))
    balance(problem.eq, problem.ws, problem.x0.reshape(1, -1), problem.v0.reshape(1, -1), start)
    law = problem.eq.law
    return bool(abs(start[0, 1]) <= NOTHING * float(np.sum(np.abs(law[:, 0]) * law[:, 1] ** 2)))


def energy_kept(work: Integration, t: NDArray[np.float64], kinetic: NDArray[np.float64], energy: NDArray[np.float64]) -> str:
    """The message on the energy up to these samples, "" if none; `work.worst` keeps the worst sample so far.

    t (s,), s; kinetic, energy (s,), J.
    """
    problem = work.problem
    if not _conserved(problem) or resting(problem):
        return ""
    start = np.empty((1, 8))
    balance(problem.eq, problem.ws, problem.x0.reshape(1, -1), problem.v0.reshape(1, -1), start)
    off = np.abs(energy - start[0, :2].sum())
    if len(off) and not off.max() <= work.worst[0]:
        k = int(np.argmax(np.where(np.isnan(off), np.inf, off)))
        work.worst[:2] = off[k], t[k]
    work.worst[2] = max(work.worst[2], float(work.memory.kinetic_most), float(kinetic.max(initial=0.0)))
    lost, when, most = work.worst.tolist()
    method = problem.method
    stepped = isinstance(method, ERROR_CONTROLLED) and method.step is None
    allowed = PROMISED * method.rtol if stepped else FIXED
    if work.status is Status.ENERGY_GROWS or lost <= allowed * most + 1e-11 * float(np.abs(start[0, :2]).sum()):
        return ""
    share = lost / max(most, 1e-300)
    return (
        f"The energy is off by {share:.2g} of the largest kinetic energy at t = {when:.6g} s, though nothing feeds it or takes "
        f"from it: {_mend(work, stepped)}."
    )


def _conserved(problem: Problem) -> bool:
    """True if the sum of kinetic and potential energy is a constant of the motion."""
    return (
        problem.isolated
        and problem.motors is None
        and not len(problem.z0)
        and not np.any(problem.eq.law[:, 2])
        and not problem.eq.pin.size
        and not problem.eq.damp_six.size + problem.eq.damp_eight.size
        and not np.any(problem.eq.spring[:, 2:4])
    )


def _mend(work: Integration, stepped: bool) -> str:
    """The fix."""
    method, eq = work.problem.method, work.problem.eq
    if isinstance(method, Radau) and np.any(eq.law_kind != NONE):
        return (
            "the method damps vibrations faster than its steps; where they matter, tighten rtol and atol, or use EnergyMomentum"
        )
    if stepped:
        mend = "what lies behind is no better than that; tighten rtol and atol"
        if len(work.happened()["passages"]) or work.memory.pivot < NEARLY * work.memory.pivot_most:
            return f"{mend}, or start farther from a singular position"
        cables = [work.problem.system.members[i] for i in eq.law_member[eq.law_kind == CABLE]]
        if cables:
            return f"{mend}: steps do not see the instant at which the cable {cables[0]!r} tightens or goes slack"
        return mend
    if isinstance(method, GeneralizedAlpha):
        return "the method damps fast vibrations; where they matter, use a smaller step, or EnergyMomentum"
    if isinstance(method, EnergyMomentum):
        return "it is kept at the ends of steps only; use a smaller step"
    return "the steps are too long for this motion; use smaller ones, or EnergyMomentum"
