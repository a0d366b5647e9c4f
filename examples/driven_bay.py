"""Three motors behind self-locking screws move a loaded bay: to a pose in closed loop, and by a pulse."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["driven_bay"][0])
NAMES = ["M7", "M9", "M11"]

# %% Closed loop: poles are placed for the mass that each motor sees, the voltage saturates at 25 V, friction leaves an error
run = model.runs["pose"]
pose = kt.dynamics.simulate(model, run.t_end, samples=run.samples, tasks=run.tasks)
for name in NAMES:
    length, target = pose.motion.length.sel(member=name).values, run.tasks[name].target
    current, still = pose.motor_current.sel(motor=name).values, pose.motor_direction.sel(motor=name).values == 0
    stands = pose.motion.time.values[np.flatnonzero(~still)[-1] + 1]
    wanted, left = 1e3 * (target - length[0]), 1e3 * (target - length[-1])
    print(f"{name}: {wanted:+.1f} mm wanted, {left:+.3f} mm left, stands from {stands:.2f} s;")
    print(f"    {np.abs(current).max():.2f} A at most, {current[-1]:.2f} A in the end")
    assert abs(target - length[-1]) < 0.1 * abs(target - length[0])

# %% Where the energy goes: all of what the source gives is accounted for
taken = pose.electrical_energy.values[-1].sum()
for name in ("copper_energy", "motor_loss", "gear_loss", "screw_loss", "actuator_work"):
    print(f"{name:14s} {pose.data[name].values[-1].sum() / taken:6.1%}")
assert np.abs(pose.motor_energy_balance.values).max() < 1e-8 * taken

# %% Backwards: inverse dynamics along this motion, and what it asks of the drives, give the current and voltage back
demand = kt.actuators.evaluate(model, pose.motion, kt.dynamics.inverse(model, pose.motion, static=False))
moving = np.abs(pose.motion.length_rate.sel(member=NAMES).values) > 1e-8
for name in ("current", "voltage"):
    given = pose.data[f"motor_{name}"].values
    off = np.abs(demand.data[name].values - given)[moving].max() / np.abs(given).max()
    print(f"{name} found backwards, off by {off:.0e} of the largest")
    assert off < 1e-8

# %% Without voltage a self-locking screw stays where it is, whatever its neighbours do
run = model.runs["pulse"]
pulse = kt.dynamics.simulate(model, run.t_end, samples=run.samples, tasks=run.tasks)
went = pulse.motion.length.sel(member=NAMES).values[-1] - pulse.motion.length.sel(member=NAMES).values[0]
print("a pulse, nothing, a torque:", ", ".join(f"{1e3 * one:+.3f} mm" for one in went))
assert abs(went[1]) < 1e-12
