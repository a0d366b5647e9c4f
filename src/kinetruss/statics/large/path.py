"""Equilibrium paths under a growing load, through limit points, with the bifurcations on them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError
from kinetruss.mechanics import System, compile, constraint_jacobian
from kinetruss.mechanics.assembly import Balance, balance_of, case_loads
from kinetruss.model import LoadCase, Model, nearest
from kinetruss.results import Column, Result, Status, provenance, variable
from kinetruss.statics.large.arc import Point, Road
from kinetruss.statics.large.equilibrium import forces_of, must_begin
from kinetruss.statics.large.saddle import LOOKED_AT, modes, rows_of
from kinetruss.statics.large.search import find_equilibrium

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Path", "path", "scaled_force", "without"]

TURN = 0.94
"""Cosine of the largest change of direction of the tangent in one step (20 degrees)."""

ALIKE = 1e-6
"""If the work of the load on a mode is below this fraction of their norms, the event is a bifurcation, not a limit point."""


class Path(Result):
    """Equilibria under a growing load."""

    @property
    def limit_points(self) -> NDArray[np.float64]:
        """Load factors at which the load has a maximum or minimum, in the order of the path."""
        return np.asarray(self.data["event_factor"].values[self.data["event_kind"].values == "limit"])

    @property
    def bifurcations(self) -> NDArray[np.float64]:
        """Load factors at which another path branches off, in the order of the path."""
        return np.asarray(self.data["event_factor"].values[self.data["event_kind"].values == "bifurcation"])


@dataclass(frozen=True, kw_only=True, eq=False)
class _Event:
    kind: str
    point: Point
    arc: float
    mode: NDArray[np.float64]


def path(
    model: Model,
    load: str | Mapping[str, float],
    *,
    start: Result | ArrayLike | None = None,
    load_case: str | None = None,
    lengths: Mapping[str, float] | None = None,
    tasks: Mapping[str, Any] | None = None,
    to: float | None = None,
    points: int = 100,
    step: float = 0.02,
    largest_step: float = 0.05,
    sense: int = 1,
    raise_on_failure: bool = True,
) -> Path:
    """Follow equilibria while one load is scaled by a factor from 0 on, through limit points.

    Parameters
    ----------
    load : name of a load or of a load case (its nodal forces), or a mapping of loads to factors: the factor scales these.
    start, lengths, tasks : as in `equilibrium`; the path begins in equilibrium under the loads that are not scaled.
    load_case : the unscaled loads; by default the model's gravity and its other loads.
    to : load factor to end at. points : largest number of points. step, largest_step : length of the first and of any step, as
        multiples of the size of the structure. sense : -1 begins towards negative factors.
    raise_on_failure : False gives the path up to where it could not be followed.

    Returns
    -------
    Path. ``load_factor`` (point), ``position`` (point, node, axis) m, ``member_force`` (point, member) N, ``reaction`` (point,
    support, axis) N, ``unstable`` (point): number of unstable modes under a constant load; ``stiffness`` (point): lowest
    eigenvalue of the reduced stiffness, N/m. Events: ``event_kind`` (``limit`` or ``bifurcation``), ``event_factor``,
    ``event_point`` (after which point), ``event_position``, ``event_mode`` (event, node, axis).

    Raises
    ------
    InputError : an unknown load, one without force; arguments out of range.
    AnalysisError : no equilibrium at the start, or a point that cannot be passed; ``error.result`` is the path up to there.

    Notes
    -----
    Pseudo-arc-length (Riks 1972, Crisfield 1981, Keller 1977), the step fitted to the curvature of the path. Events are where
    an eigenvalue of the reduced stiffness changes sign: a limit point (located to round-off) if the load does work on its
    mode, else a bifurcation (located as well as its bad conditioning allows), after which the path continues along its
    tangent. Two events of one mode within a step cancel and are not detected: reduce largest_step.

    >>> import kinetruss as kt
    >>> arch = kt.library.mechanisms.von_mises(load=0.001)
    >>> [float(factor) for factor in kt.statics.path(arch, "load").limit_points.round(9)]
    [9.949916958, -9.949916958]
    """
    if points < 2 or not 0 < step <= largest_step:
        got = f"points={points}, step={step:g}, largest_step={largest_step:g}"
        raise InputError(f"{got} gives no path. Give at least 2 points, and 0 < step <= largest_step.")
    system = compile(model)
    push = scaled_force(system, load)
    balance = balance_of(without(system, load, load_case), load_case, tasks)
    x, wanted, span = must_begin(balance, start, lengths or {})
    reached = find_equilibrium(balance, x, wanted, 1e-13, 500)
    if not reached.good:
        raise AnalysisError("The structure has no equilibrium before the load is applied. See statics.equilibrium.")
    road = Road(balance, push, wanted, rows_of(balance.system, reached.x), span)
    first = road.begin(reached.x, reached.N, 0.0, 1.0 if sense >= 0 else -1.0)
    walk = _Walk(road, first, step, largest_step)
    good = walk.on(points, to)
    found = _record(system, balance, road, walk, good)
    if good or not raise_on_failure:
        return found
    raise AnalysisError(f"{found.status.value} {found.message}", found)


class _Walk:
    """The points so far, their eigenvalues, and the events between them."""

    def __init__(self, road: Road, first: Point, step: float, largest: float) -> None:
        self.road, self.step, self.largest = road, step, largest
        self.points, self.arcs, self.events = [first], [0.0], list[_Event]()
        self.after: list[int] = []
        self.looked_at = len(road.free) <= LOOKED_AT
        self.values = [self.eigen(first)[0]]

    def eigen(self, at: Point) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Eigenvalues and modes of the reduced stiffness at a point."""
        if not self.looked_at:
            return np.zeros(0), np.zeros((len(self.road.free), 0))
        free = self.road.free
        K = self.road.loaded(at.factor).stiffness(at.x, at.N)[free][:, free]
        return modes(K, constraint_jacobian(self.road.system, at.x)[:, free])

    def on(self, count: int, to: float | None) -> bool:
        """Continue to `count` points, or to a load factor; False if a point cannot be passed."""
        while len(self.points) < count:
            at = self.points[-1]
            point = self.road.ahead(at, self.step)
            while point is None or self._turn(at, point) < TURN:
                self.step *= 0.5
                if self.step < 1e-10:
                    return point is not None
                point = self.road.ahead(at, self.step)
            arc = self.step
            ended = to is not None and min(at.factor, point.factor) <= to <= max(at.factor, point.factor) and to != at.factor
            if ended:
                point = self.road.at_factor(point, float(to or 0.0)) or point
            self._add(point, arc)
            if ended:
                return True
            self.step = min(self.largest, arc * (1.5 if self._turn(at, point) > 0.99 and point.steps < 6 else 1.0))
        return True

    def _turn(self, one: Point, two: Point) -> float:
        """Cosine between the tangents of two points."""
        return float(one.to_x @ two.to_x) / self.road.span**2 + one.to_factor * two.to_factor / self.road.unit**2

    def _add(self, point: Point, arc: float) -> None:
        values = self.eigen(point)[0]
        before, after = int(np.sum(self.values[-1] < 0)), int(np.sum(values < 0))
        found = [self._event(index, arc) for index in range(min(before, after), max(before, after))]
        for event in sorted((one for one in found if one is not None), key=lambda one: one.arc):
            self.events.append(event)
            self.after.append(len(self.points) - 1)
        self.road.choose(point.x)
        self.points.append(point)
        self.values.append(values)
        self.arcs.append(self.arcs[-1] + arc)

    def _event(self, index: int, arc: float) -> _Event | None:
        """The point after the last one at which the eigenvalue of this index is zero."""
        from scipy.optimize import brentq

        at = self.points[-1]
        known: dict[float, Point] = {0.0: at}

        def value(s: float) -> float:
            if s not in known:
                near = min(known, key=lambda other: abs(other - s))
                point = self.road.ahead(at, s, (near, known[near]))
                if point is None:
                    return float("nan")
                known[s] = point
            return float(self.eigen(known[s])[0][index])

        ends = value(0.0), value(arc)
        if not ends[0] * ends[1] < 0:
            return None
        try:
            s = float(brentq(value, 0.0, arc, xtol=1e-15 * max(1.0, arc), rtol=1e-14))
        except ValueError:  # a point in between does not converge
            return None
        point = known.get(s) or self.road.ahead(at, s)
        if point is None:
            return None
        mode = self.eigen(point)[1][:, index]
        push = self.road.push[self.road.free]
        felt = abs(float(push @ mode)) / (float(np.linalg.norm(push)) * float(np.linalg.norm(mode)))
        return _Event(kind="limit" if felt > ALIKE else "bifurcation", point=point, arc=s, mode=mode)


