"""Instants between the samples of a motion, added if drives or members turn far from one sample to the next."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.structure.lengths import turn_rates
from kinetruss.kernels.structure.plan import LENGTH
from kinetruss.mechanics import kept
from kinetruss.model import Cyclic, Sine, Tabulated

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.path.sample import Sampled
    from kinetruss.mechanics import System

__all__ = ["REFINED", "between", "divided_into", "halved"]

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


@kept()
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
