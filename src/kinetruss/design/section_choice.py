"""The last step of an optimum: values from lists, improved step by step; those of a truss are proven by branch and bound."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.design.optimum.evaluations import FEASIBLE, Evaluations, OutsideError
from kinetruss.design.optimum.truss_sections import KEPT, Proof, SectionTask, lightest
from kinetruss.errors import AnalysisError
from kinetruss.mechanics import compile, constraint_jacobian
from kinetruss.statics.linear_statics import known_forces
from kinetruss.statics.small_displacements import flexibility, loads_at, stiff_rows, weight_word

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.design.model_function import ModelFunction

Choice = tuple[int, ...]
AGREES = 1e-6
"""Largest relative difference between the truss that is proven and the analysis of the model."""


def chosen(
    function: ModelFunction, asked: Evaluations, p: NDArray[np.float64], told: Any
) -> tuple[NDArray[np.float64], Proof | None, list[str]]:
    """Values from the lists near the optimum p without them, the proof if there is one, and remarks.

    Raises
    ------
    AnalysisError : no choice was found that keeps all limits.
    """
    own = list(function.task.variables.values())
    lists = [np.sort(one.choose) if one.choose is not None else np.array([value]) for one, value in zip(own, p, strict=True)]
    mixed = any(one.choose is None for one in own)
    notes = ["Variables without a list keep the values of the optimum without lists."] if mixed else []
    task, why = (None, "some variables have no list") if mixed else section_task(function, lists)

    def judged(choice: Choice) -> tuple[float, float]:
        if task is not None:
            return task.cost(np.array(choice)), task.used(np.array(choice)) - 1
        try:
            value, excess = asked.values(np.array([one[k] for one, k in zip(lists, choice, strict=True)]))
        except OutsideError:
            return np.inf, np.inf
        return value, float(excess.max(initial=0.0))

    start = tuple(
        min(int(np.searchsorted(one, value * (1 - FEASIBLE))), len(one) - 1) for one, value in zip(lists, p, strict=True)
    )
    best = improved(judged, start, [len(one) for one in lists], KEPT if task is not None else FEASIBLE)
    proof = None
    if task is not None:
        progress = None if told is None else lambda boxes, cost, bound: told(boxes, cost, bound)
        proof = lightest(task, None if best is None else np.array(best), function.task.seconds, progress)
        best = None if proof.choice is None else tuple(proof.choice.tolist())
        if best is None and proof.closed:
            raise AnalysisError(
                "No choice from the lists keeps all limits; this is proven. Add larger values, or widen the limits."
            )
    else:
        notes.append(f"The choice is not proven: {why}.")
    if best is None:
        raise AnalysisError("No choice from the lists was found that keeps all limits. Add larger values, or widen the limits.")
    return np.array([one[k] for one, k in zip(lists, best, strict=True)]), proof, notes


def improved(
    judged: Callable[[Choice], tuple[float, float]], start: Choice, sizes: Sequence[int], kept: float
) -> Choice | None:
    """A choice that keeps all limits and that no step of one or two variables improves; None if none was found.

    judged : objective and largest excess of a choice.
    """
    known: dict[Choice, tuple[float, float]] = {}

    def at(choice: Choice) -> tuple[float, float]:
        if choice not in known:
            known[choice] = judged(choice)
        return known[choice]

    here = start
    while at(here)[1] > kept:
        up = [_moved(here, {k: 1}, sizes) for k in range(len(here))]
        if not (better := [one for one in up if one is not None and at(one)[1] < at(here)[1]]):
            top = tuple(size - 1 for size in sizes)
            if here == top or at(top)[1] > kept:
                return None
            here = top
            continue
        here = min(better, key=lambda one: at(one)[1])
    single = [{k: step} for k in range(len(here)) for step in (-1, -2, 1)]
    double = [
        {k: a, j: b}
        for k, j in itertools.combinations(range(len(here)), 2)
        for a, b in ((-1, -1), (-1, 1), (1, -1), (-2, 1), (1, -2))
    ]
    moving = True
    while moving:
        moving = False
        for moves in (single, double):
            near = [one for move in moves if (one := _moved(here, move, sizes)) is not None]
            good = [one for one in near if at(one)[0] < at(here)[0] and at(one)[1] <= kept]
            if good:
                here, moving = min(good, key=lambda one: at(one)[0]), True
                break
    return here


def _moved(choice: Choice, steps: dict[int, int], sizes: Sequence[int]) -> Choice | None:
    found = list(choice)
    for k, step in steps.items():
        found[k] += step
        if not 0 <= found[k] < sizes[k]:
            return None
    return tuple(found)


# The model as a truss whose sections can be proven.


def section_task(function: ModelFunction, lists: Sequence[NDArray[np.float64]]) -> tuple[SectionTask | None, str]:
    """The truss of a model whose variables are areas of bars, or why it is none, in words."""
    if len({repr((one.analysis, one.arguments.get("weight"))) for one in function.asked}) > 1:
        return None, "limits are of several analyses"
    if any(one.analysis != "statics.linear" for one in function.asked):
        return None, "branch and bound knows trusses under small displacements (statics.linear) alone"
    if any(one.arguments.get("weight", True) is not False for one in function.asked):
        return None, "loads change with the sections; without weight (arguments: {weight: false}) it would be"
    if any(one.multiples for one in function.task.variables.values()):
        return None, "variables have multiples"
    least, most = (np.array([f(one) for one in lists]) for f in (np.min, np.max))
    found = _truss(function, most)
    if isinstance(found, str):
        return None, found
    directions, flexible, loads, at, cases = found
    group = _groups(function, lists, flexible)
    if group is None:
        return None, "variables are not the areas of bars, each of one, or bars have other areas"
    slope, _ = function.gradients(most, np.zeros(0, np.int64))
    middle = 0.5 * (least + most)
    straight = abs(slope @ (middle - most) - (function.values(middle, None)[0] - function.values(most, None)[0]))
    if straight > AGREES * abs(function.values(most, None)[0]):
        return None, f"{function.task.least} is not the sum of what each bar costs"
    rest = (function.values(most, None)[0] - slope @ most) / len(lists)
    limits = _limits(function, most, directions, at, cases, lists, group)
    if isinstance(limits, str):
        return None, limits
    pull, push, measures, low, high = limits
    stretch = flexible * most[group]
    task = SectionTask(
        directions=directions,
        stretch=stretch,
        loads=loads,
        group=group,
        areas=lists,
        costs=[a * one + rest for a, one in zip(slope, lists, strict=True)],
        pull=pull,
        push=push,
        measures=measures,
        least=low,
        most=high,
    )
    for share in (1.0, 0.4):
        choice = np.array([int(share * (len(one) - 1)) for one in lists])
        p = np.array([one[k] for one, k in zip(lists, choice, strict=True)])
        value, excess = function.values(p, None)
        if abs(task.used(choice) - 1 - excess.max()) > AGREES * (1 + abs(excess.max())) or abs(
            task.cost(choice) - value
        ) > AGREES * abs(value):
            return None, "its limits are not those of a truss of bars alone"
    return task, ""


def _truss(function: ModelFunction, p: NDArray[np.float64]) -> Any:
    """Directions (m, n), flexibilities l/(E A) (m,), loads (cases, n), places of the unknowns, load cases; or why not."""
    model = function.model_at(p)
    system = compile(model)
    held, x = stiff_rows(system), system.x0
    flexible = flexibility(held, x)
    if not np.isfinite(flexible).all() or not (flexible > 0).all() or (held.row_kind != 0).any():
        return "it is more than a truss of elastic bars"
    cases = list(dict.fromkeys(one.arguments.get("load_case") for one in function.asked))
    loads = []
    for case in cases:
        known = known_forces(system, held, x, loads_at(system, np.zeros(1), case, weight_word(False)).at(x[None]))
        if known.tension.any() or known.continua_force.any():
            return "it has forces without load"
        loads.append(known.load[held.free])
    G = constraint_jacobian(held, x).toarray()[:, held.free]
    return G, flexible, np.array(loads), np.asarray(held.free), cases


def _groups(function: ModelFunction, lists: Sequence[NDArray[np.float64]], flexible: NDArray[np.float64]) -> Any:
    """The variable that is the area of each bar (m,)."""
    most = np.array([one.max() for one in lists])
    group = np.full(len(flexible), -1)
    for k in range(len(lists)):
        p = most.copy()
        p[k] *= 0.5
        found = _truss(function, p)
        if isinstance(found, str):
            return None
        ratio = found[1] / flexible
        own = np.abs(ratio - 2) < AGREES
        if not (own | (np.abs(ratio - 1) < AGREES)).all() or (group[own] >= 0).any():
            return None
        group[own] = k
    return group if (group >= 0).all() else None


def _limits(
    function: ModelFunction,
    p: NDArray[np.float64],
    directions: NDArray[np.float64],
    at: NDArray[np.int64],
    cases: Sequence[Any],
    lists: Sequence[NDArray[np.float64]],
    group: NDArray[np.int64],
) -> Any:
    """Forces allowed of each bar by section, and displacements with limits; or why a limit is none of them."""
    m = len(directions)
    inf = np.inf
    pull, push = [np.full(len(lists[g]), inf) for g in group], [np.full(len(lists[g]), inf) for g in group]
    rows: dict[bytes, list[Any]] = {}
    seen: dict[str, set[Any]] = {}
    for asked, name, one in function.entries(p):
        if name == "least":
            continue
        own, case = function.task.limits[name], asked.arguments.get("load_case")
        seen.setdefault(name, set()).add(case)
        for k in range(one.values.size):
            seeds = one.seeds(k)
            if len(seeds) != 1:
                return f"the limit {name!r} is no stress, force or displacement"
            ((variable, weight),) = seeds.items()
            flat = weight.reshape(-1)
            if variable == "displacement":
                moved = np.zeros((flat.size // weight.shape[-1], 3))
                moved[:, : weight.shape[-1]] = weight
                row = moved.reshape(-1)[at]
                if row.any():
                    rows.setdefault(row.tobytes(), [row, -inf, inf])
                    kept = rows[row.tobytes()]
                    kept[1] = max(kept[1], -inf if own.at_least is None else own.at_least)
                    kept[2] = min(kept[2], inf if own.at_most is None else own.at_most)
            elif variable in ("axial_stress", "member_force") and np.count_nonzero(flat) == 1 and flat.size == m:
                bar = int(flat.argmax())
                size = lists[group[bar]] if variable == "axial_stress" else np.ones(len(lists[group[bar]]))
                if flat[bar] != 1.0 or (own.at_least or 0.0) > 0 or (own.at_most or 0.0) < 0:
                    return f"the limit {name!r} is not on the stress or force itself, above and below 0"
                pull[bar] = np.minimum(pull[bar], inf if own.at_most is None else own.at_most * size)
                push[bar] = np.minimum(push[bar], inf if own.at_least is None else -own.at_least * size)
            else:
                return f"the limit {name!r} is no stress, force or displacement"
    if any(found != set(cases) for found in seen.values()):
        return "limits hold in different load cases"
    bounded = all(np.isfinite(one).all() for one in (*pull, *push))
    if not bounded:
        return "some bars have no limit of stress or force in tension, or in compression"
    found = list(rows.values())
    measures = np.array([one[0] for one in found]) if found else np.zeros((0, directions.shape[1]))
    low, high = (np.array([one[i] for one in found]) for i in (1, 2))
    if not (np.isfinite(low).all() and np.isfinite(high).all()):
        return "displacements have a limit on one side alone"
    return pull, push, measures, low, high
