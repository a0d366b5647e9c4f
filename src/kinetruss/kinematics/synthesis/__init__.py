"""Linkages for a task: four-bars and slider-cranks through given positions of a body, or along a path."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.synthesis.found import Linkage as Linkage, Linkages as Linkages
    from kinetruss.kinematics.synthesis.paths import along as along
    from kinetruss.kinematics.synthesis.positions import through as through

__getattr__, __dir__, __all__ = late(__name__)
