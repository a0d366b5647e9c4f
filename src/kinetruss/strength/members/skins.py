"""Stress in the elements of the faces of membranes and solids, for pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics.structure import TRIANGLES
from kinetruss.strength.members.elements import elements

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.structure import Skin
    from kinetruss.model import Model

__all__ = ["skin_stress"]

MOST = 600_000
"""Largest number of elements times samples for which stress is computed."""


def skin_stress(model: Model, skin: Skin, position: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Von Mises stress (times, f), Pa, of the element of each face; None if it would take long.

    position : (times, n_nodes, dim), m. Of elements with linear strain: the largest at their points of integration.
    """
    records: dict[str, Any] = {**model.membranes, **model.solids}
    if not len(skin.nodes) or len(position) * sum(len(one.elements) for one in records.values()) > MOST:
        return None
    found = np.zeros((len(position), len(skin.nodes)))
    for k, name in enumerate(skin.names):
        values = elements(model, position, name)["von_mises"].values
        here = skin.part == k
        if values.ndim == 3 and values.shape[2] == len(TRIANGLES[6]):
            found[:, here] = values[:, skin.element[here], skin.corner[here]]
        else:
            found[:, here] = values.reshape(*values.shape[:2], -1).max(axis=2)[:, skin.element[here]]
    return found
