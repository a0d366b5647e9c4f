"""Where every node is: one configuration, a motion, what a wanted motion asks of the drives, what can move at all.

Parts are imported when first used, so that asking what can move compiles no kernels.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.kinematics._check import check, notes
    from kinetruss.kinematics.freedom.freedoms import freedoms
    from kinetruss.kinematics.freedom.mobility import Mobility, mobility
    from kinetruss.kinematics.given.arrays import from_arrays
    from kinetruss.kinematics.given.from_csv import from_csv
    from kinetruss.kinematics.modes.assembly_modes import assembly_modes
    from kinetruss.kinematics.path.assemble import assemble
    from kinetruss.kinematics.path.follow import follow
    from kinetruss.kinematics.path.sample import Sampled, sample
    from kinetruss.kinematics.poses.gimbal import gimbal_lengths, gimbal_pose
    from kinetruss.kinematics.poses.joint import joint
    from kinetruss.kinematics.poses.platform import platform
    from kinetruss.kinematics.poses.pose import pose
    from kinetruss.kinematics.poses.workspace import workspace
    from kinetruss.kinematics.rates.conditioning import conditioning
    from kinetruss.kinematics.rates.first_order import first_order
    from kinetruss.kinematics.rates.jacobian import jacobian
    from kinetruss.kinematics.rates.member_rates import member_rates
    from kinetruss.kinematics.rates.platform_jacobian import platform_jacobian
    from kinetruss.kinematics.rates.transfer_functions import transfer_functions
    from kinetruss.kinematics.targets.inverse import inverse

__all__ = [
    "Mobility", "Sampled", "assemble", "assembly_modes", "check", "conditioning", "first_order", "follow", "freedoms",
    "from_arrays", "from_csv", "gimbal_lengths", "gimbal_pose", "inverse", "jacobian", "joint", "member_rates", "mobility",
    "notes", "platform", "platform_jacobian", "pose", "sample", "transfer_functions", "workspace",
]  # fmt: skip

_HOME = {
    "Mobility": "freedom.mobility", "Sampled": "path.sample", "assemble": "path.assemble", "assembly_modes": "modes.assembly_modes",
    "check": "_check", "conditioning": "rates.conditioning", "first_order": "rates.first_order", "follow": "path.follow",
    "freedoms": "freedom.freedoms", "from_arrays": "given.arrays", "from_csv": "given.from_csv", "gimbal_lengths": "poses.gimbal",
    "gimbal_pose": "poses.gimbal", "inverse": "targets.inverse", "jacobian": "rates.jacobian", "joint": "poses.joint",
    "member_rates": "rates.member_rates", "mobility": "freedom.mobility", "notes": "_check", "platform": "poses.platform",
    "platform_jacobian": "rates.platform_jacobian", "pose": "poses.pose", "sample": "path.sample",
    "transfer_functions": "rates.transfer_functions", "workspace": "poses.workspace",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.kinematics.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.kinematics' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
