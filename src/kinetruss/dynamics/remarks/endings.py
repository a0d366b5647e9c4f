"""How a simulation ended: status and message."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.forward.watch import described
from kinetruss.dynamics.remarks.lost_digits import TOO_FEW
from kinetruss.dynamics.remarks.stiff import MANY, longer_steps, stiffest, vibrating
from kinetruss.errors import AnalysisError, few
from kinetruss.kernels.integrate import state as m
from kinetruss.model import DOP853, Taylor
from kinetruss.results import Status

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.integration import Integration

__all__ = ["ending", "sentences"]

STATUS = {
    m.DONE: Status.COMPLETED,
    m.PAUSED: Status.COMPLETED,
    m.EVENT: Status.EVENT,
    m.STEP_TOO_SMALL: Status.STEP_TOO_SMALL,
    m.STIFF: Status.STIFF,
    m.NOT_FINITE: Status.NOT_FINITE,
    m.ENERGY_GROWS: Status.ENERGY_GROWS,
    m.TOO_MANY_STEPS: Status.TOO_MANY_STEPS,
    m.NOT_CONVERGED: Status.STEP_NOT_CONVERGED,
}
SHOWN = 8
NEARLY = 1e-2
"""Scaled pivots below this fraction of the largest one in the run are reported as a near-singular position."""


def ending(code: int, error: BaseException | None) -> Status:
    """The status of what a kernel returned; `error` is what the last call of the user's function raised."""
    status = STATUS[code]
    by_user = error is not None and not isinstance(error, AnalysisError)  # joints that jam are no fault of a function
    return Status.USER_FORCE if by_user and not status.ok else status


def sentences(work: Integration) -> list[str]:
    """The message at the end: why the run ended early, events that did not occur, singularity crossings."""
    # the last step ends after a terminal event
    t, found = float(min(work.memory.t, work.memory.stop)), []
    if not work.status.ok:
        found.append(_early(work, t))
    elif int(work.memory.steps) > MANY and vibrating(work) >= 0:
        stiff = stiffest(work.problem.system)
        what = stiff.words(work.problem.system)
        found.append(f"The steps follow {what}; where it does not matter, {longer_steps(work, stiff)}.")
    if len(work.problem.events):
        found += _events(work, t)
    if work.memory.passages_met and len(passed := work.passages()):
        unsure = passed[passed[:, 2] == 0]
        more = f"; at t = {unsure[0, 0]:.6g} s the branch is not certain" if len(unsure) else ""
        count = "a singular position" if len(passed) == 1 else f"{len(passed)} singular positions"
        found.append(f"Passed {count}, the first at t = {passed[0, 0]:.6g} s{more}.")
    if work.lost[0] > TOO_FEW:
        share, when, pivot = work.lost
        digits = max(int(-np.log10(min(share, 1.0))), 0)
        found.append(
            f"Forces at t = {when:.6g} s keep {digits or 'no'} digits: there the rows of the constraints all but depend "
            f"on each other (smallest pivot {pivot:.2g}), so that rounding of positions changes them."
        )
    return found


def _early(work: Integration, t: float) -> str:
    """Why the run ended early, and the fix."""
    here, error = f"good up to t = {t:.6g} s of {work.t_end:g} s", work.problem.user.error
    if work.status is Status.USER_FORCE and error is not None:
        return f"The user's force function raised {type(error).__name__}: {error}; {here}."
    if isinstance(error, AnalysisError):
        return f"{error} It is {here}."
    return {
        Status.STIFF: f"{_stiffest(work)}; {here}. {_stepped_over(work)}",
        Status.NOT_FINITE: f"{_culprit(work)}; {here}.",
        Status.ENERGY_GROWS: f"{_growing(work)}; {here}.",
        Status.TOO_MANY_STEPS: f"max_steps of the method were taken; {here}. Raise max_steps, or loosen the tolerances.",
        Status.STEP_TOO_SMALL: f"Steps shrank to {work.memory.h:.2g} s; {here}. {_hindered(work)}",
        Status.STEP_NOT_CONVERGED: f"The step of {getattr(work.problem.method, 'step', 0.0) or 0.0:g} s is too long; {here}.",
        Status.NOT_CONVERGED: f"The lengths of the bars could not be closed; {here}.",
        Status.INTERRUPTED: f"Interrupted; {here}.",
    }.get(work.status, f"{here[0].upper()}{here[1:]}.")


