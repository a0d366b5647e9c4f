"""Robots as other programs describe them, and models made of them."""

from kinetruss.exchange.robots.assemble import Assembled, assemble
from kinetruss.exchange.robots.closing import Posed, closed
from kinetruss.exchange.robots.records import (
    Closure,
    JointKind,
    LeftOut,
    Link,
    Pivot,
    Robot,
    placement,
    quaternion_matrix,
    turn_about,
)

__all__ = [
    "Assembled", "Closure", "JointKind", "LeftOut", "Link", "Pivot", "Posed", "Robot", "assemble", "closed", "placement",
    "quaternion_matrix", "turn_about",
]  # fmt: skip
