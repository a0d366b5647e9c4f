"""A heavy top on its tip precesses steadily at the two rates of the closed form, slow and fast, and does not nod."""

import numpy as np

import kinetruss as kt

mass, arm, tilt, spin, g = 0.5, 0.06, np.radians(25.0), 180.0, 9.81
axis = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
frame = np.array([[np.cos(tilt), 0.0, -np.sin(tilt)], [0.0, 1.0, 0.0], axis])
disc = kt.library.bodies.cylinder_properties(0.02, 0.05, mass=mass, at=arm * axis, axes=frame)
model = kt.library.bodies.rigid(
    kt.Model(nodes={"tip": (0, 0, 0)}, fixed=["tip"], gravity=(0, 0, -g)), "top", disc, nodes=["tip"]
)
I1, _, I3 = np.diag(frame @ disc.inertia @ frame.T)
I1 += mass * arm**2  # about the tip

# steady precession: I1 cos(tilt) W^2 - I3 spin W + m g l = 0, spin being the rate about the top's own axis
slow, fast = sorted(np.roots([I1 * np.cos(tilt), -I3 * spin, mass * g * arm]).real)
for name, W in (("slow", slow), ("fast", fast)):
    turning = W * np.array([0, 0, 1.0]) + (spin - W * np.cos(tilt)) * axis
    speeds = {node: tuple(np.cross(turning, model.nodes[node].at)) for node in model.bodies["top"].nodes if node != "tip"}
    run = kt.dynamics.simulate(
        model.with_(velocities=speeds), 0.5 * 2 * np.pi / W, samples=51, method=kt.DOP853(rtol=1e-12, atol=1e-13)
    )
    e = kt.kinematics.pose(model, run.motion, "top").rotation_matrix.values @ axis
    nod = np.abs(np.arccos(e[:, 2]) - tilt).max()
    way = np.unwrap(np.arctan2(e[:, 1], e[:, 0]))
    error = np.abs(way - W * run.motion.data.time.values).max()
    print(f"{name} precession at {W:.4f} rad/s: half a turn to {error:.1e} rad, nods by {nod:.1e} rad")
    assert nod < 1e-7
    assert error < 1e-6