def _hindered(work: Integration) -> str:
    """What may limit the steps, and the fix."""
    pivot, most = float(work.memory.pivot), float(work.memory.pivot_most)
    if pivot < NEARLY * most:
        return f"The position there is all but singular (smallest pivot {pivot:.2g}): start farther off, or with more speed."
    return "Loosen the tolerances, or look at what jumps or is singular there."


def _stiffest(work: Integration) -> str:
    """The elastic bar with the fastest vibration, and the number of steps that it needs."""
    system, memory = work.problem.system, work.memory
    found = stiffest(system)
    bar = found.bar
    if bar < 0:
        return "The forces change faster than the motion"
    steps = int(memory.steps) * work.t_end / max(float(memory.t), 1e-300)
    if found.damped:
        return (
            f"The strongest damper is that of {system.members[bar]} ({system.damping[bar]:.3g} N s/m, which slows its ends "
            f"within {1 / found.rate:.3g} s): the whole run would take about {steps:.2g} steps"
        )
    vibrating = f", vibrating at about {found.rate:.3g} rad/s" if found.rate > 0 else ""
    return (
        f"The stiffest bar is {system.members[bar]} ({system.spring[bar]:.3g} N/m{vibrating}): "
        f"the whole run would take about {steps:.2g} steps"
    )


def _stepped_over(work: Integration) -> str:
    """What may step farther, as a sentence."""
    words = longer_steps(work, stiffest(work.problem.system))
    return f"{words[0].upper()}{words[1:]}."


def _culprit(work: Integration) -> str:
    """The quantity that is not finite."""
    t, memory, problem = float(work.memory.t), work.memory, work.problem
    nf = len(problem.eq.free)
    x, v = problem.x0.copy(), problem.v0.copy()
    x[problem.eq.free], v[problem.eq.free] = memory.y[0, :nf], memory.y[0, nf : 2 * nf]
    push = problem.user.at(t + max(float(memory.h), 0.0), x, v)
    bad = np.flatnonzero(~np.isfinite(push).reshape(-1, 3).all(axis=1))
    if len(bad):
        return f"The user's force on {problem.system.nodes[int(bad[0])]} is {push[3 * int(bad[0]) :][:3]}"
    return "A force, an acceleration or the next state is no finite number"


def _growing(work: Integration) -> str:
    method = work.problem.method
    chosen = isinstance(method, DOP853 | Taylor) and method.step is None
    mend = "tighten rtol and atol" if chosen else "use a smaller step, or EnergyMomentum"
    if chosen and work.memory.pivot < NEARLY * work.memory.pivot_most:
        mend = "the position there is all but singular: start farther from it, or with more speed"
    return f"The energy grew though nothing feeds it: the steps are too long for this motion; {mend}"


def _events(work: Integration, t: float) -> list[str]:
    """The event that stopped the run, and events that did not occur."""
    came, events = work.happened()["events"], work.problem.events
    names = list(events)
    found = []
    if work.status is Status.EVENT:
        k = int(came[-1, 0])
        found.append(f"Stopped by {described(names[k], events[names[k]])} at t = {came[-1, 1]:.9g} s.")
    never = [described(name, events[name]) for k, name in enumerate(names) if k not in came[:, 0]]
    if never:
        found.append(f"Did not come up to t = {t:.6g} s: {few(never, SHOWN, '; ')}.")
    return found
