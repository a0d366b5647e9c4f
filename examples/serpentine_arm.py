"""A wave runs down a hanging arm of twelve bays: where its tip goes, and which bay has the hardest work."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["serpentine_arm"][0])
run = model.runs["wave"]
motion = kt.kinematics.follow(model, run.trajectory, samples=run.samples)
tip = motion.position.sel(node=["B12.N7", "B12.N8", "B12.N9"]).mean("node").values
print(f"camera {-tip[0, 2]:.3f} m below the base; it swings from y = {tip[:, 1].min():.3f} to {tip[:, 1].max():.3f} m")

# Every bay tilts about one axis only, so the tilts add up to that of the tip; those of a whole wave add up to nothing.
tilts = np.array(list(run.trajectory.values.values()))
top = kt.kinematics.platform(model, motion, ("B12.N7", "B12.N9", "B12.N8"), base=("B1.N1", "B1.N2", "B1.N3"))
print(f"bays tilt by up to {np.degrees(tilts.max()):.2f} degrees, the camera by {np.degrees(abs(top.beta.values).max()):.4f}")
assert np.allclose(top.beta.values[::2], tilts.sum(axis=0), atol=1e-9)
assert abs(tip[:, 0]).max() < 1e-9

forces = kt.dynamics.inverse(model, motion)
worst = kt.strength.check(model, forces).table()[0]
demand = kt.actuators.evaluate(model, motion, forces)
drawn = {bay: sum(demand.drawn_energy.sel(active=f"{bay}.{leg}").item() for leg in ("M7", "M9", "M11")) for bay in model.poses}
bay = max(drawn, key=lambda name: drawn[name])
print(f"{worst.part} governs: {100 * worst.utilisation:.1f} % of {worst.rule}; {bay} draws most, {drawn[bay]:.1f} J")
assert worst.utilisation < 1
assert not kt.actuators.exceeded(demand)
