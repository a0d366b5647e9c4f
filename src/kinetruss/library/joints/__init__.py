"""Joints between bodies in one call: nodes that the bodies share, and bars if shared nodes are not enough."""

from kinetruss.late import listed
from kinetruss.library.joints.chains import cylindrical, planar, prismatic
from kinetruss.library.joints.drives import drive, screw
from kinetruss.library.joints.joining import JointWarning, conditioning
from kinetruss.library.joints.shared import pin, revolute, spherical, universal, weld
from kinetruss.library.joints.slides import parallelogram

__all__ = [
    "JointWarning",
    "conditioning",
    "cylindrical",
    "drive",
    "parallelogram",
    "pin",
    "planar",
    "prismatic",
    "revolute",
    "screw",
    "spherical",
    "universal",
    "weld",
]

__dir__ = listed(__name__)
