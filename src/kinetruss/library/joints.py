"""Joints between bodies in one call: nodes that the bodies share, and bars where sharing is not enough."""

from kinetruss.library._joining import JointWarning, conditioning
from kinetruss.library._joint_chains import cylindrical, planar, prismatic
from kinetruss.library._joint_drives import drive, screw
from kinetruss.library._joint_shared import pin, revolute, spherical, universal, weld
from kinetruss.library._joint_slides import parallelogram

__all__ = [
    "JointWarning", "conditioning", "cylindrical", "drive", "parallelogram", "pin", "planar", "prismatic", "revolute", "screw",
    "spherical", "universal", "weld",
]  # fmt: skip
