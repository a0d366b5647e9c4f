"""Attitudes in space, in the forms that engineers write, read as rotation matrices."""

from __future__ import annotations

import math
from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, WithJsonSchema

from kinetruss.errors import shown
from kinetruss.units import parse

FORMS = (
    "Give a rotation vector (three angles), a quaternion (w, x, y, z), a rotation matrix (three rows), or where two axes "
    "point, e.g. {z: [0, 1, 1], x: [1, 0, 0]}."
)
OFF = 1e-6
"""Largest difference of R^T R from the unit matrix of a rotation matrix that is given with rounded digits."""
EXACT = 1e-12
"""The same, below which a matrix stays as it is."""
PARALLEL = 1e-6
"""Smallest sine of the angle between two directions that give an attitude."""


def _attitude(value: Any) -> tuple[tuple[float, ...], ...]:
    """Rotation matrix R (rows of a 3 x 3 matrix) of any form."""
    value = value.as_matrix() if hasattr(value, "as_matrix") else value
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, dict):
        R = _from_directions(value)
    elif not isinstance(value, (list, tuple)) or len(value) not in (3, 4):
        raise ValueError(f"{shown(value)} is no attitude. {FORMS}")
    elif len(value) == 4:
        R = _from_quaternion(_numbers(value, 4))
    elif all(isinstance(row, (list, tuple)) for row in value):
        R = _from_matrix(np.array([_numbers(row, 3) for row in value]))
    else:
        R = _from_vector(_numbers(value, 3, "angle"))
    return tuple(tuple(row) for row in (R + 0.0).tolist())


def _numbers(values: Any, count: int, kind: str = "number") -> Any:
    """Finite numbers (count,)."""
    if not isinstance(values, (list, tuple)) or len(values) != count or any(isinstance(v, (list, tuple)) for v in values):
        raise ValueError(f"{shown(values)} are not {count} numbers. {FORMS}")
    found = np.array([parse(one, kind) for one in values], float)
    if not np.isfinite(found).all():
        raise ValueError(f"{shown(values)} has a number that is not finite. {FORMS}")
    return found


def _from_vector(vector: Any) -> Any:
    """Rodrigues (1840): 1 + sin(a) K + (1 - cos(a)) K K, a the length of the vector."""
    turn = float(np.linalg.norm(vector))
    if turn == 0.0:
        return np.eye(3)
    x, y, z = vector / turn
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + math.sin(turn) * K + (1.0 - math.cos(turn)) * (K @ K)


def _from_quaternion(quaternion: Any) -> Any:
    size = float(np.linalg.norm(quaternion))
    if size == 0.0:
        raise ValueError("the quaternion is 0 and turns nothing. The one of no rotation is [1, 0, 0, 0].")
    w, x, y, z = quaternion / size
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _from_matrix(R: Any) -> Any:
    """The matrix, with digits lost in writing mended: the nearest rotation (Kabsch, 1976)."""
    off = float(np.abs(R.T @ R - np.eye(3)).max())
    if not off <= OFF:
        raise ValueError(
            f"is no rotation matrix: R^T R differs from the unit matrix by {off:.3g} (at most {OFF:g}). Columns are "
            "unit vectors at right angles: give more digits, or where two axes point."
        )
    if np.linalg.det(R) < 0:
        raise ValueError("is a reflection: its determinant is -1, of a rotation 1. Reverse one axis, or swap two.")
    if off <= EXACT:
        return R
    left, _, right = np.linalg.svd(R)
    return left @ right


def _from_directions(given: dict[str, Any]) -> Any:
    """The first axis as given, the second as near to its direction as may be (H. D. Black, AIAA Journal 2 (1964) 1350-1351)."""
    if len(given) != 2 or not set(given) <= set("xyz"):
        raise ValueError(
            f"{shown(given)} does not say where two axes point. Name two of x, y, z, e.g. {{z: [0, 1, 1], x: [1, 0, 0]}}."
        )
    (first, a), (second, b) = ((name, _numbers(one, 3)) for name, one in given.items())
    for name, one in ((first, a), (second, b)):
        if not np.linalg.norm(one) > 0:
            raise ValueError(f"{name} points nowhere: its direction is 0. Give three numbers, not all 0.")
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    out = np.cross(a, b)
    if not np.linalg.norm(out) > PARALLEL:
        raise ValueError(f"{first} and {second} are to point along one line. Give them different directions.")
    i, j = "xyz".index(first), "xyz".index(second)
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    R = np.empty((3, 3))
    R[:, i] = a
    R[:, 3 - i - j] = sign * out / np.linalg.norm(out)
    R[:, j] = sign * np.cross(R[:, 3 - i - j], a)
    return R


_ROW = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
_SCHEMA = {
    "anyOf": [
        {"type": "array", "items": {"anyOf": [{"type": "number"}, {"type": "string"}]}, "minItems": 3, "maxItems": 4},
        {"type": "array", "items": _ROW, "minItems": 3, "maxItems": 3},
        {"type": "object", "properties": dict.fromkeys("xyz", _ROW), "additionalProperties": False, "minProperties": 2},
    ],
    "description": "rotation vector (rad, or text), quaternion (w, x, y, z), rotation matrix, or where two axes point",
}
Attitude = Annotated[tuple[tuple[float, ...], ...], BeforeValidator(_attitude), WithJsonSchema(_SCHEMA)]
"""R (3, 3), its columns the axes of a frame in global axes. Read from a rotation vector (axis times angle, rad), a quaternion
(w, x, y, z; of any length but 0), a rotation matrix, the directions of two of the axes x, y, z (the first exactly, the second
as near as may be), or in Python a rotation of SciPy."""
