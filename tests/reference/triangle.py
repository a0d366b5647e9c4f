"""The triangular truss by direct trigonometry and its eleven equations (Lacy 1991, chapter 2, errata put right).

O2 = (0, 0) carries the active member, O1 = (ground, 0) the follower; they meet at B, above. phi is the angle at O1 from
O1->O2 to O1->B (clockwise), theta the angle at O2 from +x to O2->B.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

Three = tuple[float, float, float]

__all__ = ["Pose", "Triangle", "forces", "follower_section", "pose", "step_response", "tube_section"]


@dataclass(frozen=True)
class Triangle:
    """Sizes and masses, SI. Follower and tube are of one section; the base rod is thin."""

    follower: float = 2.0
    tube: float = 2.0
    shortest: float = 0.5
    ground: float = 2.0
    outer: float = 0.0254
    inner: float = 0.022225
    density: float = 2711.5
    rod_mass: float = 2.4
    rod_length: float = 2.1
    load: float = 10.0
    gravity: float = 9.81

    @property
    def line(self) -> float:
        """Mass of the tube a metre."""
        return self.density * math.pi / 4 * (self.outer**2 - self.inner**2)

    @property
    def gyration(self) -> float:
        """Square of the radius of gyration of the section."""
        return (self.outer**2 + self.inner**2) / 16


@dataclass(frozen=True)
class Pose:
    """Length of the active member and the two angles, each with two derivatives."""

    length: Three
    phi: Three
    theta: Three


def step_response(t: float, rise: float = 1.2, damping: float = 0.8, settling: float = 2.7) -> Three:
    """x, x', x'' of rise w^2 2w/((s^2 + 2 zeta w s + w^2)(s + 2w)) stepped, w = 6/(zeta settling), by partial fractions."""
    w = 6 / (damping * settling)
    pole = complex(-damping * w, w * math.sqrt(1 - damping**2))
    third = -2 * w
    gain = 2 * w**3
    residues = [(p, gain / (p * slope)) for p, slope in _slopes(pole, third)]
    parts = [sum(c * p**k * np.exp(p * t) for p, c in residues).real for k in range(3)]
    return rise * (1 + parts[0]), rise * parts[1], rise * parts[2]


def _slopes(pole: complex, third: float) -> list[tuple[complex, complex]]:
    """Each pole with the derivative of the denominator there."""
    poles = [pole, pole.conjugate(), complex(third)]
    return [(p, np.prod([p - q for q in poles if q is not p])) for p in poles]


def pose(truss: Triangle, x: float, rate: float, acceleration: float) -> Pose:
    """Angles from the law of cosines; derivatives from the loop O2 -> B -> O1 closed in rate and acceleration."""
    a, g = truss.follower, truss.ground
    length = truss.tube + truss.shortest + x
    phi = math.acos((a**2 + g**2 - length**2) / (2 * a * g))
    theta = math.acos((length**2 + g**2 - a**2) / (2 * length * g))
    # d/dt of length^2 = a^2 + g^2 - 2 a g cos(phi), once and twice
    phi_rate = length * rate / (a * g * math.sin(phi))
    phi_acceleration = ((rate**2 + length * acceleration) / (a * g) - math.cos(phi) * phi_rate**2) / math.sin(phi)
    # d/dt of length sin(theta) = a sin(phi), once and twice
    s, c = math.sin(theta), math.cos(theta)
    height_rate = a * math.cos(phi) * phi_rate
    height_acceleration = a * (math.cos(phi) * phi_acceleration - math.sin(phi) * phi_rate**2)
    theta_rate = (height_rate - rate * s) / (length * c)
    rest = acceleration * s + 2 * rate * c * theta_rate - length * s * theta_rate**2
    theta_acceleration = (height_acceleration - rest) / (length * c)
    return Pose((length, rate, acceleration), (phi, phi_rate, phi_acceleration), (theta, theta_rate, theta_acceleration))


