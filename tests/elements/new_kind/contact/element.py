"""Contact of spheres with the ground: N = k d^n (1 + c d'), never a pull, and friction -mu N v/sqrt(|v|^2 + slip^2)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.on_nodes import Part
from kinetruss.kernels.coordinates.node_laws import NodeLaw, Value
from kinetruss.kernels.coordinates.programs import Vector, above, dot, minus, root
from kinetruss.model.drives import CoordinateDrive
from kinetruss.model.simulation import Event

if TYPE_CHECKING:
    from kinetruss.mechanics.system import System


def depth(nodes: Sequence[Vector], numbers: Sequence[Any]) -> Any:
    """d, negative above the ground."""
    return numbers[0] - dot(nodes[0], tuple(numbers[6:9]))


def stored(nodes: Sequence[Vector], numbers: Sequence[Any]) -> Any:
    """Energy k d^(n + 1)/(n + 1)."""
    _, k, n, *_ = numbers
    return k * above(depth(nodes, numbers), n + 1.0) / (n + 1.0)


def pressed(t: Any, nodes: Sequence[Vector], rates: Sequence[Vector], numbers: Sequence[Any]) -> Any:
    """N."""
    _, k, n, c, *_ = numbers
    return k * above(depth(nodes, numbers), n) * above(1.0 - c * dot(rates[0], tuple(numbers[6:9])))


def resisted(t: Any, nodes: Sequence[Vector], rates: Sequence[Vector], numbers: Sequence[Any]) -> list[Vector]:
    """What damping adds to the force of the energy, and friction."""
    _, k, n, _, mu, slip, *up = numbers
    N, (v,), normal = pressed(t, nodes, rates, numbers), rates, tuple(up)
    along = minus(v, tuple(dot(v, normal) * one for one in normal))
    share = mu * N / root(dot(along, along) + slip * slip)
    added = N - k * above(depth(nodes, numbers), n)
    return [tuple(added * one - share * slid for one, slid in zip(normal, along, strict=True))]


VALUES = {
    "gap": Value(lambda _t, nodes, _v, numbers: -1.0 * depth(nodes, numbers), "m", "from the sphere to the ground"),
    "pressure": Value(pressed, "N", "normal force on the sphere"),
}


def contacts(system: System) -> Part | None:
    """The contacts of a model."""
    own: dict[str, Any] = system.model.contacts
    if not own:
        return None
    fields = ("radius", "height", "stiffness", "exponent", "damping", "friction", "slip")
    radius, height, *others = np.moveaxis(system.numbers("contact", *fields), -1, 0)
    up = np.broadcast_to(np.eye(3)[system.dim - 1], (*radius.shape, 3))
    axis, at = "xyz"[system.dim - 1], [[system.node_index(one.node)] for one in own.values()]
    met = {
        f"{name}.contact": Event(
            coordinate=CoordinateDrive(node=one.node, axis=axis), value=one.height + one.radius, stop=False
        )
        for name, one in own.items()
    }
    numbers = np.concatenate([np.stack([radius + height, *others], axis=-1), up], axis=-1)
    law, says = NodeLaw(stored, resisted, VALUES), "force of the ground on the node"
    return Part("contact", tuple(own), law, at, numbers, grounded=True, says=says, switches=met)
