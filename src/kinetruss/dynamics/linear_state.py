"""The state at which a structure is linearised, and its inputs and outputs by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import ELASTIC, ENGINEERING, compile, constraint_jacobian, ends_of
from kinetruss.mechanics.arguments import number_of, positions_of, vectors_of
from kinetruss.mechanics.balance import Balance, balance_of, balanced_rows, measure_forces, row_tensions
from kinetruss.mechanics.coordinates import Coordinate, chosen_dofs, coordinates, derivatives_of, is_prescribed
from kinetruss.mechanics.elements import element_forces
from kinetruss.mechanics.matrices import bar_laws, mass_matrix, turning_inertia, turning_members
from kinetruss.mechanics.rows import row_derivatives
from kinetruss.model import Active, AngleDrive, GivenForce, LengthDrive, Model, nearest, turns
from kinetruss.results import Motion, Result, Simulation

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System


def compliant(state: State, dofs: str | Iterable[str] | None, free: str | Iterable[str], rigid: str | Iterable[str]) -> State:
    """The state with springs in place of the rows of held drives that have a compliance, except those named in `rigid`.

    A drive with flexibility f (m/N) is N = (l - l0)/f, with the commanded length l0 that gives the N of the state.

    Raises
    ------
    InputError : a name in `rigid` that is no drive with a compliance.
    """
    system = state.balance.system
    soft = [name for name, one in system.model.members.items() if isinstance(one, Active) and one.compliance is not None]
    stiff = [rigid] if isinstance(rigid, str) else list(rigid)
    if unknown := [name for name in stiff if name not in soft]:
        raise InputError(f"{unknown[0]!r} in rigid is no active member with a compliance. {nearest(unknown[0], soft)}".rstrip())
    if not soft:
        return state
    gone = {*stiff, *([free] if isinstance(free, str) else free), *(() if dofs is None else chosen_dofs(system, dofs)[1])}
    held = np.flatnonzero((system.row_kind == LENGTH) & (system.row_drive >= 0))
    names = [(system.members[system.row_member[r]], system.drives[system.row_drive[r]]) for r in held]
    rows = held[[member in soft and drive not in gone for member, drive in names]]
    i = system.row_member[rows]
    length = ends_of(system, state.x)[1][i]
    f = np.nan_to_num(system.compliance[i]) * length + system.yielding[i]
    kind, law, spring, natural = (one.copy() for one in (system.kind, system.law, system.spring, system.natural))
    # N = (l - l0)/f with l0 = l - N f
    kind[i], law[i], spring[i], natural[i] = ELASTIC, ENGINEERING, 1 / f, length - state.N[rows] * f
    rest = np.setdiff1d(np.arange(len(system.row_kind)), rows)
    changed = system.with_rows(rest, kind=kind, law=law, spring=spring, natural=natural)
    return replace(
        state,
        balance=replace(state.balance, system=changed),
        N=state.N[rest],
        springs={int(member): float(1 / one) for member, one in zip(i, f, strict=True)},
    )


# The state at which a structure is linearised: positions, velocities, accelerations and forces.

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
        if state.whole.attrs.get("kind") != "equilibrium":
            raise InputError(f"{type(state).__name__} is not a state. Give an Equilibrium, positions, or a Motion and a time.")
        x, v = positions_of(system, state.whole["position"].values), np.zeros_like(system.x0)
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
    found += (element_forces(system, x, v) - element_forces(system, x)).reshape(-1, 3)
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
    derived = row_derivatives(system, x, v)
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
    derived = row_derivatives(system, x)
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
    if time is None and motion.whole.sizes["time"] != 1:
        raise InputError("The motion has more than one sample. Give time=..., s.")
    here = motion.whole.isel(time=0) if time is None else motion.whole.sel(time=time, method="nearest")
    units = {"position": "m", "velocity": "m/s", "acceleration": "m/s^2"}
    return tuple(vectors_of(system, here[name].values, name, unit) for name, unit in units.items())


def _as_found(
    system: System, found: Result, load_case: str | None, tasks: Mapping[str, Any] | None, time: float | None
) -> tuple[Mapping[str, Any], str | None, float]:
    """Tasks, load case and time of an equilibrium, unless they are given."""
    attrs = found.whole.attrs
    own = {}
    for name in attrs.get("let_go", ()):
        value = float(found.whole["drive_force"].sel(drive=name))
        own[name] = GivenForce(torque=value) if turns(system.model.all_drives[name]) else GivenForce(value)
    if load_case is None and attrs.get("load_case") in system.model.cases:
        load_case = str(attrs["load_case"])
    load_time = float(attrs.get("load_time", 0.0)) if time is None else number_of(time, "time", "s")
    return own if tasks is None else tasks, load_case, load_time


# Inputs and outputs of a linearised structure, by name.

Names = str | Iterable[str] | Mapping[str, str | Mapping[str, float]]
"""Names, or labels of names, or labels of sums: {"base": {"N1.z": 1, "N2.z": 1}}."""


@dataclass(frozen=True, slots=True)
class Input:
    """A force on coordinates, the motion of prescribed ones, or the commanded length of drives that give way.

    Each has a factor; that of a commanded length is the stiffness in series, N/m: it acts as this force on its member.
    """

    label: str
    kind: Literal["force", "motion", "command"]
    parts: tuple[tuple[Coordinate, float], ...]

    @property
    def unit(self) -> str:
        """SI unit."""
        own = self.parts[0][0].unit
        return "N m" if self.kind == "force" and own == "rad" else "N" if self.kind == "force" else own

    @property
    def columns(self) -> list[tuple[str, str]]:
        """Name and unit of its columns in B: one force or commanded length, or value, rate and second rate."""
        if self.kind != "motion":
            return [(self.label, self.unit)]
        return [(self.label + mark, self.unit + per) for mark, per in (("", ""), ("'", "/s"), ("''", "/s^2"))]


@dataclass(frozen=True, slots=True)
class Output:
    """A coordinate (order 0), its rate (1) or second rate (2), or the force of a member, a drive or a support."""

    label: str
    kind: Literal["motion", "force"]
    order: int
    parts: tuple[tuple[Coordinate, float], ...]

    @property
    def unit(self) -> str:
        """SI unit."""
        own = self.parts[0][0].unit
        if self.kind == "force":
            return "N m" if own == "rad" else "N"
        return own + ("", "/s", "/s^2")[self.order]


def inputs_of(system: System, names: Names, springs: Mapping[int, float]) -> list[Input]:
    """Inputs of a system without the rows of released drives; springs : stiffness of drives that give way, by member, N/m.

    Raises
    ------
    InputError : unknown names; a sum of forces and prescribed motions, or of metres and radians.
    """
    found = []
    for label, parts in _listed(system, names):
        kinds = {_kind(system, one, springs) for one, _ in parts}
        if len(kinds) > 1 or len({one.unit for one, _ in parts}) > 1:
            raise InputError(
                f"Input {label!r} adds different quantities (forces, prescribed motions, angles). Make separate inputs of them."
            )
        if any(one.kind == "pose" for one, _ in parts):
            raise InputError(f"Input {label!r} is a pose coordinate. Name nodes, lengths or angles.")
        kind = kinds.pop()
        if kind == "command":
            parts = [(one, factor * springs[one.index]) for one, factor in parts]
        found.append(Input(label, kind, tuple(parts)))
    return found


def _kind(system: System, one: Coordinate, springs: Mapping[int, float]) -> Literal["force", "motion", "command"]:
    if one.kind == "length" and one.index in springs:
        return "command"
    return "motion" if is_prescribed(system, one) else "force"


def outputs_of(system: System, names: Names) -> list[Output]:
    """Outputs: coordinates, with ' and '' for rates, or NAME.force.

    Raises
    ------
    InputError : unknown names; a force that nothing carries.
    """
    found: list[Output] = []
    for label, given in _items(names):
        sums = [(_signal(system, text), factor) for text, factor in given]
        (ones, kind, order), factor = sums[0]
        if len(given) == 1 and label == given[0][0] and len(ones) > 1:
            mark = label[label.index(".force") :] if kind == "force" else "'" * order
            found += [Output(one.name + mark, kind, order, ((one, factor),)) for one in ones]
            continue
        parts = tuple((one, factor) for (ones, _, _), factor in sums for one in ones)
        if len({(kind, order) for (_, kind, order), _ in sums}) > 1 or len({one.unit for one, _ in parts}) > 1:
            raise InputError(
                f"Output {label!r} adds different quantities (forces, rates, angles). Make separate outputs of them."
            )
        found.append(Output(label, kind, order, parts))
    if len({one.label for one in found}) < len(found):
        raise InputError("An output is named twice. Name each once.")
    return found


def unit_load_of(system: System, one: Input, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Nodal forces (3 n,) of a unit of a force input, at positions x (n, 3)."""
    found = derivatives_of(system, [part for part, _ in one.parts], x)
    factor = np.array([factor for _, factor in one.parts])
    return np.asarray(found.g[0].T @ (factor / found.r[:, 0]))


