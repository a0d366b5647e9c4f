"""`dynamics.simulate` and its gradients: of values at instants, of what is read over time, of the times of events.

The adjoint of the motion goes back from the samples that a response reads to the start (`run_adjoint`). At a sample, a and N
follow from its state by the equations of motion; at the start, places and velocities follow from the numbers of the model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.dynamics.equations import with_numbers
from kinetruss.dynamics.integrators import jumps
from kinetruss.dynamics.simulation import stepper_for, wanted_times
from kinetruss.dynamics.simulation_records import simulation_of
from kinetruss.dynamics.simulation_setup import Options, problem_of, seconds
from kinetruss.dynamics.starting import given_positions, given_velocities
from kinetruss.errors import AnalysisError
from kinetruss.gradients.differences import TWO, Weighed, differences
from kinetruss.gradients.nearness import parts_of, site_of_rows, sites, sites_along
from kinetruss.gradients.run_adjoint import STAGES, Columns, States, Varying, back_through, edges_between, gauss
from kinetruss.gradients.run_equations import At, Reading, gaps, refuse
from kinetruss.gradients.run_repeated import Repeated, steps_of
from kinetruss.gradients.run_start import of_start
from kinetruss.gradients.varied import STEP, Varied
from kinetruss.mechanics import System, compile
from kinetruss.model import Model, Radau
from kinetruss.results.user_parts import users_of
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]

CLOSE = 2e-5
"""Step of differences by numbers, in parts of each: the error is the square of it."""
SHARE = {"Taylor": 1.4, "DOP853": 2.75, "Radau": 2.75}
"""Longest cell in steps of the method."""
REST = 1e-6
"""Speed of what rests, in lengths over the time of the run."""
GOOD, BEST, FAIR = 3e-10, 3, 100.0
"""Error of the adjoint, or rtol if that is more, at which cells are short enough; how often they are halved; multiple of it
above which there is no result."""
ROOM = 32e6
"""Bytes of the derivatives that are held at once."""
LEFT_OUT = ("step_size", "smallest_pivot", "constraint_error", "steps", "rejected", "evaluations", "singularity")
"""What the integration tells of itself."""
PLAIN = {"position": 0, "velocity": 1, "acceleration": 2}
"""Variables that are x, v and a of nodes."""


class RunPoint:
    """A run of `dynamics.simulate`, with the arguments of that function, and the gradients of what is read of it."""

    def __init__(
        self,
        system: System,
        t_end: float | str | None = None,
        *,
        samples: int = 201,
        times: ArrayLike | None = None,
        progress: Any = None,  # noqa: ARG002 - of the value alone
        raise_on_failure: bool = True,  # noqa: ARG002 - a run that failed has no gradient
        **options: Any,
    ) -> None:
        model = system.given
        t = wanted_times(t_end, samples, times, model)
        self.model, self.options = model, Options(**options)
        self.t_end = float(t[-1]) if t_end is None else seconds(t_end)
        self.problem = problem_of(model, self.t_end, self.options)
        refuse(self.problem, self.options)
        self.work: Any = stepper_for(self.problem, self.t_end)
        self._noted: list[tuple[float, float]] = []
        self.trace = self.work.advance(t, steps=self._noted)
        self.result = simulation_of(self.work, self.trace)
        if not self.result.status.ok:
            raise AnalysisError(f"The run has no gradient: {self.result.status.value} {self.result.message}".strip())
        if self.result.passages:
            raise AnalysisError(
                f"The run passes a singular position at t = {self.result.passages[0].time:.6g} s; there its gradient is not "
                "known. End the run before it."
            )
        self._others: dict[bytes, At] = {}

    @cached_property
    def _records(self) -> dict[str, Any]:
        """By variable the part of the result that has it."""
        parts = (self.result, self.result.motion, self.result.forces)
        return {str(name): part for part in reversed(parts) for name in part.data.data_vars}

    def data(self) -> xr.Dataset:
        """The results as users read them, with names of the occurrences of events."""
        found: dict[str, Any] = {}
        coords: dict[str, Any] = {}
        for name, part in self._records.items():
            one = part.data[name]
            timed = one.dims[:1] == ("time",) and one.dtype.kind == "f"
            if (timed or name == "event_time") and name not in LEFT_OUT:
                found[name] = one.variable
                coords |= {dim: part.data[dim].variable for dim in one.dims if dim in part.data.coords}
        if "event_time" in found:
            named = [one.name for one in self.result.events]
            coords["occurrence"] = [
                name if name not in named[:j] else f"{name}_{named[: j + 1].count(name)}" for j, name in enumerate(named)
            ]
        return xr.Dataset(found, coords=coords)

    # The equations with other numbers.

    @cached_property
    def base(self) -> At:
        """The equations with the numbers of the run."""
        x, v = (
            given_positions(self.problem.system, self.options.positions),
            given_velocities(self.problem.system, self.options.velocities),
        )
        return At(self.problem.fresh(), (x, v), np.zeros_like(x))

    def _made(self, system: System, model: Model) -> At:
        old, given = self.base.problem, self.options.trajectory
        moving = model.trajectories[given] if isinstance(given, str) else given
        eq = with_numbers(old.eq, system, old.load_case, old.tasks, moving, self.t_end)
        start = given_positions(system, self.options.positions), given_velocities(system, self.options.velocities)
        shift = start[0] - self.base.given[0]
        shift[eq.free] = 0.0
        return At(replace(old, system=system, eq=eq), start, shift)

    def at(self, by: Varied, change: Floats) -> At:
        """With numbers changed by (K,)."""
        key = change.tobytes()
        if key not in self._others:
            anew = bool(self._anew[np.flatnonzero(change)].any())
            self._others[key] = found = self._changed(by, change, anew)
            self._same_jumps(found)
        return self._others[key]

    def _changed(self, by: Varied, change: Floats, anew: bool) -> At:
        """The same by the numbers of the elements alone, or by the model set up anew."""
        model = by.model_at(change) if anew else self.model
        return self._made(compile(model) if anew else by.changed(change), model)

    def _sort(self, by: Varied, read: Reading) -> None:
        """Find the numbers on which more depends than the numbers of the elements tell: loads, motions, inputs."""
        count = len(by.names)

        def told(which: NDArray[np.int64]) -> bool:
            change = np.zeros(count)
            change[which] = CLOSE * by.scale[which]
            one, two, base = (
                self._values(at, read) for at in (*(self._changed(by, change, anew) for anew in (False, True)), self.base)
            )
            if one.shape != two.shape or one.shape != base.shape:
                return False
            other = one != two
            one, two, base = (values[other] for values in (one, two, base))
            size = np.maximum(np.abs(one), np.abs(base))
            return bool((np.abs(one - two) <= 1e-3 * np.abs(two - base) + 1e-9 * CLOSE * size).all())

        def untold(which: NDArray[np.int64]) -> list[int]:
            if told(which):
                return []
            half = len(which) // 2
            return which.tolist() if not half else [*untold(which[:half]), *untold(which[half:])]

        self._anew = np.zeros(count, bool)
        self._anew[untold(np.arange(count))] = True

    def _values(self, at: At, read: Reading) -> Floats:
        """All that depends on numbers at fixed states: the equations, the start, what is read."""
        states, left = at.solved(read.states)
        eq = at.problem.eq
        times = [eq.piece_start, eq.force_time, eq.load_time]
        return np.concatenate([left.reshape(-1), eq.reals, *times, *at.given, self._columns(at, states, read).reshape(-1)])

    def _same_jumps(self, other: At) -> None:
        """Refuse numbers that move an instant at which a drive or support jumps, or a bend onto a sample of forces."""
        one, two = self.base.problem.eq, other.problem.eq
        if np.array_equal(one.piece_start, two.piece_start):
            return
        given = {*one.force_time.tolist(), *one.load_time.tolist()}
        if [t for t in jumps(one) if t not in given]:
            raise AnalysisError(
                "A number changes the instant at which a velocity or acceleration of a drive or support jumps; this gradient "
                "is not known. Take a motion without jumps, as Quintic."
            )
        bends = one.piece_start[one.piece_start != two.piece_start]
        if len(on := [t for t in self._forced if np.abs(bends - t).min() <= 10.0 * CLOSE * self.t_end]):
            raise AnalysisError(
                f"A force or acceleration is read at t = {on[0]:.6g} s, where a motion ends or changes its form, and a number "
                "moves that instant: it has one gradient before and one after it. Choose other samples."
            )

    @cached_property
    def _again(self) -> Repeated:
        return Repeated(self.problem, self.t_end)

    @cached_property
    def varying(self) -> Varying:
        """How the residual varies with states."""
        base, system = self.base, self.problem.system
        eq, parts, at = base.problem.eq, parts_of(system), sites(system)
        node = np.repeat(at["node"], 3)[eq.free]
        rows = site_of_rows(system)[eq.row]
        names = list(parts.index)
        near = [parts.around(("nodes", names[i])) if i >= 0 else None for i in node.tolist()]
        site = np.concatenate([node, rows]).astype(np.int64)
        kept = np.concatenate([np.arange(len(eq.free)), len(eq.free) + np.flatnonzero(~eq.redundant)])
        length = np.asarray(self.work.control.length, float)
        length = np.where(np.isfinite(length) & (length > 0), length, 1.0)
        elastic = bool(eq.law_A.size or eq.element.size)
        return Varying(
            lambda states: base.solved(states)[1], eq.free, kept, Columns.of(near, len(names)), site, length, elastic
        )

    # What responses read at samples and at events.

    def _kept(self, name: str) -> tuple[NDArray[np.int64], ...]:
        """Places of the values that users read along the axes after time."""
        whole = self._records[name].whole
        found = users_of(whole.isel(time=[0]), name)
        return tuple(np.asarray(one).reshape(-1) for one in found[1:])

    def _columns(self, at: At, states: States, read: Reading) -> Floats:
        """Values (s, values) at solved states of `at`."""
        found, count = [], len(states.t)
        if read.others:
            work = copy(self.work)
            work.problem, work.angles, work.worst, work.ended = (
                at.problem,
                self.work.angles.copy(),
                self.work.worst.copy(),
                False,
            )
            whole = simulation_of(work, at.trace(states))
            parts = {"result": whole, "motion": whole.motion, "forces": whole.forces}
        for name in read.names:
            if name in PLAIN:
                values = states[1 + PLAIN[name]].reshape(count, -1, 3)
            else:
                values = parts[read.part[name]].arrays[name].values
            found.append(values[np.ix_(np.arange(count), *read.kept[name])].reshape(count, -1))
        return np.concatenate([*found, gaps(at.problem, self.base.problem.eq, states)], axis=1)

    @one_thread
    def gradients(self, by: Varied, seeds: Sequence[Mapping[str, Floats]]) -> Floats:
        """Derivatives (k, numbers) of k responses with seeds ds/dd by the variables that they read."""
        read = self._reading(seeds)
        if not len(read.states.t):
            return np.zeros((len(seeds), len(by.names)))
        self._others.clear()
        self._forced = read.states.t[np.abs(read.z).max(axis=(1, 2), initial=0.0) > 0].tolist()
        self._sort(by, read)
        found = self._of_marks(by, read)
        good = max(GOOD, 3.0 * self.problem.method.rtol)
        for _ in range(BEST + 1):
            gradient, start, error = self._swept(by, read)
            if error <= good or error > 0.5 * read.error:
                break
            read.share, read.error = 0.5 * read.share, error
        error = min(error, read.error)
        if not error <= FAIR * good:
            raise AnalysisError(
                f"The gradient along the run is not known to more than {error:.2g} of its size: a force that jumps or bends "
                "(dry friction, an impact), or a motion that the method follows too roughly. Tighten rtol, or smooth it."
            )
        return found + gradient + of_start(self, by, start)

    def _reading(self, seeds: Sequence[Mapping[str, Floats]]) -> Reading:
        """What is read where: seeds at marks, with what follows from times of events, reduced to weights of places and
        velocities.
        """
        names = [name for name in dict.fromkeys(name for one in seeds for name in one) if name != "event_time"]
        kept, events = {name: self._kept(name) for name in names}, self.work.happened()["events"]
        wanted, of_time, met, stop = self._wanted(seeds, events)
        at = {float(t): k for k, t in enumerate(self.trace.t)}
        times = np.unique(np.concatenate([self.trace.t[wanted], events[met, 1]]))
        places = [at.get(float(t), -1) for t in times]
        if min(places, default=0) < 0:
            states = self._again.states(times)
        else:
            row, trace = self.base.problem.eq.row, self.trace
            states = States(trace.t, trace.x, trace.v, trace.a, trace.N[:, row]).part(places)
        homes = {id(self.result): "result", id(self.result.motion): "motion", id(self.result.forces): "forces"}
        part = {name: homes[id(self._records[name])] for name in names}
        read = Reading(names, kept, part, any(name not in PLAIN for name in names), states)
        k, count = len(seeds), len(self.problem.events)
        pieces = []
        for name in names:
            size = int(np.prod([len(one) for one in kept[name]], initial=1))
            own = np.zeros((k + len(met), len(times), size))
            for i, one in enumerate(seeds):
                if name in one:
                    for j, place in enumerate(places):
                        if place >= 0:
                            own[i, j] = one[name][place].reshape(-1)
            pieces.append(own)
        gaps = np.zeros((k + len(met), len(times), count))
        for j, event in enumerate(met):
            gaps[k + j, int(np.flatnonzero(times == events[event, 1])[0]), int(events[event, 0])] = 1.0
        read.weight = np.concatenate([*pieces, gaps], axis=2)
        read.site = np.concatenate([*(self._sites(name).reshape(-1) for name in names), np.full(count, -1)]).astype(np.int64)
        read.share, read.error = SHARE[type(self.problem.method).__name__], np.inf
        self._reduce(read)
        self._follow_events(read, [(one, float(events[one, 1]), of_time[:, one], one == stop) for one in met], k)
        return read

    def _wanted(
        self, seeds: Sequence[Mapping[str, Floats]], events: Floats
    ) -> tuple[NDArray[np.bool_], Floats, list[int], int]:
        """Samples that are read (times,), seeds of the times of events (k, events), events whose times count, and that which
        ends the run, or -1.
        """
        wanted = np.zeros(len(self.trace.t), bool)
        for one in seeds:
            for name, own in one.items():
                if name != "event_time":
                    wanted |= np.abs(own).reshape(len(own), -1).max(axis=1, initial=0.0) > 0
        stopped = self.result.status.name == "EVENT"
        if stopped and wanted[-2:].all() and len(wanted) > 1:
            raise AnalysisError(
                "A mean over time, or a value between samples, of a run that an event ends has no gradient by the time of that "
                "end. Give the run an end in time, or read final(...), max(...) or an earlier instant."
            )
        of_time = np.array([one.get("event_time", np.zeros(len(events))) for one in seeds])
        met = np.flatnonzero(np.abs(of_time).max(axis=0, initial=0.0) > 0).tolist()
        last = max([*self.trace.t[wanted], *events[met, 1]], default=0.0)
        for k, t, *_ in events[events[:, 1] <= last]:
            if (name := list(self.problem.events)[int(k)]) not in (self.options.events or {}):
                raise AnalysisError(
                    f"The run has no gradient beyond t = {t:.6g} s: there {name} is met or left, and its force bends. Read "
                    "earlier values, or take an elastic element without a gap."
                )
        stop = len(events) - 1 if stopped and wanted[-1] else -1
        return wanted, of_time, met + [stop] * (stop >= 0 and stop not in met), stop

    def _sites(self, name: str) -> NDArray[np.int64]:
        """The node of each value that users read, (values,)."""
        one = self._records[name].whole[name].isel(time=0)
        own = sites_along(self.problem.system, one)
        return np.asarray(own[np.ix_(*self._kept(name))] if own.ndim else own)

    def _reduce(self, read: Reading) -> None:
        """Weights of places and velocities at the marks (marks, k, free), and of the residual there, from those of values."""
        vary, base, states, weight = self.varying, self.base, read.states, read.weight.swapaxes(0, 1)
        eq, used = base.problem.eq, np.flatnonzero(np.abs(read.weight).max(axis=(0, 1), initial=0.0) > 0)

        def by(name: str, flat: NDArray[np.int64], step: Floats, columns: Columns, points: Any = TWO) -> Floats:
            moved = getattr(states, name).copy()

            def change(group: list[int]) -> Floats:
                return vary.nudged(
                    lambda own: self._columns(base, states._replace(**{name: own}), read)[:, used],
                    moved,
                    flat[group],
                    step[group],
                    points,
                )

            found = np.zeros((*weight.shape[:2], len(flat)))
            for j, where, effect in columns.found(change, read.site[used]):
                found[:, :, j] = np.einsum("mkv,mv->mk", weight[:, :, used][:, :, where], effect) / step[j]
            return found

        f, r = len(eq.free), len(eq.row)
        alone = Columns([[j] for j in range(r)], [None] * r, vary.columns.nodes)
        sizes = [float(np.abs(one).max(initial=0.0)) or 1.0 for one in (states.v, states.a, states.N)]
        if read.others or read.weight[..., weight.shape[2] - len(self.problem.events) :].any():
            sx = by("x", eq.free, vary.reach * vary.length, vary.columns, vary.points)
            sv, sa = (
                by(name, eq.free, np.full(f, 1e-3 * size), vary.columns) for name, size in (("v", sizes[0]), ("a", sizes[1]))
            )
            sN = by("N", np.arange(r), np.full(r, 1e-3 * sizes[2]), alone)
        else:
            sx, sv, sa = self._plain(read)
            sN = np.zeros((*weight.shape[:2], r))
        if eq.redundant.any() and np.abs(sN).max(initial=0.0) > 0:
            raise AnalysisError(
                "A response reads forces that are not unique, because constraints depend on each other; they have no gradient. "
                "Read positions, velocities or energies, or leave the redundant members out."
            )
        tangent = vary.tangent(states)
        z = vary.weights(tangent, sa, sN)
        read.z = z
        read.sx, read.sv = sx - z[:, :, vary.kept] @ tangent.rx, sv - z[:, :, vary.kept] @ tangent.rv

    def _plain(self, read: Reading) -> list[Floats]:
        """Weights of free coordinates of x, v, a where nothing else is read."""
        free, first = self.base.problem.eq.free, 0
        whole = np.zeros((3, *read.weight.shape[:2], *self.problem.system.x0.shape))
        for name in read.names:
            nodes, axes = read.kept[name]
            size = len(nodes) * len(axes)
            own = read.weight[:, :, first : first + size].reshape(*read.weight.shape[:2], len(nodes), len(axes))
            whole[PLAIN[name]][:, :, nodes[:, None], axes] += own
            first += size
        return [one.reshape(*read.weight.shape[:2], -1)[:, :, free].swapaxes(0, 1) for one in whole]

    def _follow_events(self, read: Reading, met: list[tuple[int, float, Floats, bool]], k: int) -> None:
        """Add what the times of events change: dt = -(change of what is watched)/(its rate)."""
        if met:
            rate = self._rates(read)
            for j, (_, t, of_time, stops) in enumerate(met):
                m = int(np.flatnonzero(read.states.t == t)[0])
                own, size = (
                    rate[m, k + j],
                    float(np.abs(read.sx[m, k + j]) @ np.abs(read.states.v[m, self.base.problem.eq.free])),
                )
                if not abs(own) > 1e-9 * size or own == 0.0:
                    raise AnalysisError(f"What is watched only touches its value at t = {t:.6g} s; that time has no gradient.")
                for i in range(k):
                    share = -(of_time[i] + (rate[m, i] if stops else 0.0)) / own
                    read.sx[m, i] += share * read.sx[m, k + j]
                    read.sv[m, i] += share * read.sv[m, k + j]
                    read.z[m, i] += share * read.z[m, k + j]
                    read.weight[i, m] += share * read.weight[k + j, m]
        read.sx, read.sv, read.z, read.weight = read.sx[:, :k], read.sv[:, :k], read.z[:, :k], read.weight[:k]

    def _rates(self, read: Reading) -> Floats:
        """Rates (marks, k) of what is read along the motion."""
        at, free = read.states, self.base.problem.eq.free
        found = np.einsum("mkf,mf->mk", read.sx, at.v[:, free]) + np.einsum("mkf,mf->mk", read.sv, at.a[:, free])
        step = 1e-6 * self.t_end
        for way in (1.0, -1.0):
            states, left = self.base.solved(at._replace(t=at.t + way * step))
            values = self._columns(self.base, states, read)
            found += way * 0.5 / step * (np.einsum("kmv,mv->mk", read.weight, values) - np.einsum("mkr,mr->mk", read.z, left))
        return np.asarray(found)

    def _of_marks(self, by: Varied, read: Reading) -> Floats:
        """Derivatives by the numbers at fixed states of the marks."""
        k = read.weight.shape[0]

        def of(change: Floats) -> Floats:
            at = self.at(by, change)
            states, left = at.solved(read.states)
            values = np.einsum("kmv,mv->kv", read.weight, self._columns(at, states, read))
            return np.concatenate([-np.einsum("mkr,mr->kr", read.z, left), values], axis=1).reshape(-1)

        return self.by_numbers(by, of, np.concatenate([self.varying.site, read.site]), k)

    def by_numbers(self, by: Varied, of: Any, site: NDArray[np.int64], k: int) -> Floats:
        """Derivatives (k, numbers) of k sums of terms (k m,), each at a node (m,)."""
        weight, vary = np.kron(np.eye(k), np.ones(len(site))).astype(float), self.varying
        step = (STEP if vary.elastic else CLOSE) * by.scale
        return differences(Weighed(of, weight, np.tile(site, k)), by.near, step, vary.columns.nodes, vary.points)

    # The adjoint along the run.

    def _swept(self, by: Varied, read: Reading) -> tuple[Floats, Floats, float]:
        """Derivatives (k, numbers) by what numbers do along the run; the adjoint (k, 2 free) at the start; its error."""
        vary, base, k = self.varying, self.base, read.weight.shape[0]
        f, last, stiff = len(vary.free), float(read.states.t[-1]), isinstance(self.problem.method, Radau)
        jump = {float(t): np.concatenate([sx, sv], axis=1) for t, sx, sv in zip(read.states.t, read.sx, read.sv, strict=True)}
        adjoint, found = jump[last], np.zeros((k, len(by.names)))
        if last == 0.0:
            return found, adjoint, 0.0
        breaks = [t for t in jumps(base.problem.eq, all_pieces=True) if 0.0 < t < last]
        bends = self.work.happened()["events"][:, 1]
        inner = np.concatenate([read.states.t, breaks, bends[(bends > 0.0) & (bends < last)]])
        edges = edges_between(np.unique(np.concatenate([[0.0], inner])), *steps_of(self._noted, self.t_end), read.share)
        size = STAGES * (f + len(vary.site)) ** 2 * 40 + (STAGES * f) ** 2 * 32 * stiff
        eq = base.problem.eq
        least = REST * np.concatenate([vary.length / self.t_end, vary.length / self.t_end**2])
        timed = bool(len(eq.motion_kind) or len(eq.force_time) > len(eq.force_kind) or len(eq.load_time))
        drift, error, scale = np.zeros(k), np.zeros(k), np.full(k, 1e-300)
        for own, every in self._again.backwards(edges, max(1, int(ROOM / size)), gauss(STAGES).c):
            h = np.diff(own)
            ends = np.arange(len(own)) * (STAGES + 1)
            at = every.part(np.setdiff1d(np.arange(len(every.t)), ends))
            tangent = vary.tangent(at)
            jumps_here = np.array([jump.get(float(t), np.zeros_like(adjoint)) for t in own[:-1]])
            later, earlier, inner = back_through(tangent, h, STAGES, adjoint, jumps_here, stiff)
            adjoint = earlier[0] + jumps_here[0]
            of_a = inner.reshape(len(h) * STAGES, k, f)
            z = vary.weights(tangent, of_a)
            found -= self.by_numbers(by, lambda change, at=at, z=z: self._sums(by, change, at, z), vary.site, k)
            # l^T (v, a) changes by what depends on time
            rate = np.concatenate([every.v[ends][:, vary.free], every.a[ends][:, vary.free]], axis=1)
            gain = np.einsum("ckf,cf->ck", later, rate[1:]) - np.einsum("ckf,cf->ck", earlier, rate[:-1])
            if timed:
                step = 1e-4 * np.repeat(h, STAGES)
                left = [base.solved(at._replace(t=at.t + way * step))[1] for way in (1.0, -1.0)]
                by_time = np.einsum("skr,sr->sk", z, (left[0] - left[1]) / (2.0 * step[:, None]))
                gain += by_time.reshape(len(h), STAGES, k).sum(axis=1)
            gain[np.isin(own[:-1], breaks) | np.isin(own[1:], breaks)] = 0.0
            sums = drift + np.cumsum(gain[::-1], axis=0)
            drift, error = sums[-1], np.maximum(error, np.abs(sums).max(axis=0))
            scale = np.maximum(scale, np.einsum("ckf,cf->ck", np.abs(later), np.abs(rate[1:]) + least).max(axis=0))
        return found, adjoint, float((error / scale).max(initial=0.0))

    def _sums(self, by: Varied, change: Floats, at: States, z: Floats) -> Floats:
        return np.asarray(np.einsum("skr,sr->kr", z, self.at(by, change).solved(at)[1]).reshape(-1))
