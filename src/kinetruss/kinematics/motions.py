"""Exact positions, velocities and accelerations of all nodes along a trajectory."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.arrays import array_of
from kinetruss.errors import AnalysisError, InputError, few
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.lengths import lengths
from kinetruss.kernels.sweep import follow as kernel
from kinetruss.kinematics.floating import adrift, edges_of
from kinetruss.kinematics.jacobians import singularity_at
from kinetruss.kinematics.positions import out_of_reach, own_start
from kinetruss.kinematics.redundant import LEAST, PARTED, Path, sweep, sweep_redundant
from kinetruss.kinematics.sampling import Sampled, check_trajectory, sample
from kinetruss.kinematics.time_tables import table_notes, with_supports
from kinetruss.kinematics.turns import REFINED, Passed, between, halved
from kinetruss.limits import hold, whole
from kinetruss.mechanics import System, arrange, cached, compile
from kinetruss.mechanics.arguments import number_of, positions_of
from kinetruss.mechanics.bays import POSE, departs, pose_values
from kinetruss.mechanics.beam_shapes import fixed_shapes, shaped
from kinetruss.mechanics.mobility import mobility_at, underdriven
from kinetruss.mechanics.rigid_motions import floats
from kinetruss.mechanics.rotations import rotation_axes, rotations
from kinetruss.model import Model, turned_far
from kinetruss.model.beam_checks import spin_note
from kinetruss.model.beam_frames import line_advice
from kinetruss.results import Arrays, Axes, Motion, Status, provenance, variable
from kinetruss.results.user_parts import part_axes, rotation_columns
from kinetruss.results.wide_tables import drive_unit
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


AXES = ("x", "y", "z")


@cached(of_records=True)
def _axes(system: System) -> Axes:
    """Names of nodes, axes, members and drives."""
    return Axes(
        {
            **part_axes(system),
            "drive": np.array(system.drives, dtype=object).astype(str),
            **drive_unit(system)[1],
            **rotation_axes(system),
        }
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """Histories of a motion: t (times,) s; x, v, a (times, 3 n); drive : values, rates and second rates (times or more,
    drives); gauge (times,) : singularity measure, None if not computed; passed : the states between samples; attrs : more
    attributes.
    """

    t: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    drive: tuple[NDArray[np.float64], ...]
    gauge: NDArray[np.float64] | None = None
    passed: Passed | None = None
    attrs: Mapping[str, Any] = field(default_factory=dict)

    def until(self, k: int) -> Course:
        """The first k samples."""
        gauge = None if self.gauge is None else self.gauge[:k]
        return replace(self, t=self.t[:k], x=self.x[:k], v=self.v[:k], a=self.a[:k], gauge=gauge)


def motion_of(system: System, found: Course, space: str, status: Status, message: str) -> Motion:
    """Motion from histories of nodes and drives."""
    arrays = motion_arrays(system, found, space)
    message = f"{message} {rods_that_stick_out(system, found.t, arrays.columns['length'].values)}".strip()
    return Motion(data=arrays.later, status=status, message=message, provenance=provenance(system.given, space=space))


def motion_arrays(system: System, found: Course, space: str) -> Arrays:
    """The arrays of a motion."""
    t, x, v, a, drive = found.t, found.x, found.v, found.a, found.drive
    count = len(t)
    gauge = np.full(count, np.nan) if found.gauge is None else found.gauge
    L, Ld, Ldd = allocate(*[(count, len(system.members))] * 3)
    lengths(system.p, system.q, x, v, a, L, Ld, Ldd)
    nodal, member, driven = ("time", "node", "axis"), ("time", "member"), ("time", "drive")

    def shaped(y: NDArray[np.float64]) -> NDArray[np.float64]:
        return y.reshape(count, len(system.nodes), 3)[:, :, : system.dim]

    unit = drive_unit(system)[0]
    data = {
        "position": variable(nodal, shaped(x), "m", "node position"),
        "velocity": variable(nodal, shaped(v), "m/s", "node velocity"),
        "acceleration": variable(nodal, shaped(a), "m/s^2", "node acceleration"),
        "length": variable(member, L, "m", "member length"),
        "length_rate": variable(member, Ld, "m/s", "rate of member length"),
        "length_acceleration": variable(member, Ldd, "m/s^2", "second rate of member length"),
        "drive_position": variable(driven, drive[0][:count], unit, "drive coordinate"),
        "drive_velocity": variable(driven, drive[1][:count], f"{unit}/s", "drive rate"),
        "drive_acceleration": variable(driven, drive[2][:count], f"{unit}/s^2", "drive acceleration"),
        "singularity": variable(("time",), gauge, "", "distance from a singular position"),
    }
    data |= rotation_columns(system, ("time",), lambda: rotations(system, x.reshape(count, len(system.nodes), 3)))
    if found.passed is not None:
        data |= found.passed.variables(system)
    return Arrays(_axes(system), t, data, {"kind": "motion", "trajectory_space": space, **found.attrs})


def rods_that_stick_out(system: System, t: NDArray[np.float64], length: NDArray[np.float64]) -> str:
    """Which active members become shorter than one of their rods, and when; empty if none does."""
    two = np.flatnonzero(system.two_rods)
    if not len(t) or not len(two):
        return ""
    rod = system.own_rods[two][:, [1, 4]]
    short = length[:, two].argmin(axis=0)
    least = length[short, two]
    off = rod.max(axis=1) - least
    bad = np.flatnonzero(off > 1e-9 * least)
    if not len(bad):
        return ""
    k = int(bad[off[bad].argmax()])
    which = ("base", "tube")[int(rod[k].argmax())]
    more = f" So do {len(bad) - 1} more." if len(bad) > 1 else ""
    return (
        f"{system.members[two[k]]} shortens to {least[k]:.6g} m (t = {t[short[k]]:g} s), less than its {which} rod of "
        f"{rod[k].max():.6g} m, which is impossible: forces include the whole rod.{more} Shorten the rod, or the stroke."
    )


# Exact positions, velocities and accelerations of all nodes along a trajectory.

BENT = (
    "In a motion of drives beams keep their shape. If the motion bends them, it follows from forces: dynamics.simulate, "
    "statics.equilibrium."
)


@one_thread
def follow(
    model: Model,
    trajectory: Any,
    *,
    samples: int = 201,
    times: ArrayLike | None = None,
    start: ArrayLike | None = None,
    least: float = LEAST,
    raise_on_failure: bool = True,
) -> Motion:
    """Follow a trajectory of lengths, angles, coordinates or poses.

    Parameters
    ----------
    trajectory : a trajectory record, or the name of one in the model.
    samples : equally spaced instants from 0 to the trajectory's duration, both included.
    times : the instants instead, s, increasing.
    start : (n_nodes, dim) a configuration at the first instant, m; by default reached from the model's own.
        A structure that floats begins there, or in the model's own at 0 s, with the momentum of the model's `velocities`.
    least : the motion stops if the singularity measure falls below this value.
    raise_on_failure : False gives the good samples with a status instead of an exception.

    Returns
    -------
    Motion with position, velocity, acceleration (time, node, axis) m, m/s, m/s^2; length and its rates (time, member);
    drive_position and its rates (time, drive); of beams node_rotation (time, frame, about) rad, of their nodes from the model:
    in the plane from -pi to pi, in space the vector along the axis; singularity (time): distance from a singular position, 0
    in one: the smallest singular value of the Jacobian's blocks, rows of unit length, where the shape of rigid parts does not
    count.

    Raises
    ------
    InputError : faults of the trajectory, fewer drives than freedoms, drives that contradict each other. Nothing was computed.
    AnalysisError : lengths that cannot close or a singular position; `result` is the Motion up to the last good state.

    Notes
    -----
    Each sample takes one forward sweep over the blocks of the block triangular form: Newton's method for positions, then
    velocities and accelerations with the same factors. There are no differences in time, so the sample spacing does not
    change the result. A structure that nothing holds moves as a whole by its momentum, under gravity and all loads of the model
    (see `docs/kinematics.md`): its velocities satisfy the momenta to round-off, and its attitude has the error that the message
    gives, about 1e-12 rad. If anything turns far between two samples, instants in between are computed too, so that whole
    turns and the branch do not depend on the samples; the motion keeps these states (``between_time``, ``between_position``,
    ``between_velocity``).

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")}
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"turn": 3.0}, duration=1.0), samples=5)
    >>> motion.velocity.sel(node="B").values[0].round(9).tolist()  # m/s: r w, upwards
    [0.0, 6.0]
    >>> motion.acceleration.sel(node="B").values[0].round(9).tolist()  # m/s^2: r w^2, to the centre
    [-18.0, 0.0]
    """
    system = compile(model)
    if isinstance(trajectory, str):
        trajectory = _named(model, trajectory)
    check_trajectory(system, trajectory)
    t = instants(trajectory.duration, samples, times, model)
    motion, beyond = _followed(model, system, trajectory, t, start, least)
    if beyond and motion.status.ok:
        motion = motion.with_(status=Status.NOT_CONVERGED, message=beyond)
    if raise_on_failure and not motion.status.ok:
        raise AnalysisError(motion.message, motion)
    for note in (*map(str, turned_far(model, trajectory)), table_notes(model, trajectory), _of_shapes(system)):
        motion = with_note(motion, note)
    return motion


def _of_shapes(system: System) -> str:
    """The note on beams that keep their shape."""
    held = fixed_shapes(system)
    if held is None:
        return ""
    # a rigid link is expected to
    links = system.model.links
    names = [name for name in held.names if name not in links or links[name].kind == "elastic"]
    kept = f"Beams keep their shape: {few(names, 8)}. Their deflection under load: statics.deflection, flexible.vibration."
    text = kept if names else ""
    return f"{text} {spin_note(system.model)}".strip()


def with_note(motion: Motion, note: str) -> Motion:
    """The motion with a note added to its message."""
    return motion.with_(message=f"{motion.message} {note}".strip()) if note else motion


def off_pose(system: System, t: NDArray[np.float64], x: NDArray[np.float64], sampled: Sampled) -> tuple[int, str] | None:
    """The first sample at which a bay is not in its prescribed pose (its supports may move apart), and the message.

    t (s,) s; x (s, 3 n) m. Returns None if there is no such sample.
    """
    if not sampled.poses:
        return None
    samples = np.searchsorted(sampled.times, t)
    poses = {name: asked[samples] for name, asked in sampled.poses.items()}
    found = [(departs(system, name, x, asked), name) for name, asked in poses.items()]
    if not (off := [(k, name) for k, name in found if k is not None]):
        return None
    k, name = min(off)
    got, asked = pose_values(system, name, x[k : k + 1])[0], poses[name][k]
    here, wanted = (", ".join(f"{part} {value:.9g}" for part, value in zip(POSE, q, strict=True)) for q in (got, asked))
    text = f"At t = {t[k]:g} s the bay of pose {name!r} stands at {here}; prescribed is {wanted}."
    mend = "The sides of the bay change: keep its base and top rigid, or prescribe its lengths instead of its pose."
    return k, f"{text} {mend}"


def _followed(
    model: Model, system: System, trajectory: Any, t: NDArray[np.float64], start: ArrayLike | None, least: float
) -> tuple[Motion, str]:
    """The motion at the instants t, and the error at the first pose out of reach."""
    course, found, sampled, beyond = course_along(model, system, trajectory, t, start, least)
    motion = motion_of(system, course, sampled.space, found.status, found.message)
    if off := off_pose(system, course.t, course.x, sampled):
        data = motion.whole.isel(time=slice(0, off[0]))
        motion = motion.with_(data=data, status=Status.NOT_CONVERGED, message=off[1])
    return motion, beyond


def course_along(
    model: Model, system: System, trajectory: Any, t: NDArray[np.float64], start: ArrayLike | None, least: float
) -> tuple[Course, Swept, Sampled, str]:
    """The histories at the instants t (s,) s, with more instants between those far apart; how the motion ended; the prescribed
    values; and the error at the first pose out of reach.
    """
    held = floats(system)
    # what floats moves as a whole from the beginning on
    late = held is not None and start is None and len(t) and t[0] > 0
    dense = between(trajectory, np.concatenate([[0.0], t]) if late else t)
    for _ in range(REFINED):
        sampled, beyond = _reachable(model, trajectory, dense)
        path = path_of(held or system, sampled.times, sampled)
        found = sweep_path(held or system, path, start=start, least=least)
        if held is not None:
            found = _adrift(model, held, trajectory, dense, found, start, least)
        finer = halved(system, found.x, found.v, dense, sampled)
        if len(finer) == len(dense):
            break
        dense = finer
    return course_at(dense, t, found, path.drive), found, sampled, beyond


def _adrift(
    model: Model, held: System, trajectory: Any, t: NDArray[np.float64], found: Swept, start: ArrayLike | None, least: float
) -> Swept:
    """The motion in space of a floating structure from that in a frame of its own, `found`, at the instants t (s,) s."""

    def shapes(times: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        sampled, _ = _reachable(model, trajectory, np.concatenate([t[:1], times]))
        swept = sweep_path(held, path_of(held, sampled.times, sampled), start=start, least=least)
        if len(swept.x) <= len(times):
            raise AnalysisError(f"Between the samples: {swept.message}")
        return swept.x[1:], swept.v[1:], swept.a[1:]

    if not (count := len(found.x)):
        return found
    moved = adrift(compile(model), shapes, t[:count], (found.x, found.v, found.a), edges_of(trajectory))
    return replace(found, x=moved.x, v=moved.v, a=moved.a, message=f"{found.message} {moved.words}".strip())


def course_at(
    dense: NDArray[np.float64], t: NDArray[np.float64], found: Swept, drive: tuple[NDArray[np.float64], ...]
) -> Course:
    """The result at the instants `dense`, split into samples at t (s,) and states between them."""
    count = len(found.x)
    if dense is t:
        return Course(t=t[:count], x=found.x, v=found.v, a=found.a, drive=drive, gauge=found.gauge)
    own = np.isin(dense[:count], t)
    samples, between = dense[:count][own], Passed(dense[:count][~own], found.x[~own], found.v[~own])
    return Course(
        t=samples,
        x=found.x[own],
        v=found.v[own],
        a=found.a[own],
        drive=tuple(one[:count][own] for one in drive),
        gauge=found.gauge[own],
        passed=between.within(-np.inf, samples[-1] if len(samples) else -np.inf),
    )


def _reachable(model: Model, trajectory: Any, t: NDArray[np.float64]) -> tuple[Sampled, str]:
    """The samples before the first pose out of reach, and the error there."""
    try:
        return sample(model, trajectory, t), ""
    except AnalysisError as error:
        if error.result is None or not len(error.result.times):
            raise InputError(f"{error} The path starts out of reach.") from None
        return error.result, str(error)


def instants(duration: float, samples: int, times: ArrayLike | None, model: Model | None = None) -> NDArray[np.float64]:
    """The time axis: `times`, or equally spaced over the duration; at most as many as a motion of `model` can hold.

    Raises
    ------
    InputError : no instant, no row of finite numbers, or an instant that is not after the one before; too many.
    """
    if times is None:
        samples = whole(samples, "samples", least=2)
        a_sample = 1 if model is None else 9 * len(model.whole.nodes) + 4 * len(model.whole.members)
        hold(samples * a_sample, f"A motion of {samples:,} samples", "Take fewer, or write a run to a folder (out).")
        return np.linspace(0.0, duration, samples)
    t = np.atleast_1d(array_of(times, "times", {}, {"times": None}, unit="s"))
    if not len(t):
        raise InputError("times has no instant. Give at least one, s.")
    if len(back := np.flatnonzero(np.diff(t) <= 0)):
        k = int(back[0])
        raise InputError(f"times[{k + 1}]: {t[k + 1]:g} s is not after {t[k]:g} s. Sort times, and give each instant once.")
    return t


def path_of(system: System, t: NDArray[np.float64], sampled: Sampled) -> Path:
    """Drive and support histories of a sampled trajectory on the time axis."""
    drive = (sampled.value, sampled.rate, sampled.acceleration)
    columns = system.coordinate_drive[:, 1]
    value, rate, second = (each[:, columns] for each in drive)
    moving = with_supports(system, t, (value, rate, second))
    value, rate, second = map(np.ascontiguousarray, drive)
    return Path(t=t, drive=(value, rate, second), moving=moving)


@dataclass(frozen=True, kw_only=True, eq=False)
class Swept:
    """Flat histories (times, 3 n), m and s, and the singularity measure (times,) of the good samples; how the motion ended."""

    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    gauge: NDArray[np.float64]
    status: Status
    message: str


def follow_path(system: System, path: Path, space: str, *, start: ArrayLike | None = None, least: float = LEAST) -> Motion:
    """`follow` for a compiled system along prescribed histories; failures are reported by the status."""
    s = sweep_path(system, path, start=start, least=least)
    course = Course(t=path.t[: len(s.x)], x=s.x, v=s.v, a=s.a, drive=path.drive, gauge=s.gauge)
    return motion_of(system, course, space, s.status, s.message)


def sweep_path(system: System, path: Path, *, start: ArrayLike | None = None, least: float = LEAST) -> Swept:
    """The histories from which `follow_path` makes a Motion; loose beams keep their shape."""
    solved = shaped(system)
    try:
        return _swept(solved, path, start, least)
    except InputError as error:
        if solved is system:
            raise
        raise InputError(f"{error} {BENT}") from None


def _swept(system: System, path: Path, start: ArrayLike | None, least: float) -> Swept:
    arrangement = arrange(system)
    if arrangement.plan is None:
        raise underdriven(system)
    at = own_start(system) if start is None else positions_of(system, start, "start")
    least = number_of(least, "least", "smallest gauge", infinite=True)
    histories = allocate(*[(len(path.t), system.x0.size)] * 3, (len(path.t),))
    x, v, a, gauge = histories
    if len(arrangement.redundant):
        reason, good, reached = sweep_redundant(system, arrangement, path, at, start is not None, least, histories)
    else:
        reason, good, reached = sweep(
            system, arrangement.plan, path, at, start is not None, slice(0, len(path.t)), least, histories
        )
    if reason == kernel.WEAK and good == 0 and mobility_at(system, x[0].reshape(-1, 3)).undriven:
        raise underdriven(system)
    status, message = _verdict(system, path, reason, good, reached, x)
    return Swept(x=x[:good], v=v[:good], a=a[:good], gauge=gauge[:good], status=status, message=message)


def _named(model: Model, name: str) -> Any:
    if name not in model.trajectories:
        raise InputError(f"No trajectory called {name!r}. There are: {', '.join(model.trajectories) or 'none'}.")
    return model.trajectories[name]


def _way_out(system: System) -> str:
    """How to start elsewhere; of bars on one line, how to make the link."""
    advice = line_advice(system.model)
    return f"{advice}." if advice else "Start it near that position, or drive another member there."


def _verdict(system: System, path: Path, reason: int, good: int, reached: float, x: NDArray[np.float64]) -> tuple[Status, str]:
    if reason == kernel.DONE:
        return Status.COMPLETED, ""
    if good == 0 and (reason == kernel.WEAK or np.allclose(path.drive[0][0], system.drive_start, rtol=0, atol=1e-12)):
        return Status.SINGULAR, (
            f"The path starts (t = {path.t[0]:g} s) in a singular position, in which the drives do not determine how the "
            f"structure moves on. {_way_out(system)}"
        )
    if good == 0:
        return Status.NOT_CONVERGED, (
            f"The lengths at the start of the path (t = {path.t[0]:g} s) cannot be closed: {reached:.1%} of the way from the "
            "model's own lengths was reached. Start the path at the model's lengths, or draw the model nearer to it."
        )
    here, last = path.t[min(good, len(path.t) - 1)], path.t[good - 1]
    # if continuation failed, row `good` holds the last state it reached on the way to that sample
    end = good if reason == kernel.STUCK else good - 1
    first, weakest = singularity_at(system, x[[0, end]])
    text = f"between t = {last:g} s and {here:g} s (singularity measure {first:.2g} at the start, {weakest:.1g} there)"
    good_to = f"The motion is good up to t = {last:g} s."
    if reason in (kernel.STUCK, PARTED) and weakest > max(0.05 * first, 1e-3):
        return Status.NOT_CONVERGED, f"The lengths cannot be closed {text}. {good_to} Correct the path there."
    if reason in (kernel.STUCK, PARTED) and good < len(path.t) and (far := out_of_reach(system, path, good, x[end])):
        return Status.OUT_OF_REACH, f"Out of reach {text}: {far}. {good_to} Keep the path within the reach of the structure."
    return Status.SINGULAR, (
        f"The path runs into a singular position {text}. {good_to} Change the path to avoid it, or drive another member there."
    )
