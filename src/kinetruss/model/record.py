"""Base of all records, and the quantity types their fields are made of."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from inspect import Parameter, Signature, get_annotations
from numbers import Integral
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, NoReturn, Self, cast

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    GetCoreSchemaHandler,
    ValidationError,
    WithJsonSchema,
)
from pydantic_core import core_schema

from kinetruss.errors import ArgumentError, Fault, FrozenError, ModelError, shown
from kinetruss.limits import MOST_COUNT, MOST_WHOLE, SMALLEST
from kinetruss.model.table import brief
from kinetruss.model.words import faults_of, in_python
from kinetruss.units import EITHER, NUMBER, parse, unit_of

if TYPE_CHECKING:
    from pydantic._internal._model_construction import ModelMetaclass
else:
    ModelMetaclass = type(BaseModel)  # pydantic does not export it


class _Raising(ModelMetaclass):
    """Makes records that are built in Python raise `ModelError`; nested records are checked without it."""

    _positional: tuple[str, ...]

    def __call__(self, /, *args: Any, **data: Any) -> Any:
        if len(args) > len(self._positional):
            raise ArgumentError(f"{self.__name__} takes its fields by name: {self.__name__}({self._first_fields()}).")
        if twice := [name for name in self._positional[: len(args)] if name in data]:
            raise ArgumentError(f"{self.__name__}: {twice[0]!r} is given twice. Give it once.")
        data |= dict(zip(self._positional, args, strict=False))
        try:
            return super().__call__(**data)
        except ValidationError as error:
            raise ModelError(_told(self._faults(error, data))) from None
        except ModelError as error:
            raise ModelError(_told(error.faults), error.source) from None

    def _first_fields(self) -> str:
        """How to write the record: up to three of its fields, those that it needs first."""
        fields = {
            name: one for name, one in cast("type[Record]", self).model_fields.items() if name not in ("kind", "kinetruss")
        }
        names = sorted(fields, key=lambda name: not fields[name].is_required())
        return ", ".join([*(f"{name}=..." for name in names[:3]), *(["..."] if len(names) > 3 else [])])

    def __dir__(self) -> list[str]:
        """Own names, without those of pydantic: `help` and completion list no others."""
        return [name for name in super().__dir__() if not hasattr(BaseModel, name) and not name.startswith("_")]

    def _faults(self, error: ValidationError, data: dict[str, Any]) -> Any:
        return [replace(fault, path=(self.__name__, *fault.path)) for fault in faults_of(error, data, self)]


def _told(faults: list[Fault]) -> list[Fault]:
    """Faults with their mends as Python is written, unless the data are those of a file."""
    return [replace(fault, mend=in_python(fault.mend)) for fault in faults]


class Record(BaseModel, metaclass=_Raising):
    """A frozen record that accepts its own fields only; text with units is converted to SI numbers."""

    _positional: ClassVar[tuple[str, ...]] = ()

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Help and editors show the fields by their short types: ``mass: Mass = 0.0``."""
        cls.__signature__ = _signature(cls)

    model_config = ConfigDict(frozen=True, extra="forbid", validate_default=False, ser_json_inf_nan="constants")

    def with_(self, **changes: Any) -> Self:
        """A new record with some fields changed; the result is checked like any other."""
        return type(self)(**{name: getattr(self, name) for name in type(self).model_fields} | changes)

    def __repr_args__(self) -> Iterator[tuple[str | None, Any]]:
        """Fields that are not at their default, long lists in short."""
        for name, field in type(self).model_fields.items():
            value = getattr(self, name)
            if field.is_required() or value != field.get_default(call_default_factory=True):
                yield name, brief(value)

    def __str__(self) -> str:
        return repr(self)

    def __dir__(self) -> list[str]:
        """Fields and own methods, without those of pydantic."""
        return [name for name in super().__dir__() if name == "with_" or name.startswith("__") or not hasattr(BaseModel, name)]

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy; with an update the same as `with_`, so that all checks run."""
        return self.with_(**update) if update else super().model_copy(deep=deep)

    def __setattr__(self, name: str, value: Any) -> None:
        self._refuse(name)

    def __delattr__(self, name: str) -> None:
        self._refuse(name)

    def _refuse(self, name: str) -> NoReturn:
        what = type(self).__name__
        raise FrozenError(f"{what} is frozen: {shown(name)} cannot be changed. Make a new one: record.with_({name}=...).")


def _signature(cls: type[Record]) -> Signature:
    """Fields with their annotations as they are written in the class that has them."""
    written = {name: text for base in reversed(cls.__mro__) for name, text in get_annotations(base).items()}
    found = []
    for name, field in cls.model_fields.items():
        how = Parameter.POSITIONAL_OR_KEYWORD if name in cls._positional else Parameter.KEYWORD_ONLY
        default = Parameter.empty if field.is_required() else field.get_default(call_default_factory=True)
        found.append(Parameter(name, how, default=default, annotation=_plain(_short(str(written.get(name, "Any"))))))
    return Signature(sorted(found, key=lambda one: one.kind))


def _plain(annotation: str) -> str:
    """The types of this package that are no words of Python, written out.

    >>> _plain("Filled[Name, Rate]"), _plain("SectionOrName | None")
    ('dict[Name, Rate]', 'Section | Name | None')
    """
    text = annotation.replace("Moves", "Table[CoordinateName, tuple[Coordinate, Coordinate]]")
    return re.sub(r"(\w+)OrName\b", r"\1 | Name", re.sub(r"\b(?:Table|Filled)\[", "dict[", text))


def _short(annotation: str) -> str:
    """The type of a field without the rules for its values: the first argument of every ``Annotated``."""
    start = annotation.find("Annotated[")
    if start < 0:
        return annotation
    first = start + len("Annotated[")
    depth, comma = 0, 0
    for k in range(first, len(annotation)):
        depth += (annotation[k] in "[(") - (annotation[k] in ")]")
        if depth < 0:
            break
        if depth == 0 and annotation[k] == "," and not comma:
            comma = k
    return _short(annotation[:start] + annotation[first:comma] + annotation[k + 1 :])


def positive(value: float) -> float:
    """A rule for values: greater than 0."""
    if value <= 0:
        raise ValueError(f"{value:g} must be greater than 0. Give a positive value.")
    if value < SMALLEST:
        raise ValueError(f"{value:g} is too small to compute with. Give at least {SMALLEST:g}.")
    return value


def _no_negative_lump(value: float) -> float:
    if value < 0:
        raise ValueError(
            f"{value:g} must not be negative. Give 0 or a positive value; a body of which some lumps or bars would be negative "
            "is given as a whole: kt.Body."
        )
    return value


def _not_negative(value: float) -> float:
    if value < 0:
        raise ValueError(f"{value:g} must not be negative. Give 0 or a positive value.")
    if 0 < value < SMALLEST:
        raise ValueError(f"{value:g} is too small to compute with. Give 0, or at least {SMALLEST:g}.")
    return value


_NUMBER = rf"^\s*{NUMBER.pattern}\s*$"
_NUMBER_AND_UNIT = rf"^\s*{NUMBER.pattern}(\s*[A-Za-zµμ%].*)?$"


@dataclass(frozen=True)
class Of:
    """Annotation of a float field: its quantity, and a rule for its value.

    endless : the number may be as large as a float64; only values computed from it are checked against limits.
    """

    quantity: str
    rule: Callable[[float], float] | None = None
    endless: bool = False

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        # a plain schema: pydantic's float would turn a `Tagged` value into a bare one
        schema = core_schema.no_info_plain_validator_function(partial(_read, quantity=self.quantity, endless=self.endless))
        return schema if self.rule is None else core_schema.no_info_after_validator_function(self.rule, schema)

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        unit = unit_of(self.quantity)
        units = EITHER.get(self.quantity, unit)
        described = f"{self.quantity}: a number in {units}, or text with a unit" if unit else self.quantity
        text = _NUMBER_AND_UNIT if unit else _NUMBER
        return {"anyOf": [{"type": "number"}, {"type": "string", "pattern": text}], "description": described, "x-unit": unit}


def _read(value: Any, quantity: str, endless: bool) -> float:
    if endless and type(value) is float and math.isfinite(value):
        return value
    return parse(value, quantity)


def _flag(value: Any) -> Any:
    """Only true and false; no other value is converted."""
    if isinstance(value, str) and value in ("true", "false"):
        return value == "true"
    if not isinstance(value, bool):
        raise ValueError(f"{shown(value)} is not true or false. Write true or false.")
    return value


def _whole(value: Any) -> Any:
    """Whole numbers from numbers or text, ``1e3`` included; not from true or false."""
    number = value
    if isinstance(value, str) and NUMBER.fullmatch(value):
        number = float(value)
    if isinstance(number, float) and number.is_integer():
        number = int(number)
    if isinstance(number, bool) or not isinstance(number, Integral):
        raise ValueError(f"{shown(value)} is not a whole number. Write for example 200.")
    number = int(number)
    if abs(number) > MOST_WHOLE:
        raise ValueError(f"{shown(value)} is beyond what is counted with. Give a smaller number.")
    return number


def _listed(value: Any) -> Any:
    """Arrays as lists."""
    return value.tolist() if hasattr(value, "tolist") else value


def short_form(value: Any, field: str) -> Any:
    """A plain list or array is read as the record that has it as its `field`.

    >>> import kinetruss as kt
    >>> kt.model.short_form((0, 1), "at"), kt.model.short_form({"at": (0, 1)}, "at")
    ({'at': (0, 1)}, {'at': (0, 1)})
    """
    value = _listed(value)
    return {field: value} if isinstance(value, (list, tuple)) else value


def _choice(value: Any) -> str:
    return "name" if isinstance(value, str) else "record"


NameOrRecord = Discriminator(_choice)
"""Chooses between a name (Tag "name") and a record given in place (Tag "record")."""

Series = BeforeValidator(_listed)
"""Lets a tuple field be given as an array."""


class OneForBoth:
    """Annotation of a pair: one value is used for both."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(
            lambda value: (value, value) if isinstance(value, str | float | int) else _listed(value), handler(source)
        )

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        pair = handler(schema)
        return {"anyOf": [pair["prefixItems"][0], pair]}


