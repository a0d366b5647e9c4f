"""Notes on the entries of a verdict: the formula used, or missing data."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.strength.members.parts import Parts

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["missing", "notes"]


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
