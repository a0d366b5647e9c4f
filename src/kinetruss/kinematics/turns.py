"""States between the samples of a motion, so that whole turns do not depend on how many samples there are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kernels.structure.lengths import turn_rates
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import cached
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Cyclic, Sine, Tabulated
from kinetruss.results import Column, Motion, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.sampling import Sampled
    from kinetruss.mechanics import System


FAR = 0.8
"""Largest turn (rad) from one instant to the next; if something turns more, instants are added in between."""
A_PERIOD = 8
"""Instants per period of a periodic motion, so that a full swing between two instants is not missed."""
REFINED = 12
"""Number of refinements at most."""
MOST = 200_000
"""Number of instants at most."""


def between(trajectory: Any, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Instants t (s,), with added ones at which a periodic or tabulated trajectory could reverse between samples."""
    if len(t) < 2:
        return t
    if isinstance(trajectory, Sine | Cyclic):
        return _filled(t, np.ceil(np.diff(t) * A_PERIOD / trajectory.period))
    if isinstance(trajectory, Tabulated):
        knots = np.array(trajectory.times) - trajectory.times[0]
        return np.union1d(t, knots[(knots > t[0]) & (knots < t[-1])])
    return t


def divided_into(t: NDArray[np.float64], parts: int) -> NDArray[np.float64]:
    """Instants t (s,), with added ones so that there are at least so many parts, none longer than the duration over them."""
    if len(t) < 2:
        return t
    return _filled(t, np.ceil(np.diff(t) * parts / (t[-1] - t[0]) - 1e-9))


def halved(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64], t: NDArray[np.float64], sampled: Sampled | None = None
) -> NDArray[np.float64]:
    """Instants t (s,), with more added if a member or a drive turns far, judged by the good samples x, v (k, 3 n).

    Raises
    ------
    InputError : there would be too many instants.
    """
    if len(t) < 2:
        return t
    rate = np.zeros(len(t))
    p, q = system.p, system.q
    if system.continua is not None:
        p, q = np.concatenate([p, system.continua.p]), np.concatenate([q, system.continua.q])
    turn_rates(p, q, x, v, rate[: len(x)])
    h, angles = t[1:] - t[:-1], _turning(system)
    ahead = np.maximum(rate[1:], rate[:-1]) * h
    if sampled is not None and len(angles) and (known := len(sampled.times) - 1) > 0:
        value, fastest, bend = (
            _largest(y, angles) for y in (sampled.value[1:] - sampled.value[:-1], sampled.rate, sampled.acceleration)
        )
        for turn in (
            value,
            np.maximum(fastest[1:], fastest[:-1]) * h[:known],
            np.maximum(bend[1:], bend[:-1]) * h[:known] ** 2 / 8,
        ):
            np.maximum(ahead[:known], turn, out=ahead[:known])
    return t if ahead.max() <= FAR else _filled(t, np.ceil(ahead / FAR))


def _largest(y: NDArray[np.float64], columns: NDArray[np.int64]) -> NDArray[np.float64]:
    """Largest magnitude (times,) over some columns of y (times, k)."""
    size = np.abs(y[:, columns])
    return size[:, 0] if len(columns) == 1 else size.max(axis=1)


@cached()
def _turning(system: System) -> NDArray[np.int64]:
    """The drives of angles."""
    drives: NDArray[np.int64] = system.row_drive[(system.row_drive >= 0) & (system.row_kind != LENGTH)].astype(np.int64)
    return drives


def _filled(t: NDArray[np.float64], parts: NDArray[np.float64]) -> NDArray[np.float64]:
    """Instants t (s,) with interval i divided into ``parts[i]`` equal parts."""
    count = np.maximum(parts, 1.0)
    if not count.sum() <= MOST:
        k = int(np.argmax(count))
        raise InputError(
            f"Between the samples at t = {t[k]:g} s and {t[k + 1]:g} s something turns so fast that {count.sum():.3g} "
            f"instants would be needed in total, more than {MOST:,}. Follow a shorter or slower motion."
        )
    whole = count.astype(np.int64)
    if whole.max(initial=1) == 1:
        return t
    inner = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(t[:-1], t[1:], whole, strict=True)]
    return np.concatenate([*inner, t[-1:]])


# States between the samples of a motion, so that whole turns do not depend on how many samples there are.

HALF_TURN = np.pi
KEPT = ("position", "velocity", "acceleration")


