"""Strain gauges on members, and the pose at which they are set to zero."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from kinetruss.model._record import Angle, Coordinate, Length, Name, Number, PositiveLength, PositiveNumber, Record, Time
from kinetruss.model._table import ReadOnly, Table

__all__ = ["Gauge", "GaugeZero"]


class Gauge(Record):
    """A strain gauge parallel to the axis of a bar, or of base or tube of an active member.

    part : ``base`` or ``tube``, of an active member. at : place as a fraction of the length, from the end at A; or
    `distance` from that end, m; by default the middle. angle : place around the section, rad, from member axis 2 towards 3.
    radius : distance from the axis, m; by default the gauge sits on the surface. factor : gauge factor, relative change of
    resistance over strain. group : gauges of one name, at one section, whose readings are split into axial strain and bending.
    """

    member: Name
    part: Literal["base", "tube"] | None = None
    at: Annotated[Number, Field(ge=0, le=1)] | None = None
    distance: Length | None = None
    angle: Angle = 0.0
    radius: PositiveLength | None = None
    factor: PositiveNumber = 2.0
    group: Name | None = None

    @model_validator(mode="after")
    def _one_place(self) -> Gauge:
        if self.at is not None and self.distance is not None:
            raise ValueError("has both at and distance. Give one: at (a fraction), or distance (m).")
        if self.distance is not None and self.distance < 0:
            raise ValueError(f"distance {self.distance:g} m must not be negative. Give 0 or a positive value.")
        return self


class GaugeZero(Record):
    """The reference state of all gauges: a pose at rest, under gravity, with the loads of `load_case` (by default none).

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
