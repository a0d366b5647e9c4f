"""The record of a hub."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, PlainValidator, WithJsonSchema, model_validator

from kinetruss.model._record import Flag, Name, PositiveLength, Record, Series
from kinetruss.model._table import ReadOnly, Table
from kinetruss.model.parts.sections import MaterialOrName, SectionOrName
from kinetruss.units import parse, shown

__all__ = ["Hub"]


def _offset(value: Any) -> Any:
    """A distance along the member, or the components of a vector."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, (list, tuple)):
        if len(value) not in (2, 3):
            raise ValueError(f"has {len(value)} components. Give a distance along the member, or a vector from the node.")
        vector = tuple(parse(entry, "length") for entry in value)
        if not any(vector):
            raise ValueError("is a vector of length 0. Leave the member out: it then ends at the node itself.")
        return vector
    if (distance := parse(value, "length")) <= 0:
        raise ValueError(f"{shown(value)} must be greater than 0. Leave the member out: it then ends at the node itself.")
    return distance


_NUMBER: dict[str, Any] = {"anyOf": [{"type": "number"}, {"type": "string"}]}
_SCHEMA = {
    "anyOf": [*_NUMBER["anyOf"], {"type": "array", "items": _NUMBER, "minItems": 2, "maxItems": 3}],
    "description": "length: a number in m or text with a unit, towards the member's other end; or a vector from the node",
    "x-unit": "m",
}
Offset = Annotated[Any, PlainValidator(_offset), WithJsonSchema(_SCHEMA)]
"""m: a distance from the node towards the member's other end, or a vector from the node in the start configuration."""


def _axis(value: Any) -> Any:
    """A direction in space: x, y, z, or three numbers."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, str) and value in ("x", "y", "z"):
        return tuple(float(value == one) for one in "xyz")
    numbers = tuple(parse(entry, "number") for entry in value) if isinstance(value, (list, tuple)) else ()
    if len(numbers) != 3 or not any(numbers):
        raise ValueError(f"{shown(value)} is no axis in space. Give x, y, z or three numbers, not all 0.")
    return numbers


_AXIS_SCHEMA = {
    "anyOf": [{"enum": ["x", "y", "z"]}, {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}],
    "description": "axis in the start configuration: x, y, z or three numbers",
}
HingeAxis = Annotated[Any, PlainValidator(_axis), WithJsonSchema(_AXIS_SCHEMA)]
"""A direction in space, in the start configuration."""


class Hub(Record):
    """A node of finite size: a rigid hub with an arm to the joint of each member (plane: pin; space: ball joint or hinge).

    In `Model.hubs` by the name of its node, which is the centre. Arms are rigid bars ``NODE.MEMBER`` to nodes of the same name,
    where the members end. A member becomes shorter by its arms; its `length`, `natural_length` and `limits` are those between
    its joints.

    reach : length of the arms of all members at the node that are neither in `arms` nor in `clamped`, m.
    arms : by member, the length of its arm towards its other end, m, or the vector of its joint from the node, m, in the
        start configuration. A member that no field names ends at the centre.
    hinges : by member with an arm, in space, the axis of its joint in the start configuration, ``x``, ``y``, ``z`` or three
        numbers: the member turns about it only, relative to the hub. Without it the joint is a ball.
    clamped : rigid members that are fixed to the hub, without a joint; the hub turns with them, and they bend.
    section, material : of the arms; by default those of the model, as for any bar.
    turns : the hub of a fixed node turns about it. Otherwise it is bolted to the ground, and its arms do not move.

    >>> import kinetruss as kt
    >>> ideal = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (0.5, 0.5)}, fixed=["A", "B"],
    ...                  bars={"a": ("A", "C"), "b": ("B", "C")})
    >>> real = ideal.with_(hubs={"A": kt.Hub(reach=0.05), "B": kt.Hub(reach="50 mm")})
    >>> real.bars["a"].ends, [round(c, 6) for c in real.nodes["A.a"].at]
    (('A.a', 'C'), [0.035355, 0.035355])
    """

    reach: PositiveLength | None = None
    arms: Table[Name, Offset] = ReadOnly()
    hinges: Table[Name, HingeAxis] = ReadOnly()
    clamped: Annotated[tuple[Name, ...], Field(), Series] = ()
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    turns: Flag = False

    @model_validator(mode="after")
    def _apart(self) -> Hub:
        if both := [name for name in self.clamped if name in self.arms]:
            raise ValueError(f"{shown(both[0])} is clamped and has an arm. Keep one of the two.")
        if both := [name for name in self.clamped if name in self.hinges]:
            raise ValueError(f"{shown(both[0])} is clamped and has a hinge. Keep one of the two.")
        if self.reach is None and not self.arms and not self.clamped:
            raise ValueError("has no arms. Give reach (all members), arms: {MEMBER: 50 mm}, or clamped: [MEMBER].")
        return self
