"""Poses of bodies, planes and platforms; workspaces."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.poses.body_nodes import nodes_of
    from kinetruss.kinematics.poses.joint import shared_nodes
    from kinetruss.kinematics.poses.pose import carried

__all__ = ["carried", "nodes_of", "shared_nodes"]

__getattr__, __dir__ = late(
    __name__,
    {
        "body_nodes": "nodes_of",
        "joint": "shared_nodes",
        "pose": "carried",
    },
)
