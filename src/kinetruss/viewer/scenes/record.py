"""The scene: everything a viewer shows, as plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["FORMAT", "VERSION", "Mode", "Scene"]

FORMAT = "kinetruss.scene"
VERSION = 1
"""Raised when a reader of the present version would show a newer scene wrongly; additions do not raise it."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Mode:
    """A shape to be shown swinging: a mechanism, a vibration mode.

    name : what is shown. shape : (n_nodes, dim) displacements, any scale. frequency : Hz, or None for a mechanism.
    """

    name: str
    shape: NDArray[Any]
    frequency: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Scene:
    """A model, alone or along a motion, as plain data.

    header : what JSON can hold: names, kinds, supports, units of the arrays, channels; ``format`` and ``version`` name its
        form. The keys are listed in the documentation of the viewer.
    arrays : by name. Over time first, then nodes or members, then axes, as in results.
    """

    header: Mapping[str, Any]
    arrays: Mapping[str, NDArray[Any]]