def one_format(number: int, key: str, words: str) -> BeforeValidator:
    """The check of a format's version, which is this number. key : of it in a file. words : what a version is called."""

    def checked(value: Any) -> int:
        if value not in (number, str(number)) or isinstance(value, bool):
            raise ValueError(f"{words.format(shown(value))} is not known here. This release reads {key}: {number}.")
        return number

    return BeforeValidator(checked)


# besides white space and slashes: control characters, and characters that change the direction of text or are invisible
_HIDDEN = r"\x00-\x1f\x7f-\x9f\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff"
Name = Annotated[str, Field(strict=True, min_length=1, max_length=200, pattern=rf"^[^\s/\\{_HIDDEN}]+$")]
Flag = Annotated[bool, BeforeValidator(_flag), WithJsonSchema({"enum": [True, False, "true", "false"]})]
Whole = Annotated[
    int,
    BeforeValidator(_whole),
    WithJsonSchema({"anyOf": [{"type": "integer"}, {"type": "string", "pattern": _NUMBER}]}),
]
Count = Annotated[Whole, Field(ge=1, le=MOST_COUNT)]

Length = Annotated[float, Of("length")]
PositiveLength = Annotated[float, Of("length", positive)]
Distance = Annotated[float, Of("length", _not_negative)]
Mass = Annotated[float, Of("mass", _not_negative)]
LumpMass = Annotated[float, Of("mass", _no_negative_lump)]
Time = Annotated[float, Of("time")]
Delay = Annotated[float, Of("time", _not_negative)]
PositiveTime = Annotated[float, Of("time", positive)]
Span = Annotated[float, Of("time", positive, endless=True)]
"""A time that only matters as a multiple of another: the end of a run, a step."""
Angle = Annotated[float, Of("angle")]
AngularRate = Annotated[float, Of("angular rate", positive)]
Area = Annotated[float, Of("area", positive)]
SecondMoment = Annotated[float, Of("second moment of area", positive)]
Density = Annotated[float, Of("density", _not_negative)]
Stress = Annotated[float, Of("stress", positive)]
Force = Annotated[float, Of("force")]
Torque = Annotated[float, Of("torque", _not_negative)]
SignedTorque = Annotated[float, Of("torque")]
Stiffness = Annotated[float, Of("stiffness", positive)]
Damping = Annotated[float, Of("damping constant", _not_negative)]
RotaryFriction = Annotated[float, Of("rotary friction", _not_negative)]
RotaryFrictions = Annotated[tuple[RotaryFriction, RotaryFriction], OneForBoth()]
Acceleration = Annotated[float, Of("acceleration")]
Speed = Annotated[float, Of("speed", positive)]
Inertia = Annotated[float, Of("moment of inertia", _not_negative)]
Resistance = Annotated[float, Of("resistance", _not_negative)]
PositiveResistance = Annotated[float, Of("resistance", positive)]
Inductance = Annotated[float, Of("inductance", _not_negative)]
Voltage = Annotated[float, Of("voltage", positive)]
Current = Annotated[float, Of("current", positive)]
SignedVoltage = Annotated[float, Of("voltage")]
SignedCurrent = Annotated[float, Of("current")]
Transconductance = Annotated[float, Of("transconductance", positive)]
TorqueConstant = Annotated[float, Of("torque constant", positive)]
BackEmf = Annotated[float, Of("back-emf constant", _not_negative)]
Lead = Annotated[float, Of("lead", positive)]
Number = Annotated[float, Of("number")]
PositiveNumber = Annotated[float, Of("number", positive)]
Factor = Annotated[float, Of("factor")]
Coordinate = Annotated[float, Of("coordinate")]
Rate = Annotated[float, Of("rate")]
PositiveRate = Annotated[float, Of("rate", positive)]
Width = Annotated[float, Of("coordinate", _not_negative)]
SpringStiffness = Annotated[float, Of("spring stiffness", _not_negative)]
SpringDamping = Annotated[float, Of("spring damping", _not_negative)]
ContactDamping = Annotated[float, Of("contact damping")]
SpringForce = Annotated[float, Of("force or moment")]
Resisting = Annotated[float, Of("force or moment", _not_negative)]
SecondRate = Annotated[float, Of("second rate")]
PositiveSecondRate = Annotated[float, Of("second rate", positive)]
PositiveForce = Annotated[float, Of("force or moment", positive)]

Point = Annotated[tuple[Length, ...], Field(min_length=2, max_length=3), Series]
ForceVector = Annotated[tuple[Force, ...], Field(min_length=2, max_length=3), Series]
VelocityVector = Annotated[tuple[Annotated[float, Of("velocity")], ...], Field(min_length=2, max_length=3), Series]
GravityVector = Annotated[tuple[Acceleration, ...], Field(min_length=2, max_length=3), Series]
Spin = Annotated[tuple[Annotated[float, Of("angular rate")], ...], Field(min_length=1, max_length=3), Series]
SpinRate = Annotated[tuple[Annotated[float, Of("angular acceleration")], ...], Field(min_length=1, max_length=3), Series]
