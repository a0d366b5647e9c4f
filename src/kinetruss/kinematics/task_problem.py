"""The drives that meet tasks, as one problem, and the places from which its solution is sought.

They are the same in every call.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.coordinates.tape import tape_of
from kinetruss.kernels.tasks import reach as cold, track as warm
from kinetruss.kernels.tasks.sweeps import Drives, TaskWork, workspace_of
from kinetruss.kinematics.motions import Swept, sweep_path
from kinetruss.kinematics.positions import own_start
from kinetruss.kinematics.redundant import LEAST, Path
from kinetruss.kinematics.task_programs import Tasks, tasks_of
from kinetruss.kinematics.time_tables import support_history
from kinetruss.mechanics import System, arrange, measure_of
from kinetruss.mechanics.beam_shapes import shaped
from kinetruss.mechanics.mobility import underdriven
from kinetruss.mechanics.positions import drive_places, shortest
from kinetruss.model import Active, LengthDrive

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.coordinates.tape import Tape
    from kinetruss.kernels.structure.structure import Plan


STARTS = 16
"""Starts of a pose that is not met."""
NEAR = 0.15
"""Change of drives near by, in units of the shortest bar or rad, and 0.4 of the stroke at most."""
WIDE = 0.4
"""Spread of lengths without limits about the start, in units of the shortest bar; angles turn half a turn to either side."""


def starts_of(given: Any, first: Any, count: int) -> Iterator[Any]:
    """At most `count` states to start from: the first, the model's own, then in turn from the spread and near the first.

    given, first : the `Problem` of the task and a `State` of it.
    """
    yield first
    own = not np.array_equal(first.q, given.begin.q)
    if own and count > 1:
        yield given.begin
    rng, rest = np.random.default_rng(1), max(0, count - 1 - own)
    spread = _spread(given, rng, (rest + 1) // 2)
    for k in range(rest):
        start = given.begin if k % 2 == 0 else first
        wanted = spread[k // 2] if k % 2 == 0 else _near(given, rng, first.q)
        # a share of the way where the structure cannot be closed on all of it
        for share in (1.0, 0.5, 0.25):
            if (found := given.moved(start, start.q + share * (wanted - start.q))) is not None:
                yield found
                break


def _spread(given: Any, rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Drives (count, d) in all parts of their strokes, by a Latin hypercube (McKay, Beckman and Conover, 1979).

    Every other one has all its drives at the nearer ends of their strokes, where nearest poses often are.
    """
    lower, upper, own = given.drives.lower, given.drives.upper, given.begin.q
    room = np.where(given.turning, np.pi, WIDE * given.scale)
    low, high = np.where(np.isfinite(lower), lower, own - room), np.where(np.isfinite(upper), upper, own + room)
    cells = np.stack([rng.permutation(count) for _ in own], axis=1) + rng.uniform(size=(count, len(own)))
    share = cells / max(1, count)
    share[::2] = np.round(share[::2])
    found: NDArray[np.float64] = np.where(given.drives.held == 3, own, low + (high - low) * share)
    return found


