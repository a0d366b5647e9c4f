"""A crank turns a four-bar linkage at constant speed: torque at the crank, and a check that no energy is lost."""

import math

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.four_bar(coupler_mass=0.5)
motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 2 * math.pi}, duration=1), samples=361)
forces = kt.dynamics.inverse(model, motion)

torque = forces.drive_force.sel(drive="motor")
print(f"torque at the crank from {torque.min().item():.3f} to {torque.max().item():.3f} N m")

# one turn ends where it began, so the work of the motor is zero: its mean torque, over one period
work = 2 * math.pi * torque[:-1].mean().item()
print(f"work of one turn {work:.2e} J")
assert abs(work) < 1e-9
assert np.allclose(forces.power, forces.energy_rate, atol=1e-12)
