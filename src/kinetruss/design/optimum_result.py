"""The result of an optimum: values, model, certificate, history, as a record, as text and as plain data."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from kinetruss.design.optimum.certificate import FIRST_ORDER, Active, Certificate
from kinetruss.design.optimum.evaluations import FEASIBLE, Evaluations, Step
from kinetruss.design.optimum.truss_sections import Proof
from kinetruss.design.sizing_result import record
from kinetruss.display import Table, number, quantity
from kinetruss.display.tables import words
from kinetruss.errors import few
from kinetruss.model import Model, OptimumTask
from kinetruss.model.optimum import unit_given
from kinetruss.model.table import read_only
from kinetruss.results import provenance

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.design.model_function import ModelFunction
    from kinetruss.design.optimum.problem import Problem
    from kinetruss.design.under_mission import Listed

SHARE = 0.01
"""Of a limit, by which it is moved in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ActiveLimit:
    """A limit or bound that is reached. name : what; limit : its value; side : ``most`` or ``least``; unit.

    price : by how much the objective falls if the limit is moved by one of its unit; 0 : it is reached but costs nothing.
    """

    name: str
    limit: float
    side: str
    unit: str
    price: float
    bound: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitUse:
    """How far a side of a limit is used, in one load case.

    name : of the limit; subject : what its worst value is of; value, before : this value at the end and at the start; limit;
    side : ``most`` or ``least``; unit. left : to the limit, as a share of it; negative if it is exceeded.
    """

    name: str
    subject: str
    value: float
    before: float
    limit: float
    side: str
    unit: str
    left: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Optimum:
    """What an optimum search found.

    model : with the values. values : of the variables, SI. objective, unit : the response that was made small. before : its
    value at the start. certificate : to first order. active : limits and bounds reached, the dearest first. limits : how far
    each is used. history : a step for each analysis. analyses : points; computed : values and gradients that were not known
    from an earlier run; seconds. state : "" done, or ``interrupted``. proof : of a choice from lists, by branch and bound;
    relaxed : the optimum without lists, from which it was chosen. listed : with parts from the catalogues of the mission, if
    there is one.
    """

    model: Model
    task: OptimumTask
    values: Mapping[str, float]
    objective: float
    unit: str
    before: float
    certificate: Certificate
    active: tuple[ActiveLimit, ...]
    limits: tuple[LimitUse, ...]
    history: tuple[Step, ...]
    analyses: int
    computed: int
    seconds: float
    state: str = ""
    proof: Proof | None = None
    relaxed: float | None = None
    listed: Listed | None = None
    notes: tuple[str, ...] = ()
    provenance: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        read_only(self)

    @property
    def certified(self) -> bool:
        """Whether it may be called an optimum: the search ended where the conditions hold, or with a choice from lists."""
        return not self.state and (self.certificate.first_order or (self.certificate.feasible and self.relaxed is not None))

    def variable_unit(self, name: str) -> str:
        """The SI unit in which a variable was given."""
        return _unit(self.task, name)

    @property
    def sentence(self) -> str:
        """What is proven, in one sentence."""
        if self.state:
            return f"Interrupted: the best design so far that keeps all limits. {self._gap}"
        if not self.certificate.feasible:
            return f"No optimum: a limit is exceeded by {100 * self.certificate.excess:.3g} % of it."
        if self.proof is not None or self.relaxed is not None:
            return self._gap
        if self.certificate.first_order:
            priced = sum(one.price > 0 for one in self.active)
            local = "A local optimum: " if priced >= len(self.values) else "A local optimum to first order: "
            return (
                f"{local}no small change within the limits lowers {self.task.least} (residual "
                f"{self.certificate.residual:.1e}). A better one elsewhere is not excluded."
            )
        return (
            f"No optimum is certified: the residual is {self.certificate.residual:.2g}, "
            f"more than {FIRST_ORDER:g}. Allow more iterations, a smaller tolerance, or another method."
        )

    @property
    def _gap(self) -> str:
        if self.proof is None:
            return "" if self.relaxed is None else self._unproven
        if self.proof.closed:
            return (
                f"The best of all choices from the lists, proven by branch and bound ({self.proof.boxes} boxes, "
                f"{self.proof.programs} programs in whole numbers, {self.proof.seconds:.1f} s)."
            )
        return (
            f"The best choice found; branch and bound {self.proof.stopped}: none is below "
            f"{quantity(self.proof.bound, self.unit)}, a gap of {100 * self.proof.gap:.2g} %."
        )

    @property
    def _unproven(self) -> str:
        assert self.relaxed is not None  # noqa: S101 - asked only then
        gap = (self.objective - self.relaxed) / self.objective
        return (
            "A choice from the lists that no single step improves; it is not proven. The optimum without lists, a local one, "
            f"is {100 * gap:.2g} % lower."
        )

    @cached_property
    def record(self) -> dict[str, Any]:
        """All values as plain data, without the model."""
        proof = None if self.proof is None else {
            "cost": self.proof.cost, "bound": self.proof.bound, "gap": self.proof.gap, "closed": self.proof.closed,
            "boxes": self.proof.boxes, "programs": self.proof.programs, "seconds": self.proof.seconds,
        }  # fmt: skip
        own = ("objective", "unit", "before", "analyses", "computed", "seconds", "state", "certified", "relaxed")
        return {
            "title": self.task.title, "least": self.task.least, **{name: getattr(self, name) for name in own},
            "values": dict(self.values), "sentence": self.sentence, "notes": list(self.notes), "proof": proof,
            "certificate": {
                "first_order": self.certificate.first_order, "feasible": self.certificate.feasible,
                "residual": self.certificate.residual, "complementarity": self.certificate.complementarity,
                "excess": self.certificate.excess if math.isfinite(self.certificate.excess) else None,
            },
            "active": [{name: getattr(one, name) for name in ActiveLimit.__slots__} for one in self.active],
            "listed": None if self.listed is None else _listed_record(self.listed),
            "limits": [{name: _finite(getattr(one, name)) for name in LimitUse.__slots__} for one in self.limits],
            "history": [[one.analyses, one.objective, one.worst if math.isfinite(one.worst) else None] for one in self.history],
            "provenance": dict(self.provenance),
        }  # fmt: skip

    @property
    def text(self) -> str:
        """Variables, what is active and what it costs, the certificate."""
        return "\n".join(str(one) for one in _lines(self))

    def __str__(self) -> str:
        return self.text


