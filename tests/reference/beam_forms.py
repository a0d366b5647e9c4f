"""Beams and conditions: closed forms of `kinetruss verify`, groups members and structures."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.linalg import eigvalsh
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

__all__ = ["beams", "conditions"]


def elastica(load: float) -> tuple[float, float]:
    """Deflection and shortening over L of a cantilever under P L^2/(E I) = load: elliptic integrals, slope a at the tip.

    With m = p^2 = (1 + sin a)/2 and sin(b) = 1/(p sqrt 2): sqrt(load) = K(m) - F(b, m), which gives a. The tip has moved by
    1 - 2 (E(m) - E(b, m))/sqrt(load) across the beam, and reaches to sqrt(2 sin(a)/load) along it.
    """

    def left(m: float) -> float:
        return float(ellipk(m) - ellipkinc(math.asin(1 / math.sqrt(2 * m)), m)) - math.sqrt(load)

    m = brentq(left, 0.5 + 1e-12, 1 - 1e-12, xtol=1e-15)
    part = float(ellipe(m) - ellipeinc(math.asin(1 / math.sqrt(2 * m)), m))
    return 1 - 2 * part / math.sqrt(load), 1 - math.sqrt(2 * (2 * m - 1) / load)


def beams() -> dict[str, float]:
    """Expected values by the names of the cases; loads and moments are over those of Euler and Bernoulli."""
    found = {f"beams.cantilever.{dim}d.{name}": 1.0 for dim in (2, 3) for name in ("clamp", "deflection")}
    found |= {f"beams.cantilever.{dim}d.middle": 0.5 for dim in (2, 3)}  # P (L - L/2)
    # w L^2/2 at the clamp, w L^2/8 in the middle, over themselves
    found |= {f"beams.cantilever.{dim}d.weight.{name}": 1.0 for dim in (2, 3) for name in ("clamp", "middle")}
    found |= {"beams.cantilever.twist": 1.0, "beams.buckling.factor": 1.0, "beams.circle.turn": 1.0}
    for load in (5, 10):
        down, short = elastica(load)
        found |= {f"beams.elastica.{load}.deflection": down, f"beams.elastica.{load}.shortening": short}
    free = brentq(lambda b: math.cos(b) * math.cosh(b) + 1, 1.5, 2.5, xtol=1e-15)
    both = brentq(lambda b: math.cos(b) * math.cosh(b) - 1, 4.0, 5.5, xtol=1e-15)
    found |= {"beams.frequencies.clamped_free": free**2}
    found |= {"beams.frequencies.clamped_clamped": both**2, "beams.frequencies.free_free": both**2}
    k = 3.0 / 4.0  # I h/(I L)
    found |= {"beams.portal.foot": (3 * k + 1) / (2 * (6 * k + 1)), "beams.portal.head": 3 * k / (2 * (6 * k + 1))}
    found |= {f"beams.damped.{dim}d.{name}": 1.0 for dim in (2, 3) for name in ("ratio", "energy")}
    # P L^3/(E I) of a force in the middle: clamped at both ends, and with one of them on a hinge
    found |= {"beams.hinged.along_2": 1 / 192, "beams.hinged.along_3": 7 / 768, "beams.driven.frequency": 1.0}
    found |= {f"beams.sheared.{dim}d.{name}": 1.0 for dim in (2, 3) for name in ("end", "along")}
    found |= {"beams.thick.column.load": 1.0, "beams.spinning.stretch": 1.0}
    return found | loads_along()


def loads_along() -> dict[str, float]:
    """Beams under q x/L, by a force method of two redundants at the end of q; a bar under q on its last quarter.

    With the end at x = 1 free, a unit load at s deflects it by s^2 (3 - s)/6 and turns it by s^2/2; a force F there by F/3 and
    F/2, a moment C by C/2 and C.
    """
    down, turn, moment = polynomial(lambda s: s**3 * (3 - s) / 6), polynomial(lambda s: s**3 / 2), polynomial(lambda s: s * s)
    F, C = np.linalg.solve([[1 / 3, 1 / 2], [1 / 2, 1.0]], [down, turn])
    found = {"deflection": down, "clamp": moment, "clamp.0": moment - F - C, "clamp.q": -C}
    left = 0.25 * 0.125
    found = {f"beams.triangle.{name}": float(value) for name, value in found.items()}
    found |= {"bars.part.left": left, "bars.part.right": 0.25 - left, "bars.part.moment": 0.75 * left}
    once = ("linear.speed", "linear.lasts", "linear.meets", "damped.n_1.speed", "damped.n_1_5.speed")
    return found | {f"stops.{name}": 1.0 for name in once}


def polynomial(f: Callable[[Any], Any]) -> float:
    """Integral of a polynomial of degree up to 7 from 0 to 1."""
    at, weight = np.polynomial.legendre.leggauss(4)
    return float(0.5 * weight @ f(0.5 * (1 + at)))


def conditions() -> dict[str, float]:
    """Warm, accelerated, rotating structures: shifts over a dT, a clamped bar over E A a dT, m a; and the map of an arm."""
    stretch = 12e-6 * 45.0
    return {
        "missions.conditions.shift_C_x": 1.0,
        "missions.conditions.shift_C_y": 1.5,
        "missions.conditions.clamped": -1 / (1 + stretch),
        "missions.conditions.pushed": -2.0 * 3.0,
        **{f"missions.rotating_base.{name}": 1.0 for name in ("root", "middle", "euler", "coriolis", "centrifugal")},
        "missions.rotating_base.gravity": math.cos(9.0 * 0.3),
        **{f"missions.workspace.serial_{r}": _arm(0.4, 0.3, r / 1000) for r in (120, 300, 500)},
    }


def _arm(a: float, b: float, r: float) -> float:
    """Least singular value, m/rad, of the tip of two bars by their angles: of [[a^2, a b c], [a b c, b^2]], c = cos between."""
    across = a * b * (r**2 - a**2 - b**2) / (2 * a * b)
    return math.sqrt(float(eigvalsh([[a**2, across], [across, b**2]])[0]))
