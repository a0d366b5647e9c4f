"""Loads of a load case on a time axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import LoadCase, NodalForce
from kinetruss.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Loads", "case_loads"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Loads:
    """gravity (3,), lump_gravity (n, 3) m/s^2; loads (k,) names, node (k,) and force (times, k, 3) N."""

    name: str
    loads: tuple[str, ...]
    gravity: NDArray[np.float64]
    lump_gravity: NDArray[np.float64]
    node: NDArray[np.int64]
    force: NDArray[np.float64]


def case_loads(system: System, t: NDArray[np.float64], name: str | None) -> Loads:
    """Gravity and nodal forces of a load case of the model (None: all loads with factor 1)."""
    model = system.model
    if name is not None and name not in model.load_cases:
        raise InputError(f"No load case called {name!r}. There are: {', '.join(model.load_cases) or 'none'}.")
    case = LoadCase() if name is None else model.load_cases[name]
    gravity = system.gravity.copy()
    if case.gravity is not None:
        gravity[: system.dim] = case.gravity
    own = np.isfinite(system.own_gravity)
    factors = dict.fromkeys(model.loads, 1.0) if case.loads is None else case.loads
    force = np.zeros((len(t), len(factors), 3))
    for k, (load, factor) in enumerate(factors.items()):
        force[:, k, : system.dim] = factor * _history(model.loads[load], t)
    return Loads(
        name=name or "all",
        loads=tuple(factors),
        gravity=gravity,
        lump_gravity=np.where(own, np.nan_to_num(system.own_gravity), gravity),
        node=np.array([system.node_index(model.loads[load].node) for load in factors], np.int64),
        force=force,
    )


def _history(load: NodalForce, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """(times, dim): constant, or linear between the table's entries and held outside."""
    if load.forces is None:
        return np.broadcast_to(np.array(load.force), (len(t), len(load.force or ())))
    return np.stack([np.interp(t, load.times or (), column) for column in zip(*load.forces, strict=True)], axis=1)
