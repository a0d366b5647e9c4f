"""Errors of targets that do not fix a configuration, or that a structure cannot follow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import RANK_TOLERANCE, System, jacobian

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LARGEST", "PLATFORM", "explained", "freedoms"]

PLATFORM = ("x", "y", "z", "roll", "pitch", "yaw")
WAYS = ("move along x", "move along y", "move along z", "roll (turn about x)", "pitch (turn about y)", "yaw (turn about z)")
LARGEST = 1200
"""Largest number of free coordinates for which the degrees of freedom of a structure are counted."""


def explained(system: System, targets: Sequence[str], platform: Sequence[str] | None, error: InputError) -> InputError:
    """An error of the sweep in terms of targets: degrees of freedom left, motions that are impossible or held for the platform.

    system : with its drives; targets : names of the coordinates that move; platform : nodes that move as one, or None.
    """
    if len(system.free) > LARGEST or len(system.coordinate_drive):
        return error
    ways = freedoms(system)
    count = ways.shape[1]
    if platform is not None:
        cannot = _cannot(system, ways, platform)
        if cannot:
            able = (6 if system.dim == 3 else 3) - len(cannot)
            return InputError(
                f"To first order the platform cannot {' nor '.join(cannot)} from where it stands: its drives give it {able} of "
                f"the {able + len(cannot)} motions of a rigid body, and a platform's targets hold all of them. Start from "
                "another position, or name coordinates of single nodes as targets instead of a platform."
            )
    wanted = (6 if system.dim == 3 else 3) if platform is not None else len(targets)
    if count > wanted:
        left = count - wanted
        hold = ", or hold drives: make them bars of a given length." if system.drives else "."
        return InputError(
            f"The targets fix {wanted} of the {count} freedoms of the structure; {left} {'is' if left == 1 else 'are'} left. "
            f"Name as many targets as there are freedoms{hold}"
        )
    if platform is not None:
        held = [name for name in (PLATFORM if system.dim == 3 else ("x", "y", "yaw")) if name not in targets]
        if held:
            return InputError(
                f"{error} The targets of a platform hold all its motions: {', '.join(held)}, which are not named, stay as they "
                "are in the model. To leave them free, name coordinates of single nodes as targets."
            )
    return error


def freedoms(system: System) -> NDArray[np.float64]:
    """Orthonormal velocities (free, k) that the drives can produce, with all rows but theirs held."""
    kept = system.row_drive < 0
    J = jacobian(system, system.x0, system.drive_start)[kept]
    if not len(J):
        return np.eye(len(system.free))
    _, sizes, right = np.linalg.svd(J, full_matrices=True)
    rank = int(np.count_nonzero(sizes > RANK_TOLERANCE * max(1.0, float(sizes.max(initial=0.0)))))
    return np.ascontiguousarray(right[rank:].T)


def _cannot(system: System, ways: NDArray[np.float64], platform: Sequence[str]) -> list[str]:
    """Rigid-body motions of the platform that no degree of freedom contains, in words, by the nearest axes."""
    index = [system.node_index(name) for name in platform]
    full = np.zeros((system.x0.size, ways.shape[1]))
    full[system.free] = ways
    moves = full.reshape(len(system.nodes), 3, -1)[index]
    arms = system.x0[index] - system.x0[index].mean(axis=0)
    size = float(np.linalg.norm(arms, axis=1).max()) or 1.0
    turns = np.stack([np.cross(axis, arms) / size for axis in np.eye(3)], axis=-1)
    shifts = np.broadcast_to(np.eye(3), (len(index), 3, 3))
    rigid = np.concatenate([shifts, turns], axis=-1)[:, :, list(range(6)) if system.dim == 3 else [0, 1, 5]]
    names = WAYS if system.dim == 3 else (WAYS[0], WAYS[1], WAYS[5])
    flat = rigid.reshape(-1, rigid.shape[-1])
    twists = np.linalg.lstsq(flat, moves.reshape(-1, ways.shape[1]), rcond=None)[0]
    left, sizes, _ = np.linalg.svd(twists)
    rank = int(np.count_nonzero(sizes > 1e-8 * max(1.0, float(sizes.max(initial=0.0)))))
    lacking = left[:, rank:]
    found: list[str] = []
    for k in np.argsort(-np.linalg.norm(lacking, axis=1)):
        if len(found) < lacking.shape[1]:
            found.append(names[int(k)])
    return found
