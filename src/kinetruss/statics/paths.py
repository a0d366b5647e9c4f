"""Equilibrium paths under a growing load, through limit points, with the bifurcations on them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError, few
from kinetruss.mechanics import System, compile, constraint_jacobian
from kinetruss.mechanics.balance import Balance, balance_of
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.model import LoadCase, Model, nearest
from kinetruss.results import Column, Result, Status, provenance, variable
from kinetruss.results.user_parts import part_axes, support_axes
from kinetruss.results.wide_tables import element_axes, force_units
from kinetruss.statics.arc import Point, Road
from kinetruss.statics.large_displacements import forces_of, must_begin
from kinetruss.statics.saddle_point import LOOKED_AT, modes, rows_of
from kinetruss.statics.search import find_equilibrium
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


TURN = 0.94
"""Cosine of the largest change of direction of the tangent in one step (20 degrees)."""

ASIDE = 0.9995
"""Cosine of the largest angle between a chord and the mean of the tangents at its ends (1.8 degrees). On one branch it tends
to 0 with the square of the step, on an arc of a circle it is 0; a point on another branch lies aside.
"""

CONTINUOUS = 1e-6
"""An eigenvalue that stays above this part of its change in a step jumps over 0: the step has left its branch."""

ZERO = 1e-13
"""Part of the largest stiffness below which an eigenvalue is round-off."""

KINK, SHORTEST = 1e-7, 1e-10
"""Below the first, a step whose end is near crosses a kink of the path (a cable goes slack); no step is below the second."""

GONE = 1e-8
"""Part of the size of the structure below which a length counts as zero."""

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


@one_thread
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
    tangent. A step whose chord and tangents do not fit one curve, or in which an eigenvalue jumps over zero, has reached
    another branch and is halved. Two events of one mode within a step cancel and are not detected: reduce largest_step. Where
    the length of a member goes to zero the path ends, and ``message`` says so.

    >>> import kinetruss as kt
    >>> arch = kt.library.mechanisms.von_mises(load=0.001)
    >>> [float(factor) for factor in kt.statics.path(arch, "load").limit_points.round(9)]
    [9.949916958, -9.949916958]
    """
    if points < 2 or not 0 < step <= largest_step:
        got = f"points={points}, step={step:g}, largest_step={largest_step:g}"
        raise InputError(f"{got} gives no path. Give at least 2 points, and 0 < step <= largest_step.")
    system = compile(model)
    scaled = scaled_loads(system, load)
    push = scaled_force(system, scaled)
    balance = balance_of(without(system, load, load_case), load_case, tasks)
    x, wanted, span = must_begin(balance, start, lengths or {})
    reached = find_equilibrium(balance, x, wanted, 1e-13, 500)
    if not reached.good:
        raise AnalysisError("The structure has no equilibrium before the load is applied. See statics.equilibrium.")
    road = Road(balance, push, wanted, rows_of(balance.system, reached.x), span)
    first = road.begin(reached.x, reached.N, 0.0, 1.0 if sense >= 0 else -1.0)
    walk = _Walk(road, first, step, largest_step)
    good = walk.on(points, to)
    end = "" if good else _end(system, walk.points[-1], span)
    found = _record(system, balance, scaled, road, walk, good or bool(end), end)
    if good or end or not raise_on_failure:
        return found
    raise AnalysisError(f"{found.status.value} {found.message}", found)


