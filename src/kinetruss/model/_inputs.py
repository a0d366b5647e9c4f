"""What a drive train is fed with, what it moves, and a position loop around it. Data only."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from kinetruss.model._loads import check_table
from kinetruss.model._record import (
    Angle,
    Force,
    Length,
    Mass,
    Number,
    PositiveTime,
    Record,
    Series,
    SignedCurrent,
    SignedVoltage,
    Time,
)

__all__ = ["DriveInput", "DriveLoad", "ExponentialInput", "PositionLoop", "SineInput", "StepInput", "TableInput"]


def _one_of(voltage: object, current: object) -> None:
    if (voltage is None) == (current is None):
        raise ValueError("an input is either a voltage (V; of an amplifier, where there is one) or a current (A). Give one.")


class StepInput(Record):
    """A constant voltage (V) or current (A) from `start` on, until `end`; nothing before and after."""

    kind: Literal["step"] = "step"
    voltage: SignedVoltage | None = None
    current: SignedCurrent | None = None
    start: Time = 0.0
    end: Time | None = None

    @model_validator(mode="after")
    def _sound(self) -> StepInput:
        _one_of(self.voltage, self.current)
        if self.end is not None and self.end <= self.start:
            raise ValueError(f"the step ends at {self.end:g} s, before it starts at {self.start:g} s. Swap them.")
        return self


class ExponentialInput(Record):
    """A voltage or current from a first value to a last one: last + (first - last) exp(-t/time_constant)."""

    kind: Literal["exponential"] = "exponential"
    voltage: tuple[SignedVoltage, SignedVoltage] | None = None
    current: tuple[SignedCurrent, SignedCurrent] | None = None
    time_constant: PositiveTime

    @model_validator(mode="after")
    def _sound(self) -> ExponentialInput:
        _one_of(self.voltage, self.current)
        return self


class SineInput(Record):
    """A voltage or current of this amplitude times sin(2 pi t/period + phase)."""

    kind: Literal["sine"] = "sine"
    voltage: SignedVoltage | None = None
    current: SignedCurrent | None = None
    period: PositiveTime
    phase: Angle = 0.0

    @model_validator(mode="after")
    def _sound(self) -> SineInput:
        _one_of(self.voltage, self.current)
        return self


class TableInput(Record):
    """A table of voltages or currents at times (s): linear between, held outside."""

    kind: Literal["table"] = "table"
    times: Annotated[tuple[Time, ...], Field(min_length=2), Series]
    voltages: Annotated[tuple[SignedVoltage, ...], Series] | None = None
    currents: Annotated[tuple[SignedCurrent, ...], Series] | None = None

    @model_validator(mode="after")
    def _sound(self) -> TableInput:
        _one_of(self.voltages, self.currents)
        check_table(self.times, self.voltages or self.currents or (), "values")
        return self


DriveInput = StepInput | ExponentialInput | SineInput | TableInput


class PositionLoop(Record):
    """The input follows the error of the length, by state feedback whose gains place the poles.

    The wanted length is `target` (m), or a table `times` (s), `targets` (m), linear between and held outside. The loop is
    w^2/(s^2 + 2 zeta w s + w^2) with w = `settling_factor`/(zeta `settling_time`); where the winding's inductance counts, times
    p/(s + p) with p = `third_pole` w. 4 is the usual factor (2 %); Lacy's (1991) programme has damping 0.8 and factor 6.
    """

    kind: Literal["position_loop"] = "position_loop"
    target: Length | None = None
    times: Annotated[tuple[Time, ...], Series] | None = None
    targets: Annotated[tuple[Length, ...], Series] | None = None
    settling_time: PositiveTime
    damping: Annotated[Number, Field(gt=0)] = 0.8
    settling_factor: Annotated[Number, Field(gt=0)] = 4.0
    third_pole: Annotated[Number, Field(gt=0)] = 2.0

    @model_validator(mode="after")
    def _sound(self) -> PositionLoop:
        if (self.target is None) == (self.times is None or self.targets is None):
            raise ValueError("a loop has one target. Give target: a length, or times and targets.")
        if self.times is not None and self.targets is not None:
            check_table(self.times, self.targets, "targets")
        return self

    @property
    def natural_frequency(self) -> float:
        """w, rad/s."""
        return self.settling_factor / (self.damping * self.settling_time)


class DriveLoad(Record):
    """What a drive works against: a thrust (N, positive presses the member short) and a mass (kg) that moves with its length.

    The thrust is constant, or a table over `times` (s), or over `lengths` (m): linear between, held outside.
    """

    thrust: Force | None = None
    times: Annotated[tuple[Time, ...], Field(min_length=2), Series] | None = None
    lengths: Annotated[tuple[Length, ...], Field(min_length=2), Series] | None = None
    thrusts: Annotated[tuple[Force, ...], Series] | None = None
    mass: Mass = 0.0

    @model_validator(mode="after")
    def _sound(self) -> DriveLoad:
        rows = [column for column in (self.times, self.lengths) if column is not None]
        if self.thrusts is None and not rows:
            return self
        if self.thrusts is None or len(rows) != 1 or self.thrust is not None:
            raise ValueError("a load is one thrust, or a table. Give thrust; or thrusts with times; or thrusts with lengths.")
        if self.times is not None:
            check_table(self.times, self.thrusts, "thrusts")
        elif any(b <= a for a, b in zip(rows[0][:-1], rows[0][1:], strict=True)):
            raise ValueError("the lengths of the table must increase. Sort the table by length.")
        elif len(rows[0]) != len(self.thrusts):
            raise ValueError(f"{len(rows[0])} lengths but {len(self.thrusts)} thrusts. Give one of each.")
        return self
