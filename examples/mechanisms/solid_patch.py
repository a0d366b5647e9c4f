"""An uneven block of tetrahedra drawn to 1.43 times its length: stress and stretch of the closed form, exactly."""

import numpy as np

import kinetruss as kt

E, nu, size, pull = 2e6, 0.3, np.array([0.4, 0.2, 0.1]), 3e4
mesh = kt.library.meshes.box(size=size, cells=(4, 3, 2))
points, rng = mesh.points.copy(), np.random.default_rng(1)
inner = np.all((points > 1e-9) & (points < size - 1e-9), axis=1)
points[inner] += rng.uniform(-0.15, 0.15, (inner.sum(), 3)) * size / (4, 3, 2)
mesh = kt.library.meshes.mesh(points, mesh.elements)

held = {}
for letter in "xyz":
    for name in mesh.at(**{letter: 0.0}):
        held[name] = held.get(name, "") + letter
share = dict.fromkeys(mesh.at(x=size[0]), 0.0)  # of the end's area, a third of every triangle to each corner
for four in mesh.elements:
    face = [mesh.names[k] for k in four if mesh.names[k] in share]
    if len(face) == 3:
        a, b, c = (points[mesh.names.index(name)] for name in face)
        for name in face:
            share[name] += np.linalg.norm(np.cross(b - a, c - a)) / 6
area = size[1] * size[2]
model = kt.Model(
    nodes=mesh.nodes, fixed=held, material=kt.Material(E=E, poisson=nu, density=0.0), solids={"block": mesh.solid()},
    loads={f"pull.{name}": kt.NodalForce(node=name, force=(pull * part / area, 0, 0)) for name, part in share.items()},
)  # fmt: skip
rest = kt.statics.equilibrium(model)

# St Venant-Kirchhoff under one stress: pull/area = E s (s^2 - 1)/2 with the stretch s; across sqrt(1 - nu (s^2 - 1))
s = max(np.roots([E / 2, 0, -E / 2, -pull / area]).real)
across = np.sqrt(1 - nu * (s**2 - 1))
wanted = points * [s, across, across]
error = np.abs(rest.position.values - wanted).max()
true = kt.strength.elements(model, rest, "block").true_stress.values
print(f"stretch {s:.6f}; places to {error:.1e} m, true stress {true[..., 0, 0].mean() / 1e6:.6f} MPa")
assert error < 1e-10
assert np.allclose(true[..., 0, 0], pull / (area * across**2), rtol=1e-9)
assert abs(s - 1.431127) < 1e-6
