"""Animated shapes: mechanisms of a model, vibration modes of a linearisation."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kinetruss.viewer.scenes.record import Mode

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Result

__all__ = ["mechanisms", "vibrations"]

DENSE = 300
"""Number of nodes up to which mechanisms are computed, since they need a dense rank decision."""

MOST = 24
"""Largest number of shapes in a scene."""


def mechanisms(model: Model) -> list[Mode]:
    """Mechanisms with all drives fixed; none for larger models."""
    from kinetruss.kinematics import mobility

    if len(model.nodes) > DENSE:
        return []
    return [Mode(name=f"mechanism {k + 1}", shape=shape) for k, shape in enumerate(mobility(model).mechanisms[:MOST])]


def vibrations(linearisation: Result) -> list[Mode]:
    """The undamped modes of a linearisation, slowest first."""
    data = linearisation.data
    found = []
    for k, (frequency, shape) in enumerate(zip(data["frequency"].values[:MOST], data["mode_shape"].values, strict=False)):
        away = math.isnan(frequency)
        name = f"mode {k + 1}, runs away" if away else f"mode {k + 1}"
        found.append(Mode(name=name, shape=shape, frequency=None if away else float(frequency)))
    return found
