"""A Stewart-Gough platform: leg lengths for a pose, and back from the lengths to the pose."""

import math

import numpy as np

import kinetruss as kt

home = kt.library.mechanisms.stewart()
pose = kt.library.mechanisms.stewart(at=(0.03, -0.02, 0.65), turned=(0.1, -0.05, 0.2))
legs = {f"leg{k}": math.dist(*(pose.nodes[end].at for end in pose.bars[f"leg{k}"].ends)) for k in range(1, 7)}
print({name: round(length, 6) for name, length in legs.items()})

assembled = kt.kinematics.assemble(home, lengths=legs)
wanted = np.array([node.at for node in pose.nodes.values()])
error = np.abs(assembled - wanted).max()
print(f"the platform stands where it was wanted, to {error:.1e} m")
assert error < 1e-12
