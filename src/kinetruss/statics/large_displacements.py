"""Nonlinear equilibrium of a structure with springs, cables, loads and rigid bars."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.dynamics.actions import CarriedBy
from kinetruss.dynamics.bar_actions import mean_tension_at_rest
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.structure.structure import ANGLE, LENGTH
from kinetruss.mechanics import System, compile, constraint_jacobian, not_unique_note, rearrange
from kinetruss.mechanics.accuracy import SILENT, accuracy_note
from kinetruss.mechanics.arguments import number_of, positions_of
from kinetruss.mechanics.balance import Balance, balance_of, measure_forces, row_tensions
from kinetruss.mechanics.elements import named_motions
from kinetruss.mechanics.mode_texts import moves_text
from kinetruss.mechanics.null_space import Spaces
from kinetruss.mechanics.rotations import rotation_axes, rotations
from kinetruss.model import Model, nearest
from kinetruss.model.beam_checks import spin_note
from kinetruss.results import Column, Result, Status, provenance, variable
from kinetruss.results.user_parts import lifted_note, part_axes, reactions, rotation_columns, support_axes
from kinetruss.results.wide_tables import element_axes, element_columns, force_units, other_columns
from kinetruss.statics.saddle_point import LOOKED_AT, rows_of
from kinetruss.statics.search import CLOSED, SearchResult, closed, find_equilibrium, row_errors
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class Equilibrium(Result):
    """A structure in equilibrium: positions, forces and stiffness."""

    @property
    def stable(self) -> bool:
        """True if every small displacement that the rows allow increases the potential energy."""
        return not self.data.attrs["unstable"] and not self.data.attrs["neutral"]

    @property
    def ways_out(self) -> list[str]:
        """The unstable modes, and those without stiffness (left free), in words, as far as they were computed."""
        return list(self.data.attrs["ways_out"])


@one_thread
def equilibrium(
    model: Model,
    start: Equilibrium | ArrayLike | None = None,
    load_case: str | None = None,
    *,
    lengths: Mapping[str, float] | None = None,
    tasks: Mapping[str, Any] | None = None,
    time: float = 0.0,
    tolerance: float = 1e-13,
    max_steps: int = 500,
    raise_on_failure: bool = True,
) -> Equilibrium:
    """Nonlinear equilibrium: large displacements, rigid bars, springs by any law, cables, prestress, gravity, mechanisms.

    Parameters
    ----------
    start : (n_nodes, dim) m, or an Equilibrium: the initial guess; by default the model's own configuration. Rigid bars may
        have other lengths there.
    load_case : name; None takes all loads with factor 1. Loads in time are taken at `time`, s.
    lengths : prescribed values of rigid or driven members and of drives: lengths and node coordinates in m, angles in rad.
    tasks : drive -> ``kt.Hold()`` (default), ``kt.Free()`` or ``kt.GivenForce(...)``.
    tolerance : largest residual force, as a fraction of the largest force. max_steps : largest number of iterations.
    raise_on_failure : False gives the best state with its status instead of an error.

    Returns
    -------
    Equilibrium. ``position`` (node, axis) m; ``length`` (member) m; ``member_force`` (member) N, mean over the length, tension
    positive; ``node_rotation`` (frame, about) rad of the nodes of beams; ``reaction`` (support, axis) N on the structure;
    ``drive_force`` (drive) N or N m; ``stiffness`` (mode) N/m,
    lowest eigenvalues of the stiffness on the changes that rigid bars and held drives allow, and ``mode_shape`` (mode, node,
    axis). ``stable``, ``ways_out``; the message names unstable modes, modes without stiffness, and the rigid members whose
    force is not unique (``data.attrs["not_unique"]``; the rule of `dynamics.inverse` shares it out). `dynamics.linearise`
    takes it as its state.

    Raises
    ------
    InputError : unknown names, a wrong shape, a task without meaning at rest.
    AnalysisError : no equilibrium within max_steps, or lengths that cannot be closed; ``error.result`` is the best state.

    Notes
    -----
    f(x) = J^T N, phi(x) = 0, by Newton's method on both at once with the whole tangent (laws, N/L of all bars, rigid ones too),
    with a shift and step lengths such that the potential energy decreases, so that it converges to a stable equilibrium. It
    ends in an unstable equilibrium only if it starts in one. The sign of the reduced stiffness decides which it is.

    >>> import kinetruss as kt
    >>> hanging = kt.Model(nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}}, fixed=["A"], bars={"b": ("A", "B")},
    ...                    gravity=(0, -9.81))
    >>> found = kt.statics.equilibrium(hanging)
    >>> (found.position.sel(node="B").values.round(9) + 0.0).tolist(), round(found.member_force.item(), 9), found.stable
    ([0.0, -1.0], 19.62, True)
    """
    system = compile(model)
    load_time = number_of(time, "time", "s")
    balance = balance_of(system, load_case, tasks, load_time)
    x, wanted, error, span = begun(balance, start, lengths or {})
    if error > CLOSED * span:
        return _failed(balance, x, wanted, raise_on_failure)
    reached = find_equilibrium(balance, x, wanted, tolerance, max_steps)
    found = _record(system, balance, reached)
    found.whole.attrs["load_time"] = load_time
    if reached.good or not raise_on_failure:
        return found
    raise AnalysisError(f"{found.status.value} {found.message}", found)


def begun(
    balance: Balance, start: Any, lengths: Mapping[str, float]
) -> tuple[NDArray[np.float64], NDArray[np.float64], float, float]:
    """Positions (n, 3) near a start at which rows and coordinates have their prescribed values; these values of the rows
    (rows,); the largest remaining error and the size of the structure, m.

    Raises
    ------
    InputError : a start of another shape, or not finite; a name that prescribes nothing; a meaningless value.
    """
    system = balance.system
    x = positions_of(system, start.whole["position"].values if isinstance(start, Result) else start).copy()
    wanted, places = prescribed_values(system, x, lengths)
    x, error, span = closed(system, x, wanted, places)
    return x, wanted, error, span


def must_begin(
    balance: Balance, start: Any, lengths: Mapping[str, float]
) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """`begun`, but only with closed lengths: positions, prescribed values of rows, size.

    Raises
    ------
    AnalysisError : lengths that cannot be closed.
    """
    x, wanted, error, span = begun(balance, start, lengths)
    if error > CLOSED * span:
        _failed(balance, x, wanted, raising=True)
    return x, wanted, span


def prescribed_values(
    system: System, x: NDArray[np.float64], lengths: Mapping[str, float]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Prescribed values of rows (rows,), m or rad, and coordinates of drives (3 n,), m: those at x unless given."""
    places = x.reshape(-1).copy()
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = system.drive_start[system.row_drive[driven]]
    for name, value in lengths.items():
        rows = np.zeros(len(wanted), bool)
        if name in system.drives:
            drive = system.drives.index(name)
            rows = system.row_drive == drive
            flats = system.coordinate_drive[system.coordinate_drive[:, 1] == drive, 0]
            if len(flats):
                places[flats] = _finite(name, value)
                continue
            if not rows.any():
                raise InputError(
                    f"Drive {name!r} is released by its task, so it has no prescribed value. Leave out its task, or its value "
                    "in lengths."
                )
        elif name in system.members:
            rows = (system.row_member == system.members.index(name)) & (system.row_kind == LENGTH)
        if not rows.any():
            held = list(system.row_names)
            raise InputError(f"No held length or angle called {name!r}. {nearest(name, [*system.drives, *held])}".rstrip())
        if _finite(name, value) <= 0 and system.row_kind[rows][0] == LENGTH:
            raise InputError(f"lengths[{name!r}] is {value}. Give a length greater than 0.")
        wanted[rows] = value
    return wanted, places


