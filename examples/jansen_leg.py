"""A leg of Theo Jansen: how far and how level its foot goes, and the torque of the crank."""

import numpy as np

import kinetruss as kt

run = kt.run(kt.read(kt.library.example_files()["jansen_leg"][0]))
found = run.quantities["all"]
x, y = (found.value.sel(quantity=name).values for name in ("foot_x", "foot_y"))
down = y < y.min() + 0.01
torque = run.forces["all"].drive_force.sel(drive="motor")
way, share = np.ptp(x[down]), down.mean()
print(f"the foot goes {way:.3f} m within 10 mm of the ground in {share:.0%} of a turn, and rises {np.ptp(y):.3f} m")
print(f"its speed there is {np.abs(found.rate.sel(quantity='foot_x').values[down]).mean():.2f} m/s on average")
print(f"the crank needs up to {np.abs(torque).max().item():.2f} N m")
assert np.ptp(x[down]) > 0.5

# after one turn everything is where it began, and gravity has done no work
assert np.allclose(run.motion.position[0], run.motion.position[-1], atol=1e-10)
assert abs(2 * np.pi * torque[:-1].mean().item()) < 1e-6
