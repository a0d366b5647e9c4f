"""Lead screws, gears, motors and amplifiers of Lacy (1991) as ready records, by constant and by name."""

from __future__ import annotations

import math

from kinetruss.late import listed
from kinetruss.model import Amplifier, DriveTrain, Gear, LeadScrew, Motor

__all__ = [
    "AMPLIFIERS",
    "AMPLIFIER_LACY_SLEWING",
    "GEARS",
    "GEAR_LACY",
    "GEAR_LACY_SLEWING",
    "MOTORS",
    "MOTOR_LACY",
    "MOTOR_LACY_SLEWING",
    "SCREWS",
    "SCREW_LACY_PLANAR",
    "SCREW_LACY_SLEWING",
    "SCREW_LACY_SPATIAL",
    "TRAIN_LACY",
    "TRAIN_LACY_SLEWING",
]

__dir__ = listed(__name__)

INCH = 0.0254

SCREW_LACY_SPATIAL = LeadScrew(lead=INCH / 16 / (2 * math.pi), mean_diameter=0.0127, friction=0.1)
"""Double-octahedral bay: 1/16 in a turn (2.5266e-4 m/rad; table 5.1 prints 2.527e-6), mean diameter 12.7 mm."""

SCREW_LACY_PLANAR = LeadScrew(lead=0.003, mean_diameter=0.02, friction=0.3)
"""Triangular truss, section 3.7: 3 mm/rad, mean diameter 20 mm. Lead = friction x radius: just self-locking."""

SCREW_LACY_SLEWING = LeadScrew(lead=0.0159 * INCH, mean_diameter=0.0127, friction=0.1)
"""Slewing programme, appendix: 0.0159 in/rad; diameter and friction of the bay."""

GEAR_LACY = Gear(ratio=5.2)
"""Double-octahedral bay, table 5.1."""

GEAR_LACY_SLEWING = Gear(ratio=5.1)
"""Slewing programme, appendix: reduction 1/5.1."""

MOTOR_LACY = Motor(
    inertia=6.76e-6,
    resistance=2.0,
    torque_constant=0.0398,
    emf_constant=0.0398,
    max_voltage=25.0,
    source="Lacy (1991), tables 3.1 and 5.1; largest input 25 V",
)

MOTOR_LACY_SLEWING = Motor(  # type: ignore[call-arg]  # the resistance follows from the time constant
    inertia=1.22e-4,
    time_constant=0.0164,
    torque_constant=0.1,
    emf_constant=0.1,
    friction_torque=0.6,
    max_current=1.8 * 5.0,
    max_speed=400.0,
    source="Lacy (1991), slewing programme: 0.1 N m/A, 1.22e-4 kg m^2, friction 0.6 N m, 400 rad/s, amplifier 1.8 A/V at 5 V; "
    "resistance R = time constant Kt Kb/J from 0.0164 s with Kb = Kt",
)

AMPLIFIER_LACY_SLEWING = Amplifier(current_gain=1.8, max_input=5.0, source="Lacy (1991), slewing programme: 1.8 A/V, 5 V")

TRAIN_LACY = DriveTrain(screw=SCREW_LACY_SPATIAL, gear=GEAR_LACY, motor=MOTOR_LACY)
"""Double-octahedral bay, tables 3.1 and 5.1: a voltage of up to 25 V at the motor."""

TRAIN_LACY_SLEWING = DriveTrain(
    screw=SCREW_LACY_SLEWING, gear=GEAR_LACY_SLEWING, motor=MOTOR_LACY_SLEWING, amplifier=AMPLIFIER_LACY_SLEWING
)
"""The real drive of the slewing programme: amplifier, motor, gear and screw."""

SCREWS: dict[str, LeadScrew] = {
    "screw_lacy_planar": SCREW_LACY_PLANAR,
    "screw_lacy_slewing": SCREW_LACY_SLEWING,
    "screw_lacy_spatial": SCREW_LACY_SPATIAL,
}
GEARS: dict[str, Gear] = {"gear_lacy": GEAR_LACY, "gear_lacy_slewing": GEAR_LACY_SLEWING}
MOTORS: dict[str, Motor] = {"motor_lacy": MOTOR_LACY, "motor_lacy_slewing": MOTOR_LACY_SLEWING}
AMPLIFIERS: dict[str, Amplifier] = {"amplifier_lacy_slewing": AMPLIFIER_LACY_SLEWING}