def _frames(truss: Triangle, p: Pose) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Unit vectors along O1->B and O2->B and their increasing-angle normals."""
    phi, theta = p.phi[0], p.theta[0]
    along1, normal1 = np.array([-math.cos(phi), math.sin(phi)]), np.array([math.sin(phi), math.cos(phi)])
    along2, normal2 = np.array([math.cos(theta), math.sin(theta)]), np.array([-math.sin(theta), math.cos(theta)])
    return along1, normal1, along2, normal2


def _polar(along: np.ndarray, normal: np.ndarray, r: Three, angle: Three) -> np.ndarray:
    """Acceleration in polar coordinates."""
    radial = r[2] - r[0] * angle[1] ** 2
    around = r[0] * angle[2] + 2 * r[1] * angle[1]
    return radial * along + around * normal


def forces(truss: Triangle, p: Pose) -> dict[str, np.ndarray]:
    """Reactions R1, R2, the forces on follower and tube at B, and the force and ccw moment of the tube on the base.

    Eleven equations: two forces and a moment for follower, base rod and tube, two forces at B. The interface stands at
    the tube's free end.
    """
    a1, _, a2, _ = _frames(truss, p)
    free = p.length[0] - truss.tube
    # unknowns: R1 0:2, R2 2:4, F1 4:6 (on follower at B), Ft 6:8 (on tube at B), S 8:10 and M 10 (tube on base, M ccw)
    m = np.zeros((11, 11))
    m[0:2, 0:2] = m[0:2, 4:6] = np.eye(2)
    m[2, 0:2], m[2, 4:6] = _arm(-truss.follower / 2 * a1), _arm(truss.follower / 2 * a1)
    m[3:5, 2:4] = m[3:5, 8:10] = np.eye(2)
    m[5, 2:4], m[5, 8:10], m[5, 10] = _arm(-truss.rod_length / 2 * a2), _arm((free - truss.rod_length / 2) * a2), 1
    m[6:8, 6:8], m[6:8, 8:10] = np.eye(2), -np.eye(2)
    m[8, 6:8], m[8, 8:10], m[8, 10] = _arm(truss.tube / 2 * a2), -_arm(-truss.tube / 2 * a2), -1
    m[9:11, 4:6] = m[9:11, 6:8] = -np.eye(2)
    f = np.linalg.solve(m, _needed(truss, p))
    return {"R1": f[0:2], "R2": f[2:4], "F1": f[4:6], "Ft": f[6:8], "S": f[8:10], "M": f[10:11]}


def _needed(truss: Triangle, p: Pose) -> np.ndarray:
    """Right-hand side of the eleven equations: m (a - g) and I alpha (ccw) of follower, base rod, tube; load at B."""
    a1, n1, a2, n2 = _frames(truss, p)
    length, rate, acceleration = p.length
    down = np.array([0.0, -truss.gravity])
    follower = _polar(a1, n1, (truss.follower / 2, 0, 0), p.phi)
    rod = _polar(a2, n2, (truss.rod_length / 2, 0, 0), p.theta)
    tube = _polar(a2, n2, (length - truss.tube / 2, rate, acceleration), p.theta)
    inertia = truss.line * truss.follower * (truss.follower**2 / 12 + truss.gyration)
    tube_inertia = truss.line * truss.tube * (truss.tube**2 / 12 + truss.gyration)
    return np.concatenate(
        [
            truss.line * truss.follower * (follower - down),
            [-inertia * p.phi[2]],  # phi is clockwise
            truss.rod_mass * (rod - down),
            [truss.rod_mass * truss.rod_length**2 / 12 * p.theta[2]],
            truss.line * truss.tube * (tube - down),
            [tube_inertia * p.theta[2]],
            truss.load * (_polar(a2, n2, p.length, p.theta) - down),
        ]
    )


def _arm(arm: np.ndarray) -> np.ndarray:
    """Row that turns a force into its ccw moment about the foot of `arm`."""
    return np.array([-arm[1], arm[0]])


def follower_section(truss: Triangle, p: Pose, found: dict[str, np.ndarray], s: float) -> Three:
    """T, V, M at s m from O1. V and M act on the B side, along the increasing-phi normal and clockwise."""
    a1, n1, _, _ = _frames(truss, p)
    centre = _polar(a1, n1, ((truss.follower + s) / 2, 0, 0), p.phi)
    return _b_side(truss, a1, n1, truss.follower, p.phi, found["F1"], s, centre)


def tube_section(truss: Triangle, p: Pose, found: dict[str, np.ndarray], s: float) -> Three:
    """T, V, M in the tube at s m from O2. V and M act on the B side, along the increasing-theta normal and ccw."""
    _, _, a2, n2 = _frames(truss, p)
    length, rate, acceleration = p.length
    centre = _polar(a2, n2, ((length + s) / 2, rate, acceleration), p.theta)
    return _b_side(truss, a2, n2, length, p.theta, found["Ft"], s, centre)


def _b_side(
    truss: Triangle, along: np.ndarray, normal: np.ndarray, length: float, angle: Three,
    at_b: np.ndarray, s: float, centre: np.ndarray,
) -> Three:  # fmt: skip
    """Balance of the piece of tube from s to B: what the A side exerts on it."""
    piece = length - s
    mass = truss.line * piece
    cut = mass * (centre - np.array([0.0, -truss.gravity])) - at_b
    inertia = mass * (piece**2 / 12 + truss.gyration)
    moment = inertia * angle[2] - piece / 2 * (at_b @ normal) + piece / 2 * (cut @ normal)
    return float(-cut @ along), float(cut @ normal), float(moment)
