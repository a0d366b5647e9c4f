"""A slider-crank at even speed: where the slider is, and the torque that moves it, against the closed form."""

import numpy as np

import kinetruss as kt

r, l, mass, rate = 0.1, 0.3, 3.0, 20.0
model = kt.library.mechanisms.slider_crank(
    crank=r, rod=l, slider_mass=mass, crank_mass=0.0, rod_mass=0.0, angle=0.4, gravity=None
)
motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": rate}, duration=0.6), samples=301)
forces = kt.dynamics.inverse(model, motion)

angle = 0.4 + rate * motion.data.time.values
s, c, side = np.sin(angle), np.cos(angle), np.sqrt(l**2 - (r * np.sin(angle)) ** 2)
place = r * c + side
slope = -r * s - r**2 * s * c / side  # of the place over the angle
bend = -r * c - r**2 * (c**2 - s**2) / side - r**4 * s**2 * c**2 / side**3
torque = mass * bend * rate**2 * slope

off = np.abs(motion.position.sel(node="S", axis="x").values - place).max()
strange = np.abs(forces.drive_force.sel(drive="motor").values - torque).max() / np.abs(torque).max()
print(f"slider off by {off:.1e} m, torque of at most {np.abs(torque).max():.1f} N m off by {strange:.1e} of it")
assert off < 1e-13
assert strange < 1e-12
