"""Bodies of the library: shapes, surfaces, default points, and motion that does not depend on the points."""

import struct
from itertools import product

import numpy as np
import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.model import body_mass

bodies = kt.library.bodies
seeds = st.integers(0, 2**32 - 1)
GROUND = kt.Model(nodes={"O": (0.0, 0.0, 0.0)}, fixed=["O"], gravity=(0, 0, -9.81))


def cube(size=1.0, at=(0.0, 0.0, 0.0)):
    """The twelve triangles of a box, turned outwards."""
    corners = {bits: np.array(at) + np.array(size) * (np.array(bits) - 0.5) for bits in product((0, 1), repeat=3)}
    found = []
    for axis, side in product(range(3), (0, 1)):
        one, two = (axis + 1) % 3, (axis + 2) % 3
        square = []
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            bits = [0, 0, 0]
            bits[axis], bits[one], bits[two] = side, a, b
            square.append(corners[tuple(bits)])
        square = square if side else square[::-1]
        found += [[square[0], square[1], square[2]], [square[0], square[2], square[3]]]
    return np.array(found)


def same(one, two, tolerance=1e-12):
    assert abs(one.mass - two.mass) < tolerance * abs(two.mass)
    assert np.abs(one.center - two.center).max() < tolerance
    assert np.abs(one.inertia - two.inertia).max() < tolerance * np.abs(two.inertia).max()


def test_cuboid_from_its_corner():
    """-2 m along the edges of the corner, 3 m/2 between the others, 5 m/2 in the corner."""
    found = bodies.bar_masses(
        [[0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4]], 1.0, (1, 1.5, 2), bodies.box_properties((2, 3, 4), mass=1).inertia
    )
    assert np.allclose([found.bars[0, k] for k in (1, 2, 3)], -2, atol=1e-12)
    assert np.allclose([found.bars[pair] for pair in ((1, 2), (1, 3), (2, 3))], 1.5, atol=1e-12)
    assert np.allclose(found.lumped, (2.5, 0, 0, 0), atol=1e-12)


@given(seeds)
def test_bars_and_back(seed):
    rng = np.random.default_rng(seed)
    points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) + rng.uniform(-0.3, 0.3, (4, 3))
    shape = bodies.box_properties(
        rng.uniform(0.1, 2, 3), mass=2.0, at=rng.normal(size=3), axes=np.linalg.qr(rng.normal(size=(3, 3)))[0]
    )
    worth = bodies.bar_masses(points, shape.mass, shape.center, shape.inertia)
    same(bodies.mass_properties(points, worth.bars, worth.lumped), shape, 1e-11)


@pytest.mark.parametrize("text", [True, False])
@pytest.mark.parametrize("turned", [False, True])
def test_stl_of_a_box(tmp_path, text, turned):
    triangles = cube((2, 1, 0.5), (3, -2, 1))[:, :: -1 if turned else 1]
    path = tmp_path / "box.stl"
    if text:
        facets = ["".join(f"vertex {x} {y} {z}\n" for x, y, z in t) for t in triangles]
        lines = [f"facet normal 0 0 0\nouter loop\n{facet}endloop\nendfacet" for facet in facets]
        path.write_text("solid box\n" + "\n".join(lines) + "\nendsolid box\n")
    else:
        data = b"".join(struct.pack("<12fH", 0, 0, 0, *t.reshape(-1), 0) for t in triangles)
        path.write_bytes(b"solid but binary".ljust(80) + struct.pack("<I", len(triangles)) + data)
    same(bodies.from_stl(path, density=10.0), bodies.box_properties((2, 1, 0.5), density=10.0, at=(3, -2, 1)))
    assert abs(bodies.from_stl(path, density=1.0, scale=0.1).mass - 1e-3) < 1e-15
    assert bodies.stl(GROUND, "b", path, mass=1.0, nodes=["O"]).bodies["b"].mass == 1.0


