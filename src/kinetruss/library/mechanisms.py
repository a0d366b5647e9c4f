"""Mechanisms: pendulums, linkages, Andrews' mechanism; small structures with springs."""

from kinetruss.library._andrews import ANDREWS_TORQUE, andrews
from kinetruss.library._linkages import four_bar, n_four_bar, slider_crank, spatial_slider_crank
from kinetruss.library._pendulums import double_pendulum, n_pendulum, pendulum
from kinetruss.library._springs import rhombus_with_spring, von_mises

__all__ = [
    "ANDREWS_TORQUE", "andrews", "double_pendulum", "four_bar", "n_four_bar", "n_pendulum", "pendulum", "rhombus_with_spring",
    "slider_crank", "spatial_slider_crank", "von_mises",
]  # fmt: skip
