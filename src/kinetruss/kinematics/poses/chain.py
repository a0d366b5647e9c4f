"""Closed form of a chain of double-octahedral bays in equal poses, as a quadruple octahedron has two of."""

from __future__ import annotations

import math
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinetruss.arrays import array_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.motion.placement import equal_share, tilt
from kinetruss.kinematics.poses.gimbal import gimbal_lengths, gimbal_pose
from kinetruss.limits import MOST_ENTRIES, whole

__all__ = ["chain_lengths", "chain_pose"]

Floats = NDArray[np.float64]


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
