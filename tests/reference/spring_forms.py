"""Closed forms of springs about hinges, SI."""

from __future__ import annotations

import math

from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipk, ellipkinc

__all__ = ["springs", "tip_slope", "way_to_rest"]

K, INERTIA = 30.0, 2.0 * 1.5**2
"""N m/rad, kg m^2."""


def springs() -> dict[str, float]:
    """An arm on a spring: free, damped, rubbing, with play, under a motor; columns of links (Hencky)."""
    w, d = math.sqrt(K / INERTIA), 4.0 / (2 * INERTIA)
    wd = math.sqrt(w * w - d * d)
    found = {}
    for t in (0.5, 1.0, 2.5, 5.0):
        found[f"spring.swing.{t:g}s"] = math.cos(w * t)
        found[f"spring.damped.{t:g}s"] = math.exp(-d * t) * (math.cos(wd * t) + d / wd * math.sin(wd * t))
    # a quarter of a cycle about the edge of the play, then across it at w (1 - play)
    found["spring.play.time"] = math.pi / (2 * w) + 0.2 / (w * 0.8)
    # every half cycle loses 2 M/k
    found |= {f"spring.friction.turn_{k}": (1 - 0.1 * k) * (-1) ** k for k in range(1, 5)}
    for t in (0.25, 0.5):
        q, qd = 10 * t**3 - 15 * t**4 + 6 * t**5, 30 * t**2 - 60 * t**3 + 30 * t**4
        qdd = 60 * t - 180 * t**2 + 120 * t**3
        found[f"spring.torque.out.{t:g}s"] = INERTIA * qdd + K * q + 0.7 * qd + 0.4
        found[f"spring.torque.back.{t:g}s"] = -INERTIA * qdd + K * (1 - q) - 0.7 * qd - 0.4
    low = math.sqrt((K + 2.0 * 9.81 * 1.5) / INERTIA)
    found |= {"spring.small.frequency": low, "spring.small.damping": 1.2 / (2 * INERTIA * low)}
    for links in (1, 2, 4):
        for mode in range(1, max(links, 2)):
            share = 0.25 if links == 1 else math.sin(mode * math.pi / (2 * links)) ** 2
            found[f"spring.column.{links}.mode_{mode}"] = 4 * 12.0 / 0.5 * share
    return found | {"spring.post_buckled.lean": 1.0, "spring.post_buckled.moment": 100.0 * 0.98}


def way_to_rest() -> float:
    """Time from rest at 2.5 rad to 0 under spring and weight: int d theta/sqrt(2 (V(2.5) - V(theta))/I)."""

    def potential(theta: float) -> float:
        return 0.5 * K * theta**2 - 2.0 * 9.81 * 1.5 * math.cos(theta)

    def pace(s: float) -> float:  # theta = 2.5 - s^2: no root at the start
        return 2 * s / math.sqrt(2 * (potential(2.5) - potential(2.5 - s * s)) / INERTIA)

    return float(quad(pace, 0.0, math.sqrt(2.5), epsabs=1e-14, epsrel=1e-14)[0])


def tip_slope(load: float) -> float:
    """Slope at the tip of a clamped elastic line of length 1 and E I = 1 under a dead load across it.

    sqrt(P) = K(p) - F(asin(1/(p sqrt 2)), p), 2 p^2 = 1 + sin(slope) (Frisch-Fay, Flexible Bars, 1962, chapter 2).
    """

    def off(slope: float) -> float:
        p = math.sqrt((1 + math.sin(slope)) / 2)
        return float(ellipk(p * p) - ellipkinc(math.asin(1 / (p * math.sqrt(2))), p * p) - math.sqrt(load))

    return float(brentq(off, 1e-6, math.pi / 2 - 1e-9, xtol=1e-15))
