"""Drives that follow a trajectory by feedback in a simulation: reference, gains, limits, and the forces on the nodes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.screws import raising_torque
from kinetruss.actuators.shafts import train_of
from kinetruss.dynamics.closed_loop import push, rate_of, value_of
from kinetruss.dynamics.linearisation import linearise
from kinetruss.dynamics.prescribed import inverse
from kinetruss.dynamics.state_feedback import feedback
from kinetruss.dynamics.user_forces import UserForce
from kinetruss.errors import InputError
from kinetruss.kinematics.motions import follow
from kinetruss.kinematics.sampling import sample
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.coordinates import coordinates
from kinetruss.model import Model, Run, Tracking
from kinetruss.results import Column, variable
from kinetruss.results.wide_tables import drive_unit, force_units

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FINE = 400
"""Intervals over the run at which the forces along the reference are computed; a cubic spline goes through them."""


class Tracker:
    """Feedback of some drives about a reference; called with t, x, v it gives the nodal forces (n_nodes, dim), N.

    names : the drives. system : of the model whose nodes move. own : a force of the user beside it.
    """

    words = "drives are fed back"

    def __init__(self, model: Model, system: System, run: Run, function: Callable[..., Any] | None) -> None:
        record, self.system = run.feedback, system
        assert record is not None  # noqa: S101 - asked for by it
        self.own = UserForce(system, function)
        self.names = record.chosen(system.model.all_drives, run.tasks)
        self.coordinates = coordinates(system, self.names)
        self.index = np.array([system.drives.index(name) for name in self.names])
        self.turns = np.array([one.kind in ("angle", "sum") and self._turning(one) for one in self.coordinates])
        self._model, self._trajectory = model, model.trajectory_of(run)
        end = float(run.t_end or 0.0)
        sample(model, self._trajectory, [0.0, end])  # a table that ends earlier is refused before any work
        others = [name for name in system.model.all_drives if name in run.tasks]
        if record.feedforward and others:
            raise InputError(
                f"feedback takes the forces along the reference, in which all drives follow the trajectory, but {others[0]!r} "
                "has a task. Write feedforward: false, or leave the drive to the feedback."
            )
        case = run.load_cases[0] if run.load_cases else None
        self._reference = self._forces_along(end, case) if record.feedforward else None
        self._times, self._gains = self._all_gains(record, end, case)
        self.limit = self._limits(record)

    def _turning(self, one: Any) -> bool:
        """True for angles that come round."""
        return one.kind == "angle" or bool(self.system.measure_period[one.index] > 0)

    def _forces_along(self, end: float, case: str | None) -> Callable[[float], Array]:
        """F_ref by time, (drives,) N or N m."""
        from scipy.interpolate import CubicSpline

        motion = follow(self._model, self._trajectory, times=np.linspace(0.0, end, FINE + 1))
        forces = inverse(self._model, motion, case, static=False)
        names = [str(name) for name in forces.arrays["drive"].values] if "drive" in forces.arrays else list(self.system.drives)
        columns = [names.index(name) for name in self.names]
        found: Callable[[float], Array] = CubicSpline(
            forces.arrays["time"].values, forces.arrays["drive_force"].values[:, columns]
        )
        return found

    def _all_gains(self, record: Tracking, end: float, case: str | None) -> tuple[Array, Array]:
        """Instants (k,), s, and gains (k, drives, 2 drives) at them."""
        count = len(self.names)
        if record.error_cost is None:
            own = [np.diag(self._each(getattr(record, name), 0.0)) for name in ("stiffness", "damping")]
            return np.zeros(1), np.hstack(own)[None]
        times = np.linspace(0.0, end, record.instants) if record.instants > 1 else np.zeros(1)
        motion = follow(self._model, self._trajectory, times=times if len(times) > 1 else np.array([0.0]))
        costs = {name: self._each(getattr(record, name), 0.0) for name in ("error_cost", "rate_cost")}
        state_cost = dict(zip(self.names, costs["error_cost"], strict=True))
        state_cost |= {f"{name}'": value for name, value in zip(self.names, costs["rate_cost"], strict=True)}
        force_cost = dict(zip(self.names, self._each(record.force_cost, 1.0), strict=True))
        found = np.empty((len(times), count, 2 * count))
        for k, x in enumerate(motion.whole["position"].values):
            lin = linearise(self._model, x, inputs=self.names, dofs=self.names, load_case=case)
            gains = feedback(lin, inputs=self.names, state_cost=state_cost, input_cost=force_cost).gains
            states = [*self.names, *(f"{name}'" for name in self.names)]
            found[k] = gains.sel(input=list(self.names), state=states).values
        return times, found

    def _each(self, given: float | Mapping[str, float] | None, default: float) -> Array:
        """A number of each drive."""
        if given is None or isinstance(given, Mapping):
            return np.array([(given or {}).get(name, default) for name in self.names])
        return np.full(len(self.names), float(given))

    def _limits(self, record: Tracking) -> Array:
        """Largest forces (drives,), N or N m; infinite without limits."""
        found = self._each(record.limits, np.inf) if record.limits is not None else np.full(len(self.names), np.inf)
        if record.motor_limits:
            found = np.minimum(found, [steady_force(self._model, name) for name in self.names])
        return found

    def errors(self, t: float, x: Array, v: Array) -> Array:
        """q - q_ref and its rate (2 drives,) at t (s), x, v (n, dim)."""
        asked = sample(self._model, self._trajectory, [t])
        off = np.array([value_of(self.system, one, x) for one in self.coordinates]) - asked.value[0, self.index]
        turned = np.remainder(off + np.pi, 2 * np.pi) - np.pi
        rate = np.array([rate_of(self.system, one, x, v) for one in self.coordinates]) - asked.rate[0, self.index]
        return np.concatenate([np.where(self.turns, turned, off), rate])

    def forces(self, t: float, x: Array, v: Array) -> tuple[Array, Array]:
        """Forces (drives,), N or N m, that act and that the feedback asks for, at t (s), x, v (n, dim)."""
        z = self.errors(t, x, v)
        wanted = -(self._gains_at(t) @ z)
        if self._reference is not None:
            wanted = wanted + self._reference(t)
        return np.clip(wanted, -self.limit, self.limit), wanted

    def _gains_at(self, t: float) -> Array:
        if len(self._times) == 1:
            return np.asarray(self._gains[0])
        k = int(np.clip(np.searchsorted(self._times, t, side="right") - 1, 0, len(self._times) - 2))
        share = np.clip((t - self._times[k]) / (self._times[k + 1] - self._times[k]), 0.0, 1.0)
        return np.asarray((1 - share) * self._gains[k] + share * self._gains[k + 1])

    def __call__(self, t: float, x: Array, v: Array) -> Array:
        """Nodal forces (n, dim), N, at t (s), x, v (n, dim)."""
        out = np.zeros_like(x)
        for one, force in zip(self.coordinates, self.forces(t, x, v)[0], strict=True):
            push(self.system, one, x, float(force), out)
        if self.own.given:
            full = [np.pad(y, ((0, 0), (0, 3 - x.shape[1]))).reshape(-1) for y in (x, v)]
            out += self.own.at(t, *full).reshape(-1, 3)[:, : x.shape[1]]
            if isinstance(self.own.error, BaseException):
                raise self.own.error
        return out

    def along(self, t: Array, x: Array, v: Array) -> tuple[Array, Array, Array]:
        """Forces that act, that are asked for, and errors (times, drives); x, v (times, 3 n)."""
        dim, count = self.system.dim, len(self.names)
        acting, wanted, errors = (np.zeros((len(t), count)) for _ in range(3))
        for k, when in enumerate(t):
            places = [y[k].reshape(-1, 3)[:, :dim] for y in (x, v)]
            acting[k], wanted[k] = self.forces(float(when), *places)
            errors[k] = self.errors(float(when), *places)[:count]
        return acting, wanted, errors

    def histories(self, t: Array, x: Array, v: Array) -> dict[str, Column]:
        """Columns (time, drive) of a simulation: NaN for drives that are not fed back."""
        full = np.full((3, len(t), len(self.system.drives)), np.nan)
        full[:, :, self.index] = self.along(t, x, v)
        per, force = ("time", "drive"), force_units(self.system)[0]["drive"]
        return {
            "feedback_force": variable(per, full[0], force, "force of the feedback, within its limits"),
            "feedback_asked": variable(per, full[1], force, "force of the feedback without its limits"),
            "tracking_error": variable(per, full[2], drive_unit(self.system)[0], "drive coordinate less its reference"),
        }


def steady_force(model: Model, name: str) -> float:
    """The force, N, or torque, N m, against which the motor of a drive moves steadily at its peak torque; else infinite.

    The peak torque, or that of the peak current of motor or amplifier, less the friction of the motor, through gear and screw
    in the direction that raises the load. Speed and voltage do not limit it.
    """
    one = model.actuators.get(name)
    if one is None or getattr(one, "motor", None) is None or (hasattr(one, "screw") and one.screw is None):
        return np.inf
    train = train_of(model, name)
    current = [one.max_current for one in (train.motor, train.amplifier) if one is not None and one.max_current is not None]
    torques = [train.motor.torque_constant * value for value in current]
    torques += [train.motor.max_torque] if train.motor.max_torque is not None else []
    if not torques:
        return np.inf
    output = max(0.0, min(torques) - train.motor.friction_torque) * train.gear.ratio * train.gear.efficiency
    return output if train.screw is None else output / raising_torque(train.screw, 1.0)


def tracker_of(model: Model, system: System, run: Run, function: Callable[..., Any] | None) -> Tracker | None:
    """The feedback of a run, with a force of the user beside it; None without feedback.

    Raises
    ------
    InputError : gains of least cost of a structure whose drives are not its freedoms; a base that rotates.
    """
    if run.feedback is None:
        return None
    if model.base_rotation is not None:
        raise InputError("feedback does not know the forces in a base that rotates. Leave out base_rotation, or the feedback.")
    if compile(model).model.bearings:
        raise InputError("feedback of drives beside friction in bearings is not computed. Leave out one of them.")
    return Tracker(model, system, run, function)