def scaled_force(system: System, load: str | Mapping[str, float]) -> NDArray[np.float64]:
    """The force that is scaled (3 n,), N."""
    model = system.model
    if isinstance(load, str) and load in model.load_cases:
        loads = case_loads(system, np.zeros(1), load)
    else:
        factors = {load: 1.0} if isinstance(load, str) else {name: float(value) for name, value in load.items()}
        for name in factors:
            if name not in model.loads:
                raise InputError(
                    f"No load called {name!r} to scale. {nearest(name, [*model.loads, *model.load_cases])}".rstrip()
                )
        scaled = model.with_(load_cases={"scaled": LoadCase(loads=factors)}, runs={})
        loads = case_loads(compile(scaled), np.zeros(1), "scaled")
    if any(not one.constant for _, one, _ in loads.unit_loads):
        raise InputError("The load that is scaled turns with the structure. Give one that keeps its direction.")
    loads = loads.at(system.x0[None])
    push = np.zeros(system.x0.shape)
    np.add.at(push, loads.node, loads.force[0])
    flat = push.reshape(-1)
    if not np.any(flat[system.free]):
        raise InputError("The load that is scaled has no force on a free node. Give one that has.")
    return np.where(system.prescribed, 0.0, flat)


def without(system: System, load: str | Mapping[str, float], load_case: str | None) -> System:
    """The system without the scaled loads, if no load case gives the unscaled ones."""
    if load_case is not None:
        return system
    model = system.model
    case = model.load_cases.get(load) if isinstance(load, str) else None
    gone = (case.loads or model.loads) if case is not None else [load] if isinstance(load, str) else load
    kept = {name: record for name, record in model.loads.items() if name not in gone}
    return replace(system, model=model.with_(loads=kept, load_cases={}, runs={}))


