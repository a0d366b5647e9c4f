"""Lead screws, gears and motors: what the drives of active members must deliver."""

from kinetruss.actuators._evaluate import evaluate, summarise
from kinetruss.actuators._motor import motor_demand
from kinetruss.actuators._screw import (
    gear_ratio_for,
    is_self_locking,
    largest_self_locking_lead,
    lowering_torque,
    raising_torque,
    screw_torque,
)  # fmt: skip

__all__ = [
    "evaluate", "gear_ratio_for", "is_self_locking", "largest_self_locking_lead", "lowering_torque", "motor_demand",
    "raising_torque", "screw_torque", "summarise",
]  # fmt: skip
