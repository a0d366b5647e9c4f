"""What colours the members: values in time, or where a scene is large the worst of the whole run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.results import Forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Verdict

__all__ = ["CHANNELS", "strength_histories", "worst_of"]

CHANNELS: dict[str, dict[str, str]] = {
    "force": {"label": "Axial force", "unit": "N", "scale": "diverging", "low": "compression", "high": "tension",
              "array": "member_force"},
    "stress": {"label": "Stress", "unit": "Pa", "scale": "sequential", "low": "none", "high": "largest of the run",
               "array": "stress"},
    "utilisation": {"label": "Utilisation", "unit": "", "scale": "capacity", "low": "unused", "high": "full at 1",
                    "array": "utilisation"},
    "buckling": {"label": "Buckling margin", "unit": "", "scale": "margin", "low": "no compression", "high": "buckles",
                 "array": "buckling"},
    "speed": {"label": "Speed of the middle", "unit": "m/s", "scale": "sequential", "low": "at rest",
              "high": "largest of the run"},
}  # fmt: skip
"""Channels a scene may have. ``array`` is missing where the page forms it from others."""


def strength_histories(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Stress (largest von Mises along the member, Pa), utilisation (largest of all rules), and compression over allowed.

    Each (times, members), by the rules of `strength.check`; NaN where a rule cannot be applied.
    """
    from kinetruss import strength

    data = strength.utilisation(model, forces)
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
