"""Lines drawn by bars: Hart's inversor exactly, Watt's linkage with an error of fifth order in its swing."""

import numpy as np

import kinetruss as kt

hart = kt.library.mechanisms.hart()
motion = kt.kinematics.follow(hart, hart.runs["swing"].trajectory, samples=101)
x, y = (motion.position.sel(node="P", axis=axis).values for axis in "xy")
print(f"Hart: P runs {1e3 * np.ptp(y):.1f} mm and leaves its line by {np.ptp(x):.1e} m")
assert np.ptp(y) > 0.01
assert np.ptp(x) < 1e-13


def aside(swing: float) -> float:
    """How far Watt's P leaves its line while the arm swings so far to either side of level, m."""
    watt = kt.library.mechanisms.watt_line(angle=-swing)
    path = kt.kinematics.follow(watt, kt.Quintic(moves={"motor": (-swing, swing)}, duration=1.0), samples=51)
    return np.abs(path.position.sel(node="P", axis="x").values).max()


order = np.log2(aside(0.2) / aside(0.1))
print(f"Watt: P leaves its line by {aside(0.2):.1e} m at 0.2 rad, with the power {order:.2f} of the swing")
assert 4.5 < order < 5.5
