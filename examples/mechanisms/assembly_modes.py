"""All ways to put a platform on three points together with its six legs as they are: 16 complex ones, some of them real."""

import numpy as np

import kinetruss as kt

platform = kt.library.mechanisms.stewart(kind="6-3", turned=(0.1, 0.2, 0.1))
modes = kt.kinematics.assembly_modes(platform)
print(f"{modes.attrs['complex_solutions'][0]} complex solutions, {modes.sizes['mode']} real configurations")
for mode in modes.mode.values:
    P1 = modes.position.sel(mode=mode, node="P1").values.round(4)
    print(f"  {mode}: P1 at {P1}, smallest singular value {modes.singularity.sel(mode=mode).item():.3f}")

assert modes.attrs["complex_solutions"] == [16]  # Innocenti & Parenti-Castelli (1990): a triangular platform has 16
assert modes.attrs["lost"] == 0
assert modes.distance.values[0] < 1e-9  # the model's own configuration is one of them
heights = modes.position.sel(node=["P1", "P2", "P3"], axis="z").values
below = np.sort(-heights[heights.max(axis=1) < 0], axis=0)
above = np.sort(heights[heights.min(axis=1) > 0], axis=0)
assert np.abs(below - above).max() < 1e-9  # those under the base mirror those above it
