"""Overconstrained loops let go for seconds: closed forms of their angles, energy, and the equation of their one freedom."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import solve_ivp

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, Model
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["bennett_places", "cases", "hinge_angles", "one_freedom"]

Places = Callable[[float], "NDArray[np.float64]"]
ENERGY = Reference("identity", "energy is kept")
BENNETT_ANGLES = Reference(
    "closed-form", "Bennett (1903): sin((beta - alpha)/2) sin(t1/2) sin(t2/2) = sin((beta + alpha)/2) cos(t1/2) cos(t2/2)"
)
ONE_FREEDOM = Reference("independent", "m(q) q'' + m'(q) q'^2/2 + V'(q) = 0 of the one freedom, DOP853 of SciPy at 1e-12")
BRICARD_ENERGY = Reference(
    "identity", "energy is kept", "orthogonal loop of six links of 1 m, 1 kg, 10 s: problem A04 of the IFToMM library"
)
BRICARD_ANGLES = Reference("closed-form", "Bricard (1927), Chen, You & Tarnai (2005): cos t + cos u + cos t cos u = 0")
HINGE = 0.1
SAMPLES = 128
BENNETT: dict[str, dict[str, Any]] = {
    "default": {"twist": 0.7, "other_twist": 1.3, "angle": 1.0},
    "slender": {"twist": 0.3, "other_twist": 1.5, "angle": 2.0},
    "wide": {"twist": 0.5, "other_twist": 2.5, "angle": 0.3},
}
TIME = 3.0


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


def let_go(name: str, time: float) -> Any:
    """A simulation of one of `BENNETT`, or of the orthogonal loop of six."""
    model = mechanisms.bricard() if name == "bricard" else mechanisms.bennett(**BENNETT[name])
    return dynamics.simulate(model, time, samples=301, method=DOP853(rtol=1e-11, atol=1e-12))


def hinge_angles(model: Model, position: Any, count: int) -> NDArray[np.float64]:
    """Angles (samples, count) of the hinges of a loop `P1`, `A1`, `P2` ..., rad, from places of its nodes."""
    at = {name: position.sel(node=name).values for name in model.nodes}
    found = []
    for k in range(1, count + 1):
        before, after = (k - 2) % count + 1, k % count + 1
        axis = at[f"A{k}"] - at[f"P{k}"]
        axis = axis / np.linalg.norm(axis, axis=1, keepdims=True)
        came, goes = at[f"P{k}"] - at[f"P{before}"], at[f"P{after}"] - at[f"P{k}"]
        found.append(np.arctan2((axis * np.cross(came, goes)).sum(axis=1), (came * goes).sum(axis=1)))
    return np.stack(found, axis=1)


def history(name: str, time: float) -> dict[str, float]:
    """Change of the energy of the largest kinetic one, and what the closed form of the angles leaves."""
    run = let_go(name, time)
    whole = run.kinetic_energy.values + run.potential_energy.values
    found = {"energy": float(np.abs(whole - whole[0]).max() / run.kinetic_energy.values.max()), "reached": float(run.time[-1])}
    if name == "bricard":
        t = hinge_angles(mechanisms.bricard(), run.motion.position, 6)
        c = np.cos(t)
        left = [c[:, i] + c[:, i - 1] + c[:, i] * c[:, i - 1] for i in range(6)]
        return found | {"closure": float(np.abs(left).max())}
    twist, other = BENNETT[name]["twist"], BENNETT[name]["other_twist"]
    t = hinge_angles(mechanisms.bennett(**BENNETT[name]), run.motion.position, 4) / 2
    down, up = math.sin((other - twist) / 2), math.sin((other + twist) / 2)
    left = [down * np.sin(t[:, 0]) * np.sin(t[:, 1]) - up * np.cos(t[:, 0]) * np.cos(t[:, 1])]
    return found | {"closure": float(np.abs(left).max())}


def against_one_freedom(name: str) -> dict[str, float]:
    """Largest distance of P2, A2, P3, A3 after `TIME` from where the equation of the one freedom has them, m."""
    own = dict(BENNETT[name])
    angle = own.pop("angle")
    places = bennett_places(own["twist"], own["other_twist"])
    q, _ = one_freedom(places, angle, 0.0, TIME)
    end = let_go(name, TIME).motion.position.isel(time=-1)
    return {"off": float(np.abs(end.sel(node=["P2", "A2", "P3", "A3"]).values - places(float(q))).max())}


def cases() -> Iterator[Case]:
    """Energy 1e-8, angles 1e-8, places 1e-8 m."""
    for name in BENNETT:
        start = (ENERGY, 0.0, 1e-8, history, (name, 10.0))
        yield Case(f"loops.bennett.{name}.energy", *start, ("energy",), 1.0)
        yield Case(f"loops.bennett.{name}.closure", BENNETT_ANGLES, 0.0, 1e-8, history, (name, 10.0), ("closure",), 1.0)
        yield Case(f"loops.bennett.{name}.one_freedom", ONE_FREEDOM, 0.0, 1e-8, against_one_freedom, (name,), ("off",), 1.0)
    yield Case("loops.bricard.long.energy", BRICARD_ENERGY, 0.0, 1e-8, history, ("bricard", 10.0), ("energy",), 1.0)
    yield Case("loops.bricard.long.closure", BRICARD_ANGLES, 0.0, 1e-8, history, ("bricard", 10.0), ("closure",), 1.0)