def made(
    function: ModelFunction, asked: Evaluations, p: NDArray[Any], proven: Certificate, *, state: str,
    notes: Sequence[str], proof: Proof | None, relaxed: float | None, seconds: float,
) -> Optimum:  # fmt: skip
    """The result at a point p (n,)."""
    problem, model = replace(function.problem, limits=function.limits_at(p)), function.model_at(p)
    return Optimum(
        model=model,
        task=function.task,
        values={one.name: float(value) for one, value in zip(problem.variables, p, strict=True)},
        objective=asked.values(p)[0],
        unit=problem.unit,
        before=asked.values(problem.start)[0],
        certificate=proven,
        active=_active(problem, proven),
        limits=tuple(_uses(function, p)),
        history=tuple(asked.history),
        analyses=asked.analyses,
        computed=asked.computed,
        seconds=seconds,
        state=state,
        proof=proof,
        relaxed=relaxed,
        notes=tuple(notes),
        provenance=provenance(model, before=provenance(function.model)["model"]),
    )


def question(function: ModelFunction) -> dict[str, Any]:
    """What a task asks, as plain data in SI units."""
    task = function.task
    own = ("title", "least", "analysis", "method", "starts")
    return {
        **{name: getattr(task, name) for name in own}, "unit": function.unit,
        "model": function.model.title,
        "variables": [
            {"name": one.name, "of": list(task.variables[one.name].of),
             "paths": sum(len(paths) for of, _, paths in function.parts if of == k), "lower": one.lower, "upper": one.upper,
             "start": one.start, "unit": one.unit, "scale": one.scale,
             "choose": list(map(float, task.variables[one.name].choose or ()))}
            for k, one in enumerate(function.problem.variables)
        ],
        "limits": [
            {"name": name, "of": one.of, "analysis": one.analysis or task.analysis, "arguments": dict(one.arguments),
             "load_cases": list(one.load_cases or task.load_cases or ()), "unit": unit,
             "at_least": None if one.at_least is None else float(one.at_least),
             "at_most": None if one.at_most is None else float(one.at_most)}
            for name, one in task.limits.items()
            for unit in [next((block.unit for block in function.limits.blocks if block.name == name), "")]
        ],
    }  # fmt: skip


def _uses(function: ModelFunction, p: NDArray[Any]) -> Iterator[LimitUse]:
    for one, subject, value, before in function.worst(p):
        left = -one.sign * (value - one.limit) / one.size
        side = "most" if one.sign > 0 else "least"
        yield LimitUse(
            name=one.name, subject=subject, value=value, before=before, limit=one.limit, side=side, unit=one.unit, left=left
        )


