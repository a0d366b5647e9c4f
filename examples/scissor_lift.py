"""A scissor lift: pressure of the oil along the lift, and at the lowest position by hand."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["scissor_lift"][0])
run = kt.run(model)
found = run.quantities["all"].value
for at in (0, 30, 65, 130):
    height, pressure = (found.sel(quantity=name).values[at] for name in ("height", "pressure"))
    print(f"table at {height:.2f} m: {pressure:4.0f} bar")
print(run.finding.sentence)

# the length s of the cylinder has s^2 = 0.09 x^2 + 0.25 h^2 with x^2 + h^2 = (2 m)^2, so dh/ds = s/(0.16 h); the table rises by
# h, the middle of a leg by h/2, that of the cylinder by 0.35 h
h = found.sel(quantity="height").values
weight = 9.81 * (1150 + 2 * 113.04 / 2 + 40 * 0.35)
thrust = weight * np.sqrt(0.36 + 0.16 * h**2) / (0.16 * h)
assert np.allclose(found.sel(quantity="thrust"), thrust, rtol=1e-12)
drive = run.forces["middle"].drive_force.sel(drive="cylinder")
assert np.allclose(drive, thrust, rtol=1e-3)  # the lift is slow: inertia adds little
assert run.finding.state == "ok"
