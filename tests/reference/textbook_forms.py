"""Closed forms of the beams, frames and grids of textbooks, apart from any element."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import brentq
from scipy.special import jv

Numbers = dict[str, float]


def textbooks() -> Numbers:
    """All of them, by id."""
    constant = {
        **dict.fromkeys((f"formula.part_of_a_span.{name}" for name in ("propped", "clamped", "clamped.M")), 1.0),
        **dict.fromkeys((f"formula.portal.{f}.{name}" for f in ("hinged", "clamped") for name in ("thrust", "corner")), 1.0),
        "formula.portal.clamped.foot": 1.0,
        "formula.couple_on_a_span.couple": 1.0,
        "formula.crossed_ties.pulls": 1.0,
        "formula.foundation.deflection": 1.0,
    }
    spans = _spans([0.0] * 4, 1.0, 1.0, 1.0)
    equal = {"outer": spans[0], "inner": spans[1], "M": 0.5 - spans[0]}
    gerber = {"C": 4 / 2, "M": 2 * 2 / 2 + 2 * 2}
    gerber |= {"A": 3 - gerber["M"] / 6, "B": 12 - gerber["C"] - (3 - gerber["M"] / 6)}
    sunk = _spans([0.0, -0.625, -1.5, -0.75], 2 / 12, 240.0, 29000.0 * 7800.0)
    return (
        constant
        | {f"formula.equal_spans.{name}": value for name, value in equal.items()}
        | {f"formula.gerber.{name}": value for name, value in gerber.items()}
        | {f"book.kassimali.{name}": value for name, value in zip("ABCD", sunk, strict=True)}
        | {f"formula.portal_buckling.{name}": value for name, value in _portals().items()}
        | {"vpcs.ssll11.D.uy": _four_bars(), "vpcs.ssll403.factor": _own_weight()}
        | {f"vpcs.{name}": value for name, value in (_short_beam() | _folded() | _grid() | _tip_mass()).items()}
    )


def _spans(sunk: list[float], q: float, l: float, rigidity: float) -> list[float]:
    """Reactions of three equal spans under q by three moments, M1 + 4 M2 + M3 = -q l^2/2 + 6 E I/l^2 (d1 - 2 d2 + d3)."""
    right = [-q * l * l / 2 + 6 * rigidity / l**2 * (sunk[k] - 2 * sunk[k + 1] + sunk[k + 2]) for k in (0, 1)]
    M = [0.0, *np.linalg.solve([[4.0, 1.0], [1.0, 4.0]], right).tolist(), 0.0]
    ends = [(q * l / 2 + (M[k + 1] - M[k]) / l, q * l / 2 - (M[k + 1] - M[k]) / l) for k in range(3)]
    return [ends[0][0], ends[0][1] + ends[1][0], ends[1][1] + ends[2][0], ends[2][1]]


def _portals() -> Numbers:
    """P h^2/(E I) = u^2 of a column on a hinge or a clamp under a girder of its own length and stiffness."""

    def near(u: float) -> float:  # what turns the head of a clamped column, over E I/h
        return u * (math.sin(u) - u * math.cos(u)) / (2 - 2 * math.cos(u) - u * math.sin(u))

    roots = {
        "hinged.free": brentq(lambda u: u * math.tan(u) - 6, 0.1, 1.5, xtol=1e-15),
        "hinged.held": brentq(lambda u: u * u * math.sin(u) + 2 * (math.sin(u) - u * math.cos(u)), 3.2, 4.4, xtol=1e-15),
        "clamped.free": brentq(lambda u: u * math.cos(u) + 6 * math.sin(u), 1.6, 3.1, xtol=1e-15),
        "clamped.held": brentq(lambda u: near(u) + 2, 4.6, 5.5, xtol=1e-15),
    }
    return {name: float(u) ** 2 for name, u in roots.items()}


def _four_bars() -> float:
    """N by the balance of D, then of C; then -sum of N^2 l/(E A) over the force."""
    F, at = 9810.0, {"A": (0, 0), "B": (1, 0), "C": (0.5, 0.5), "D": (2, 1)}

    def way(a: str, b: str) -> np.ndarray:
        d = np.subtract(at[b], at[a])
        return d / np.linalg.norm(d)

    CD, BD = np.linalg.solve(np.column_stack([way("C", "D"), way("B", "D")]), [0.0, -F])
    AC, BC = np.linalg.solve(np.column_stack([way("A", "C"), way("B", "C")]), CD * way("C", "D"))
    bars = ((AC, "AC", 2e-4), (BC, "BC", 2e-4), (CD, "CD", 1e-4), (BD, "BD", 1e-4))
    return -sum(N * N * math.dist(at[ends[0]], at[ends[1]]) / (1.962e11 * area) for N, ends, area in bars) / F


def _own_weight() -> float:
    j = float(brentq(lambda z: jv(-1 / 3, z), 1.5, 2.2, xtol=1e-15))
    return 9 / 4 * j * j * 2e11 * 1e-8 / 12 / (7800 * 1e-4 * 9.81)


def _short_beam() -> Numbers:
    """rho r^2/(k G) w^4 - (1 + q r^2 (1 + E/(k G))) w^2 + E r^2 q^2/rho = 0, q = (n pi/L)^2; the lower of each n."""
    E, G, rho, r2, k = 2e11, 2e11 / 2.6, 7800.0, 2e-4 / 3 / 0.02, 1 / 1.17692
    found = [(2 * n - 1) / 4 * math.sqrt(E / rho) for n in (1, 2)]
    for n in range(1, 5):
        q = (n * math.pi) ** 2
        half, last = 0.5 * (1 + q * r2 * (1 + E / (k * G))), E * r2 * q * q / rho
        lower = last / (half + math.sqrt(half * half - rho * r2 / (k * G) * last))
        found.append(math.sqrt(lower) / (2 * math.pi))
    return {f"sdll01.mode_{n}": f for n, f in enumerate(sorted(found), 1)}


def _folded() -> Numbers:
    scale = math.sqrt(2.1e11 * 0.005**2 / 12 / 7800.0) / 0.5**2
    return {f"sdll02.mode_{n}": (2 * ((n + 1) // 2) - 1) ** 2 * math.pi / 8 * scale for n in range(1, 9)}


def _grid() -> Numbers:
    """The middle of a pinned beam resists with 4 E I b^3/(tan - tanh)(b l/2); the third beam on two of these, halved."""
    EI, line, h = 2e11 * 1.943e-5, 7800 * 2.872e-3, 2.5

    def half(w: float) -> np.ndarray:
        b = (line * w * w / EI) ** 0.25
        s, c, sh, ch = math.sin(b * h), math.cos(b * h), math.sinh(b * h), math.cosh(b * h)
        spring = 4 * EI * b**3 / (math.tan(b * h) - math.tanh(b * h))
        # w = (cos, sin, cosh, sinh)(b x) from the middle: no slope and half the force there, no moment and a spring at h
        return np.array(
            [
                [0, b, 0, b],
                [0, -EI * b**3, 0, EI * b**3],
                [-c, -s, ch, sh],
                [
                    EI * b**3 * s - spring * c,
                    -EI * b**3 * c - spring * s,
                    EI * b**3 * sh - spring * ch,
                    EI * b**3 * ch - spring * sh,
                ],
            ]
        )

    def shaken(w: float) -> np.ndarray:
        b = (line * w * w / EI) ** 0.25
        shape = np.linalg.solve(half(w), [0, -1e5 / 2, 0, 0])
        return np.array([shape[0] + shape[2], shape @ [math.cos(b * h), math.sin(b * h), math.cosh(b * h), math.sinh(b * h)]])

    G, B = shaken(80.0).tolist()
    first, third = (
        float(brentq(lambda f: np.linalg.det(half(2 * math.pi * f) / 1e6), *ends, xtol=1e-13)) for ends in ((15, 18), (36, 40))
    )
    return {"sdll08.mode_1": first, "sdll08.mode_3": third, "sdll08.B.shaken": B, "sdll08.G.shaken": G}


def _tip_mass() -> Numbers:
    area, inertia = math.pi / 4 * (0.35**2 - 0.32**2), math.pi / 64 * (0.35**4 - 0.32**4)
    m = 1000 / (7800 * area * 10)
    scale = math.sqrt(2.1e11 * inertia / (7800 * area)) / 10**2 / (2 * math.pi)

    def left(b: float) -> float:
        s, c, sh, ch = math.sin(b), math.cos(b), math.sinh(b), math.cosh(b)
        return 1 + c * ch - m * b * (s * ch - c * sh)

    ends = [(0.5, 2.0), (3.2, 4.7), (6.3, 7.8), (9.5, 11.0)]
    return {f"sdll15.straight.mode_{n}": float(brentq(left, *at, xtol=1e-15)) ** 2 * scale for n, at in enumerate(ends, 1)}
