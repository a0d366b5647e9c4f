"""A loader crane: pressure in both cylinders along the motion, and that of the boom cylinder at full reach by hand."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["loader_crane"][0])
run = kt.run(model)
found = run.quantities["all"].value
for at in (0, 25, 50, 75, 100):
    reach, height, lift, fold = (
        found.sel(quantity=name).values[at] for name in ("reach", "height", "lift_pressure", "fold_pressure")
    )
    print(f"hook at {reach:.2f} m, {height:.2f} m high: boom cylinder {lift:3.0f} bar, jib cylinder {fold:3.0f} bar")
print(run.finding.sentence)

# moments about the foot of the boom; the line of the cylinder goes from (0.4, 0.6) to (0.9, 2), the foot is at (0, 2)
arm = (0.4 * 1.4 + 1.4 * 0.5) / np.hypot(0.5, 1.4)
moment = 9.81 * (1000 * 6 + 70 * 4.5 + 120 * 1.5 + 40 * 2.5 + 50 * 0.45)
area = np.pi / 4 * 0.08**2
assert np.isclose(found.sel(quantity="lift_pressure").values[0], moment / arm / area / 1e5, rtol=1e-4)
drives = run.forces["all"].drive_force
for drive in ("lift", "fold"):  # the crane is slow: inertia adds little
    assert np.allclose(drives.sel(drive=drive), 1e5 * area * found.sel(quantity=f"{drive}_pressure"), rtol=0.02)
assert run.finding.state == "ok"
