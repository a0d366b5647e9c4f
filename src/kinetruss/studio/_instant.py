"""Forces, reactions, stresses and motor demand of one pose at rest."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.actuators.demand import columns_of
from kinetruss.display import quantity
from kinetruss.model import Model
from kinetruss.strength import check
from kinetruss.strength.verdict import Governing, headline
from kinetruss.viewer.scenes import moving

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Forces

__all__ = ["MANY", "Instant", "alarms_of", "framed", "instant"]

MANY = 40
"""Number of members above which motors and mobility are computed only when the slider stops."""

LARGEST = 400
"""Number of members above which the mobility of a pose (a dense singular value decomposition) is omitted."""

ALARMS = 4
"""Largest number of members in messages."""

DEMANDS = ("thrust", "stroke", "holding_torque", "breakaway_torque", "current")


@dataclass(frozen=True, kw_only=True, eq=False)
class Instant:
    """One pose at rest: forces, arrays of the scene, demand of the motors, mobility as text, limits exceeded."""

    forces: Forces
    arrays: dict[str, NDArray[Any]]
    demand: list[dict[str, Any]] | None
    mobility: str | None
    alarms: list[str]
    verdict: dict[str, Any]


def instant(model: Model, position: NDArray[np.float64], case: str | None, fine: bool = True) -> Instant:
    """All results shown for a pose (n_nodes, dim), m, at rest under a load case (None: all loads)."""
    still = np.zeros((1, *position.shape))
    motion = kinematics.from_arrays(model, [0.0], position[None], still, still)
    forces = dynamics.inverse(model, motion, case, static=False)
    _, arrays = moving(model, motion, [forces], None, 600)
    fine = fine or len(model.members) <= MANY
    demand = _demand(model, forces) if fine and model.actuators else None
    mobility = str(kinematics.mobility(model, position)) if fine and len(model.members) <= LARGEST else None
    alarms = [*_strength(model, arrays), *_motors(demand or [])]
    verdict = headline(check(model, forces), drives=_holding(demand or []), timed=False).record
    return Instant(forces=forces, arrays=arrays, demand=demand, mobility=mobility, alarms=alarms, verdict=verdict)


def alarms_of(model: Model, forces: Forces) -> list[str]:
    """Members and motors beyond a limit under the forces of one pose, in sentences."""
    _, arrays = moving(model, forces.motion, [forces], None, 600)
    return [*_strength(model, arrays), *_motors(_demand(model, forces) if model.actuators else [])]


def _strength(model: Model, arrays: dict[str, NDArray[Any]]) -> list[str]:
    """Members beyond a limit, worst first, in sentences."""
    nothing = np.full((1, len(model.members)), np.nan)
    used, buckling = (np.fmax(arrays.get(name, nothing)[0], 0.0) for name in ("utilisation", "buckling"))
    worst = np.maximum(used, buckling)
    order = [int(k) for k in np.argsort(-worst, kind="stable") if worst[k] > 1]
    names = list(model.members)
    found = [
        f"{names[k]} buckles: its compression is {quantity(buckling[k], '%')} of what is allowed."
        if buckling[k] > 1
        else f"{names[k]} is at {quantity(worst[k], '%')} of its allowed load."
        for k in order[:ALARMS]
    ]
    return found + [f"{len(order) - ALARMS} more members are beyond a limit."] * (len(order) > ALARMS)


def _holding(demand: list[dict[str, Any]]) -> Iterator[Governing]:
    """The share of the largest current that each motor takes to hold."""
    for one in demand:
        if one["current"] is not None and one["max_current"]:
            used = abs(one["current"]) / one["max_current"]
            yield Governing(kind="drive", name=one["name"], member=one["name"], rule="holding current", used=used)


def _motors(demand: list[dict[str, Any]]) -> list[str]:
    return [
        f"{one['name']}: holding takes {quantity(abs(one['current']), 'A')}, more than "
        f"the motor's {quantity(one['max_current'], 'A')}."
        for one in demand
        if one["current"] is not None and one["max_current"] and abs(one["current"]) > one["max_current"]
    ]


def _demand(model: Model, forces: Forces) -> list[dict[str, Any]]:
    columns = columns_of(model, forces.motion, forces)
    return [
        {
            "name": name,
            **{one: number(of[one][0]) if one in of else None for one in DEMANDS},
            "max_current": _limit(model, name),
        }
        for name, of in zip(model.actuators, columns, strict=True)
    ]


def _limit(model: Model, name: str) -> float | None:
    motor = model.actuators[name].motor
    record = model.motors[motor] if isinstance(motor, str) else motor
    return None if record is None else record.max_current


def number(value: Any) -> float | None:
    """A float, or None if JSON cannot represent it."""
    return float(value) if math.isfinite(value) else None


def framed(header: dict[str, Any], *blocks: bytes) -> bytes:
    """One binary message: length of the header (uint32), the header in JSON padded to four bytes, then the blocks."""
    text = json.dumps(header, ensure_ascii=False, allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    return b"".join([len(text).to_bytes(4, "little"), text, *blocks])
