"""The camera: presets, the distance at which everything is in the picture, and projection of points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["PRESETS", "Camera", "aimed"]

PRESETS = {
    "iso": (0.72, -1.0, 0.42),
    "corner": (0.72, -1.0, 0.42),
    "front": (0.0, -1.0, 0.0),
    "side": (1.0, 0.0, 0.0),
    "top": (0.0, 0.0, 1.0),
}
"""Directions of the presets; ``corner`` is ``iso`` in the page."""
ANGLE = np.radians(24.0)
MARGIN = 0.94


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Camera:
    """A camera at `eye` (m) that looks at `target`; right, upward and backward are unit vectors; wide : width over height."""

    eye: Array
    target: Array
    right: Array
    upward: Array
    backward: Array
    wide: float

    def seen(self, points: Array, width: int, height: int) -> Array:
        """Pixel coordinates (n, 2), from the left and from the top, of points (n, 3)."""
        apart = points - self.eye
        depth = -(apart @ self.backward) * np.tan(ANGLE / 2)
        x, y = apart @ self.right / (depth * self.wide), apart @ self.upward / depth
        return np.column_stack([(1 + x) * width / 2, (1 - y) * height / 2])


def aimed(camera: str | Sequence[float], points: Array, wide: float, dim: int) -> Camera:
    """A camera that shows all points (n, 3) as large as possible.

    camera : a preset, or the direction from the structure to the eye.

    Raises
    ------
    InputError : no such preset; a direction without length.
    """
    backward = _direction(camera, dim)
    up = np.array([0.0, 1.0, 0.0]) if abs(backward[2]) > 0.999 else np.array([0.0, 0.0, 1.0])
    right = np.cross(up, backward)
    right /= np.linalg.norm(right)
    upward = np.cross(backward, right)
    axes = np.stack([right, upward, backward])
    flat = points @ axes.T
    centre = (flat.min(axis=0) + flat.max(axis=0)) / 2
    for _ in range(4):  # in perspective near points look larger, so that the middle of the picture is not that of the box
        x, y, w = (flat - centre).T
        steep = np.tan(ANGLE / 2) * MARGIN
        far = max(float(np.max(np.abs(x) / (steep * wide) + w)), float(np.max(np.abs(y) / steep + w)), 1e-6)
        depth = far - w
        centre[0] += _middle(x / depth) * far
        centre[1] += _middle(y / depth) * far
    x, y, w = (flat - centre).T
    far = max(float(np.max(np.abs(x) / (steep * wide) + w)), float(np.max(np.abs(y) / steep + w)), 1e-6)
    target = centre @ axes
    return Camera(eye=target + far * backward, target=target, right=right, upward=upward, backward=backward, wide=wide)


def _middle(seen: Array) -> float:
    return float(seen.min() + seen.max()) / 2


def _direction(camera: str | Sequence[float], dim: int) -> Array:
    if isinstance(camera, str):
        if camera not in PRESETS:
            raise InputError(f"No camera called {camera!r}. {nearest(camera, PRESETS)}")
        # a plane structure is seen along the normal of its plane by default
        camera = (0.0, 0.0, 1.0) if dim == 2 and camera in ("iso", "corner") else PRESETS[camera]
    found = np.array(camera, float)
    if found.shape != (3,) or not np.isfinite(found).all() or not np.linalg.norm(found) > 0:
        raise InputError(f"camera {tuple(camera)}: give a preset ({', '.join(PRESETS)}) or a direction (x, y, z).")
    direction: Array = found / np.linalg.norm(found)
    return direction
