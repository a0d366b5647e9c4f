"""Forces in a base that rotates: inertia by velocities and accelerations in space, resistance by those relative to the base."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.structure import EndForces, NodalLoads, States, Structure
from kinetruss.kernels.sweep.forces import applied
from kinetruss.mechanics import System, kept
from kinetruss.mechanics.assembly import Loads, elements, structure_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

__all__ = ["fictitious_forces", "in_space", "solved_in_space"]


def in_space(loads: Loads, states: States) -> States:
    """States with velocities and accelerations in space; as given where the base does not rotate.

    Accelerations are less the change of gravity, if it turns: with the gravity of `loads` they give a - g.
    """
    if loads.base is None:
        return states
    x, v, a = (y.reshape(len(y), -1, 3) for y in states)
    moving = np.broadcast_to(loads.base.velocities(x, v), x.shape)
    felt = loads.base.accelerations(x, v, a, loads.base.gravity_change(loads.t, loads.gravity))
    return States(states.x, *(np.ascontiguousarray(np.broadcast_to(y, x.shape)).reshape(len(x), -1) for y in (moving, felt)))


def solved_in_space(
    system: System, loads: Loads, states: States, solve: Callable[[Loads, States], dict[str, Any]]
) -> dict[str, Any]:
    """What `solve` finds with states in space; the states relative to the base are its ``relative``.

    Friction about pins on the ground and springs resist relative velocities: the difference acts as forces on nodes.
    """
    if loads.base is None:
        return solve(loads, states)
    space = in_space(loads, states)
    if len(system.springs) or system.friction.any():
        whole = structure_of(system)
        change = _nodal(whole, system, states) - _nodal(whole, system, space) + fictitious_forces(system, states, space)
        loads = _with(loads, change.reshape(len(change), -1, 3))
    return solve(loads, space) | {"relative": states}


def fictitious_forces(system: System, states: States, space: States) -> NDArray[np.float64]:
    """Centrifugal, Euler and Coriolis forces at the nodes (times, 3 n), N: -M (a - a_rel) and the convective terms.

    With the consistent masses of members and bodies: accelerations of a rotating frame are linear in position and velocity.
    """
    masses = _masses(system)
    return _nodal(masses, system, space) - _nodal(masses, system, states)


@kept()
def _masses(system: System) -> Structure:
    """The element tables without laws, pins and springs."""
    table = elements(system)
    none = {name: values[:0] for name, values in table.items() if name.startswith(("law", "pin", "spring"))}
    return Structure.of(table | none | {name: np.zeros(1, np.int64) for name in ("spring_ptr", "spring_table_ptr")})


def _nodal(structure: Structure, system: System, states: States) -> NDArray[np.float64]:
    """f - M a of the elements at the nodes (times, 3 n), N, without gravity and loads."""
    joint, rest = np.zeros((len(states.x), len(system.members), 2, 3)), np.zeros_like(states.x)
    nothing = NodalLoads(np.zeros(3), np.zeros_like(system.x0), np.zeros(0, np.int64), np.zeros((len(states.x), 0, 3)))
    applied(structure, nothing, states, EndForces(joint, rest))
    return rest


def _with(loads: Loads, force: NDArray[np.float64]) -> Loads:
    """Loads and forces (times, n, 3) on all nodes."""
    return replace(
        loads,
        loads=(*loads.loads, *("base" for _ in range(force.shape[1]))),
        node=np.concatenate([loads.node, np.arange(force.shape[1])]),
        force=np.concatenate([loads.force, force], axis=1),
    )
