"""A windscreen wiper: angle that the blades sweep, torque of the motor, and the force in the link by hand."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["wiper"][0])
motion = kt.kinematics.follow(model, model.runs["wipe"].trajectory, samples=241)
forces = kt.dynamics.inverse(model, motion)

arm = motion.position.sel(node="T") - motion.position.sel(node="L")
angle = np.degrees(np.unwrap(np.arctan2(arm.sel(axis="y"), arm.sel(axis="x"))))
torque = forces.drive_force.sel(drive="motor")
print(f"the blades sweep {np.ptp(angle):.1f} degrees; the motor gives {np.abs(torque).max().item():.3f} N m")
assert 80 < np.ptp(angle) < 100

# both wipers move alike, and after one turn everything is where it began
assert np.allclose(arm, motion.position.sel(node="U") - motion.position.sel(node="R"), atol=1e-12)
assert abs(2 * np.pi * torque[:-1].mean().item()) < 1e-6
assert np.allclose(forces.power, forces.energy_rate, atol=1e-10)