def _finite(name: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise InputError(f"lengths[{name!r}] is {value!r}. Give a finite number, m (angles: rad).")
    return number


def _failed(balance: Balance, x: NDArray[np.float64], wanted: NDArray[np.float64], raising: bool) -> Equilibrium:
    """The error of lengths that cannot be closed; it names the worst row."""
    system = balance.system
    error = row_errors(system, x, wanted)
    worst = int(np.abs(error).argmax())
    message = f"{system.part_of(worst)!r} is off by {abs(error[worst]):.3g} m."
    position = variable(("node", "axis"), x[:, : system.dim], "m", "node position")
    data = xr.Dataset({"position": position}, coords=part_axes(system))
    data.attrs |= {"kind": "equilibrium", "unstable": 0, "neutral": 0, "ways_out": []}
    found = Equilibrium(
        data=data, status=Status.NOT_CONVERGED, message=message, provenance=provenance(system.given, load_case=balance.name)
    )
    if raising:
        raise AnalysisError(f"{found.status.value} {message} Give lengths that fit, or start nearer.", found)
    return found


def state_columns(
    system: System, balance: Balance, x: NDArray[np.float64], N: NDArray[np.float64]
) -> tuple[dict[str, Column], dict[str, Any]]:
    """Positions, lengths, forces and rotations at positions x (n, 3) and row forces N (rows,), and the names along axes."""
    d = x[system.q] - x[system.p]
    data = {
        "position": variable(("node", "axis"), x[:, : system.dim], "m", "node position"),
        "length": variable(("member",), np.linalg.norm(d, axis=1), "m", "member length"),
        **forces_of(system, balance, x, N),
        **rotation_columns(system, (), lambda: rotations(system, x[None])[0]),
    }
    coords = {
        **part_axes(system),
        **support_axes(system),
        "drive": list(system.drives),
        **element_axes(system),
        **force_units(system, "drive", *element_axes(system))[1],
        **rotation_axes(system),
    }
    return data, coords


def _record(system: System, balance: Balance, reached: SearchResult) -> Equilibrium:
    dim, found = system.dim, reached.stability
    shapes = found.shapes[:, :, :dim]
    if len(shapes):
        shapes = shapes / np.abs(shapes).max(axis=(1, 2), keepdims=True)
    data, coords = state_columns(system, balance, reached.x, reached.N)
    data |= {
        "stiffness": variable(("mode",), found.values, "N/m", "eigenvalues of the reduced stiffness"),
        "mode_shape": variable(("mode", "node", "axis"), shapes, "", "their shapes, largest component 1"),
    }
    ways = [moves_text(system, shape) for shape in shapes[: found.negative + found.neutral]]
    unsure = _not_unique(balance.system, reached.x)
    attrs = {
        "kind": "equilibrium",
        "load_case": balance.name,
        "not_unique": unsure,
        "unstable": found.negative,
        "neutral": found.neutral,
        "ways_out": ways,
        "residual": reached.residual,
        "steps": reached.steps,
        "let_go": [name for k, name in enumerate(system.drives) if not _holds(balance.system, k)],
    }
    return Equilibrium(
        data=xr.Dataset(data, coords=coords, attrs=attrs),
        status=Status.COMPLETED if reached.good else Status.NO_EQUILIBRIUM,
        message=" ".join(
            text
            for text in (
                _message(reached, ways, system.nodes),
                _unsure(balance, reached),
                not_unique_note(unsure),
                lifted_note(system, named_motions(system, reached.x[None]).force[0]) if system.inner.elements else "",
                spin_note(system.model),
            )
            if text
        ),
        provenance=provenance(system.given, load_case=balance.name),
    )


def _not_unique(system: System, x: NDArray[np.float64]) -> list[str]:
    """Rigid members in a state of self-stress at positions x (n, 3); in very large structures none are looked for."""
    if not len(rows_of(system, x).redundant):
        return []
    rows = np.flatnonzero(rearrange(system, x, None).not_unique)
    return system.parts_of(rows)


def _unsure(balance: Balance, reached: SearchResult) -> str:
    """The message next to a singular position if rows determine all positions: residual forces are amplified by 1/s."""
    system, count = balance.system, len(balance.system.free)
    if not reached.good or not 0 < count == len(system.row_member) <= LOOKED_AT:
        return ""
    least = Spaces(constraint_jacobian(system, reached.x)[:, system.free]).smallest
    return accuracy_note(system, reached.x, max(reached.residual, np.finfo(float).eps) / least if least else np.inf)


def _holds(system: System, drive: int) -> bool:
    return bool(np.any(system.row_drive == drive) or np.any(system.coordinate_drive[:, 1] == drive))


def forces_of(system: System, balance: Balance, x: NDArray[np.float64], N: NDArray[np.float64]) -> dict[str, Column]:
    """member_force (member), reaction (support, axis), drive_force (drive), values and forces of springs at rest."""
    held = balance.system
    tension, torque = row_tensions(held, x, N)
    on_measures = measure_forces(held, N)
    left = balance.applied(x) - constraint_jacobian(held, x).T @ N if len(N) else balance.applied(x)
    drive = np.zeros(len(system.drives))
    for r in np.flatnonzero(system.row_drive >= 0):
        i, d = system.row_member[r], system.row_drive[r]
        if (m := system.row_measure[r]) >= 0:
            drive[d] = balance.turn[m] - on_measures[m]
            continue
        drive[d] = torque[i] + balance.torque[i] if system.row_kind[r] == ANGLE else balance.push[i] - tension[i]
    fixed = system.prescribed.copy()
    for flat, d in system.coordinate_drive:
        drive[d] = -left[flat] if held.prescribed[flat] else balance.force[flat]
        fixed[flat] = False
    last = len(system.measures) - len(system.force_elements)
    own = last - len(system.model.couplings)
    mean = balance.tension(x) + tension
    support = np.where(fixed, -left, 0.0).reshape(1, -1, 3)
    supports = [system.node_index(name) for name in system.supports]
    carried = CarriedBy(mean[None], support, np.zeros((1, 0, 3)))
    mean = mean + mean_tension_at_rest(system, balance.loads.at(x[None]), x, drive, -on_measures[own:last], carried)
    units, on = force_units(system)[0], named_motions(system, x[None])
    return (
        {
            "member_force": variable(("member",), mean, "N", "mean axial force, tension positive"),
            **reactions(system, (), x, support[0, supports], -on_measures[own:last], on.force[0]),
            "drive_force": variable(("drive",), drive, units["drive"], "drive force or torque"),
        }
        | element_columns(system, (), on.force[0], on.value[0])
        | other_columns(system, (), x[None])
    )


def _message(reached: SearchResult, ways: list[str], nodes: tuple[str, ...]) -> str:
    """The message on residual forces, unstable modes and modes without stiffness."""
    if not reached.good:
        return (
            f"After {reached.steps} steps {reached.residual:.3g} of the largest force is left on {nodes[reached.worst]!r}: "
            "hold it, start nearer, or allow more steps."
        )
    found = reached.stability
    texts = []
    if reached.residual > SILENT:
        texts.append(
            f"Forces balance to {reached.residual:.1g} of the largest only: with stiffnesses as large as these, round-off of "
            "the positions allows no less."
        )
    if found.negative:
        shown = f": {'; '.join(ways[: found.negative][:3])}" if ways else ""
        texts.append(f"Unstable in {found.negative} mode{'s' if found.negative != 1 else ''}{shown}.")
    if found.neutral:
        shown = f": {'; '.join(ways[found.negative :][:3])}" if ways else ""
        texts.append(f"Left free, {found.neutral} mode{'s' if found.neutral != 1 else ''} without stiffness{shown}.")
    return " ".join(texts)
