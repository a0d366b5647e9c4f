"""Linkages of one angle: the row of four-bars in closed form, the spatial slider-crank by Lagrange's equation."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk

__all__ = ["SlidingCrank", "amplitude", "row_of_four_bars"]


def row_of_four_bars(loops: int, times: np.ndarray, rate: float = 1.0, gravity: float = 9.81) -> tuple[np.ndarray, np.ndarray]:
    """Angle from upright and its rate for bars of 1 m: theta'' = k sin theta from upright, theta = 2 am(w t/2 | -4 k/w^2)."""
    k = gravity * ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)
    theta = 2 * amplitude(rate * times / 2, -4 * k / rate**2)
    return theta, np.sign(rate) * np.sqrt(rate**2 + 4 * k * np.sin(theta / 2) ** 2)


def amplitude(u: np.ndarray, m: float) -> np.ndarray:
    """Jacobi's am(u | m) for a negative parameter, unwrapped: am(u | m) = pi/2 - am(K - u') with u' = sqrt(1 - m) u."""
    # DLMF 22.17: the parameter mu = -m/(1 - m) lies in (0, 1); sin am(u|m) = sd(sqrt(1-m) u | mu)/sqrt(1-m)
    mu, scale = -m / (1 - m), math.sqrt(1 - m)
    sn, cn, dn, _ = ellipj(scale * np.asarray(u, float), mu)
    turned = np.arctan2(sn / (scale * dn), cn / dn)
    quarter = ellipk(mu) / scale  # am grows by pi/2 in it
    return turned + 2 * math.pi * np.round(np.asarray(u) / (4 * quarter) - turned / (2 * math.pi))


@dataclass(frozen=True)
class SlidingCrank:
    """A crank about an axis along x through (y, z), a rod, a slider on the x axis; uniform bars; gravity along -z.

    theta from +z towards -y: P = (y - a sin th, z + a cos th); s^2 = l^2 - |P|^2; the rod's ends move at right angles, so
    T = [(m_c + m_r) a^2 th'^2/3 + (m_r/3 + m_s) s'^2]/2, V = (m_c/2 + m_r/2) g z_P.
    """

    crank: float = 0.08
    rod: float = 0.3
    axis: tuple[float, float] = (0.1, 0.12)
    masses: tuple[float, float, float] = (0.12, 0.5, 2.0)
    gravity: float = 9.81

    def slide(self, theta: float) -> tuple[float, float, float]:
        """Place s of the slider and its two derivatives by the angle."""
        a, (y, z) = self.crank, self.axis
        # |P|^2 = y^2 + z^2 + a^2 + 2 a (z cos th - y sin th)
        square = self.rod**2 - (y * y + z * z + a * a + 2 * a * (z * math.cos(theta) - y * math.sin(theta)))
        s = math.sqrt(square)
        first = a * (z * math.sin(theta) + y * math.cos(theta)) / s
        second = (a * (z * math.cos(theta) - y * math.sin(theta)) - first**2) / s
        return s, first, second

    def acceleration(self, theta: float, rate: float) -> float:
        """Lagrange: (A + B s'^2) th'' + B s' s'' th'^2 = -dV/dth."""
        (mc, mr, ms), a = self.masses, self.crank
        _, first, second = self.slide(theta)
        A, B = (mc + mr) * a * a / 3, mr / 3 + ms
        pull = (mc + mr) / 2 * self.gravity * a * math.sin(theta)
        return (pull - B * first * second * rate**2) / (A + B * first**2)

    def energy(self, theta: float, rate: float) -> float:
        """Kinetic and potential, J."""
        (mc, mr, ms), a = self.masses, self.crank
        first = self.slide(theta)[1]
        kinetic = ((mc + mr) * a * a / 3 + (mr / 3 + ms) * first**2) * rate**2 / 2
        return kinetic + (mc + mr) / 2 * self.gravity * (self.axis[1] + a * math.cos(theta))

    def run(self, times: np.ndarray, theta: float = 0.0, rate: float = 6.0) -> tuple[np.ndarray, np.ndarray]:
        """Angle and rate at times, from times[0]."""
        found = solve_ivp(
            lambda _, y: [y[1], self.acceleration(*y)],
            (times[0], times[-1]),
            [theta, rate],
            "DOP853",
            times,
            rtol=1e-13,
            atol=1e-14,
        )
        return found.y[0], found.y[1]
