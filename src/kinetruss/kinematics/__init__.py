"""Where every node is: one configuration, a motion, what a wanted motion asks of the drives, what can move at all.

Parts are imported when first used, so that asking what can move compiles no kernels.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.kinematics._assemble import assemble
    from kinetruss.kinematics._assembly_modes import assembly_modes
    from kinetruss.kinematics._check import check, notes
    from kinetruss.kinematics._conditioning import conditioning
    from kinetruss.kinematics._first_order import first_order
    from kinetruss.kinematics._follow import follow
    from kinetruss.kinematics._freedoms import freedoms
    from kinetruss.kinematics._from_csv import from_csv
    from kinetruss.kinematics._gimbal import gimbal_lengths, gimbal_pose
    from kinetruss.kinematics._given import from_arrays
    from kinetruss.kinematics._inverse import inverse
    from kinetruss.kinematics._jacobian import jacobian
    from kinetruss.kinematics._joint import joint
    from kinetruss.kinematics._member_rates import member_rates
    from kinetruss.kinematics._mobility import Mobility, mobility
    from kinetruss.kinematics._platform import platform
    from kinetruss.kinematics._platform_jacobian import platform_jacobian
    from kinetruss.kinematics._pose import pose
    from kinetruss.kinematics._sample import Sampled, sample
    from kinetruss.kinematics._transfer_functions import transfer_functions
    from kinetruss.kinematics._workspace import workspace

__all__ = [
    "Mobility", "Sampled", "assemble", "assembly_modes", "check", "conditioning", "first_order", "follow", "freedoms",
    "from_arrays", "from_csv", "gimbal_lengths", "gimbal_pose", "inverse", "jacobian", "joint", "member_rates", "mobility",
    "notes", "platform", "platform_jacobian", "pose", "sample", "transfer_functions", "workspace",
]  # fmt: skip

_HOME = {
    "Mobility": "_mobility", "Sampled": "_sample", "assemble": "_assemble", "assembly_modes": "_assembly_modes",
    "check": "_check", "conditioning": "_conditioning", "first_order": "_first_order", "follow": "_follow",
    "freedoms": "_freedoms", "from_arrays": "_given", "from_csv": "_from_csv", "gimbal_lengths": "_gimbal",
    "gimbal_pose": "_gimbal", "inverse": "_inverse", "jacobian": "_jacobian", "joint": "_joint",
    "member_rates": "_member_rates", "mobility": "_mobility", "notes": "_check", "platform": "_platform",
    "platform_jacobian": "_platform_jacobian", "pose": "_pose", "sample": "_sample",
    "transfer_functions": "_transfer_functions", "workspace": "_workspace",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.kinematics.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.kinematics' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
