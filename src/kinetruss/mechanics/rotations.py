"""Rotations of the nodes that carry a frame: nodes of beams, clamps, released ends of beams."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.caching import cached

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System

    Array = NDArray[np.float64]


class Framed(NamedTuple):
    """names : nodes, or beams and ends that turn on their own (``BEAM.NODE``). origin (k,), axes (k, dim) : their nodes."""

    names: tuple[str, ...]
    origin: NDArray[np.int64]
    axes: NDArray[np.int64]


@cached()
def framed(system: System) -> Framed | None:
    """The frames of a system; None if it has none."""
    found = system.inner.frames
    if not found:
        return None
    origin = np.array([system.node_index(one.origin) for one in found.values()], np.int64)
    axes = np.array([[system.node_index(node) for node in one.nodes] for one in found.values()], np.int64)
    return Framed(tuple(found), origin, axes)


def rotations(system: System, x: Array) -> Array:
    """Rotations (times, k, 1 or 3), rad, of the frames from the model to positions x (times, n, 3): the angle in the plane,
    from -pi to pi; in space the vector along the axis, of the size of the angle (0 to pi), global axes.
    """
    found = framed(system)
    if found is None:
        return np.zeros((len(x), 0, 1 if system.dim == 2 else 3))
    # edges as columns: D = R D0
    D0, D = (
        np.swapaxes(y[:, found.axes] - y[:, found.origin][:, :, None], 2, 3)[:, :, : system.dim] for y in (system.x0[None], x)
    )
    R = D @ np.linalg.inv(D0)
    if system.dim == 2:
        return np.asarray(np.arctan2(R[..., 1, 0] - R[..., 0, 1], R[..., 0, 0] + R[..., 1, 1])[..., None])
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_matrix(R.reshape(-1, 3, 3)).as_rotvec().reshape(*R.shape[:2], 3))


def small_rotations(system: System, x: Array, u: Array) -> Array:
    """The same for small displacements u from x, both (n, 3), to first order: (k, 1 or 3)."""
    found = framed(system)
    if found is None:
        return np.zeros((0, 1 if system.dim == 2 else 3))
    edges, moved = (y[found.axes] - y[found.origin][:, None] for y in (x, u))
    edges = edges / np.square(edges).sum(axis=-1, keepdims=True)
    # w x e = d for orthogonal edges e: the sum of e x d/|e|^2 is 2 w in space, and 2 w in the plane
    turned = 0.5 * np.cross(edges, moved).sum(axis=1)
    return np.asarray(turned[:, 2:] if system.dim == 2 else turned)


def rotation_axes(system: System) -> dict[str, Any]:
    """The axes of results with rotations; none without frames."""
    found = framed(system)
    return {} if found is None else {"frame": list(found.names), "about": ["z"] if system.dim == 2 else ["x", "y", "z"]}
