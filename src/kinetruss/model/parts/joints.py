"""Joints by name: their nodes, bars, couplings, angles and slides."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field

from kinetruss.model._record import Name, Record, Series

if TYPE_CHECKING:
    pass

__all__ = ["FREEDOMS", "GROUND", "Hinge", "SHARED", "Joint"]

GROUND = "ground"
"""Name of the fixed frame, in place of a body."""

Kind = Literal[
    "spherical",
    "revolute",
    "prismatic",
    "cylindrical",
    "planar",
    "universal",
    "screw",
    "weld",
    "pin",
    "parallelogram",
    "double_parallelogram",
]

FREEDOMS = {
    "spherical": 3,
    "revolute": 1,
    "prismatic": 1,
    "cylindrical": 2,
    "planar": 3,
    "universal": 2,
    "screw": 1,
    "weld": 0,
    "pin": 1,
    "parallelogram": 1,
    "double_parallelogram": 2,
}
"""Relative degrees of freedom that a joint leaves."""

SHARED = {"spherical": 1, "pin": 1, "revolute": 2}
"""Number of nodes that the bodies of a joint must share; for a weld as many as there are axes."""

Names = Annotated[tuple[Name, ...], Series]


class Hinge(Record):
    """An angle at a joint: about the axis (two nodes, in the plane one) from node `start` to node `end`."""

    axis: Annotated[tuple[Name, ...], Field(min_length=1, max_length=2), Series]
    start: Name
    end: Name


class Joint(Record):
    """A joint between two bodies, as `library.joints` makes it from nodes and bars.

    kind : the kind of joint. bodies : two names, either may be ``ground``. nodes : its own and shared nodes. bars, couplings :
        its own; the bars of the bodies to its nodes are not included.
    hinges : angles at it. slide : two nodes whose distance is the slide.

    The record only holds names: the constraints come from the nodes, bars and couplings.
    """

    kind: Kind
    bodies: tuple[Name, Name]
    nodes: Names
    bars: Names = ()
    couplings: Names = ()
    hinges: Annotated[tuple[Hinge, ...], Series] = ()
    slide: tuple[Name, Name] | None = None

    @property
    def freedoms(self) -> int:
        """Relative degrees of freedom that it leaves."""
        return FREEDOMS[self.kind]
