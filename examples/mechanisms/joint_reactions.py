"""A compound pendulum as a body: angle and reaction at its hinge from the nodes, whatever bars carry the mass."""

import numpy as np

import kinetruss as kt

mass, far, inertia = 2.0, 0.3, 0.05
model = kt.Model(
    nodes={"O": (0, 0), "A": (0.3, 0), "B": (0.15, 0.1)}, fixed=["O"], gravity=(0, -9.81),
    bodies={"pendulum": kt.Body(nodes=("O", "A", "B"), mass=mass, center=(far, 0.0), inertia=inertia)},
)  # fmt: skip
run = kt.dynamics.simulate(model, 1.0, samples=101, method=kt.DOP853(rtol=1e-11, atol=1e-12))
pose = kt.kinematics.pose(model, run.motion, "pendulum")
force = kt.dynamics.joint_reaction(model, run, "pendulum", ["O"]).force.values

# released level: rate and acceleration from the energy; the centre's acceleration gives the reaction
angle = pose.angle.values - pose.angle.values[0]
whole = inertia + mass * far**2
rate2 = -2 * mass * 9.81 * far * np.sin(angle) / whole
second = -mass * 9.81 * far * np.cos(angle) / whole
along = np.stack([np.cos(angle), np.sin(angle)], axis=1)
across = np.stack([-np.sin(angle), np.cos(angle)], axis=1)
wanted = mass * (far * (second[:, None] * across - rate2[:, None] * along) + [0, 9.81])
error = np.abs(force - wanted).max()
print(f"largest reaction {np.linalg.norm(force, axis=1).max():.2f} N, off by {error:.1e} N")
assert error < 1e-7
