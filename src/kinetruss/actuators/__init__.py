"""Lead screws, gears and motors: what drives must deliver, and how they move when a voltage or a current drives them."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.actuators.demand_summary import (
        Exceeded as Exceeded,
        exceeded as exceeded,
        merge_summaries as merge_summaries,
        summarise as summarise,
    )
    from kinetruss.actuators.demands import evaluate as evaluate, screw_couples as screw_couples
    from kinetruss.actuators.drive_model import Gains as Gains, place_poles as place_poles
    from kinetruss.actuators.drive_runs import simulate_drive as simulate_drive
    from kinetruss.actuators.energies import Move as Move, moves as moves, power_flow as power_flow
    from kinetruss.actuators.screws import (
        breakaway_torque as breakaway_torque,
        gear_ratio_for as gear_ratio_for,
        holding_torque as holding_torque,
        is_self_locking as is_self_locking,
        largest_self_locking_lead as largest_self_locking_lead,
        lowering_torque as lowering_torque,
        raising_torque as raising_torque,
        screw_torque as screw_torque,
    )
    from kinetruss.actuators.shafts import motor_demand as motor_demand, train_of as train_of

__getattr__, __dir__, __all__ = late(__name__)
