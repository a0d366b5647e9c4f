"""Where every node is: one configuration, a motion, what a wanted motion asks of the drives, what can move at all.

Parts are imported when first used, so that asking what can move compiles no kernels.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics import synthesis as synthesis
    from kinetruss.kinematics.assembly import assembly_modes as assembly_modes
    from kinetruss.kinematics.checking import check as check, notes as notes
    from kinetruss.kinematics.chosen_freedoms import conditioning as conditioning, freedoms as freedoms
    from kinetruss.kinematics.gimbal_poses import (
        chain_lengths as chain_lengths,
        chain_pose as chain_pose,
        gimbal_lengths as gimbal_lengths,
        gimbal_pose as gimbal_pose,
    )
    from kinetruss.kinematics.given_motions import from_arrays as from_arrays, from_csv as from_csv
    from kinetruss.kinematics.inverse_motion import inverse as inverse, reach as reach
    from kinetruss.kinematics.jacobians import jacobian as jacobian, transfer_functions as transfer_functions
    from kinetruss.kinematics.joint_motion import joint as joint
    from kinetruss.kinematics.measured_motions import Smoothed as Smoothed, measured as measured
    from kinetruss.kinematics.motions import follow as follow
    from kinetruss.kinematics.platforms import platform as platform, platform_jacobian as platform_jacobian
    from kinetruss.kinematics.poses import pose as pose
    from kinetruss.kinematics.positions import assemble as assemble
    from kinetruss.kinematics.quantity_histories import quantities as quantities
    from kinetruss.kinematics.rates import first_order as first_order, member_rates as member_rates
    from kinetruss.kinematics.sampling import Sampled as Sampled, sample as sample
    from kinetruss.kinematics.workspaces import workspace as workspace
    from kinetruss.mechanics.mobility import Mobility as Mobility, mobility as mobility

__getattr__, __dir__, __all__ = late(__name__)
