"""The real drive of the slewing programme: fed with an exponential voltage, then in a position loop, then read backwards."""

import numpy as np

import kinetruss as kt
from kinetruss.library.drives import TRAIN_LACY_SLEWING as TRAIN

# %% Open loop: the friction of 0.6 N m holds the motor until the amplifier gives 3.4 V; then the speed limit is near
run = kt.actuators.simulate_drive(
    TRAIN, kt.ExponentialInput(voltage=(0, 3.5), time_constant=0.15), load=40.0, duration=1.0, length=1.412
)
for episode in run.episodes:
    print(f"open loop: {episode}")
print(f"open loop: {1e3 * (run.length.values[-1] - 1.412):.2f} mm in 1 s, {run.electrical_energy.values[-1]:.0f} J")

# %% Closed loop: 20 mm longer, damping 0.8, poles as in the programme (w = 6/(0.8 x settling time))
loop = kt.PositionLoop(target=1.432, damping=0.8, settling_time=0.9 * 1.5, settling_factor=6)
gains = kt.actuators.place_poles(TRAIN, loop)
closed = kt.actuators.simulate_drive(TRAIN, loop, load=40.0, duration=1.5, length=1.412)
print(f"loop: gains {gains.position:.0f} V/m and {gains.rate:.1f} V s/m; {closed.status.value}")
print(f"loop: {closed.message}")

# %% Without friction the loop is the closed form
free = TRAIN.with_(screw=TRAIN.screw.with_(friction=0.0), motor=TRAIN.motor.with_(friction_torque=0.0))
ideal = kt.actuators.simulate_drive(free, loop.with_(target=1.4121), duration=1.5, length=1.412)
w = loop.natural_frequency
wd, t = 0.6 * w, ideal.time.values
expected = 1.412 + 1e-4 * (1 - np.exp(-0.8 * w * t) * (np.cos(wd * t) + 0.8 / 0.6 * np.sin(wd * t)))
assert np.abs(ideal.length.values - expected).max() < 1e-12

# %% Backwards: the same length history asks for the same current
torque = kt.actuators.screw_torque(TRAIN.screw, closed.thrust.values, closed.length_rate.values)
back = kt.actuators.motor_demand(
    TRAIN.screw, TRAIN.gear, TRAIN.motor, torque, closed.length_rate.values, closed.length_acceleration.values
)
moving = closed.length_rate.values != 0
assert np.abs(back["current"] - closed.current.values)[moving].max() < 1e-9
assert np.abs(closed.energy_balance.values).max() < 1e-6
needed = (0.6 + kt.actuators.raising_torque(TRAIN.screw, 40.0) / 5.1) / 0.1 / 1.8
print(f"the drive starts at {needed:.3f} V")
assert abs(needed - 3.379) < 1e-3

# %% The model file beside this script has the same drive: what a quintic move of 20 mm asks of it
model = kt.read(kt.library.example_files()["drive_train"][0])
assert kt.actuators.train_of(model, "leg") == TRAIN
motion = kt.kinematics.follow(model, model.runs["out"].trajectory, samples=301)
demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
for row in demand.table():
    print(f"{row.rule:10s} {row.value:8.4g} of {row.limit:8.4g} {row.unit}")
assert not kt.actuators.exceeded(demand)
