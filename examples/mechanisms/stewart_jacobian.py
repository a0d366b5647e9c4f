"""A Stewart-Gough platform as a machine: Jacobian, stiffness, and a Delta's workspace, against closed forms."""

import math

import numpy as np

import kinetruss as kt

model = kt.library.mechanisms.stewart(at=(0.05, -0.03, 0.62), turned=(0.1, -0.05, 0.2))
heads = [f"P{k}" for k in range(1, 7)]
found = kt.kinematics.platform_jacobian(model, heads)
middle = np.mean([model.nodes[name].at for name in heads], axis=0)
rows = []
for k in range(1, 7):
    foot, head = (np.array(model.nodes[end].at) for end in model.bars[f"leg{k}"].ends)
    along = (head - foot) / np.linalg.norm(head - foot)
    rows.append([*along, *np.cross(head - middle, along)])
error = np.abs(found.inverse.values - rows).max()
print(f"leg rates per twist are the lines of the legs, to {error:.1e}; parallel gauge {float(float(found.parallel)):.3f}")
assert error < 1e-12

stiffness = kt.statics.platform_stiffness(model, heads, 2e6).stiffness.values
wanted = 2e6 * np.array(rows).T @ np.array(rows)
print(f"stiffness J^T k J upwards: {stiffness[2, 2] / 1e6:.3f} N/um")
assert np.allclose(stiffness, wanted, rtol=1e-9, atol=1e-3)

delta = kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7))
far = np.linspace(0.0, 0.8, 41)
slice_ = kt.kinematics.workspace(delta, "Q", ("x", far), ("y", [0.0]), {"z": -0.75})


def reached(x: float) -> bool:
    """All three rods, 0.8 m, reach from the circles of the elbows, 0.35 m, to the sides of the platform."""
    for turn in (0.0, 2 * math.pi / 3, -2 * math.pi / 3):
        out, side, down = x * math.cos(turn) + 0.09 * math.sqrt(3) / 2 - 0.2, -x * math.sin(turn), -0.70
        size = math.hypot(out, down)
        if abs(size**2 + side**2 + 0.35**2 - 0.8**2) > 2 * 0.35 * size:
            return False
    return True


print(f"the Delta reaches {int(slice_.reachable.sum())} of {len(far)} places along x")
assert [bool(place) for place in slice_.reachable.values.reshape(-1)] == [reached(x) for x in far]
