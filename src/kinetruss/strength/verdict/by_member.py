"""Results of the rules for whole members, which may have several parts, and checks that were not possible."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.results.records import NOT_CHECKED, most_used
from kinetruss.strength.members.parts import parts_of
from kinetruss.strength.verdict.beams import beam_parts, chord_of
from kinetruss.strength.verdict.notes import missing
from kinetruss.strength.verdict.utilisation import utilised

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces, Row, Verdict

__all__ = ["highest", "strength_histories", "unchecked", "worst_of"]


def strength_histories(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Stress (largest von Mises along the member, Pa), utilisation (the largest finite one of all rules: beyond Euler's load
    that of buckling), and compression over allowed.

    Each (times, members), by the rules of `strength.check`; NaN where a rule cannot be applied. A utilisation is NaN, not 0,
    if the checked rules have no demand and another rule was not checked: for instance for a member in tension without yield
    strength.
    """
    data = utilised(model, forces).columns
    return _by_member(model, data, data["value"].values, data["utilisation"].values)


def worst_of(model: Model, verdict: Verdict) -> dict[str, NDArray[np.float64]]:
    """The same for a whole run (members,), from its verdict."""
    data = verdict.arrays
    found = _by_member(model, data, data["value"].values[None], data["utilisation"].values[None])
    return {name: values[0] for name, values in found.items()}


def unchecked(model: Model) -> dict[str, str]:
    """Member -> the rules that were not checked and why, in words; fully checked members are left out.

    >>> import kinetruss as kt
    >>> bar = kt.Bar(ends=("A", "B"), section=kt.Tube(outer=0.02, inner=0.016), material=kt.Material(E=70e9, density=2700))
    >>> unchecked(kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"a": bar}))
    {'a': 'yield: no yield strength'}
    """
    parts = parts_of(model)
    found: dict[str, list[str]] = {}
    for r, (part, member) in enumerate(zip(parts.names, parts.members, strict=True)):
        bar = model.bars.get(member)
        if (bar is None or not bar.brace) and (what := missing(parts, r)):
            found.setdefault(member, []).append(f"yield{'' if part == member else ' of ' + part}: no {what}")
    for name in beam_parts(model):
        material = model.material_of(model.beams[name])
        if material is None or material.yield_strength is None:
            found.setdefault(chord_of(name), []).append("yield: no yield strength")
    return {member: "; ".join(words) for member, words in found.items()}


def highest(rows: Iterable[Row]) -> float:
    """Highest utilisation of some entries; NaN if none was checked, or only rules without demand."""
    some = list(rows)
    found = most_used(row.utilisation for row in some)
    return math.nan if found == 0 and any(row.note.startswith(NOT_CHECKED) for row in some if not row.checked) else found


def _by_member(
    model: Model, data: Any, value: NDArray[np.float64], used: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Over (times, members), of values and utilisations over (times, parts, rules)."""
    rules, index = list(data["rule"].values), {name: k for k, name in enumerate(model.members)}
    index |= {name: index[chord_of(name)] for name in beam_parts(model)}
    of = np.array([index[str(name)] for name in data["member"].values], np.int64)
    stress, buckling = rules.index("yield"), rules.index("buckling")
    count = len(model.members)
    largest = _largest(np.fmax.reduce(np.where(np.isinf(used), np.nan, used), axis=2), of, count)
    some = np.zeros(count, np.bool_)
    some[[index[name] for name in unchecked(model)]] = True
    largest[some & (largest == 0)] = np.nan
    found = {
        "stress": _largest(value[:, :, stress], of, count),
        "utilisation": largest,
        "buckling": _largest(used[:, :, buckling], of, count),
    }
    return {name: values for name, values in found.items() if not np.isnan(values).all()}


def _largest(values: NDArray[np.float64], of: NDArray[np.int64], count: int) -> NDArray[np.float64]:
    """Largest over the parts of each member; NaN only where all are."""
    found = np.full((len(values), count), np.nan)
    for part, member in enumerate(of):
        found[:, member] = np.fmax(found[:, member], values[:, part])
    return found
