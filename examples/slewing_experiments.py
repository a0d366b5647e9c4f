"""The two slewing experiments from tables of lengths: tilt, strain against constructed records, voltages of the motors."""

import numpy as np

import kinetruss as kt

file, *tables = kt.library.example_files()["slewing_experiments"]
model = kt.read(file)
ideal = kt.read(kt.library.example_files()["strain_gauges"][0])  # the same gauges along the laws that the tables are made from

for name in ("experiment_1", "experiment_2"):
    run = model.runs[name]
    motion = kt.kinematics.follow(model, run.trajectory, samples=run.samples)
    beta, _, _ = kt.kinematics.gimbal_pose(1.2192, 0.9017, motion.length.sel(member=["M7", "M9", "M11"]).values)
    forces = kt.dynamics.inverse(model, motion)
    demand = kt.actuators.evaluate(model, motion, forces)
    print(
        f"{name}: {run.samples} rows, tilt from {np.degrees(beta.min()):.2f} to {np.degrees(beta.max()):.2f} degrees,", end=" "
    )
    print(f"motor of M7 up to {abs(demand.voltage.sel(active='M7')).max().item():.1f} V")

    (record,) = (table for table in tables if table.name == f"strain_{name}.csv")
    measured = kt.io.read_strains(record, model)  # constructed, not measured: the file says how
    strains = kt.runs.gauge_strains(model, name, measured=measured)
    found = kt.strength.compare_gauges(strains, measured).sel(column="M6.axial")
    offset, correlation = found["offset"].item(), found["correlation"].item()
    print(f"    strain of M6, record minus computed: offset {offset:.3f} microstrain, correlation {correlation:.4f}")
    same = kt.runs.gauge_strains(ideal, name, measured=measured)["group_strain"] - strains["group_strain"]
    rounding = abs(same).max().item()
    print(f"    lengths rounded to 0.01 mm change the strains by up to {rounding:.3f} microstrain")
    assert rounding < 0.05
    assert np.allclose(np.degrees([beta.min(), beta.max()]), [-10, 10] if name == "experiment_1" else [-8, 8], atol=0.01)
    assert correlation > 0.999
