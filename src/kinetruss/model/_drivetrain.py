"""Lead screw, gear and motor of an active member."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Tag, field_validator, model_validator

from kinetruss.model._record import (
    Angle,
    AngularRate,
    BackEmf,
    Current,
    Inductance,
    Inertia,
    Lead,
    Name,
    NameOrRecord,
    Number,
    PositiveLength,
    Record,
    Resistance,
    Torque,
    TorqueConstant,
    Voltage,
)  # fmt: skip

__all__ = ["Gear", "GearOrName", "LeadScrew", "Motor", "MotorOrName", "ScrewOrName"]


class LeadScrew(Record):
    """Lead screw: lead in m/rad (text may say ``mm/rev``), mean thread diameter in m, friction coefficient.

    `flank` is the thread half-angle: 0 for a square thread, 14.5 deg for Acme, 15 deg for trapezoidal metric.
    """

    lead: Lead
    mean_diameter: PositiveLength
    friction: Number = 0.0
    flank: Angle = 0.0

    @field_validator("friction")
    @classmethod
    def _friction(cls, value: float) -> float:
        if not 0 <= value < 1:
            raise ValueError(f"friction coefficient {value:g} must lie between 0 and 1. Greased steel on bronze: 0.1.")
        return value

    @field_validator("flank")
    @classmethod
    def _flank(cls, value: float) -> float:
        if not 0 <= value < 0.8:
            raise ValueError(f"thread half-angle {value:g} rad must lie between 0 and 45 deg. Acme: '14.5 deg'.")
        return value


class Gear(Record):
    """Gear between motor and screw: motor speed over screw speed; efficiency between 0 and 1."""

    ratio: Number
    efficiency: Number = 1.0
    inertia: Inertia = 0.0

    @model_validator(mode="after")
    def _ranges(self) -> Gear:
        if self.ratio <= 0:
            raise ValueError(f"gear ratio {self.ratio:g} must be greater than 0 (motor turns per screw turn). Give 1 for none.")
        if not 0 < self.efficiency <= 1:
            raise ValueError(f"gear efficiency {self.efficiency:g} must lie above 0 and at most 1. Give 1 for no loss.")
        return self


class Motor(Record):
    """DC motor: armature inertia, winding resistance, torque and back-emf constants, limits; SI."""

    kind: Literal["dc"] = "dc"
    inertia: Inertia
    resistance: Resistance
    torque_constant: TorqueConstant
    emf_constant: BackEmf
    inductance: Inductance = 0.0
    friction_torque: Torque = 0.0
    max_voltage: Voltage | None = None
    max_current: Current | None = None
    max_speed: AngularRate | None = None
    max_torque: Torque | None = None
    source: str = ""


ScrewOrName = Annotated[Annotated[LeadScrew, Tag("record")] | Annotated[Name, Tag("name")], NameOrRecord]
GearOrName = Annotated[Annotated[Gear, Tag("record")] | Annotated[Name, Tag("name")], NameOrRecord]
MotorOrName = Annotated[Annotated[Motor, Tag("record")] | Annotated[Name, Tag("name")], NameOrRecord]
