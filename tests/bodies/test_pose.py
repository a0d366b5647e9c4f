"""Poses, joint angles and reactions against closed forms of rigid bodies."""

import itertools

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.errors import InputError

seeds = st.integers(0, 2**32 - 1)
G = np.array([0.3, -0.7, -9.81])


def spinning(model, t, axis, angle, rate, centre):
    """Motion of all nodes of a model as one body: `angle` about an axis, and the path of the origin with two rates."""
    at = np.array([node.at for node in model.nodes.values()], float)
    w, alpha = rate[0][:, None] * axis, rate[1][:, None] * axis
    r = np.stack([Rotation.from_rotvec(angle[:, None] * axis).apply(point) for point in at], axis=1)
    turned = np.cross(w[:, None], r)
    x, v = r + centre[0][:, None], turned + centre[1][:, None]
    a = np.cross(alpha[:, None], r) + np.cross(w[:, None], turned) + centre[2][:, None]
    return kt.kinematics.from_arrays(model, t, x, v, a), w, alpha


def random_motion(rng, model, t):
    axis = rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    rate, growth = rng.uniform(2, 4), rng.uniform(0.2, 1)
    angle = rate * t + 0.5 * growth * t**2
    speed = rng.normal(size=3)
    path = (np.outer(np.sin(t), speed), np.outer(np.cos(t), speed), np.outer(-np.sin(t), speed))
    return axis, angle, path, *spinning(model, t, axis, angle, (rate + growth * t, growth + 0 * t), path)


def random_body(rng, **fields):
    names = ("A", "B", "C", "D")
    points = np.array([(0, 0, 0), (1, 0.1, 0), (0.2, 0.9, 0), (0.3, 0.2, 1.1)]) + rng.uniform(-0.1, 0.1, (4, 3))
    center = rng.normal(size=3)
    body = kt.Body(nodes=names, mass=2.0, center=tuple(center), inertia=(1.0, 1.2, 1.5))
    nodes = {name: tuple(map(float, p)) for name, p in zip(names, points, strict=True)}
    return kt.Model(nodes=nodes, bodies={"b": body}, gravity=tuple(G), **fields), center


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(seeds)
@example(1418)  # passes a full turn by 4e-4 rad
def test_pose_is_the_turn_that_made_the_motion(seed):
    rng = np.random.default_rng(seed)
    model, center = random_body(rng)
    t = np.linspace(0, 5, 201)
    axis, angle, path, motion, w, alpha = random_motion(rng, model, t)
    found = kt.kinematics.pose(model, motion, "b")
    turn = Rotation.from_rotvec(angle[:, None] * axis)
    assert np.abs(found.rotation_matrix.values - turn.as_matrix()).max() < 1e-13
    off = np.abs(found.rotation_vector.values - angle[:, None] * axis).max(axis=1)
    assert (off <= 1e-12 * (1 + angle / np.maximum(np.abs(np.sin(angle / 2)), 1e-12))).all()  # full turns have no axis
    assert np.abs(found.position.values - turn.apply(center) - path[0]).max() < 1e-12
    assert np.abs(found.angular_velocity.values - w).max() < 1e-12 * np.abs(w).max()
    assert np.abs(found.angular_acceleration.values - alpha).max() < 1e-11 * np.abs(w).max() ** 2
    q = found.quaternion.values
    assert np.einsum("tc,tc->t", q[1:], q[:-1]).min() > 0
    again = Rotation.from_euler("ZYX", found.euler.values).as_matrix()
    assert np.abs(again - turn.as_matrix()).max() < 1e-12


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(seeds)
def test_seen_from_itself_a_body_rests_and_rates_are_derivatives(seed):
    rng = np.random.default_rng(seed)
    model, _ = random_body(rng)
    t = np.linspace(0, 1, 2001)
    motion = random_motion(rng, model, t)[3]
    own = kt.kinematics.pose(model, motion, "b", seen_from=("A", "B", "C"))
    assert np.abs(own.velocity.values).max() < 1e-11
    assert np.abs(own.acceleration.values).max() < 1e-10
    one = kt.kinematics.pose(model, motion, "b")
    # d(quaternion)/dt = (0, w) q / 2: central differences, order 2
    step, q = t[1] - t[0], one.quaternion.values
    slope = (q[2:] - q[:-2]) / (2 * step)
    w = one.angular_velocity.values[1:-1]
    scalar = -0.5 * np.einsum("tc,tc->t", w, q[1:-1, 1:])
    vector = 0.5 * (q[1:-1, :1] * w + np.cross(w, q[1:-1, 1:]))
    assert np.abs(slope - np.column_stack([scalar, vector])).max() < 5 * step**2 * np.abs(w).max() ** 3


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(seeds)
def test_reactions_are_those_of_newton_and_euler_for_any_choice_of_points(seed):
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 1, 5)
    held = {"A": "xyz", "B": "yz", "C": "z"}
    model, center = random_body(rng, fixed=held)
    state = rng.integers(2**31)
    axis, angle, path, motion, w, alpha = random_motion(np.random.default_rng(state), model, t)
    forces = kt.dynamics.inverse(model, motion)
    found = kt.dynamics.joint_reaction(model, forces, "b", ["A", "B", "C", "D"], point="A")
    R = Rotation.from_rotvec(angle[:, None] * axis).as_matrix()
    inertia = R @ np.diag([1.0, 1.2, 1.5]) @ R.transpose(0, 2, 1)
    arm = np.einsum("tij,j->ti", R, center)
    a = path[2] + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
    force = 2.0 * (a - G)
    about = motion.data["position"].sel(node="A").values
    h = np.einsum("tij,tj->ti", inertia, w)
    moment = np.einsum("tij,tj->ti", inertia, alpha) + np.cross(w, h) + np.cross(arm + path[0] - about, force)
    scale = np.abs(moment).max()
    assert np.abs(found.force.values - force).max() < 1e-11 * scale
    assert np.abs(found.moment.values - moment).max() < 1e-11 * scale
    turned = kt.dynamics.joint_reaction(model, forces, "b", ["A", "B", "C", "D"], point="A", frame="b")
    assert np.abs(np.einsum("tij,tj->ti", R, turned.moment.values) - found.moment.values).max() < 1e-11 * scale