def test_surfaces_that_are_none(tmp_path):
    with pytest.raises(kt.InputError, match="is not a closed surface, all turned alike: 3 edges are met from one side only"):
        bodies.surface_properties(cube()[1:], mass=1)
    mixed = cube()
    mixed[0] = mixed[0][::-1]
    with pytest.raises(kt.InputError, match="not a closed surface"):
        bodies.surface_properties(mixed, mass=1)
    with pytest.raises(kt.InputError, match="cannot be read"):
        bodies.from_stl(tmp_path / "no.stl", mass=1)
    (tmp_path / "no.stl").write_text("solid of words only")
    with pytest.raises(kt.InputError, match="is no STL file"):
        bodies.from_stl(tmp_path / "no.stl", mass=1)
    with pytest.raises(kt.InputError, match="either the mass"):
        bodies.surface_properties(cube())


def test_a_sphere_of_many_triangles_converges():
    def error(n):
        theta, phi = np.meshgrid(np.linspace(0, np.pi, n + 1), np.linspace(0, 2 * np.pi, 2 * n + 1), indexing="ij")
        r = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
        r[:, -1] = r[:, 0]
        a, b, c, d = r[:-1, :-1], r[1:, :-1], r[1:, 1:], r[:-1, 1:]
        made = np.concatenate([np.stack(corners, axis=2).reshape(-1, 3, 3) for corners in ((a, b, c), (a, c, d))])
        wanted = bodies.sphere_properties(1.0, density=1.0).inertia[0, 0]
        return abs(bodies.surface_properties(made, density=1.0).inertia[0, 0] / wanted - 1)

    errors = [error(n) for n in (8, 16)]
    assert 1.9 < np.log2(errors[0] / errors[1]) < 2.1


def test_shapes_made_of_others():
    whole = bodies.cylinder_properties(2.0, 0.5, density=3.0)
    same(
        bodies.combined(whole, bodies.cylinder_properties(2.0, 0.2, density=-3.0)),
        bodies.tube_properties(2.0, 0.5, 0.2, density=3.0),
    )
    halves = [bodies.box_properties((1, 1, 1), mass=1, at=(x, 0, 0)) for x in (-0.5, 0.5)]
    same(bodies.combined(*halves), bodies.box_properties((2, 1, 1), mass=2))
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces = np.array(points, float)[[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]]
    same(bodies.tetrahedron_properties(points, density=6.0), bodies.surface_properties(faces, density=6.0))


@pytest.mark.parametrize(
    ("made", "count"),
    [
        (lambda: bodies.box(GROUND, "b", (1, 2, 3), mass=2.0, at=(1, 0, 0)), 4),
        (lambda: bodies.cylinder(GROUND, "b", 2.0, 0.3, mass=2.0, axes=np.eye(3)[[1, 2, 0]]), 4),
        (lambda: bodies.sphere(GROUND, "b", 0.7, mass=2.0), 4),
        (lambda: bodies.tube(GROUND, "b", 1.0, 0.3, 0.2, mass=2.0), 4),
        (lambda: bodies.flat(GROUND, "b", (1, 2), mass=2.0, at=(0, 1, 2), axes=np.eye(3)[[2, 0, 1]]), 3),
        (lambda: bodies.rigid(GROUND, "b", bodies.rod_properties((0, 0, 0), (1, 2, 3), mass=2.0)), 2),
    ],
    ids=["box", "cylinder", "sphere", "tube", "flat", "rod"],
)
def test_default_points_carry_the_body(made, count):
    model = made()
    body = model.bodies["b"]
    assert len(body.nodes) == len(body.carriers) == count
    m, _ = body_mass(model, body)
    assert abs(m.sum() - 2.0) < 1e-14
    if count == 4:  # bars worth m/4 each, -m/8 at the corners
        assert np.allclose(m[~np.eye(4, dtype=bool)], 2.0 / 24, atol=1e-13)
        assert np.allclose(np.diag(m), 2.0 / 8, atol=1e-13)
    else:
        assert np.allclose(m, 2.0 * (1 + np.eye(count)) / (count * (count + 1)), atol=1e-13)
    worth = bodies.mass_properties(
        [model.nodes[n].at for n in body.carriers], {(i, j): 6 * m[i, j] for i in range(count) for j in range(i + 1, count)},
        np.diag(m) - 2 * (m.sum(axis=1) - np.diag(m)),
    )  # fmt: skip
    same(worth, bodies.properties_of(model, "b"), 1e-12)


def pendulum(points, nodes=("O",)):
    shape = bodies.box_properties(
        (0.2, 0.3, 0.5), mass=2.0, at=(0.1, 0.2, -0.4), axes=np.linalg.qr(np.arange(9).reshape(3, 3) ** 1.5 + np.eye(3))[0]
    )
    return bodies.rigid(GROUND, "b", shape, nodes=nodes, points=points)


