"""Watt's six-bar: its crank turns round, the second loop on its rocker closes all the way, and it comes home."""

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.watt_six_bar()
motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 2 * np.pi}, duration=1.0), samples=361)
start = {name: np.array(node.at) for name, node in model.nodes.items()}
worst = max(
    np.abs(np.linalg.norm(motion.position.sel(node=a).values - motion.position.sel(node=b).values, axis=1)
           - np.linalg.norm(start[a] - start[b])).max()
    for a, b in (bar.ends for bar in model.bars.values())
)  # fmt: skip
home = np.abs(motion.position.isel(time=-1).values - motion.position.isel(time=0).values).max()
print(f"{len(model.bars)} bars keep their lengths to {worst:.1e} m; after one turn it is home to {home:.1e} m")
assert kt.kinematics.mobility(model).degrees_of_freedom == 1
assert worst < 1e-13
assert home < 1e-12
