"""Single poses: the drives that meet a task, or come nearest to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.errors import InputError
from kinetruss.kinematics.objectives.knots import KNOTTED, best_state
from kinetruss.kinematics.targets.along import asked_for, cannot, choice_of, divided, nearest_text
from kinetruss.kinematics.targets.courses import at_values, parameters_of
from kinetruss.kinematics.targets.inverse import task_of
from kinetruss.kinematics.targets.solve import MET, Problem, State, problem
from kinetruss.kinematics.targets.starts import STARTS
from kinetruss.limits import whole
from kinetruss.mechanics import compile
from kinetruss.model import Model, nearest
from kinetruss.results import variable
from kinetruss.results.records import drive_unit, unit_along

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["reach"]


def reach(
    model: Model, targets: Any, values: Mapping[str, ArrayLike] | None = None, *, onward: bool = False, starts: int = STARTS
) -> xr.Dataset:
    """Drives and positions for single poses of a task: exact where it can be met, else the nearest that is found.

    Parameters
    ----------
    targets : a task, several of them, or a trajectory, as in `inverse`; of its moves the end counts.
    values : coordinate of the task -> (poses,), m or rad: these poses instead; coordinates not named stay at the start.
    onward : start each pose from the one before, not from the model's own configuration.
    starts : places from which a pose that is not met is sought, at most: the given one, the model's own, a spread of drives
        over their strokes (without limits: about the start) and some near by; the same in every call.

    Returns
    -------
    Dataset over `pose`: ``drive_position`` (pose, drive) m or rad, ``position`` (pose, node, axis) m, ``asked`` and ``found``
    (pose, coordinate), ``miss`` (pose) m (angles times the shortest bar), ``reached`` (pose), ``starts`` (pose): how many
    were used, ``same`` (pose): how many of them came as near as the best, ``message`` (pose): empty, or what the nearest
    pose has.

    Raises
    ------
    ModelError, InputError : unknown names, values of different lengths, fewer than one start.

    Notes
    -----
    Damped least squares (Levenberg, 1944; Marquardt, 1963) within the strokes, then the drives of least objective on the
    tasks' surface. The nearest pose is the best of some starts, by the sum of squares of the misses (lengths
    in m, angles times the shortest bar); every start leads to a local minimum, and no other one is excluded.

    >>> import kinetruss as kt
    >>> bay = kt.library.vgt.double_octahedral()
    >>> top = kt.Positioning(node="N8", moves={"z": 0.95}, free=["x", "y"])
    >>> round(float(kt.kinematics.reach(bay, top).position.sel(node="N8", axis="z").values[0]), 9)
    0.95
    """
    starts = whole(starts, "starts", least=1)
    system = compile(model)
    task = task_of(system, targets, None)
    choice = choice_of(task)
    given = problem(system, divided(system, task)[0], choice)
    start = given.tasks.start(given.begin.x)
    names = [one.name for one in given.tasks.asked]
    if values is None:
        parameters = parameters_of(given.tasks, start, np.array([task.duration]))[0]
    else:
        parameters = at_values(given.tasks, _table(names, start, values))
    states, state = [], given.begin
    for row in parameters:
        found = given.reach(row, state, starts=starts)
        if choice.objective in KNOTTED and found.far <= MET * given.scale:
            found = best_state(given, row, found, choice.objective)
        states.append(found)
        state = found if onward else given.begin
    return _dataset(given, names, parameters, states)


def _table(names: list[str], start: Any, values: Mapping[str, ArrayLike]) -> Any:
    """Values (poses, asked) from given columns."""
    for name in values:
        if name not in names:
            raise InputError(f"The task has no coordinate {name!r}. {nearest(name, names)} It has: {', '.join(names)}.")
    columns = {name: np.atleast_1d(array_of(value, name, {}, {"poses": None})) for name, value in values.items()}
    if len({len(one) for one in columns.values()}) > 1:
        raise InputError(
            f"values have different lengths: {', '.join(f'{k} {len(v)}' for k, v in columns.items())}. Give as many."
        )
    count = len(next(iter(columns.values()))) if columns else 1
    table = np.tile(start, (count, 1))
    for name, column in columns.items():
        table[:, names.index(name)] = column
    return table


def _dataset(given: Problem, names: list[str], parameters: Any, states: list[State]) -> xr.Dataset:
    system, count = given.system, len(states)
    x = np.stack([one.x for one in states]).reshape(count, len(system.nodes), 3)[:, :, : system.dim]
    far = np.array([one.far for one in states])
    reached = far <= MET * given.scale
    said = [""] * count
    for k in np.flatnonzero(~reached):
        lacking = cannot(given, given.linear(given.begin, parameters[k])[1])
        said[k] = f"{lacking} {nearest_text(given, states[k], parameters[k])}".strip()
    unit, named = drive_unit(system)
    asked, also = unit_along("coordinate", [given.tasks.unit(one) for one in given.tasks.asked], "coordinate_unit", "m")
    data = {
        "drive_position": variable(("pose", "drive"), np.stack([one.q for one in states]), unit, "drive coordinate"),
        "position": variable(("pose", "node", "axis"), x, "m", "node position"),
        "asked": variable(("pose", "coordinate"), np.stack([asked_for(given, row) for row in parameters]), asked, "asked for"),
        "found": variable(("pose", "coordinate"), given.tasks.read(np.stack([one.x for one in states])), asked, "found"),
        "miss": variable(("pose",), far, "m", "largest miss of a coordinate"),
        "reached": ("pose", reached),
        "starts": ("pose", np.array([one.starts for one in states])),
        "same": ("pose", np.array([one.same for one in states])),
        "message": ("pose", said),
    }
    coords = {"drive": list(system.drives), "node": list(system.nodes), "axis": list("xyz"[: system.dim]), "coordinate": names}
    return xr.Dataset(data, coords=coords | named | also, attrs={"kind": "reach"})
