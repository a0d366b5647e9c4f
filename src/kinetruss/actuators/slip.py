"""Dry friction of several screws at once: which slip, which stick, and how the lengths accelerate."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.drive_model import DriveModel
from kinetruss.actuators.shafts import Shaft

if TYPE_CHECKING:
    from numpy.typing import NDArray


MOST = 10
"""Slipping motors up to which every pattern of raising and lowering is tried."""
ROUND_OFF = 1e-13


def slipping(
    models: Sequence[DriveModel],
    direction: Sequence[int],
    torque: Sequence[float],
    thrust: Sequence[float],
    mass: Sequence[Sequence[float]],
) -> tuple[list[float], tuple[int, ...]]:
    """Accelerations w (k,) of the coordinates, m/s^2 or rad/s^2, 0 where one sticks; and the screws or gears that jam.

    Parameters
    ----------
    direction : of every motion, 1, -1, or 0 where it sticks. torque (k,) : of the motors, N m. thrust (k,), mass (k, k) : the
        actuators push with F = thrust + mass w.

    Notes
    -----
    Along the motion s of each: s K_t i - T_f - R(s F) = J G/lead s w, R(A) = up A where a load is raised (A >= 0), -down A
    where it is lowered. For a pattern of raising and lowering that is a linear system; the pattern is right where the signs of
    A are those assumed. A self-locking screw (down > 0) jams where the structure that drives it is too heavy for its rotor
    (mass x down >= J G/lead): no acceleration satisfies both sides, it stops at once. w goes on as if it raised its
    load, so that the instant can be found.
    """
    moving, w = [j for j, s in enumerate(direction) if s], [0.0] * len(models)
    if not moving:
        return w, ()
    if len(moving) == 1:
        j = moving[0]
        w[j], jams = _alone(models[j].shaft, direction[j], torque[j], thrust[j], mass[j][j])
        return w, (j,) * jams
    shafts = [models[j].shaft for j in moving]
    s = np.array([direction[j] for j in moving], float)
    rotor = np.array([shaft.inertia * shaft.speed for shaft in shafts])
    given = s * np.array(torque)[moving] - np.array([shaft.friction for shaft in shafts])
    load, heavy = s * np.array(thrust)[moving], s[:, None] * np.array(mass)[np.ix_(moving, moving)] * s
    up, down = np.array([shaft.up for shaft in shafts]), np.array([-shaft.down for shaft in shafts])

    def tried(raised: NDArray[np.bool_]) -> tuple[NDArray[np.float64], NDArray[np.bool_], bool]:
        slope = np.where(raised, up, down)
        along = np.linalg.solve(np.diag(rotor) + slope[:, None] * heavy, given - slope * load)
        against = load + heavy @ along
        nothing = np.abs(against) <= ROUND_OFF * (np.abs(load) + np.abs(heavy) @ np.abs(along))
        signs = np.where(nothing, raised, against > 0)
        return along, signs, bool(np.all(raised | (rotor + np.diag(heavy) * down > 0)) and np.array_equal(signs, raised))

    found = _pattern(tried, load >= 0)
    if found is not None:
        return _among(len(models), moving, s * found), ()
    excess = np.diag(heavy) * -down - rotor
    worst = np.flatnonzero(excess >= 0) if (excess >= 0).any() else np.array([int(np.argmax(excess))])
    down[worst] = up[worst]
    found = _pattern(tried, load >= 0)
    return _among(len(models), moving, 0.0 * s if found is None else s * found), tuple(moving[k] for k in worst)


def _among(count: int, moving: list[int], found: NDArray[np.float64]) -> list[float]:
    """Accelerations of all from those that move."""
    w = np.zeros(count)
    w[moving] = found
    return [float(one) for one in w]


def _alone(shaft: Shaft, direction: int, torque: float, thrust: float, mass: float) -> tuple[float, bool]:
    """The same of one motor: its acceleration, and whether it jams."""
    if shaft.down > 0:
        rotor, load, given = shaft.inertia * shaft.speed, direction * thrust, direction * torque - shaft.friction
        if load * rotor + mass * given < 0 and rotor <= mass * shaft.down:
            return direction * (given - load * shaft.up) / (rotor + mass * shaft.up), True
    return shaft.acceleration(direction, torque, thrust, mass), False


def _pattern(tried: Any, raised: NDArray[np.bool_]) -> NDArray[np.float64] | None:
    """The solution of the pattern that agrees with itself: first by following the signs, then by trying all; or None."""
    for _ in range(2 * len(raised) + 2):
        found, raised, good = tried(raised)
        if good:
            return np.asarray(found)
    if len(raised) <= MOST:
        for one in product((True, False), repeat=len(raised)):
            found, _, good = tried(np.array(one))
            if good:
                return np.asarray(found)
    return None
