"""A slice of the workspace of a point of a robot, with drives, limits and both singularity measures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.errors import InputError, shown
from kinetruss.kinematics.given.support import support_history
from kinetruss.kinematics.path.follow import follow_path
from kinetruss.kinematics.path.redundant import LEAST, Path
from kinetruss.kinematics.targets.inverse import release
from kinetruss.mechanics import System, compile
from kinetruss.mechanics import jacobian as rows_of
from kinetruss.mechanics.configuration import drive_values, number_of
from kinetruss.model import Active, Model, nearest
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["workspace"]

STEPS = 25
"""Samples on the way from the start to the slice."""


@dataclass(frozen=True, eq=False)
class _Slice:
    """The input of the sweep: the system of the model, that with the point prescribed, its axes, and the values of the grid."""

    system: System
    released: System
    axes: tuple[int, int]
    u: NDArray[np.float64]
    v: NDArray[np.float64]
    level: NDArray[np.float64]
    least: float


def workspace(
    model: Model,
    point: str,
    across: tuple[str, ArrayLike],
    along: tuple[str, ArrayLike],
    at: Mapping[str, float] | None = None,
    *,
    limits: Mapping[str, tuple[float, float]] | None = None,
    least: float = LEAST,
) -> xr.Dataset:
    """The points of a plane slice that a node can reach, the drive positions there, and singularity measures.

    Parameters
    ----------
    point : a node, whose coordinates fix the configuration (as many drives as coordinates).
    across, along : axis and places of the grid, e.g. ``("x", np.linspace(-0.4, 0.4, 41))``; m, increasing.
    at : value of the third axis, e.g. ``{"z": -0.8}``; by default the coordinate of the point.
    limits : drive name -> (least, largest), m or rad; `limits` of active members apply as well.
    least : least singularity measure of a reachable position, as in `follow`.

    Returns
    -------
    Dataset over the two axes (along, across). ``reachable``: bool, on the assembly branch of the model's own configuration;
    ``within``: reachable and all drives within their limits; ``limit``: what stops it otherwise, ``out of reach`` or the drive
    that is farthest beyond its limits, ``M7 short`` or ``M7 long``; ``drive_position`` (along, across, drive) m or rad, NaN
    elsewhere; ``stroke`` (along, across, drive): share of the way from the least to the largest limit, NaN without limits;
    ``serial``: singularity measure of the inverse problem (0 at the border of the workspace); ``parallel``: smallest singular
    value of the prescribed rows with the drives held (0 at a position in which the drives do not hold the structure);
    ``conditioning``: the same over their largest (1: all directions held alike). `report.map_picture` draws each of them.

    Raises
    ------
    InputError : unknown names or axes, limits the wrong way round, a point that does not fix the configuration.

    Notes
    -----
    Swept from the model's configuration along the lines of the grid, first all rows from the line through the start, then all
    columns: a point counts as reachable if one of the two paths leads to it by steps that Newton's method can follow.

    >>> import numpy as np, kinetruss as kt
    >>> leg = {"kind": "driven"}
    >>> two = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "P": (0.5, 1)}, fixed=["A", "B"],
    ...                bars={"a": {"ends": ("A", "P"), **leg}, "b": {"ends": ("B", "P"), **leg}})
    >>> found = kt.kinematics.workspace(two, "P", ("x", np.linspace(0, 1, 5)), ("y", [0.5, 1.0]), limits={"a": (0.0, 1.2)})
    >>> found.within.sel(y=1.0).values.tolist()
    [True, True, True, False, False]
    """
    cut = _slice(model, point, across, along, at, least)
    x = np.full((len(cut.v), len(cut.u), cut.system.x0.size), np.nan)
    _sweep(cut, x, swapped=False)
    _sweep(cut, x, swapped=True)
    return _dataset(cut, x, _limits(model, cut.system, limits or {}), across[0], along[0])


def _slice(model: Model, point: str, across: Any, along: Any, at: Mapping[str, float] | None, least: float) -> _Slice:
    system = compile(model)
    if point not in system.nodes:
        raise InputError(f"No node called {point!r}. {nearest(point, system.nodes)}")
    letters = "xyz"[: model.dim]
    (one, u), (other, v) = _grid("across", across), _grid("along", along)
    named = [one, other, *_level(at)]
    if sorted({*map(str, named), *letters}) != sorted(letters) or len(set(named)) != len(named):
        raise InputError(f"{named} are not different axes of {', '.join(letters)}. Name two for the grid and the third in at.")
    first = 3 * system.node_index(point)
    flats = np.array([first + k for k in range(model.dim)], np.int32)
    if len(system.drives) != model.dim:
        raise InputError(
            f"{point} has {model.dim} coordinates, but the model has {len(system.drives)} drives, so its position does not "
            "fix the configuration. Choose a model or a point with equal numbers."
        )
    level = system.x0.reshape(-1)[flats].copy()
    for axis, value in _level(at).items():
        level[letters.index(axis)] = value
    axes = (letters.index(one), letters.index(other))
    return _Slice(system, release(system, tuple(int(flat) for flat in flats)), axes, u, v, level, least)


def _grid(what: str, given: Any) -> tuple[str, NDArray[np.float64]]:
    """An axis and the places on it."""
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2 or not isinstance(given[0], str):
        raise InputError(
            f"{what} is {shown(given)}. Give an axis and its places, e.g. {what}=('x', np.linspace(-0.4, 0.4, 41))."
        )
    values = array_of(given[1], f"{what}[1]", {"places": None}, unit="m")
    if not len(values) or np.any(np.diff(values) <= 0):
        raise InputError("The places of a grid must be a list of increasing values, m, e.g. np.linspace(-0.4, 0.4, 41).")
    return given[0], values


def _level(at: Any) -> dict[str, float]:
    """The value of the third axis."""
    if at is None:
        return {}
    if not isinstance(at, Mapping):
        raise InputError(f"at is {shown(at)}. Give the third axis with its value, e.g. at={{'z': -0.8}}.")
    return {axis: number_of(value, f"at[{axis!r}]", "m") for axis, value in at.items()}


def _sweep(cut: _Slice, x: NDArray[np.float64], *, swapped: bool) -> None:
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


def _way(cut: _Slice, here: NDArray[np.float64], entry: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Flat positions with the point at `entry`, reached from the model's configuration, or None."""
    states = _reached(cut, here + np.linspace(0, 1, STEPS)[:, None] * (entry - here), cut.system.x0.reshape(-1))
    return states[-1] if len(states) == STEPS else None


