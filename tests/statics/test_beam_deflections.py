"""Rotations of nodes and deflections between the nodes of beams: closed forms, and one beam against many."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.rotations import rotations

E, I, A, L, Q = 200e9, 1.3e-8, 2e-4, 2.0, -120.0
STEEL = kt.Material(E=E, density=0.0, poisson=0.3)
SECTION = kt.General(area=A, I2=2.1e-8, I3=I, c2=0.01, c3=0.01, J=3e-8)
XI = np.linspace(0.0, 1.0, 9)
X = L * XI


def plane(angle=0.0, **more):
    """One beam from the origin, turned by an angle."""
    given = {"clamped": ["A"], "section": SECTION, "material": STEEL}
    return kt.Model(nodes={"A": (0, 0), "B": (L * np.cos(angle), L * np.sin(angle))}, beams={"b": ("A", "B")}, **given | more)


def across(angle, force):
    """A load in the model's axes that is across the beam."""
    return (-force * np.sin(angle), force * np.cos(angle))


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.5])
def test_a_cantilever_under_a_uniform_load(angle):
    model = plane(angle, loads={"q": kt.MemberLoad(member="b", force=across(angle, Q))})
    linear = kt.statics.linear(model)
    found = kt.strength.beams(model, linear, stations=XI)
    w = Q * X**2 * (6 * L**2 - 4 * L * X + X**2) / (24 * E * I)
    np.testing.assert_allclose(found.displacement[0], np.outer(w, across(angle, 1.0)), atol=1e-12 * abs(w).max())
    np.testing.assert_allclose(found.deflection[0, :, 0], w - XI * w[-1], atol=1e-12 * abs(w).max())
    assert linear.node_rotation.sel(frame="B", about="z").item() == pytest.approx(Q * L**3 / (6 * E * I), rel=1e-12)
    assert linear.node_rotation.sel(frame="A", about="z").item() == 0.0


def test_a_simple_beam_under_a_uniform_load_and_its_turns_at_the_supports():
    model = plane(clamped=[], fixed={"A": "xy", "B": "y"}, loads={"q": kt.MemberLoad(member="b", force=(0, Q))})
    linear = kt.statics.linear(model)
    found = kt.strength.beams(model, linear, stations=XI)
    np.testing.assert_allclose(
        found.displacement[0, :, 1], Q * X * (L**3 - 2 * L * X**2 + X**3) / (24 * E * I), rtol=1e-10, atol=1e-15
    )
    np.testing.assert_allclose(linear.node_rotation[:, 0], [Q * L**3 / (24 * E * I), -Q * L**3 / (24 * E * I)], rtol=1e-12)


def test_shear_adds_its_part():
    """5 q L^4/(384 E I) + q L^2/(8 G A_s) in the middle of a simple beam (Timoshenko)."""
    area = A * 5 / 6
    soft = kt.General(area=A, I2=I, I3=I, c2=0.01, c3=0.01, J=3e-8, A2=area, A3=area)
    model = plane(clamped=[], fixed={"A": "xy", "B": "y"}, section=soft, loads={"q": kt.MemberLoad(member="b", force=(0, Q))})
    found = kt.strength.beams(model, kt.statics.linear(model), stations=[0.5]).displacement[0, 0, 1].item()
    G = E / 2.6
    assert found == pytest.approx(5 * Q * L**4 / (384 * E * I) + Q * L**2 / (8 * G * area), rel=1e-12)


def test_a_rod_that_hangs_stretches_under_its_own_weight():
    heavy = kt.Material(E=1e6, density=1000.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, -L)},
        beams={"b": ("A", "B")},
        clamped=["A"],
        section=SECTION,
        material=heavy,
        gravity=(0, -9.81),
    )
    found = kt.strength.beams(model, kt.statics.linear(model), stations=XI).displacement[0, :, 1]
    np.testing.assert_allclose(found, -1000 * 9.81 * (L * X - X**2 / 2) / 1e6, rtol=1e-12, atol=1e-15)


LOADS = {
    "part": {"start": 0.3, "end": 1.5},
    "triangle": {"shape": (0, 1)},
    "part of a trapezoid": {"start": 0.25, "end": 1.75, "shape": (0.5, 2.0)},
}


