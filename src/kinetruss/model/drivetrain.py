"""Lead screw, gear, motor and amplifier of an active member."""

from __future__ import annotations

import math
from functools import partial
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, ConfigDict, Tag, field_validator, model_validator

from kinetruss.errors import UnitError
from kinetruss.model.collecting import from_library
from kinetruss.model.record import (
    Angle,
    AngularRate,
    BackEmf,
    Current,
    Inductance,
    Inertia,
    Lead,
    NameOrRecord,
    Number,
    PositiveLength,
    PositiveTime,
    Record,
    Resistance,
    Torque,
    TorqueConstant,
    Transconductance,
    Voltage,
)
from kinetruss.model.references import AmplifierName, GearName, MotorName, ScrewName
from kinetruss.units import parse


class LeadScrew(Record):
    """Lead screw: lead, mean thread diameter in m, friction coefficient.

    A bare number of `lead` is in m per radian: 1/(2 pi) of the lead per turn in catalogues; write ``"5 mm/rev"``.

    `flank` is the thread half-angle: 0 for a square thread, 14.5 deg for Acme, 15 deg for trapezoidal metric.
    `static_friction` is the coefficient at rest; by default that of the running screw.
    `hand` : of the thread; it gives the sign of the torque about the axis of the member.

    lead : travel per angle, m/rad; text may say mm/rev.
    mean_diameter : of the thread, m.
    friction : coefficient between screw and nut, running.
    static_friction : coefficient at rest; by default that of the running screw.
    flank : half-angle of the thread, rad.
    hand : of the thread.
    """

    lead: Lead
    mean_diameter: PositiveLength
    friction: Number = 0.0
    flank: Angle = 0.0
    static_friction: Number | None = None
    hand: Literal["right", "left"] = "right"

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

    @model_validator(mode="after")
    def _at_rest(self) -> LeadScrew:
        if self.static_friction is not None and not self.friction <= self.static_friction < 1:
            raise ValueError(
                f"static friction {self.static_friction:g} must lie between the running friction {self.friction:g} and 1. "
                "At rest a screw sticks more than it does running."
            )
        return self


class Gear(Record):
    """Gear between motor and screw, or motor and angle: motor speed over the other speed; efficiency between 0 and 1.

    `back_efficiency` applies if power flows back to the motor; by default it is the `efficiency`. For a self-locking gear it
    is 0 or less: moving with the load then needs motor torque. A worm of lead angle a and friction angle r has tan(a)/tan(a +
    r) and tan(a - r)/tan(a).

    ratio : motor speed over output speed.
    efficiency : power at the output over that of the motor, which drives.
    back_efficiency : if the load drives the motor; by default the `efficiency`.
    inertia : of its parts, at the motor, kg m^2.
    """

    ratio: Number
    efficiency: Number = 1.0
    back_efficiency: Number | None = None
    inertia: Inertia = 0.0

    @model_validator(mode="after")
    def _ranges(self) -> Gear:
        if self.ratio <= 0:
            raise ValueError(f"gear ratio {self.ratio:g} must be greater than 0 (motor turns per screw turn). Give 1 for none.")
        if not 0 < self.efficiency <= 1:
            raise ValueError(f"gear efficiency {self.efficiency:g} must lie above 0 and at most 1. Give 1 for no loss.")
        if self.back_efficiency is not None and not -math.inf < self.back_efficiency <= 1:
            raise ValueError(
                f"gear back_efficiency {self.back_efficiency:g} must be finite and at most 1. Give 1 for no loss, 0 or less "
                "where the gear holds its load by itself."
            )
        return self

    @property
    def backwards(self) -> float:
        """Torque at the motor times the ratio over the torque at the output, if the load drives the motor."""
        return self.efficiency if self.back_efficiency is None else self.back_efficiency

    @property
    def self_locking(self) -> bool:
        """True if no load can drive the gear backwards."""
        return self.backwards <= 0


_MOTOR_DATA = ("inertia", "resistance", "time_constant")


def _two_of_three(schema: dict[str, Any]) -> None:
    """Two of inertia, resistance and time constant give the third."""
    schema["required"] = [name for name in schema["required"] if name not in _MOTOR_DATA]
    schema["anyOf"] = [{"required": [a, b]} for a, b in zip(_MOTOR_DATA, (*_MOTOR_DATA[1:], _MOTOR_DATA[0]), strict=True)]


