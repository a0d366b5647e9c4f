"""The equations of motion of a compiled model as arrays: free and prescribed coordinates, rows, forces."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.dynamics.motion_tables import Table, drive_tables, stack, table_of
from kinetruss.elements.kinds import load_arrays
from kinetruss.elements.loads.load import Turning
from kinetruss.errors import InputError
from kinetruss.kernels.solve.kkt import factor, prepare_rows, project
from kinetruss.kernels.structure.equations import (
    ANGLE_FORCE,
    COORDINATE_FORCE,
    LENGTH_FORCE,
    SPARSE,
    SUM_FORCE,
    Equations,
    Workspace,
)
from kinetruss.kernels.structure.sums import of_equations
from kinetruss.kinematics.time_tables import check_support
from kinetruss.mechanics import System
from kinetruss.mechanics.coordinates import released
from kinetruss.mechanics.loads import case_loads, history_of, unit_loads_of
from kinetruss.mechanics.solvers import mark_dropped, solver_arrays, workspace_for
from kinetruss.mechanics.tables import pair_weights, structure_arrays
from kinetruss.model import (
    TRAJECTORY_TASKS,
    AngleDrive,
    CoordinateDrive,
    Free,
    GivenForce,
    Hold,
    LengthDrive,
    LoadCase,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray


NEARBY = 1e-3
"""Distance from the start at which redundant rows are checked, as a fraction of the shortest bar."""


def equations(
    system: System,
    load_case: str | None = None,
    tasks: Mapping[str, Any] | None = None,
    trajectory: Any = None,
    solver: str = "auto",
    t_end: float = 1.0,
) -> tuple[Equations, Workspace]:
    """Arrays of M(x) a + J^T N = f(t, x, v), J a = gamma, and the workspace to solve them.

    Parameters
    ----------
    load_case : None takes all loads with factor 1. tasks : what each drive does; a drive without one follows `trajectory`
        where that moves it, else it is held at its start. t_end : s, end of the tables of motions without a closed form.
    solver : "auto", "dense", "sparse" or "sweep".

    Returns
    -------
    Equations, whose rows are ``system.row_*[eq.row]`` (rows of released drives are left out), and a Workspace.
    """
    tasks = dict(tasks or {})
    reduced = released(system, not_prescribed(system, tasks))
    fields, column = _fields(system, reduced, load_case, tasks, _motions(system, tasks, trajectory, t_end))
    eq, ws = _assembled(system, reduced, fields, column, solver, False)
    if eq.solver == SPARSE and _some_dropped(system, eq, ws):
        eq, ws = _assembled(system, reduced, fields, column, "sparse", True)
        _some_dropped(system, eq, ws)
    return eq, ws


def with_numbers(
    eq: Equations, system: System, load_case: str | None, tasks: Mapping[str, Any], trajectory: Any, t_end: float
) -> Equations:
    """The same equations, made as by `equations`, with the numbers of another system; for all but their solver, which keeps
    its own.
    """
    reduced = released(system, not_prescribed(system, tasks))
    fields, _ = _fields(system, reduced, load_case, tasks, _motions(system, tasks, trajectory, t_end))
    return eq.with_(**(fields | _sums(system, eq.row, fields) | {"value": _values(system, eq.row)}))


def _fields(
    system: System,
    reduced: System,
    load_case: str | None,
    tasks: Mapping[str, Any],
    motions: tuple[dict[str, Table], dict[str, int]],
) -> tuple[dict[str, Any], dict[str, int]]:
    """Masses, forces and motions; the columns of the motions by name."""
    tables, column = motions
    fields = _masses(system, load_case) | _prescribed_coordinates(reduced, column) | _forces(system, load_case, tasks)
    return fields | stack(list(tables.values())), column


def _values(system: System, row: NDArray[np.int64]) -> NDArray[np.float64]:
    """What rows hold, with those of drives as they are at the start."""
    drive, start = system.row_drive[row], np.concatenate([system.drive_start, np.zeros(1)])
    return np.where(drive < 0, system.row_value[row], start[drive])


def _some_dropped(system: System, eq: Equations, ws: Workspace) -> bool:
    """Mark rows that depend on others at the start and, if the structure can move, at a small distance from it as well."""
    x, v = system.x0.reshape(-1).copy(), np.zeros(system.x0.size)
    prepare_rows(eq, ws, 0.0, x, v)
    factor(eq, ws, x)
    if not mark_dropped(eq, ws):
        return False
    fewest, best = int(eq.redundant.sum()), x
    # from a singular position few directions can be followed; that of least weighted change, with weights in a row, is one
    ways = [system.velocity0.reshape(-1).copy(), np.random.default_rng(0).standard_normal(x.size)]
    ways += [np.equal(np.arange(x.size) % 3, axis) * 1.0 for axis in range(system.dim)]
    for v in ways:
        v[eq.local < 0] = 0.0
        project(eq, ws, 0.0, x, v, 1e-10)
        if np.abs(v).max() < 1e-6:
            continue
        y = x + NEARBY * float(np.min(ws.target[0])) * v / np.abs(v).max()
        if project(eq, ws, 0.0, y, np.zeros(y.size), 1e-10)[0]:
            factor(eq, ws, y)
            mark_dropped(eq, ws)
            if eq.redundant.sum() < fewest:
                fewest, best = int(eq.redundant.sum()), y
        factor(eq, ws, x)
    factor(eq, ws, best)
    return mark_dropped(eq, ws)


def _assembled(
    system: System, reduced: System, fields: dict[str, Any], column: dict[str, int], solver: str, shared: bool
) -> tuple[Equations, Workspace]:
    """The records for a solver."""
    solving, order = solver_arrays(reduced, fields, solver, shared=shared)
    kept = np.flatnonzero(np.isin(system.row_drive, np.unique(reduced.row_drive)))
    row = kept[order]
    free = reduced.free.astype(np.int64)
    local = np.full(system.x0.size, -1, np.int64)
    local[free] = np.arange(len(free))
    drive, member = system.row_drive[row], system.row_member[row]
    rows = {
        "free": free,
        "local": local,
        "row": row,
        "kind": system.row_kind[row].astype(np.int64),
        "A": 3 * system.p[member].astype(np.int64),
        "B": 3 * system.q[member].astype(np.int64),
        "motion": np.array([-1 if d < 0 else column.get(system.drives[d], -1) for d in drive], np.int64),
        "value": _values(system, row),
    }
    without_bearings = dict.fromkeys(("rubs", "bearing_ints", "bearing_reals", "pressed_ints", "pressed_reals"), np.zeros(0))
    eq = Equations.of(fields | solving | rows | _sums(system, row, fields) | without_bearings)
    return eq, workspace_for(eq)


def _sums(system: System, row: NDArray[np.int64], fields: dict[str, Any]) -> dict[str, Any]:
    """Rows that are sums, with their terms; after these all terms of the system, for given torques."""
    held = system.row_measure[row]
    places = np.flatnonzero(held >= 0)
    measures = held[places]
    spans = [np.arange(*system.measure_ptr[m : m + 2]) for m in measures]
    pushed = fields["force_kind"] == SUM_FORCE
    ends = np.cumsum([0, *map(len, spans)]).astype(np.int64)
    every = [np.arange(len(system.term_kind))] if pushed.any() else []
    terms = np.concatenate([*spans, *every, np.zeros(0)]).astype(np.int64)
    size = np.linalg.norm(system.x0[system.q] - system.x0[system.p], axis=1)
    return {
        "sums": of_equations.addresses() if len(places) or pushed.any() else np.zeros(0, np.int64),
        "sum_row": places,
        "sum_ptr": ends,
        "term_form": system.term_form[terms],
        "term_at": system.term_at[terms],
        "term_data": system.term_data[terms],
        "sum_scale": system.measure_scale[measures],
        "sum_period": system.measure_period[measures],
        "sum_size": np.full(len(places), size.mean() if len(size) else 1.0),
        "force_A": fields["force_A"] + pushed * ends[-1],
        "force_B": fields["force_B"] + pushed * ends[-1],
    }


def not_prescribed(system: System, tasks: Mapping[str, Any]) -> tuple[str, ...]:
    """Drives that prescribe nothing: released, under a given force, or driven by a motor."""
    keeping = (Hold, *TRAJECTORY_TASKS)
    return tuple(name for name in system.drives if name in tasks and not isinstance(tasks[name], keeping))


def _motions(
    system: System, tasks: Mapping[str, Any], trajectory: Any, t_end: float
) -> tuple[dict[str, Table], dict[str, int]]:
    """Motions of drives and of support coordinates by name, and the column of each."""
    tables = {} if trajectory is None else drive_tables(system.given, trajectory, t_end)
    for name, task in tasks.items():
        tables.pop(name, None)
        if isinstance(task, TRAJECTORY_TASKS):
            tables[name] = drive_tables(system.given, task, t_end)[name]
    for node, history in system.model.support_motion.items():
        check_support(node, history, 0.0, t_end)
        displacement = np.array(history.displacements)
        for axis in system.model.fixed[node]:
            k = "xyz".index(axis)
            start = system.x0[system.node_index(node), k]
            tables[f"{node}.{axis} support"] = table_of(np.array(history.times), start + displacement[:, k], history.shape)
    return tables, {name: k for k, name in enumerate(tables)}


def _prescribed_coordinates(system: System, column: dict[str, int]) -> dict[str, Any]:
    """Prescribed coordinates that move."""
    pairs = [(int(flat), column[system.drives[d]]) for flat, d in system.coordinate_drive if system.drives[d] in column]
    for node in system.model.support_motion:
        base = 3 * system.node_index(node)
        pairs += [(base + "xyz".index(axis), column[f"{node}.{axis} support"]) for axis in system.model.fixed[node]]
    held = np.array(pairs, np.int64).reshape(-1, 2)
    return {"held": held[:, 0].copy(), "held_motion": held[:, 1].copy()}


def _masses(system: System, load_case: str | None) -> dict[str, Any]:
    """Constant and changing masses, laws, and weight."""
    loads, found = case_loads(system, np.zeros(1), load_case, rotating=True), structure_arrays(system)
    g = loads.gravity
    constant = system.lump[:, None] * loads.lump_gravity + found["share"][:, None] * g
    weight = pair_weights(found["pair"], g)
    np.add.at(constant, found["pair_A"] // 3, weight[:, 0])
    np.add.at(constant, found["pair_B"] // 3, weight[:, 1])
    return found | {"constant": constant.reshape(-1), "gravity": g, "lump_gravity": loads.lump_gravity}


def _forces(system: System, load_case: str | None, tasks: Mapping[str, Any]) -> dict[str, Any]:
    """Nodal loads and given drive forces as tables in time; a constant force is a table of one entry."""
    found: list[tuple[int, int, int, int, Any, Any]] = []
    turning: list[Turning] = []
    for name, share in loads_of_case(system, load_case).items():
        constant, more = load_tables(system, name, share)
        found += [(-1, COORDINATE_FORCE, flat, flat, times, amounts) for flat, times, amounts in constant]
        turning += more
    for name, task in tasks.items():
        if isinstance(task, GivenForce):
            found.append((system.drives.index(name), *_target(system, name), *force_history(task)))
        elif not isinstance(task, (Free, Hold, *TRAJECTORY_TASKS)):
            raise InputError(f"task {type(task).__name__} of drive {name!r} is not simulated with the truss. Give a force.")
    columns: Any = zip(*found, strict=True) if found else ((), (), (), (), (), ())
    drive, kind, A, B, times, values = columns
    return {
        "force_kind": np.array(kind, np.int64),
        "force_A": np.array(A, np.int64),
        "force_B": np.array(B, np.int64),
        "force_drive": np.array(drive, np.int64),
        "force_ptr": np.cumsum([0, *(len(column) for column in times)]).astype(np.int64),
        "force_time": np.concatenate([*times, np.zeros(0)]).astype(float),
        "force_value": np.concatenate([*values, np.zeros(0)]).astype(float),
    } | load_arrays(turning)


def loads_of_case(system: System, load_case: str | None) -> Mapping[str, float]:
    """The loads of a load case with their factors; None takes all with factor 1."""
    case = LoadCase() if load_case is None else system.model.cases[load_case]
    return dict.fromkeys(system.model.loads, 1.0) if case.loads is None else case.loads


def force_history(task: GivenForce) -> tuple[Any, Any]:
    """Times, s, and amounts of a given force; a constant one is a table of one entry."""
    return ((0.0,), (task.constant,)) if task.times is None else (task.times, task.table)


def load_tables(system: System, name: str, share: float) -> tuple[list[tuple[int, Any, Any]], list[Turning]]:
    """A load times a share: flat coordinates, times and amounts of constant forces; else such as depend on positions."""
    found: list[tuple[int, Any, Any]] = []
    turning: list[Turning] = []
    load = system.model.loads[name]
    times = load.times or (0.0,)
    if not (units := unit_loads_of(system, name)):
        return found, turning
    for unit, amount in zip(units, share * history_of(load, np.array(times)).T, strict=True):
        if not np.any(amount):
            continue
        if not unit.constant:
            turning.append(Turning(unit, times, amount))
            continue
        for node, force in zip(unit.nodes, unit.forces(np.zeros((len(unit.nodes), 3))), strict=True):
            found += [(3 * int(node) + int(c), times, force[c] * amount) for c in np.flatnonzero(force)]
    return found, turning


def _target(system: System, name: str) -> tuple[int, int, int]:
    """Kind and coordinates of the coordinate that a drive acts on."""
    drive = system.model.all_drives[name]
    if isinstance(drive, CoordinateDrive):
        flat = 3 * system.node_index(drive.node) + "xyz".index(drive.axis)
        return COORDINATE_FORCE, flat, flat
    if (m := system.drive_measure[system.drives.index(name)]) >= 0:
        return SUM_FORCE, int(system.measure_ptr[m]), int(system.measure_ptr[m + 1])
    i = system.members.index(cast("LengthDrive | AngleDrive", drive).bar)  # all others are measured
    return ANGLE_FORCE if isinstance(drive, AngleDrive) else LENGTH_FORCE, 3 * int(system.p[i]), 3 * int(system.q[i])
