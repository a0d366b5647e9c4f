"""Messages of a simulation: how it ended, what limited its steps, whether energy was conserved."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.dynamics.integrators import described
from kinetruss.elements.kinds import present, switches
from kinetruss.errors import AnalysisError, few
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.samples import NEAR
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.kkt import balance
from kinetruss.kernels.structure.structure import CABLE, NONE
from kinetruss.mechanics import System
from kinetruss.mechanics.elements import element_forces, has_elements, named_laws, turned_over
from kinetruss.model import DOP853, ERROR_CONTROLLED, EnergyMomentum, GeneralizedAlpha, Radau, Taylor
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.integration import Integration
    from kinetruss.dynamics.simulation_problem import Problem
    from kinetruss.kernels.integrate.state import Samples

    Floats = NDArray[np.float64]


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
    here, error = f"good up to t = {t:.6g} s of {work.t_end:g} s", work.problem.error
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


def _state(work: Integration) -> tuple[Floats, Floats]:
    """Flat positions and velocities (3 n,) of the last good state."""
    problem, y = work.problem, work.memory.y
    nf = len(problem.eq.free)
    x, v = problem.x0.copy(), problem.v0.copy()
    x[problem.eq.free], v[problem.eq.free] = y[0, :nf], y[0, nf : 2 * nf]
    return x, v


def _culprit(work: Integration) -> str:
    """The quantity that is not finite."""
    t, memory, problem = float(work.memory.t), work.memory, work.problem
    push = problem.user.at(t + max(float(memory.h), 0.0), *_state(work))
    bad = np.flatnonzero(~np.isfinite(push).reshape(-1, 3).all(axis=1))
    if len(bad):
        return f"The user's force on {problem.system.nodes[int(bad[0])]} is {push[3 * int(bad[0]) :][:3]}"
    return "A force, an acceleration or the next state is no finite number"


def _growing(work: Integration) -> str:
    if name := turned_over(work.problem.system, *_state(work), ahead=max(float(work.memory.h), 0.0)):
        return (
            f"{name} passes half a turn from its rest, where its law, or its energy, would jump. "
            "Give another rest, or end the run before"
        )
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
    own = switches(work.problem.system)
    never = [described(name, events[name]) for k, name in enumerate(names) if k not in came[:, 0] and name not in own]
    if never:
        found.append(f"Did not come up to t = {t:.6g} s: {few(never, SHOWN, '; ')}.")
    return found


# Whether a conservative system keeps its energy along a run, and the message if it does not.

PROMISED = 1e3
"""Allowed error of the energy as a multiple of the error tolerance: some hundred steps contribute one tolerance each."""
NOTHING = 1e-24
"""Energy of springs at their natural lengths, as a fraction of k l0^2: round-off."""
FIXED = 1e-3
"""Allowed error of the energy with fixed steps, as a fraction of the largest kinetic energy: visible in a figure."""


def resting(problem: Problem) -> bool:
    """True if nothing moves and no stored energy could cause motion: all energy is then round-off."""
    if problem.v0.any() or problem.eq.constant.any() or problem.motors is not None or len(problem.z0):
        return False
    x0 = problem.x0.reshape(-1, 3)
    if np.any(named_laws(problem.system, x0)[:, 0]) or np.any(element_forces(problem.system, x0, rows=False)):
        return False
    start = np.empty((1, 8))
    balance(problem.eq, problem.ws, problem.x0.reshape(1, -1), problem.v0.reshape(1, -1), start)
    law = problem.eq.law
    return bool(abs(start[0, 1]) <= NOTHING * float(np.sum(np.abs(law[:, 0]) * law[:, 1] ** 2)))


def energy_remark(work: Integration, t: NDArray[np.float64], kinetic: NDArray[np.float64], energy: NDArray[np.float64]) -> str:
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
        and not any(one.loses(record) for one, record in present(problem.system))
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


# Accelerations and forces next to singular positions: refined by what the equations still lack, their lost digits counted.
#
# There the rows of the Jacobian all but depend on each other, most of all where light and heavy bodies meet: the Schur
# complement of the equations of motion loses the square of what the equations themselves lose. A residual of the equations
# gives it back (`solve_refined` of the kernels). What round-off of the positions does to the forces no solver can mend: it is
# measured, by positions that differ in their last digit.


LOW = 1e-2
"""Scaled pivot below which the accelerations and forces of a sample are refined."""
TOO_FEW = 1e-7
"""Share of the largest force beyond which the message names what is lost: fewer than seven digits are left."""


def refine(problem: Problem, samples: Samples, done: int, pivot_most: float, lost: Floats) -> None:
    """Refine the first `done` samples next to singular positions, in place.

    pivot_most : the largest scaled pivot met: samples in a singular position itself are left as they are. lost (3,) : the
    largest share of a force that is lost, its time (s), the pivot there; it is kept up to date.
    """
    if problem.motors is not None or not samples.N.shape[1]:
        return
    pivots = samples.diagnostics[:done, 1]
    for k in np.flatnonzero((pivots < LOW) & (pivots >= NEAR * pivot_most) & np.isfinite(samples.a[:done]).all(axis=1)):
        t, x, v = float(samples.times[k]), samples.x[k], samples.v[k]
        a, N = _refined(problem, t, x.copy(), v.copy())
        last_digit = np.spacing(np.abs(x)) * np.random.default_rng(0).choice((-1.0, 1.0), x.size)
        _, other = _refined(problem, t, x + last_digit, v.copy())
        if not (np.isfinite(a).all() and np.isfinite(N).all() and np.isfinite(other).all()):
            continue
        samples.a[k], samples.N[k] = a, N
        # where all forces are round-off, none is lost
        share = float(np.abs(other - N).max() / max(np.abs(N).max(), np.abs(problem.ws.f).max(), 1e-300))
        if share > lost[0]:
            lost[:] = share, t, pivots[k]


def _refined(problem: Problem, t: float, x: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Accelerations (3 n,) and row forces (r,), N, at t (s), x, v (3 n,)."""
    a, N = np.zeros(x.size), np.zeros(len(problem.eq.A))
    problem.ws.pivot[1] = 0.0  # wherever the motion comes from
    evaluate(problem.eq, problem.ws, problem.user.call, t, x, v, a, N)
    return a, N


