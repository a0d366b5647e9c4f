"""Maps over coordinates of a task: what can be reached, with drives, limits and both singularity measures.

So the sweep also passes positions in which the drives do not hold the structure.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.errors import InputError, shown
from kinetruss.kernels.tasks.sweeps import Drives
from kinetruss.kinematics.inverse_motion import release, task_of
from kinetruss.kinematics.jacobians import singularity_at
from kinetruss.kinematics.motions import follow_path
from kinetruss.kinematics.objectives import KNOTTED
from kinetruss.kinematics.redundant import LEAST, Path
from kinetruss.kinematics.task_courses import at_values
from kinetruss.kinematics.task_motions import Choice, cannot, choice_of, divided
from kinetruss.kinematics.task_problem import MET, Problem, State, problem
from kinetruss.kinematics.time_tables import support_history
from kinetruss.mechanics import System, compile, jacobian as rows_of
from kinetruss.mechanics.arguments import number_of
from kinetruss.mechanics.bays import POSE
from kinetruss.mechanics.positions import drive_values
from kinetruss.model import Active, Coordinates, Model, Positioning, nearest
from kinetruss.results import variable
from kinetruss.results.wide_tables import drive_unit
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


STEPS = 25
"""Samples on the way from the start to the slice."""


@dataclass(frozen=True, eq=False)
class Slice:
    """Input of the sweep: the system, the node, two of its axes, their values u and v, and the level of all coordinates."""

    system: System
    node: str
    axes: tuple[int, int]
    u: NDArray[np.float64]
    v: NDArray[np.float64]
    level: NDArray[np.float64]
    least: float

    @cached_property
    def released(self) -> System:
        """The system with the node prescribed in place of the drives."""
        first = 3 * self.system.node_index(self.node)
        return release(self.system, tuple(range(first, first + self.system.dim)))


def places(cut: Slice) -> NDArray[np.float64]:
    """Flat positions (v, u, 3 n); NaN out of reach.

    From the start to the slice along its lines, first all rows from the line through the start, then all columns: a place is
    reached if one of the two paths leads to it by steps that Newton's method can follow.
    """
    x = np.full((len(cut.v), len(cut.u), cut.system.x0.size), np.nan)
    _sweep(cut, x, swapped=False)
    _sweep(cut, x, swapped=True)
    return x


def _sweep(cut: Slice, x: NDArray[np.float64], *, swapped: bool) -> None:
    """Fill x (along, across, 3 n): from the start to the slice, along the line through it, then all lines that cross it."""
    first, second = (cut.u, cut.v) if swapped else (cut.v, cut.u)
    one, other = cut.axes if swapped else cut.axes[::-1]
    here = cut.system.x0.reshape(-1)[cut.released.coordinate_drive[:, 0]]
    entry = cut.level.copy()
    entry[other] = np.clip(here[other], second[0], second[-1])
    entry[one] = np.clip(here[one], first[0], first[-1])
    for k, place, state in _line(cut, _way(cut, here, entry), entry, one, first):
        for j, _, flat in _line(cut, state, place, other, second):
            row, column = (j, k) if swapped else (k, j)
            if np.isnan(x[row, column, 0]):
                x[row, column] = flat


def _way(cut: Slice, here: NDArray[np.float64], entry: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Flat positions with the point at `entry`, reached from the model's configuration, or None."""
    states = _reached(cut, here + np.linspace(0, 1, STEPS)[:, None] * (entry - here), cut.system.x0.reshape(-1))
    return states[-1] if len(states) == STEPS else None


def _line(cut: Slice, state: Any, place: NDArray[np.float64], axis: int, values: NDArray[np.float64]) -> Any:
    """(index, place, flat positions) of the values on one axis that are reached from `place`, upwards and downwards."""
    if state is None:
        return
    middle = int(np.searchsorted(values, place[axis]))
    for order in (range(middle, len(values)), range(middle - 1, -1, -1)):
        way = np.repeat(place[None], len(order) + 1, axis=0)
        way[1:, axis] = values[list(order)]
        yield from zip(order, way[1:], _reached(cut, way, state)[1:], strict=False)


def _reached(cut: Slice, way: NDArray[np.float64], state: NDArray[np.float64]) -> NDArray[np.float64]:
    """Flat positions (good, 3 n) along places (k, dim) of the point, from a state at the first of them."""
    t = np.arange(len(way), dtype=float)
    still = np.zeros_like(way)
    supports = support_history(cut.released, np.zeros(len(way)))
    x, v, a = (np.ascontiguousarray(np.hstack([one, y])) for one, y in zip((way, still, still), supports, strict=True))
    path = Path(t=t, drive=(way, still, still), moving=(x, v, a))
    found = follow_path(cut.released, path, "workspace", start=state.reshape(-1, 3)[:, : cut.system.dim], least=cut.least)
    position = found.whole["position"].values
    full = np.zeros((len(position), len(cut.system.nodes), 3))
    full[:, :, : cut.system.dim] = position
    return full.reshape(len(position), -1)


