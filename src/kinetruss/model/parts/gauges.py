"""Strain gauges on members, and the pose at which they are set to zero."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from kinetruss.model._record import (
    Angle,
    Coordinate,
    Flag,
    Length,
    Name,
    Number,
    PositiveLength,
    PositiveNumber,
    PositiveResistance,
    Record,
    Resistance,
    SignedVoltage,
    Time,
    Voltage,
)
from kinetruss.model._table import ReadOnly, Table

__all__ = ["Bridge", "Gauge", "GaugeZero"]


class Bridge(Record):
    """The bridge of a gauge, for records in volts.

    kind : the active arms. ``quarter``: the gauge alone; ``half_bending``: a second one with the opposite strain, beside it;
    ``half_axial``: one across the axis; ``half_opposite``: one with the same strain, opposite; ``full_bending`` and
    ``full_axial``: two such pairs. excitation, V. gain : of the amplifier. linear : True if the readings are to be taken as
    proportional to strain (an instrument that corrects them). poisson : ratio of the strains across and along.
    resistance : of the gauge, lead : of one lead of three, ohm. zero : reading at zero strain, zero_end : the same after the
    record, V; between them it drifts linearly. shunt : resistor across the gauge, ohm, and shunt_reading : the change of the
    reading that it made, V.
    """

    kind: Literal["quarter", "half_bending", "half_axial", "half_opposite", "full_bending", "full_axial"] = "quarter"
    excitation: Voltage
    gain: PositiveNumber = 1.0
    linear: Flag = False
    poisson: Number = 0.3
    resistance: PositiveResistance | None = None
    lead: Resistance = 0.0
    zero: SignedVoltage = 0.0
    zero_end: SignedVoltage | None = None
    shunt: PositiveResistance | None = None
    shunt_reading: SignedVoltage | None = None

    @model_validator(mode="after")
    def _whole(self) -> Bridge:
        if (self.shunt is None) != (self.shunt_reading is None):
            raise ValueError("has one of shunt and shunt_reading. Give both: the resistor, and the change of reading it made.")
        if self.shunt_reading == 0:
            raise ValueError("shunt_reading is 0 V: the shunt did nothing. Give the change of reading it made.")
        if self.resistance is None and (self.shunt is not None or self.lead):
            raise ValueError("has a shunt or a lead, but no resistance. Give the resistance of the gauge, e.g. 120 ohm.")
        return self


class Gauge(Record):
    """A strain gauge on a bar, or on base or tube of an active member, by default parallel to its axis.

    member : name of the bar or active member.
    distance : place in m from the end at A, in place of `at`.
    part : ``base`` or ``tube``, of an active member. at : place as a fraction of the length, from the end at A; or
    `distance` from that end, m; by default the middle. angle : place around the section, rad, from member axis 2 towards 3.
    radius : distance from the axis, m; by default the gauge sits on the surface. factor : gauge factor, relative change of
    resistance over strain. direction : of the gauge from the axis, towards growing `angle`, rad (shear gauges: +-45 deg).
    bridge : for records in volts. group : gauges of one name, at one section, whose readings are split into axial strain,
    bending and shear.
    """

    member: Name
    part: Literal["base", "tube"] | None = None
    at: Annotated[Number, Field(ge=0, le=1)] | None = None
    distance: Length | None = None
    angle: Angle = 0.0
    radius: PositiveLength | None = None
    factor: PositiveNumber = 2.0
    group: Name | None = None
    direction: Angle = 0.0
    bridge: Bridge | None = None

    @model_validator(mode="after")
    def _one_place(self) -> Gauge:
        if self.at is not None and self.distance is not None:
            raise ValueError("has both at and distance. Give one: at (a fraction), or distance (m).")
        if self.distance is not None and self.distance < 0:
            raise ValueError(f"distance {self.distance:g} m must not be negative. Give 0 or a positive value.")
        return self


class GaugeZero(Record):
    """The reference state of all gauges: a pose at rest, under gravity, with the loads of `load_case` (by default none).

    time : instant of the run, s, in place of `at`.
    load_case : whose loads act in the reference state; by default none.
    at : drive or pose coordinates -> value (m or rad), the others as in the model; or `time` of the run, s.
    """

    at: Table[Name, Coordinate] = ReadOnly()
    time: Time | None = None
    load_case: Name | None = None

    @model_validator(mode="after")
    def _one_pose(self) -> GaugeZero:
        if self.at and self.time is not None:
            raise ValueError("has both at and time. Give one: at (coordinates of a pose), or time (of the run).")
        return self
