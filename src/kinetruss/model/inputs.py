"""Inputs of a drive train, its load, and a position loop around it. Data only."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field, model_validator

from kinetruss.model.in_time import check_table
from kinetruss.model.record import (
    Angle,
    Coordinate,
    Force,
    Inertia,
    Length,
    Mass,
    PositiveNumber,
    PositiveTime,
    Record,
    Series,
    SignedCurrent,
    SignedTorque,
    SignedVoltage,
    Time,
)


def _one_of(*given: object) -> None:
    if sum(one is not None for one in given) != 1:
        raise ValueError(
            "an input is either a voltage (V; of an amplifier, where there is one), a current (A), or a torque of the motor "
            "(N m). Give one."
        )


class StepInput(Record):
    """A constant voltage (V), current (A) or torque of the motor (N m) from `start` on, until `end`; nothing before and after.

    A torque of the motor, here and in other inputs, is the current that produces it; the amplifier is bypassed.

    voltage : V, of the amplifier where there is one. current : A. torque : of the motor, N m. Give one of them.
    end : s; by default it never ends.
    """

    kind: Literal["step"] = "step"
    voltage: SignedVoltage | None = None
    current: SignedCurrent | None = None
    torque: SignedTorque | None = None
    start: Time = 0.0
    end: Time | None = None

    @model_validator(mode="after")
    def _sound(self) -> StepInput:
        _one_of(self.voltage, self.current, self.torque)
        if self.end is not None and self.end <= self.start:
            raise ValueError(f"the step ends at {self.end:g} s, before it starts at {self.start:g} s. Swap them.")
        return self


class ExponentialInput(Record):
    """A voltage, current or torque from a first value to a last one: last + (first - last) exp(-t/time_constant).

    voltage, current, torque : first and last value, V, A or N m; give one of them.
    """

    kind: Literal["exponential"] = "exponential"
    voltage: tuple[SignedVoltage, SignedVoltage] | None = None
    current: tuple[SignedCurrent, SignedCurrent] | None = None
    torque: tuple[SignedTorque, SignedTorque] | None = None
    time_constant: PositiveTime

    @model_validator(mode="after")
    def _sound(self) -> ExponentialInput:
        _one_of(self.voltage, self.current, self.torque)
        return self


class SineInput(Record):
    """A voltage, current or torque of this amplitude times sin(2 pi t/period + phase).

    voltage, current, torque : amplitude, V, A or N m; give one of them.
    """

    kind: Literal["sine"] = "sine"
    voltage: SignedVoltage | None = None
    current: SignedCurrent | None = None
    torque: SignedTorque | None = None
    period: PositiveTime
    phase: Angle = 0.0

    @model_validator(mode="after")
    def _sound(self) -> SineInput:
        _one_of(self.voltage, self.current, self.torque)
        return self


class TableInput(Record):
    """A table of voltages, currents or torques at times (s): linear between, constant outside.

    times : s, increasing.
    voltages, currents, torques : at these times, V, A or N m; give one of them.
    """

    kind: Literal["table"] = "table"
    times: Annotated[tuple[Time, ...], Field(min_length=2), Series]
    voltages: Annotated[tuple[SignedVoltage, ...], Series] | None = None
    currents: Annotated[tuple[SignedCurrent, ...], Series] | None = None
    torques: Annotated[tuple[SignedTorque, ...], Series] | None = None

    @model_validator(mode="after")
    def _sound(self) -> TableInput:
        _one_of(self.voltages, self.currents, self.torques)
        check_table(self.times, self.voltages or self.currents or self.torques or (), "values")
        return self


DriveInput = StepInput | ExponentialInput | SineInput | TableInput


class PositionLoop(Record):
    """The input follows the error of the length or angle, by state feedback whose gains place the poles.

    The wanted value is `target` (m, or rad counting on over full turns), or a table `times` (s), `targets`, linear between and
    constant outside. The loop is w^2/(s^2 + 2 zeta w s + w^2) with w = `settling_factor`/(zeta `settling_time`); with the
    inductance of the winding, times p/(s + p) with p = `third_pole` w. 4 is the usual factor (2 %); Lacy's (1991) programme
    has damping 0.8 and factor 6.

    target : wanted length or angle, m or rad. times : of a table of targets, s. targets : at these times, m or rad.
    """

    kind: Literal["position_loop"] = "position_loop"
    target: Coordinate | None = None
    times: Annotated[tuple[Time, ...], Series] | None = None
    targets: Annotated[tuple[Coordinate, ...], Series] | None = None
    settling_time: PositiveTime
    damping: PositiveNumber = 0.8
    settling_factor: PositiveNumber = 4.0
    third_pole: PositiveNumber = 2.0

    @model_validator(mode="after")
    def _sound(self) -> PositionLoop:
        if (self.target is None) == (self.times is None or self.targets is None):
            raise ValueError("a loop has one target. Give target: a length or an angle, or times and targets.")
        if self.times is not None and self.targets is not None:
            check_table(self.times, self.targets, "targets")
        return self

    @property
    def natural_frequency(self) -> float:
        """w, rad/s."""
        return self.settling_factor / (self.damping * self.settling_time)


class DriveLoad(Record):
    """The load of a drive: a thrust (N, positive shortens the member) and a mass (kg) that moves with its length.

    For a drive of an angle, it is a torque (N m, positive turns the angle back) and an inertia (kg m^2).
    The thrust is constant, or a table over `times` (s), or over `lengths` (m): linear between, constant outside; the torque
    likewise, over `times` or `angles` (rad).
    """

    thrust: Force | None = None
    times: Annotated[tuple[Time, ...], Field(min_length=2), Series] | None = None
    lengths: Annotated[tuple[Length, ...], Field(min_length=2), Series] | None = None
    thrusts: Annotated[tuple[Force, ...], Series] | None = None
    mass: Mass = 0.0
    torque: SignedTorque | None = None
    angles: Annotated[tuple[Angle, ...], Field(min_length=2), Series] | None = None
    torques: Annotated[tuple[SignedTorque, ...], Series] | None = None
    inertia: Inertia = 0.0

    @model_validator(mode="after")
    def _sound(self) -> DriveLoad:
        if self.of_length and self.of_angle:
            raise ValueError("a load is one of a length (thrust, mass) or of an angle (torque, inertia). Give one kind.")
        force, place = ("torque", "angle") if self.of_angle else ("thrust", "length")
        rows = [column for column in (self.times, self.places) if column is not None]
        if self.amounts is None and not rows:
            return self
        if self.amounts is None or len(rows) != 1 or self.amount is not None:
            raise ValueError(
                f"a load is one {force}, or a table. Give {force}; or {force}s with times; or {force}s with {place}s."
            )
        if self.times is not None:
            check_table(self.times, self.amounts, f"{force}s")
        elif any(b <= a for a, b in pairwise(rows[0])):
            raise ValueError(f"the {place}s of the table must increase. Sort the table by {place}.")
        elif len(rows[0]) != len(self.amounts):
            raise ValueError(f"{len(rows[0])} {place}s but {len(self.amounts)} {force}s. Give one of each.")
        return self

    @property
    def of_length(self) -> bool:
        """True if a load of a length is given."""
        return bool(self.mass) or any(one is not None for one in (self.thrust, self.thrusts, self.lengths))

    @property
    def of_angle(self) -> bool:
        """True if a load of an angle is given."""
        return bool(self.inertia) or any(one is not None for one in (self.torque, self.torques, self.angles))

    @property
    def amount(self) -> float | None:
        """The constant thrust (N) or torque (N m)."""
        return self.thrust if self.torque is None else self.torque

    @property
    def amounts(self) -> tuple[float, ...] | None:
        """Thrusts (N) or torques (N m) of the table."""
        return self.thrusts if self.torques is None else self.torques

    @property
    def places(self) -> tuple[float, ...] | None:
        """Lengths (m) or angles (rad) of the table."""
        return self.lengths if self.angles is None else self.angles

    @property
    def carried(self) -> float:
        """Mass (kg) or inertia (kg m^2) that moves with the length or angle."""
        return self.mass or self.inertia