# Maps over coordinates of a task: what can be reached, with drives, limits and both singularity measures.

ENTRIES = 24
"""Points of the grid that are tried as the first one."""

Cell = tuple[int, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Grid:
    """Names and places of the axes in the order of the arrays, their columns in the task, and the values of a pose's others."""

    names: tuple[str, ...]
    places: tuple[NDArray[np.float64], ...]
    columns: tuple[int, ...]
    level: NDArray[np.float64]

    @property
    def shape(self) -> Cell:
        return tuple(len(one) for one in self.places)

    def row(self, cell: Cell) -> NDArray[np.float64]:
        """Values (asked,) of the task's coordinates at a point of the grid."""
        found = self.level.copy()
        found[list(self.columns)] = [places[k] for places, k in zip(self.places, cell, strict=True)]
        return found

    def beside(self, cell: Cell) -> Iterator[Cell]:
        """The neighbours of a point along the axes."""
        for axis, count in enumerate(self.shape):
            for k in (cell[axis] - 1, cell[axis] + 1):
                if 0 <= k < count:
                    yield (*cell[:axis], k, *cell[axis + 1 :])


@dataclass(frozen=True, kw_only=True, eq=False)
class _Pose:
    """A state that meets the task, and derivatives (m, d) of the task by the drives that are not held."""

    state: State
    derivatives: NDArray[np.float64]

    @property
    def gauge(self) -> float:
        """Smallest singular value."""
        return float(np.linalg.svd(self.derivatives, compute_uv=False)[-1])

    def beyond(self, other: _Pose) -> bool:
        """Whether there is a singular pose between this one and another."""
        one, two = self.derivatives, other.derivatives
        return one.shape[0] == one.shape[1] and bool(np.linalg.det(one) * np.linalg.det(two) < 0)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Found:
    """The poses that are reached, and those that are not for a singular pose on the way."""

    poses: dict[Cell, _Pose] = field(default_factory=dict)
    singular: set[Cell] = field(default_factory=set)


@one_thread
def workspace(
    model: Model,
    point: Any,
    across: tuple[str, ArrayLike],
    along: tuple[str, ArrayLike],
    at: Mapping[str, ArrayLike] | None = None,
    *,
    limits: Mapping[str, tuple[float, float]] | None = None,
    least: float = LEAST,
) -> xr.Dataset:
    """The poses of a grid over two or three coordinates that can be reached, the drives there, and singularity measures.

    Parameters
    ----------
    point : a node (coordinates ``x``, ``y``, ``z``), a pose of the model (``bay``: ``bay.beta``, ``bay.gamma``,
        ``bay.height``), a list of coordinates (``["bay.beta", "bay.gamma"]``: the height is then free), or a task as in
        `inverse`, whose moves do not count.
    across, along : coordinate and places of the grid, e.g. ``("x", np.linspace(-0.4, 0.4, 41))``; m or rad, increasing.
    at : values of other coordinates, e.g. ``{"z": -0.8}``; by default they stay as in the model. The places of one of them make
        a third axis: ``{"bay.height": [1.0, 1.1, 1.2]}``.
    limits : drive name -> (least, largest), m or rad; `limits` of active members apply as well.
    least : least singularity measure of a reachable pose, both `serial` and `parallel`.

    Returns
    -------
    Dataset over the axes (at, along, across). ``reachable``: bool, on the assembly branch of the model's own configuration;
    ``within``: reachable and all drives within their limits; ``limit``: what stops it otherwise, ``out of reach``,
    ``singular`` (not to be reached without passing a singular pose) or the drive that is farthest beyond its limits,
    ``M7 short`` or ``M7 long``; ``drive_position`` (..., drive) m or rad, NaN elsewhere; ``stroke`` (..., drive): share of the
    way from the least to the largest limit, NaN without limits; ``serial``: smallest singular value of the derivatives of the
    task (its angles times the shortest bar) by the drives, per m or rad of these (0 at the border of the workspace);
    ``parallel``: smallest singular value
    of the prescribed rows with the drives held (0 at a pose in which the drives do not hold the structure); ``conditioning``:
    the same over their largest (1: all directions held alike). `report.map_picture` draws each of them.

    Raises
    ------
    ModelError, InputError : unknown names or axes, limits the wrong way round, a task that the drives cannot do.

    Notes
    -----
    Continued from the model's own pose to the grid, and from each pose that is reached to its neighbours. Places of a node with
    as many drives as coordinates are continued with the node prescribed, also through positions in which the drives do not hold
    the structure; of other tasks what lies behind such positions counts as out of reach. With more drives than coordinates the
    drives are those of least change from the model's own. A pose that these reach only beyond their limits counts as within if
    other drives keep them, continued in the same way; `drive_position` has these. The drive that `limit` names is one of the
    drives of least change.

    >>> import numpy as np, kinetruss as kt
    >>> leg = {"kind": "driven"}
    >>> two = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "P": (0.5, 1)}, fixed=["A", "B"],
    ...                bars={"a": {"ends": ("A", "P"), **leg}, "b": {"ends": ("B", "P"), **leg}})
    >>> found = kt.kinematics.workspace(two, "P", ("x", np.linspace(0, 1, 5)), ("y", [0.5, 1.0]), limits={"a": (0.0, 1.2)})
    >>> found.within.sel(y=1.0).values.tolist()
    [True, True, True, False, False]
    """
    system = compile(model)
    least = number_of(least, "least", "")
    bounds = _limits(model, system, limits or {})
    grid, given = _problem(system, _task(system, point), (across, along, at))
    if lacking := cannot(given, given.linear(given.begin, at_values(given.tasks, grid.level[None])[0])[1]):
        raise InputError(f"{lacking} Name fewer coordinates, or leave some free.")
    alone = isinstance(point, str) and point in system.nodes and len(system.drives) == model.dim
    found = _swept(given, grid, least, point) if alone else _flood(given, grid, least)
    kept = _within_bounds(given, grid, least, bounds, found)
    return _dataset(given, grid, least, bounds, found, kept)


def _task(system: System, point: Any) -> Any:
    """The task that a node, a pose, or a list of coordinates stands for."""
    if isinstance(point, str):
        if point in system.nodes:
            return Positioning(node=point, moves={"x": 0.0})
        if point in system.model.poses:
            return Coordinates(moves={f"{point}.{part}": 0.0 for part in POSE})
        raise InputError(
            f"No node called {point!r}, nor a pose. {nearest(point, [*system.nodes, *system.model.poses])} "
            "Give a node, a pose, coordinates as a list, or a task."
        )
    if isinstance(point, (list, tuple)) and point and all(isinstance(one, str) for one in point):
        return task_of(system, Coordinates(moves=dict.fromkeys(point, 0.0)), None)
    return task_of(system, point, None)


def _problem(system: System, task: Any, axes: Any) -> tuple[_Grid, Problem]:
    """The grid over a task's coordinates, and the problem of the task without limits."""
    own = choice_of(task)
    if own.objective in KNOTTED:
        raise InputError(
            f"A map cannot choose drives by {own.objective!r}, which is for motions. Choose 'least_change' or 'stroke_ends'."
        )
    choice = Choice(objective=own.objective, weights=own.weights, hold=own.hold, within_stroke=False)
    given = problem(system, divided(system, task)[0], choice)
    start = given.tasks.start(given.begin.x)
    return _grid([one.name for one in given.tasks.asked], start, *axes), given


def _grid(names: list[str], start: NDArray[np.float64], across: Any, along: Any, at: Any) -> _Grid:
    rest = _level(at)
    axes = [_axis("along", along), _axis("across", across)]
    several = [(name, value) for name, value in rest.items() if np.ndim(value)]
    if len(several) > 1:
        raise InputError(f"at has places of {several[0][0]} and {several[1][0]}. Give places of one, a value of the other.")
    named = [axes[1][0], axes[0][0], *rest]
    if not set(named) <= set(names) or len(set(named)) != len(named):
        raise InputError(f"{named} are not different axes of {', '.join(names)}. Name two for the grid, and others in at.")
    axes = [*((name, _places(value, f"at[{name!r}]")) for name, value in several), *axes]
    level = start.copy()
    for name, value in rest.items():
        if not np.ndim(value):
            level[names.index(name)] = number_of(value, f"at[{name!r}]", "m or rad")
    keys = tuple(name for name, _ in axes)
    return _Grid(
        names=keys, places=tuple(one for _, one in axes), columns=tuple(names.index(name) for name in keys), level=level
    )


def _axis(what: str, given: Any) -> tuple[str, NDArray[np.float64]]:
    """A coordinate and its places."""
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2 or not isinstance(given[0], str):
        raise InputError(
            f"{what} is {shown(given)}. Give an axis and its places, e.g. {what}=('x', np.linspace(-0.4, 0.4, 41))."
        )
    return given[0], _places(given[1], f"{what}[1]")


def _places(given: Any, what: str) -> NDArray[np.float64]:
    values = array_of(given, what, {"places": None}, unit="m or rad")
    if not len(values) or np.any(np.diff(values) <= 0):
        raise InputError("The places of a grid must be a list of increasing values, e.g. np.linspace(-0.4, 0.4, 41).")
    return values


def _level(at: Any) -> dict[str, Any]:
    """Values, or places, of the other coordinates."""
    if at is None:
        return {}
    if not isinstance(at, Mapping):
        raise InputError(f"at is {shown(at)}. Give other axes with their values, e.g. at={{'z': -0.8}}.")
    return dict(at)


def _swept(given: Problem, grid: _Grid, least: float, node: str) -> _Found:
    """The places of a node that fixes the configuration by itself."""
    system, poses = given.system, {}
    one, other = grid.columns[-1], grid.columns[-2]
    for first in product(*(range(count) for count in grid.shape[:-2])):
        level = grid.row((*first, 0, 0))
        x = places(Slice(system, node, (one, other), grid.places[-1], grid.places[-2], level, least))
        for i, j in np.argwhere(~np.isnan(x[..., 0])):
            at, zero = x[i, j].reshape(1, -1, 3), np.zeros((1, len(system.nodes), 3))
            q = drive_values(system, at, zero, zero)[0][0]
            state = State(x=x[i, j].copy(), q=q, s=given.begin.s, miss=given.begin.miss)
            A = given.linear(state, at_values(given.tasks, grid.row((*first, i, j))[None])[0])[1]
            poses[(*first, int(i), int(j))] = _Pose(state=state, derivatives=A)
    return _Found(poses=poses)


def _flood(given: Problem, grid: _Grid, least: float) -> _Found:
    """Continue from the start to the grid, and on it from neighbour to neighbour."""
    found = _Found(poses=_entered(given, grid, least))
    ahead = deque(found.poses)
    while ahead:
        cell = ahead.popleft()
        for other in grid.beside(cell):
            if other in found.poses:
                continue
            if (pose := _step(given, grid.row(other), found.poses[cell])) is None:
                continue
            if pose.gauge < least or pose.beyond(found.poses[cell]):
                found.singular.add(other)
            else:
                found.poses[other] = pose
                ahead.append(other)
    return _Found(poses=found.poses, singular=found.singular - set(found.poses))


def _entered(given: Problem, grid: _Grid, least: float) -> dict[Cell, _Pose]:
    """The first point of the grid, by steps from the start: the nearest one, or one of some others."""
    start = given.tasks.start(given.begin.x)
    cells = list(product(*(range(count) for count in grid.shape)))
    order = np.argsort([np.linalg.norm(grid.row(cell) - start) for cell in cells], kind="stable")
    for k in order[np.unique(np.linspace(0, len(order) - 1, ENTRIES).astype(int))]:
        last = _step(given, start, _Pose(state=given.begin, derivatives=np.empty((0, 0))))
        for j in range(1, STEPS + 1):
            if last is None:
                break
            pose = _step(given, start + (grid.row(cells[k]) - start) * j / STEPS, last)
            last = None if pose is None or pose.gauge < least or pose.beyond(last) else pose
        if last is not None:
            return {cells[k]: last}
    return {}


def _step(given: Problem, row: NDArray[np.float64], near: _Pose) -> _Pose | None:
    """The pose of a row of values, from one near by; None if it is out of reach."""
    parameters = at_values(given.tasks, row[None])[0]
    state = given.reach(parameters, near.state, starts=1)
    if not state.far <= MET * given.scale:
        return None
    state = given.polished(parameters, state)
    return _Pose(state=state, derivatives=given.linear(state, parameters)[1][:, given.drives.held != 3])


def _within_bounds(given: Problem, grid: _Grid, least: float, bounds: NDArray[np.float64], found: _Found) -> dict[Cell, _Pose]:
    """The poses with drives that keep their limits: of those found, or where drives can be chosen, by a way of their own."""
    fits = {cell: (bounds[:, 0] <= one.state.q) & (one.state.q <= bounds[:, 1]) for cell, one in found.poses.items()}
    fitting = {cell: one for cell, one in found.poses.items() if fits[cell].all()}
    if np.count_nonzero(given.drives.held != 3) == len(given.tasks.labels) or len(fitting) == len(found.poses):
        return fitting
    arrays = {name: getattr(given.drives, name) for name in ("row", "flat", "held", "weight")}
    limited = Drives.of(arrays | {"lower": bounds[:, 0].copy(), "upper": bounds[:, 1].copy()})
    return _flood(replace(given, drives=limited), grid, least).poses | fitting


def _limits(model: Model, system: System, given: Mapping[str, tuple[float, float]]) -> NDArray[np.float64]:
    """Least and largest value of each drive, (drives, 2)."""
    if not isinstance(given, Mapping):
        raise InputError(f"limits is {shown(given)}. Give drive -> (least, largest), e.g. limits={{'M7': (0.8, 1.5)}}.")
    if unknown := [name for name in given if name not in system.drives]:
        raise InputError(f"No drive called {unknown[0]!r}. {nearest(unknown[0], system.drives)}")
    for name, pair in given.items():
        if isinstance(pair, str) or not isinstance(pair, Sequence) or len(pair) != 2:
            raise InputError(f"limits[{name!r}] is {shown(pair)}. Give (least, largest), m or rad.")
        low, high = (number_of(value, f"limits[{name!r}]", "m or rad", infinite=True) for value in pair)
        if not low < high:
            raise InputError(f"limits[{name!r}] = ({low:g}, {high:g}) must be (least, largest).")
    own = {name: member.limits for name, member in model.active.items() if isinstance(member, Active) and member.limits}
    return np.array([(own | dict(given)).get(name, (-np.inf, np.inf)) for name in system.drives], float).reshape(-1, 2)


def _dataset(given: Problem, grid: _Grid, least: float, bounds: NDArray[np.float64], found: _Found, kept: Any) -> xr.Dataset:
    system, count = given.system, len(given.system.drives)
    drives, stroke = (np.full((*grid.shape, count), np.nan) for _ in range(2))
    serial, parallel, conditioning = (np.full(grid.shape, np.nan) for _ in range(3))
    words, within = np.full(grid.shape, "out of reach", dtype=object), np.zeros(grid.shape, bool)
    for cell in found.singular:
        words[cell] = "singular"
    for cell, first in (kept | found.poses).items():
        pose = kept.get(cell, first)
        held = float(singularity_at(system, pose.state.x.reshape(1, -1))[0])
        if held < least:
            words[cell] = "singular"
            continue
        drives[cell], serial[cell], parallel[cell] = pose.state.q, pose.gauge, held
        conditioning[cell] = _share(rows_of(system, pose.state.x.reshape(-1, 3), pose.state.q))
        within[cell] = cell in kept
        words[cell] = "" if within[cell] else _stopped(system, pose.state.q, bounds)
    reachable = ~np.isnan(serial)
    span = bounds[:, 1] - bounds[:, 0]
    known = np.isfinite(span)
    stroke[..., known] = (drives[..., known] - bounds[known, 0]) / span[known]
    per = grid.names
    data = {
        "reachable": variable(per, reachable, "", "can be reached"),
        "within": variable(per, within, "", "can be reached within the drives' limits"),
        "limit": variable(per, words.astype(str), "", "what stops the pose"),
        "stroke": variable((*per, "drive"), stroke, "", "share of the stroke of each drive"),
        "drive_position": variable((*per, "drive"), drives, drive_unit(system)[0], "drives there"),
        "serial": variable(per, serial, "", "smallest singular value of the task by the drives"),
        "parallel": variable(per, parallel, "", "singularity measure, drives held"),
        "conditioning": variable(per, conditioning, "", "smallest over largest singular value, drives held"),
    }
    units = {one.name: given.tasks.unit(one) for one in given.tasks.asked}
    coords: dict[str, Any] = {
        name: (name, places, {"units": units[name]}) for name, places in zip(per, grid.places, strict=True)
    }
    return xr.Dataset(data, coords=coords | {"drive": list(system.drives)} | drive_unit(system)[1], attrs={"kind": "workspace"})


def _share(J: NDArray[np.float64]) -> float:
    """Smallest singular value as a fraction of the largest; 1 where nothing is unknown."""
    if not J.size:
        return 1.0
    found = np.linalg.svd(J, compute_uv=False)
    return float(found[-1] / found[0])


def _stopped(system: System, q: NDArray[np.float64], bounds: NDArray[np.float64]) -> str:
    """The drive that is farthest beyond its limits, and on which side."""
    d = int(np.maximum(bounds[:, 0] - q, q - bounds[:, 1]).argmax())
    return f"{system.drives[d]} {'short' if q[d] < bounds[d, 0] else 'long'}"
