"""Events of a simulation: a length, a coordinate or a force that reaches a value."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ValidationInfo, WithJsonSchema, field_validator, model_validator

from kinetruss.model._record import Flag, Name, Record
from kinetruss.units import parse

__all__ = ["Event"]

_VALUE = {"anyOf": [{"type": "number"}, {"type": "string"}], "description": "m, of a force N; a number, or text with a unit"}


class Event(Record):
    """The instant at which a length (of a member, m), a coordinate (``NODE.x``, m) or a mean axial force (of a member, N)
    arrives at a value.

    length : of this member, m. coordinate : ``NODE.x``, m. force : mean axial one of this member, N. Give one of them.
    direction : from below (``rising``), from above (``falling``) or ``both``. A quantity that touches its value and turns back
        counts once; one that has this value at the start does not count. stop : end the run there; False only records the
        event.
    """

    length: Name | None = None
    coordinate: Name | None = None
    force: Name | None = None
    value: Annotated[float, WithJsonSchema(_VALUE)]
    direction: Literal["rising", "falling", "both"] = "both"
    stop: Flag = True

    @field_validator("value", mode="plain")
    @classmethod
    def _in_its_unit(cls, value: Any, info: ValidationInfo) -> float:
        return parse(value, "force" if info.data.get("force") is not None else "length")

    @model_validator(mode="after")
    def _one_quantity(self) -> Event:
        given = [name for name in ("length", "coordinate", "force") if getattr(self, name) is not None]
        if len(given) != 1:
            has = f"has {' and '.join(given)}" if given else "watches nothing"
            raise ValueError(f"{has}. Give one of length (a member), coordinate (NODE.x) or force (a member).")
        return self

    @property
    def unit(self) -> str:
        """SI unit of the quantity, and of `value`: m or N."""
        return "m" if self.force is None else "N"
