"""A sphere of flat triangles under inner pressure: stress p r/(2 t) and growth p r^2 (1 - nu)/(2 E t), nearer with h^2."""

import numpy as np

import kinetruss as kt

r, t, p, E, nu = 0.5, 1e-3, 2e4, 70e9, 0.3


def octant(parts):
    """An eighth of the sphere, held by its planes of symmetry, every triangle under pressure."""
    grid = [(i, j) for i in range(parts + 1) for j in range(parts + 1 - i)]
    number = {ij: k for k, ij in enumerate(grid)}
    points = np.array([(i, j, parts - i - j) for i, j in grid], float)
    points *= r / np.linalg.norm(points, axis=1, keepdims=True)
    up = [[(i, j), (i + 1, j), (i, j + 1)] for i, j in grid if i + j < parts]
    down = [[(i + 1, j), (i + 1, j + 1), (i, j + 1)] for i, j in grid if i + j < parts - 1]
    mesh = kt.library.meshes.mesh(points, [[number[ij] for ij in three] for three in (*up, *down)])
    held = {}
    for letter in "xyz":
        for name in mesh.at(**{letter: 0.0}):
            held[name] = held.get(name, "") + letter
    faces = [tuple(mesh.names[k] for k in three[::-1]) for three in mesh.elements]  # seen from within
    loads = {f"p{k}": kt.Pressure(face=face, pressure=p) for k, face in enumerate(faces)}
    skin = mesh.membrane(thickness=t)
    return kt.Model(
        nodes=mesh.nodes, fixed=held, material=kt.Material(E=E, poisson=nu, density=0.0), membranes={"skin": skin}, loads=loads
    )


missed = []
for parts in (4, 8, 16):
    model = octant(parts)
    rest = kt.statics.equilibrium(model)
    stress = kt.strength.elements(model, rest, "skin")
    mean = float(
        np.average(stress.principal.values[..., :2].mean(axis=-1).reshape(-1), weights=stress.volume.values.reshape(-1))
    )
    moved = np.linalg.norm(rest.position.values, axis=-1).mean() - r
    missed.append((mean / (p * r / (2 * t)) - 1, moved / (p * r**2 * (1 - nu) / (2 * E * t)) - 1))
    print(
        f"{len(model.membranes['skin'].elements)} triangles: stress off by {missed[-1][0]:.1e}, growth by {missed[-1][1]:.1e}"
    )

stress_off, growth_off = np.abs(missed).T
assert np.all(stress_off[:-1] / stress_off[1:] > 3.7)  # of second order in the size of the triangles
assert stress_off[-1] < 3e-3
assert np.all(growth_off[:-1] / growth_off[1:] > 2)
assert growth_off[-1] < 2e-2
