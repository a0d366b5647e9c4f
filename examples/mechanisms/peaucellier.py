"""Peaucellier's linkage: seven bars draw a straight line."""

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.peaucellier()
motion = kt.kinematics.follow(model, model.runs["swing"].trajectory, samples=101)
x, y = (motion.position.sel(node="P", axis=axis).values for axis in "xy")
print(f"P runs {np.ptp(y) * 1000:.1f} mm and leaves its line by {np.ptp(x):.1e} m")
assert np.ptp(y) > 0.05
assert np.allclose(x, (0.5**2 - 0.3**2) / (2 * 0.15), rtol=0, atol=1e-13)