def two_arms(carriers=None, mid=(0.5, 0.1)):
    """A double pendulum of two planar bodies; the second hangs on the first at B."""
    nodes = {"O": (0, 0), "B": (1, 0), "C": (2, 0.3), "M": mid}
    bodies = {
        "one": kt.Body(nodes=("O", "B", "M"), mass=2.0, center=(0.4, 0.1), inertia=0.3, carriers=carriers),
        "two": kt.Body(nodes=("B", "C"), mass=1.0, center=(1.6, 0.2), inertia=0.2),
    }
    push = kt.BodyForce(body="one", at=(0.9, 0.4), force=(3.0, 8.0))
    return kt.Model(nodes=nodes, bodies=bodies, fixed=["O"], gravity=(0, -9.81), loads={"push": push})


@pytest.mark.slow
def test_reactions_do_not_know_how_mass_was_spread():
    runs = []
    for carriers, mid in ((None, (0.5, 0.1)), (("O", "B"), (0.5, 0.1)), (("O", "M"), (0.3, -0.4)), (("M", "B"), (0.2, 0.7))):
        model = two_arms(carriers, mid)
        found = kt.dynamics.simulate(model, 0.8, samples=9)
        joint = kt.dynamics.joint_reaction(model, found, "one", "two")
        other = kt.dynamics.joint_reaction(model, found, "two", "one")
        assert np.abs(joint.force.values + other.force.values).max() < 1e-9
        assert np.abs(joint.moment.values).max() < 1e-12  # about the pin itself
        base = kt.dynamics.joint_reaction(model, found, "one", ["O"])
        assert np.abs(base.force.values - found.forces.data["reaction"].sel(support="O").values).max() < 1e-9
        angle = kt.kinematics.joint(model, found.motion, "one", "two")
        runs.append(np.column_stack([joint.force.values, base.force.values, angle.angle.values, angle.angle_rate.values]))
    for one in runs[1:]:
        assert np.abs(one - runs[0]).max() < 1e-7 * np.abs(runs[0]).max()


