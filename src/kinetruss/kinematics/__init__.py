"""Where every node is: one configuration, a motion, what a wanted motion asks of the drives, what can move at all."""

from kinetruss.kinematics._assemble import assemble
from kinetruss.kinematics._follow import follow
from kinetruss.kinematics._gimbal import gimbal_lengths, gimbal_pose
from kinetruss.kinematics._given import from_arrays
from kinetruss.kinematics._inverse import inverse
from kinetruss.kinematics._mobility import Mobility, mobility
from kinetruss.kinematics._sample import Sampled, sample

__all__ = [
    "Mobility", "Sampled", "assemble", "follow", "from_arrays", "gimbal_lengths", "gimbal_pose", "inverse", "mobility", "sample",
]  # fmt: skip
