"""Mechanisms: pendulums, linkages in the plane and in space, straight lines, robots; small structures with springs."""

from kinetruss.late import listed
from kinetruss.library.mechanisms.andrews import ANDREWS_TORQUE, andrews
from kinetruss.library.mechanisms.delta import delta
from kinetruss.library.mechanisms.linkages import four_bar, n_four_bar, slider_crank, spatial_slider_crank
from kinetruss.library.mechanisms.loops import bennett, bricard, spherical_four_bar
from kinetruss.library.mechanisms.pendulums import double_pendulum, n_pendulum, pendulum
from kinetruss.library.mechanisms.robot import robot
from kinetruss.library.mechanisms.sarrus import SARRUS_BARS as SARRUS_BARS
from kinetruss.library.mechanisms.sarrus import sarrus
from kinetruss.library.mechanisms.sarrus import sarrus_places as sarrus_places
from kinetruss.library.mechanisms.six_bars import stephenson_six_bar, watt_six_bar
from kinetruss.library.mechanisms.springs import rhombus_with_spring, von_mises
from kinetruss.library.mechanisms.stewart import stewart
from kinetruss.library.mechanisms.straight_lines import chebyshev, hart, peaucellier, roberts, watt_line

__all__ = [
    "ANDREWS_TORQUE",
    "andrews",
    "bennett",
    "bricard",
    "chebyshev",
    "delta",
    "double_pendulum",
    "four_bar",
    "hart",
    "n_four_bar",
    "n_pendulum",
    "peaucellier",
    "pendulum",
    "rhombus_with_spring",
    "roberts",
    "robot",
    "sarrus",
    "slider_crank",
    "spatial_slider_crank",
    "spherical_four_bar",
    "stephenson_six_bar",
    "stewart",
    "von_mises",
    "watt_line",
    "watt_six_bar",
]

__dir__ = listed(__name__)
