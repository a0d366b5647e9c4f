"""The quickest motion along a path that keeps all limits of the drives: its time is stretched or shortened evenly."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators
from kinetruss.dynamics.prescribed.inverse import inverse
from kinetruss.errors import InputError
from kinetruss.kinematics.limited import LIMIT_ATTRS, limit_values
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Motion
from kinetruss.results.records import MOTORS_UNCHECKED, check_samples

__all__ = ["Given", "Quickest", "quickest"]

Given = Mapping[str, float] | float | None
"""A limit of all drives, or of some by name."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Quickest:
    """The quickest motion. duration : s. factor : of time, over that of the motion given. limit : what governs (``rate``,
    ``acceleration``, ``force``, or a quantity of the motor); drive, time : whose, and when (s, in the quickest motion); use :
    share of that limit, 1 to round-off.
    """

    motion: Motion
    duration: float
    factor: float
    limit: str
    drive: str
    time: float
    use: float

    def __str__(self) -> str:
        return f"{self.duration:.6g} s; {self.limit} of {self.drive} governs, {self.use:.1%} of its limit at {self.time:.4g} s."


@dataclass(frozen=True)
class _Bound:
    """Smallest factor of time that one limit allows, and where."""

    factor: float
    limit: str
    drive: str
    sample: int


def quickest(
    model: Model,
    motion: Motion,
    *,
    rate: Given = None,
    acceleration: Given = None,
    force: Given = None,
    motors: bool = True,
    load_case: str | None = None,
) -> Quickest:
    """Stretch or shorten a motion evenly in time until one limit of the drives is just reached.

    Parameters
    ----------
    motion : from `kinematics.inverse` or `kinematics.follow`, at rest or not.
    rate, acceleration, force : largest magnitudes, of all drives or by name: m/s or rad/s, m/s^2 or rad/s^2, N or N m.
    motors : keep the limits of motors and amplifiers that the model has, too (those that `actuators.evaluate` lists).
    load_case : as in `inverse`.

    Returns
    -------
    Quickest.

    Raises
    ------
    InputError : no limit at all; a limit that is not positive; a force limit that the load at rest exceeds by itself; a motion
        that ended early.

    Notes
    -----
    With time times k, rates are those of the motion over k and accelerations over k^2; forces are static + dynamic/k^2, where
    inertia is the only thing that depends on the rates (no dampers, friction of bearings, moving loads). So k follows in closed
    form from rates, accelerations and forces. Motor limits depend on k through friction and back-emf; there k is found by
    bisection (Brent, 1973).

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"actuator": 0.1}, duration=1.0), samples=11)
    >>> found = kt.dynamics.quickest(model, motion, rate=0.2)  # m/s
    >>> round(found.duration, 6), found.limit, found.drive
    (0.5, 'rate', 'actuator')
    """
    if not motion.status.ok:
        raise InputError(f"The motion ended early: {motion.message or motion.status.value} Give one that is whole.")
    check_samples(motion)
    names = [str(name) for name in motion.arrays["drive"].values]
    limits = {what: limit_values(names, given, what) for what, given in
              (("rate", rate), ("acceleration", acceleration), ("force", force))}  # fmt: skip
    found = [
        *_bounds(names, "rate", motion.arrays["drive_velocity"].values, limits["rate"], 1.0),
        *_bounds(names, "acceleration", motion.arrays["drive_acceleration"].values, limits["acceleration"], 0.5),
    ]
    if np.isfinite(limits["force"]).any():
        found += _force_bounds(model, motion, names, limits["force"], load_case)
    asked = _motor_limits(model, motion, load_case) if motors and model.actuators else []
    if not found and not asked:
        raise InputError("There is no limit to keep. Give rate, acceleration or force, or motors with limits.")
    moves = [one for one in found if one.factor > 0]
    best = max(moves, key=lambda one: one.factor) if moves else None
    if asked:
        best = _with_motors(model, motion, load_case, best)
    if best is None:
        raise InputError("No drive moves, so there is nothing to make quicker. Give a motion that moves.")
    t = motion.arrays["time"].values
    made = _scaled(motion, best.factor)
    if asked:
        made.attrs.pop(MOTORS_UNCHECKED, None)
    use = _use(model, made, best, limits, load_case)
    return Quickest(
        motion=made,
        duration=float(best.factor * (t[-1] - t[0])),
        factor=best.factor,
        limit=best.limit,
        drive=best.drive,
        time=float(made.arrays["time"].values[best.sample]),
        use=use,
    )


def _bounds(names: list[str], what: str, y: NDArray[np.float64], limit: NDArray[np.float64], power: float) -> list[_Bound]:
    """k = (|y|/limit)^power of each drive that has a limit."""
    found = []
    for d in np.flatnonzero(np.isfinite(limit)):
        at = int(np.argmax(np.abs(y[:, d])))
        found.append(_Bound(float((abs(y[at, d]) / limit[d]) ** power), what, names[d], at))
    return found


