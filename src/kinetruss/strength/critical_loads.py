"""Critical loads of straight members, and the notes on entries of a verdict."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display import number, quantity
from kinetruss.errors import InputError
from kinetruss.results.wide_tables import CABLE
from kinetruss.strength.parts import Parts

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


END_CONDITIONS = {
    "pinned-pinned": 1.0,
    "clamped-pinned": (4.493409457909064 / math.pi) ** 2,  # first root of tan x = x: 2.0457
    "clamped-clamped": 4.0,
    "clamped-free": 0.25,
}
"""End-condition constants C of P = C pi^2 E I/l^2."""


def end_condition(ends: str | float) -> float:
    """The constant C of a named end condition, or the number itself.

    >>> end_condition("clamped-free"), end_condition(1.2)
    (0.25, 1.2)
    """
    if isinstance(ends, str):
        if ends not in END_CONDITIONS:
            raise InputError(f"end condition {ends!r} is not known. Write one of {', '.join(END_CONDITIONS)}, or a number C.")
        return END_CONDITIONS[ends]
    if not ends > 0:
        raise InputError(f"end-condition constant {ends:g} must be greater than 0. Pinned ends: 1.")
    return float(ends)


def euler_load(E: ArrayLike, I: ArrayLike, length: ArrayLike, C: str | float = 1.0) -> NDArray[np.float64]:
    """Euler's critical load C pi^2 E I/l^2, N.

    Parameters
    ----------
    E : Pa. I : second moment of area, m^4. length : m. C : end condition, a name or the constant.

    >>> round(float(euler_load(71e9, 8.45590e-09, 2.0)), 0)
    1481.0
    """
    stiffness = np.asarray(E, float) * np.asarray(I, float)
    return np.asarray(end_condition(C) * math.pi**2 * stiffness / np.asarray(length, float) ** 2)


def johnson_load(
    E: ArrayLike, I: ArrayLike, area: ArrayLike, length: ArrayLike, yield_strength: ArrayLike, C: str | float = 1.0
) -> NDArray[np.float64]:
    """Johnson's critical load of a stocky member, A Sy (1 - Sy (l/k)^2/(4 pi^2 C E)), k^2 = I/A, N.

    Meant for slenderness below `transition`, where it meets Euler's load with the same slope at A Sy/2.
    Source: Shigley, Mechanical Engineering Design, columns, parabolic (J. B. Johnson) formula.

    >>> import kinetruss as kt
    >>> E, I, area, yield_strength = 200e9, 1e-8, 1e-4, 200e6
    >>> length = kt.strength.transition(E, yield_strength) * (I / area) ** 0.5
    >>> kt.strength.johnson_load(E, I, area, length, yield_strength).round(3).item()  # N: half of A Sy, as Euler's load there
    10000.0
    """
    A, Sy = np.asarray(area, float), np.asarray(yield_strength, float)
    return np.asarray(A * Sy * (1 - A * Sy / (4 * euler_load(E, I, length, C))))


def transition(E: ArrayLike, yield_strength: ArrayLike, C: str | float = 1.0) -> NDArray[np.float64]:
    """Slenderness l/k at which Johnson's parabola meets Euler's hyperbola: sqrt(2 pi^2 C E/Sy).

    >>> import kinetruss as kt
    >>> kt.strength.transition(200e9, 200e6).round(2).item()  # pi sqrt(2 * 1000)
    140.5
    """
    ratio = np.asarray(E, float) / np.asarray(yield_strength, float)
    return np.asarray(math.pi * np.sqrt(2 * end_condition(C) * ratio))


def critical_load(
    E: ArrayLike,
    I: ArrayLike,
    area: ArrayLike,
    length: ArrayLike,
    yield_strength: ArrayLike | None = None,
    C: str | float = 1.0,
) -> NDArray[np.float64]:
    """Euler's load of a slender member, Johnson's of a stocky one (slenderness below `transition`), N.

    Euler's alone where the yield strength is None or NaN.

    >>> import kinetruss as kt
    >>> slender, stocky = 10.0, 0.1  # m
    >>> kt.strength.critical_load(200e9, 1e-8, 1e-4, [slender, stocky], 200e6).round(1).tolist()  # N: pi^2 E I/l^2; near A Sy
    [197.4, 19949.3]
    """
    euler = euler_load(E, I, length, C)
    if yield_strength is None:
        return euler
    squash = np.asarray(area, float) * np.asarray(yield_strength, float)
    # slenderness below the transition means an Euler load above half the squash load; a comparison with NaN is false
    return np.where(euler > squash / 2, johnson_load(E, I, area, length, yield_strength, C), euler)


def amplification(compression: ArrayLike, euler: ArrayLike, factor: float = 1.0, safety: float = 1.0) -> NDArray[np.float64]:
    """Amplification of the bending of a member by a compression P: Cm/(1 - n P/Pe); infinite from n P = Pe on.

    Parameters
    ----------
    compression : N, positive. euler : Euler load about the same axis, N. factor : Cm, 1 for loads across the member and
        pinned ends. safety : factor n on buckling.

    Source: AISC, Specification for Structural Steel Buildings, Allowable Stress Design (1989), eq. H1-1.

    Examples
    --------
    >>> import kinetruss as kt
    >>> kt.strength.amplification([0.0, 500.0, 1000.0], 1000.0).tolist()  # P = 0, Pe/2, Pe
    [1.0, 2.0, inf]
    """
    P, Pe = np.broadcast_arrays(np.asarray(compression, float), np.asarray(euler, float))
    left = 1 - safety * P / Pe
    found: NDArray[np.float64] = np.where(left > 0, factor / np.where(left > 0, left, 1.0), np.inf)
    return np.where(np.isnan(left), np.nan, found)


# Notes on the entries of a verdict: the formula used, or missing data.

ROUND_OFF = 1e-9
"""Excess over a load, as a fraction of it, that is round-off."""


def notes(
    parts: Parts,
    rod: NDArray[np.int64],
    whole: NDArray[np.int64],
    compression: NDArray[np.float64],
    johnson: NDArray[np.bool_],
    active_section: str,
    untold: NDArray[np.bool_],
) -> NDArray[np.object_]:
    """Notes over (subject, rule): yield, buckling, beam-column.

    untold (parts,) : those under torsion whose shear stress is not known.
    rod, whole : part that yields and member that buckles, -1 for none. compression (subjects,) N: largest, as judged.
    """
    found = np.full((len(rod), 3), "", dtype=object)
    gaps = missing(parts)
    for i, (r, k) in enumerate(zip(rod.tolist(), whole.tolist(), strict=True)):
        if r >= 0 and gaps[r]:
            found[i, 0] = f"not checked: no {gaps[r]}"
        elif r >= 0 and untold[r] and np.isnan(parts.twist[r]):
            found[i, 0] = "not checked: no shear stress of torsion of a general section"
        if k >= 0:
            found[i, 1] = _buckling(parts, gaps, k, float(compression[i]), bool(johnson[i]), active_section)
            if compression[i] > 0 and all(gaps[one] == "yield strength" for one in _rods(parts, k)):
                found[i, 2] = "not checked: no yield strength"
    return found


def beyond_euler(factored: float, euler: float, safety: float) -> str:
    """Why an interaction of compression and bending has no finite value. factored : compression times the safety factor, and
    Euler's load, N.

    >>> beyond_euler(339.35e3, 268e3, 2.5)
    "compression times the factor 2.5 (339.4 kN) exceeds Euler's load (268 kN)"
    >>> beyond_euler(268e3, 268e3, 1.0)
    "compression (268 kN) reaches Euler's load (268 kN)"
    """
    what = "compression" if safety == 1 else f"compression times the factor {number(safety)}"
    by = "exceeds" if factored > euler * (1 + ROUND_OFF) else "reaches"
    digits = next((n for n in range(4, 12) if by == "reaches" or quantity(factored, "N", n) != quantity(euler, "N", n)), 12)
    return f"{what} ({quantity(factored, 'N', digits)}) {by} Euler's load ({quantity(euler, 'N', digits)})"


def _rods(parts: Parts, k: int) -> list[int]:
    """The parts of a member."""
    first = int(parts.first[k])
    return [first, first + 1] if parts.two[k] else [first]


def missing(parts: Parts) -> list[str]:
    """The data that each part lacks for the yield check, or nothing."""
    gaps = {
        "section forces of a planar body": parts.body,
        "section": parts.shape < 0,
        "material": np.isnan(parts.E),
        "yield strength": np.isnan(parts.yield_strength),
    }
    found: list[str] = np.select(list(gaps.values()), list(gaps), "").tolist()
    return found


def _buckling(parts: Parts, gaps: list[str], k: int, compression: float, johnson: bool, active_section: str) -> str:
    first = int(parts.first[k])
    if parts.cable[k]:
        return CABLE
    used = _rods(parts, k)
    if parts.two[k] and active_section != "weaker":
        used = [first + (active_section == "tube")]
    lacking = {r: gap for r in used if (gap := gaps[r]) not in ("", "yield strength")}
    if len(lacking) == len(used):
        # a bar has this note once, under yield
        return f"not checked: no {next(iter(lacking.values()))}" if parts.two[k] else ""
    if compression == 0:
        return "never in compression"
    text = "Johnson" if johnson else "Euler"
    if all(gaps[r] == "yield strength" for r in used if r not in lacking):
        text = "Euler; no yield strength for Johnson"
    if parts.two[k] and lacking:
        r, gap = next(iter(lacking.items()))
        named, other = ("base", "tube") if r == first else ("tube", "base")
        text += f"; {named} has no {gap}, so with the {other}'s section"
    return text
