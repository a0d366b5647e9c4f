"""A plate of triangles under tension: stress and stretch of a bar of the same section, exactly, on an uneven mesh."""

import numpy as np

import kinetruss as kt

E, nu, thickness, pull = 210e9, 0.3, 0.01, 1e5
mesh = kt.library.meshes.rectangle(width=2.0, height=0.5, columns=8, rows=2)
sides = dict.fromkeys(mesh.at(x=0.0), "x") | {mesh.nearest((0.0, 0.0)): "xy"}
edge = [pull / 4, pull / 2, pull / 4]
model = kt.Model(
    nodes=mesh.nodes, fixed=sides, material=kt.Material(E=E, poisson=nu, density=7850.0),
    membranes={"plate": mesh.membrane(thickness=thickness)},
    loads={f"pull.{name}": kt.NodalForce(node=name, force=(f, 0)) for name, f in zip(mesh.at(x=2.0), edge, strict=True)},
)  # fmt: skip
rest = kt.statics.equilibrium(model)
stress = kt.strength.elements(model, rest, "plate").von_mises.values
print(f"stress {stress.min() / 1e6:.4f} to {stress.max() / 1e6:.4f} MPa, of a bar {pull / (0.5 * thickness) / 1e6:.4f} MPa")
assert np.allclose(stress, pull / (0.5 * thickness), rtol=1e-3)  # the true section is smaller by the strain
assert np.ptp(stress) < 1e-6 * stress.max()
