"""Motions along a path against the limits of the drives: their forces, all limits, and the quickest motion that keeps them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators, kinematics
from kinetruss.display.ranks import largest, largest_first
from kinetruss.dynamics.prescribed import inverse
from kinetruss.errors import InputError
from kinetruss.kinematics.drive_limits import LIMIT_ATTRS, Limits, Use, limit_values, motion_uses
from kinetruss.kinematics.redundant import LEAST
from kinetruss.model import Model
from kinetruss.results import Forces, Motion
from kinetruss.results.records import MOTORS_UNCHECKED, check_samples
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@one_thread
def inverse_along(
    model: Model,
    targets: Any,
    *,
    platform: Sequence[str] | None = None,
    load_case: str | None = None,
    static: bool = True,
    samples: int = 201,
    times: ArrayLike | None = None,
    least: float = LEAST,
) -> Forces:
    """Inverse kinematics and inverse dynamics of a robot along a path: motions and forces of its drives, and all other forces.

    Parameters
    ----------
    targets, platform, samples, times, least : the prescribed node coordinates or platform pose, as in `kinematics.inverse`.
    load_case, static : as in `inverse`.

    Returns
    -------
    Forces, as of `inverse`; ``motion`` has the required ``drive_position`` and its rates; ``drive_force`` are the
    required forces and torques, N or N m.

    Raises
    ------
    InputError : as for both. AnalysisError : the path cannot be followed; `result` is the Motion up to the last good state.

    Examples
    --------
    >>> import kinetruss as kt
    >>> lift = kt.library.mechanisms.stewart(platform_mass=12.0)
    >>> up = kt.Quintic(moves={"z": (0.0, 0.1)}, duration=1.0)
    >>> forces = kt.dynamics.inverse_along(lift, up, platform=("P1", "P2", "P3", "P4", "P5", "P6"), samples=3)
    >>> forces.drive_force.sel(drive="leg1").round(2).values.tolist()
    [21.78, 21.48, 21.23]
    """
    motion = kinematics.inverse(model, targets, platform=platform, samples=samples, times=times, least=least)
    return inverse(model, motion, load_case, static=static)


# All limits of the drives against a motion with its forces: strokes, rates, accelerations, forces, motors.


@dataclass(frozen=True, kw_only=True)
class LimitsKept:
    """How far a motion uses the limits of the drives. uses : largest use of each limit of each drive, worst first, with
    `limit`, `drive`, `time` (s), `value`, `most`, `ratio`.
    """

    uses: tuple[Use, ...]

    @property
    def kept(self) -> bool:
        """Whether all limits are kept."""
        return self.uses[0].kept

    @property
    def worst(self) -> Use:
        """The limit that is used most."""
        return self.uses[0]

    def __str__(self) -> str:
        over = [str(one) for one in self.uses if not one.kept]
        if not over:
            return f"All {len(self.uses)} limits are kept; most used: {self.worst}."
        return f"{len(over)} of {len(self.uses)} limits are not kept: {'; '.join(over[:6])}."


@one_thread
def limits_kept(
    model: Model,
    motion: Motion,
    forces: Forces | None = None,
    *,
    rate: Given = None,
    acceleration: Given = None,
    force: Given = None,
    load_case: str | None = None,
) -> LimitsKept:
    """Compare a motion with all limits of the drives.

    Parameters
    ----------
    motion : from `kinematics.inverse` or `kinematics.follow`.
    forces : along it, from `inverse`; by default those of `load_case`.
    rate, acceleration, force : largest magnitudes, of all drives or by name: m/s or rad/s, m/s^2 or rad/s^2, N or N m. Limits
        of strokes, motors and amplifiers are those of the model.

    Returns
    -------
    LimitsKept.

    Raises
    ------
    InputError : no limit at all; a limit that is not positive; unknown names.

    Examples
    --------
    >>> import kinetruss as kt
    >>> bay = kt.library.vgt.double_octahedral(gravity=(0, 0, -9.81))
    >>> up = kt.Coordinates(moves={"N8.z": 1.0, "N7.z": 1.0, "N9.z": 1.0}, duration=2.0)
    >>> found = kt.dynamics.limits_kept(bay, kt.kinematics.inverse(bay, up, samples=41), rate=0.2, force=1e4)
    >>> found.kept, found.worst.limit
    (True, 'rate')
    """
    check_samples(motion)
    names = [str(name) for name in motion.arrays["drive"].values]
    given = {"rate": rate, "acceleration": acceleration, "force": force}
    limits = Limits(**{what: limit_values(names, value, what) for what, value in given.items()}, others=())
    forces = inverse(model, motion, load_case, static=False) if forces is None else forces
    t = motion.arrays["time"].values
    moved = motion.arrays["drive_velocity"].values, motion.arrays["drive_acceleration"].values
    uses = motion_uses(limits, names, t, moved, forces.arrays["drive_force"].values, "force")
    if model.actuators:
        uses += _motor_uses(model, motion, forces)
    if not uses:
        raise InputError(
            "There is no limit to compare with. Give rate, acceleration or force, or strokes and motors with limits."
        )
    return LimitsKept(uses=tuple(largest_first(uses, lambda one: one.ratio)))


def _motor_uses(model: Model, motion: Motion, forces: Forces) -> list[Use]:
    """Use of the limits of strokes, motors and amplifiers."""
    data = actuators.evaluate(model, motion, forces).data
    value, limit, when = (data[name].values for name in ("value", "limit", "time_of"))
    return [
        Use(limit=str(what), drive=str(name), time=float(when[i, j]), value=float(value[i, j]), most=float(limit[i, j]))
        for i, name in enumerate(data["active"].values)
        for j, what in enumerate(data["quantity"].values)
        if np.isfinite(limit[i, j]) and np.isfinite(value[i, j])
    ]


# The quickest motion along a path that keeps all limits of the drives: its time is stretched or shortened evenly.

Given = Mapping[str, float] | float | None
"""A limit of all drives, or of some by name."""

EXACT = 1e-9
"""Share of a limit that counts as round-off: no result exceeds a limit by more."""
NOISE = 1e-13
"""Changes of a force with the pace below this part of the largest are round-off."""
ROUNDS, STEP, FASTEST, MOST = 8, 1.5, 1e3, 1e6
"""Rounds of the closed form; between two paces that are tried to enclose the largest; where only motors limit it, the first;
how many times quicker or slower than the motion given the paces that are tried are at most.
"""


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
class _Share:
    """Largest share of one limit, of which drive, at which sample."""

    share: float
    limit: str
    drive: str
    sample: int


@one_thread
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
    InputError : no limit at all; a limit that is not positive; a force limit that a steady load exceeds at rest; a motion in
        which no drive moves, or that ended early; limits that no even stretch of time keeps, or that none exceeds.

    Notes
    -----
    With time times k, rates are those of the motion over k and accelerations over k^2. Forces are S + A/k + B/k^2 with weight
    and springs in S, linear dampers in A, inertia in B: three evaluations give all three, and k follows in closed form. Other
    forces (friction, quadratic dampers, loads in time, motors) change with k otherwise: from the closed form, or with loads in
    time from the quickest of many, k is then found by Brent's method (1973). The forces at the samples of the motion that is
    returned are computed in every case, and none exceeds its limit by more than round-off. Between samples more can be needed:
    give enough of them.

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
    asked = bool(motors and model.actuators and _motor_limits(model, motion, load_case))
    if not asked and not any(np.isfinite(one).any() for one in limits.values()):
        raise InputError("There is no limit to keep. Give rate, acceleration or force, or motors with limits.")
    search = _Search(model, motion, names, limits, load_case, asked)
    if not motion.arrays["drive_velocity"].values.any():
        raise InputError("No drive moves, so there is nothing to make quicker. Give a motion that moves.")
    pace = min(search.pace_of_rates(), search.pace_of_forces())
    made, worst = search.kept(pace if np.isfinite(pace) else FASTEST)
    t, factor = motion.arrays["time"].values, 1.0 / search.pace
    if asked:
        made.attrs.pop(MOTORS_UNCHECKED, None)
    return Quickest(
        motion=made,
        duration=float(factor * (t[-1] - t[0])),
        factor=factor,
        limit=worst.limit,
        drive=worst.drive,
        time=float(made.arrays["time"].values[worst.sample]),
        use=worst.share,
    )


@dataclass
class _Search:
    """Looks for the largest pace, one over the factor of time, with which a motion keeps limits; `pace` is the last tried."""

    model: Model
    motion: Motion
    names: list[str]
    limits: Mapping[str, NDArray[np.float64]]
    load_case: str | None
    motors: bool
    pace: float = field(default=1.0, init=False)

    @property
    def loads_in_time(self) -> bool:
        """Whether loads of the model change in time."""
        return any(getattr(load, "times", None) for load in self.model.loads.values())

    def pace_of_rates(self) -> float:
        """The largest pace that keeps the limits of rates and accelerations."""
        data, paces = self.motion.arrays, [np.inf]
        for what, name, power in (("rate", "drive_velocity", 1.0), ("acceleration", "drive_acceleration", 0.5)):
            share = np.abs(data[name].values).max(axis=0, initial=0.0) / self.limits[what]
            paces += [float(one) ** -power for one in share if one > 0]
        return min(paces)

    def pace_of_forces(self) -> float:
        """The largest pace that keeps the limits of forces if these are S + A/k + B/k^2; infinite if they do not change.

        The three are taken from paces around the last result, at which they are as large as each other.
        """
        limit, pace, last = self.limits["force"], 1.0, np.inf
        if not np.isfinite(limit).any():
            return np.inf
        self._refuse_at_rest(limit)
        steps = np.array([0.5, 1.0, 2.0])
        for _ in range(ROUNDS):
            F = np.array([self._forces(pace * step) for step in steps])
            parts = np.linalg.solve(np.vander(steps, increasing=True), F.reshape(3, -1)).reshape(F.shape)
            parts[1:][np.abs(parts[1:]) < NOISE * np.abs(F).max(axis=(0, 1))] = 0.0
            found = _quickest_pace(parts, limit)
            if found == 0:  # friction and loads in time may look like that from here
                return pace
            pace *= found
            if pace > MOST:  # by round-off, or not at all
                return np.inf
            if abs(found - 1.0) <= 1e-15 or abs(found - 1.0) >= last:
                break
            last = abs(found - 1.0) if abs(found - 1.0) < 1e-6 else np.inf
        return pace

    def kept(self, pace: float) -> tuple[Motion, _Share]:
        """The motion at the largest pace near the given one that keeps all limits, and what governs there."""
        from scipy.optimize import brentq

        top = self.pace_of_rates()
        if self.loads_in_time:  # each pace meets other loads: the first that keeps the limits, from quick to slow
            tried = min(top, MOST) / STEP ** np.arange(2 * np.log(MOST) / np.log(STEP))
            pace = next((float(one) for one in tried if self._at(float(one))[1].share <= 1), pace)
        made, worst = self._at(pace)
        if abs(worst.share - 1.0) <= EXACT:
            return made, worst
        low = high = pace
        while True:  # downwards to a pace that keeps them, or upwards to one that does not
            step = STEP if worst.share < 1 else 1 / STEP
            other = min(low * step, top)
            if other == low:
                return self._at(top)
            if not 1 / MOST <= other <= MOST:
                raise InputError(
                    f"{worst.limit} of {worst.drive!r} is {worst.share:.4g} times its limit even in a motion {1 / low:.3g} "
                    "times as long. Raise the limit, or lower the load."
                    if worst.share > 1
                    else "No drive needs more of its limit in a quicker motion, so there is no quickest one. Give a limit of "
                    "rates."
                )
            low, high, last = other, low, worst
            made, worst = self._at(low)
            if abs(worst.share - 1.0) <= EXACT:
                return made, worst
            if (worst.share < 1) != (last.share < 1):
                break
        pace = float(np.exp(brentq(lambda p: self._at(float(np.exp(p)))[1].share - 1.0, *np.log([low, high]), xtol=1e-15)))
        made, worst = self._at(pace)
        for back in (1e-15, 1e-14, 1e-13, 1e-12, 1e-9):  # to the side that keeps them
            if worst.share <= 1.0 + EXACT:
                return made, worst
            made, worst = self._at(pace * (1.0 - back))
        # a force that jumps with the pace: from the side that keeps the limits
        made, worst = self._at(min(low, high))
        if worst.share > 1.0 + EXACT:
            raise InputError(f"{worst.limit} of {worst.drive!r} jumps over its limit with the pace. Give a limit of rates.")
        return made, worst

    def _refuse_at_rest(self, limit: NDArray[np.float64]) -> None:
        if self.loads_in_time:
            return
        forces = inverse(self.model, self.motion, self.load_case)
        if forces.static is None:
            raise InputError("The forces at rest are not known. Give a motion of this model.")
        rest = forces.static.arrays["drive_force"].values
        for d in np.flatnonzero((np.abs(rest) >= limit).any(axis=0)):
            k = int(np.argmax(np.abs(rest[:, d]) >= limit[d]))
            raise InputError(
                f"{self.names[d]!r} carries {rest[k, d]:.6g} at rest (t = {self.motion.arrays['time'].values[k]:g} s), its "
                f"limit is {limit[d]:.6g}: no time is long enough. Raise the limit, or lower the load."
            )

    def _forces(self, pace: float) -> NDArray[np.float64]:
        forces = inverse(self.model, _scaled(self.motion, 1.0 / pace), self.load_case, static=False)
        return np.asarray(forces.arrays["drive_force"].values)

    def _at(self, pace: float) -> tuple[Motion, _Share]:
        """The motion at a pace, and the largest share of a limit that it takes."""
        self.pace = pace
        made, found = _scaled(self.motion, 1.0 / pace), []
        needed = self.motors or np.isfinite(self.limits["force"]).any()
        forces = inverse(self.model, made, self.load_case, static=False) if needed else None
        sizes = {"rate": made.arrays["drive_velocity"].values, "acceleration": made.arrays["drive_acceleration"].values}
        if forces is not None:
            sizes["force"] = forces.arrays["drive_force"].values
        for what, y in sizes.items():
            share = np.abs(y) / self.limits[what]
            i, d = np.unravel_index(int(share.argmax()), share.shape)
            found.append(_Share(float(share[i, d]), what, self.names[int(d)], int(i)))
        if self.motors:
            found.append(_of_motors(self.model, made, forces))
        return made, largest(found, lambda one: one.share)


def _quickest_pace(parts: NDArray[np.float64], limit: NDArray[np.float64]) -> float:
    """The largest u with |S + A u + B u^2| <= limit (d,) at all samples, 0 if there is none; parts (3, samples, d) are S, A, B.

    Each sample excludes the ranges of u in which it is beyond its limit; the last of them has no end.
    """
    some = np.isfinite(limit)
    begins, ends = [], []
    for which in (1.0, -1.0):
        S, A, B = (which * one[:, some] for one in parts)
        beyond = S - limit[some]  # beyond + A u + B u^2 > 0 is excluded
        with np.errstate(all="ignore"):
            root = np.sqrt(A**2 - 4 * B * beyond)
            # both roots without a difference of equal numbers
            half = -0.5 * (A + np.where(A < 0, -root, root))
            one, two = np.sort(np.array([half / B, beyond / half]), axis=0)
        without_end = ((B == 0) & (A > 0)) | ((B > 0) & (two > 0))  # behind the larger root, or the only one
        between = (B < 0) & (two > 0)
        begins += [np.where(np.isfinite(two), two, one)[without_end], one[between]]
        ends += [np.full(int(without_end.sum()), np.inf), two[between]]
    begin, end = np.concatenate(begins), np.concatenate(ends)
    if not begin.size:
        return np.inf
    order = np.argsort(begin)
    begin, end = begin[order], end[order]
    reach = np.maximum.accumulate(end)
    # the range without end begins behind the last gap
    apart = np.flatnonzero(begin[1:] >= reach[:-1])
    first = int(apart[-1]) + 1 if len(apart) else 0
    if np.isfinite(reach[-1]):
        return np.inf
    return max(float(begin[first]), 0.0)


def _scaled(motion: Motion, k: float) -> Motion:
    """The motion with its time times k."""
    data = motion.whole.copy()
    for name in data.data_vars:
        text = str(name)
        power = 1 if text.endswith(("velocity", "_rate")) else 2 if text.endswith("acceleration") else 0
        if power:
            data[name] = data[name].copy(data=data[name].values / k**power)
        elif text == "between_time":
            data[name] = data[name].copy(data=data[name].values * k)
    data.attrs = {name: value for name, value in data.attrs.items() if name not in LIMIT_ATTRS}
    return motion.with_(data=data.assign_coords(time=data["time"].values * k))


def _motor_limits(model: Model, motion: Motion, load_case: str | None) -> bool:
    """Whether a motor or amplifier has a limit that depends on the pace."""
    data = actuators.evaluate(model, motion, inverse(model, motion, load_case, static=False)).data
    return bool(np.isfinite(data["limit"].values[:, data["quantity"].values != "stroke"]).any())


def _of_motors(model: Model, motion: Motion, forces: Any) -> _Share:
    """Largest share of a limit of a motor or amplifier."""
    data = actuators.evaluate(model, motion, forces).data
    share = (data["value"] / data["limit"]).where(data["quantity"] != "stroke").values
    if np.isnan(share).all():
        return _Share(0.0, "", "", 0)
    i, j = np.unravel_index(int(np.nanargmax(share)), share.shape)
    when, t = float(data["time_of"].values[i, j]), motion.arrays["time"].values
    at = 0 if np.isnan(when) else int(np.argmin(np.abs(t - when)))
    return _Share(float(share[i, j]), str(data["quantity"].values[j]), str(data["active"].values[i]), at)
