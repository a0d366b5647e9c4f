"""Section vectors of the product, in member axes, brought to the references' global axes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.model import Model

__all__ = ["member_axes"]


def member_axes(model: Model, motion: Any, name: str) -> NDArray[np.float64]:
    """Axes 1, 2, 3 of a spatial member with an orientation node, as rows, in global axes (times, 3, 3).

    1 points from A to B, 3 along 1 x (orientation - A), 2 = 3 x 1.
    """
    member = model.members[name]
    if member.orientation is None:
        raise ValueError(f"member {name!r} has no orientation node.")
    a, b, third = (motion["position"].sel(node=node).values for node in (*member.ends, member.orientation))
    along = _unit(b - a)
    normal = _unit(np.cross(along, third - a))
    return np.stack([along, np.cross(normal, along), normal], 1)


def _unit(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    unit: NDArray[np.float64] = vectors / np.linalg.norm(vectors, axis=1, keepdims=True)
    return unit
