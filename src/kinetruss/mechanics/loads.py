"""Loads of a load case on a time axis, and loads on bodies as forces on nodes, which may turn with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.elements.kinds import LOADS
from kinetruss.elements.loads.load import load_of
from kinetruss.errors import InputError, few
from kinetruss.mechanics.rotating_base import RotatingBase, base_of
from kinetruss.mechanics.system import System
from kinetruss.model import LoadCase, NodalForce, loads_along_beams

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.loads.load import UnitLoad


def history_of(load: Any, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Components (times, c) of a load: constant, or linear between the entries of a table and constant outside it.

    load : a record, or as `load_of` gives it.
    """
    table = getattr(load, load.amounts)
    if table is None:
        given = np.atleast_1d(np.asarray(getattr(load, load.amount)))[..., None, :]
        return np.broadcast_to(given, (*given.shape[:-2], len(t), given.shape[-1]))
    rows = table if isinstance(table, np.ndarray) else np.array(table, float).reshape(len(table), -1)
    columns = np.moveaxis(rows, -2, -1).reshape(-1, len(load.times))
    found = np.stack([np.interp(t, load.times, column) for column in columns], axis=-1)
    return np.moveaxis(found.reshape(len(t), *rows.shape[:-2], rows.shape[-1]), 0, -2)


@cached(256)
def unit_loads_of(system: System, name: str) -> tuple[UnitLoad, ...]:
    """The unit load of each component of a load; none where the ground takes all of it."""
    return LOADS[type(system.model.loads[name])].units(system, load_of(system, name))


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

    def scaled_with(self, more: Loads, factor: float) -> Loads:
        """A copy with the nodal forces of other loads times a factor."""
        force = np.concatenate([self.force, factor * more.force], axis=1)
        return replace(self, loads=self.loads + more.loads, node=np.concatenate([self.node, more.node]), force=force)

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
    steady, factors = _steady(system, name)
    amounts = {load: _over(factor) * history_of(load_of(system, load), t) for load, factor in factors.items()}
    force = np.zeros((*system.x0.shape[:-2], len(t), len(steady.loads), 3), system.x0.dtype)
    for k, load in enumerate(steady.loads):
        force[..., k, : system.dim] = amounts.pop(load)
    unit_loads = [
        (load, unit, amount)
        for load, components in amounts.items()
        if components.any() and (units := unit_loads_of(system, load))
        for unit, amount in zip(units, np.moveaxis(components, -1, 0), strict=True)
        if amount.any()
    ]
    return replace(steady, force=force, unit_loads=tuple(unit_loads), t=t, amounts=amounts, base=base)


@cached()
def _steady(system: System, name: str | None) -> tuple[Loads, Mapping[str, float]]:
    """What of a load case does not change in time, and the factors of its loads."""
    model = system.model
    if name is not None and name not in model.cases:
        raise InputError(f"No load case called {name!r}. There are: {few(tuple(model.cases), 8) or 'none'}.")
    case = LoadCase() if name is None else model.cases[name]
    gravity, given = system.gravity.copy(), system.load_numbers
    if case.gravity is not None:
        gravity[..., : system.dim] = given[f"case {name} gravity"]
    own = np.isfinite(system.own_gravity)
    factors: dict[str, Any] = dict.fromkeys(model.loads, 1.0) if case.loads is None else {**case.loads}
    if refused := [fault for fault in loads_along_beams(model) if factors.get(str(fault.path[1]))]:
        raise InputError(str(refused[0]))
    if case.loads is not None:
        factors = dict(zip(factors, np.moveaxis(given[f"case {name} factor"], -1, 0), strict=True))
    nodal = {load: record.node for load in factors if isinstance(record := model.loads[load], NodalForce)}
    steady = Loads(
        name=name or "all",
        loads=tuple(nodal),
        gravity=gravity,
        lump_gravity=np.where(own, np.nan_to_num(system.own_gravity), gravity[..., None, :]),
        node=np.array([system.node_index(node) for node in nodal.values()], np.int64),
        force=np.zeros((0, len(nodal), 3)),
    )
    return steady, factors


def _over(factor: Any) -> Any:
    """A number of each copy over times and components."""
    return np.asarray(factor)[..., None, None]