def _force_bounds(model: Model, motion: Motion, names: list[str], limit: Any, load_case: str | None) -> list[_Bound]:
    """Largest 1/k^2 with |static + dynamic/k^2| <= limit at all samples."""
    forces = inverse(model, motion, load_case)
    if forces.static is None:
        raise InputError("The forces at rest are not known. Give a motion of this model.")
    rest = forces.static.arrays["drive_force"].values
    moving, found = forces.arrays["drive_force"].values - rest, []
    for d in np.flatnonzero(np.isfinite(limit)):
        if (over := np.abs(rest[:, d]) >= limit[d]).any():
            k = int(np.argmax(over))
            raise InputError(
                f"{names[d]!r} carries {rest[k, d]:.6g} at rest (t = {motion.arrays['time'].values[k]:g} s), its limit is "
                f"{limit[d]:.6g}: no time is long enough. Raise the limit, or lower the load."
            )
        room = limit[d] - np.sign(moving[:, d]) * rest[:, d]
        with np.errstate(divide="ignore"):
            most = np.where(moving[:, d] != 0, room / np.abs(moving[:, d]), np.inf)
        k = int(np.argmin(most))
        found.append(_Bound(0.0 if np.isinf(most[k]) else float(most[k] ** -0.5), "force", names[d], k))
    return found


def _scaled(motion: Motion, k: float) -> Motion:
    """The motion with its time times k."""
    data = motion.data.copy()
    for name in data.data_vars:
        text = str(name)
        power = 1 if text.endswith(("velocity", "_rate")) else 2 if text.endswith("acceleration") else 0
        if power:
            data[name] = data[name].copy(data=data[name].values / k**power)
        elif text == "between_time":
            data[name] = data[name].copy(data=data[name].values * k)
    data.attrs = {name: value for name, value in data.attrs.items() if name not in LIMIT_ATTRS}
    return motion.with_(data=data.assign_coords(time=data["time"].values * k))


def _peaks(model: Model, motion: Motion, load_case: str | None) -> Any:
    return actuators.evaluate(model, motion, inverse(model, motion, load_case, static=False))


def _motor_limits(model: Model, motion: Motion, load_case: str | None) -> list[tuple[str, str]]:
    """Drives and quantities that have a limit of a motor."""
    data = _peaks(model, motion, load_case).data
    limit = data["limit"].sel(quantity=[q for q in data["quantity"].values if q not in ("stroke",)])
    return [(str(a), str(q)) for a in limit["active"].values for q in limit["quantity"].values
            if np.isfinite(limit.sel(active=a, quantity=q))]  # fmt: skip


def _worst(model: Model, motion: Motion, load_case: str | None) -> tuple[float, str, str, float]:
    """Largest share of a motor limit, its quantity, drive and time."""
    data = _peaks(model, motion, load_case).data
    share = (data["value"] / data["limit"]).where(data["quantity"] != "stroke").values
    if np.isnan(share).all():
        return 0.0, "", "", 0.0
    i, j = np.unravel_index(int(np.nanargmax(share)), share.shape)
    return (
        float(share[i, j]),
        str(data["quantity"].values[j]),
        str(data["active"].values[i]),
        float(data["time_of"].values[i, j]),
    )


def _with_motors(model: Model, motion: Motion, load_case: str | None, best: _Bound | None) -> _Bound | None:
    """The factor that also keeps the limits of motors."""
    from scipy.optimize import brentq

    low = best.factor if best is not None else 1e-3

    def over(log_k: float) -> float:
        return _worst(model, _scaled(motion, float(np.exp(log_k))), load_case)[0] - 1.0

    if over(np.log(low)) <= 0:
        return best
    high = np.log(low) + 1.0
    while over(high) > 0:
        high += 1.0
        if high > np.log(low) + 20:
            raise InputError(
                "A motor limit is exceeded even at rest: no time is long enough. Take a larger motor, or less load."
            )
    log_k = brentq(over, np.log(low), high, xtol=1e-13, rtol=1e-14)
    k = float(np.exp(log_k))
    _, quantity, drive, when = _worst(model, _scaled(motion, k), load_case)
    t = motion.arrays["time"].values * k
    at = 0 if np.isnan(when) else int(np.argmin(np.abs(t - when)))
    return _Bound(k, quantity, drive, at)


def _use(model: Model, made: Motion, best: _Bound, limits: Mapping[str, Any], load_case: str | None) -> float:
    """Share of the governing limit in the quickest motion."""
    if best.limit not in limits:
        return _worst(model, made, load_case)[0]
    d = [str(name) for name in made.arrays["drive"].values].index(best.drive)
    if best.limit == "force":
        y = inverse(model, made, load_case, static=False).arrays["drive_force"].values
    else:
        y = made.arrays["drive_velocity" if best.limit == "rate" else "drive_acceleration"].values
    return float(np.abs(y[:, d]).max() / limits[best.limit][d])
