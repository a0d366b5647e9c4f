"""Drag: resistance of a fluid at rest to a node, and of what holds the node elastically in it."""

from __future__ import annotations

from typing import ClassVar

from kinetruss.model.drives import ElementRecord
from kinetruss.model.record import Area, Density, PositiveNumber, Stiffness
from kinetruss.model.references import NodeName


class Drag(ElementRecord):
    """Resistance of a fluid at rest to a node: density coefficient area/2 times the square of its speed; and elastic bedding.

    node : on which it acts. area : of the front. coefficient : of drag. density : of the fluid, by default of air. bedding :
    stiffness against displacements from the place in the model.
    """

    element: ClassVar[str] = "drag"
    node: NodeName
    area: Area
    coefficient: PositiveNumber = 1.0
    density: Density = 1.225
    bedding: Stiffness | None = None
