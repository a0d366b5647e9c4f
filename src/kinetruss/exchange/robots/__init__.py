"""Robots as other programs describe them, and models made of them. `of_model` makes a robot of a model."""

from kinetruss.exchange.robots.assemble import Assembled, assemble
from kinetruss.exchange.robots.closing import Posed, closed
from kinetruss.exchange.robots.records import (
    Closure,
    DrivenLength,
    JointCoupling,
    JointKind,
    LeftOut,
    Link,
    Pivot,
    Robot,
    RobotOfModel,
    Span,
    matrix_quaternion,
    placement,
    quaternion_matrix,
    turn_about,
)
from kinetruss.exchange.robots.sliders import with_sliders

__all__ = [
    "Assembled", "Closure", "DrivenLength", "JointCoupling", "JointKind", "LeftOut", "Link", "Pivot", "Posed", "Robot",
    "RobotOfModel", "Span",
    "assemble", "closed", "matrix_quaternion", "placement", "quaternion_matrix", "turn_about", "with_sliders",
]  # fmt: skip
