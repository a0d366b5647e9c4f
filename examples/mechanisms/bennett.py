"""Bennett's linkage: four skew hinges that move though the count of a loop of four gives -2; rank decides."""

import math

import numpy as np

import kinetruss as kt

TWISTS = (0.7, 1.3)
ratio = math.sin((TWISTS[1] + TWISTS[0]) / 2) / math.sin((TWISTS[1] - TWISTS[0]) / 2)

model = kt.library.mechanisms.bennett()
found = kt.kinematics.mobility(model)
print(f"count {found.maxwell}, rank {found.rank}: {found.undriven} mechanism, {found.self_stress} states of self-stress")
assert (found.rank, found.undriven, found.self_stress) == (11, 1, 3)


def turned(angle: float, hinge: str, before: str, after: str) -> float:
    """Angle at a hinge between the perpendiculars to its neighbours, rad, where hinge 1 stands at `angle`."""
    at = {name: np.array(node.at) for name, node in kt.library.mechanisms.bennett(angle=angle).nodes.items()}
    u, v = at[f"P{hinge}"] - at[f"P{before}"], at[f"P{after}"] - at[f"P{hinge}"]
    axis = (at[f"A{hinge}"] - at[f"P{hinge}"]) / np.linalg.norm(at[f"A{hinge}"] - at[f"P{hinge}"])
    return math.atan2(axis @ np.cross(u, v), u @ v)


for angle in (0.5, 1.0, 2.0):
    first, second = turned(angle, "1", "4", "2"), turned(angle, "2", "1", "3")
    product = math.tan(first / 2) * math.tan(second / 2)
    print(f"hinges at {first:.3f} and {second:.3f} rad: product of tangents of their halves {product:.12f}")
    assert math.isclose(abs(product), ratio, rel_tol=1e-12)
