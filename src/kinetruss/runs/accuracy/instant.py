"""A model as it is at one instant of its loads."""

from __future__ import annotations

from typing import Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.mechanics.assembly import history_of
from kinetruss.mechanics.configuration import base_of
from kinetruss.model import Model

__all__ = ["at_instant"]

VALUES = {"forces": "force", "moments": "moment", "pressures": "pressure"}
"""Table of a load in time -> its constant value."""


def at_instant(model: Model, time: float) -> Model:
    """The model with its loads and gravity as they are at a time, s, for poses that are counted along the time axis.

    Raises
    ------
    InputError : supports that move.
    """
    if model.support_motion:
        name = next(iter(model.support_motion))
        raise InputError(f"A budget takes no moving supports, and {name!r} moves. Leave out support_motion.")
    t = np.array([time])
    loads = {name: _constant(load, t) for name, load in model.loads.items()}
    found = model.with_(loads=loads) if loads != model.loads else model
    base = base_of(compile(model))
    if base is None or not base.turns or model.base_rotation is None:
        return found

    def turned(gravity: Any) -> Any:
        if gravity is None:
            return None
        here = np.zeros(3)
        here[: model.dim] = gravity
        return tuple((here + base.gravity_change(t, here)[0])[: model.dim].tolist())

    cases = {name: case.with_(gravity=turned(case.gravity)) for name, case in model.load_cases.items()}
    still = model.base_rotation.with_(gravity_turns=False)
    return found.with_(gravity=turned(model.gravity), load_cases=cases, base_rotation=still)


def _constant(load: Any, t: Any) -> Any:
    """A load with its value at a time, (1,) s."""
    for table, value in VALUES.items():
        if getattr(load, table, None) is not None:
            here = history_of(load, t)[0].tolist()
            alone = value == "pressure" or (value == "moment" and len(here) == 1)
            return load.with_(**{"times": None, table: None, value: here[0] if alone else tuple(here)})
    return load
