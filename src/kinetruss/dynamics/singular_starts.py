"""Starts in singular positions and steps across them: power series of the motion, outside the kernels.

In a singular position rows of the Jacobian are dependent, and accelerations are differences of small numbers. Explicit
steps lose the branch, because their stages do not satisfy the constraints before the projection. The motion itself is
smooth. So a(t) is a polynomial that satisfies the equations of motion at collocation points (Hairer, Norsett & Wanner
1993, section II.7). All points keep a distance from the start. They lie on both sides of it if the equations do not
depend on time, else after it. A fixed-point iteration finds the polynomial: positions and velocities at the points are
integrals of a(t), projected onto the constraints.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from kinetruss.dynamics.equations import not_prescribed
from kinetruss.dynamics.integrators import integrate, jumps
from kinetruss.dynamics.starting import EXACTLY, SINGULAR, Singular
from kinetruss.elements.kinds import ELEMENTS, on_coordinates
from kinetruss.errors import InputError
from kinetruss.kernels.integrate.dop853 import interpolate
from kinetruss.kernels.integrate.state import Memory, Samples
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.kkt import project
from kinetruss.kernels.structure.equations import SUM_FORCE
from kinetruss.kernels.structure.structure import CABLE
from kinetruss.mechanics.coordinates import released
from kinetruss.mechanics.mobility import beam_deformations, mobility_at
from kinetruss.mechanics.mode_texts import moves_text
from kinetruss.model import DOP853, ERROR_CONTROLLED, Taylor

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.simulation_problem import Problem


GAP = 0.4
"""Fraction of the segment, next to the start, without collocation points."""
BOTH_SIDES = 6
"""Number of collocation points on each side of the start, if they lie on both sides."""
ONE_SIDE = 8
"""Number of collocation points if all lie after the start."""
ITERATIONS = 40
"""Largest number of fixed-point iterations."""
CONVERGED = 1e-13
"""Change of accelerations, as a fraction of the largest one, at which the iteration has converged."""
SHORTER = 0.7
"""Factor from one trial length to the next. A long segment is no polynomial, or has a point near another singularity."""
TRIES = 10
"""Largest number of trial lengths."""
TAIL = 0.1
"""Effect of the last two coefficients of the accelerations on velocities, as a factor."""
GOOD = 3e-10
"""Error of a segment that ends the search. The error is the correction by the projection, relative to the shortest member
or the largest speed."""
USABLE = 1e-6
"""Largest error of a segment that is accepted."""
WORTH = 0.1
"""A shorter segment replaces an accepted one if its error is smaller by this factor."""


@dataclass(frozen=True, eq=False)
class _Plan:
    """Collocation points s (k,) as fractions of the segment, and matrices that act on values there.

    once, twice (k, k) : single and double integrals from 0 to s. begin (k,) : the value at 0. last (2, k) : the last two
    Chebyshev coefficients. read (8,) : instants of the interpolant; read_once, read_twice (8, k) : integrals from 0 to them.
    back (8, 8) : from states at `read` to the interpolant of a step (see kernels.integrate.dop853.interpolate).
    """

    s: NDArray[np.float64]
    once: NDArray[np.float64]
    twice: NDArray[np.float64]
    begin: NDArray[np.float64]
    last: NDArray[np.float64]
    read: NDArray[np.float64]
    read_once: NDArray[np.float64]
    read_twice: NDArray[np.float64]
    back: NDArray[np.float64]


class State(NamedTuple):
    """The start of a segment: t, s; x, v (3 n,), m, m/s; a first guess of a (3 n,), m/s^2."""

    t: float
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Segment:
    """From `begin` to `end` (s). a0 (3 n,), N0 (rows,) : at the start. x, v, a (3 n,), N (rows,) : at the end.

    dense (8, 2 nf) : the interpolant. pivot : scaled pivot at the end. evaluations : number of evaluations.
    """

    begin: float
    end: float
    a0: NDArray[np.float64]
    N0: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    N: NDArray[np.float64]
    dense: NDArray[np.float64]
    pivot: float
    evaluations: int


@cache
def _plan(both: bool) -> _Plan:
    count = BOTH_SIDES if both else ONE_SIDE
    places = 0.5 - 0.5 * np.cos((2 * np.arange(count) + 1) * np.pi / (2 * count))
    right = GAP + (1 - GAP) * (places - places[0]) / (places[-1] - places[0])
    s = np.concatenate([-right[::-1], right]) if both else right
    k = len(s)
    # the Chebyshev variable goes from -1 to 1 over all points and is `low` at the start of the segment
    low, scale = (0.0, 1.0) if both else (-1.0, 2.0)

    def local(t: NDArray[np.float64]) -> NDArray[np.float64]:
        return scale * t + low

    fit = np.linalg.inv(chebyshev.chebvander(local(s), k - 1))
    single = np.stack([chebyshev.chebint(c, 1, lbnd=low) for c in fit.T], axis=1) / scale
    double = np.stack([chebyshev.chebint(chebyshev.chebint(c, 1, lbnd=low), 1, lbnd=low) for c in fit.T], axis=1) / scale**2
    r = np.linspace(0.0, 1.0, 8)
    basis = [
        r**0,
        r,
        r * (1 - r),
        r**2 * (1 - r),
        (r * (1 - r)) ** 2,
        r**3 * (1 - r) ** 2,
        (r * (1 - r)) ** 3,
        r**4 * (1 - r) ** 3,
    ]
    return _Plan(
        s=s,
        once=chebyshev.chebvander(local(s), k) @ single,
        twice=chebyshev.chebvander(local(s), k + 1) @ double,
        begin=(chebyshev.chebvander(local(np.zeros(1)), k - 1) @ fit)[0],
        last=np.array(fit[-2:], float),
        read=r,
        read_once=chebyshev.chebvander(local(r), k) @ single,
        read_twice=chebyshev.chebvander(local(r), k + 1) @ double,
        back=np.linalg.inv(np.stack(basis, axis=1)),
    )


def segment(problem: Problem, start: State, span: float, *, both: bool, size: float, tolerance: float) -> Segment | None:
    """The segment from a state, over `span` (s) or less; None if no segment satisfies the constraints.

    both : the equations do not depend on time, so that points before the start are allowed. size : length of the shortest
    member, m. tolerance : of the projections.
    """
    best, least, count = None, USABLE, 0
    for _ in range(TRIES):
        found, off, taken = _segment(problem, start, span, _plan(both), size, tolerance)
        count += taken
        if found is not None and off < (least if best is None else WORTH * least):
            best, least = found, off
        if least <= GOOD:
            break
        span *= SHORTER
    return None if best is None else Segment(**{**vars(best), "evaluations": count})


def _segment(
    problem: Problem, start: State, span: float, plan: _Plan, size: float, tolerance: float
) -> tuple[Segment | None, float, int]:
    """The polynomial over `span` (s), its error, and the number of evaluations."""
    x0, v0, rows, k = start.x, start.v, len(problem.eq.row), len(plan.s)
    a, N, pivots = np.tile(start.a, (k, 1)), np.zeros((k, rows)), np.zeros(k)
    last, off = np.inf, np.inf
    for turn in range(ITERATIONS):
        # x(s) = x0 + h s v0 + h^2 (double integral of a), v(s) = v0 + h (integral of a), with h = span
        x = x0 + span * plan.s[:, None] * v0 + span**2 * (plan.twice @ a)
        v = v0 + span * (plan.once @ a)
        speed, new, off = float(np.abs(v).max()), np.zeros_like(a), 0.0
        for i, s in enumerate(plan.s):
            # project onto the constraints, then M a + J^T N = f, J a = gamma gives the next a and N at this point
            t = start.t + max(span * s, 0.0)
            good, moved, turned = project(problem.eq, problem.ws, t, x[i], v[i], tolerance)
            if not good or not np.isfinite(x[i]).all():
                return None, np.inf, k * turn + i
            pivots[i] = evaluate(problem.eq, problem.ws, problem.user.call, t, x[i], v[i], new[i], N[i])
            off = max(off, moved / size, turned / max(speed, 1e-300))
        change, largest = float(np.abs(new - a).max()), float(np.abs(new).max())
        a = new
        if not np.isfinite(change):
            return None, np.inf, k * (turn + 1)
        if change <= CONVERGED * largest or (turn > 4 and change > 0.7 * last and change < 1e-6 * largest):
            break
        last = change
    else:
        return None, np.inf, k * ITERATIONS
    # if a(t) is not resolved by the polynomial, its last coefficients are large
    off = max(off, TAIL * span * float(np.abs(plan.last @ a).max()) / max(speed, 1e-300))
    free = problem.eq.free
    states = np.concatenate(
        [
            (x0 + span * plan.read[:, None] * v0 + span**2 * (plan.read_twice @ a))[:, free],
            (v0 + span * (plan.read_once @ a))[:, free],
        ],
        axis=1,
    )
    states[-1] = np.concatenate([x[-1][free], v[-1][free]])
    found = Segment(
        begin=start.t,
        end=start.t + span,
        a0=plan.begin @ a,
        N0=plan.begin @ N,
        x=x[-1],
        v=v[-1],
        a=a[-1],
        N=N[-1],
        dense=plan.back @ states,
        pivot=float(pivots[-1]),
        evaluations=0,
    )
    return found, off, k * (turn + 1)


# Steps across singular positions, computed outside the kernels, if explicit steps cannot determine the branch.

SEGMENT = 0.3
"""Duration of a segment as a fraction of the time in which a member moves by its length."""
LOOKS = 65
"""Number of instants of a segment at which singular positions are searched."""
NEXT = 0.3
"""First step after a segment, as a fraction of the segment."""


def sizes(problem: Problem) -> tuple[float, float]:
    """Length of the shortest member, m, and the smallest tolerance of projections that round-off allows."""
    places = problem.system.x0
    size = float(np.linalg.norm(places[problem.system.q] - places[problem.system.p], axis=1).min())
    return size, max(1e-15, 2.2e-16 * (1.0 + float(np.abs(places).max()) / size))


def cross_singular(problem: Problem, control: Any, memory: Memory) -> None:
    """Advance the memory by one segment from its present state. If there is none, the next step is taken without it."""
    memory.alone = 1
    if len(problem.z0):
        return
    free, nf = problem.eq.free, len(problem.eq.free)
    x, v, a = problem.x0.copy(), problem.v0.copy(), np.zeros(problem.x0.size)
    x[free], v[free], a[free] = memory.y[0, :nf], memory.y[0, nf : 2 * nf], memory.y[1, nf : 2 * nf]
    here = State(float(memory.t), x, v, a)
    found = segment_from(problem, control, here, int(memory.interval), float(np.abs(a).max()))
    if found is not None:
        memory.alone = 0
        advance_by(problem, memory, found)


def segment_from(problem: Problem, control: Any, start: State, interval: int, gain: float) -> Segment | None:
    """A segment from a state, in an interval without jumps; gain : size of the accelerations near the state, m/s^2."""
    size, tolerance = sizes(problem)
    pace = max(float(np.abs(start.v).max()) / size, float(np.sqrt(gain / size)))
    if not pace > 0:
        return None
    fixed = problem.isolated and not problem.user.given
    # the segment may end after the last sample, but not after a jump
    left = np.inf if fixed else 0.9 * (float(control.breaks[0, interval + 1]) - start.t)
    return segment(problem, start, min(SEGMENT / pace, left), both=fixed, size=size, tolerance=tolerance)


def advance_by(problem: Problem, memory: Memory, found: Segment) -> None:
    """Advance the memory to the end of a segment as after a step; the work after every step is still to be done."""
    free = problem.eq.free
    memory.y[0] = np.concatenate([found.x[free], found.v[free]])
    memory.y[1] = np.concatenate([found.v[free], found.a[free]])
    memory.dense[: len(found.dense)], memory.multiplier[:] = found.dense, found.N
    span = found.end - found.begin
    memory.t, memory.t_old, memory.h_old, memory.pivot = found.end, found.begin, span, found.pivot
    memory.h, memory.error_old, memory.constraint = NEXT * span, 1e-4, 0.0
    memory.pivot_most = max(memory.pivot_most, found.pivot)
    memory.steps, memory.evaluations = memory.steps + 1, memory.evaluations + found.evaluations
    memory.launched, memory.series = 1, 0
    _record(problem, memory, found)


def _record(problem: Problem, memory: Memory, found: Segment) -> None:
    """Store the singular passages of a segment: minima of its scaled pivot below the limit of singularity."""
    from scipy.optimize import minimize_scalar

    times, most = np.linspace(found.begin, found.end, LOOKS), float(memory.pivot_most)
    pivots = np.array([_pivot(problem, found, t) for t in times])
    places = [(found.begin, pivots[0])] if found.begin == 0.0 and pivots[0] < EXACTLY * most else []
    for k in range(1, LOOKS - 1):
        if pivots[k] == pivots[k - 1 : k + 2].min() or (k == 1 and not places and pivots[0] < pivots[1]):
            least = minimize_scalar(
                lambda t: _pivot(problem, found, t),
                bounds=(times[k - 1], times[k + 1]),
                method="bounded",
                options={"xatol": 1e-9 * (found.end - found.begin)},
            )
            places.append((float(least.x), float(least.fun)))
    for when, least in places:
        if least < SINGULAR * most:
            if (k := memory.passages_met) < len(memory.passages):
                memory.passages[k] = when, least, float(when > 0 or np.abs(problem.v0).max() > 0)
            memory.passages_met += 1


def _pivot(problem: Problem, found: Segment, t: float) -> float:
    """Scaled pivot of the equations at t (s) of a segment."""
    y, free = np.zeros(found.dense.shape[1]), problem.eq.free
    interpolate(found.dense, min(max((t - found.begin) / (found.end - found.begin), 0.0), 1.0), y)
    x, v, a, N = problem.x0.copy(), problem.v0.copy(), np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x[free], v[free] = y[: len(free)], y[len(free) :]
    project(problem.eq, problem.ws, t, x, v, 1e-13)
    return float(evaluate(problem.eq, problem.ws, problem.user.call, t, x, v, a, N))


# Starts in or near a singular position: the first segment of the motion, and the note on it.

LOW = 0.1
"""Scaled pivot at the start below which it is compared with pivots of nearby positions."""
BESIDE = 0.1
"""Distance of the nearby positions as a fraction of the shortest member."""
PLACES = 3
"""Number of nearby positions."""
LARGEST = 400
"""Number of free coordinates up to which the degrees of freedom at the start are named."""
SHOWN = 3
"""Largest number of degrees of freedom that are named."""


class First(NamedTuple):
    """Values at the start that the equations do not give: accelerations a (3 n,), m/s^2, constraint forces N (rows,), N."""

    a: NDArray[np.float64]
    N: NDArray[np.float64]


def singular_start(problem: Problem) -> Singular | None:
    """Data of a start that may be near a singular position; None for any other start."""
    a, N = np.zeros(problem.x0.size), np.zeros(len(problem.eq.row))
    x, v = problem.x0.copy(), problem.v0.copy()
    pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
    if not len(N) or problem.motors is not None or not pivot < LOW:
        return None
    size, tolerance = sizes(problem)
    most, gain = _beside(problem, size, tolerance)
    return Singular(float(pivot), most, gain, a, size)


def singular_note(problem: Problem) -> tuple[str, ...]:
    """The note on a singular start at rest; empty if a velocity determines the motion."""
    found = problem.singular
    if found is None or found.pivot > EXACTLY * found.most or np.abs(problem.v0).max() > 0:
        return ()
    where = (
        f"The start is a singular position, at rest{_freedoms(problem)}: "
        "nothing determines which of the possible motions it takes."
    )
    fix = f"To choose a motion, start {1e-2 * found.size:.2g} m away from it, or with velocities."
    return (f"{where} The motion computed is the one nearest to the accelerations of the forces. {fix}",)


def _freedoms(problem: Problem) -> str:
    """The degrees of freedom at the start as text."""
    system = released(problem.system, not_prescribed(problem.system, dict(problem.tasks)))
    if len(system.free) > LARGEST:
        return ""
    there = mobility_at(system, problem.x0.reshape(-1, 3), beam_deformations)
    texts = [moves_text(system, mode) for mode in there.mechanisms[:SHOWN]]
    more = f", and {there.undriven - SHOWN} more" if there.undriven > SHOWN else ""
    return f", with {there.undriven} degrees of freedom ({'; '.join(texts)}{more})"


def start_beside(problem: Problem, control: Any, memory: Memory, samples: Samples) -> First | None:
    """Advance the memory of an integration by the first segment of a motion that starts near a singular position.

    Methods with fixed steps still begin at the start, with the accelerations of the motion there. Returns None if the start
    is regular, or if no segment is found.
    """
    start = problem.singular
    if start is None:
        return None
    if not start.near:
        integrate(problem.eq, problem.ws, problem.user.call, control, memory, samples.part(0, 0), 0)
        memory.pivot_most = max(start.pivot, start.most)
        return None
    found = segment_from(problem, control, State(0.0, problem.x0, problem.v0, start.a), 0, start.gain)
    if found is None:
        return None
    integrate(problem.eq, problem.ws, problem.user.call, control, memory, samples.part(0, 0), 0)
    memory.pivot_most = start.most
    if not isinstance(problem.method, ERROR_CONTROLLED) or problem.method.step is not None:
        nf = len(problem.eq.free)
        memory.y[1, nf : 2 * nf], memory.multiplier[:] = found.a0[problem.eq.free], found.N0
    else:
        advance_by(problem, memory, found)
    return First(found.a0, found.N0)


def _beside(problem: Problem, size: float, tolerance: float) -> tuple[float, float]:
    """Largest scaled pivot near the start, and the smallest of the largest accelerations there, m/s^2; 0 if none can close."""
    free, rng, most, gain = problem.eq.free, np.random.default_rng(0), 0.0, np.inf
    # a direction without symmetry, and the one of weights in a row
    ways = [*rng.standard_normal((PLACES, len(free))), *(np.equal(free % 3, axis) * 1.0 for axis in range(problem.system.dim))]
    for way in ways:
        x, v = problem.x0.copy(), problem.v0.copy()
        x[free] += BESIDE * size * way
        a, N = np.zeros(x.size), np.zeros(len(problem.eq.row))
        good, _, _ = project(problem.eq, problem.ws, 0.0, x, v, tolerance)
        pivot = evaluate(problem.eq, problem.ws, problem.user.call, 0.0, x, v, a, N)
        if good and np.isfinite(a).all() and pivot > 0:
            most, gain = max(most, float(pivot)), min(gain, float(np.abs(a).max()))
    return most, gain if most > 0 else 0.0


# Determines which motions have the power series that `Taylor` needs.

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
        (eq.load, "a load turns with its body"),
        ([why for one in ELEMENTS if (why := one.without_series(system))], "{}"),
        (eq.bearing_ints, "bearings have friction"),
        ([problem.user] if problem.user.given else [], problem.user.words),
        ([problem.motors] if problem.motors is not None else [], "motors have inputs"),
    )
    return next((words.format(what[0]) for what, words in found if len(what)), None)


def by_default(problem: Problem) -> DOP853 | Taylor:
    """The default method: power series if the motion has one, does not have many segments, and no sums of terms (angles in
    space, couplings, springs on coordinates), whose series cost as much time as they save.
    """
    eq = problem.eq
    sums = eq.sum_row.size or on_coordinates(problem.system) is not None or np.any(eq.force_kind == SUM_FORCE)
    few = len(jumps(eq, all_pieces=True)) <= MANY
    return Taylor() if few and not sums and without_series(problem) is None else DOP853()


def refuse_series(problem: Problem) -> None:
    """Raise InputError if `Taylor` cannot be used."""
    if (why := without_series(problem)) is not None:
        raise InputError(f"method: Taylor has no power series of this motion: {why}. Use DOP853().")
