"""A bay driven by a recorded table of lengths: a quintic spline through the record, forces with and without the load."""

from pathlib import Path

import numpy as np

import kinetruss as kt

folder = Path(kt.library.__file__).parent / "examples"
table = np.loadtxt(folder / "measured_slew.csv", delimiter=",", skiprows=1)
record = kt.Spline(times=tuple(table[:, 0]), values={name: tuple(table[:, k]) for k, name in enumerate(("M7", "M9", "M11"), 1)})

model = kt.library.vgt.double_octahedral(gravity=(0, 0, 9.81), tip_force=(0, 0, 46))
motion = kt.kinematics.follow(model, record, samples=219)
beta, gamma, height = kt.kinematics.gimbal_pose(1.2192, 0.889, motion.length.sel(member=["M7", "M9", "M11"]).values)
print(f"recorded tilt from {np.degrees(beta[0]):.2f} to {np.degrees(beta[-1]):.2f} degrees, {len(table)} rows")

for name, each in (("with 46 N", model), ("without", model.with_(loads={}))):
    forces = kt.dynamics.inverse(each, motion)
    print(f"{name:10s} M6 up to {forces.member_force.sel(member='M6').max().item():.2f} N")

assert abs(np.degrees(beta[0]) + 9) < 0.01
assert abs(np.degrees(beta[-1]) - 9) < 0.01
assert np.abs(height - height.mean()).max() < 1e-5  # a slew at constant height, but for the rounding of the record
