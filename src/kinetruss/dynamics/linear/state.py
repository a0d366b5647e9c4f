"""The state at which a structure is linearised: positions, velocities, accelerations and forces."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kinematics.given import check_motion
from kinetruss.mechanics import compile, constraint_jacobian, ends_of
from kinetruss.mechanics.assembly import (
    Balance,
    balance_of,
    balanced_rows,
    bar_laws,
    mass_matrix,
    measure_forces,
    row_tensions,
    spring_forces,
    turning_inertia,
    turning_members,
)
from kinetruss.mechanics.beams import damping_forces
from kinetruss.mechanics.configuration import number_of, positions_of, vectors_of
from kinetruss.mechanics.constraints import held_rows
from kinetruss.model import AngleDrive, GivenForce, LengthDrive, Model, turns
from kinetruss.results import Motion, Result, Simulation

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["State", "drive_forces", "moving_forces", "state_at"]

AT_REST = 1e-8
"""Residual forces below this fraction of the largest force count as zero."""


@dataclass(frozen=True, kw_only=True, eq=False)
class State:
    """balance : forces, with drives of given force released. x, v, a (n, 3); N (rows,) of its rows. left : largest residual
    force at rest as a fraction of the largest force. still : True in equilibrium at rest. springs : stiffness of drives that
    give way, by the index of their member, N/m.
    """

    balance: Balance
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    N: NDArray[np.float64]
    left: float
    still: bool
    springs: Mapping[int, float] = field(default_factory=dict)


def state_at(model: Model, state: Any, load_case: str | None, tasks: Mapping[str, Any] | None, time: float | None) -> State:
    """The state of a model: its own configuration, positions, (positions, velocities), an Equilibrium, a Motion at a time.

    Raises
    ------
    InputError : a wrong shape, a motion without its time, velocities that rigid bars or held drives do not allow.
    """
    system = compile(model)
    given, load_time = None, 0.0 if time is None else number_of(time, "time", "s")
    if isinstance(state, Simulation):
        state = state.motion
    if isinstance(state, Motion):
        x, v, given = _sample(system, state, time)
    elif isinstance(state, Result):
        if state.data.attrs.get("kind") != "equilibrium":
            raise InputError(f"{type(state).__name__} is not a state. Give an Equilibrium, positions, or a Motion and a time.")
        x, v = positions_of(system, state.data["position"].values), np.zeros_like(system.x0)
        tasks, load_case, load_time = _as_found(system, state, load_case, tasks, time)
    else:
        x, v = _pair(system, state)
    balance = balance_of(system, load_case, tasks, load_time)
    f = moving_forces(balance, x, v)
    if given is not None:
        N = balanced_rows(balance, x, f - mass_matrix(system, x) @ given.reshape(-1))
        return State(balance=balance, x=x, v=v, a=given, N=N, left=0.0, still=False)
    _check_rates(balance.system, x, v)
    N = balanced_rows(balance, x, f)
    free = balance.system.free
    out = np.abs((f - constraint_jacobian(balance.system, x).T @ N)[free] if len(N) else f[free]).max(initial=0.0)
    size = max(float(np.abs(part).max(initial=0.0)) for part in (balance.force, N, balance.tension(x), balance.pushing(x)))
    left = float(out) / size if size else 0.0
    still = left <= AT_REST and not np.any(v)
    a = np.zeros_like(x)
    if not still:
        a, N = _accelerations(balance, x, v, f)
    return State(balance=balance, x=x, v=v, a=a, N=N, left=left, still=still)


def moving_forces(balance: Balance, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces on the nodes (3 n,), N, without constraint forces and M a; with dampers and convective forces of rods."""
    system = balance.system
    found = balance.applied(x).reshape(-1, 3)
    if not np.any(v):
        return found.reshape(-1)
    if system.continua is not None and (beams := system.continua.beams) is not None and beams.damping.any():
        found += damping_forces(beams, x[None], v[None])[0]
    if system.springs:
        found += (spring_forces(system, x, v) - spring_forces(system, x)).reshape(-1, 3)
    _, L, u = ends_of(system, x)
    Ld = np.einsum("mc,mc->m", u, v[system.q] - v[system.p])
    more = (bar_laws(system, L, Ld).tension - bar_laws(system, L).tension)[:, None] * u
    np.add.at(found, system.p, more)
    np.subtract.at(found, system.q, more)
    if len(turning := turning_members(system)):
        ends = np.stack([system.p[turning], system.q[turning]], axis=1)
        np.subtract.at(found, ends, turning_inertia(system, turning, x[ends], v[ends], np.zeros((*ends.shape, 3)), np.zeros(3)))
    return found.reshape(-1)