@pytest.mark.parametrize("case", LOADS)
def test_one_beam_deflects_as_many_do(case):
    """The nodes of a fine mesh are exact, so their displacements are those between the nodes of a coarse one (load across)."""
    share = {"start": 0.0, "end": L, "shape": (1.0, 1.0), **LOADS[case]}
    load = kt.MemberLoad(member="b", force=across(0.4, Q), **LOADS[case])
    model = plane(0.4, loads={"q": load, "P": kt.NodalForce(node="B", force=(5, -40))})
    found = kt.strength.beams(model, kt.statics.linear(model), stations=XI)
    count = 40
    s = np.linspace(0, L, count + 1)
    first, last = share["shape"]

    def intensity(at):
        return first + (last - first) * (at - share["start"]) / (share["end"] - share["start"])

    loads = {
        f"q{i}": kt.MemberLoad(member=f"b{i}", force=across(0.4, Q), shape=(intensity(s[i]), intensity(s[i + 1])))
        for i in range(count)
        if share["start"] - 1e-9 <= s[i] and s[i + 1] <= share["end"] + 1e-9
    }
    fine = kt.Model(
        nodes={f"n{i}": (s[i] * np.cos(0.4), s[i] * np.sin(0.4)) for i in range(count + 1)},
        beams={f"b{i}": (f"n{i}", f"n{i + 1}") for i in range(count)},
        clamped=["n0"], section=SECTION, material=STEEL,
        loads={**loads, "P": kt.NodalForce(node=f"n{count}", force=(5, -40))},
    )  # fmt: skip
    nodes = kt.statics.linear(fine).displacement.sel(node=[f"n{i}" for i in range(0, count + 1, count // 8)])
    np.testing.assert_allclose(found.displacement[0], nodes, atol=1e-9 * float(abs(nodes).max()))


def test_a_frame_in_space_deflects_and_turns_as_a_fine_one():
    """Bending in both planes, torsion and tension."""

    def frame(count):
        corner, end = np.array([1.0, 0.4, 0.3]), np.array([1.2, 1.5, -0.2])
        nodes, beams, loads = {"A": (0, 0, 0)}, {}, {"P": kt.NodalForce(node=f"c{count}", force=(20, 10, -50))}
        last = "A"
        for leg, (a, b) in zip("bc", ((np.zeros(3), corner), (corner, end)), strict=True):
            for i in range(1, count + 1):
                name = f"{leg}{i}"
                nodes[name] = tuple(a + (b - a) * i / count)
                beams[name] = {"ends": (last, name), "orientation": (0, 0, 1)}
                loads[name] = kt.MemberLoad(member=name, force=(3, -20, -60))
                last = name
        return kt.Model(nodes=nodes, beams=beams, clamped=["A"], section=SECTION, material=STEEL, loads=loads)

    coarse, fine = frame(1), frame(4)
    one, many = kt.statics.linear(coarse), kt.statics.linear(fine)
    for leg in "bc":
        found = kt.strength.beams(coarse, one, stations=[0.25, 0.5, 0.75]).displacement.sel(beam=f"{leg}1")
        nodes = many.displacement.sel(node=[f"{leg}{i}" for i in (1, 2, 3)])
        np.testing.assert_allclose(found, nodes, rtol=1e-8, atol=1e-12)
        np.testing.assert_allclose(
            one.node_rotation.sel(frame=f"{leg}1"), many.node_rotation.sel(frame=f"{leg}4"), rtol=1e-8, atol=1e-12
        )


def test_a_moment_rolls_a_beam_up_by_its_rotation():
    """M L/(E I), however large; the equilibrium keeps it from -pi to pi."""
    moment = 2.2 * E * I / L
    model = plane(loads={"M": kt.BodyCouple(body="B", moment=moment)})
    count = 16
    fine = kt.Model(
        nodes={f"n{i}": (L * i / count, 0) for i in range(count + 1)},
        beams={f"b{i}": (f"n{i}", f"n{i + 1}") for i in range(count)},
        clamped=["n0"], section=SECTION, material=STEEL, loads={"M": kt.BodyCouple(body=f"n{count}", moment=moment)},
    )  # fmt: skip
    found = kt.statics.equilibrium(fine)
    np.testing.assert_allclose(found.node_rotation[:, 0], 2.2 * np.arange(count + 1) / count, rtol=2e-3, atol=1e-12)
    small = model.with_(loads={"M": kt.BodyCouple(body="B", moment=1e-4 * moment)})
    linear, exact = kt.statics.linear(small), kt.statics.equilibrium(small)
    np.testing.assert_allclose(exact.node_rotation, linear.node_rotation, rtol=1e-6)
    places = [kt.strength.beams(small, one, stations=XI).displacement[0, :, 1] for one in (linear, exact)]
    np.testing.assert_allclose(places[0], 2.2e-4 * X**2 / (2 * L), rtol=1e-10, atol=1e-15)
    np.testing.assert_allclose(places[1], places[0], rtol=1e-4, atol=1e-12)


def test_a_simulation_has_the_rotations_of_a_swinging_beam():
    heavy = kt.Material(E=E, density=7800.0)
    swing = kt.Model(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0)}, beams={"b": ("A", "B")}, fixed=["A"], section=kt.Rod(diameter=0.05),
        material=heavy, gravity=(0, 0, -9.81),
    )  # fmt: skip
    run = kt.dynamics.simulate(swing, t_end=0.4, samples=9)
    chord = (run.motion.position.sel(node="B") - run.motion.position.sel(node="A")).values
    angle = np.arctan2(-chord[:, 2], chord[:, 0])
    np.testing.assert_allclose(run.motion.node_rotation.sel(frame="A", about="y"), angle, atol=2e-4)
    assert angle[-1] > 0.5
    still = kt.statics.linear(swing.with_(clamped=["A"]))
    np.testing.assert_allclose(
        still.node_rotation.sel(frame="B", about="y").item(),
        7800 * 9.81 * np.pi / 4 * 0.05**2 / (6 * E * np.pi / 64 * 0.05**4),
        rtol=1e-9,
    )


def test_beams_that_keep_their_shape_have_no_deflection():
    model = plane(
        clamped=[],
        fixed=["A"],
        loads={"P": kt.NodalForce(node="B", force=(0, -1))},
        drives={"d": {"kind": "coordinate", "node": "B", "axis": "y"}},
    )
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"d": (0.0, 0.2)}, duration=1.0), samples=3)
    found = kt.strength.beams(model, kt.dynamics.inverse(model, motion), stations=[0.5])
    assert np.isnan(found.displacement).all()


@pytest.mark.parametrize("dim", [2, 3])
def test_a_motion_without_a_sample_has_no_rotations(dim):
    """Also where from the first instant on the lengths cannot be closed."""
    model = kt.Model(
        nodes={"A": (0.0,) * dim, "B": (1.0, *(0.0,) * (dim - 1))}, clamped=["A"], beams={"arm": ("A", "B")},
        section=kt.Rod(diameter=0.01), material="steel_s235",
    )  # fmt: skip
    system = compile(model)
    assert rotations(system, np.zeros((0, len(system.nodes), 3))).shape == (0, 2, 1 if dim == 2 else 3)
