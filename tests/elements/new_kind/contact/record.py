"""Contact: a sphere on a node meets the ground."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from pydantic import model_validator

from kinetruss.errors import Fault
from kinetruss.model.drives import ElementRecord
from kinetruss.model.record import Coordinate, Number, PositiveLength, PositiveNumber, PositiveRate, SpringStiffness
from kinetruss.model.references import NodeName

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


class Contact(ElementRecord):
    """A sphere on a node meets the ground, a plane across the last axis, with the depth d: k d^n (1 + damping d'), never a pull
    (K. H. Hunt, F. R. E. Crossley, J. Appl. Mech. 42 (1975) 440, eq. 8), and friction of it, which creeps below `slip`.

    node : centre of the sphere. radius : its radius. height : of the ground. stiffness : k, N/m^n. exponent : n. damping :
    s/m. friction : coefficient. slip : speed at which the friction has 71 % of its size, m/s.
    """

    element: ClassVar[str] = "contact"
    node: NodeName
    radius: PositiveLength
    height: Coordinate = 0.0
    stiffness: SpringStiffness
    exponent: PositiveNumber = 1.5
    damping: Number = 0.0
    friction: Number = 0.0
    slip: PositiveRate = 1e-3

    @model_validator(mode="after")
    def _sound(self) -> Contact:
        for name in ("damping", "friction"):
            if getattr(self, name) < 0.0:
                raise ValueError(f"{name} {getattr(self, name):g} is negative: contact would give energy. Give at least 0.")
        return self

    def faults(self, model: ModelData, path: tuple[Any, ...]) -> Iterator[Fault]:
        """The sphere must not be in the ground in the model."""
        if (low := model.nodes[self.node].at[-1] - self.radius) < self.height:
            words = f"the sphere reaches down to {low:g} m, below the ground at {self.height:g} m."
            yield Fault((*path, "radius"), words, "Raise the node, or lower the ground.", about=(("nodes", self.node),))
