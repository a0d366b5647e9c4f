"""Models with hinges, axes and couplings whose motion is known by other means."""

import numpy as np
import scipy.integrate

import kinetruss as kt

Z = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])


def skew(e):
    """e x as a matrix."""
    return np.array([[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]], float)


def turn(e, angle):
    """Rotation about the unit vector e (Rodrigues)."""
    K = skew(e)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


class Arm:
    """Two links in space: the first turns about z, the second about an axis that the first carries; point masses.

    The same by minimal coordinates: places, velocities, accelerations and torques from products of rotations.
    """

    O, T = np.zeros(3), np.array([0.0, 0.0, 1.0])
    S1, S2, P = np.array([0.9, 0.1, 0.4]), np.array([0.8, 0.7, 0.6]), np.array([1.6, 0.5, 0.2])
    masses = np.array([0.7, 0.3, 1.1])
    g = np.array([0.0, 0.0, -9.81])

    def __init__(self):
        self.e = (self.S2 - self.S1) / np.linalg.norm(self.S2 - self.S1)
        self.E = skew(self.e)

    def model(self, **more):
        pairs = (("O", "S1"), ("O", "S2"), ("T", "S1"), ("T", "S2"), ("S1", "S2"), ("S1", "P"), ("S2", "P"))
        bars = {one + two: kt.Bar(ends=(one, two), mass=0.0) for one, two in pairs}
        m1, m2, m3 = self.masses
        return kt.Model(
            nodes={"O": self.O, "T": self.T, "F": (1.0, 0.0, 0.0), "S1": kt.Node(at=self.S1, mass=m1),
                   "S2": kt.Node(at=self.S2, mass=m2), "P": kt.Node(at=self.P, mass=m3)},
            fixed=["O", "T", "F"], bars=bars, gravity=tuple(self.g),
            drives={"base": kt.HingeDrive(axis=("O", "T"), start="F", end="S1"),
                    "elbow": kt.HingeDrive(axis=("S1", "S2"), start="O", end="P")},
            **more,
        )  # fmt: skip

    def state(self, q, qd, qdd):
        """Places, velocities, accelerations (3 masses, 3), and their derivatives by q (2, 3, 3); q from the start."""
        R1, R2 = turn([0, 0, 1], q[0]), turn(self.e, q[1])
        w = np.array([self.S1, self.S2, self.S1 + R2 @ (self.P - self.S1)])
        r = np.array([0 * self.S1, 0 * self.S1, R2 @ (self.P - self.S1)])
        wd = qd[1] * r @ self.E.T
        wdd = qdd[1] * r @ self.E.T + qd[1] ** 2 * r @ (self.E @ self.E).T
        x, v = w @ R1.T, (wd + qd[0] * w @ Z.T) @ R1.T
        a = (wdd + 2 * qd[0] * wd @ Z.T + w @ (qdd[0] * Z + qd[0] ** 2 * Z @ Z).T) @ R1.T
        return x, v, a, np.array([w @ Z.T @ R1.T, r @ self.E.T @ R1.T])

    def torque(self, q, qd, qdd):
        """Generalised torques (2,) that the motion takes, weight and all."""
        _, _, a, D = self.state(q, qd, qdd)
        return np.einsum("p,pc,kpc->k", self.masses, a - self.g, D)

    def acceleration(self, q, qd, torque):
        """q'' under given torques."""
        _, _, _, D = self.state(q, qd, np.zeros(2))
        M = np.einsum("p,ipc,jpc->ij", self.masses, D, D)
        return np.linalg.solve(M, torque - self.torque(q, qd, np.zeros(2)))

    def simulate(self, t, torque, qd=(0.0, 0.0)):
        """q (times, 2) under constant torques, from rest or from rates qd."""
        right = lambda _, y: np.concatenate([y[2:], self.acceleration(y[:2], y[2:], torque)])  # noqa: E731
        start = np.concatenate([np.zeros(2), qd])
        return scipy.integrate.solve_ivp(right, (0, t[-1]), start, "DOP853", t, rtol=1e-12, atol=1e-13).y[:2].T


class DoublePendulum:
    """Two massless links in the plane with point masses, driven by an angle to x and by the angle between them."""

    l1, l2, m1, m2, g = 1.0, 0.7, 2.0, 1.5, 9.81

    def model(self):
        return kt.Model(
            nodes={"A": (0, 0), "B": kt.Node(at=(self.l1, 0), mass=self.m1),
                   "C": kt.Node(at=(self.l1 + self.l2, 0), mass=self.m2)},
            fixed=["A"], gravity=(0, -self.g),
            bars={"a": kt.Bar(ends=("A", "B"), mass=0.0), "b": kt.Bar(ends=("B", "C"), mass=0.0)},
            drives={"shoulder": kt.AngleDrive("a"), "elbow": kt.HingeDrive(axis="B", start="A", end="C")},
        )  # fmt: skip

    def terms(self, q, qd):
        """Mass matrix and the rest of the torques in shoulder angle and relative angle (textbook: Craig 2005, section 6.7)."""
        l1, l2, m1, m2 = self.l1, self.l2, self.m1, self.m2
        c, s = np.cos(q[1]), np.sin(q[1])
        M = np.array([[m2 * l2**2 + 2 * l1 * l2 * m2 * c + l1**2 * (m1 + m2), l2**2 * m2 + l1 * l2 * m2 * c],
                      [l2**2 * m2 + l1 * l2 * m2 * c, l2**2 * m2]])  # fmt: skip
        V = m2 * l1 * l2 * s * np.array([-(qd[1] ** 2) - 2 * qd[0] * qd[1], qd[0] ** 2])
        lower = m2 * l2 * self.g * np.cos(q[0] + q[1])
        return M, V + np.array([lower + (m1 + m2) * l1 * self.g * np.cos(q[0]), lower])

    def simulate(self, t, torque):
        """Angles (times, 2) from rest, stretched out along x."""

        def right(_, y):
            M, h = self.terms(y[:2], y[2:])
            return np.concatenate([y[2:], np.linalg.solve(M, torque - h)])

        return scipy.integrate.solve_ivp(right, (0, t[-1]), np.zeros(4), "DOP853", t, rtol=1e-12, atol=1e-13).y[:2].T
