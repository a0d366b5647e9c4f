"""Friction of bearings in forward dynamics: couples from the joint forces of the same instant.

At given t, x, v accelerations and row forces are linear in the couples, and so are the joint forces: R = R_0 + sum c_j B_j.
R_0 and B_j follow from one solution of the equations of motion without friction and one more for a unit couple at each
bearing; then c_k = -mu r |R_k(c)| tanh(|w|/slip) is a fixed point of few numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.bearing_friction import couples_on_ends, relative_rates, seats_of
from kinetruss.dynamics.force_tables import Read, forces_of
from kinetruss.dynamics.prescribed import apply_loads, jammed, take_sum_forces, with_friction_of
from kinetruss.dynamics.user_forces import UserForce
from kinetruss.errors import InputError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.solve.kkt import accelerate_under, evaluate
from kinetruss.kernels.structure.applied import applied as forces_on_nodes, no_force, python_force
from kinetruss.kernels.structure.rows import row_forces
from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.mechanics import ends_of
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.positions import drive_values
from kinetruss.mechanics.rotating_base import base_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.equations import Equations, Workspace
    from kinetruss.mechanics import System


CLOSE = 1e-14
"""Change of the couples that counts as none, relative to the largest."""
MOST = 400
"""Rounds of the fixed point."""


def bearing_friction_of(
    system: System,
    function: Callable[..., Any] | None,
    eq: Equations,
    ws: Workspace,
    load_case: str | None,
    start: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> Rubbing:
    """The friction of bearings, called once at the start: positions and velocities (3 n,).

    Raises
    ------
    InputError : the base rotates. AnalysisError : a joint jams at the start.
    """
    if base_of(system) is not None:
        raise InputError(
            "Bearings with friction cannot be simulated in a base that rotates. Take out the bearings, or the rotation."
        )
    found = Rubbing(system, function, eq, ws, load_case)
    found.ready()
    found.at(0.0, *(y.copy() for y in start))
    if found.error is not None:
        raise found.error
    return found


def solved_along(system: System, loads: Loads, states: States, N: NDArray[np.float64]) -> dict[str, Any]:
    """Joint forces and the rest at nodes, as `forces_of` takes them, of solved states and row forces N (times, rows)."""
    count = len(states.x)
    joint, rest = allocate((count, len(system.members), 2, 3), (count, system.x0.size))
    apply_loads(system, loads, states, EndForces(joint, rest))
    p, q = (3 * ends[system.row_member] for ends in (system.p, system.q))
    row_forces(system.row_member, system.row_kind, p, q, states.x, N, joint, rest)
    take_sum_forces(system, states.x, N, rest)
    return {"x": states.x, "v": states.v, "a": states.a, "N": N, "joint": joint, "rest": rest}


class Rubbing(UserForce):
    """The friction of bearings as a force on nodes, with the force of the user."""

    def __init__(
        self, system: System, function: Callable[..., Any] | None, eq: Equations, ws: Workspace, load_case: str | None
    ) -> None:
        super().__init__(system, None)
        self._users = UserForce(system, function)
        self.given, self._plain, self.call = True, True, python_force
        self._eq, self._ws, self._case = eq, ws.copy(), load_case

    @property
    def words(self) -> str:
        """What it is, for messages."""
        return "bearings have friction"

    @property
    def own(self) -> UserForce:
        """The force of the user alone."""
        return self._users

    def again(self) -> Rubbing:
        """A new one without a force of the user, and with its own buffers."""
        return Rubbing(self._system, None, self._eq, self._ws, self._case)

    def ready(self) -> None:
        """Clear the stored exceptions, and make this the force that kernels of this thread call."""
        self._users.error = None
        super().ready()

    def _push(self, t: float, x: NDArray[np.float64], v: NDArray[np.float64], out: NDArray[np.float64]) -> None:
        if self.error is not None and not isinstance(self.error, Exception):
            out.fill(np.nan)
            return
        try:
            given = self._users.at(t, x, v)
            if self._users.error is not None:
                raise self._users.error
            node, force = couples_on_ends(self._system, x.reshape(1, -1, 3), self.couples(t, x, v, given)[None])
            out += given
            np.add.at(out.reshape(-1, 3), node, force[0])
            self.error = None
        except BaseException as error:  # noqa: BLE001 - nothing may pass through compiled code; it is raised afterwards
            self.error = error
            out.fill(np.nan)

    def couples(
        self, t: float, x: NDArray[np.float64], v: NDArray[np.float64], given: NDArray[np.float64] | None = None
    ) -> NDArray[np.float64]:
        """Couples (bearings, 3), N m, on the members of bearings at t, x, v (3 n,); given (3 n,) : the force of the user.

        Raises
        ------
        AnalysisError : the couples do not settle.
        """
        system, seats = self._system, seats_of(self._system)
        rate = relative_rates(system, x.reshape(1, -1, 3), v.reshape(1, -1, 3))[0]
        size = np.linalg.norm(rate, axis=1)
        way = np.divide(rate, size[:, None], out=np.zeros_like(rate), where=size[:, None] > 0)
        most = np.array([seat.arm for seat in seats]) * np.tanh(size / np.array([seat.slip for seat in seats]))
        if not most.any():
            return np.zeros_like(way)
        base, change = self._reactions(t, x.copy(), v.copy(), way, self._users.at(t, x, v) if given is None else given)
        amount, first = np.zeros(len(seats)), 0.0
        for _ in range(MOST):
            found = -most * np.linalg.norm(base + np.einsum("j,jkc->kc", amount, change), axis=1)
            moved, amount = np.abs(found - amount).max(), found
            first = first or moved
            if moved <= CLOSE * np.abs(amount).max():
                return np.asarray(amount[:, None] * way)
            if not moved <= 1e6 * first:
                break
        raise jammed(seats[int(np.argmax(np.abs(amount)))].name)

    def _reactions(
        self, t: float, x: NDArray[np.float64], v: NDArray[np.float64], way: NDArray[np.float64], given: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """R_0 (bearings, 3), N, and its changes B (couple, bearings, 3), 1/m, by a unit couple along each way."""
        system, eq, ws, seats = self._system, self._eq, self._ws, seats_of(self._system)
        count = 1 + len(seats)
        couple = np.zeros((count, len(seats), 3))
        couple[np.arange(1, count), np.arange(len(seats))] = way
        a, N = np.zeros((count, x.size)), np.zeros((count, len(system.row_member)))
        row, f = np.empty(len(eq.row)), np.empty(x.size)
        evaluate(eq, ws, no_force, t, x, v, a[0], row)
        forces_on_nodes(eq, no_force, t, x, v, f)
        f += given
        at = np.broadcast_to(x, a.shape).copy()
        places = at.reshape(count, -1, 3)
        node, extra = couples_on_ends(system, places, couple)
        for k in range(count):
            push = f.copy()
            np.add.at(push.reshape(-1, 3), node, extra[k])
            ws.f[:] = push
            accelerate_under(eq, ws, x, v, a[k], row)
            N[k, eq.row] = row
        states = States(at, np.broadcast_to(v, a.shape).copy(), a)
        loads = case_loads(system, np.full(count, t), self._case).at(at)
        loads = with_forces(system, loads, np.broadcast_to(given, a.shape))
        solved = solved_along(system, with_friction_of(loads, node, extra), states, N)
        read = _read(system, states)
        joint = forces_of(system, read, loads, solved | {"bearing": couple}, False)[0].joint_force
        R = np.stack([joint[:, seat.member, seat.end] for seat in seats], axis=1)
        return R[0], R[1:] - R[0]


def with_forces(system: System, loads: Loads, push: NDArray[np.float64]) -> Loads:
    """The loads, with forces (times, 3 n), N, of the user as one more load at each node on which they act."""
    push = push.reshape(len(push), len(system.nodes), 3)
    nodes = np.flatnonzero(np.abs(push).max(axis=(0, 2), initial=0.0) > 0)
    return replace(
        loads,
        loads=(*loads.loads, *(f"user force on {system.nodes[i]}" for i in nodes)),
        node=np.concatenate([loads.node, nodes]),
        force=np.concatenate([loads.force, push[:, nodes]], axis=1),
    )


def _read(system: System, states: States) -> Read:
    """Lengths and drives of states."""
    x, v, a = (y.reshape(len(y), -1, 3) for y in states)
    _, L, u = ends_of(system, x)
    rate = np.einsum("tmc,tmc->tm", v[:, system.q] - v[:, system.p], u)
    value, speed, _ = drive_values(system, x, v, a)
    return Read(L, rate, value, speed)