@pytest.mark.slow
@pytest.mark.parametrize("end", ["A", "B", "C"])
@pytest.mark.parametrize("at", ["hinge", "ground", ("hinge.1", "hinge.2")])
def test_the_couple_of_a_drive_is_no_part_of_the_load_of_its_bearing(end, at):
    """A door turned by a motor: m (a - g) and the moment across the axis, whatever node the motor takes hold of."""
    nodes = {"A": (0.3, 0.1, 0), "B": (0.8, 0, 0.1), "C": (0.2, 0.1, 0.9), "D": (0.1, 0.5, 0.4), "F": (0, -1, 0)}
    center, inertia, m = np.array([0.4, 0.1, 0.3]), np.diag([0.2, 0.3, 0.15]), 2.0
    body = kt.Body(nodes=tuple("ABCD"), mass=m, center=tuple(center), inertia=(0.2, 0.3, 0.15))
    model = kt.Model(nodes=nodes, fixed=["F"], bodies={"door": body}, gravity=tuple(G))
    model = kt.library.joints.revolute(model, "hinge", bodies=("ground", "door"), at=(0, 0, 0.2), axis="z")
    axis = model.joints["hinge"].hinges[0].axis
    model = model.with_(drives={"motor": kt.HingeDrive(axis=axis, start="F", end=end)})
    found = kt.dynamics.simulate(model, 0.6, samples=7, tasks={"motor": kt.GivenForce(torque=3.0)})
    reaction = kt.dynamics.joint_reaction(model, found, "door", at)
    pose = kt.kinematics.pose(model, found.motion, "door")
    force = m * (pose.acceleration.values - G)
    R, w, alpha = (pose[name].values for name in ("rotation_matrix", "angular_velocity", "angular_acceleration"))
    J = R @ inertia @ R.transpose(0, 2, 1)
    middle = found.motion.data["position"].sel(node=list(axis)).values.mean(axis=1)
    moment = np.einsum("tij,tj->ti", J, alpha) + np.cross(w, np.einsum("tij,tj->ti", J, w))
    moment += np.cross(pose.position.values - middle, force)
    np.testing.assert_allclose(reaction.force.values, force, atol=1e-10)
    np.testing.assert_allclose(reaction.moment.values[:, :2], moment[:, :2], atol=1e-10)
    np.testing.assert_allclose(reaction.moment.values[:, 2], 0.0, atol=1e-10)
    np.testing.assert_allclose(np.abs(moment[:, 2]), 3.0, rtol=1e-9)  # all of it comes from the motor


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda m, f: kt.kinematics.pose(m, f.motion, "tow"), "Did you mean"),
        (lambda m, f: kt.kinematics.pose(m, f.motion, ("O",)), "at least 2"),
        (lambda m, f: kt.kinematics.joint(m, f.motion, "one", ("O", "C")), "axis|share"),
        (lambda m, f: kt.kinematics.joint(m, f.motion, "two", ("O", "M")), "share no node"),
        (lambda m, f: kt.dynamics.joint_reaction(m, f, "two", ["O"]), "not a node of two"),
        (lambda m, f: kt.dynamics.joint_reaction(m, f, "two", "one", point="X"), "No node called 'X'"),
    ],
)
def test_wrong_names_are_told(call, words):
    model = two_arms()
    at = np.array([node.at for node in model.nodes.values()])[None]
    forces = kt.dynamics.inverse(model, kt.kinematics.from_arrays(model, [0.0], at, 0 * at, 0 * at))
    if "axis" in words:
        assert call(model, forces).attrs["nodes"] == ["O"]
        return
    with pytest.raises(InputError, match=words):
        call(model, forces)


# -- bodies that strain --


