"""Mechanisms: pendulums, linkages in the plane and in space, straight lines, robots; small structures with springs."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.library.mechanisms.linkages import (
        four_bar as four_bar,
        n_four_bar as n_four_bar,
        slider_crank as slider_crank,
        spatial_slider_crank as spatial_slider_crank,
        stephenson_six_bar as stephenson_six_bar,
        watt_six_bar as watt_six_bar,
    )
    from kinetruss.library.mechanisms.loops import (
        bennett as bennett,
        bricard as bricard,
        sarrus as sarrus,
        spherical_four_bar as spherical_four_bar,
    )
    from kinetruss.library.mechanisms.platforms import delta as delta, stewart as stewart
    from kinetruss.library.mechanisms.robot_of_bars import robot as robot
    from kinetruss.library.mechanisms.squeezer import ANDREWS_TORQUE as ANDREWS_TORQUE, andrews as andrews
    from kinetruss.library.mechanisms.straight_lines import (
        chebyshev as chebyshev,
        hart as hart,
        peaucellier as peaucellier,
        roberts as roberts,
        watt_line as watt_line,
    )
    from kinetruss.library.mechanisms.swinging import (
        double_pendulum as double_pendulum,
        n_pendulum as n_pendulum,
        pendulum as pendulum,
        rhombus_with_spring as rhombus_with_spring,
        von_mises as von_mises,
    )

__getattr__, __dir__, __all__ = late(__name__)
