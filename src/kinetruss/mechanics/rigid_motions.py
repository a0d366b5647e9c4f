"""Rigid motions of a whole structure, and which of them nothing holds.

A rigid motion is a twist (u, w): the velocity u of the place about which moments are taken, m/s, and the angular velocity w,
rad/s; T are the velocities of the nodes by unit twists.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.mechanics.rigid_parts import rigid_parts
from kinetruss.mechanics.row_gradients import RANK_TOLERANCE, jacobian

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System

    Array = NDArray[np.float64]

HELD = 1e-9
"""Rate of a constraint under a rigid motion, of unit gradients and a structure of unit size, from which on it holds it."""


def twists(dim: int) -> NDArray[np.int64]:
    """Which of the six components of a twist there are: all in space; along x and y and about z in the plane."""
    return np.arange(6) if dim == 3 else np.array([0, 1, 5])


class Scalars(NamedTuple):
    """Nodes that are no places: all of them, and those that are the rotation of a rigid beam in the plane."""

    all: NDArray[np.int64]
    rotations: NDArray[np.int64]

    def not_known(self, system: System) -> list[str]:
        """Those with a mass of which nothing says what turns, or goes along what."""
        return [system.nodes[i] for i in np.setdiff1d(self.all, self.rotations) if system.node_mass[i]]


@cached()
def scalars_of(system: System) -> Scalars:
    """The scalars of a system."""
    model = system.model
    turning = {beam.rotation for beam in model.beams.values() if beam.kind == "rigid"} - {None}
    every = [i for i, node in enumerate(model.nodes.values()) if node.scalar]
    return Scalars(np.array(every, np.int64), np.array([i for i in every if system.nodes[i] in turning], np.int64))


def rigid_fields(x: Array) -> Array:
    """T (..., 6, n, 3): velocities of nodes at x (..., n, 3) from the place of moments, m, by the six unit twists."""
    found = np.zeros((*x.shape[:-2], 6, *x.shape[-2:]))
    for k in range(3):
        found[..., k, :, k] = 1.0
        found[..., 3 + k, :, :] = np.cross(np.eye(3)[k], x)
    return found


def resultants(x: Array, force: Array) -> Array:
    """(..., 6): sum of vectors (..., n, 3) at the nodes x, and of their moments."""
    return np.concatenate([force.sum(axis=-2), np.cross(x, force).sum(axis=-2)], axis=-1)


@cached()
def floats(system: System) -> System | None:
    """A floating system as it stands in a frame of its own: coordinates of some of its nodes are held, which no rigid motion
    leaves as they are. None unless nothing holds the structure, and nothing in it is prescribed against the ground,
    as the idle axes of scalars are.

    The nodes are those of one rigid part where there is one, so that the frame is as good in all positions of the structure.
    """
    prescribed = system.prescribed.reshape(-1, 3)[:, : system.dim]
    if prescribed.any() or len(system.coordinate_drive) or not len(system.x0):
        return None
    from scipy.linalg import qr

    size = float(np.ptp(system.x0, axis=0).max())
    x, own = (system.x0 - system.x0.mean(axis=0)) / (size or 1.0), twists(system.dim)
    ways = rigid_fields(x)[own].reshape(len(own), -1).T
    if len(system.row_member) and np.abs(jacobian(system, system.x0, system.drive_start) @ ways[system.free]).max() > HELD:
        return None
    for nodes in _candidates(system):
        flats = (3 * np.array(sorted(nodes))[:, None] + np.arange(system.dim)).reshape(-1)
        _, R, order = qr(ways[flats].T, mode="economic", pivoting=True)
        if len(flats) < len(own) or abs(R[len(own) - 1, len(own) - 1]) < RANK_TOLERANCE * abs(R[0, 0]):
            continue
        held = system.prescribed.copy()
        held[flats[order[: len(own)]]] = True
        return system.with_rows(slice(None), prescribed=held)
    return None


def _candidates(system: System) -> list[set[int]]:
    """Nodes on which a frame may stand: of the rigid parts, the largest first; of a rigid bar, in the plane; all."""
    parts = sorted((set(one.nodes) for one in rigid_parts(system)), key=lambda nodes: (-len(nodes), min(nodes)))
    bars = [{int(system.p[m]), int(system.q[m])} for m in system.row_member[system.row_drive < 0]] if system.dim == 2 else []
    return [*parts, *bars, set(range(len(system.nodes)))]
