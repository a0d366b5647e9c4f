"""A planar crane leads its load along a vertical line: the lengths of two active chords, and what they must bear."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["planar_crane"][0])
run = model.runs["lift"]
lift = kt.kinematics.inverse(model, run.targets, samples=run.samples)
for name, lengths in zip(lift.drive_position.drive.values, lift.drive_position.values.T, strict=True):
    print(f"{name}: {lengths[0]:.4f} m at the start, {lengths[40]:.4f} m halfway, {lengths[-1]:.4f} m at the end")
load = lift.position.sel(node="B8.N3").values
assert np.ptp(load[:, 0]) < 1e-9  # a vertical line
assert abs(np.ptp(load[:, 1]) - 2) < 1e-5

forces = kt.dynamics.inverse(model, lift)
worst = kt.strength.check(model, forces).table()[0]
demand = kt.actuators.evaluate(model, lift, forces)
print(f"{worst.part} governs: {100 * worst.utilisation:.1f} % of {worst.rule} at {worst.time:.0f} s")
print(f"pull of B1.longeron1 up to {-forces.drive_force.sel(drive='B1.longeron1').min().item() / 1e3:.2f} kN")
assert worst.utilisation < 1
assert not kt.actuators.exceeded(demand)
assert demand.self_locking.all()  # the load stays where it is without current
