"""Check that the closed form of a pose is that of the bay in the model."""

from __future__ import annotations

import numpy as np

from kinetruss.kinematics.path.assemble import own_start
from kinetruss.kinematics.poses.gimbal import check_sides, gimbal_pose
from kinetruss.mechanics import System, kept
from kinetruss.mechanics.configuration import FIT, POSE, bay_of, pose_fault, pose_members, pose_values

__all__ = ["check_pose"]


@kept(256)
def check_pose(system: System, pose: str) -> None:
    """Refuse a pose whose closed form is not that of the model's own bay.

    Raises
    ------
    ModelError : another base side or longeron than the bay has (so also a tapered bay), drives of no bay or in another order, a
        bay that stands on another assembly branch than upright.
    """
    record = system.model.poses[pose]
    check_sides(record.base, record.longeron)
    bay, x = bay_of(system, pose), own_start(system)
    pairs = [("base", a, b) for side in (bay.base, bay.top) for a, b in zip(side, (*side[1:], side[0]), strict=True)]
    corners = ((0, 2), (1, 2), (0, 1))  # of the middle nodes 4, 5, 6
    pairs += [
        ("longeron", m, side[k])
        for m, two in zip(bay.middle, corners, strict=True)
        for k in two
        for side in (bay.base, bay.top)
    ]
    found = [float(np.linalg.norm(x[b] - x[a])) for _, a, b in pairs]
    off = [abs(value - getattr(record, side)) for value, (side, _, _) in zip(found, pairs, strict=True)]
    worst = int(np.argmax(off))
    if off[worst] > FIT * record.longeron:
        side, a, b = pairs[worst]
        raise pose_fault(
            pose,
            f"{system.nodes[a]} and {system.nodes[b]} are {found[worst]:.9g} m apart in the model; the pose says "
            f"{getattr(record, side):.9g} m, so its angles would be those of another bay.",
            f"Give the {side} of the model's own bay; where its sides differ, no pose fits: move its lengths.",
            side,
        )
    members = pose_members(system, pose)
    lengths = np.linalg.norm(x[system.q[members]] - x[system.p[members]], axis=1)
    closed = np.array([float(value) for value in gimbal_pose(record.base, record.longeron, lengths)])
    measured = pose_values(system, pose, x.reshape(1, -1))[0]
    if np.abs(measured - closed).max() > 10 * FIT * max(1.0, record.longeron):
        given, wanted = (", ".join(f"{k} {v:.6g}" for k, v in zip(POSE, q, strict=True)) for q in (measured, closed))
        raise pose_fault(
            pose, f"the bay stands at {given}; with these lengths the pose means {wanted}.", "Draw the bay upright."
        )
