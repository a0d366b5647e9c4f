"""Vibration that a motion excites in elastic members and actuators: small displacements from the rigid motion."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError
from kinetruss.flexible.structure import Instant, Softness, elastic_stiffness, instants_of, modes_of, refuse_unloaded_beams
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics import System, compile, ends_of
from kinetruss.mechanics.arguments import number_of
from kinetruss.mechanics.matrices import bar_laws
from kinetruss.model import Model
from kinetruss.results import Forces, Result, provenance, variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Vibration", "settled_of", "vibration"]

FIRST = 8
"""Steps within a period of the lowest mode that are tried first."""

MOST = 100_000
"""Steps at most, of one integration."""

SPECTRAL = 0.8
"""Spectral radius of generalised-alpha where members are inextensible; 1 (the trapezoidal rule) where none is."""


class Vibration(Result):
    """Displacements and member forces of the elastic structure, and what they differ from the rigid answer."""


@one_thread
def vibration(
    model: Model,
    forces: Forces,
    *,
    damping: float = 0.0,
    rest: float = 0.0,
    stiffness: Mapping[str, float] | None = None,
    rigid: Collection[str] = (),
    tolerance: float = 1e-3,
) -> Vibration:
    """Vibration of elastic members and actuators, excited by a motion of the drives, against the rigid answer.

    Parameters
    ----------
    forces : from `dynamics.inverse` of the same model along the motion. Actuators have its lengths as natural lengths.
    damping : ratio of the lowest mode of the first sample; proportional to stiffness, so that a mode of n times that frequency
        has n times the ratio.
    rest : s after the end of a motion that ends at rest, in which the structure goes on vibrating.
    stiffness, rigid : as in `frequencies`.
    tolerance : steps are halved until the displacements change by less than this fraction of the largest.

    Returns
    -------
    Vibration, over the times of the forces, then those of the rest. ``displacement`` (time, node, axis) m, from the rigid
    motion; ``settled`` likewise, of the same forces without vibration (that of `statics.deflection`); ``elongation`` (time,
    member) m; ``member_force`` (time, member) N, elastic, without damping; ``difference`` (time, member) N, from the force of
    the rigid structure.
    attrs: ``overshoot``, largest displacement over the largest settled one; ``residual`` m, largest distance from the settled
    state after the end of the motion (NaN without rest); ``steps`` and ``step_change``, the change at the last halving.

    Raises
    ------
    InputError : as in `frequencies`; a rest after a motion that does not end at rest; too few samples.
    AnalysisError : the tolerance is not reached within 100,000 steps; ``error.result`` is the best answer.

    Notes
    -----
    M u'' + C u' + K u + G^T N = f - M a, G u = f N: first order in u about the rigid motion, with the matrices of every sample,
    linear in between, and the forces by a cubic spline. It starts in the settled state. Errors are of the second order in u;
    `simulate` has no such limit. Trapezoidal rule (Newmark, 1959); generalised-alpha (Chung & Hulbert, 1993) where members
    are inextensible.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
    ...     bars={"rod": kt.Bar(ends=("O", "A"), kind="driven", mass=0)},
    ... )
    >>> motion = kt.kinematics.follow(model, kt.Quintic(moves={"rod": (1.0, 0.9)}, duration=0.1), samples=51)
    >>> forces = kt.dynamics.inverse(model, motion)
    >>> found = kt.flexible.vibration(model, forces, rest=0.1, stiffness={"rod": 20e3})
    >>> found.settled.sel(node="A", axis="y").values[0].round(6).item()  # m: hangs m g/k lower
    -0.001
    >>> found.attrs["overshoot"] > 1
    True
    """
    system, ratio = compile(model), number_of(damping, "damping", "")
    if not 0 <= ratio < 1:
        raise InputError(f"damping is {damping}. Give a ratio from 0 to below 1.")
    still = number_of(rest, "rest", "s")
    soft = Softness(stiffness=stiffness or {}, rigid=rigid)
    refuse_unloaded_beams(model, forces)
    course = _course(list(instants_of(model, forces, soft)), forces, still, ratio)
    found, change, steps = _converged(course, tolerance)
    result = _record(system, forces, course, found, change, steps)
    if change > tolerance:
        said = (
            f"The displacements still change by {change:.1g} of the largest with {steps} steps. Raise the tolerance, or name "
            "stiff members in rigid."
        )
        raise AnalysisError(said, result)
    return result


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """t (times,) s; the structure at them; spline of the forces (n,); settled u (times, n) and N (times, rows); damping seconds
    (C per stiffness); samples of the motion itself; steps between samples to begin with; spectral radius of the method.
    """

    t: NDArray[np.float64]
    at: list[Instant]
    force: Any
    settled: tuple[NDArray[np.float64], NDArray[np.float64]]
    delay: float
    own: int
    parts: int
    radius: float


def _course(at: list[Instant], forces: Forces, rest: float, ratio: float) -> Course:
    from scipy.interpolate import CubicSpline

    if forces.whole.attrs.get("at_rest", 0):
        raise InputError("Poses at rest do not vibrate. Give the forces of a motion, by dynamics.inverse.")
    t = np.asarray(forces.arrays["time"].values, float)
    if len(t) < 4:
        raise InputError(f"A vibration needs four samples at least, got {len(t)}. Take more samples of the motion.")
    own, w = len(t), float(np.sqrt(modes_of(at[0], 1)[0][0]))
    force = CubicSpline(t, np.array([one.load for one in at]))
    if rest > 0:
        moving = max(float(np.abs(forces.motion.arrays[name].values[-1]).max()) for name in ("velocity", "acceleration"))
        if moving > 1e-9 * max(float(np.abs(forces.motion.arrays["velocity"].values).max()), 1e-300):
            raise InputError("The motion does not end at rest, so nothing is known after it. Leave rest at 0, or end at rest.")
        step = float(np.median(np.diff(t)))
        more = max(int(np.ceil(rest / step)), 1)
        t = np.concatenate([t, t[-1] + rest * np.arange(1, more + 1) / more])
        at = at + [at[-1]] * more
    elif rest < 0:
        raise InputError(f"rest is {rest} s. Give 0 or more.")
    settled = [settled_of(one) for one in at]
    parts = max(1, int(np.ceil(float(np.diff(t).max()) * w * FIRST / (2 * np.pi))))
    return Course(
        t=t,
        at=at,
        force=lambda s: force(min(s, t[own - 1])),
        settled=(np.array([u for u, _ in settled]), np.array([N for _, N in settled])),
        delay=2 * ratio / w,
        own=own,
        parts=parts,
        radius=1.0 if np.all(at[0].f > 0) else SPECTRAL,
    )


def _converged(course: Course, tolerance: float) -> tuple[tuple[NDArray[np.float64], NDArray[np.float64]], float, int]:
    """u and N with their errors of second order removed (Richardson), the change at the last halving, and the steps."""
    parts, last = course.parts, None
    coarse = _path(course, parts)
    while True:
        parts *= 2
        steps = parts * (len(course.t) - 1)
        fine = _path(course, parts)
        found = ((4 * fine[0] - coarse[0]) / 3, (4 * fine[1] - coarse[1]) / 3)
        size = float(np.abs(found[0]).max()) or 1.0
        change = np.inf if last is None else float(np.abs(found[0] - last).max()) / size
        if change <= tolerance or 2 * steps > MOST:
            return found, change, steps
        coarse, last = fine, found[0]


def settled_of(here: Instant) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """u (n,) and N (rows,) of the forces of an instant without vibration."""
    n, G = here.M.shape[0], here.G.toarray()
    matrix = np.block([[here.K.toarray(), G.T], [G, -np.diag(here.f)]])
    found = np.linalg.solve(matrix, np.concatenate([here.load, np.zeros(len(here.f))]))
    return found[:n], found[n:]


def _path(course: Course, parts: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """u (times, n) and N (times, rows) by generalised-alpha with `parts` steps between samples.

    Chung & Hulbert: balance at t + (1 - a_f) h with accelerations at t + (1 - a_m) h; second order for any radius.
    """
    radius = course.radius
    a_m, a_f = (2 * radius - 1) / (radius + 1), radius / (radius + 1)
    gamma, beta = 0.5 - a_m + a_f, 0.25 * (1 - a_m + a_f) ** 2
    u, N = course.settled[0][0].copy(), course.settled[1][0].copy()
    v, acceleration = np.zeros_like(u), np.zeros_like(u)
    us, Ns = [u], [N]
    for i in range(len(course.t) - 1):
        h = (course.t[i + 1] - course.t[i]) / parts
        ends = _dense(course.at[i], course.delay), _dense(course.at[i + 1], course.delay)
        for k in range(parts):
            share, now = (k + 1 - a_f) / parts, (k + 1) / parts
            M, C, K, G = (p + share * (q - p) for p, q in zip(ends[0][:4], ends[1][:4], strict=True))
            end, f = (ends[0][j] + now * (ends[1][j] - ends[0][j]) for j in (3, 4))
            guess = u + h * v + h * h * (0.5 - beta) * acceleration, v + h * (1 - gamma) * acceleration
            matrix = np.block(
                [
                    [(1 - a_m) * M + (1 - a_f) * (h * gamma * C + h * h * beta * K), G.T * (1 - a_f)],
                    [h * h * beta * end, -np.diag(f)],
                ]
            )
            force = course.force(course.t[i] + (k + 1 - a_f) * h)
            late = a_m * (M @ acceleration) + C @ ((1 - a_f) * guess[1] + a_f * v) + K @ ((1 - a_f) * guess[0] + a_f * u)
            right = np.concatenate([force - late - a_f * (G.T @ N), -end @ guess[0]])
            found = np.linalg.solve(matrix, right)
            acceleration, N = found[: len(u)], found[len(u) :]
            u, v = guess[0] + h * h * beta * acceleration, guess[1] + h * gamma * acceleration
        us.append(u)
        Ns.append(N)
    return np.array(us), np.array(Ns)


def _dense(here: Instant, delay: float) -> tuple[NDArray[np.float64], ...]:
    """M, C, K, G, f as arrays; C with damping that is proportional to the stiffness."""
    G, K, C = here.G.toarray(), here.K.toarray(), here.C.toarray()
    if delay:
        C = C + delay * (elastic_stiffness(here) + here.B.toarray())
    return here.M.toarray(), C, K, G, here.f


def _record(
    system: System,
    forces: Forces,
    course: Course,
    found: tuple[NDArray[np.float64], NDArray[np.float64]],
    change: float,
    steps: int,
) -> Vibration:
    (u, N), (su, _) = found, course.settled
    times, own = len(course.t), course.own
    shift = np.array([np.linalg.norm(_full(system, one), axis=2).max() for one in (u[:, None], su[:, None])])
    away = np.linalg.norm(_full(system, (u - su)[own:, None]), axis=2).max() if times > own else np.nan
    given = forces.arrays["member_force"].values
    still = np.concatenate([given, np.repeat(given[-1:], times - own, axis=0)])
    e, force = _elongations(system, course, u), still.copy()
    bars = np.flatnonzero(system.row_kind == LENGTH)
    rigid = np.array([one.N for one in course.at])
    force[:, system.row_member[bars]] += (N - rigid)[:, bars]
    springs = np.flatnonzero(system.spring > 0)
    if len(springs):
        lengths = [ends_of(system, one.x)[1] for one in course.at]
        force[:, springs] += (np.array([bar_laws(system, L).slope for L in lengths]) * e)[:, springs]
    per, at = ("time", "member"), ("time", "node", "axis")
    data = {
        "displacement": variable(at, _full(system, u[:, None])[:, :, : system.dim], "m", "displacement from the rigid motion"),
        "settled": variable(at, _full(system, su[:, None])[:, :, : system.dim], "m", "the same without vibration"),
        "elongation": variable(per, e, "m", "elastic elongation"),
        "member_force": variable(per, force, "N", "mean axial force, tension positive"),
        "difference": variable(per, force - still, "N", "force minus that of the rigid structure"),
    }
    coords = {name: forces.whole.coords[name] for name in ("node", "axis", "member")}
    attrs = {
        "kind": "vibration",
        "load_case": forces.load_case,
        "overshoot": float(shift[0] / shift[1]) if shift[1] else np.nan,
        "residual": float(away),
        "steps": steps,
        "step_change": change,
    }
    frame = xr.Dataset(data, coords={"time": course.t}, attrs=attrs).assign_coords(coords)
    return Vibration(
        data=frame,
        status=forces.status,
        message=forces.message,
        provenance=provenance(system.given, load_case=forces.load_case),
    )


def _elongations(system: System, course: Course, u: NDArray[np.float64]) -> NDArray[np.float64]:
    """(times, members) m, of first order in u (times, n)."""
    moved = _full(system, u[:, None])
    along = np.array([ends_of(system, one.x)[2] for one in course.at])
    return np.asarray(np.einsum("tmc,tmc->tm", moved[:, system.q] - moved[:, system.p], along))


def _full(system: System, u: NDArray[np.float64]) -> NDArray[np.float64]:
    """Displacements (times, nodes, 3) of free coordinates (times, 1, n)."""
    found = np.zeros((len(u), system.x0.size))
    found[:, system.free] = u[:, 0]
    return found.reshape(len(u), -1, 3)
