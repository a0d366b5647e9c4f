"""Drag on nodes with an elastic bedding: F = -c |v| v - k (x - x0), c = density coefficient area/2."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.on_nodes import Part
from kinetruss.kernels.coordinates.node_laws import NodeLaw
from kinetruss.kernels.coordinates.programs import Vector, dot, minus, speed

if TYPE_CHECKING:
    from kinetruss.mechanics.system import System


def bedding(nodes: Sequence[Vector], numbers: Sequence[Any]) -> Any:
    """Energy k |x - x0|^2/2."""
    _, stiffness, *start = numbers
    d = minus(nodes[0], tuple(start))
    return 0.5 * stiffness * dot(d, d)


def drag(t: Any, nodes: Sequence[Vector], rates: Sequence[Vector], numbers: Sequence[Any]) -> list[Vector]:
    """Force -c |v| v."""
    (v,), c = rates, numbers[0]
    return [tuple(-1.0 * c * speed(v) * one for one in v)]


def drags(system: System) -> Part | None:
    """The drags of a model."""
    own: dict[str, Any] = system.model.drags
    if not own:
        return None
    area, coefficient, density, bed = np.moveaxis(system.numbers("drag", "area", "coefficient", "density", "bedding"), -1, 0)
    at = [system.node_index(one.node) for one in own.values()]
    start = np.broadcast_to(system.x0[..., at, :], (*area.shape, 3))
    c, stiff = density * coefficient * area / 2, np.where(np.isnan(bed), 0.0, bed)
    numbers = np.concatenate([c[..., None], stiff[..., None], start], axis=-1)
    law, says = NodeLaw(bedding, drag), "resistance on the node"
    return Part("drag", tuple(own), law, [[k] for k in at], numbers, grounded=True, says=says)
