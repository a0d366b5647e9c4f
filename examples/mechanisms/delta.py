"""A Delta robot whose arms are let go: the platform falls, does not turn, and is where the equations in its place say."""

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.delta(at=(0.05, -0.08, -0.75))
found = kt.kinematics.mobility(model)
print(f"{len(model.bars)} bars, rank {found.rank}, {found.degrees_of_freedom} degrees of freedom")
assert (len(model.bars), found.coordinates, found.fixed, found.rank, found.degrees_of_freedom) == (45, 66, 18, 45, 3)

free = dict.fromkeys(model.drives, kt.Free())
run = kt.dynamics.simulate(model, 0.15, samples=2, tasks=free, method=kt.DOP853(rtol=1e-12, atol=1e-14))
corners = run.motion.position.sel(node=[f"P{k}{side}" for k in (1, 2, 3) for side in "ab"]).isel(time=-1)
platform = corners.mean("node").values
print("platform after 0.15 s:", platform.round(9), "m")

# virtual work in the three coordinates of the platform, integrated apart from this library
assert np.allclose(platform, [0.05112539021292342, -0.08176370419970541, -0.8862096864133835], rtol=0, atol=1e-10)
