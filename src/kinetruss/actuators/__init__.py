"""Lead screws, gears and motors: what drives must deliver, and how they move when a voltage or a current drives them."""

from kinetruss.actuators.demand.couples import screw_couples
from kinetruss.actuators.demand.evaluate import evaluate
from kinetruss.actuators.demand.exceeded import Exceeded, exceeded
from kinetruss.actuators.demand.moves import Move, moves
from kinetruss.actuators.demand.power_flow import power_flow
from kinetruss.actuators.demand.summarise import merge_summaries, summarise
from kinetruss.actuators.forward.place_poles import Gains, place_poles
from kinetruss.actuators.forward.simulate_drive import simulate_drive
from kinetruss.actuators.trains.motor import motor_demand
from kinetruss.actuators.trains.screw import (
    breakaway_torque,
    gear_ratio_for,
    holding_torque,
    is_self_locking,
    largest_self_locking_lead,
    lowering_torque,
    raising_torque,
    screw_torque,
)
from kinetruss.actuators.trains.train_of import train_of
from kinetruss.late import listed

__all__ = [
    "Exceeded", "Gains", "Move", "breakaway_torque", "evaluate", "exceeded", "gear_ratio_for", "holding_torque",
    "is_self_locking", "largest_self_locking_lead", "lowering_torque", "merge_summaries", "motor_demand", "moves",
    "place_poles", "power_flow", "raising_torque", "screw_couples", "screw_torque", "simulate_drive", "summarise", "train_of",
]  # fmt: skip

__dir__ = listed(__name__)