@pytest.mark.slow
def test_motion_does_not_depend_on_the_points():
    """A box that swings about one of its points: positions of a material point, forces on the ground."""
    rng = np.random.default_rng(4)
    base = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) * 0.3
    found = []
    for k in range(3):
        points = None if k == 0 else base + rng.uniform(-0.1, 0.1, (4, 3))
        model = pendulum(points, {"O": None, "P": (0.4, 0.5, 0.1)})
        run = kt.dynamics.simulate(model, t_end=1.0, method=kt.DOP853(rtol=1e-11, atol=1e-11))
        found.append((run.motion.position.sel(node="P").values[-1], run.forces.data["reaction"].values[-1, 0]))
    for place, force in found[1:]:
        assert np.abs(place - found[0][0]).max() < 1e-9
        assert np.abs(force - found[0][1]).max() < 1e-7


def test_nodes_that_are_there_carry_it():
    start = kt.Model(nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "D": (0, 0, 1), "E": (0.1, 0, 0)})
    made = bodies.rigid(start, "b", bodies.sphere_properties(0.3, mass=1.0), nodes=list("AEBCD"))
    assert list(made.nodes) == list(start.nodes)
    assert set(made.bodies["b"].carriers) == set("ABCD") or set(made.bodies["b"].carriers) == set("EBCD")


def test_flat_bodies_with_joints_in_their_plane_get_an_apex():
    made = bodies.flat(GROUND, "b", (1, 2), mass=2.0, nodes=["O"])
    assert "b.apex" in made.nodes
    assert kt.kinematics.mobility(made).degrees_of_freedom == 3


@pytest.mark.slow
def test_planar_bodies():
    start = kt.Model(nodes={"A": (0, 0)}, fixed=["A"], gravity=(0, -9.81))
    made = bodies.rigid(start, "b", mass=2.0, center=(0.5, 0.1), inertia=0.18, nodes=["A"])
    assert [node.at for name, node in made.nodes.items() if name != "A"] == [(0.5 - 0.3, 0.1), (0.5 + 0.3, 0.1)]
    lin = kt.dynamics.linearise(bodies.rigid(start, "b", mass=2.0, center=(0, -0.5), inertia=0.18, nodes=["A"]))
    assert abs(lin.angular_frequency.item() - np.sqrt(2 * 9.81 * 0.5 / (0.18 + 2 * 0.25))) < 1e-12


def test_faults_of_the_library():
    with pytest.raises(kt.InputError, match="There is a body called 'b'"):
        bodies.sphere(bodies.sphere(GROUND, "b", 1.0, mass=1.0), "b", 1.0, mass=1.0)
    with pytest.raises(kt.InputError, match="No node called 'X'"):
        bodies.sphere(GROUND, "b", 1.0, mass=1.0, nodes=["X"])
    with pytest.raises(kt.InputError, match="is one node"):
        bodies.rigid(GROUND, "b", nodes=["O"])
    with pytest.raises(kt.InputError, match="it is a point"):
        bodies.rigid(GROUND, "b", mass=1.0, center=(0, 0, 0), inertia=(0, 0, 0))
    with pytest.raises(kt.InputError, match="either the mass"):
        bodies.sphere(GROUND, "b", 1.0)
    flat, line = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]
    for points, where, mend in ((flat, "in one plane", "Move one of them"), (line, "on one line", "Move two of them")):
        for make in (
            lambda: bodies.bar_masses(points, 1.0, (0, 0, 0), (1, 1, 1)),  # noqa: B023
            lambda: bodies.rigid(GROUND, "b", mass=1.0, center=(0, 0, 0), inertia=(1, 1, 1), points=points),  # noqa: B023
            lambda: bodies.tetrahedron_properties(points, mass=1.0),  # noqa: B023
        ):
            with pytest.raises(kt.InputError, match=rf"lie {where}\. {mend}, e\.g\. to \("):
                make()


