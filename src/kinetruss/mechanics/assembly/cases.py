"""Loads of a load case on a time axis."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import prod
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import System, kept
from kinetruss.mechanics.assembly.followers import Follower, history_of, pushes_of
from kinetruss.model import LoadCase, NodalForce

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Loads", "case_loads"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Loads:
    """gravity (3,), lump_gravity (n, 3) m/s^2; loads (k,) names, node (k,) and force (times, k, 3) N.

    pushes : loads on bodies: name, what it pushes with for the amount 1, amount (times,); `at` makes nodal forces of them.
    """

    name: str
    loads: tuple[str, ...]
    gravity: NDArray[np.float64]
    lump_gravity: NDArray[np.float64]
    node: NDArray[np.int64]
    force: NDArray[np.float64]
    pushes: tuple[tuple[str, Follower, NDArray[np.float64]], ...] = ()

    def at(self, x: NDArray[np.float64]) -> Loads:
        """The same with loads on bodies as nodal forces, at positions x (times, 3 n) or (times, n, 3)."""
        if not self.pushes:
            return self
        x = x.reshape(len(x), prod(x.shape[1:]) // 3, 3)
        names, nodes, forces = list(self.loads), [self.node], [self.force]
        for name, push, amount in self.pushes:
            names += [name] * len(push.nodes)
            nodes.append(push.nodes)
            forces.append(amount[:, None, None] * push.forces(x[:, push.nodes]))
        return replace(self, loads=tuple(names), node=np.concatenate(nodes), force=np.concatenate(forces, axis=1), pushes=())


def case_loads(system: System, t: NDArray[np.float64], name: str | None) -> Loads:
    """Gravity and nodal forces of a load case of the model (None: all loads with factor 1)."""
    loads, (steady, factors) = system.model.loads, _steady(system, name)
    force = np.zeros((len(t), len(steady.loads), 3))
    for k, load in enumerate(steady.loads):
        force[:, k, : system.dim] = factors[load] * history_of(loads[load], t)
    pushes = [
        (load, push, factor * amount)
        for load, factor in factors.items()
        if factor and load not in steady.loads
        for push, amount in zip(pushes_of(system, load), history_of(loads[load], t).T, strict=True)
        if amount.any()
    ]
    return replace(steady, force=force, pushes=tuple(pushes))


@kept()
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