class Motor(Record):
    """DC motor: armature inertia, winding resistance, torque and back-emf constants, limits; SI.

    `time_constant` (s, of the unloaded motor at a constant voltage: J R/(K_t K_b)) may replace the inertia or the resistance.
    `max_current` and `max_torque` are peak limits, `rated_current` and `rated_torque` continuous limits (compared with the
    root mean square).

    inertia : of the rotor, kg m^2.
    resistance : of the winding, ohm.
    inductance : of the winding, H.
    torque_constant : torque per current, N m/A.
    emf_constant : back-emf per speed, V s/rad.
    friction_torque : Coulomb friction of the bearings, N m.
    time_constant : s, of the unloaded motor at a constant voltage, in place of the inertia or the resistance.
    max_voltage, max_current, max_speed, max_torque : peak limits, V, A, rad/s, N m.
    rated_current, rated_torque : continuous limits, A, N m.
    source : where the values are from.
    """

    model_config = ConfigDict(json_schema_extra=_two_of_three)

    kind: Literal["dc"] = "dc"
    inertia: Inertia
    resistance: Resistance
    torque_constant: TorqueConstant
    emf_constant: BackEmf
    inductance: Inductance = 0.0
    friction_torque: Torque = 0.0
    time_constant: PositiveTime | None = None
    max_voltage: Voltage | None = None
    max_current: Current | None = None
    max_speed: AngularRate | None = None
    max_torque: Torque | None = None
    rated_current: Current | None = None
    rated_torque: Torque | None = None
    source: str = ""

    @model_validator(mode="before")
    @classmethod
    def _from_time_constant(cls, value: Any) -> Any:
        if not isinstance(value, dict) or value.get("time_constant") is None:
            return value
        missing = [name for name in ("inertia", "resistance") if name not in value]
        if len(missing) != 1:
            return value
        try:
            kind = {"inertia": "moment of inertia", "resistance": "resistance"}
            (known,) = kind.keys() - set(missing)
            squared = parse(value["torque_constant"], "torque constant") * parse(value["emf_constant"], "back-emf constant")
            found = parse(value["time_constant"], "time") * squared / parse(value[known], kind[known])
        except (KeyError, UnitError, ZeroDivisionError):
            # faults of the others are reported; this value is inserted so that it is not reported as missing
            found = 1.0
        return value | {missing[0]: found}

    @model_validator(mode="after")
    def _possible(self) -> Motor:
        if abs(self.emf_constant - self.torque_constant) > 0.1 * self.torque_constant:
            raise ValueError(
                f"the back-emf constant {self.emf_constant:g} V s/rad does not fit the torque constant "
                f"{self.torque_constant:g} N m/A: such a motor would make power. In SI both are the same number."
            )
        if self.time_constant is not None:
            found = self.inertia * self.resistance / (self.torque_constant * self.emf_constant)
            if abs(found - self.time_constant) > 0.02 * self.time_constant:
                raise ValueError(
                    f"time constant {self.time_constant:g} s does not fit J R/(K_t K_b) = {found:g} s. "
                    "Give two of inertia, resistance and time_constant."
                )
        return self


class Amplifier(Record):
    """The amplifier of a motor: a current of `current_gain` A/V, or a voltage of `voltage_gain` V/V, times its input.

    current_gain : output current per input voltage, A/V.
    voltage_gain : output voltage per input voltage.
    source : where the values are from.
    max_input : V, larger inputs are limited to it. max_voltage, max_current : limits of its output.
    """

    current_gain: Transconductance | None = None
    voltage_gain: Number | None = None
    max_input: Voltage | None = None
    max_voltage: Voltage | None = None
    max_current: Current | None = None
    source: str = ""

    @model_validator(mode="after")
    def _one_gain(self) -> Amplifier:
        if (self.current_gain is None) == (self.voltage_gain is None):
            raise ValueError("an amplifier has one gain. Give current_gain (A/V) or voltage_gain (V/V).")
        if self.voltage_gain is not None and self.voltage_gain <= 0:
            raise ValueError(f"voltage gain {self.voltage_gain:g} must be greater than 0. Turn the sign of the input instead.")
        return self

    @property
    def gain(self) -> float:
        """A/V or V/V."""
        found = self.current_gain if self.current_gain is not None else self.voltage_gain
        return found or 0.0


class DriveTrain(Record):
    """Everything between a voltage and a length: amplifier (by default none), motor, gear (by default none), screw.

    Without a screw it drives an angle. Each is a record, or the name of one in the library.
    """

    screw: Annotated[LeadScrew | None, BeforeValidator(partial(from_library, table="screws"))] = None
    motor: Annotated[Motor, BeforeValidator(partial(from_library, table="motors"))]
    gear: Annotated[Gear, BeforeValidator(partial(from_library, table="gears"))] = Gear(ratio=1.0)
    amplifier: Annotated[Amplifier | None, BeforeValidator(partial(from_library, table="amplifiers"))] = None


ScrewOrName = Annotated[Annotated[LeadScrew, Tag("record")] | Annotated[ScrewName, Tag("name")], NameOrRecord]
GearOrName = Annotated[Annotated[Gear, Tag("record")] | Annotated[GearName, Tag("name")], NameOrRecord]
MotorOrName = Annotated[Annotated[Motor, Tag("record")] | Annotated[MotorName, Tag("name")], NameOrRecord]
AmplifierOrName = Annotated[Annotated[Amplifier, Tag("record")] | Annotated[AmplifierName, Tag("name")], NameOrRecord]
