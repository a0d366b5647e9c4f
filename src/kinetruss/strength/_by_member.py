"""What the rules say of whole members, where a member may have several parts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.strength._utilisation import utilisation

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces, Verdict

__all__ = ["strength_histories", "worst_of"]


def strength_histories(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Stress (largest von Mises along the member, Pa), utilisation (largest of all rules), and compression over allowed.

    Each (times, members), by the rules of `strength.check`; NaN where a rule cannot be applied.
    """
    data = utilisation(model, forces)
    rules = list(data["rule"].values)
    of = _members_of(model, data["member"].values)
    used = data["utilisation"].values
    found = {
        "stress": (data["value"].values[:, :, rules.index("yield")]),
        "utilisation": np.fmax.reduce(used, axis=2),
        "buckling": used[:, :, rules.index("buckling")],
    }
    count = len(model.members)
    return {name: _largest(values, of, count) for name, values in found.items() if not np.isnan(values).all()}


def worst_of(model: Model, verdict: Verdict) -> dict[str, NDArray[np.float64]]:
    """The same of a whole run (members,), from its verdict."""
    data = verdict.data
    rules = list(data["rule"].values)
    of = _members_of(model, data["member"].values)
    used = data["utilisation"].values
    found = {
        "stress": data["value"].values[:, rules.index("yield")],
        "utilisation": np.fmax.reduce(used, axis=1),
        "buckling": used[:, rules.index("buckling")],
    }
    count = len(model.members)
    return {name: _largest(values[None], of, count)[0] for name, values in found.items() if not np.isnan(values).all()}


def _members_of(model: Model, names: NDArray[Any]) -> NDArray[np.int64]:
    index = {name: k for k, name in enumerate(model.members)}
    return np.array([index[str(name)] for name in names], np.int64)


def _largest(values: NDArray[np.float64], of: NDArray[np.int64], count: int) -> NDArray[np.float64]:
    """Largest over the parts of each member; NaN only where all are."""
    found = np.full((len(values), count), np.nan)
    for part, member in enumerate(of):
        found[:, member] = np.fmax(found[:, member], values[:, part])
    return found
