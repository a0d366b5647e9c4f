"""What a model's members and motors bear, from its numbers alone, for responses beside the results.

Of members, for ``member_force/buckling_load``: buckling_load N, Euler's load of a slender bar, Johnson's of a stocky one, about
its weaker axis, with its own end condition, as in `strength.check`; yield_load N, area times yield strength. Of the motors of
active members, for ``voltage/max_voltage``: their own limits. NaN where the model does not say.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.shafts import parts_of as train_parts
from kinetruss.errors import InputError, few
from kinetruss.gradients.differences import FOUR
from kinetruss.gradients.responses import Beside
from kinetruss.mechanics import compile, ends_of
from kinetruss.model import LengthDrive, Model
from kinetruss.results import variable
from kinetruss.strength.critical_loads import critical_load, end_condition
from kinetruss.strength.parts import parts_of

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from numpy.typing import NDArray

    Names = Mapping[str, Sequence[str]]

MEMBERS = {"buckling_load": "N", "yield_load": "N"}
MOTORS = {
    "max_voltage": "V",
    "max_current": "A",
    "max_speed": "rad/s",
    "max_torque": "N m",
    "rated_current": "A",
    "rated_torque": "N m",
}
NAMES = (*MEMBERS, *MOTORS)


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


def motor_limits(model: Model, active: Sequence[str]) -> dict[str, NDArray[np.float64]]:
    """Limits (active,) of the motors of some active members by name."""
    motors = [train_parts(model, model.actuators[name])[2] for name in active]
    return {name: np.array([getattr(one, name, None) or np.nan for one in motors], float) for name in MOTORS}


def _borne(model: Model, names: Names) -> dict[str, NDArray[np.float64]]:
    found = member_loads(model, names["member"]) if "member" in names else {}
    return found | (motor_limits(model, names["active"]) if "active" in names else {})


def names_of(data: Any) -> dict[str, list[str]]:
    """The members and active members of a result, as far as it has any; its instants, of a motion."""
    return {dim: [str(name) for name in data[dim].values] for dim in ("member", "active", "time") if dim in data.coords}


def beside(model: Model, names: Names) -> Beside:
    """The same as variables beside those of a result with these members, active members and instants."""

    def load(kind: str) -> dict[str, Any]:
        driven = {one.bar for one in model.all_drives.values() if isinstance(one, LengthDrive)}
        moving = [name for name in names["member"] if name in driven] if "time" in names else []
        if moving and kind == "buckling_load":
            raise InputError(
                f"buckling_load of {few(moving, 4)} changes with the length along a motion, and is known here at the place of "
                "the model alone. Limit utilisation[buckling], which follows the length."
            )
        own = member_loads(model, names["member"])[kind]
        return {kind: variable(("member",), own, MEMBERS[kind], "load that the member bears")}

    def limits() -> dict[str, Any]:
        found = motor_limits(model, names["active"])
        return {name: variable(("active",), one, MOTORS[name], "limit of the motor") for name, one in found.items()}

    found: dict[str, Callable[[], dict[str, Any]]] = {}
    if "member" in names:
        found |= {kind: partial(load, kind) for kind in MEMBERS}
    return Beside(found | (dict.fromkeys(MOTORS, limits) if "active" in names else {}))


def slopes(
    at: Callable[[NDArray[np.float64]], Model], p: NDArray[np.float64], names: Names, step: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Derivatives (members or motors, n) by variables p (n,), by differences of fourth order of these formulas; at : the model
    of p; names : as of `names_of`.
    """
    found: dict[str, NDArray[np.float64]] = {}
    for k in range(len(p)):
        for share, weight in FOUR:
            moved = p.copy()
            moved[k] += share * step[k]
            for name, one in _borne(at(moved), names).items():
                found.setdefault(name, np.zeros((len(one), len(p))))[:, k] += weight * one / step[k]
    return found
