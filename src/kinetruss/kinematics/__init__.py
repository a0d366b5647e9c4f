"""Where every node is: one configuration, a motion, what a wanted motion asks of the drives, what can move at all.

Parts are imported when first used, so that asking what can move compiles no kernels.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics._check import check, notes
    from kinetruss.kinematics.given.arrays import from_arrays
    from kinetruss.kinematics.given.from_csv import from_csv
    from kinetruss.kinematics.given.measured import Smoothed, measured
    from kinetruss.kinematics.modes.assembly_modes import assembly_modes
    from kinetruss.kinematics.path.assemble import assemble
    from kinetruss.kinematics.path.follow import follow
    from kinetruss.kinematics.path.sample import Sampled, sample
    from kinetruss.kinematics.poses.chain import chain_lengths, chain_pose
    from kinetruss.kinematics.poses.gimbal import gimbal_lengths, gimbal_pose
    from kinetruss.kinematics.poses.joint import joint
    from kinetruss.kinematics.poses.platform import platform
    from kinetruss.kinematics.poses.pose import pose
    from kinetruss.kinematics.poses.workspace import workspace
    from kinetruss.kinematics.rates.conditioning import conditioning
    from kinetruss.kinematics.rates.first_order import first_order
    from kinetruss.kinematics.rates.freedoms import freedoms
    from kinetruss.kinematics.rates.jacobian import jacobian
    from kinetruss.kinematics.rates.member_rates import member_rates
    from kinetruss.kinematics.rates.platform_jacobian import platform_jacobian
    from kinetruss.kinematics.rates.transfer_functions import transfer_functions
    from kinetruss.kinematics.targets.inverse import inverse
    from kinetruss.kinematics.targets.reach import reach
    from kinetruss.mechanics.freedom import Mobility, mobility

__all__ = [
    "Mobility", "Sampled", "Smoothed", "assemble", "assembly_modes", "chain_lengths", "chain_pose", "check", "conditioning",
    "first_order", "follow", "freedoms", "from_arrays", "from_csv", "gimbal_lengths", "gimbal_pose", "inverse", "jacobian",
    "joint", "measured", "member_rates", "mobility", "notes", "platform", "platform_jacobian", "pose", "reach", "sample",
    "transfer_functions", "workspace",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "_check": "check notes",
        "rates.freedoms": "freedoms",
        "kinetruss.mechanics.freedom": "Mobility mobility",
        "given.arrays": "from_arrays",
        "given.from_csv": "from_csv",
        "given.measured": "Smoothed measured",
        "modes.assembly_modes": "assembly_modes",
        "path.assemble": "assemble",
        "path.follow": "follow",
        "path.sample": "Sampled sample",
        "poses.chain": "chain_lengths chain_pose",
        "poses.gimbal": "gimbal_lengths gimbal_pose",
        "poses.joint": "joint",
        "poses.platform": "platform",
        "poses.pose": "pose",
        "poses.workspace": "workspace",
        "rates.conditioning": "conditioning",
        "rates.first_order": "first_order",
        "rates.jacobian": "jacobian",
        "rates.member_rates": "member_rates",
        "rates.platform_jacobian": "platform_jacobian",
        "rates.transfer_functions": "transfer_functions",
        "targets.inverse": "inverse",
        "targets.reach": "reach",
    },
)
