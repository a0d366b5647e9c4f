"""Base of all records, and the quantity types their fields are made of."""

from __future__ import annotations

from typing import Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, WithJsonSchema

from kinetruss.units import parse, unit_of

__all__ = [
    "Acceleration", "Angle", "AngularRate", "Area", "BackEmf", "Coordinate", "Count", "Density", "Force",
    "ForceVector", "GravityVector", "Inductance", "Inertia", "Lead", "Length", "Mass", "Name", "Number", "Point",
    "PositiveLength", "PositiveTime", "Rate", "Record", "Resistance", "SecondMoment", "Speed", "Stress", "Time",
    "Torque", "TorqueConstant", "Voltage", "Current",
]  # fmt: skip


class Record(BaseModel):
    """A frozen record that accepts its own fields only; text with units is read into SI numbers."""

    model_config = ConfigDict(frozen=True, extra="forbid", validate_default=False, ser_json_inf_nan="constants")

    def with_(self, **changes: Any) -> Self:
        """A new record with some fields changed; the result is checked like any other."""
        return type(self)(**{name: getattr(self, name) for name in type(self).model_fields} | changes)


def _positive(value: float) -> float:
    if value <= 0:
        raise ValueError(f"{value:g} must be greater than 0. Give a positive value.")
    return value


def _not_negative(value: float) -> float:
    if value < 0:
        raise ValueError(f"{value:g} must not be negative. Give 0 or a positive value.")
    return value


def _quantity(quantity: str, rule: Any = None) -> Any:
    unit = unit_of(quantity)
    schema = {
        "anyOf": [{"type": "number"}, {"type": "string"}],
        "description": f"{quantity}: a number in {unit or 'plain units'}, or text with a unit" if unit else quantity,
        "x-unit": unit,
    }
    validators = [BeforeValidator(lambda value: parse(value, quantity)), WithJsonSchema(schema)]
    if rule is not None:
        validators.append(AfterValidator(rule))
    return Annotated[float, *validators]


Name = Annotated[str, Field(min_length=1, pattern=r"^[^\s/\\]+$")]
Count = Annotated[int, Field(ge=1)]

Length = _quantity("length")
PositiveLength = _quantity("length", _positive)
Mass = _quantity("mass", _not_negative)
Time = _quantity("time")
PositiveTime = _quantity("time", _positive)
Angle = _quantity("angle")
AngularRate = _quantity("angular rate", _positive)
Area = _quantity("area", _positive)
SecondMoment = _quantity("second moment of area", _positive)
Density = _quantity("density", _not_negative)
Stress = _quantity("stress", _positive)
Force = _quantity("force")
Torque = _quantity("torque", _not_negative)
Acceleration = _quantity("acceleration")
Speed = _quantity("speed", _positive)
Inertia = _quantity("moment of inertia", _not_negative)
Resistance = _quantity("resistance", _not_negative)
Inductance = _quantity("inductance", _not_negative)
Voltage = _quantity("voltage", _positive)
Current = _quantity("current", _positive)
TorqueConstant = _quantity("torque constant", _positive)
BackEmf = _quantity("back-emf constant", _not_negative)
Lead = _quantity("lead", _positive)
Number = _quantity("number")
Coordinate = _quantity("coordinate")
Rate = _quantity("rate")

Point = Annotated[tuple[Length, ...], Field(min_length=2, max_length=3)]
ForceVector = Annotated[tuple[Force, ...], Field(min_length=2, max_length=3)]
GravityVector = Annotated[tuple[Acceleration, ...], Field(min_length=2, max_length=3)]
