"""Closed forms of the double-octahedral bay and of chains of bays: gimbal angles and height, lengths of the drives."""

from __future__ import annotations

import math
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinetruss.arrays import array_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.motion.gimbal import gimbal_forward, gimbal_inverse
from kinetruss.kernels.motion.placement import equal_share, reach, tilt
from kinetruss.kinematics.positions import own_start
from kinetruss.limits import MOST_ENTRIES, whole
from kinetruss.mechanics import System, cached
from kinetruss.mechanics.arguments import number_of
from kinetruss.mechanics.bays import FIT, POSE, bay_of, pose_fault, pose_members, pose_values

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


# Closed form of a chain of double-octahedral bays in equal poses, as a quadruple octahedron has two of.


def chain_lengths(base: float, longeron: float, beta: ArrayLike, gamma: ArrayLike, height: ArrayLike, bays: int = 2) -> Floats:
    """Lengths of the active members of equal bays on each other from the pose of the top, all bays in the same pose.

    Each bay tilts by the same fraction of the whole tilt about one axis, exactly; with two bays it is the quadruple octahedron
    with equal gimbal halves. Equal fractions of beta and gamma themselves do not give the pose.

    Parameters
    ----------
    base, longeron : of every bay, m, as in `gimbal_lengths`.
    beta, gamma : gimbal angles of the top of the chain, rad. height : distance of its centroid from that of the base, m. The
        three are broadcast to one shape.
    bays : number of bays.

    Returns
    -------
    (..., 3 bays), m: M7, M9, M11 of the first bay, then of the next.

    Raises
    ------
    InputError : as `gimbal_lengths`; no whole number of bays.
    AnalysisError : a pose out of reach of the bays.

    Source: turns without twist about one axis add up (`kernels.motion.placement.equal_share`); a bay as Lacy (1991), chapter 4.

    Examples
    --------
    >>> import numpy as np
    >>> chain_lengths(1.2192, 0.889, np.radians(20), 0, 2.2).round(6).tolist()
    [1.099526, 1.230366, 1.230366, 1.099526, 1.230366, 1.230366]
    """
    bays = whole(bays, "bays", most=MOST_ENTRIES)
    given = ((beta, "beta", "rad"), (gamma, "gamma", "rad"), (height, "height", "m"))
    asked = np.broadcast_arrays(*(array_of(value, name, unit=unit) for value, name, unit in given))
    one, other, rise = equal_share(asked[0], asked[1], asked[2], bays)
    try:
        return np.tile(gimbal_lengths(base, longeron, one, other, rise), bays)
    except AnalysisError as error:
        raise AnalysisError(f"Each of the {bays} bays: {error}" if bays > 1 else str(error)) from None


def chain_pose(base: float, longeron: float, lengths: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Gimbal angles and height of the top of bays on each other from the lengths of all active members, equal or not.

    Parameters
    ----------
    base, longeron : of every bay, m. lengths : (..., 3 bays), m, in the order of `chain_lengths`.

    Returns
    -------
    beta, gamma (rad) and height (m: distance of the centroids of top and base), each (...).

    Raises
    ------
    InputError : a number of lengths that is no multiple of three. AnalysisError : lengths that cannot be closed.

    Examples
    --------
    >>> import numpy as np
    >>> pose = chain_pose(1.2192, 0.889, chain_lengths(1.2192, 0.889, 0.3, -0.2, 2.2))
    >>> [round(float(value), 12) for value in pose]
    [0.3, -0.2, 2.2]
    """
    given = array_of(lengths, "lengths", unit="m")
    if given.ndim == 0 or given.shape[-1] == 0 or given.shape[-1] % 3:
        raise InputError(f"lengths: shape {given.shape}, expected (..., 3 bays), m: M7, M9, M11 of every bay.")
    flat = given.reshape(-1, given.shape[-1] // 3, 3)
    poses = np.stack(gimbal_pose(base, longeron, flat), axis=-1)
    found = np.array([_top(bays) for bays in poses]).reshape(*given.shape[:-1], 3)
    return cast("tuple[Floats, Floats, Floats]", tuple(found[..., k] for k in range(3)))


def _top(bays: Floats) -> tuple[float, float, float]:
    """Pose of the top from those of the bays, (bays, 3): frames one after the other, from the base up."""
    origin, frame = np.zeros(3), np.eye(3)
    for beta, gamma, height in bays:
        u, turn = tilt(beta, gamma)
        origin, frame = origin + frame @ (height * u), frame @ turn
    x, y, z = frame[:, 2]
    return math.atan2(-y, z), math.asin(min(1.0, max(-1.0, -x))), math.sqrt(float(origin @ origin))


# Check that the closed form of a pose is that of the bay in the model.


@cached(256)
def check_pose(system: System, pose: str) -> None:
    """Refuse a pose whose closed form is not that of the model's own bay.

    Raises
    ------
    ModelError : another base side or longeron than the bay has (so also a tapered bay), drives of no bay or in another order, a
        bay that stands on another assembly branch than upright.
    """
    record = system.model.poses[pose]
    check_sides(record.base, record.longeron)
    bay, x = bay_of(system, pose), own_start(system)
    pairs = [("base", a, b) for side in (bay.base, bay.top) for a, b in zip(side, (*side[1:], side[0]), strict=True)]
    corners = ((0, 2), (1, 2), (0, 1))  # of the middle nodes 4, 5, 6
    pairs += [
        ("longeron", m, side[k])
        for m, two in zip(bay.middle, corners, strict=True)
        for k in two
        for side in (bay.base, bay.top)
    ]
    found = [float(np.linalg.norm(x[b] - x[a])) for _, a, b in pairs]
    off = [abs(value - getattr(record, side)) for value, (side, _, _) in zip(found, pairs, strict=True)]
    worst = int(np.argmax(off))
    if off[worst] > FIT * record.longeron:
        side, a, b = pairs[worst]
        raise pose_fault(
            pose,
            f"{system.nodes[a]} and {system.nodes[b]} are {found[worst]:.9g} m apart in the model; the pose says "
            f"{getattr(record, side):.9g} m, so its angles would be those of another bay.",
            f"Give the {side} of the model's own bay; where its sides differ, no pose fits: move its lengths.",
            side,
        )
    members = pose_members(system, pose)
    lengths = np.linalg.norm(x[system.q[members]] - x[system.p[members]], axis=1)
    closed = np.array([float(value) for value in gimbal_pose(record.base, record.longeron, lengths)])
    measured = pose_values(system, pose, x.reshape(1, -1))[0]
    if np.abs(measured - closed).max() > 10 * FIT * max(1.0, record.longeron):
        given, wanted = (", ".join(f"{k} {v:.6g}" for k, v in zip(POSE, q, strict=True)) for q in (measured, closed))
        raise pose_fault(
            pose, f"the bay stands at {given}; with these lengths the pose means {wanted}.", "Draw the bay upright."
        )
