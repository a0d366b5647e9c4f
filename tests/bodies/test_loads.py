"""Loads on bodies: their resultants, their work, what they do to motion, equilibrium and stiffness."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import unit_loads_of

bodies = kt.library.bodies
seeds = st.integers(0, 2**32 - 1)
CORNERS = {"O": (0.0, 0.0, 0.0), "X": (1.0, 0.1, 0.0), "Y": (0.0, 1.2, 0.0), "Z": (0.2, 0.0, 1.0)}
FOUR = tuple(CORNERS)
AT, F, M = (0.4, -0.3, 0.7), (1.0, 2.0, -3.0), (0.5, -1.0, 2.0)


def space(loads, nodes=FOUR, **body):
    return compile(kt.Model(nodes=CORNERS, bodies={"b": kt.Body(nodes=nodes, mass=1.0, **body)}, loads={"l": loads}))


def acting(system, amounts, x):
    """Nodal forces (n, 3) of the load at positions x (n, 3)."""
    found = np.zeros_like(x)
    for amount, push in zip(amounts, unit_loads_of(system, "l"), strict=True):
        np.add.at(found, push.nodes, amount * push.forces(x[push.nodes]))
    return found


def moved(rng, x):
    turn = Rotation.random(random_state=int(rng.integers(2**31))).as_matrix()
    shift = rng.normal(size=3)
    return turn, shift, x @ turn.T + shift


@pytest.mark.slow
@given(seeds, st.booleans(), st.sampled_from([4, 3]))
def test_a_force_at_a_point(seed, follows, count):
    at = AT if count == 4 else tuple(np.array([0.3, 0.3, 0.4]) @ np.array(list(CORNERS.values())[:3]))
    system = space(kt.BodyForce(body="b", at=at, force=F, follows=follows), FOUR[:count])
    turn, shift, x = moved(np.random.default_rng(seed), system.x0)
    f = acting(system, F, x)
    wanted = turn @ F if follows else np.array(F)
    place = turn @ at + shift
    assert np.abs(f.sum(axis=0) - wanted).max() < 1e-12
    assert np.abs(np.cross(x - place, f).sum(axis=0)).max() < 1e-11


@given(seeds, st.booleans(), st.sampled_from([4, 3]))
def test_a_couple_and_its_power(seed, follows, count):
    system = space(kt.BodyCouple(body="b", moment=M, follows=follows), FOUR[:count])
    rng = np.random.default_rng(seed)
    turn, _, x = moved(rng, system.x0)
    f, wanted = acting(system, M, x), turn @ M if follows else np.array(M)
    w, v = rng.normal(size=(2, 3))
    assert np.abs(f.sum(axis=0)).max() < 1e-11
    assert np.abs(np.cross(x, f).sum(axis=0) - wanted).max() < 1e-10
    assert abs(np.sum(f * (v + np.cross(w, x))) - wanted @ w) < 1e-10


@given(seeds, st.booleans(), st.sampled_from([2, 3]))
def test_planar_loads(seed, follows, count):
    nodes = {"A": (0.0, 0.0), "B": (1.0, 0.5), "C": (-0.2, 0.8)}
    body = kt.Body(nodes=tuple(nodes)[:count], mass=1.0)
    at, force = np.array([0.3, 0.9, 0.0]), np.array([2.0, -1.0, 0.0])
    load = kt.BodyForce(body="b", at=tuple(at[:2]), force=tuple(force[:2]), follows=follows)
    loads = {"l": load, "m": kt.BodyCouple(body="b", moment=1.5)}
    system = compile(kt.Model(nodes=nodes, bodies={"b": body}, loads=loads))
    rng = np.random.default_rng(seed)
    turn = Rotation.from_rotvec([0, 0, rng.uniform(-3, 3)]).as_matrix()
    shift = np.append(rng.normal(size=2), 0)
    x = system.x0 @ turn.T + shift
    f = acting(system, force[:2], x)
    assert np.abs(f.sum(axis=0) - (turn @ force if follows else force)).max() < 1e-13
    assert np.abs(np.cross(x - (turn @ at + shift), f).sum(axis=0)).max() < 1e-12
    (couple,) = unit_loads_of(system, "m")
    f = couple.forces(x[couple.nodes])
    assert np.abs(f.sum(axis=0)).max() < 1e-13
    assert abs(np.cross(x[couple.nodes], f).sum(axis=0)[2] - 1.0) < 1e-12


def test_force_beside_a_bar_of_the_plane():
    """Fp = ((1 - xi) Fx - eta Fy, eta Fx + (1 - xi) Fy), Fq = (xi Fx + eta Fy, -eta Fx + xi Fy)."""
    load = kt.BodyForce(body="b", at=(0.3 * 2.0, 0.2 * 2.0), force=(3.0, 4.0))
    system = compile(kt.Model(nodes={"P": (0, 0), "Q": (2, 0)}, bars={"b": ("P", "Q")}, loads={"l": load}))
    wanted = [[0.7 * 3 - 0.2 * 4, 0.2 * 3 + 0.7 * 4, 0], [0.3 * 3 + 0.2 * 4, -0.2 * 3 + 0.3 * 4, 0]]
    assert np.abs(acting(system, (3.0, 4.0), system.x0) - wanted).max() < 1e-14


def test_pressure():
    faces = [("O", "Y", "X"), ("O", "X", "Z"), ("O", "Z", "Y"), ("X", "Y", "Z")]
    loads = {"".join(face): kt.Pressure(face=face, pressure=5.0) for face in faces}
    system = compile(kt.Model(nodes=CORNERS, bodies={"b": kt.Body(nodes=FOUR, mass=1.0)}, loads=loads))
    total = np.zeros((4, 3))
    for name, face in zip(loads, faces, strict=True):
        (push,) = unit_loads_of(system, name)
        f = 5.0 * push.forces(system.x0[push.nodes])
        a, b, c = (np.array(CORNERS[node]) for node in face)
        assert np.abs(f.sum(axis=0) + 5.0 * np.cross(b - a, c - a) / 2).max() < 1e-14
        np.add.at(total, push.nodes, f)
    assert np.abs(total.sum(axis=0)).max() < 1e-14
    assert np.abs(np.cross(system.x0, total).sum(axis=0)).max() < 1e-14
    assert (total @ np.ones(3)).max() > 0  # it presses inwards: the corner O is pushed into the body


def test_pressure_on_an_edge_of_the_plane():
    load = kt.Pressure(face=("A", "B"), pressure=3.0, depth=0.5)
    system = compile(kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, bars={"b": ("A", "B")}, loads={"l": load}))
    assert np.abs(acting(system, (3.0,), system.x0) - [[0, 1.5, 0], [0, 1.5, 0]]).max() < 1e-15


@pytest.mark.parametrize(
    "load",
    [
        kt.BodyForce(body="b", at=AT, force=F, follows=True), kt.BodyCouple(body="b", moment=M),
        kt.BodyCouple(body="b", moment=M, follows=True), kt.Pressure(face=("X", "Y", "Z"), pressure=2.0),
    ],
    ids=["force", "couple", "following_couple", "pressure"],
)  # fmt: skip
def test_tangents(load):
    """Against central differences, and second order of these."""
    system = space(load)
    rng = np.random.default_rng(2)
    for push in unit_loads_of(system, "l"):
        r, d = system.x0[push.nodes], rng.normal(size=(len(push.nodes), 3))
        wanted = push.tangent(r) @ d.reshape(-1)
        errors = [
            np.abs(((push.forces(r + h * d) - push.forces(r - h * d)) / (2 * h)).reshape(-1) - wanted).max()
            for h in (1e-2, 1e-3)
        ]
        assert errors[1] < 1e-4
        assert errors[1] < 0.02 * errors[0] or errors[0] < 1e-11


def loaded_box():
    start = kt.Model(nodes={"O": (0.0, 0.0, 0.0)}, fixed=["O"], gravity=(0, 0, -9.81))
    shape = bodies.box_properties((1, 2, 3), mass=2.0, at=(0.3, 0.2, 0.1))
    loads = {
        "push": kt.BodyForce(body="b", at=(0.5, 0.1, 0.9), times=(0, 0.1, 0.3), forces=((0, 0, 0), (1, 2, 3), (-3, 2, 1))),
        "jet": kt.BodyForce(body="b", force=(1, 2, 3), follows=True),
        "twist": kt.BodyCouple(body="b", moment=(1, -2, 3)),
        "motor": kt.BodyCouple(body="b", times=(0, 0.2), moments=((0, 0, 0), (1, -2, 3)), follows=True),
        "wind": kt.Pressure(face=("b.1", "b.2", "b.3"), pressure=10.0),
    }
    return bodies.rigid(start, "b", shape, nodes=["O"]).with_(loads=loads)


@pytest.mark.slow
def test_forward_and_inverse_dynamics_agree():
    model = loaded_box()
    run = kt.dynamics.simulate(model, t_end=0.4)
    again = kt.dynamics.inverse(model, run.motion, static=False)
    size = float(abs(run.forces.whole["member_force"]).max())
    assert float(abs(again.whole["member_force"] - run.forces.whole["member_force"]).max()) < 1e-9 * size
    assert float(abs(run.forces.data["energy_balance"]).max()) < 1e-9 * float(abs(run.forces.data["power"]).max())
    labelled = kt.dynamics.newton_euler(model, run.motion, again, time=0.2)
    assert labelled.residual < 1e-9 * labelled.largest


def pendulum(**loads):
    nodes = {"A": (0.0, 0.0), "B": (0.0, -2.0)}
    return kt.Model(nodes=nodes, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), mass=3.0)}, gravity=(0, -9.81), loads=loads)


@pytest.mark.slow
def test_a_couple_turns_a_pendulum_and_leaves_its_stiffness():
    model = pendulum(m=kt.BodyCouple(body="b", moment=3.0 * 9.81 * 1.0 * 0.5))
    found = kt.statics.equilibrium(model)
    assert np.abs(found.position.sel(node="B").values - (2 * 0.5, -2 * np.sqrt(0.75))).max() < 1e-9
    lin = kt.dynamics.linearise(model, found, dofs="b.angle")
    assert abs(lin.angular_frequency.item() ** 2 - 1.5 * 9.81 / 2 * np.sqrt(0.75)) < 1e-7


@pytest.mark.parametrize("follows", [True, False])
def test_a_force_that_follows_has_another_stiffness_than_one_that_does_not(follows):
    """Along the bar, at its end: a dead force stiffens by F l, one that follows never has a moment about the pin."""
    model = pendulum(f=kt.BodyForce(body="b", at=(2.0, 0.0), force=(0.0, -20.0), follows=follows))
    lin = kt.dynamics.linearise(model, dofs="b.angle")
    wanted = (3.0 * 9.81 * 1.0 + (0.0 if follows else 20.0 * 2.0)) / (3.0 * 4 / 3)
    assert abs(lin.angular_frequency.item() ** 2 - wanted) < 1e-11


@pytest.mark.parametrize(
    ("load", "message"),
    [
        ({"body": "c", "force": (1, 0, 0)}, "no body called 'c'"),
        ({"body": "b", "force": (1, 0)}, "has 2 components"),
        ({"body": "b", "moment": 1.0}, "is one number in a model of dimension 3"),
        ({"body": "b"}, "has neither a force nor a table of forces"),
        ({"body": "b", "moment": (1, 0, 0), "moments": ((1, 0, 0), (1, 0, 0)), "times": (0, 1)}, "has both a moment"),
        ({"face": ("O", "X"), "pressure": 1.0}, "names 2 nodes"),
        ({"face": ("O", "X", "W"), "pressure": 1.0}, "no node called 'W'"),
        ({"body": "rod", "moment": (1, 0, 0)}, "is a couple on a rod of two nodes"),
        ({"body": "plate", "force": (1, 0, 0), "at": (0, 0, 0.5)}, "is 0.5 m off the plane"),
    ],
)  # fmt: skip
def test_faults(load, message):
    carried = {"b": kt.Body(nodes=FOUR), "rod": kt.Body(nodes=FOUR[:2]), "plate": kt.Body(nodes=FOUR[:3])}
    with pytest.raises(kt.ModelError) as error:
        kt.Model(nodes=CORNERS, bodies=carried, loads={"l": load})
    assert len(error.value.faults) == 1
    assert error.value.faults[0].path[:2] == ("loads", "l")
    assert message in str(error.value)


@pytest.mark.slow
def test_followers_feed_energy():
    """A free body under a couple spins up: the guard against energy from nowhere knows where it comes from."""
    start = kt.Model(nodes={"G": (9.0, 9.0, 9.0)}, fixed=["G"])
    model = bodies.sphere(start, "b", 0.5, mass=2.0).with_(loads={"m": kt.BodyCouple(body="b", moment=(0, 0, 0.2))})
    run = kt.dynamics.simulate(model, t_end=1.0)
    assert abs(run.data["kinetic_energy"].values[-1] / (0.5 * 0.2**2 / 0.2) - 1) < 1e-6
