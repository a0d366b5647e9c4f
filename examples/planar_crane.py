"""A planar crane leads its load along a vertical line: the lengths of two active chords, and what they must bear."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["planar_crane"][0])
x, y = model.nodes["B8.N3"].at
line = kt.Quintic(moves={"B8.N3.x": (x, x), "B8.N3.y": (y, y + 2.0)}, duration=40.0)
lift = kt.kinematics.inverse(model, line, samples=41)
table = model.runs["lift"].trajectory.values
for name, lengths in zip(lift.drive_position.drive.values, lift.drive_position.values.T, strict=True):
    print(f"{name}: {lengths[0]:.4f} m at the start, {lengths[20]:.4f} m halfway, {lengths[-1]:.4f} m at the end")
    assert np.allclose(lengths, table[name], atol=1e-6)  # planar_crane.csv

forces = kt.dynamics.inverse(model, lift)
worst = kt.strength.check(model, forces).table()[0]
demand = kt.actuators.evaluate(model, lift, forces)
print(f"{worst.part} governs: {100 * worst.utilisation:.1f} % of {worst.rule} at {worst.time:.0f} s")
print(f"pull of B1.longeron1 up to {-forces.drive_force.sel(drive='B1.longeron1').min().item() / 1e3:.2f} kN")
assert worst.utilisation < 1
assert not kt.actuators.exceeded(demand)
assert demand.self_locking.all()  # the load stays where it is without current
