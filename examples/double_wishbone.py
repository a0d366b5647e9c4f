"""A wheel on two wishbones: camber, toe and roll centre along its travel; camber at rest by hand."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["double_wishbone"][0])
run = kt.run(model)
found = run.quantities["all"].value
travel = found.sel(quantity="travel").values
print(" travel    camber      toe   roll centre")
for wanted in (-0.06, -0.03, 0.0, 0.03, 0.06):
    at = int(np.abs(travel - wanted).argmin())
    camber, toe, centre = (found.sel(quantity=name).values[at] for name in ("camber", "toe", "roll_centre"))
    print(f"{1e3 * travel[at]:4.0f} mm {np.degrees(camber):6.2f} deg {np.degrees(toe):5.2f} deg {1e3 * centre:8.0f} mm")
print(run.finding.sentence)

# the camber is the slope of the wheel's axis
axis = run.motion.position.sel(node="S") - run.motion.position.sel(node="W")
slope = np.arcsin(axis.sel(axis="z") / np.linalg.norm(axis, axis=1))
assert np.allclose(found.sel(quantity="camber"), -slope, atol=1e-12)
assert run.finding.state == "ok"
