"""Forces on the nodes of a structure at rest: loads, weights, laws of bars and springs, drives with a given force."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.elements.local_axes import turned
from kinetruss.errors import InputError, ModelError
from kinetruss.kernels.structure.structure import ANGLE, LENGTH
from kinetruss.mechanics.arrangement import rearrange
from kinetruss.mechanics.coordinates import released
from kinetruss.mechanics.elements import element_change, element_forces, named_laws
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.matrices import bar_laws, mass_matrix, tangents, turning_inertia
from kinetruss.mechanics.measures import measure_gradients, measure_hessian, measured
from kinetruss.mechanics.row_gradients import (
    RANK_TOLERANCE,
    constraint_jacobian,
    ends_of,
    row_scales,
)
from kinetruss.mechanics.rows import factors_of
from kinetruss.mechanics.system import System
from kinetruss.model import Free, GivenForce, Hold, Model, task_faults

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.loads.load import UnitLoad


@dataclass(frozen=True, kw_only=True, eq=False)
class Balance:
    """Forces at rest.

    system : without the rows of released drives. name : of the load case.
    force (3 n,) N: loads and weights that keep their direction. gravity (3,) m/s^2.
    followers : loads that turn with bodies, with their amounts.
    push (m,) N, torque (m,) N m: given forces of drives; positive lengthens or turns counter-clockwise.
    turn (measures,) N m: of drives of hinges and of angles in space.
    loads : all of them by name.
    """

    system: System
    name: str
    force: NDArray[np.float64]
    gravity: NDArray[np.float64]
    push: NDArray[np.float64]
    torque: NDArray[np.float64]
    turn: NDArray[np.float64]
    loads: Loads
    followers: tuple[tuple[UnitLoad, float], ...] = ()

    def tension(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Tensions (m,), N, by constitutive laws and given drive forces at positions x (n, 3)."""
        _, L, _ = ends_of(self.system, x)
        return bar_laws(self.system, L).tension - self.push

    def applied(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Forces on the nodes (3 n,), N, without the constraint forces."""
        system = self.system
        _, L, u = ends_of(system, x)
        # N u of laws and given thrusts
        tensions = (bar_laws(system, L).tension - self.push)[:, None] * u
        if np.any(self.torque):
            # T n/L of given torques
            tensions -= (self.torque / L)[:, None] * turned(u)
        found = self.force.reshape(-1, 3).copy()
        np.add.at(found, system.p, tensions)
        np.subtract.at(found, system.q, tensions)
        rods = np.flatnonzero(system.two_rods)
        # weight of active members: it depends on their lengths
        if len(rods) and np.any(self.gravity):
            ends = np.stack([system.p[rods], system.q[rods]], axis=1)
            still = np.zeros((*ends.shape, 3))
            np.subtract.at(found, ends, turning_inertia(system, rods, x[ends], still, still, self.gravity))
        flat = found.reshape(-1)
        # T dq/dx of torques on measures
        for m in np.flatnonzero(self.turn):
            flat += self.turn[m] * measure_gradients(system, m, x[None])[0]
        flat += element_forces(system, x)
        return flat + self.following(x)

    def pushing(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """The force of each element on a coordinate on nodes (force_elements,), N, about, at positions x (n, 3)."""
        if not self.system.force_elements:
            return np.zeros(0)
        return np.asarray(named_laws(self.system, x)[:, 0] / self.system.measure_scale[self.system.force_element_measure])

    def following(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Forces on the nodes (3 n,), N, of loads that turn with bodies."""
        found = np.zeros_like(x)
        for one, amount in self.followers:
            np.add.at(found, one.nodes, amount * one.forces(x[one.nodes]))
        return found.reshape(-1)

    def following_stiffness(self, x: NDArray[np.float64]) -> Any:
        """Minus the derivative of `following` (3 n, 3 n), N/m; not symmetric."""
        rows, columns, values = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)], [np.zeros(0)]
        for one, amount in self.followers:
            flat = (3 * one.nodes[:, None] + np.arange(3)).reshape(-1)
            rows.append(np.repeat(flat, len(flat)))
            columns.append(np.tile(flat, len(flat)))
            values.append(-amount * one.tangent(x[one.nodes]).reshape(-1))
        at = np.concatenate(rows), np.concatenate(columns)
        return csr_array((np.concatenate(values), at), shape=(x.size, x.size))

    def energy_change(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
        """Potential energy at y minus that at x, (n, 3) m each, J: work against all forces but those of constraints."""
        system = self.system
        (_, L0, u0), (_, L1, u1) = ends_of(system, x), ends_of(system, y)
        # strain energy
        change = float(np.sum(bar_laws(system, L1).energy - bar_laws(system, L0).energy))
        change += element_change(system, x, y)
        # work of loads that keep their direction, and of given thrusts
        change -= float(self.force @ (y - x).reshape(-1)) + float(self.push @ (L1 - L0))
        if np.any(self.torque):
            # work of given torques: T times the change of the angle
            turn = np.arctan2(u0[:, 0] * u1[:, 1] - u0[:, 1] * u1[:, 0], np.sum(u0 * u1, axis=1))
            change -= float(self.torque @ turn)
        for m in np.flatnonzero(self.turn):
            before, after = measured(system, m, np.stack([x, y]))[:, 0]
            change -= float(self.turn[m] * (after - before))
        rods, two = system.rods, system.two_rods
        if two.any() and np.any(self.gravity):
            # weight of active members: first moments move with the ends and turn with the direction
            arm = 0.5 * (rods[:, 0] * rods[:, 1] - rods[:, 3] * rods[:, 4])
            moved = (rods[:, [0]] * (y - x)[system.p] + rods[:, [3]] * (y - x)[system.q] + arm[:, None] * (u1 - u0))[two]
            change -= float(np.sum(moved @ self.gravity))
        if self.followers:  # followers have no potential: their work along the straight line from x to y
            change -= 0.5 * float((self.following(x) + self.following(y)) @ (y - x).reshape(-1))
        return change

    def stiffness(self, x: NDArray[np.float64], N: NDArray[np.float64]) -> Any:
        """K (3 n, 3 n), N/m, at positions x and row forces N (rows,)."""
        return self.tangents(x, N, self.tension(x))[0]

    def tangents(
        self,
        x: NDArray[np.float64],
        N: NDArray[np.float64],
        tensions: NDArray[np.float64],
        v: NDArray[np.float64] | None = None,
        a: NDArray[np.float64] | None = None,
    ) -> tuple[Any, Any]:
        """K and C (3 n, 3 n), N/m and N s/m, along a motion v, a (n, 3); tension (m,), N: by laws and given forces."""
        tension, torque = row_tensions(self.system, x, N)
        K, C = tangents(self.system, x, tensions + tension, self.torque + torque, self.gravity, v, a)
        # T d^2q/dx^2 of measures
        if np.any(back := measure_forces(self.system, N) - self.turn):
            K = K + sum_stiffness(self.system, x, back)
        return K + self.following_stiffness(x) if self.followers else K, C

    def with_share(self, share: float) -> Balance:
        """A copy with a share of the loads that turn with bodies."""
        return replace(self, followers=tuple((one, share * amount) for one, amount in self.followers))

    def with_force(self, force: NDArray[np.float64]) -> Balance:
        """A copy with other forces of constant direction (3 n,), N."""
        return replace(self, force=force)


def measure_forces(system: System, N: NDArray[np.float64]) -> NDArray[np.float64]:
    """Generalised force on each measure (measures,) by the constraints that prescribe it, from row forces N (rows,)."""
    found, held = np.zeros(len(system.measures)), system.row_measure[system.sums]
    found[held] = system.measure_scale[held] * N[system.sums]
    return found


def sum_stiffness(system: System, x: NDArray[np.float64], tensions: NDArray[np.float64]) -> Any:
    """K (3 n, 3 n) of generalised forces on measures (measures,): each force times the Hessian of its measure."""
    rows: list[Any] = [np.zeros(0, np.int64)]
    columns: list[Any] = [np.zeros(0, np.int64)]
    values: list[Any] = [np.zeros(0)]
    # force of each measure times its Hessian
    for m in np.flatnonzero(tensions):
        flats, H = measure_hessian(system, m, x)
        rows.append(np.repeat(flats, len(flats)))
        columns.append(np.tile(flats, len(flats)))
        values.append(tensions[m] * H.reshape(-1))
    at = (np.concatenate(rows), np.concatenate(columns))
    return csr_array(coo_array((np.concatenate(values), at), shape=(x.size, x.size)))


def row_tensions(
    system: System, x: NDArray[np.float64], N: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Tension (m,) N and applied torque (m,) N m of members from row forces N (rows,)."""
    angle, length = system.row_kind == ANGLE, system.row_kind == LENGTH
    tension, torque = np.zeros(len(system.members)), np.zeros(len(system.members))
    # N of lengths; the row force of an angle is minus the torque over the length
    np.add.at(tension, system.row_member[length], N[length])
    np.subtract.at(torque, system.row_member[angle], N[angle] * row_scales(system, x, angle))
    return tension, torque


def balance_of(
    system: System, load_case: str | None = None, tasks: Mapping[str, Any] | None = None, time: float = 0.0
) -> Balance:
    """The forces of a load case on a structure whose drives have tasks: `Hold` (default), `Free` or `GivenForce`.

    Raises
    ------
    InputError : an unknown load case or drive, a task that has no meaning at rest.
    """
    given_forces = _given_forces(system.given, tasks or {}, time)
    held = released(system, tuple(given_forces))
    loads = case_loads(system, np.array([time]), load_case)
    push, torque = np.zeros(len(system.members)), np.zeros(len(system.members))
    turn = np.zeros(len(system.measures))
    force = _constant(system, loads)
    # given force of each drive: on a coordinate, a thrust, a torque, or a torque on a measure
    for drive, value in given_forces.items():
        d = system.drives.index(drive)
        for flat in system.coordinate_drive[system.coordinate_drive[:, 1] == d, 0]:
            force[flat] += value
        for r in np.flatnonzero(system.row_drive == d):
            if (m := system.row_measure[r]) >= 0:
                turn[m] += value
                continue
            (torque if system.row_kind[r] == ANGLE else push)[system.row_member[r]] += value
    return Balance(
        system=held,
        name=loads.name,
        force=force,
        gravity=loads.gravity,
        push=push,
        torque=torque,
        turn=turn,
        loads=loads,
        followers=tuple((one, float(amount[0])) for _, one, amount in loads.unit_loads if not one.constant),
    )


def balanced_rows(balance: Balance, x: NDArray[np.float64], left: NDArray[np.float64]) -> NDArray[np.float64]:
    """Row forces N (rows,) that balance the forces `left` (3 n,) best; redundant ones as in inverse dynamics."""
    system = balance.system
    if not len(system.row_member):
        return np.zeros(0)
    J = constraint_jacobian(system, x)[:, system.free]
    if J.shape[0] == J.shape[1] and (N := _determinate(J, left[system.free])) is not None:
        return N
    # least squares on sqrt(w) N: least sum w N^2 among the forces that balance best
    scale = np.sqrt(rearrange(system, x, None).weight)
    found, *_ = np.linalg.lstsq(J.toarray().T / scale, left[system.free], rcond=RANK_TOLERANCE)
    return np.asarray(found / scale)


def _determinate(J: Any, left: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Row forces of a square, regular J, or None."""
    factors = factors_of(J.T)
    if factors is None:
        return None
    N = factors.solve(left)
    N += factors.solve(left - J.T @ N)
    size = float(np.abs(left).max(initial=0.0))
    regular = float(np.abs(factors.U.diagonal()).min(initial=1.0)) > RANK_TOLERANCE
    return np.asarray(N) if regular and np.abs(left - J.T @ N).max(initial=0.0) <= RANK_TOLERANCE * size else None


def _given_forces(model: Model, tasks: Mapping[str, Any], time: float) -> dict[str, float]:
    """Forces of the drives that are not held, N or N m."""
    if found := list(task_faults(model, tasks, ("tasks",))):
        raise ModelError(found)
    given_forces = {}
    for name, task in tasks.items():
        if isinstance(task, Hold):
            continue
        if isinstance(task, Free):
            given_forces[name] = 0.0
        elif isinstance(task, GivenForce):
            if task.turns and model.all_drives[name].kind == "length":
                raise InputError(
                    f"The task of drive {name!r} is a torque of its motor, which friction holds at rest. Give a force."
                )
            constant = task.constant
            given_forces[name] = float(np.interp(time, task.times or (), task.table or ())) if constant is None else constant
        else:
            raise InputError(
                f"The task of drive {name!r} is {type(task).__name__}, which has no meaning at rest. Give kt.Hold(), kt.Free() "
                "or kt.GivenForce(...)."
            )
    return given_forces


def _constant(system: System, loads: Loads) -> NDArray[np.float64]:
    """Loads, lumped masses and weights of bars (not active members), (3 n,) N."""
    bars = replace(system, rods=np.where(system.two_rods[:, None], 0.0, system.rods), lump=np.zeros_like(system.lump))
    force = (mass_matrix(bars, system.x0) @ np.tile(loads.gravity, len(system.nodes))).reshape(-1, 3)
    force += system.lump[:, None] * loads.lump_gravity
    np.add.at(force, loads.node, loads.force[0])
    for _, one, amount in loads.unit_loads:
        if one.constant:
            np.add.at(force, one.nodes, amount[0] * one.forces(np.zeros((len(one.nodes), 3))))
    return np.asarray(force.reshape(-1))
