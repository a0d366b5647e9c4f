"""A model as a function of its variables: the response that is made small, the limits, and their exact gradients."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from kinetruss.design.limit_rows import Block, LimitRows
from kinetruss.design.optimum.evaluations import BeyondError
from kinetruss.design.optimum.problem import Problem, Variable
from kinetruss.design.own_limits import NAMES, beside, names_of, slopes
from kinetruss.design.vibration_point import VibrationPoint
from kinetruss.errors import AnalysisError, Fault, InputError, ModelError
from kinetruss.gradients import Entries, read_entries
from kinetruss.gradients.analyses import POINTS, point_of
from kinetruss.gradients.points import gradients_at
from kinetruss.gradients.responses import Sheet
from kinetruss.gradients.varied import varied
from kinetruss.io import set_values
from kinetruss.io.values import fitting, number_at, resolved
from kinetruss.mechanics import compile
from kinetruss.model import Model, OptimumLimit, OptimumTask, OptimumVariable, nearest
from kinetruss.model.optimum import unit_given
from kinetruss.units import dimension_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

OBJECTIVE = "least"
FREQUENCIES = "flexible.frequencies"
"""Of those that meet, each keeps the derivative along its own shape."""
STEP = 1e-3
"""Of differences of what a member bears, as a share of a variable or its range."""
AT_ONCE = 20_000_000
"""Numbers of the seeds of responses that are differentiated together."""
STILL = 1e-12
"""A change of a value below this, of itself, is none."""


@dataclass(frozen=True, slots=True)
class _Asked:
    """One analysis: its arguments, and the responses that are read of it, each with its first row of limits (-1: objective)."""

    analysis: str
    arguments: dict[str, Any]
    texts: list[tuple[str, str]]
    """Name of the limit, response."""


class _Solved(NamedTuple):
    """The model at a point p, its analyses at their solution, and the entries of their responses."""

    key: bytes
    model: Model
    points: list[Any]
    entries: list[list[Entries]]


class ModelFunction:
    """The `Function` of a task: rows of limits in the order of the task, its load cases, entries, sides.

    parts : paths with one value: the index of their variable, the factor, the paths. problem : for the solvers.
    """

    def __init__(self, model: Model, task: OptimumTask) -> None:
        self.model, self.task = model, task
        self.parts, variables = _variables(model, task)
        self.factors = np.zeros((len(self.parts), len(variables)))
        """Derivatives of the values of `parts` by the variables."""
        for i, (k, factor, _) in enumerate(self.parts):
            self.factors[i, k] = factor
        name = _own(task)
        self.own = None if name is None else [one.name for one in variables].index(name)
        self.sign = -1.0 if task.least.startswith("-") else 1.0
        """The variable that is itself made small, or large."""
        self.unit = "" if self.own is None else variables[self.own].unit
        self.asked = _asked(model, task)
        self._last: _Solved | None = None
        start = np.array([one.start for one in variables])
        found = self._entries(start)
        self.limits = self._rows(found)
        self.at_start = [value for _, _, value in self.limits.worst(found)]
        """The worst value of each block of limits at the start."""
        self.problem = Problem(
            variables=variables, limits=self.limits, function=self, objective=task.least, unit=self.unit,
            families=self.limits.families,
        )  # fmt: skip

    def model_at(self, p: NDArray[np.float64]) -> Model:
        """The model with these values of the variables."""
        values = {path: float(factor * p[k]) for k, factor, paths in self.parts for path in paths}
        return set_values(self.model, values)

    def limits_at(self, p: NDArray[np.float64]) -> LimitRows:
        """The limits with the names of what they are on at these values of the variables."""
        return self.limits.at(self._entries(p))

    def worst(self, p: NDArray[np.float64]) -> Iterator[tuple[Block, str, float, float]]:
        """Of each block of limits: what its worst value is of, this value, and that at the start."""
        for (block, subject, value), before in zip(self.limits.worst(self._entries(p)), self.at_start, strict=True):
            yield block, subject, value, before

    def values(self, p: NDArray[np.float64], rows: NDArray[np.int64] | None) -> tuple[float, NDArray[np.float64]]:
        """Objective, and excess of limits."""
        found = self._entries(p)
        return self._objective(found, p), self.limits.excess(found)[slice(None) if rows is None else rows]

    def gradients(self, p: NDArray[np.float64], rows: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Derivatives of both by the variables, in SI."""
        solved = self._at(p)
        by = varied(solved.model, [paths for _, _, paths in self.parts])
        slope = np.zeros((len(rows), len(p)))
        of_objective = np.array([self.sign * (k == self.own) for k in range(len(p))])
        for j, (asked, point, read) in enumerate(zip(self.asked, solved.points, solved.entries, strict=True)):
            # both sides of a limit have the gradient of one entry
            wanted: dict[tuple[int, int], list[int]] = {}
            wanted |= {(i, 0): [] for i, (name, _) in enumerate(asked.texts) if name == OBJECTIVE}
            for place, row in enumerate(rows.tolist()):
                block, k = self.limits.place(row)
                if block.analysis == j:
                    wanted.setdefault((block.text, int(block.kept[k])), []).append(place)
            if not wanted:
                continue
            if any(np.isinf(read[text].values).any() for text, _ in wanted):
                raise BeyondError(p)
            most = max(1, AT_ONCE // max(read[text].values.size for text, _ in wanted))
            every = list(wanted.items())
            for some in (every[k : k + most] for k in range(0, len(every), most)):
                seeds = [read[text].seeds(entry) for (text, entry), _ in some]
                for ((text, _), places), found in zip(some, self._slopes(p, point, by, seeds), strict=True):
                    if asked.texts[text][0] == OBJECTIVE:
                        of_objective = found
                    for place in places:
                        slope[place] = found * self.limits.sign_over_size[rows[place]]
        return of_objective, slope

    def _slopes(self, p: NDArray[np.float64], point: Any, by: Any, seeds: Sequence[Mapping[str, Any]]) -> Any:
        """Derivatives (responses, n): of results by the analysis, of what members bear by its formulas."""
        own = [{name: one for name, one in seed.items() if name not in NAMES} for seed in seeds]
        found = np.zeros((len(seeds), len(p)))
        if some := [k for k, seed in enumerate(own) if seed]:
            chosen = [own[k] for k in some]
            slope = point.gradients(by, chosen) if hasattr(point, "gradients") else gradients_at(point, by, chosen)
            found[some] = slope @ self.factors
        if any(name in seed for seed in seeds for name in NAMES):
            variables = self.problem.variables
            step = STEP * np.array([abs(at) or one.upper - one.lower for at, one in zip(p, variables, strict=True)])
            for name, slope in slopes(self.model_at, p, names_of(point.data()), step).items():
                for k, seed in enumerate(seeds):
                    if name in seed:
                        found[k] += np.nan_to_num(seed[name]) @ np.nan_to_num(slope)
        return found

    def entries(self, p: NDArray[np.float64]) -> Iterator[tuple[_Asked, str, Entries]]:
        """All responses at a point: their analysis, the name of their limit, their values."""
        for asked, read in zip(self.asked, self._entries(p), strict=True):
            for (name, _), one in zip(asked.texts, read, strict=True):
                yield asked, name, one

    def idle(self, p: NDArray[np.float64]) -> list[str]:
        """The variables that change neither objective nor any limit."""
        here = self._entries(p)
        before, left = np.append(self.limits.excess(here), self._objective(here, p)), []
        for k, one in enumerate(self.problem.variables):
            moved = p.copy()
            moved[k] += 0.01 * (one.upper - one.lower) * (1 if p[k] < 0.5 * (one.lower + one.upper) else -1)
            try:
                there = self._entries(moved)
            except (AnalysisError, ModelError):  # it does something
                continue
            after = np.append(self.limits.excess(there), self._objective(there, moved))
            if np.all(np.abs(after - before) <= STILL * np.maximum(np.abs(before), 1e-3 * np.abs(before).max())):
                left.append(one.name)
        return left

    def _entries(self, p: NDArray[np.float64]) -> list[list[Entries]]:
        return self._at(p).entries

    def _at(self, p: NDArray[np.float64]) -> _Solved:
        """The analyses at a point; those at the last one are kept, as gradients follow values."""
        key = p.tobytes()
        if self._last is None or self._last.key != key:
            self._last = self._solved(self.model_at(p), key)
        return self._last

    def _solved(self, model: Model, key: bytes = b"") -> _Solved:
        points = [_analysed(asked, compile(model)) for asked in self.asked]
        entries = []
        for asked, point in zip(self.asked, points, strict=True):
            data = point.data()
            sheet = Sheet.of(data, ChainMap(getattr(point, "more", {}), cast("Any", beside(model, names_of(data)))))
            entries.append([_read(name, text, sheet) for name, text in asked.texts])
        return _Solved(key, model, points, entries)

    def judged(self, model: Model) -> tuple[float, float, str]:
        """Of this model with other parts: the objective (NaN if it is a variable that is gone with the part), the largest
        excess of a limit, and its name.
        """
        found = self._solved(model).entries
        limits = self.limits.at(found)
        excess = limits.excess(found)
        worst = int(excess.argmax()) if len(excess) else -1
        name = limits[worst].subject if len(excess) else ""
        return self._of_parts(model, found), float(excess[worst]) if len(excess) else -np.inf, name

    def _of_parts(self, model: Model, found: list[list[Entries]]) -> float:
        if self.own is None:
            return self._objective(found, np.zeros(0))
        path = next(paths[0] for k, _, paths in self.parts if k == self.own)
        try:
            return self.sign * number_at(model, path, resolved(model, path))
        except InputError:
            return np.nan

    def _objective(self, found: list[list[Entries]], p: NDArray[np.float64]) -> float:
        if self.own is not None:
            return self.sign * float(p[self.own])
        for asked, read in zip(self.asked, found, strict=True):
            for (name, _), one in zip(asked.texts, read, strict=True):
                if name == OBJECTIVE:
                    return float(one.values)
        raise AssertionError

    def _rows(self, found: list[list[Entries]]) -> LimitRows:
        blocks, faults = [], []
        for j, (asked, read) in enumerate(zip(self.asked, found, strict=True)):
            case = asked.arguments.get("load_case")
            for i, ((name, text), one) in enumerate(zip(asked.texts, read, strict=True)):
                if name == OBJECTIVE:
                    self.unit = one.unit
                    if one.dims:
                        said = f"{text!r} has a value for each {', '.join(one.dims)}."
                        mend = "Take one of them by name, or max(...), sum(...), pnorm(..., 8)."
                        raise ModelError([Fault((OBJECTIVE,), said, mend)])
                    continue
                own, kept = self.task.limits[name], np.flatnonzero(~np.isnan(one.values.reshape(-1)))
                if not len(kept):
                    faults.append(Fault(("limits", name, "of"), f"{text!r} has no value that is known.", "See what it needs."))
                for side, limit, sign in (("at_most", own.at_most, 1), ("at_least", own.at_least, -1)):
                    if limit is None or not len(kept):
                        continue
                    faults += _unit_faults(name, side, limit, one.unit, text)
                    size = abs(float(limit)) or float(np.nanmax(np.abs(one.values))) or 1.0
                    made = Block(
                        name=name, case=case, analysis=j, text=i, of=one, kept=kept, limit=float(limit), size=size, sign=sign,
                        unit=one.unit or unit_given(limit) or "",
                    )  # fmt: skip
                    blocks.append(made)
        if faults:
            raise ModelError(faults)
        return LimitRows(blocks)


def _read(name: str, text: str, sheet: Sheet) -> Entries:
    try:
        return read_entries(text, sheet)
    except InputError as error:
        path = (OBJECTIVE,) if name == OBJECTIVE else ("limits", name, "of")
        raise ModelError([Fault(path, str(error), "")]) from None


def _unit_faults(name: str, side: str, limit: float, unit: str, text: str) -> Iterator[Fault]:
    given = unit_given(limit)
    if given is not None and _dimension(given) != _dimension(unit):
        yield Fault(
            ("limits", name, side), f"is in {given or '1'}, but {text} in {unit or '1'}.", f"Give it in {unit or 'no unit'}."
        )


def _own(task: OptimumTask) -> str | None:
    """The variable that is itself made small, or large if a minus stands before it."""
    name = task.least.removeprefix("-").strip()
    return name if name in task.variables else None


def _dimension(unit: str) -> tuple[int, ...]:
    """Exponents of a unit, also of one as ``1/s``."""
    return tuple(-one for one in dimension_of(unit[2:])) if unit.startswith("1/") else dimension_of(unit)


def _analysed(asked: _Asked, system: Any) -> Any:
    """The analysis of a system at its solution."""
    point = VibrationPoint if asked.analysis == FREQUENCIES else point_of(asked.analysis)
    try:
        return point(system, **asked.arguments)
    except TypeError as error:
        raise ModelError(
            [Fault(("arguments",), f"{asked.analysis} does not take them: {error}.", "See its arguments.")]
        ) from None


def _asked(model: Model, task: OptimumTask) -> list[_Asked]:
    """The analyses of a task, each once."""
    found: dict[str, _Asked] = {}
    faults: list[Fault] = []

    def ask(place: tuple[str, ...], name: str, one: OptimumLimit | None, case: str | None) -> None:
        analysis = (one.analysis if one is not None else None) or task.analysis
        arguments = {**task.arguments, **(one.arguments if one is not None else {})}
        if analysis not in POINTS:
            faults.append(Fault((*place, "analysis"), f"results of {analysis!r} have no gradients.", nearest(analysis, POINTS)))
            return
        if case is not None:
            arguments["load_case"] = case
        text = task.least if one is None else one.of
        found.setdefault(f"{analysis} {sorted(arguments.items())}", _Asked(analysis, arguments, [])).texts.append((name, text))

    known = [*model.load_cases, *model.combinations]
    for name, one in task.limits.items():
        cases: Sequence[str | None] = one.load_cases or task.load_cases or (None,)
        for case in cases:
            if case is not None and case not in known:
                place = ("limits", name, "load_cases") if one.load_cases else ("load_cases",)
                faults.append(Fault(place, f"the model has no load case called {case!r}.", nearest(case, known)))
            else:
                ask(("limits", name), name, one, case)
    if _own(task) is None:
        ask((), OBJECTIVE, None, (task.load_cases or (None,))[0] if not faults else None)
    if faults:
        raise ModelError(list(dict.fromkeys(faults)))
    return list(found.values())


Part = tuple[int, float, list[str]]
"""Paths that have the value of the variable with this index, times the factor."""


def _variables(model: Model, task: OptimumTask) -> tuple[list[Part], list[Variable]]:
    """Parts and bounds of the variables; all faults at once."""
    parts: list[Part] = []
    found: list[Variable] = []
    faults: list[Fault] = []
    owner: dict[tuple[str | int, ...], str] = {}
    for name, one in task.variables.items():
        try:
            k = len(found)
            own: list[Part] = [(k, 1.0, [path for pattern in one.of for path in fitting(model, pattern)])]
            own += [(k, factor, fitting(model, pattern)) for pattern, factor in one.multiples.items()]
            for path in (path for _, _, paths in own for path in paths):
                keys = resolved(model, path)
                if owner.setdefault(keys, name) != name:
                    raise InputError(f"changes {path}, which {owner[keys]!r} changes too. Leave it out of one of them.")
            found.append(_variable(model, name, one, own))
            parts += own
        except ModelError as error:
            faults += [
                Fault(("variables", name, "of"), f"{fault.where}: {fault.message}", fault.mend) for fault in error.faults
            ]
        except InputError as error:
            faults.append(Fault(("variables", name, "of"), str(error), ""))
    if faults:
        raise ModelError(faults)
    return parts, found


def _variable(model: Model, name: str, one: OptimumVariable, own: list[Part]) -> Variable:
    """The bounds in SI; the model must take both."""
    low, high = one.between if one.between is not None else (min(one.choose or ()), max(one.choose or ()))
    for bound in (low, high):
        set_values(model, {path: factor * float(bound) for _, factor, paths in own for path in paths})
    values = [number_at(model, path, resolved(model, path)) for path in own[0][2]]
    start = float(one.start) if one.start is not None else float(np.mean(values))
    return Variable(name=name, lower=float(low), upper=float(high), start=float(np.clip(start, low, high)), scale=one.scale,
                    unit=unit_given(low) or "")  # fmt: skip
