"""Lead screws, gears and motors: what the drives of active members must deliver, and what they do when they are fed."""

from kinetruss.actuators._evaluate import evaluate
from kinetruss.actuators._exceeded import Exceeded, exceeded
from kinetruss.actuators._motor import motor_demand
from kinetruss.actuators._moves import Move, moves
from kinetruss.actuators._place_poles import Gains, place_poles
from kinetruss.actuators._power_flow import power_flow
from kinetruss.actuators._screw import (
    breakaway_torque,
    gear_ratio_for,
    holding_torque,
    is_self_locking,
    largest_self_locking_lead,
    lowering_torque,
    raising_torque,
    screw_torque,
)  # fmt: skip
from kinetruss.actuators._simulate_drive import simulate_drive
from kinetruss.actuators._summarise import merge_summaries, summarise
from kinetruss.actuators._train_of import train_of

__all__ = [
    "Exceeded", "Gains", "Move", "breakaway_torque", "evaluate", "exceeded", "gear_ratio_for", "holding_torque",
    "is_self_locking", "largest_self_locking_lead", "lowering_torque", "merge_summaries", "motor_demand", "moves",
    "place_poles", "power_flow", "raising_torque", "screw_torque", "simulate_drive", "summarise", "train_of",
]  # fmt: skip