def _line(cut: _Slice, state: Any, place: NDArray[np.float64], axis: int, values: NDArray[np.float64]) -> Any:
    """(index, place, flat positions) of the values on one axis that are reached from `place`, upwards and downwards."""
    if state is None:
        return
    middle = int(np.searchsorted(values, place[axis]))
    for order in (range(middle, len(values)), range(middle - 1, -1, -1)):
        way = np.repeat(place[None], len(order) + 1, axis=0)
        way[1:, axis] = values[list(order)]
        yield from zip(order, way[1:], _reached(cut, way, state)[1:], strict=False)


def _reached(cut: _Slice, way: NDArray[np.float64], state: NDArray[np.float64]) -> NDArray[np.float64]:
    """Flat positions (good, 3 n) along places (k, dim) of the point, from a state at the first of them."""
    t = np.arange(len(way), dtype=float)
    still = np.zeros_like(way)
    supports = support_history(cut.released, np.zeros(len(way)))
    x, v, a = (np.ascontiguousarray(np.hstack([one, y])) for one, y in zip((way, still, still), supports, strict=True))
    path = Path(t=t, drive=(way, still, still), moving=(x, v, a))
    found = follow_path(cut.released, path, "workspace", start=state.reshape(-1, 3)[:, : cut.system.dim], least=cut.least)
    position = found.data["position"].values
    full = np.zeros((len(position), len(cut.system.nodes), 3))
    full[:, :, : cut.system.dim] = position
    return full.reshape(len(position), -1)


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


def _dataset(cut: _Slice, x: NDArray[np.float64], limits: NDArray[np.float64], across: str, along: str) -> xr.Dataset:
    system, good = cut.system, ~np.isnan(x[..., 0])
    states = x[good]
    zero = np.zeros((len(states), len(system.nodes), 3))
    drives = drive_values(system, states.reshape(zero.shape), zero, zero)[0]
    at = [states[k].reshape(-1, 3) for k in range(len(states))]
    rows = [rows_of(system, one, values) for one, values in zip(at, drives, strict=True)]
    free = [rows_of(cut.released, one) for one in at]
    stroke, stopped = _stroke(system, drives, limits)
    within = np.all((drives >= limits[:, 0]) & (drives <= limits[:, 1]), axis=1)
    per = (along, across)

    def placed(values: Any, like: Any) -> NDArray[Any]:
        out = np.full((*good.shape, *np.shape(values)[1:]), like)
        out[good] = values
        return out

    gauges = [np.array([_smallest(one)[0] for one in found]) for found in (free, rows)]
    conditioning = np.array([_smallest(one)[1] for one in rows])
    data = {
        "reachable": variable(per, good, "", "can be reached"),
        "within": variable(per, placed(within, False), "", "can be reached within the drives' limits"),
        "limit": variable(per, _words(good, stopped), "", "what stops the point"),
        "stroke": variable((*per, "drive"), placed(stroke, np.nan), "", "share of the stroke of each drive"),
        "drive_position": variable((*per, "drive"), placed(drives, np.nan), "m or rad", "drives there"),
        "serial": variable(per, placed(gauges[0], np.nan), "", "gauge of the inverse problem"),
        "parallel": variable(per, placed(gauges[1], np.nan), "", "gauge of the drives' hold"),
        "conditioning": variable(per, placed(conditioning, np.nan), "", "smallest over largest singular value, drives held"),
    }
    coords = {across: (across, cut.u, {"units": "m"}), along: (along, cut.v, {"units": "m"}), "drive": list(system.drives)}
    return xr.Dataset(data, coords=coords, attrs={"kind": "workspace"})


def _smallest(J: NDArray[np.float64]) -> tuple[float, float]:
    """Smallest singular value, and as a fraction of the largest; 1 where nothing is unknown."""
    if not J.size:
        return 1.0, 1.0
    found = np.linalg.svd(J, compute_uv=False)
    return float(found[-1]), float(found[-1] / found[0])


def _stroke(system: System, drives: NDArray[np.float64], limits: NDArray[np.float64]) -> tuple[NDArray[np.float64], list[str]]:
    """Share of the stroke of each drive (states, drives), and what stops each state; empty where nothing does."""
    span = limits[:, 1] - limits[:, 0]
    known = np.isfinite(span)
    share = np.full(drives.shape, np.nan)
    share[:, known] = (drives[:, known] - limits[known, 0]) / span[known]
    beyond = np.maximum(limits[:, 0] - drives, drives - limits[:, 1])
    names = []
    for row, off in zip(drives, beyond, strict=True):
        d = int(off.argmax()) if len(off) else 0
        stopped = len(off) > 0 and off[d] > 0
        names.append(f"{system.drives[d]} {'short' if row[d] < limits[d, 0] else 'long'}" if stopped else "")
    return share, names


def _words(good: NDArray[np.bool_], stopped: list[str]) -> NDArray[np.str_]:
    found = np.full(good.shape, "out of reach", dtype=object)
    found[good] = stopped
    return found.astype(str)
