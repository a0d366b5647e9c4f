"""Notes on the entries of a verdict: the formula used, or missing data."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display import number, quantity
from kinetruss.strength.members.parts import Parts

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["beyond_euler", "missing", "notes"]


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
    for i, (r, k) in enumerate(zip(rod, whole, strict=True)):
        if r >= 0 and (lacking := missing(parts, int(r))):
            found[i, 0] = f"not checked: no {lacking}"
        elif r >= 0 and untold[r] and np.isnan(parts.twist[r]):
            found[i, 0] = "not checked: no shear stress of torsion of a general section"
        if k >= 0:
            found[i, 1] = _buckling(parts, int(k), float(compression[i]), bool(johnson[i]), active_section)
            if compression[i] > 0 and all(missing(parts, one) == "yield strength" for one in _rods(parts, int(k))):
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


def missing(parts: Parts, r: int) -> str:
    """The data that a part lacks for the yield check, or nothing."""
    if parts.body[r]:
        return "section forces of a planar body"
    if parts.shape[r] < 0:
        return "section"
    if np.isnan(parts.E[r]):
        return "material"
    return "yield strength" if np.isnan(parts.yield_strength[r]) else ""


def _buckling(parts: Parts, k: int, compression: float, johnson: bool, active_section: str) -> str:
    first = int(parts.first[k])
    if parts.cable[k]:
        return "not checked: a cable does not buckle"
    used = _rods(parts, k)
    if parts.two[k] and active_section != "weaker":
        used = [first + (active_section == "tube")]
    lacking = {r: gap for r in used if (gap := missing(parts, r)) not in ("", "yield strength")}
    if len(lacking) == len(used):
        # a bar has this note once, under yield
        return f"not checked: no {next(iter(lacking.values()))}" if parts.two[k] else ""
    if compression == 0:
        return "never in compression"
    text = "Johnson" if johnson else "Euler"
    if all(np.isnan(parts.yield_strength[r]) for r in used if r not in lacking):
        text = "Euler; no yield strength for Johnson"
    if parts.two[k] and lacking:
        r, gap = next(iter(lacking.items()))
        named, other = ("base", "tube") if r == first else ("tube", "base")
        text += f"; {named} has no {gap}, so with the {other}'s section"
    return text
