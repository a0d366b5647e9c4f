"""Optimal design: the least mass, energy, force ... of a model within limits, with a certificate."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.design.model_function import ModelFunction
from kinetruss.design.optimum.certificate import certificate
from kinetruss.design.optimum.contradictions import contradiction
from kinetruss.design.optimum.evaluations import FEASIBLE, BeyondError, Evaluations
from kinetruss.design.optimum.working_limits import ALL, NEAR, Found, optimum
from kinetruss.design.optimum_folder import opened
from kinetruss.design.optimum_result import Optimum, contradiction_words, made, question
from kinetruss.design.section_choice import chosen
from kinetruss.design.under_mission import listed, under
from kinetruss.errors import AnalysisError, Fault, InfeasibleError, InputError, ModelError
from kinetruss.io import read, read_optimum, set_values
from kinetruss.io.values import fitting
from kinetruss.io.yaml_text import MAX_SIZE
from kinetruss.model import Mission, Model, OptimumLimit, OptimumTask, OptimumVariable

if TYPE_CHECKING:
    from numpy.typing import NDArray

Progress = Callable[[int, float, float], None]


def optimise(
    model: Model | str | Path | None = None,
    variables: Mapping[str, OptimumVariable | Mapping[str, Any]] | OptimumTask | str | Path | None = None,
    objective: str = "mass",
    constraints: Mapping[str, OptimumLimit | Mapping[str, Any]] | None = None,
    *,
    mission: Mission | str | Path | None = None,
    out: str | Path | None = None,
    overwrite: bool = False,
    progress: Progress | None = None,
    **options: Any,
) -> Optimum:
    """The least of a response of a model, by some of its numbers, within limits; with a certificate of first order.

    Parameters
    ----------
    model : a model or its file. variables : by name, each an `OptimumVariable` or its fields; or a whole `OptimumTask`, or the
        file of one, which then has objective and constraints.
    objective : the response that is made small, as of `kt.Response`. constraints : by name, each an `OptimumLimit`.
    mission : a mission or its file; by default that of the task. Limits that name no analysis hold in all its runs and load
        cases, with its safety factors; from what is found, `size` chooses parts of its catalogues (`Optimum.listed`).
    out : folder that keeps every analysis: the same task goes on there after a kill or Ctrl-C. overwrite : replace another one.
    progress : called with analyses, objective and the largest excess of a limit, of its size.
    options : the other fields of `OptimumTask`: analysis, arguments, load_cases, method, iterations, tolerance, starts, seed.

    Returns
    -------
    Optimum: the values, the model with them, the certificate, the history. After Ctrl-C the best that keeps all limits so far,
    with ``state`` "interrupted".

    Raises
    ------
    ModelError : faults of the task: unknown paths, bounds that the model refuses, units, variables that do nothing.
    InfeasibleError : nothing within the bounds keeps all limits; the smallest set of those that exclude each other is named.
    AnalysisError : an analysis failed, or the search lost its way.
    KeyboardInterrupt : before anything was found that keeps all limits.

    Notes
    -----
    SLSQP (Kraft 1988) with exact gradients, on a working set of the limits. The certificate is found apart from it: multipliers
    by non-negative least squares (see `design.optimum.certificate`). It is of a local optimum; only a choice from lists for a
    truss under small displacements is proven to be the best of all.

    Examples
    --------
    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.General(area=1e-3, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> found = kt.design.optimise(rod, {"area": {"of": "section.area", "between": ("10 mm^2", "10 cm^2")}}, "mass",
    ...                            {"stress": {"of": "axial_stress", "at_most": "100 MPa"}}, arguments={"weight": False})
    >>> round(found.values["area"] * 1e6, 6), found.certificate.first_order  # A = F/sigma
    (70.0, True)
    """
    task = _task(variables, objective, constraints, options)
    if model is None:
        if task.model is None:
            raise InputError("No model is given. Give one, or model: FILE in the task.")
        model = task.model
    given = model_for(task, model)
    mission = task.mission if mission is None else mission
    if mission is not None:
        given, task, mission = under(given, task, mission)
    began = time.monotonic()
    function = ModelFunction(given, task)
    if idle := function.idle(function.problem.start):
        raise ModelError([
            Fault(("variables", name), "changes neither the objective nor any limit.", "Leave it out, or name another path.")
            for name in idle
        ])  # fmt: skip
    with nullcontext() if out is None else opened(Path(out), given, task, question(function), overwrite=overwrite) as folder:
        asked = Evaluations(function.problem, None if folder is None else folder.evaluations, progress)
        result = _searched(function, asked, progress, began)
        if mission is not None and result.certificate.feasible and not result.state:
            result = _of_catalogues(function, result, mission)
        if folder is not None:
            folder.finish(result)
    return result


def model_for(task: OptimumTask, model: Model | str | Path, max_size: int = MAX_SIZE) -> Model:
    """The model of a task, or its file, with the values that the task sets."""
    found = model if isinstance(model, Model) else read(model, max_size=max_size)
    for first in (True, False):  # on parameters depends which parts there are
        patterns = {one: value for one, value in task.set.items() if one.startswith(("library.", "parameters.")) is first}
        if own := {path: value for pattern, value in patterns.items() for path in fitting(found, pattern)}:
            found = set_values(found, own)
    return found


def _task(variables: Any, objective: str, constraints: Any, options: Mapping[str, Any]) -> OptimumTask:
    if isinstance(variables, str | Path):
        variables = read_optimum(variables)
    if isinstance(variables, OptimumTask):
        changes = {**options, **({} if constraints is None else {"limits": dict(constraints)})}
        return variables.with_(**changes) if changes else variables
    if not variables:
        raise InputError(
            "No variables are given. Give for example {'area': {'of': 'bars.*.section.area', 'between': (1e-5, 1e-3)}}."
        )
    return OptimumTask(variables=dict(variables), least=objective, limits=dict(constraints or {}), **options)


def _searched(function: ModelFunction, asked: Evaluations, progress: Any, began: float) -> Optimum:
    """The best of all searches, then the choice from lists."""
    task, problem = function.task, function.problem
    listed = any(one.choose is not None for one in task.variables.values())
    best: Found | None = None
    lost: BeyondError | None = None
    state, notes, arrived = "", [], 0
    excess = asked.values(problem.start)[1]
    if (worst := float(excess.max(initial=0.0))) > FEASIBLE:
        k = int(excess.argmax())
        notes.append(f"The start exceeds {problem.limits[k].subject} by {100 * worst:.3g} % of it, and more perhaps.")
    try:
        for start in _starts(problem, task.starts, task.seed):
            try:
                found = optimum(asked, start, task.method, task.iterations, task.tolerance)
            except BeyondError as error:
                lost = error
                continue
            if found.certificate.feasible and (best is None or _value(asked, found) < _value(asked, best)):
                best = found
            arrived += found.certificate.first_order
        if best is None and lost is None:
            _refuse(function, asked)
    except KeyboardInterrupt:
        if asked.best is None:
            raise
        state = "interrupted"
    if best is not None and (state == "" or asked.best is None):
        p = best.p
    elif asked.best is not None:
        p = asked.best[0]
        if lost is not None:
            notes.append(str(lost))
    else:
        assert lost is not None  # noqa: S101 - an interrupted search without anything has ended above
        raise lost
    if task.starts > 1:
        notes.append(f"{arrived} of {task.starts} searches ended where the conditions of first order hold.")
    relaxed = asked.values(p)[0]
    proof = None
    if listed and not state:
        p, proof, told = chosen(function, asked, p, progress)
        notes += told
        state = "interrupted" if proof is not None and proof.stopped == "interrupted" else state
    return made(function, asked, p, certificate(asked, p), state=state, notes=notes, proof=proof,
                relaxed=relaxed if listed else None, seconds=time.monotonic() - began)  # fmt: skip


def _of_catalogues(function: ModelFunction, found: Optimum, mission: Mission) -> Optimum:
    """With parts of the catalogues of a mission, or the reason why they do not serve."""
    try:
        return replace(found, listed=listed(function, found.model, mission))
    except AnalysisError as error:
        return replace(found, notes=(*found.notes, f"The catalogues of the mission have no parts for it: {error}"))


def _value(asked: Evaluations, found: Found | None) -> float:
    return np.inf if found is None else asked.values(found.p)[0]


def _starts(problem: Any, count: int, seed: int) -> Sequence[NDArray[np.float64]]:
    """The given start, then random ones, uniform in the scaled variables."""
    rng = np.random.default_rng(seed)
    return [problem.start, *(problem.real(rng.uniform(size=len(problem))) for _ in range(count - 1))]


def _refuse(function: ModelFunction, asked: Evaluations) -> None:
    """Say which limits exclude each other, or that the search did not find its way."""
    problem = function.problem
    start = asked.nearest[0] if asked.nearest is not None else problem.start
    excess = asked.values(start)[1]
    rows = np.arange(len(excess)) if len(excess) <= ALL else np.flatnonzero(excess > -NEAR)
    kept, nearest, worst = contradiction(asked, start, rows)
    if not kept:
        found = optimum(asked, nearest, "slsqp", function.task.iterations, function.task.tolerance)
        if found.certificate.feasible:
            values = zip(function.problem.variables, nearest, strict=True)
            at = ", ".join(f"{one.name}: {value:.4g}" for one, value in values)
            raise AnalysisError(f"The search lost its way, but limits can be kept. Start it nearer, for example at {at}.")
        raise AnalysisError("The search did not end at a point that keeps all limits. Give other starts, or wider bounds.")
    raise InfeasibleError(contradiction_words(function, kept, nearest, worst))
