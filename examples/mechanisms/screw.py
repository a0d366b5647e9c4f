"""A screw pair: bars make its cylindrical joint, a coupling its thread. It falls slower than it would without."""

import math

import numpy as np

import kinetruss as kt

PITCH = 0.3
body = kt.library.bodies.cylinder(
    kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"], gravity=(0, 0, -9.81)), "nut", 0.2, 0.1, mass=4.0
)
turned = kt.library.bodies.properties_of(body, "nut").inertia[2][2]
model = kt.library.joints.screw(body, "thread", bodies=("ground", "nut"), at=(0, 0, 0), axis="z", pitch=PITCH)
assert kt.kinematics.mobility(model).degrees_of_freedom == 1

run = kt.dynamics.simulate(model, 0.2, samples=21)
pose = kt.kinematics.pose(model, run.motion, "nut")
fallen = pose.position.sel(axis="z").values - float(pose.position.sel(axis="z")[0])
t = run.motion.data.time.values
slowed = 9.81 * 4.0 / (4.0 + turned * (2 * math.pi / PITCH) ** 2)
error = np.abs(fallen + slowed * t**2 / 2).max()
print(f"falls with {slowed:.3f} m/s^2, off by {error:.1e} m")
assert error < 1e-8
