"""What a model's members bear, from its numbers alone, for responses beside the results: ``member_force/buckling_load``.

buckling_load (member) N : Euler's load of a slender bar, Johnson's of a stocky one, about its weaker axis, with its own end
condition, as in `strength.check`. yield_load (member) N : area times yield strength. NaN where the model does not say.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.gradients.differences import FOUR
from kinetruss.gradients.responses import Beside
from kinetruss.mechanics import compile, ends_of
from kinetruss.model import Model
from kinetruss.results import variable
from kinetruss.strength.critical_loads import critical_load, end_condition
from kinetruss.strength.parts import parts_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

NAMES = ("buckling_load", "yield_load")


def member_loads(model: Model, members: Sequence[str]) -> dict[str, NDArray[np.float64]]:
    """Loads (members,) of some members by name; of an active one those of its weaker part over the whole length."""
    parts, system = parts_of(model), compile(model)
    length = dict(zip(system.members, ends_of(system, system.x0)[1], strict=True))
    C = {name: end_condition(one.buckling) for name, one in model.whole.real_members.items()}
    L, ends = (np.array([of[name] for name in parts.members]) for of in (length, C))
    loads = critical_load(ends * parts.E, np.fmin(parts.I2, parts.I3), parts.area, L, parts.yield_strength)
    found = {}
    for kind, own in (("buckling_load", loads), ("yield_load", parts.area * parts.yield_strength)):
        least: dict[str, float] = {}
        for name, one in zip(parts.members, own.tolist(), strict=True):
            least[name] = float(np.fmin(least.get(name, np.nan), one))
        found[kind] = np.array([least.get(name, np.nan) for name in members])
    return found


def beside(model: Model, members: Sequence[str]) -> Beside:
    """The same as variables beside those of a result with these members."""

    def found() -> dict[str, Any]:
        loads = member_loads(model, members)
        return {name: variable(("member",), one, "N", "load that the member bears") for name, one in loads.items()}

    return Beside(dict.fromkeys(NAMES, found) if len(members) else {})


def slopes(
    at: Callable[[NDArray[np.float64]], Model], p: NDArray[np.float64], members: Sequence[str], step: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Derivatives (members, n) by variables p (n,), by differences of fourth order of these formulas; at : the model of p."""
    found = {name: np.zeros((len(members), len(p))) for name in NAMES}
    for k in range(len(p)):
        for share, weight in FOUR:
            moved = p.copy()
            moved[k] += share * step[k]
            for name, one in member_loads(at(moved), members).items():
                found[name][:, k] += weight * one / step[k]
    return found