# Stiff elastic bars under explicit steps: detected early, from the progress of the first steps.

LOOKS = (4_000, 32_000, 128_000, 512_000)
"""Number of steps after which the steps of the whole run are estimated."""
MANY = 20_000
"""Number of steps above which a message says that most of them only follow a vibration."""
BY_FAR = 5.0
"""Allowed estimate of steps, as a multiple of max_steps, if no vibrating bar is known: at the second check."""

LATER = 1.5
"""The same from the third check on."""
RADIANS = 0.02
"""The fastest vibration limits the steps if step times its frequency exceeds this: 0.1 occurs if round-off alone excites it."""


class Stiffest(NamedTuple):
    """The elastic bar that needs the smallest steps: its index (-1: none), its rate (rad/s, 1/s), and whether its damper is
    faster than its spring.
    """

    bar: int
    rate: float
    damped: bool

    def words(self, system: System) -> str:
        """The vibration or decay in words, with the name of the bar."""
        name = system.members[self.bar]
        if self.damped:
            return f"the damper of {name}, which slows its ends within {1 / self.rate:.3g} s"
        return f"the vibration of {name} ({self.rate:.3g} rad/s)"


def stiffest(system: System) -> Stiffest:
    """The elastic bar with the fastest vibration or the fastest damper.

    w^2 = k (1/m_A + 1/m_B) and the rate c (1/m_A + 1/m_B) of a damper, with the masses at its ends alone: of the order of the
    highest frequencies of the structure.
    """
    elastic = np.flatnonzero(system.law != NONE)
    if not len(elastic):
        return Stiffest(-1, 0.0, damped=False)
    count, share = len(system.nodes), system.rods[:, 0] / 3 + system.rods[:, 3] / 3
    mass = system.node_mass + np.bincount(system.p, share, count) + np.bincount(system.q, share, count)
    still = system.prescribed.reshape(-1, 3).all(axis=1)
    # a massless node gets its inertia through rigid bars, which is unknown here: it is skipped
    give = np.where(still | (mass <= 0), 0.0, 1 / np.where(mass > 0, mass, 1.0))
    both = give[system.p[elastic]] + give[system.q[elastic]]
    spring, damper = np.sqrt(system.spring[elastic] * both), system.damping[elastic] * both
    k = int(np.argmax(np.maximum(spring, damper)))
    return Stiffest(int(elastic[k]), float(max(spring[k], damper[k])), bool(damper[k] > spring[k]))


def longer_steps(work: Integration, found: Stiffest) -> str:
    """What may step farther than explicit steps, in words."""
    if work.problem.motors is not None:
        return "make the bar rigid: motors are simulated with explicit steps"
    if found.damped:
        return "use method=Radau(), whose steps follow the motion, or EnergyMomentum(step=...)"
    return "use method=EnergyMomentum(step=...), whose steps may be far longer, or Radau(), which lets the vibration die down"


def vibrating(work: Integration) -> int:
    """The bar whose vibration or damper limits the explicit steps, or -1."""
    bar, rate, _ = stiffest(work.problem.system)
    explicit = isinstance(work.problem.method, DOP853 | Taylor)
    return bar if explicit and float(work.memory.h) * rate > RADIANS else -1


def too_stiff(work: Integration) -> bool:
    """True if the whole run would take more steps than allowed, because a vibration limits them.

    If no such bar is known (its ends get their mass from bodies), only long after the start and by a wide margin.
    """
    steps = int(work.memory.steps)
    if not isinstance(work.problem.method, DOP853 | Taylor) or not work.memory.t > 0:
        return False
    if vibrating(work) < 0 and (
        steps < LOOKS[1] or not (np.any(work.problem.system.law != NONE) or has_elements(work.problem.system))
    ):
        return False
    margin = 1.0 if vibrating(work) >= 0 else BY_FAR if steps < LOOKS[2] else LATER
    return bool(steps * work.t_end / work.memory.t > margin * work.problem.method.max_steps)