def drive_forces(state: State) -> NDArray[np.float64]:
    """Force or torque of every drive in a state, (drives,) N or N m."""
    balance, system = state.balance, state.balance.system
    tension, torque = row_tensions(system, state.x, state.N)
    if yielding := list(state.springs):
        tension[yielding] = bar_laws(system, ends_of(system, state.x, yielding)[1], member=yielding).tension
    found, on_measures = np.zeros(len(system.drives)), measure_forces(system, state.N)
    left = mass_matrix(system, state.x) @ state.a.reshape(-1) - moving_forces(balance, state.x, state.v)
    if len(state.N):
        left = left + constraint_jacobian(system, state.x).T @ state.N
    index = {name: i for i, name in enumerate(system.members)}
    for d, drive in enumerate(system.model.all_drives.values()):
        if drive.kind == "coordinate":
            flat = 3 * system.node_index(drive.node) + "xyz".index(drive.axis)
            found[d] = left[flat] if system.prescribed[flat] else balance.force[flat]
        elif (m := system.drive_measure[d]) >= 0:
            found[d] = balance.turn[m] - on_measures[m]
        elif isinstance(drive, (LengthDrive, AngleDrive)):
            i = index[drive.bar]
            found[d] = balance.torque[i] + torque[i] if drive.kind == "angle" else balance.push[i] - tension[i]
    return found


def _accelerations(
    balance: Balance, x: NDArray[np.float64], v: NDArray[np.float64], f: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """a (n, 3) and row forces of M a + J^T N = f, J a = -J' v; held drives and supports do not accelerate."""
    system = balance.system
    free = system.free
    derived = held_rows(system, x, v)
    J = derived.g[0][:, free].toarray()
    M = mass_matrix(system, x)[free][:, free].toarray()
    gamma = -derived.g[1] @ v.reshape(-1)
    rows = len(J)
    size = np.abs(M).max(initial=0.0) or 1.0
    matrix = np.block([[M / size, J.T], [J, np.zeros((rows, rows))]])
    found, *_ = np.linalg.lstsq(matrix, np.concatenate([f[free] / size, gamma]), rcond=1e-13)
    a = np.zeros(x.size)
    a[free] = found[: len(free)]
    N = balanced_rows(balance, x, f - mass_matrix(system, x) @ a)
    return a.reshape(-1, 3), N


def _check_rates(system: System, x: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Refuse velocities that change rigid lengths, held drives or supports."""
    if not np.any(v):
        return
    size = float(np.abs(v).max())
    held = np.abs(v.reshape(-1))[system.prescribed].max(initial=0.0)
    derived = held_rows(system, x)
    rates = np.abs(derived.g[0] @ v.reshape(-1)) if derived.g[0].shape[0] else np.zeros(1)
    if max(held, rates.max()) > 1e-6 * size:
        name = system.members[system.row_member[rates.argmax()]] if rates.max() > held else "a support"
        raise InputError(
            f"The velocities change the length of {name!r}, which is held. Give velocities that the structure allows, or let "
            "its drive go in tasks."
        )


def _pair(system: System, state: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions and velocities (n, 3) from positions, or from (positions, velocities)."""
    if state is None:
        return system.x0.copy(), np.zeros_like(system.x0)
    if _is_pair(state):
        return positions_of(system, state[0]), vectors_of(system, state[1], "velocity", "m/s")
    return positions_of(system, state), np.zeros_like(system.x0)


def _is_pair(state: Any) -> bool:
    """True for (positions, velocities); False for a tuple of the positions of two nodes."""
    try:
        return isinstance(state, tuple) and len(state) == 2 and np.ndim(state[0]) == 2
    except ValueError:  # rows of different lengths, which are refused as positions
        return True


def _sample(system: System, motion: Motion, time: float | None) -> tuple[NDArray[np.float64], ...]:
    """x, v, a (n, 3) of a motion at the sample nearest to a time."""
    check_motion(system, motion)
    if time is None and motion.data.sizes["time"] != 1:
        raise InputError("The motion has more than one sample. Give time=..., s.")
    here = motion.data.isel(time=0) if time is None else motion.data.sel(time=time, method="nearest")
    units = {"position": "m", "velocity": "m/s", "acceleration": "m/s^2"}
    return tuple(vectors_of(system, here[name].values, name, unit) for name, unit in units.items())


def _as_found(
    system: System, found: Result, load_case: str | None, tasks: Mapping[str, Any] | None, time: float | None
) -> tuple[Mapping[str, Any], str | None, float]:
    """Tasks, load case and time of an equilibrium, unless they are given."""
    attrs = found.data.attrs
    own = {}
    for name in attrs.get("let_go", ()):
        value = float(found.data["drive_force"].sel(drive=name))
        own[name] = GivenForce(torque=value) if turns(system.model.all_drives[name]) else GivenForce(value)
    if load_case is None and attrs.get("load_case") in system.model.load_cases:
        load_case = str(attrs["load_case"])
    load_time = float(attrs.get("load_time", 0.0)) if time is None else number_of(time, "time", "s")
    return own if tasks is None else tasks, load_case, load_time