class _LostError(Exception):
    """A point between two others was not found."""


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
        values, shapes = modes(K, constraint_jacobian(self.road.system, at.x)[:, free])
        # of a mechanism without stiffness round-off alone remains, which has no sign
        return np.where(np.abs(values) < ZERO * self.road.stiff, 0.0, values), shapes

    def on(self, count: int, to: float | None) -> bool:
        """Continue to `count` points, or to a load factor; False if a point cannot be passed."""
        while len(self.points) < count:
            at, wished = self.points[-1], self.step
            found = self._further(at)
            if found is None:
                return False
            point, events = found
            arc, end = self.step, None if to is None or to == at.factor else self._at_factor(at, point, events, to)
            if end is not None:
                arc, point = end
            for event in (one for one in events if one.arc <= arc):
                self.events.append(event)
                self.after.append(len(self.points) - 1)
            self.road.choose(point.x)
            self.points.append(point)
            self.values.append(self.eigen(point)[0])
            self.arcs.append(self.arcs[-1] + arc)
            if end is not None:
                return True
            smooth = self._turn(at, point) > 0.99 and point.steps < 6
            self.step = wished if arc < KINK else min(self.largest, arc * (1.5 if smooth else 1.0))
        return True

    def _further(self, at: Point) -> tuple[Point, list[_Event]] | None:
        """The next point, with the events before it in their order; the step is halved until all are on the branch of `at`."""
        while self.step >= SHORTEST:
            point = self.road.ahead(at, self.step)
            if point is not None and self._on_branch(at, point):
                before, after = (int(np.sum(self.eigen(one)[0] < 0)) for one in (at, point))
                events = [self._event(at, point, index) for index in range(min(before, after), max(before, after))]
                there = [one for one in events if one is not None]
                if len(there) == len(events):
                    return point, sorted(there, key=lambda one: one.arc)
            self.step *= 0.5
        return None

    def _turn(self, one: Point, two: Point) -> float:
        """Cosine between the tangents of two points."""
        return float(one.to_x @ two.to_x) / self.road.span**2 + one.to_factor * two.to_factor / self.road.unit**2

    def _on_branch(self, at: Point, point: Point) -> bool:
        """Whether a point is on the branch of another, as far as the chord between them and their tangents tell."""
        span, unit = self.road.span, self.road.unit
        chord = np.append((point.x - at.x).reshape(-1)[self.road.free] / span, (point.factor - at.factor) / unit)
        length = float(np.linalg.norm(chord))
        if self.step < KINK:  # tangents differ on the two sides of a kink, however near they are
            return length < 3 * self.step
        mean = np.append((at.to_x + point.to_x) / span, (at.to_factor + point.to_factor) / unit)
        return self._turn(at, point) >= TURN and float(chord @ mean) >= ASIDE * length * float(np.linalg.norm(mean))

    def _at_factor(self, at: Point, point: Point, events: list[_Event], factor: float) -> tuple[float, Point] | None:
        """The first point of a step at a load factor, with its arc; None if there is none."""
        from scipy.optimize import brentq

        known = {0.0: at, **{one.arc: one.point for one in events}, self.step: point}
        for low, high in pairwise(known):
            if min(known[low].factor, known[high].factor) <= factor <= max(known[low].factor, known[high].factor):
                try:
                    s = float(brentq(lambda s: self._between(at, s, known).factor - factor, low, high, xtol=1e-16, rtol=1e-14))
                except _LostError:
                    return self.step, point
                return s, replace(self._between(at, s, known), factor=factor)
        return None

    def _between(self, at: Point, s: float, known: dict[float, Point]) -> Point:
        """The point at distance s from `at`, from the nearest of those known; it becomes known.

        Raises
        ------
        _LostError : the correction does not converge.
        """
        if s not in known:
            near = min(known, key=lambda other: abs(other - s))
            point = self.road.ahead(at, s, (near, known[near]))
            if point is None:
                raise _LostError
            known[s] = point
        return known[s]

    def _event(self, at: Point, point: Point, index: int) -> _Event | None:
        """The point of a step at which the eigenvalue of this index is zero; None if there is none."""
        from scipy.optimize import brentq

        known = {0.0: at, self.step: point}

        def value(s: float) -> float:
            return float(self.eigen(self._between(at, s, known))[0][index])

        try:
            s = float(brentq(value, 0.0, self.step, xtol=1e-15 * max(1.0, self.step), rtol=1e-14))
            there = value(s)
        except _LostError:
            return None
        if abs(there) > CONTINUOUS * (abs(value(0.0)) + abs(value(self.step))) and self.step >= KINK:
            return None
        found = known[s]
        mode = self.eigen(found)[1][:, index]
        push = self.road.push[self.road.free]
        felt = abs(float(push @ mode)) / (float(np.linalg.norm(push)) * float(np.linalg.norm(mode)))
        return _Event(kind="limit" if felt > ALIKE else "bifurcation", point=found, arc=s, mode=mode)


