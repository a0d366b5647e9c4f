"""Values that are constant, or tables in time."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import model_validator
from pydantic_core import core_schema

from kinetruss.errors import Fault
from kinetruss.model.common_faults import components
from kinetruss.model.record import Record, Series, Time
from kinetruss.units import parse, unit_of

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData

Times = Annotated[tuple[Time, ...], Series] | None
"""Times of a table, s."""

Shape = Literal["spline", "monotone"]
"""The interpolation of a table."""


def check_times(times: tuple[float, ...]) -> None:
    """Times must increase; the message names the first that does not."""
    for index, (before, after) in enumerate(pairwise(times), start=1):
        if after <= before:
            raise ValueError(
                f"time goes back or stands still: entry {index + 1} is {after:g} s after {before:g} s. Sort the table by time."
            )


def check_table(times: tuple[float, ...], values: tuple[object, ...], what: str) -> None:
    """A table has one value for each time, and its times increase."""
    if len(times) != len(values):
        raise ValueError(f"{len(times)} times but {len(values)} {what}. Give one of each.")
    check_times(times)


class InTime(Record):
    """A value, or a table of values in time."""

    amount: ClassVar[str] = "force"
    amounts: ClassVar[str] = "forces"
    """Fields of the value, and of the table."""

    @model_validator(mode="after")
    def _one_form(self) -> Self:
        one, many = self.amount, self.amounts
        value, table, times = (getattr(self, name, None) for name in (one, many, "times"))
        if (value is None) == (table is None):
            has = f"neither a {one} nor a table of {many}" if value is None else f"both a {one} and a table of {many}"
            raise ValueError(f"has {has}. Give one: {one}, or times and {many}.")
        if table is not None:
            if times is None or len(times) != len(table):
                raise ValueError(f"has {len(times or ())} times and {len(table)} {many}. Give one of {many} for each time.")
            if len(times) < 2:
                raise ValueError(f"has a table of {len(times)} times. Give at least two, or one constant {one}.")
            check_times(times)
        return self


def vector_faults(load: InTime, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: ARG001
    """Vectors that have not `dim` components."""
    for place, vector in amounts_of(load, path):
        yield from components(vector, dim, place)


def moment_faults(load: InTime, dim: int, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    """A moment that is no number in the plane, or not three numbers in space; the first one."""
    for place, value in amounts_of(load, path):
        if isinstance(value, tuple) != (dim == 3):
            message = f"is {'one number' if dim == 3 else 'three numbers'} in a model of dimension {dim}."
            yield Fault((*path, place[len(path)]), message, f"Give {'three' if dim == 3 else 'one'}.", about=about)
            return


def amounts_of(load: InTime, path: tuple[Any, ...]) -> list[tuple[tuple[Any, ...], Any]]:
    """The value of a load, or those of its table, with their places."""
    value, table = getattr(load, load.amount), getattr(load, load.amounts)
    given = [((*path, load.amount), value)] if value is not None else []
    return given + [((*path, load.amounts, index), one) for index, one in enumerate(table or ())]


class MomentOf:
    """Annotation of a moment of this quantity: a number in the plane, three in space."""

    def __init__(self, quantity: str) -> None:
        self.quantity = quantity

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(partial(_moment, self.quantity))

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        number, unit = [{"type": "number"}, {"type": "string"}], unit_of(self.quantity)
        return {
            "anyOf": [*number, {"type": "array", "items": {"anyOf": number}, "minItems": 3, "maxItems": 3}],
            "description": f"{self.quantity}: a number in {unit} or text with a unit; in space three",
            "x-unit": unit,
        }


def _moment(quantity: str, value: Any) -> Any:
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, (list, tuple)):
        return parse(value, quantity)
    if len(value) != 3:
        raise ValueError(f"has {len(value)} components. Give one number in a planar model, three in space.")
    return tuple(parse(entry, quantity) for entry in value)
