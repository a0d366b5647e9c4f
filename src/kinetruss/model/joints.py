"""Joints by name: their nodes, bars, couplings, angles and slides; and bearings with friction."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from kinetruss.model.record import Name, PositiveLength, PositiveNumber, PositiveRate, Record, Series
from kinetruss.model.references import BarName, CouplingName, MemberName, NodeName, Ref

GROUND = "ground"
"""Name of the fixed frame, in place of a body."""
BodyOrGroundName = Annotated[Name, Ref("body", "bodies", also=(GROUND,))]

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


class Hinge(Record):
    """An angle at a joint.

    axis : two nodes of the axis, in the plane one. start, end : nodes from which and to which the angle counts.
    """

    axis: Annotated[tuple[NodeName, ...], Field(min_length=1, max_length=2), Series]
    start: NodeName
    end: NodeName


class Joint(Record):
    """A joint between two bodies, as `library.joints` makes it from nodes and bars.

    kind : the kind of joint. bodies : two names, either may be ``ground``. nodes : its own and shared nodes. bars, couplings :
        its own; the bars of the bodies to its nodes are not included.
    hinges : angles at it. slide : two nodes whose distance is the slide.

    The record only holds names: the constraints come from the nodes, bars and couplings.
    """

    kind: Kind
    bodies: tuple[BodyOrGroundName, BodyOrGroundName]
    nodes: Annotated[tuple[NodeName, ...], Series]
    bars: Annotated[tuple[BarName, ...], Series] = ()
    couplings: Annotated[tuple[CouplingName, ...], Series] = ()
    hinges: Annotated[tuple[Hinge, ...], Series] = ()
    slide: tuple[NodeName, NodeName] | None = None

    @property
    def freedoms(self) -> int:
        """Relative degrees of freedom that it leaves."""
        return FREEDOMS[self.kind]


class Bearing(Record):
    """A pin, hinge or ball joint at an end of a member whose friction follows from the force in it (Coulomb).

    member, node : the member and the node at its end (or the hub whose arm it ends at). radius : of the pin or ball, m.
    friction : coefficient mu. against : the other member, or ``ground``; by default the ground where the node is fixed, else
    the one other member there. In space the ground, or at the hinge of a hub (`Hub.hinges`) the hub, about the axis.
    slip : of simulations, rad/s: the friction has 76 % of its size at this rate, and creeps below; it does not stick.

    The couple on the member is mu r |R| against its relative turning rate, with R its joint force; the other part feels the
    opposite. Where the rate is 0 it acts against the turning acceleration; where both are 0 it is not determined and counts as
    none. In a simulation it is -mu r |R| tanh(rate/slip). Source: friction circle, e.g. Hamrock, Schmid & Jacobson, Machine
    Elements.

    >>> import kinetruss as kt
    >>> kt.Bearing(member="arm", node="O", radius="20 mm", friction=0.1).radius
    0.02
    """

    member: MemberName
    node: NodeName
    radius: PositiveLength
    friction: PositiveNumber
    slip: PositiveRate = 1e-3
    against: Name | None = None
