"""Loads of a load case on a time axis, and loads on bodies as forces on nodes, which may turn with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.elements.kinds import LOADS
from kinetruss.errors import InputError
from kinetruss.mechanics.rotating_base import RotatingBase, base_of
from kinetruss.mechanics.system import System
from kinetruss.model import LoadCase, NodalForce, loads_along_beams

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.loads.load import UnitLoad


def history_of(load: Any, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Components (times, c) of a load: constant, or linear between the entries of a table and constant outside it."""
    table = getattr(load, load.amounts)
    if table is None:
        given = np.atleast_1d(np.array(getattr(load, load.amount), float))
        return np.broadcast_to(given, (len(t), len(given)))
    rows = np.array(table, float).reshape(len(table), -1)
    return np.stack([np.interp(t, load.times, column) for column in rows.T], axis=1)


@cached(256)
def unit_loads_of(system: System, name: str) -> tuple[UnitLoad, ...]:
    """The unit load of each component of a load; none where the ground takes all of it."""
    load = system.model.loads[name]
    return LOADS[type(load)].units(system, load)


# Loads of a load case on a time axis.

ROTATES = (
    "The base rotates (base_rotation), which this analysis does not take into account. These do: dynamics.inverse, "
    "dynamics.simulate, statics.at_poses, missions, explain. Use one of them, or leave out base_rotation."
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Loads:
    """t (times,) s; gravity (3,), lump_gravity (n, 3) m/s^2; loads (k,) names, node (k,) and force (times, k, 3) N.

    unit_loads : other loads than those on nodes: name, unit load, amount (times,); `at` turns them into nodal forces. amounts :
    all components of these loads by name (times, c), also where the ground takes them.
    base : its rotation, or None.
    """

    name: str
    loads: tuple[str, ...]
    gravity: NDArray[np.float64]
    lump_gravity: NDArray[np.float64]
    node: NDArray[np.int64]
    force: NDArray[np.float64]
    unit_loads: tuple[tuple[str, UnitLoad, NDArray[np.float64]], ...] = ()
    amounts: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    t: NDArray[np.float64] = field(default_factory=lambda: np.zeros(1))
    base: RotatingBase | None = None

    def at(self, x: NDArray[np.float64]) -> Loads:
        """A copy with the loads on bodies turned into nodal forces, at positions x (times, 3 n) or (times, n, 3)."""
        if not self.unit_loads:
            return self
        x = x.reshape(len(x), prod(x.shape[1:]) // 3, 3)
        names, nodes, forces = list(self.loads), [self.node], [self.force]
        for name, follower, amount in self.unit_loads:
            names += [name] * len(follower.nodes)
            nodes.append(follower.nodes)
            forces.append(amount[:, None, None] * follower.forces(x[:, follower.nodes]))
        return replace(
            self, loads=tuple(names), node=np.concatenate(nodes), force=np.concatenate(forces, axis=1), unit_loads=()
        )


def case_loads(system: System, t: NDArray[np.float64], name: str | None, *, rotating: bool = False) -> Loads:
    """Gravity and nodal forces of a load case of the model (None: all loads with factor 1).

    rotating : the caller takes account of `base`.

    Raises
    ------
    InputError : an unknown load case; a base that rotates, of which the caller takes no account.
    """
    base = base_of(system)
    if base is not None and not rotating:
        raise InputError(ROTATES)
    loads, (steady, factors) = system.model.loads, _steady(system, name)
    force = np.zeros((len(t), len(steady.loads), 3))
    for k, load in enumerate(steady.loads):
        force[:, k, : system.dim] = factors[load] * history_of(loads[load], t)
    amounts = {load: factor * history_of(loads[load], t) for load, factor in factors.items() if load not in steady.loads}
    unit_loads = [
        (load, unit, amount)
        for load, components in amounts.items()
        if components.any() and (units := unit_loads_of(system, load))
        for unit, amount in zip(units, components.T, strict=True)
        if amount.any()
    ]
    return replace(steady, force=force, unit_loads=tuple(unit_loads), t=t, amounts=amounts, base=base)


@cached()
def _steady(system: System, name: str | None) -> tuple[Loads, Mapping[str, float]]:
    """What of a load case does not change in time, and the factors of its loads."""
    model = system.model
    if name is not None and name not in model.load_cases:
        raise InputError(f"No load case called {name!r}. There are: {', '.join(model.load_cases) or 'none'}.")
    case = LoadCase() if name is None else model.load_cases[name]
    gravity = system.gravity.copy()
    if case.gravity is not None:
        gravity[: system.dim] = case.gravity
    own = np.isfinite(system.own_gravity)
    factors = dict.fromkeys(model.loads, 1.0) if case.loads is None else case.loads
    if refused := [fault for fault in loads_along_beams(model) if factors.get(str(fault.path[1]))]:
        raise InputError(str(refused[0]))
    nodal = {load: record.node for load in factors if isinstance(record := model.loads[load], NodalForce)}
    steady = Loads(
        name=name or "all",
        loads=tuple(nodal),
        gravity=gravity,
        lump_gravity=np.where(own, np.nan_to_num(system.own_gravity), gravity),
        node=np.array([system.node_index(node) for node in nodal.values()], np.int64),
        force=np.zeros((0, len(nodal), 3)),
    )
    return steady, factors
