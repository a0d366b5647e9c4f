"""Quantities that a model defines: expressions of positions of nodes, directions of members, drives and their rates."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import AfterValidator, Field, WithJsonSchema, model_validator

from kinetruss.errors import Fault
from kinetruss.model.expression_kinds import Kind, in_unit
from kinetruss.model.expressions import (
    DEEPEST,
    LONGEST,
    Tree,
    forces_in,
    kind_of,
    looked_up,
    read_expression,
    walk,
)
from kinetruss.model.measured_forces import ExpressionError
from kinetruss.model.record import Of, Record
from kinetruss.model.references import LoadCaseNames

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


def _formula(text: str) -> str:
    try:
        read_expression(text)
    except ExpressionError as error:
        raise ValueError(str(error)) from None
    return text


Formula = Annotated[
    str, AfterValidator(_formula), WithJsonSchema({"type": "string", "minLength": 1, "maxLength": LONGEST}), Field(min_length=1)
]
Limit = Annotated[float, Of("measure")] | None


class Quantity(Record):
    """A quantity of the motion: an expression, which results have with its first and second rate.

    A plain text is enough: ``sweep: angle(rocker)``. A node is its place, a member the vector from its first to its second end,
    a drive its length or angle, and the name of a quantity that quantity; ``ex``, ``ey``, ``ez`` are the axes. Functions:
    ``length``, ``distance``, ``angle``, ``dot``, ``cross``, ``unit``, ``normal``, ``meet``, ``rate``, ``sqrt``, ``abs``,
    ``sin``, ``cos``, ``tan``, ``asin``, ``acos``, ``atan``, ``atan2``. Angles count on over full turns. Forces, which a motion
    alone does not have: ``force``, ``torque``, ``power``, ``reaction``, ``reaction_moment``; of a cylinder ``pressure_A``,
    ``pressure_B``, ``thrust``, ``flow_A``, ``flow_B``. Plain numbers beside lengths, angles and forces get a unit:
    ``P.y - 20*mm``. A name that is no word of Python stands in quotes: ``distance("n-1", A)``.

    value : the expression.
    words : what it is, for tables and pictures.
    limits : least and largest value allowed, a number in SI or with a unit (``80 kN``, ``200 bar``); null for none. The verdict
    of a run checks them.
    load_cases : names of the load cases and combinations in which the limits apply, as those of a deflection in combinations
    of serviceability; the name of a standard means all of its combinations. By default all. In a motion that does not depend on
    loads they always apply.

    >>> import kinetruss as kt
    >>> kt.Quantity("angle(rocker)", limits=("20 deg", None)).limits[1] is None
    True
    """

    _positional: ClassVar = ("value",)
    value: Formula
    words: str = ""
    limits: tuple[Limit, Limit] | None = None
    load_cases: Annotated[tuple[LoadCaseNames, ...], Field(min_length=1)] | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_text(cls, value: Any) -> Any:
        return {"value": value} if isinstance(value, str) else value

    @model_validator(mode="after")
    def _sound(self) -> Quantity:
        if self.limits is None:
            if self.load_cases is not None:
                raise ValueError("load_cases say where limits apply. Give limits, or leave load_cases out.")
            return self
        low, high = self.limits
        if low is None and high is None:
            raise ValueError("limits has neither a least nor a largest value. Give one of them, or leave limits out.")
        if low is not None and high is not None and not low < high:
            raise ValueError(f"limits: {low:g} is not less than {high:g}. Give the least value first.")
        return self

    @cached_property
    def tree(self) -> Tree:
        """The expression, names not looked up."""
        return read_expression(self.value)

    if TYPE_CHECKING:

        def __init__(self, value: str, *, words: str = "", limits: Any = None, load_cases: Any = None) -> None: ...


def kinds_of(model: ModelData) -> dict[str, Kind]:
    """What the quantities of a model measure."""
    return {name: kind_of(model, looked_up(model, one.tree), (name,)) for name, one in model.quantities.items()}


def quantity_faults(model: ModelData) -> Iterator[Fault]:
    """Faults of the quantities: unknown names, units that do not match, quantities that need themselves, vectors."""
    every = tuple((table, "") for table in ("nodes", "bars", "active", "beams", "drives", "quantities"))
    for name, one in model.quantities.items():
        path, about = ("quantities", name, "value"), (*(place[:1] for place in every), ("quantities", name))
        try:
            kind = kind_of(model, looked_up(model, one.tree), (name,))
        except ExpressionError as error:
            yield Fault(path, error.message, error.mend, about=about)
            continue
        if kind.vector:
            mend = "Take a component, as in (B - A).x, its length, or an angle."
            yield Fault(path, f"{one.value!r} is a vector.", mend, about=about)
            continue
        for limit in one.limits or ():
            has = getattr(limit, "quantity", None) or ""
            meant = {"length": "m", "angle": "rad"}.get(has, has)
            if meant and in_unit(meant).unit != kind.unit:
                said = f"has the unit of {_ARTICLES[has]}" if has in _ARTICLES else f"is in {meant}"
                own = f"is in {kind.unit}" if kind.unit else "has no unit"
                yield Fault(("quantities", name, "limits"), f"{said}, but {name!r} {own}.", "Mend one of them.")
                break


def needs_forces(model: ModelData, name: str) -> bool:
    """True if a quantity is not known of a motion alone."""
    return next(forces_in(model, looked_up(model, model.quantities[name].tree)), None) is not None


_ARTICLES = {"length": "a length", "angle": "an angle"}

__all__ = ["DEEPEST", "Quantity", "kinds_of", "needs_forces", "quantity_faults", "walk"]
