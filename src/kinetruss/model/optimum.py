"""The task of an optimum: what is made small, what may change, and which limits hold."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, ValidationError, WithJsonSchema, model_validator

from kinetruss.errors import Fault
from kinetruss.model.record import Name, Number, Of, Record, Whole, one_format
from kinetruss.model.table import Filled
from kinetruss.model.words import faults_of
from kinetruss.units import NUMBER

FORMAT = 1

Measure = Annotated[float, Of("measure")]
"""A number in SI, or text with the unit of what is measured."""
Paths = Annotated[tuple[str, ...], Field(min_length=1), BeforeValidator(lambda one: (one,) if isinstance(one, str) else one)]
Names = Annotated[tuple[str, ...], Field(min_length=1), BeforeValidator(lambda one: (one,) if isinstance(one, str) else one)]
Text = Annotated[str, Field(min_length=1, max_length=1000)]


def _plain(value: Any) -> Any:
    """A value as a file has it, as text: true and false, whole numbers, numbers."""
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    if value in ("true", "false"):
        return value == "true"
    if not isinstance(value, str) or not NUMBER.fullmatch(value):
        return value
    return int(value) if value.lstrip("+-").isdecimal() else float(value)


def unit_given(value: float) -> str | None:
    """SI unit of the text that a measure was given as; None of a bare number."""
    quantity = getattr(value, "quantity", None)
    return {"length": "m", "angle": "rad"}.get(quantity, quantity) if isinstance(quantity, str) else None


Settings = dict[str, Any]
Arguments = Annotated[dict[str, Any], BeforeValidator(_plain)]
"""Arguments of an analysis by name."""


class OptimumVariable(Record):
    """A number of the model that may change, or several that change together.

    of : its dotted path, as for ``--set`` (``bars.M7.section.area``, ``nodes.C.at.0``), or several paths, which have one value;
        a star stands for all that fit.
    multiples : further paths, each with the factor by which it follows: the bore of a tube, ``{sections.rim.inner: 0.84}``; the
        other side of what is symmetric, ``{nodes.L.at.0: -1}``.
    between : least and largest value. start : where the search begins; by default the value of the model.
    scale : in which the solver sees it: ``range`` linear; ``log``; ``inverse``, its reciprocal (both above 0).
    choose : the values to choose from, e.g. the areas of a catalogue; ``between`` is then not needed.

    >>> import kinetruss as kt
    >>> kt.OptimumVariable(of="bars.M7.section.area", between=("1 cm^2", "20 cm^2")).between[1]
    0.002
    """

    of: Paths
    multiples: dict[str, Number] = Field(default_factory=dict)
    between: tuple[Measure, Measure] | None = None
    start: Measure | None = None
    scale: Literal["range", "log", "inverse"] = "range"
    choose: Annotated[tuple[Measure, ...], Field(min_length=1)] | None = None

    @model_validator(mode="after")
    def _sound(self) -> OptimumVariable:
        if (self.between is None) == (self.choose is None):
            raise ValueError("needs bounds or a list, one of them. Give between: [least, largest], or choose: [...].")
        low, high = self.between if self.between is not None else (min(self.choose or ()), max(self.choose or ()))
        if self.between is not None and not low < high:
            raise ValueError(f"between: {low:g} is not less than {high:g}. Give the least value first.")
        if self.scale != "range" and low <= 0:
            raise ValueError(f"a {self.scale} scale needs values above 0, not {low:g}. Raise the least value, or take range.")
        return self


class OptimumLimit(Record):
    """A limit on a response: on every value of it (each member, node, axis, instant), in every load case.

    of : the response, as of `kt.Response`: ``axial_stress``, ``displacement[C, y]``, ``max(abs(member_force))``.
    at_most, at_least : SI or with a unit; one of them or both. load_cases : names; by default those of the task.
    analysis : by default that of the task. arguments : of the analysis, beside the load case.

    >>> import kinetruss as kt
    >>> kt.OptimumLimit(of="axial_stress", at_most="25 MPa").at_most
    25000000.0
    """

    of: Text
    at_most: Measure | None = None
    at_least: Measure | None = None
    load_cases: Names | None = None
    analysis: str | None = None
    arguments: Arguments = Field(default_factory=dict)

    @model_validator(mode="after")
    def _sound(self) -> OptimumLimit:
        low, high = self.at_least, self.at_most
        if low is None and high is None:
            raise ValueError("has no limit. Give at_most, at_least, or both.")
        if low is not None and high is not None and not low < high:
            raise ValueError(f"at_least {low:g} is not less than at_most {high:g}: no value keeps both. Change one of them.")
        return self


class OptimumTask(Record):
    """An optimum that is asked for: the least of a response, by variables, within limits.

    least : the response that is made small, as ``mass`` or ``max(abs(drive_force))``, or a variable, by its name;
        after a minus it is made large.
    variables, limits : by name.
    model : the model file, beside this one; from Python a model is given.
    set : values of the model that are changed before, by path, as by ``--set``, also ``library.NAME``.
    mission : the mission file, beside this one. Limits that name no analysis then hold in all its runs and load cases, with its
        safety factors; `least` is of its first run. From what is found, `design.size` chooses parts of its catalogues.
    analysis : ``statics.linear``, ...; arguments : of it; load_cases : for all limits that name none; by default the loads of
        the model as they are.
    method : slsqp, trust-constr, mma (needs NLopt), highs (for what is linear). iterations : at most, of one search.
    tolerance : relative, of the objective, at which a search ends.
    starts : searches from so many places; the first from the start, the others at random (`seed`); the best is kept.
    seconds : for a choice from lists, proven by branch and bound; then it stops with the gap that is left.
    """

    kinetruss_optimum: Annotated[
        int, one_format(FORMAT, "kinetruss_optimum", "format {} of an optimum"), WithJsonSchema({"const": FORMAT})
    ] = FORMAT
    title: str = ""
    model: str | None = None
    set: Settings = Field(default_factory=dict)
    mission: str | None = None
    least: Text = "mass"
    variables: Filled[Name, OptimumVariable]
    limits: dict[Name, OptimumLimit] = Field(default_factory=dict)
    analysis: str = "statics.linear"
    arguments: Arguments = Field(default_factory=dict)
    load_cases: Names | None = None
    method: Literal["slsqp", "trust-constr", "mma", "highs"] = "slsqp"
    iterations: Annotated[Whole, Field(ge=1, le=100_000)] = 500
    tolerance: Annotated[Number, Field(gt=0, le=0.01)] = 1e-9
    starts: Annotated[Whole, Field(ge=1, le=10_000)] = 1
    seed: Whole = 0
    seconds: Annotated[Number, Field(gt=0)] = 600.0

    @classmethod
    def _faults(cls, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
        return faults_of(error, data, cls)
