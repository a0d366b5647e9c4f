"""Bennett's loop by the angle of its first hinge: places in closed form, and the equation of its one freedom."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import solve_ivp

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["bennett_places", "one_freedom"]

Places = Callable[[float], "NDArray[np.float64]"]
HINGE = 0.1
SAMPLES = 128


def bennett_places(twist: float, other_twist: float, length: float = 0.3) -> Places:
    """P2, A2, P3, A3 (4, 3) of `mechanisms.bennett` from the angle of its first hinge."""
    ratio = math.sin((other_twist + twist) / 2) / math.sin((other_twist - twist) / 2)
    other = length * math.sin(other_twist) / math.sin(twist)

    def at(angle: float) -> NDArray[np.float64]:
        second = 2 * math.atan2(ratio * math.cos(angle / 2), math.sin(angle / 2))
        R, place, found = np.eye(3), np.zeros(3), []
        for turn, a, alpha in ((angle, length, twist), (second, other, other_twist)):
            c, s, d, e = math.cos(turn), math.sin(turn), math.cos(alpha), math.sin(alpha)
            place = place + a * (R @ [c, s, 0.0])
            R = R @ np.array([[c, -s * d, s * e], [s, c * d, -c * e], [0.0, e, d]])
            found += [place, place + HINGE * R[:, 2]]
        return np.array(found)

    return at


def _series(samples: NDArray[np.float64]) -> tuple[Callable[[float], float], Callable[[float], float]]:
    """A periodic function and its derivative from samples over a turn; exact to round-off once its harmonics die out."""
    c = np.fft.rfft(samples) / len(samples)
    c[1:] *= 2
    k = np.flatnonzero(np.abs(c) > 1e-15 * np.abs(c).max())  # the others are round-off, which slopes would raise
    c = c[k]

    def wave(weight: NDArray[np.complex128]) -> Callable[[float], float]:
        return lambda q: float((weight * np.exp(1j * k * q)).real.sum())

    return wave(c), wave(1j * k * c)


def one_freedom(places: Places, start: float, rate: float, time: float, mass: float = 1.0, gravity: float = 9.81) -> Any:
    """Angle and rate of the first hinge from m(q) q'' + m'(q) q'^2/2 + V'(q) = 0, by SciPy's DOP853.

    The links P1-P2, P2-P3, P3-P4 are thin rods of this mass, whose energy is m (u.u + u.w + w.w)/6 with the velocities u, w of
    their ends; weights pull along -z.
    """
    turn = 2 * math.pi * np.arange(SAMPLES) / SAMPLES
    x = np.array([places(q) for q in turn])
    k = 1j * np.arange(SAMPLES // 2 + 1)[:, None, None]
    u = np.fft.irfft(k * np.fft.rfft(x, axis=0), SAMPLES, axis=0)
    two, three = u[:, 0], u[:, 2]
    inertia, slope = _series(mass / 3 * (2 * two**2 + two * three + 2 * three**2).sum(axis=1))
    _, push = _series(mass * gravity * (x[:, 0, 2] + x[:, 2, 2]))

    def rates(_: float, y: NDArray[np.float64]) -> list[float]:
        return [y[1], -(0.5 * slope(y[0]) * y[1] ** 2 + push(y[0])) / inertia(y[0])]

    return solve_ivp(rates, (0.0, time), [start, rate], method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