MASS = {"mass": 1.0, "center": (0, 0, 0)}


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: bodies.box(GROUND, "b", (1, 1, 1), mass=-1.0), "Body 'b' has the mass -1 kg. Give 0 or more; a hole is"),
        (lambda: bodies.bar_masses(np.eye(4)[:, :3], -1.0, (0, 0, 0), (1, 1, 1)), "has the mass -1 kg"),
        (lambda: bodies.rigid(GROUND, "b", inertia=(1, 1, 3), **MASS), r"impossible: .*\(1, 1, 3 kg m\^2: 3 > 2\)"),
        (lambda: bodies.bar_masses(np.eye(4)[:, :3], 1.0, (0, 0, 0), (1, 1, 3)), "impossible: its largest principal moment"),
        (lambda: bodies.rigid(GROUND, "b", inertia=(-1, 1, 1), **MASS), "negative principal moment: -1, 1, 1"),
        (
            lambda: bodies.rigid(GROUND, "b", inertia=((1, 0.2, 0), (0.1, 1, 0), (0, 0, 1)), **MASS),
            "1,2 and 2,1 are 0.2",
        ),
        (lambda: bodies.rigid(GROUND, "b", inertia="big", **MASS), "inertia of body 'b' is 'big', which is no number"),
        (
            lambda: bodies.box(GROUND, "b", (1, 1, 1), mass=1.0, axes=np.diag([1, 1, -1])),
            r"left-handed .*z: ",
        ),
        (lambda: bodies.box(GROUND, "b", (1, 1, 1), mass=1.0, axes=np.eye(3) + 0.1), "miss unit vectors at right angles by 0"),
        (lambda: bodies.box_properties((1, 1, 1), mass=1.0).moved(axes=np.eye(2)), r"has the shape \(2, 2\). Give 3 rows"),
        (
            lambda: bodies.combined(bodies.sphere_properties(1.0, mass=1.0), bodies.sphere_properties(0.5, mass=-1.0)),
            "1 \\+ -1 = 0 kg",
        ),
        (lambda: bodies.mass_properties([(0, 0, 0), (1, 0, 0)], {(0, 2): 1.0}), "Bar 0-2 is between no two of the 2 points"),
        (
            lambda: bodies.rigid(GROUND, "b", inertia=(1, 1, 1), points=[(0, 0), (1, 0)], **MASS),
            r"\(2, 2\). Give rows of 3",
        ),
        (lambda: bodies.rigid(GROUND, "b", inertia=(1, 1, 1), points=np.eye(5)[:, :3], **MASS), "names 5. Give 4"),
        (
            lambda: bodies.rigid(GROUND, "b", inertia=(1, 1, 1), points=np.eye(3)[[0, 1, 1, 2]], **MASS),
            "b.2 and b.3 stand at",
        ),
    ],
)
def test_what_no_mass_and_no_frame_can_be_is_told(make, words):
    with pytest.raises(kt.InputError, match=words):
        make()


@pytest.mark.parametrize("inertia", [[0.02, 0.03, 0.04], np.diag([0.02, 0.03, 0.04]).tolist(), np.diag([0.02, 0.03, 0.04])])
def test_mass_properties_take_moments_and_lists(inertia):
    given = kt.library.bodies.MassProperties(mass=2.0, center=[0, 0, 0.1], inertia=inertia)
    ground = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    found = kt.library.bodies.properties_of(kt.library.bodies.rigid(ground, "body", given, nodes=["O"]), "body")
    np.testing.assert_allclose(found.inertia, np.diag([0.02, 0.03, 0.04]), atol=1e-15)
    np.testing.assert_allclose(given.moved([0, 0, 0.1]).center, [0, 0, 0.2], atol=1e-15)


@pytest.mark.parametrize("axial", [2e-3, 1e-6, 1e-9])
def test_a_needle_is_carried_by_a_tetrahedron_of_some_width(axial):
    """Its moment of inertia about its own line is in the mass matrix, not in the places of its carriers."""
    ground = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    model = kt.library.bodies.rigid(ground, "rod", mass=0.3, center=(0.5, 0, 0), inertia=(axial, 0.025, 0.025), nodes=["O"])
    there = kt.library.bodies.properties_of(model, "rod")
    np.testing.assert_allclose(there.inertia, np.diag([axial, 0.025, 0.025]), atol=1e-15)
    points = np.array([model.nodes[name].at for name in model.bodies["rod"].carriers])
    assert np.ptp(points, axis=0).min() > 0.09 * np.ptp(points, axis=0).max()
