"""A Delta robot along a path in one call: what its arms turn by and with, against virtual work in the place of its platform."""

import numpy as np

import kinetruss as kt

P, V, A = np.array([0.05, -0.08, -0.75]), np.array([1.2, -0.7, 0.5]), np.array([8.0, -5.0, 12.0])
t = np.linspace(0.0, 0.04, 41)
places = (P + np.outer(t - 0.02, V) + np.outer((t - 0.02) ** 2 / 2, A) - (0.0, 0.0, 0.05)).T  # of Q below the middle
targets = kt.Spline(times=tuple(t), values={f"Q.{axis}": tuple(row) for axis, row in zip("xyz", places, strict=True)})

model = kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7))
forces = kt.dynamics.inverse_along(model, targets, samples=41)
angles = forces.motion.drive_position.values[20]
torques, still = forces.drive_force.values[20], forces.static.drive_force.values[20]
print("angles below the horizontal:", angles.round(6), "rad")
print("torques:", torques.round(6), "N m; at rest there:", still.round(6), "N m")

assert np.allclose(angles, [0.2032907176392995, 0.44966326347074936, 0.21341826311254275], rtol=0, atol=1e-12)
assert np.allclose(torques, [-7.024949349790452, -0.35332027885705214, -4.538558518535321], rtol=0, atol=1e-9)
assert np.allclose(still, [-2.431500212975645, -1.7843495613724354, -2.4074807777433316], rtol=0, atol=1e-9)