def _finite(value: Any) -> Any:
    """Plain data: JSON has no infinity."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _active(problem: Problem, proven: Certificate) -> tuple[ActiveLimit, ...]:
    """What is reached; of neighbouring instants of one value the dearest, with the price of all."""
    found: dict[Any, tuple[Active, float]] = {}
    for one in proven.active:
        key = (one.variable, one.side) if one.row < 0 else int(problem.family[one.row])
        first, price = found.get(key, (one, 0.0))
        found[key] = first, price + one.multiplier
    return tuple(_named(problem, replace(one, multiplier=price)) for one, price in found.values())


def _named(problem: Problem, one: Active) -> ActiveLimit:
    if one.row >= 0:
        limit = problem.limits[one.row]
        side = "most" if limit.sign > 0 else "least"
        return ActiveLimit(
            name=limit.subject, limit=limit.limit, side=side, unit=limit.unit, price=float(one.multiplier), bound=False
        )
    variable = problem.variables[one.variable]
    bound = variable.upper if one.side > 0 else variable.lower
    side = "most" if one.side > 0 else "least"
    return ActiveLimit(name=variable.name, limit=bound, side=side, unit=variable.unit, price=float(one.multiplier), bound=True)


def active_words(one: ActiveLimit, unit: str) -> str:
    """What a limit costs: ``stress of M7 reaches 25 MPa; 1 % more would save 0.4 kg``."""
    at = quantity(one.limit, one.unit)
    reached = f"{one.name} is at its {one.side}, {at}" if one.bound else f"{one.name} reaches {at}"
    saved = one.price * SHARE * abs(one.limit)
    if not saved > 0:
        return f"{reached}; that costs nothing"
    return f"{reached}; 1 % {wider(one)} would save {quantity(saved, unit)}"


def wider(one: ActiveLimit) -> str:
    """Whether a limit gives way if its size is ``more`` or ``less``."""
    return "more" if (one.side == "most") == (one.limit > 0) else "less"


def _lines(found: Optimum) -> list[str]:
    unit, task = found.unit, found.task
    rows = [{"name": name, "value": quantity(value, _unit(task, name))} for name, value in found.values.items()]
    lines = [Table([words("variable", "name"), words("value", lambda row: str(row["value"]))], rows, "Variables").text, ""]
    lines.append(f"{task.least}: {quantity(found.before, unit)} at the start, {quantity(found.objective, unit)} now, after "
                 f"{found.analyses} analyses ({found.seconds:.1f} s).")  # fmt: skip
    lines.append(found.sentence)
    if found.relaxed is None:
        lines += [f"  {active_words(one, unit)}." for one in found.active]
    if found.listed is not None:
        lines += ["", *_listed_words(found, found.listed)]
    return [*lines, *found.notes]


def _listed_words(found: Optimum, listed: Listed) -> list[str]:
    """The parts, what they cost over the optimum, and whether they keep the limits."""
    sizing = listed.sizing
    parts = [f"{one.name} {one.tube}" for one in sizing.groups]
    parts += [f"{one.name} {', '.join(filter(None, (one.motor, one.screw, one.gear)))}" for one in sizing.drives]
    cost = "" if math.isnan(listed.objective) else _cost(found, listed.objective)
    kept = (
        "All limits of the task are kept"
        if listed.excess <= FEASIBLE
        else f"But {listed.limit} exceeds its limit by {100 * listed.excess:.3g} % of it"
    )
    return [f"With parts of the catalogues ({'; '.join(parts)}){cost}. {kept}. {sizing.finding.sentence}"]


def _cost(found: Optimum, objective: float) -> str:
    more = (objective - found.objective) / abs(found.objective) if found.objective else math.nan
    than = f", {quantity(abs(more), '%')} {'more' if more > 0 else 'less'} than without lists" if abs(more) > FEASIBLE else ""
    return f": {found.task.least} {quantity(objective, found.unit)}{than}"


def _listed_record(listed: Listed) -> dict[str, Any]:
    own = {"objective": listed.objective, "excess": listed.excess}
    plain = {name: one if math.isfinite(one) else None for name, one in own.items()}
    return {**plain, "limit": listed.limit, "sizing": record(listed.sizing)}


def _unit(task: OptimumTask, name: str) -> str:
    one = task.variables[name]
    return unit_given((one.between or one.choose or (0.0,))[0]) or ""


def contradiction_words(function: ModelFunction, kept: Sequence[int], nearest: Any, worst: float) -> str:
    """Which limits exclude each other, and how to mend it."""
    problem = replace(function.problem, limits=function.limits_at(nearest))
    names = [f"{one.subject} at {'most' if one.sign > 0 else 'least'} {quantity(one.limit, one.unit)}" for one in
             (problem.limits[row] for row in kept)]  # fmt: skip
    at = few([f"{one.name} {number(float(value))}" for one, value in zip(problem.variables, nearest, strict=True)], 6)
    which = (
        f"{names[0]} cannot be kept" if len(names) == 1 else f"These {len(names)} limits exclude each other: {'; '.join(names)}"
    )
    return (
        f"No design within the bounds keeps all limits, as far as a search shows. {which}. The nearest design, {at}, exceeds "
        f"by {100 * worst:.3g} %. Widen the bounds of the variables, or the limits."
    )