def scaled_loads(system: System, load: str | Mapping[str, float]) -> Loads:
    """The loads that are scaled, as nodal forces."""
    model = system.model
    if isinstance(load, str) and load in model.cases:
        loads = case_loads(system, np.zeros(1), load)
    else:
        factors = {load: 1.0} if isinstance(load, str) else {name: float(value) for name, value in load.items()}
        for name in factors:
            if name not in model.loads:
                raise InputError(f"No load called {name!r} to scale. {nearest(name, [*model.loads, *model.cases])}".rstrip())
        scaled = system.given.with_(load_cases={"scaled": LoadCase(loads=factors)}, combinations={}, runs={})
        numbers = system.load_numbers | {"case scaled factor": np.array(list(factors.values()))}
        alone = replace(system, given=scaled, model=scaled.whole, load_numbers=numbers)
        loads = case_loads(alone, np.zeros(1), "scaled")
    if any(not one.constant for _, one, _ in loads.unit_loads):
        raise InputError("The load that is scaled turns with the structure. Give one that keeps its direction.")
    return loads.at(system.x0[None])


def scaled_force(system: System, scaled: Loads) -> NDArray[np.float64]:
    """The force that is scaled (3 n,), N."""
    push = np.zeros(system.x0.shape)
    np.add.at(push, scaled.node, scaled.force[0])
    flat = push.reshape(-1)
    if not np.any(flat[system.free]):
        raise InputError("The load that is scaled has no force on a free node. Give one that has.")
    return np.where(system.prescribed, 0.0, flat)


def without(system: System, load: str | Mapping[str, float], load_case: str | None) -> System:
    """The system without the scaled loads, if no load case gives the unscaled ones."""
    if load_case is not None:
        return system
    model = system.given
    case = model.cases.get(load) if isinstance(load, str) else None
    gone = (case.loads or model.loads) if case is not None else [load] if isinstance(load, str) else load
    kept = {name: record for name, record in model.loads.items() if name not in gone}
    left = model.with_(loads=kept, load_cases={}, combinations={}, runs={})
    return replace(system, given=left, model=left.whole)


def _end(system: System, last: Point, span: float) -> str:
    """Why a path ends at its last point: a length goes to zero. Empty if it does not end there."""
    lengths = np.linalg.norm(last.x[system.q] - last.x[system.p], axis=1)
    gone = [f"the length of {name!r}" for name, L in zip(system.members, lengths, strict=True) if GONE * span > L]
    return f"The path ends at load factor {last.factor:.6g}, where {few(gone, 4)} goes to zero." if gone else ""


def _record(system: System, balance: Balance, scaled: Loads, road: Road, walk: _Walk, good: bool, end: str) -> Path:
    dim = system.dim
    forces = []
    for at in walk.points:
        loads = balance.loads.at(at.x[None]).scaled_with(scaled, at.factor)
        forces.append(forces_of(system, replace(road.loaded(at.factor), loads=loads), at.x, at.N))
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
        **part_axes(system),
        **support_axes(system),
        "drive": list(system.drives),
        **element_axes(system),
        **force_units(system, "drive", *element_axes(system))[1],
    }
    message = end if good else f"At load factor {walk.points[-1].factor:.6g} no step is short enough to go on."
    if not walk.looked_at:
        message = f"{message} Too large to look for events.".strip()
    return Path(
        data=xr.Dataset(data, coords=coords, attrs={"kind": "path", "load_case": balance.name}),
        status=Status.COMPLETED if good else Status.NO_EQUILIBRIUM,
        message=message,
        provenance=provenance(system.given),
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