def _record(system: System, balance: Balance, road: Road, walk: _Walk, good: bool) -> Path:
    dim, supports = system.dim, [system.node_index(name) for name in system.supports]
    forces = [forces_of(system, road.loaded(at.factor), at.x, at.N, supports) for at in walk.points]
    lowest = [values[0] if len(values) else np.nan for values in walk.values]
    position = np.array([at.x[:, :dim] for at in walk.points])
    d = position[:, system.q] - position[:, system.p]
    nodal = ("point", "node", "axis")
    data = {
        "load_factor": variable(("point",), np.array([at.factor for at in walk.points]), "", "load factor"),
        "position": variable(nodal, position, "m", "node position"),
        "length": variable(("point", "member"), np.linalg.norm(d, axis=2), "m", "member length"),
        **{
            name: xr.Variable(("point", *first.dims), np.array([one[name].values for one in forces]), first.attrs)
            for name, first in forces[0].items()
        },
        "unstable": variable(("point",), np.array([int(np.sum(v < 0)) for v in walk.values]), "", "modes that give way"),
        "stiffness": variable(("point",), np.array(lowest), "N/m", "lowest eigenvalue of the reduced stiffness"),
        "arc": variable(("point",), np.array(walk.arcs), "", "length along the path"),
        **_events(system, road, walk),
    }
    coords = {
        "node": list(system.nodes),
        "axis": ["x", "y", "z"][:dim],
        "member": list(system.members),
        "support": list(system.supports),
        "drive": list(system.drives),
    } | ({"spring": list(system.springs)} if system.springs else {})
    message = "" if good else f"At load factor {walk.points[-1].factor:.6g} no step is short enough to go on."
    if not walk.looked_at:
        message = f"{message} Too large to look for events.".strip()
    return Path(
        data=xr.Dataset(data, coords=coords, attrs={"kind": "path", "load_case": balance.name}),
        status=Status.COMPLETED if good else Status.NO_EQUILIBRIUM,
        message=message,
        provenance=provenance(system.model),
    )


def _events(system: System, road: Road, walk: _Walk) -> dict[str, Column]:
    """The events between the points."""
    events, nodal = walk.events, (len(walk.events), len(system.nodes), 3)
    shapes = np.zeros((len(events), system.x0.size))
    for shape, event in zip(shapes, events, strict=True):
        shape[road.free] = event.mode / np.abs(event.mode).max()
    places = np.array([event.point.x for event in events]).reshape(nodal)[:, :, : system.dim]
    modes_there = shapes.reshape(nodal)[:, :, : system.dim]
    kinds = np.array([event.kind for event in events], dtype="<U11")
    factors = np.array([event.point.factor for event in events])
    return {
        "event_kind": variable(("event",), kinds, "", "kind of event"),
        "event_factor": variable(("event",), factors, "", "load factor there"),
        "event_point": variable(("event",), np.array(walk.after, dtype=int), "", "point after which it is"),
        "event_position": variable(("event", "node", "axis"), places, "m", "node position there"),
        "event_mode": variable(("event", "node", "axis"), modes_there, "", "mode that has no stiffness there"),
    }
