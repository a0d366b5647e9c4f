"""A box spun about its middle axis turns over and over, as Euler's equations say; its pose without one angle integrated."""

import numpy as np
from scipy.integrate import solve_ivp

import kinetruss as kt

SPIN = np.array([0.05, 6.0, 0.02])
model = kt.library.bodies.box(kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"]), "box", (0.1, 0.2, 0.4), mass=3.0)
shape = kt.library.bodies.properties_of(model, "box")
speeds = {name: tuple(np.cross(SPIN, np.array(model.nodes[name].at) - shape.center)) for name in model.bodies["box"].nodes}

run = kt.dynamics.simulate(model.with_(velocities=speeds), 3.0, samples=301, method=kt.DOP853(rtol=1e-11, atol=1e-12))
pose = kt.kinematics.pose(model, run.motion, "box")
R = pose.rotation_matrix.values
own = np.einsum("tji,tj->ti", R, pose.angular_velocity.values)  # in the axes of the box

moments = np.diag(shape.inertia)
euler = solve_ivp(
    lambda _, w: np.cross(moments * w, w) / moments, (0, 3), SPIN, method="DOP853", rtol=1e-13, atol=1e-13,
    t_eval=run.motion.data.time.values,
)  # fmt: skip
error = np.abs(own - euler.y.T).max()
kept = np.abs(np.einsum("tij,j,tj->ti", R, moments, own) - moments * SPIN).max()
print(f"middle axis from {own[:, 1].max():.2f} to {own[:, 1].min():.2f} rad/s; Euler's equations to {error:.1e} rad/s")
print(f"angular momentum keeps its direction and size to {kept:.1e} N m s")
assert own[:, 1].min() < -5
assert error < 1e-7
assert kept < 1e-8