@dataclass(frozen=True, eq=False)
class Passed:
    """Instants t (k,), s, between samples, with positions x and velocities v (k, 3 n), m, m/s.

    They are kept if something turns so far from one sample to the next that the samples alone do not determine whole turns.
    """

    t: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]

    @classmethod
    def none(cls, size: int) -> Passed:
        """Record without any state; size : 3 n."""
        return cls(np.zeros(0), np.zeros((0, size)), np.zeros((0, size)))

    @classmethod
    def of(cls, system: System, motion: Motion) -> Passed:
        """The states between samples that a motion holds."""
        arrays = motion.arrays
        if "between_time" not in arrays:
            return cls.none(system.x0.size)
        t = arrays["between_time"].values
        x, v = np.zeros((2, len(t), len(system.nodes), 3))
        x[:, :, : system.dim], v[:, :, : system.dim] = (arrays[f"between_{k}"].values for k in ("position", "velocity"))
        return cls(t, x.reshape(len(t), -1), v.reshape(len(t), -1))

    @classmethod
    def joined(cls, parts: Sequence[Passed]) -> Passed:
        """The states of several parts, one after the other."""
        return cls(*(np.concatenate([getattr(part, k) for part in parts]) for k in ("t", "x", "v")))

    def within(self, begin: float, end: float) -> Passed:
        """The states after `begin` and before `end`, s."""
        inside = (self.t > begin) & (self.t < end)
        return Passed(self.t[inside], self.x[inside], self.v[inside])

    def variables(self, system: System) -> dict[str, Column]:
        """As variables of a motion; empty if there are no such states."""
        if not len(self.t):
            return {}
        shape, nodal = (len(self.t), len(system.nodes), 3), ("between", "node", "axis")
        x, v = (y.reshape(shape)[:, :, : system.dim] for y in (self.x, self.v))
        return {
            "between_time": variable(("between",), self.t, "s", "instants between samples, from which whole turns are counted"),
            "between_position": variable(nodal, x, "m", "node position between samples"),
            "between_velocity": variable(nodal, v, "m/s", "node velocity between samples"),
        }


@dataclass(frozen=True, eq=False)
class Refined:
    """Samples of a motion and the states between them: t (k,) s; x, v, a (k, 3 n) (a is 0 between samples); the indices (s,)
    of the samples.
    """

    t: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    samples: NDArray[np.int64]


def refined(
    t: NDArray[np.float64],
    x: NDArray[np.float64],
    v: NDArray[np.float64],
    a: NDArray[np.float64],
    passed: Passed,
    begin: float | None = None,
) -> Refined:
    """Samples t (s,), x, v, a (s, 3 n) with the states passed since `begin` (s; by default since the first sample)."""
    if len(t):
        passed = passed.within(t[0] if begin is None else begin, t[-1])
    if not len(t) or not len(passed.t):
        return Refined(t, x, v, a, np.arange(len(t)))
    own = ~np.isin(passed.t, t)
    times = np.concatenate([t, passed.t[own]])
    order = np.argsort(times, kind="stable")
    place = np.empty(len(order), np.int64)
    place[order] = np.arange(len(order))
    more = (passed.x[own], passed.v[own], np.zeros_like(passed.x[own]))
    x, v, a = (np.concatenate(pair)[order] for pair in zip((x, v, a), more, strict=True))
    return Refined(times[order], x, v, a, place[: len(t)])


def with_passed(system: System, motion: Motion) -> tuple[Motion, NDArray[np.int64]]:
    """Positions, velocities and accelerations of a motion, with the states between its samples, and the indices of the samples.

    Use only the angles of states between samples: their accelerations are set to 0.
    """
    check_motion(system, motion)
    passed, t = Passed.of(system, motion), motion.arrays["time"].values
    if not len(passed.t):
        return motion, np.arange(len(t))
    x, v, a = (flat_positions(system, motion.arrays[name].values) for name in KEPT)
    whole = refined(t, x, v, a, passed)
    nodal, shape = ("time", "node", "axis"), (len(whole.t), len(system.nodes), 3)
    data = {
        name: variable(nodal, y.reshape(shape)[:, :, : system.dim], unit, f"node {name}")
        for name, unit, y in zip(KEPT, ("m", "m/s", "m/s^2"), (whole.x, whole.v, whole.a), strict=True)
    }
    # the motion was checked against the model above; states from a step's polynomial satisfy it up to the polynomial's error
    names = {name: motion.whole[name] for name in ("node", "axis", "member")}
    attrs = {**motion.whole.attrs, "trajectory_space": "given", "misfit": np.inf}
    time, drives = variable(("time",), whole.t, "s", "time"), ("drive", np.array([" "]))
    return motion.with_(data=xr.Dataset(data, coords={**names, "time": time, "drive": drives}, attrs=attrs)), whole.samples


def refuse_uncounted(t: NDArray[np.float64], rate: NDArray[np.float64], what: str) -> None:
    """Raise an error if something may turn by half a turn or more from one instant to the next: turns cannot be counted.

    t (k,) s; rate (k,) or (k, m) rad/s.

    Raises
    ------
    InputError : names the instant and the sample spacing that is small enough.
    """
    if len(t) < 2:
        return
    size = np.abs(rate).reshape(len(t), -1).max(axis=1)
    ahead = np.maximum(size[1:], size[:-1]) * np.diff(t)
    worst = int(np.argmax(ahead))
    if not ahead[worst] > HALF_TURN:
        return
    step = 0.5 * HALF_TURN / max(float(size.max()), 1e-300)
    raise InputError(
        f"{what}: between the samples at t = {t[worst]:.6g} s and {t[worst + 1]:.6g} s it may turn by {ahead[worst]:.3g} rad, "
        f"more than half a turn, so whole turns cannot be counted. Give samples at most {step:.2g} s apart."
    )
