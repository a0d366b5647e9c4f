"""The two slewing experiments from noisy records of lengths: tilt, motor voltages, strain against constructed records."""

import numpy as np

import kinetruss as kt

file, *tables = kt.library.example_files()["slewing_experiments"]
model = kt.read(file)
files = {table.name: table for table in tables}

for number, tilt in ((1, 10), (2, 8)):
    name = f"experiment_{number}"
    record = kt.io.read_measured(files[f"slewing_{name}.csv"])  # constructed, not measured: the files say how
    smooth = kt.kinematics.measured(record)
    noise = 1e3 * smooth.noise.values
    run = model.runs[name]
    motion = kt.kinematics.follow(model, run.trajectory, samples=run.samples)
    beta, _, _ = np.degrees(kt.kinematics.gimbal_pose(1.2192, 0.9017, motion.length.sel(member=["M7", "M9", "M11"]).values))
    print(f"{name}: {run.samples} rows with a noise of {noise.mean():.3f} mm,", end=" ")
    print(f"tilt from {beta.min():.2f} to {beta.max():.2f} degrees")
    assert np.allclose(noise, 0.02, rtol=0.25)  # what the records were made with
    assert np.allclose([beta.min(), beta.max()], [-tilt, tilt], atol=0.01)
    assert not smooth.outlier.any()

    errors = kt.runs.standard_errors(model, record)
    force, volts = (float(np.sqrt((errors[f"{key}_error"] ** 2).mean())) for key in ("member_force", "voltage"))
    peak = abs(errors["voltage"].sel(active="M7")).max().item()
    print(f"    motor of M7 up to {peak:.1f} V; standard errors {1e3 * force:.1f} mN and {volts:.2f} V (root mean square)")
    assert force < 0.02

    measured = kt.io.read_strains(files[f"strain_{name}.csv"], model)  # constructed as well
    found = kt.strength.compare_gauges(kt.runs.gauge_strains(model, name, measured=measured), measured).sel(column="M6.axial")
    offset, correlation = found["offset"].item(), found["correlation"].item()
    print(f"    strain of M6, record minus computed: offset {offset:.3f} microstrain, correlation {correlation:.4f}")
    assert correlation > 0.998
