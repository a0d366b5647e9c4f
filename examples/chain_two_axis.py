"""Three bays on each other tilt by 10 degrees about both axes: the top leans by more than one would add up."""

import math

import numpy as np

import kinetruss as kt

TILT = math.radians(10)

model = kt.library.vgt.double_octahedral(3, payload_mass=2.0)
trajectory = kt.library.vgt.slew(3, beta=(0, TILT), gamma=(0, TILT), duration=3)
motion = kt.kinematics.follow(model, trajectory, samples=301)
forces = kt.dynamics.inverse(model, motion)

top = motion.position.sel(node=["B3.N7", "B3.N9", "B3.N8"]).isel(time=-1).values
normal = np.cross(top[1] - top[0], top[2] - top[0])
normal /= np.linalg.norm(normal)
beta, gamma = math.degrees(math.atan2(-normal[1], normal[2])), -math.degrees(math.asin(normal[0]))
print(f"the top leans by beta = {beta:.4f} and gamma = {gamma:.4f} degrees, in all {math.degrees(math.acos(normal[2])):.3f}")

worst = abs(forces.member_force).max("time")
for name in worst.member.values[np.argsort(-worst.values)][:5]:
    print(f"{name:7s} up to {worst.sel(member=name).item():8.2f} N")

# three turns about one axis: not 30 and 30 degrees
assert abs(beta - 32.5737) < 1e-4
assert abs(gamma - 28.6650) < 1e-4
assert abs(forces.end_force.sel(time=1.5, member="B1.M11", end="B").item() - 242.3970567) < 1e-6
