"""Many motions of one model and their forces, as plain arrays without records."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.force_tables import Carried, Read, forces_of
from kinetruss.dynamics.imbalance import unbalanced
from kinetruss.dynamics.prescribed import solve, with_friction
from kinetruss.errors import InputError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.lengths import lengths
from kinetruss.kernels.structure.structure import States
from kinetruss.kinematics.inverse_motion import course_to
from kinetruss.kinematics.motions import Course, course_along, instants, off_pose, path_of, rods_that_stick_out, sweep_path
from kinetruss.kinematics.redundant import LEAST
from kinetruss.kinematics.sampling import Sampled, check_trajectory
from kinetruss.kinematics.time_tables import table_notes
from kinetruss.kinematics.turns import halved
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.elements import refuse_turns
from kinetruss.mechanics.loads import case_loads
from kinetruss.model import Model, moved_by
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class Places(NamedTuple):
    """Good samples of a motion as plain arrays, with the inner nodes of beams, bodies and hubs behind those of the user.

    t (s,) s; position, velocity, acceleration (s, n_nodes, 3) m, m/s, m/s^2 (z is 0 in the plane); drive_position,
    drive_velocity, drive_acceleration (s, drives) m or rad, per s, per s^2; singularity (s,), the measure of
    `kinematics.follow`. status, message : how the motion ended.
    """

    t: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    drive_position: NDArray[np.float64]
    drive_velocity: NDArray[np.float64]
    drive_acceleration: NDArray[np.float64]
    singularity: NDArray[np.float64]
    status: Status
    message: str


class PreparedModel:
    """A model prepared for many motions and their forces; see `prepare`. system : one with other numbers than the model's."""

    def __init__(self, model: Model, load_case: str | None, system: System | None = None) -> None:
        self.model, self.load_case = model, load_case
        self._system = compile(model) if system is None else system
        case_loads(self._system, np.zeros(1), load_case, rotating=True)

    def follow(
        self,
        trajectory: Any,
        *,
        samples: int = 201,
        times: ArrayLike | None = None,
        start: ArrayLike | None = None,
        least: float = LEAST,
    ) -> Places:
        """The arrays of `kinematics.follow`; the status reports a motion that ends early, without an exception.

        Raises
        ------
        InputError : as `kinematics.follow`.
        """
        system, model = self._system, self.model
        if isinstance(trajectory, str):
            raise InputError("A prepared model follows records. Give model.trajectories[name].")
        check_trajectory(system, trajectory)
        t = instants(trajectory.duration, samples, times, model)
        course, found, sampled, beyond = course_along(model, system, trajectory, t, start, least)
        note = table_notes(model, trajectory)
        if off := off_pose(system, course.t, course.x, sampled):
            return _places(system, course.until(off[0]), Status.NOT_CONVERGED, f"{off[1]} {note}".strip())
        if beyond and found.status.ok:
            return _places(system, course, Status.NOT_CONVERGED, f"{beyond} {note}".strip())
        return _places(system, course, found.status, _said(system, course, found.message, note))

    def inverse(
        self,
        targets: Any,
        *,
        platform: Sequence[str] | None = None,
        samples: int = 201,
        times: ArrayLike | None = None,
        least: float = LEAST,
    ) -> Places:
        """The arrays of `kinematics.inverse`, as `follow` gives them.

        Raises
        ------
        InputError : as `kinematics.inverse`.
        """
        moved_by(targets)  # raises an error if it is not a trajectory
        t = instants(targets.duration, samples, times, self.model)
        course, found = course_to(self._system, targets, t, platform, least)
        message = _said(self._system, course, found.message, table_notes(self.model, targets))
        return _places(self._system, course, found.status, message)

    def along(
        self,
        t: ArrayLike,
        value: ArrayLike,
        rate: ArrayLike,
        acceleration: ArrayLike,
        *,
        start: ArrayLike | None = None,
        least: float = LEAST,
    ) -> Places:
        """Follow drives given as arrays (s, drives), m or rad, per s, per s^2, in the order of ``model.all_drives``.

        t : (s,) s, increasing. start, least : as in `kinematics.follow`.

        Raises
        ------
        InputError : wrong shapes, numbers that are not finite, or samples between which something turns by more than 0.8 rad.
        """
        system, t = self._system, instants(0.0, 2, t)
        laws = [
            _table(system, len(t), y, name) for y, name in ((value, "value"), (rate, "rate"), (acceleration, "acceleration"))
        ]
        sampled = Sampled(drives=system.drives, times=t, value=laws[0], rate=laws[1], acceleration=laws[2], space="lengths")
        path = path_of(system, t, sampled)
        found = sweep_path(system, path, start=start, least=least)
        if (more := len(halved(system, found.x, found.v, t, sampled))) > len(t):
            raise InputError(
                f"Something turns by more than 0.8 rad between two of the {len(t)} samples. "
                f"Give {more} or more samples of the same motion."
            )
        course = Course(t=t[: len(found.x)], x=found.x, v=found.v, a=found.a, drive=path.drive, gauge=found.gauge)
        return _places(system, course, found.status, _said(system, course, found.message))

    def forces(self, places: Places, *, static: bool = False) -> Carried:
        """The forces of members, supports and drives along a motion of this model: the arrays of `dynamics.inverse`.

        static : the forces of the same poses at rest instead. The motion is not checked.

        Raises
        ------
        InputError : beams whose forces balance alone does not decide.
        """
        system, count = self._system, len(places.t)
        x, v, a = (y.reshape(count, -1) for y in places[1:4])
        length, length_rate, _ = _lengths(system, x, v, a)
        if static:
            v = a = np.zeros((1, x.shape[1]))
        else:
            refuse_turns(system, places.t, x, v)
        loads = case_loads(system, places.t, self.load_case, rotating=True).at(x)
        states, read = States(x, v, a), Read(length, length_rate, places.drive_position, places.drive_velocity)
        solved = with_friction(
            system, read, loads, states, lambda pushed: solve(system, places.drive_position, pushed, states), at_rest=static
        )
        if off := solved.get("off", 0.0):
            raise InputError(unbalanced(off, static))
        return forces_of(system, read, loads, solved, static)[0]


