"""A crane on the Moon: how far its hook hangs too low, and drive lengths corrected for it."""

import numpy as np

import kinetruss as kt

HOOK = "B5.N8"
model = kt.read(kt.library.example_files()["space_crane"][0])
run = model.runs["lift"]
motion = kt.kinematics.inverse(model, run.targets, samples=run.samples)
forces = kt.statics.at_poses(model, motion.position.values[[0, 30, 60]])  # start, halfway, end: at rest
before = kt.statics.deflection(model, forces).displacement.sel(node=HOOK).values
found = kt.flexible.corrected(model, forces, at=HOOK)
after = found.displacement.sel(node=HOOK).values
for k, word in enumerate(("start", "halfway", "end")):
    drive = str(found.drive.values[np.argmax(abs(found.change.values[k]))])
    change = 1e3 * found.change.sel(drive=drive).values[k]
    print(f"{word}: the hook hangs {-1e3 * before[k, 2]:.3f} mm low and {1e3 * before[k, 1]:.3f} mm out;", end=" ")
    print(f"with {drive} changed by {change:.3f} mm and the others by less: {1e3 * np.linalg.norm(after[k]):.1e} mm")

worst = kt.strength.check(model, forces).table()[0]
demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
print(f"{worst.part} governs: {100 * worst.utilisation:.1f} % of {worst.rule}")
print(f"frequencies: {kt.flexible.frequencies(model, forces, modes=3).frequency.values[0].round(2)} Hz")
least, most = model.active["B1.M7"].limits
assert least < found.drive_length.min() < found.drive_length.max() < most
assert np.linalg.norm(after, axis=1).max() < 1e-12
assert np.linalg.norm(before, axis=1).min() > 0.01
assert worst.utilisation < 1
assert not kt.actuators.exceeded(demand)
assert demand.self_locking.all()  # the load stays where it is without current
