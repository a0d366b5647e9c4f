"""Checks of masses, inertias and frames; errors say what was given and what is possible."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model.checks import FLAT, beside, impossible, lying
from kinetruss.model.parts import quality

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["frame_axes", "numbers", "refuse_impossible", "span_points"]

ROUND = 1e-9
"""Tolerance of unit vectors of a frame and of an inertia, as a fraction of the largest."""


def numbers(what: str, value: Any) -> NDArray[np.float64]:
    """The value as an array of finite numbers; InputError otherwise."""
    try:
        found = np.array(value, float)
    except (TypeError, ValueError):
        raise InputError(f"{what} is {value!r}, which is no number. Give bare numbers in SI.") from None
    if not np.isfinite(found).all():
        raise InputError(f"{what} is {value!r}, which is not finite. Give finite numbers in SI.")
    return found


def refuse_impossible(what: str, mass: float, inertia: NDArray[np.float64]) -> None:
    """Raise an InputError for a negative mass, or moments of inertia that are impossible.

    mass kg, inertia (3, 3) kg m^2 about the centre, or one number of the plane.
    """
    if not mass >= 0:
        mend = "Give 0 or more; a hole is a part of negative mass beside the whole: bodies.combined(whole, hole)."
        raise InputError(f"{what} has the mass {mass:g} kg. {mend}")
    tensor = np.asarray(inertia, float)
    if tensor.ndim == 2 and np.abs(tensor - tensor.T).max() > ROUND * np.abs(tensor).max():
        i, j = np.unravel_index(int(np.abs(tensor - tensor.T).argmax()), tensor.shape)
        raise InputError(
            f"The inertia of {_small(what)} is not symmetric: entries {i + 1},{j + 1} and "
            f"{j + 1},{i + 1} are {tensor[i, j]:g} and {tensor[j, i]:g}. Give both the same value, minus "
            "the integral of the product of the coordinates."
        )
    if found := impossible(np.linalg.eigvalsh(tensor) if tensor.ndim == 2 else tensor.reshape(1)):
        mend = "Give moments about the centre of mass, kg m^2; about a point at a distance d they are larger by m d^2."
        raise InputError(f"The inertia of {_small(what)} {found} {mend}")


def _small(what: str) -> str:
    return what[0].lower() + what[1:]


def span_points(what: str, names: Sequence[str], points: NDArray[np.float64]) -> None:
    """Raise an InputError if points (k, dim), m, span no tetrahedron, triangle or line; it names them, and a suitable place."""
    if quality(points) > FLAT:
        return
    for i, one in enumerate(points):
        for j in range(i):
            if np.array_equal(one, points[j]):
                raise InputError(f"{what}: {names[j]} and {names[i]} stand at one place. Move one of them, or leave it out.")
    more = beside(points, min(len(points) - 1, points.shape[1]))
    places = " and ".join(f"({', '.join(f'{float(v):.4g}' for v in place)})" for place in more)
    moved = f"Move {'one of them, e.g.' if len(more) == 1 else 'two of them, e.g.' if len(more) == 2 else 'them'} to {places}"
    fewer = ", or give fewer points: three of a flat body, two of a rod" if points.shape[1] == 3 else ", or give two points"
    raise InputError(f"{what}: {', '.join(names)} lie {lying(points)}. {moved}{fewer}.")


def frame_axes(what: str, axes: Any, dim: int) -> NDArray[np.float64]:
    """Axes (dim, dim) of a frame, rows; InputError unless they are a right-handed orthonormal set."""
    found = numbers(f"axes of {what}", axes)
    if found.shape != (dim, dim):
        raise InputError(
            f"axes of {what} has the shape {found.shape}. Give {dim} rows of {dim}: the unit vectors of the frame."
        )
    if (off := float(np.abs(found @ found.T - np.eye(dim)).max())) > 1e3 * ROUND:
        raise InputError(
            f"axes of {what} miss unit vectors at right angles by {off:.3g}. Give unit vectors, each normal to the others."
        )
    if np.linalg.det(found) < 0:
        last = [float(-v) + 0.0 for v in found[-1]]
        raise InputError(
            f"axes of {what} are a left-handed frame. Turn the last axis round ({'xyz'[dim - 1]}: {last}), or swap two."
        )
    return found
