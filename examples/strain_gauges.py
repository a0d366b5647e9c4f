"""Three gauges on M6 of a hanging bay: strain along two slews, and records of the experiments against it."""

import numpy as np

import kinetruss as kt

file, *records = kt.library.example_files()["strain_gauges"]
model = kt.read(file)

for name, path in zip(("experiment_1", "experiment_2"), records, strict=True):
    measured = kt.io.read_strains(path, model)  # constructed, not measured: the files say how
    strains = kt.runs.gauge_strains(model, name, measured=measured)
    axial = strains["group_strain"].sel(group="M6", component="axial")
    bridge = 1e6 * abs(strains["bridge"]).max().item()
    print(f"{name}: axial strain of M6 {axial.min().item():.3f} to {axial.max().item():.3f} microstrain, {bridge:.2f} uV/V")
    found = kt.strength.compare_gauges(strains, measured).sel(column="M6.axial")
    share = found["difference"].values / found["simulated"].values
    offset, rms, correlation = (found[key].item() for key in ("offset", "rms", "correlation"))
    print(f"    measured minus simulated: offset {offset:.3f}, rms {rms:.3f} microstrain, correlation {correlation:.4f}")
    print(f"    {100 * share[0]:.0f} % at the start, {100 * share[-1]:.0f} % at the end")
    if name == "experiment_1":
        assert -0.14 < share[0] < -0.10
        assert -0.06 < share[-1] < -0.04

assert abs(offset - 0.5) < 0.01
# three gauges 120 degrees apart: their mean is the axial strain
assert np.allclose(strains["strain"].mean("gauge"), axial)
