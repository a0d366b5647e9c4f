"""The scene: all data of a viewer, as plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["FORMAT", "VERSION", "Mode", "Scene"]

FORMAT = "kinetruss.scene"
VERSION = 1
"""Version of the format; it increases if old readers would show new scenes wrongly, but not for additions."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Mode:
    """An animated shape: a mechanism, a vibration mode.

    name : text shown. shape : (n_nodes, dim) displacements, any scale. frequency : Hz, or None for a mechanism.
    """

    name: str
    shape: NDArray[Any]
    frequency: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Scene:
    """A model, alone or along a motion, as plain data.

    header : JSON data: names, kinds, supports, units of the arrays, channels; ``format`` and ``version`` name its
        form. The keys are listed in the documentation of the viewer.
    arrays : by name. Over time first, then nodes or members, then axes, as in results.
    """

    header: Mapping[str, Any]
    arrays: Mapping[str, NDArray[Any]]