def prepare(model: Model, load_case: str | None = None) -> PreparedModel:
    """Prepare a model for many motions and their forces. Results are plain arrays, equal to those of single calls.

    `dynamics.prepare` does the same for simulations. load_case : name of a load case; None takes all loads with factor 1.

    Raises
    ------
    InputError : an unknown load case.

    Examples
    --------
    >>> import kinetruss as kt
    >>> arm = kt.Model(nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=2)}, fixed=["O"], bars={"arm": ("O", "A")},
    ...                drives={"motor": kt.AngleDrive("arm")}, gravity=(0, -9.81))
    >>> ready = kt.prepare(arm)
    >>> for rate in (1.0, 2.0):
    ...     turn = ready.follow(kt.ConstantRate(rates={"motor": rate}, duration=0.1), samples=2)
    ...     print(ready.forces(turn).drive_force[:, 0].round(3).tolist())
    [19.62, 19.522]
    [19.62, 19.229]
    """
    return PreparedModel(model, load_case)


def _places(system: System, course: Course, status: Status, message: str) -> Places:
    shape = (len(course.t), len(system.nodes), 3)
    x, v, a = (y.reshape(shape) for y in (course.x, course.v, course.a))
    value, rate, second = (y[: len(course.t)] for y in course.drive)
    gauge = np.full(len(course.t), np.nan) if course.gauge is None else course.gauge
    return Places(course.t, x, v, a, value, rate, second, gauge, status, message)


def _said(system: System, course: Course, message: str, note: str = "") -> str:
    """The message of a motion, with notes on rods longer than their member and on tables."""
    rods = ""
    if system.two_rods.any():
        rods = rods_that_stick_out(system, course.t, _lengths(system, course.x, course.v, course.a)[0])
    return " ".join(filter(None, (message, rods, note)))


def _lengths(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64], a: NDArray[np.float64]
) -> tuple[NDArray[np.float64], ...]:
    """Lengths of members (s, members), m, and their rates."""
    found = allocate(*[(len(x), len(system.members))] * 3)
    lengths(system.p, system.q, x, v, a, *found)
    return found


def _table(system: System, count: int, given: ArrayLike, name: str) -> NDArray[np.float64]:
    found, wanted = np.ascontiguousarray(given, dtype=float), (count, len(system.drives))
    if found.shape != wanted:
        raise InputError(f"{name} has shape {found.shape}. Give {wanted}, with drives {', '.join(system.drives[:6])}.")
    if not np.isfinite(found).all():
        raise InputError(f"{name} has numbers that are not finite. Give finite numbers.")
    return found