def _signal(system: System, text: str) -> tuple[list[Coordinate], Literal["motion", "force"], int]:
    """Coordinates, kind and order of an output by name."""
    name = text.rstrip("'")
    order = len(text) - len(name)
    force = name.endswith(".force")
    if order > 2 or (force and order):
        raise InputError(f"Output {text!r}: write a coordinate, with ' for its rate or '' for its second rate, or NAME.force.")
    ones = coordinates(system, name.removesuffix(".force"))
    for one in ones:
        if force and one.kind != "length" and (one.kind == "pose" or not is_prescribed(system, one)):
            raise InputError(f"Output {text!r}: nothing carries a force there. Name a member, a support or a held drive.")
    return ones, "force" if force else "motion", order


def _items(names: Names) -> list[tuple[str, list[tuple[str, float]]]]:
    """Labels with their names and factors."""
    if isinstance(names, str):
        return [(names, [(names, 1.0)])]
    if not isinstance(names, Mapping):
        return [(name, [(name, 1.0)]) for name in names]
    found = []
    for label, given in names.items():
        parts = [(given, 1.0)] if isinstance(given, str) else [(name, float(factor)) for name, factor in given.items()]
        if not parts:
            raise InputError(f"{label!r} names nothing. Give at least one coordinate.")
        found.append((label, parts))
    return found


def _listed(system: System, names: Names) -> list[tuple[str, list[tuple[Coordinate, float]]]]:
    """Labels with their coordinates; a node without an axis stands for one entry an axis."""
    found: list[tuple[str, list[tuple[Coordinate, float]]]] = []
    for label, given in _items(names):
        ones = [(one, factor) for name, factor in given for one in coordinates(system, name)]
        if len(given) == 1 and label == given[0][0] and len(ones) > 1:
            found += [(one.name, [(one, factor)]) for one, factor in ones]
        else:
            found.append((label, ones))
    if len({label for label, _ in found}) < len(found):
        raise InputError("An input is named twice. Name each once.")
    return found
