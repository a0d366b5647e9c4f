"""Closed form of the double-octahedral bay: gimbal angles and height <-> the lengths of the three active members."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinetruss.arrays import array_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.motion.gimbal import gimbal_forward, gimbal_inverse
from kinetruss.kernels.motion.placement import reach
from kinetruss.mechanics.configuration import number_of

__all__ = ["gimbal_lengths", "gimbal_pose", "unreachable"]

Floats = NDArray[np.float64]


def gimbal_lengths(base: float, longeron: float, beta: ArrayLike, gamma: ArrayLike, height: ArrayLike) -> Floats:
    """Lengths of the active members M7, M9, M11 of a double-octahedral bay from its pose.

    Parameters
    ----------
    base : side of the base triangle, m.
    longeron : length of the cross longerons (M1..M6, M13..M18), m; more than half of `base`.
    beta, gamma : gimbal angles of the top, rad; its normal is (-sin gamma, -sin beta cos gamma, cos beta cos gamma).
    height : distance of the centroids of top and base, m. The three are broadcast to one shape.

    Returns
    -------
    (..., 3), m.

    Raises
    ------
    InputError : `longeron` not more than half of `base`.
    AnalysisError : a pose out of reach; the message names it and the nearest reachable one.

    Source: Lacy (1991), chapter 4; the midplane form is written out in `kernels.motion.gimbal`.

    Examples
    --------
    >>> import numpy as np
    >>> gimbal_lengths(1.2192, 0.889, np.radians(10), 0, 1.1218253458835146).round(6).tolist()
    [1.069583, 1.205617, 1.205617]
    """
    check_sides(base, longeron)
    wanted = np.stack(
        np.broadcast_arrays(*(array_of(q, name) for name, q in (("beta", beta), ("gamma", gamma), ("height", height)))),
        axis=-1,
    )
    pose = np.zeros((wanted.size // 3, 1, 3, 3))
    pose[:, 0, :, 0] = wanted.reshape(-1, 3)
    lengths, margin = np.empty_like(pose), np.empty(pose.shape[:2])
    gimbal_inverse(np.array([base], float), np.array([longeron], float), pose, lengths, margin)
    beyond = np.flatnonzero(~(margin[:, 0] > 0))
    if beyond.size:
        raise AnalysisError(unreachable(base, longeron, *map(float, pose[beyond[0], 0, :, 0])))
    return lengths[:, 0, :, 0].reshape(wanted.shape)


def gimbal_pose(base: float, longeron: float, lengths: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Gimbal angles and height of a double-octahedral bay from the lengths of M7, M9, M11: inverse of `gimbal_lengths`.

    Newton's method on the angles of N4, N5, N6 about the base edges, continued from three equal lengths, so that the bay stays
    on its upright branch.

    Parameters
    ----------
    base, longeron : m, as in `gimbal_lengths`.
    lengths : (..., 3), m.

    Returns
    -------
    beta, gamma (rad) and height (m), each (...).

    Raises
    ------
    InputError : `longeron` not more than half of `base`.
    AnalysisError : lengths that cannot be closed.

    Examples
    --------
    >>> beta, gamma, height = gimbal_pose(1.2192, 0.889, [1.1684, 1.1684, 1.1684])
    >>> print(f"{height:.9f}")
    1.121825346
    """
    check_sides(base, longeron)
    given = array_of(lengths, "lengths", {"...": None, "lengths of M7, M9, M11": 3}, unit="m")
    flat = np.ascontiguousarray(given.reshape(-1, 3))
    pose = np.empty_like(flat)
    gimbal_forward(float(base), float(longeron), flat, pose)
    open_ = np.flatnonzero(~np.isfinite(pose[:, 0]))
    if open_.size:
        seven, nine, eleven = flat[open_[0]]
        raise AnalysisError(
            f"lengths M7 = {seven:.6g} m, M9 = {nine:.6g} m, M11 = {eleven:.6g} m cannot be closed by a bay of base "
            f"{base:.6g} m and longerons {longeron:.6g} m. Give lengths nearer to each other or to its middle position."
        )
    beta, gamma, height = (pose[:, k].reshape(given.shape[:-1]) for k in range(3))
    return beta, gamma, height


def check_sides(base: float, longeron: float) -> None:
    """InputError unless the cross longerons span the base edge."""
    base, longeron = number_of(base, "base", "m"), number_of(longeron, "longeron", "m")
    if not (base > 0 and longeron > base / 2):
        raise InputError(
            f"cross longerons of {longeron:g} m cannot span a base edge of {base:g} m. Make them longer than {base / 2:g} m."
        )


def unreachable(base: float, longeron: float, beta: float, gamma: float, height: float) -> str:
    """Message on a pose out of reach, with the nearest reachable pose on the way to it from upright at the same height."""
    asked = f"the pose beta = {math.degrees(beta):.6g} deg, gamma = {math.degrees(gamma):.6g} deg, height = {height:.6g} m"
    tallest = 2.0 * math.sqrt(longeron**2 - base**2 / 4)
    if not 0 < height < tallest:
        return f"{asked} is out of reach: the height must lie above 0 and below {tallest:.6g} m, where the bay is stretched."
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = (low + high) / 2
        good = reach(base, longeron, middle * beta, middle * gamma, height) > 0
        low, high = (middle, high) if good else (low, middle)
    return (
        f"{asked} is out of reach: a pair of cross longerons is stretched flat before. On the way to it from upright the bay "
        f"reaches beta = {math.degrees(low * beta):.6g} deg, gamma = {math.degrees(low * gamma):.6g} deg."
    )