def stretched(motion, model, carriers, start):
    """Places (times, dim) of a point of a body whose carriers span the model: the affine map of the carriers, by itself."""
    rest = np.array([model.nodes[name].at for name in carriers])
    shares = np.linalg.solve(np.vstack([rest.T, np.ones(len(rest))]), np.append(start, 1.0))
    return np.einsum("k,tkc->tc", shares, motion.position.sel(node=list(carriers)).values)


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(st.floats(-0.2, 0.3), st.floats(-2, 2), st.floats(-2, 2), st.booleans())
def test_a_dilating_body_is_where_its_bar_stretches_it_to(stretch, e, f, by_name):
    """A body on a driven bar of the plane that turns: x = p + (l/l0) R(angle) (e, f), with exact rates."""
    model = kt.Model(
        nodes={"p": (0.1, 0.2), "q": (1.1, 0.2)}, fixed=["p"], bars={"bar": kt.Bar(ends=("p", "q"), kind="driven", mass=0)},
        drives={"turn": kt.AngleDrive("bar")},
        bodies={"plate": kt.Body(nodes=("p", "q"), kind="straining", mass=2.0, center=(0.5, 0.1), inertia=0.3)},
    )  # fmt: skip
    move = kt.Quintic(moves={"bar": (1.0, 1.0 + stretch), "turn": (0.0, 1.2)}, duration=1.0)
    motion = kt.kinematics.follow(model, move, samples=9)
    body = "plate" if by_name else ("p", "q")
    found = kt.kinematics.pose(model, motion, body, frame=kt.Frame(origin=(0.1 + e, 0.2 + f)))
    length, turn = (motion.drive_position.sel(drive=name).values for name in ("bar", "turn"))
    ld, w = (motion.drive_velocity.sel(drive=name).values for name in ("bar", "turn"))
    ldd, alpha = (motion.drive_acceleration.sel(drive=name).values for name in ("bar", "turn"))
    z = (e + 1j * f) * np.exp(1j * turn)
    expected = length * z, (ld + 1j * w * length) * z, (ldd + 2j * ld * w + length * (1j * alpha - w**2)) * z
    for name, value, at in zip(("position", "velocity", "acceleration"), expected, (0.1 + 0.2j, 0, 0), strict=True):
        np.testing.assert_allclose(found[name].values @ [1, 1j], value + at, atol=1e-11, err_msg=name)
    np.testing.assert_allclose(found.angle, turn, atol=1e-12)


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(st.lists(st.floats(-0.3, 0.3), min_size=6, max_size=6), st.lists(st.floats(-1, 2), min_size=3, max_size=3))
def test_a_straining_tetrahedron_takes_every_place_along(changes, place):
    nodes = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    edges = {f"{a}{b}": kt.Bar(ends=(a, b), kind="driven", mass=0) for a, b in itertools.combinations(nodes, 2)}
    model = kt.Model(
        nodes=nodes, fixed={"O": "xyz", "X": "yz", "Y": "z"}, bars=edges,
        bodies={"block": kt.Body(nodes=tuple(nodes), kind="straining", mass=1.0)},
    )  # fmt: skip
    lengths = {name: float(np.linalg.norm(np.subtract(*(nodes[end] for end in bar.ends)))) for name, bar in edges.items()}
    moves = {name: (L, L * (1 + 0.3 * change)) for (name, L), change in zip(lengths.items(), changes, strict=True)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), samples=5)
    found = kt.kinematics.pose(model, motion, "block", frame=kt.Frame(origin=tuple(place)))
    np.testing.assert_allclose(found.position.values, stretched(motion, model, tuple(nodes), place), atol=1e-12)
    center = kt.kinematics.pose(model, motion, "block").position.values
    np.testing.assert_allclose(center, motion.position.values.mean(axis=1), atol=1e-12)


@pytest.mark.slow
def test_messages_name_the_record_that_does_it():
    ends = {"nodes": {"p": (0, 0), "q": (1, 0)}, "fixed": {"p": "xy", "q": "y"}}
    body = kt.PlanarBody(mass=1, center=(0.5, 0), inertia=0.1)
    for kind in ("elastic", "driven", "cable", "free"):
        with pytest.raises(kt.ModelError, match=r"bars.b.body: .*kt.Body\(nodes=\('p', 'q'\), kind='straining'"):
            kt.Model(**ends, bars={"b": kt.Bar(ends=("p", "q"), kind=kind, body=body)})
    for record in (lambda: kt.Node(at=(0, 0), mass=-0.2), lambda: kt.Bar(ends=("p", "q"), mass=-0.1)):
        with pytest.raises(kt.ModelError, match="must not be negative.*kt.Body"):
            record()
    bay = kt.library.vgt.double_octahedral()
    with pytest.raises(kt.ModelError, match="kt.library.bodies.rigid"):
        bay.with_(bodies={"top": kt.Body(nodes=("N7", "N9", "N8"), mass=3.0, center=(0, 0, 1.2), inertia=(1, 1, 1.5))})


def test_a_bar_by_its_name():
    """In the plane a bar has a pose; a point off it turns with it."""
    bar = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"], drives={"turn": kt.AngleDrive("b")})
    motion = kt.kinematics.follow(bar, kt.ConstantRate(rates={"turn": 1.0}, duration=1.0), samples=5)
    found = kt.kinematics.pose(bar, motion, "b", frame=kt.Frame(origin=(0.4, 0.1)))
    c, s = np.cos(motion.data.time), np.sin(motion.data.time)
    assert np.allclose(found.position, np.stack([0.4 * c - 0.1 * s, 0.4 * s + 0.1 * c], axis=1), atol=1e-14)
