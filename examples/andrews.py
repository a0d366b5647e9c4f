"""Andrews' squeezing mechanism: seven bodies in three loops, let go under a constant torque, against values of 28 digits."""

import kinetruss as kt
from kinetruss.library import mechanisms

model = mechanisms.andrews()
torque = {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
run = kt.dynamics.simulate(model, 0.03, samples=301, tasks=torque)

turns = (run.motion.drive_position[-1] - run.motion.drive_position[0]).item()
print(f"the crank turns by {turns:.6f} rad in 0.03 s, in {run.steps.values[-1]:.0f} steps")
print(f"its bearing carries up to {abs(run.forces.member_force.sel(member='OF')).max().item():.1f} N")

# E. Hairer & G. Wanner, Solving ODEs II, VII.7, by quadrature of the energy with 28 digits
crank_angle = 15.8107711951537070971
assert abs(run.motion.drive_position.values[-1, 0] - crank_angle) < 1e-6
work = mechanisms.ANDREWS_TORQUE * (run.motion.drive_position.values[:, 0] - run.motion.drive_position.values[0, 0])
assert abs(run.energy.values - run.energy.values[0] - work).max() < 1e-8