def _near(given: Any, rng: np.random.Generator, q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Some other drives (d,) near by, within their strokes."""
    lower, upper = given.drives.lower, given.drives.upper
    room = np.minimum(NEAR * given.units, 0.4 * (upper - lower))
    return np.where(given.drives.held == 3, q, np.clip(q + rng.uniform(-1, 1, len(q)) * room, lower, upper))


# The drives that meet tasks, as one problem: least weighted squares from a reference, tasks met, strokes kept.

CLOSE = 1e-2
"""Change of drives, in units of the shortest bar, or rad, up to which positions follow without continuation."""
MET = 1e-8
"""Largest miss of a task that counts as met, as a fraction of the shortest bar."""
OPEN = (
    "the bars do not close at the drives from which the task starts: lengths do not fit each other, or the position is "
    "singular. Check the lengths of the model (`kinetruss check`), or start from another position."
)
SAME = 1e-5
"""Difference of misses, as a fraction of the shortest bar, up to which two poses out of reach count as equally near."""


@dataclass(frozen=True, kw_only=True, eq=False)
class State:
    """Positions x (3 n,), drives q (d,), and factors s (m,) of tasks; miss (m,), m, of the tasks.

    starts, same : of a nearest pose, from how many starts it was sought, and how many of them came as near.
    """

    x: NDArray[np.float64]
    q: NDArray[np.float64]
    s: NDArray[np.float64]
    miss: NDArray[np.float64]
    starts: int = 1
    same: int = 1

    @property
    def far(self) -> float:
        """Largest miss, m."""
        return float(np.abs(self.miss).max(initial=0.0))


@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """Tasks of a system as kernels take them. reference (d,) : what drives are to be near to. begin : the start."""

    system: System
    tasks: Tasks
    plan: Plan
    tape: Tape
    drives: Drives
    reference: NDArray[np.float64]
    begin: State

    @cached_property
    def scale(self) -> float:
        """Shortest bar, m."""
        return shortest(self.system)

    @cached_property
    def turning(self) -> NDArray[np.bool_]:
        """Which drives (d,) are angles."""
        return np.array([_turning(self.system, d) for d in range(len(self.reference))])

    @cached_property
    def units(self) -> NDArray[np.float64]:
        """Changes (d,) of drives that count as much as each other: the shortest bar, m, or 1 rad."""
        return np.where(self.turning, 1.0, self.scale)

    def linear(self, state: State, parameters: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """What tasks are off by (m,), and their derivatives by the drives (m, d)."""
        room = self.room(state, parameters)
        cold.linear(self.plan, self.drives, self.tape, room, self.scale)
        return room.r[len(state.q) :].copy(), room.A.copy()

    def closes(self, state: State, parameters: NDArray[np.float64]) -> bool:
        """Whether the bars close at the drives of a state, at a position where they also fix its rates."""
        return bool(cold.linear(self.plan, self.drives, self.tape, self.room(state, parameters), self.scale))

    def room(self, state: State, parameters: NDArray[np.float64]) -> TaskWork:
        """Room for kernels, with a state and parameters in it."""
        room = workspace_of(self.plan, self.tape, len(state.x), len(state.q), len(parameters))
        room.x[0], room.q[0], room.s[0], room.p[0] = state.x, state.q, state.s, parameters
        room.ref[0], room.moving[0] = self.reference, state.x[self.plan.moving]
        return room

    def reach(self, parameters: NDArray[np.float64], start: State | None = None, *, starts: int | None = None) -> State:
        """The state that meets the tasks at these parameters, or the one of least sum of squares of misses from some starts."""
        found: list[State] = []
        for one in starts_of(self, start or self.begin, STARTS if starts is None else starts):
            found.append(self._reached(parameters, one))
            if found[-1].far <= MET * self.scale:
                return found[-1]
        sizes = np.array([np.linalg.norm(one.miss) for one in found])
        same = int(np.count_nonzero(sizes <= sizes.min() + SAME * self.scale))
        return replace(found[int(np.argmin(sizes))], starts=len(found), same=same)

    def moved(self, start: State, q: NDArray[np.float64]) -> State | None:
        """The state that drives q (d,) reach on a straight way from a state; None if the way cannot be gone."""
        x = drive_path(self.system, np.linspace(start.q, q, 5), start.x)
        return None if x is None else replace(start, x=x, q=q)

    def _reached(self, parameters: NDArray[np.float64], start: State) -> State:
        self.drives.held[self.drives.held != 3] = 0
        room = self.room(start, parameters)
        cold.reach(self.plan, self.drives, self.tape, room, self.scale)
        found = State(x=room.x[0].copy(), q=room.q[0].copy(), s=room.s[0].copy(), miss=start.miss)
        room = self.room(found, parameters)
        closed = cold.linear(self.plan, self.drives, self.tape, room, self.scale)
        return replace(found, miss=room.r[len(found.q) :].copy() if closed else np.full(len(found.miss), np.inf))

    def linears(self, near: State, q: NDArray[np.float64], parameters: NDArray[np.float64]) -> NDArray[np.float64]:
        """Derivatives (k, m, d) of the tasks by the drives at drives q (k, d) near those of a state."""
        return np.stack([room.A.copy() for room, _ in self._beside(near, q, parameters)])

    def positions(self, near: State, q: NDArray[np.float64], parameters: NDArray[np.float64]) -> NDArray[np.float64]:
        """Positions (k, 3 n) that drives q (k, d) near those of a state give."""
        return np.stack([room.x[0].copy() for room, _ in self._beside(near, q, parameters)])

    def near(self, start: State, q: NDArray[np.float64], parameters: NDArray[np.float64]) -> State | None:
        """The state of drives q (d,), from a state, by Newton's method where they are near by; None if there is none."""
        if np.abs((q - start.q) / self.units).max() <= CLOSE:
            room, good = next(self._beside(start, q[None], parameters))
            return replace(start, x=room.x[0].copy(), q=q) if good else None
        return self.moved(start, q)

    def _beside(self, near: State, q: NDArray[np.float64], parameters: NDArray[np.float64]) -> Iterator[tuple[TaskWork, bool]]:
        """Room of the states of drives q (k, d) near those of a state, and whether Newton's method converged there."""
        room = self.room(near, parameters)
        for one in q:
            room.x[0], room.q[0] = near.x, one
            yield room, cold.linear(self.plan, self.drives, self.tape, room, self.scale)

    def polished(self, parameters: NDArray[np.float64], state: State) -> State:
        """A state that meets the tasks after one more step of Newton's method, if that comes nearer."""
        c, A = self.linear(state, parameters)
        free = self.drives.held != 3
        q = state.q.copy()
        q[free] -= np.linalg.lstsq(A[:, free], c, rcond=None)[0]
        q = np.where(free, np.clip(q, self.drives.lower, self.drives.upper), q)
        room = self.room(replace(state, q=q), parameters)
        good = cold.linear(self.plan, self.drives, self.tape, room, self.scale)
        found = replace(state, x=room.x[0].copy(), q=q, miss=room.r[len(q) :].copy())
        return found if good and found.far < state.far else state

    def track(self, t: NDArray[np.float64], parameters: NDArray[np.float64], start: State, reference: Any = None) -> Any:
        """`kernels.tasks.track` from a start that meets the first sample; reference (3, times, d) Taylor coefficients."""
        n, d = len(t), len(self.reference)
        self.drives.held[self.drives.held != 3] = 0
        ref = np.zeros((3, n, d))
        ref[0] = self.reference
        supports = np.zeros((3, n, len(self.plan.moving)))
        supports[0] = start.x[self.plan.moving]
        own = len(self.system.coordinate_drive)
        if self.system.model.support_motion:
            value, rate, second = support_history(self.system, t)
            supports[0, :, own:], supports[1, :, own:], supports[2, :, own:] = value, rate, 0.5 * second
        given = warm.Given(t, parameters, ref if reference is None else reference, supports, self.scale)
        out = warm.Tracked(np.zeros((3, n, len(start.x))), np.zeros((3, n, d + self.tape.tasks)), np.zeros((n, d), np.int64))
        reason, good = warm.track(self.plan, self.drives, self.tape, self.room(start, parameters[0, 0]), given, out)
        return reason, good, out


def problem(system: System, targets: Any, choice: Any) -> Problem:
    """The problem of tasks; choice : a record with objective, weights, hold and within_stroke.

    Raises
    ------
    InputError : drives that leave freedoms, or none; more tasks than drives.
    """
    system = shaped(system)
    arrangement = arrange(system)
    if arrangement.plan is None:
        raise underdriven(system)
    if not system.drives:
        raise InputError("The model has no drives, so nothing can be done for a task. Make bars driven, or name all freedoms.")
    plan, tasks = arrangement.plan, tasks_of(system, targets)
    x = own_start(system)
    q = drive_places(system, x[None])[0]
    count = len(tasks.labels)
    for row in plan.sum_row:
        m = int(system.row_measure[plan.row[row]])
        tasks.program.result(measure_of(system, tasks.program, m))
    drives, reference = drives_of(system, plan, choice, q)
    begin = State(x=x.reshape(-1).copy(), q=q, s=np.zeros(count), miss=np.zeros(count))
    return Problem(
        system=system,
        tasks=tasks,
        plan=plan,
        tape=tape_of(tasks.program, count),
        drives=drives,
        reference=reference,
        begin=begin,
    )


def strokes(system: System) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Least and largest value of each drive, m; infinite where none is given."""
    lower, upper = np.full(len(system.drives), -np.inf), np.full(len(system.drives), np.inf)
    for d, name in enumerate(system.drives):
        drive = system.model.all_drives[name]
        member = system.model.members[drive.bar] if isinstance(drive, LengthDrive) else None
        if isinstance(member, Active) and member.limits is not None:
            lower[d], upper[d] = member.limits
    return lower, upper


def drives_of(system: System, plan: Plan, choice: Any, q: NDArray[np.float64]) -> tuple[Drives, NDArray[np.float64]]:
    """Where the drives act, and what they are to be near to."""
    count = len(system.drives)
    row, flat = np.full(count, -1, np.int64), np.full(count, -1, np.int64)
    for k in plan.driven:
        row[plan.drive[k]] = k if k < plan.ptr[-1] else -2
    for at, d in system.coordinate_drive:
        flat[d] = at
    if twice := [name for d, name in enumerate(system.drives) if row[d] == -2]:
        drive = system.model.all_drives[twice[0]]
        ends = [system.node_index(one) for one in system.model.members[drive.bar].ends] if hasattr(drive, "bar") else []
        if ends and system.prescribed.reshape(-1, 3)[ends, : system.dim].all():
            raise InputError(
                f"{twice[0]!r} joins two fixed nodes, so its length cannot change. Make it a bar (in a cell: leave it out of "
                "`active`), or free one of its ends."
            )
        raise InputError(
            f"{twice[0]!r} is held by other bars or drives too, so it cannot move alone. Release it, or hold less."
        )
    lower, upper = strokes(system)
    turning = np.array([_turning(system, d) for d in range(count)])
    weight = np.where(turning, shortest(system) ** 2, 1.0) * [choice.weights.get(name, 1.0) for name in system.drives]
    held = np.array([3 if name in choice.hold else 0 for name in system.drives], np.int64)
    reference, limited = q.copy(), np.isfinite(lower) & np.isfinite(upper)
    if choice.objective == "stroke_ends":
        if not limited.any():
            raise InputError(
                "No drive has limits, so none has ends of a stroke to keep away from. Give limits of active members."
            )
        reference[limited] = 0.5 * (lower + upper)[limited]
        half = 0.5 * (upper - lower)[limited]
        weight[limited] *= (half.min() / half) ** 2
        weight[~limited] *= 1e-3
    if not choice.within_stroke:
        lower, upper = np.full(count, -np.inf), np.full(count, np.inf)
    reference = np.where(held == 3, q, reference)
    arrays = {"row": row, "flat": flat, "held": held, "weight": weight, "lower": lower, "upper": upper}
    return Drives.of(arrays), reference


def _turning(system: System, d: int) -> bool:
    return system.model.all_drives[system.drives[d]].kind in ("angle", "hinge")


def drive_path(system: System, q: NDArray[np.float64], x: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Positions (3 n,) that the last drives of a path q (times, d) give, by continuation from x; None if it cannot be gone."""
    found = followed(system, np.arange(len(q), dtype=float), (q, np.zeros_like(q), np.zeros_like(q)), x)
    return found.x[-1] if len(found.x) == len(q) else None


def followed(system: System, t: NDArray[np.float64], drive: Any, x: NDArray[np.float64]) -> Swept:
    """The sweep along histories of drives from positions x (3 n,): positions, rates, singularity measure."""
    columns = system.coordinate_drive[:, 1]
    value, rate, second = (np.ascontiguousarray(one[:, columns]) for one in drive)
    if system.model.support_motion:
        value, rate, second = (np.hstack(two) for two in zip((value, rate, second), support_history(system, t), strict=True))
    values, rates, seconds = (np.ascontiguousarray(one) for one in drive)
    path = Path(t=t, drive=(values, rates, seconds), moving=(value, rate, second))
    return sweep_path(system, path, start=x.reshape(-1, 3)[:, : system.dim], least=LEAST)
