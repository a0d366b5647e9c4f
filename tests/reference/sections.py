"""Section forces by cutting the member and balancing one side, mass element by mass element (Gauss points).

All forces and moments are exerted by the B-side part on the A-side part, in global axes.
"""

from __future__ import annotations

import numpy as np

from reference.newton_euler import Member, Rod, Solution, Truss, axis_motion

__all__ = ["bar_section", "base_section", "end_tensions", "interface", "mean_tension", "tube_section"]

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(6)


def _cross(u: np.ndarray, f: np.ndarray) -> np.ndarray:
    """u x f; in the plane a single component about z."""
    return np.cross(u, f) if len(u) == 3 else np.array([u[0] * f[1] - u[1] * f[0]])


def _part(
    rod: Rod, u: np.ndarray, u_acceleration: np.ndarray, origin: np.ndarray, gradient: np.ndarray,
    start: float, end: float, about: float,
) -> tuple[np.ndarray, np.ndarray]:  # fmt: skip
    """Force and moment about the point `about` (distance from A) that the piece [start, end] of a rod needs.

    The field a - g at distance s is origin + s gradient.
    """
    force, moment = np.zeros(len(u)), np.zeros(1 if len(u) == 2 else 3)
    half, middle = (end - start) / 2, (end + start) / 2
    for point, weight in zip(_POINTS, _WEIGHTS, strict=True):
        s = middle + half * point
        element = weight * half * rod.mass / rod.length * (origin + s * gradient)
        force += element
        moment += (s - about) * _cross(u, element)
    return force, moment + rod.rotary * (end - start) / rod.length * _cross(u, u_acceleration)


def bar_section(
    truss: Truss, k: int, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray], share: float
) -> tuple[np.ndarray, np.ndarray]:
    """Force and moment at `share` of the length of a bar from A, from the free body of its A side."""
    member = truss.members[k]
    length, _, u, _, u_acceleration = axis_motion(member, *motion)
    a = motion[2]
    origin, gradient = a[member.a] - truss.gravity, (a[member.b] - a[member.a]) / length
    s = share * length
    needed, turning = _part(member.rods[0], u, u_acceleration, origin, gradient, 0.0, s, s)
    fa = solution.force_a[k]
    return needed - fa, turning + s * _cross(u, fa)


def base_section(
    truss: Truss, k: int, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray], s: float
) -> tuple[np.ndarray, np.ndarray]:
    """Force and moment in the base rod at s m from A: below the tube's free end the A side, beyond it the overhang."""
    member = truss.members[k]
    length, _, u, _, u_acceleration = axis_motion(member, *motion)
    base, tube = member.rods
    origin = motion[2][member.a] - truss.gravity
    if s < length - tube.length:
        needed, turning = _part(base, u, u_acceleration, origin, u_acceleration, 0.0, s, s)
        fa = solution.force_a[k]
        return needed - fa, turning + s * _cross(u, fa)
    needed, turning = _part(base, u, u_acceleration, origin, u_acceleration, s, base.length, s)
    return -needed, -turning


def tube_section(
    truss: Truss, k: int, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray], s: float
) -> tuple[np.ndarray, np.ndarray]:
    """Force and moment in the tube at s m from A, from the free body of its B side (the pin at B gives no moment).

    The B side feels minus (force, moment) at the cut and the pin force at B, and needs (needed, turning).
    """
    member = truss.members[k]
    length, _, u, _, u_acceleration = axis_motion(member, *motion)
    origin = motion[2][member.b] - truss.gravity - length * u_acceleration
    needed, turning = _part(member.rods[1], u, u_acceleration, origin, u_acceleration, s, length, s)
    fb = solution.force_b[k]
    return fb - needed, (length - s) * _cross(u, fb) - turning


def interface(
    truss: Truss, k: int, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """What the tube exerts on the base, where the tube ends."""
    member = truss.members[k]
    length = axis_motion(member, *motion)[0]
    return tube_section(truss, k, solution, motion, length - member.rods[1].length)


def end_tensions(
    truss: Truss, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """Axial tension at A and at B of every member (m,), N."""
    u = np.array([axis_motion(member, *motion)[2] for member in truss.members])
    return -(solution.force_a * u).sum(1), (solution.force_b * u).sum(1)


def mean_tension(truss: Truss, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray]) -> np.ndarray:
    """Mean axial force of a bar over its length, axial interface force of an active member (m,), N."""
    return np.array([_mean(truss, k, solution, motion) for k in range(len(truss.members))])


def _mean(truss: Truss, k: int, solution: Solution, motion: tuple[np.ndarray, np.ndarray, np.ndarray]) -> float:
    member: Member = truss.members[k]
    u = axis_motion(member, *motion)[2]
    if len(member.rods) == 2:
        return float(interface(truss, k, solution, motion)[0] @ u)
    shares = (1 + _POINTS) / 2
    tensions = [bar_section(truss, k, solution, motion, share)[0] @ u for share in shares]
    return float(np.dot(_WEIGHTS / 2, tensions))
