"""The record of a beam."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from kinetruss.model.record import Delay, Mass, Name, Number, Record, Series, short_form
from kinetruss.model.references import NodeName
from kinetruss.model.sections import MaterialOrName, SectionOrName
from kinetruss.model.table import ReadOnly, Table

Vector = Annotated[tuple[Number, ...], Field(min_length=2, max_length=3), Series]


class Beam(Record):
    """A straight member that bends and twists, between two nodes.

    Beams that meet at a node share its rotation: their joint is stiff. A bar on the same node is pinned to it. The start
    configuration is free of stress.

    ends : names of its two nodes.
    kind : ``elastic`` (E, and in space and in shear G = E/(2 (1 + poisson)), of the material; large rotations and strains;
        flexible in shear where its section has a shear coefficient or shear areas), or ``rigid``.
    section, material : names or records, by default those of the model. mass : total, kg; by default density x area x
        length; spread evenly, with the rotary inertia of the section.
    orientation : in space a node, or a vector, that spans the plane of local axes 1 and 2 with the beam; by default global z
        (global x for a beam within 18 degrees of z). Axis 1 points from the first to the second end, 3 along 1 x orientation.
    hinges : in space, by end the one axis about which the beam turns freely against the node: a local axis of the beam (1
        along it, 2, 3), or a vector in global axes. The other rotations are shared.
    release : ends whose rotation the beam does not share with the node: a pin in the plane, a ball joint in space.
    damping : s; every stress of an elastic beam is E (strain + damping x rate of strain) (Kelvin and Voigt), G alike: a mode of
        angular frequency w in which only beams of this damping deform has the damping ratio w damping/2.
    rotation : of a rigid beam in the plane, a scalar node that is its angle from +x, rad, unwrapped: a coordinate like any
        other, and the beam two constraints x_Q - x_P = l (cos, sin) instead of one.

    The rotation of a node is carried by its frame: further nodes ``NODE.d1``, ``NODE.d2`` (``NODE.d3``) along x, y (z), held
    at fixed distances. `Model.whole` has them, their bars and their supports.

    Source: J. P. Meijaard, Nonlinear Dynamics 9 (1996) 21-36, and J. B. Jonker and J. P. Meijaard, SPACAR (1990), for the
    deformation modes.

    >>> import kinetruss as kt
    >>> steel = kt.Material(E=200e9, density=7800.0)
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], material=steel,
    ...                  section=kt.Rectangle(width=0.02, height=0.02), beams={"arm": ("A", "B")})
    >>> list(model.whole.nodes)
    ['A', 'B', 'A.d1', 'A.d2', 'B.d1', 'B.d2']
    """

    ends: tuple[NodeName, NodeName]
    kind: Literal["elastic", "rigid"] = "elastic"
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    mass: Mass | None = None
    orientation: NodeName | Vector | None = None
    release: Annotated[tuple[Name, ...], Series] = ()
    hinges: Table[Name, Literal[1, 2, 3] | Vector] = ReadOnly()
    rotation: NodeName | None = None
    damping: Delay = 0.0

    @model_validator(mode="before")
    @classmethod
    def _from_pair(cls, value: Any) -> Any:
        return short_form(value, "ends")
