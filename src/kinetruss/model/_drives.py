"""What moves a model: drives (one prescribed coordinate each) and poses (several drives at once, by a closed form)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field

from kinetruss.model._record import Name, PositiveLength, Record

__all__ = ["AngleDrive", "CoordinateDrive", "Drive", "GimbalPose", "LengthDrive", "Pose"]


class LengthDrive(Record):
    """Prescribes the length (m) of a bar or active member."""

    _positional: ClassVar = ("bar",)
    kind: Literal["length"] = "length"
    bar: Name

    if TYPE_CHECKING:

        def __init__(self, bar: str) -> None: ...


class AngleDrive(Record):
    """Prescribes the angle (rad) of a bar in the plane, from +x counter-clockwise to its first -> second end."""

    _positional: ClassVar = ("bar",)
    kind: Literal["angle"] = "angle"
    bar: Name

    if TYPE_CHECKING:

        def __init__(self, bar: str) -> None: ...


class CoordinateDrive(Record):
    """Prescribes one coordinate (m) of a node."""

    kind: Literal["coordinate"] = "coordinate"
    node: Name
    axis: Literal["x", "y", "z"]


Drive = Annotated[LengthDrive | AngleDrive | CoordinateDrive, Field(discriminator="kind")]


class GimbalPose(Record):
    """Pose of a double-octahedral bay: gimbal angles beta, gamma (rad) and the centroid distance `height` (m).

    Coordinates ``NAME.beta``, ``NAME.gamma``, ``NAME.height`` move the three lengths of `drives`, in the order
    M7, M9, M11 of Lacy (1991, chapter 4). `base` is the side of the base triangle, `longeron` the length of the
    cross longerons, m.
    """

    kind: Literal["gimbal"] = "gimbal"
    base: PositiveLength
    longeron: PositiveLength
    drives: tuple[Name, Name, Name]


Pose = GimbalPose
