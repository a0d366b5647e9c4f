"""Joints between bodies in one call: nodes that the bodies share, and bars if shared nodes are not enough."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.library.joints.driven import drive as drive, screw as screw
    from kinetruss.library.joints.joining import JointWarning as JointWarning, conditioning as conditioning
    from kinetruss.library.joints.shared import (
        pin as pin,
        revolute as revolute,
        spherical as spherical,
        universal as universal,
        weld as weld,
    )
    from kinetruss.library.joints.sliding import (
        cylindrical as cylindrical,
        parallelogram as parallelogram,
        planar as planar,
        prismatic as prismatic,
    )

__getattr__, __dir__, __all__ = late(__name__)
