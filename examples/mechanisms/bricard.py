"""Bricard's linkage: 24 bars hold 24 coordinates, and still it moves; by rank, not by count."""

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.bricard()
found = kt.kinematics.mobility(model)
print(f"count {found.maxwell}, rank {found.rank}: {found.undriven} mechanism, {found.self_stress} state of self-stress")
assert (found.maxwell, found.rank, found.undriven, found.self_stress) == (0, 23, 1, 1)

run = kt.dynamics.simulate(model, 2.0, samples=201)
energy = run.kinetic_energy.values + run.potential_energy.values
change = np.abs(energy - energy[0]).max() / run.kinetic_energy.values.max()
print(f"let go for 2 s: energy changes by {change:.1e} of the largest kinetic energy")
assert change < 1e-7
