"""A robot of five freedoms: its drives along a motion, and the power balance of every sample."""

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.robot()
found = kt.kinematics.mobility(model)
print(f"{len(model.bars)} bars, {found.coordinates} coordinates, {found.fixed} fixed, {found.degrees_of_freedom} freedoms")
assert (len(model.bars), found.coordinates, found.fixed, found.degrees_of_freedom, found.undriven) == (53, 63, 7, 5, 0)

motion = kt.kinematics.follow(model, model.runs["move"].trajectory, samples=201)
forces = kt.dynamics.inverse(model, motion)
for name in model.drives:
    unit = "N" if name in ("lift", "reach") else "N m"
    print(f"{name:9} at most {np.abs(forces.drive_force.sel(drive=name).values).max():7.1f} {unit}")

# at rest the lift carries the weight of the three bodies
assert np.isclose(forces.drive_force.sel(drive="lift").values[0], 9.81 * (200 + 120 + 40), rtol=1e-9)
assert np.allclose(forces.power, forces.energy_rate, atol=1e-8)
