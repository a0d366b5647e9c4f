"""Joints by name: their freedoms by rank, their motion against the classical joint, their faults."""

import math
import warnings

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.display import number
from kinetruss.errors import InputError, ModelError
from kinetruss.library import joints
from kinetruss.model import GROUND
from kinetruss.model.joints import FREEDOMS

PLACE = {2: (1.1, 0.2), 3: (1.1, 0.2, 0.1)}
U, V = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.0, 0.0])
PAIRS = (("A", "B"), (GROUND, "B"), ("A", GROUND))
MADE = {
    "spherical": (3, {}),
    "revolute": (3, {"axis": U}),
    "weld": (3, {}),
    "universal": (3, {"axes": (U, V)}),
    "prismatic": (3, {"axis": U}),
    "cylindrical": (3, {"axis": U}),
    "planar": (3, {"axis": U}),
    "pin": (2, {}),
    "plane_weld": (2, {}),
    "plane_prismatic": (2, {"axis": U[1:]}),
    "parallelogram": (2, {"axis": U[1:]}),
    "double_parallelogram": (2, {"axis": U[1:], "double": True}),
}


def two_bodies(dim: int) -> kt.Model:
    """Two free bodies, simplexes."""
    nodes = {}
    for name, corner, size in (("A", np.zeros(dim), 1.0), ("B", np.array([1.2, 0.3, 0.1])[:dim], 0.8)):
        nodes |= {f"{name}0": corner} | {f"{name}{k + 1}": corner + size * np.eye(dim)[k] for k in range(dim)}
    bodies = {name: kt.Body(nodes=[node for node in nodes if node[0] == name], mass=m) for name, m in (("A", 1.5), ("B", 2.0))}
    return kt.Model(nodes={name: tuple(at) for name, at in nodes.items()}, bodies=bodies)


def made(name: str, pair: tuple[str, str]) -> kt.Model:
    dim, given = MADE[name]
    function = getattr(joints, name.removeprefix("plane_").removeprefix("double_"))
    return function(two_bodies(dim), "j", bodies=pair, at=PLACE[dim], **given)


@pytest.mark.slow
@pytest.mark.parametrize("pair", PAIRS, ids="-".join)
@pytest.mark.parametrize("name", MADE)
def test_freedoms_by_rank(name, pair):
    model = made(name, pair)
    joint = model.joints["j"]
    found = kt.kinematics.mobility(model)
    whole = 3 if model.dim == 2 else 6
    assert found.degrees_of_freedom == whole + joint.freedoms
    assert found.self_stress == 0
    assert joint.freedoms == FREEDOMS[joint.kind]
    assert joints.conditioning(model, "j") > 0.02


def moved(motion, model: kt.Model, body: str) -> tuple[np.ndarray, np.ndarray]:
    """Rotation (t, dim, dim) and displacement (t, dim) of a body, from its first nodes; x = R x0 + d."""
    count, dim = motion.sizes["time"], model.dim
    if body == GROUND:
        return np.broadcast_to(np.eye(dim), (count, dim, dim)), np.zeros((count, dim))
    names = [f"{body}{k}" for k in range(dim + 1)]
    start = np.array([model.nodes[name].at for name in names])
    x = motion.position.sel(node=names).values
    edges0, edges = (start[1:] - start[0]).T, np.swapaxes(x[:, 1:] - x[:, :1], 1, 2)
    R = edges @ np.linalg.inv(edges0)
    return R, x[:, 0] - R @ start[0]


def relative(run, model: kt.Model, pair: tuple[str, str]) -> tuple[np.ndarray, np.ndarray]:
    """Rotation of the second body in the first one's axes, and where its point at the joint has gone there."""
    place = np.array(PLACE[model.dim])
    (R, d), (S, e) = (moved(run.motion.data, model, body) for body in pair)
    way = S @ place + e - R @ place - d
    return np.swapaxes(R, 1, 2) @ S, np.einsum("tji,tj->ti", R, way)


def residual(name: str, model: kt.Model, Q: np.ndarray, p: np.ndarray) -> np.ndarray:
    """What the classical joint keeps at 0."""
    turned = Q - np.eye(model.dim)
    u = U[1:] if model.dim == 2 else U
    off = p - (p @ u)[:, None] * u
    link = 0.0 if "parallelogram" not in name else np.subtract(model.nodes["j.3"].at, model.nodes["j.1"].at)
    v = V[:2] if model.dim == 2 else V
    table = {
        "spherical": [p], "pin": [p], "revolute": [p, turned @ u], "weld": [p, turned], "plane_weld": [p, turned],
        "universal": [p, (Q @ v) @ u], "prismatic": [turned, off], "plane_prismatic": [turned, off],
        "cylindrical": [turned @ u, off], "planar": [turned @ u, p @ u],
        "parallelogram": [turned, np.linalg.norm(p + link, axis=1) - np.linalg.norm(link)],
        "double_parallelogram": [turned],
    }  # fmt: skip
    return np.concatenate([np.ravel(part) for part in table[name]])


def let_go(model: kt.Model, seed: int, duration: float):
    """A simulation from a random motion that the joint allows."""
    rng = np.random.default_rng(seed)
    found = kt.kinematics.mobility(model)
    modes = found.mechanisms / np.linalg.norm(found.mechanisms, axis=(1, 2))[:, None, None]
    basis = np.linalg.qr(modes.reshape(len(modes), -1).T)[0]
    speed = (basis @ rng.normal(size=basis.shape[1])).reshape(modes.shape[1:])
    moving = model.with_(velocities={name: tuple(v) for name, v in zip(found.node_names, speed, strict=True) if v.any()})
    return moving, kt.dynamics.simulate(moving, duration, samples=6)


@pytest.mark.slow
@pytest.mark.parametrize("name", MADE)
def test_moves_as_the_classical_joint_does(name):
    model, run = let_go(made(name, ("A", "B")), 3, 0.3)
    Q, p = relative(run, model, ("A", "B"))
    assert np.abs(residual(name, model, Q, p)).max() < 1e-8
    if model.joints["j"].freedoms:  # and it does move
        assert max(np.abs(Q[-1] - np.eye(model.dim)).max(), np.abs(p[-1]).max()) > 1e-3


def hung(name: str, **given) -> kt.Model:
    """Body B on the ground, under gravity."""
    free = two_bodies(3)
    nodes = {key: node for key, node in free.nodes.items() if key[0] == "B"}
    one = kt.Model(nodes=nodes, bodies={"B": free.bodies["B"]}, gravity=(0, 0, -9.81))
    return getattr(joints, name)(one, "j", bodies=(GROUND, "B"), at=PLACE[3], **given)


def test_physical_pendulum():
    """A uniform tetrahedron on a hinge: I t'' = torque of its weight, integrated apart."""
    from scipy.integrate import solve_ivp

    model = hung("revolute", axis="y")
    run = kt.dynamics.simulate(model, 0.5, samples=6)
    corners = np.array([model.nodes[f"B{k}"].at for k in range(4)]) - PLACE[3]
    flat = corners[:, [0, 2]]
    # of a uniform tetrahedron: int r.r dm = m/20 (sum r_i.r_i + |sum r_i|^2)
    inertia = 2.0 / 20 * ((flat**2).sum() + (flat.sum(axis=0) ** 2).sum())
    x, z = flat.mean(axis=0)

    def rate(_, state):
        s, c = math.sin(state[0]), math.cos(state[0])
        return state[1], 2.0 * 9.81 * (c * x + s * z) / inertia  # right-handed about y: x turns to -z

    exact = solve_ivp(rate, (0, 0.5), (0, 0), rtol=1e-12, atol=1e-13).y[0, -1]
    Q = moved(run.motion.data, model, "B")[0][-1]
    assert math.remainder(math.atan2(Q[0, 2], Q[0, 0]) - exact, 2 * math.pi) == pytest.approx(0, abs=1e-8)


def test_slider_falls_along_its_axis():
    model = hung("prismatic", axis=(0.6, 0, 0.8))
    run = kt.dynamics.simulate(model, 0.2, samples=3)
    way = run.motion.position.sel(node="B0").values - run.motion.position.sel(node="B0").values[0]
    exact = -0.5 * 9.81 * 0.8 * np.array([0, 0.1, 0.2])[:, None] ** 2 * np.array([0.6, 0, 0.8])
    assert way == pytest.approx(exact, abs=1e-9)


def test_body_in_a_planar_joint_falls_freely_in_its_plane():
    model = hung("planar", axis="y")
    run = kt.dynamics.simulate(model, 0.2, samples=3)
    middle = run.motion.position.sel(node=[f"B{k}" for k in range(4)]).mean("node").values
    exact = np.outer(-0.5 * 9.81 * np.array([0, 0.1, 0.2]) ** 2, (0, 0, 1))
    assert middle - middle[0] == pytest.approx(exact, abs=1e-9)


def test_massless_linkages_need_no_force_but_the_guided_one():
    """In a cylindrical joint with an upright axis the body falls as if it were free."""
    model = hung("cylindrical", axis="z")
    run = kt.dynamics.simulate(model, 0.2, samples=3)
    height = run.motion.position.sel(node="B0", axis="z").values
    assert height - height[0] == pytest.approx(-0.5 * 9.81 * np.array([0, 0.1, 0.2]) ** 2, abs=1e-9)


def test_node_of_one_body_is_taken_for_the_joint():
    model = joints.spherical(two_bodies(3), "ball", bodies=("A", "B"), at="A1")
    assert "ball" not in model.nodes
    assert "A1" in model.bodies["B"].nodes
    at_place = joints.spherical(two_bodies(3), "ball", bodies=("A", "B"), at=(1.0, 0.0, 0.0))
    assert at_place.joints["ball"].nodes == ("A1",)


def test_mass_stays_on_its_carriers():
    model = made("revolute", ("A", "B"))
    assert model.bodies["A"].carried_by(3) == ("A0", "A1", "A2", "A3")


def test_hinge_tells_what_to_measure():
    hinge = made("revolute", (GROUND, "B")).joints["j"].hinges[0]
    assert hinge.axis == ("j.1", "j.2")
    assert hinge.start == "j.g"
    assert hinge.end.startswith("B")


def test_default_size_is_the_best_of_those_tried():
    base = two_bodies(3)
    best = joints.conditioning(joints.revolute(base, "j", bodies=("A", "B"), at=PLACE[3], axis=U), "j")
    for size in (0.2, 0.5, 1.0):
        other = joints.revolute(base, "j", bodies=("A", "B"), at=PLACE[3], axis=U, size=size)
        assert joints.conditioning(other, "j") <= best + 0.02


def test_warns_of_a_joint_too_small_for_its_bodies():
    with pytest.warns(joints.JointWarning, match=r"Joint 'j' holds badly: .* leave the size out"):
        joints.revolute(two_bodies(3), "j", bodies=("A", "B"), at=PLACE[3], axis=U, size=1e-4)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        joints.revolute(two_bodies(3), "j", bodies=("A", "B"), at=PLACE[3], axis=U)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"bodies": ("A", "A")}, r"joins 'A' to itself\. Name two different bodies, or ground"),
        ({"bodies": ("A", "C")}, r"no body called 'C'\. There are: A, B, ground"),
        ({"bodies": ("A",)}, r"names 1 bod"),
        ({"axis": (0, 0, 0)}, r"has no length, so no direction"),
        ({"axis": "w"}, r"'w' is no direction"),
        ({"at": (9, 9, 9)}, r"from body 'A', whose size is 1.41\d* m: they do not meet there\. Move the joint"),
        ({"at": (1, 2)}, r"has 2 coordinates\. Give 3"),
        ({"at": "A9"}, r"no node called 'A9'"),
        ({"size": -1.0}, r"is no size"),
    ],
)
def test_faults(given, words):
    arguments = {"bodies": ("A", "B"), "at": PLACE[3], "axis": U} | given
    with pytest.raises(ModelError, match=words):
        joints.revolute(two_bodies(3), "j", **arguments)


def test_more_faults():
    made_once = made("revolute", ("A", "B"))
    with pytest.raises(ModelError, match="is there already. Give the joint another name"):
        joints.spherical(made_once, "j", bodies=("A", "B"), at=PLACE[3])
    with pytest.raises(ModelError, match="is a joint of dimension 2 in a model of dimension 3"):
        joints.pin(two_bodies(3), "j", bodies=("A", "B"), at=PLACE[3])
    with pytest.raises(ModelError, match="axes are parallel"):
        joints.universal(two_bodies(3), "j", bodies=("A", "B"), at=PLACE[3], axes=("x", (-1, 0, 0)))
    with pytest.raises(InputError, match="no joint called 'k'"):
        joints.conditioning(made_once, "k")


def test_two_nodes_at_one_place_must_be_made_one():
    model = two_bodies(3)
    close = model.with_(nodes=model.nodes | {"B0": kt.Node(at=(1, 0, 0), coincident=True)})
    with pytest.raises(ModelError, match="nodes of their own there, 'A1' and 'B0'. Make them one: name 'A1' in both bodies"):
        joints.spherical(close, "j", bodies=("A", "B"), at=(1, 0, 0))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"bodies": ("A", "C")}, "no body called 'C'"),
        ({"bodies": ("A", "A")}, "joins 'A' to itself"),
        ({"nodes": ("A0",)}, "none of them belongs to 'B': the bodies do not meet there"),
        ({"bars": ("none",)}, "no bar called 'none'"),
        (
            {"nodes": ("j.1", "A0", "B0")},
            "of its nodes only j.1; revolute needs 2, or they do not meet there. Name 2",
        ),
        ({"nodes": ("A0", "B0")}, "share none of its nodes; revolute needs 2"),
        ({"nodes": ("A0", "B0"), "kind": "spherical", "hinges": ()}, "share none of its nodes; spherical needs 1"),
        ({"kind": "weld"}, "weld needs 3"),
    ],
)
def test_records_that_do_not_fit_their_model(changes, words):
    model = made("revolute", ("A", "B"))
    with pytest.raises(ModelError, match=words):
        model.with_(joints={"j": model.joints["j"].with_(**changes)})


def test_is_written_and_read(tmp_path):
    model = made("cylindrical", (GROUND, "B"))
    kt.write(model, tmp_path / "m.yaml")
    again = kt.read(tmp_path / "m.yaml")
    assert again.joints["j"] == model.joints["j"]
    assert again.bars.keys() == model.bars.keys()


def test_screw_falls_slower_by_what_it_turns():
    """m + I (2 pi/pitch)^2 in the place of m, turning by 2 pi for every pitch."""
    pitch = 0.3
    model = hung("screw", axis="z", pitch=pitch)
    found = kt.kinematics.mobility(model)
    assert (found.undriven, found.self_stress) == (1, 0)
    run = kt.dynamics.simulate(model, 0.2, samples=2)
    arms = np.array([model.nodes[f"B{k}"].at for k in range(4)])[:, :2] - PLACE[3][:2]
    inertia = 2.0 / 20 * ((arms**2).sum() + (arms.sum(axis=0) ** 2).sum())
    fall = -0.5 * 9.81 * 0.2**2 * 2.0 / (2.0 + inertia * (2 * math.pi / pitch) ** 2)
    R, _ = moved(run.motion.data, model, "B")
    height = run.motion.position.sel(node="B0", axis="z").values
    assert height[1] - height[0] == pytest.approx(fall, rel=1e-8)
    assert math.atan2(R[1, 1, 0], R[1, 0, 0]) == pytest.approx(2 * math.pi * fall / pitch, rel=1e-8)


def slider_in_plane(form: str) -> kt.Model:
    corners = {"B0": (1.2, 0.3), "B1": (2.0, 0.3), "B2": (1.2, 1.0)}
    one = kt.Model(nodes=corners, bodies={"B": kt.Body(nodes=list(corners), mass=2.0)}, gravity=(0, -9.81))
    return joints.prismatic(one, "j", bodies=(GROUND, "B"), at=PLACE[2], axis=(0.6, 0.8), form=form)


@pytest.mark.parametrize("form", ["linkage", "direct"])
def test_slider_in_the_plane_falls_along_its_axis(form):
    model = slider_in_plane(form)
    found = kt.kinematics.mobility(model)
    assert (found.undriven, found.self_stress) == (1, 0)
    run = kt.dynamics.simulate(model, 0.2, samples=2)
    x = run.motion.position.sel(node="B0").values
    assert x[1] - x[0] == pytest.approx(-0.5 * 9.81 * 0.8 * 0.04 * np.array([0.6, 0.8]), abs=1e-9)


def test_drives_at_joints():
    turned = joints.drive(hung("revolute", axis="y"), "j", "motor")
    motion = kt.kinematics.follow(turned, kt.ConstantRate(rates={"motor": 1.0}, duration=0.5), samples=3)
    torque = kt.dynamics.inverse(turned, motion).drive_force.isel(time=0).item()
    arm = np.mean([turned.nodes[f"B{k}"].at for k in range(4)], axis=0) - PLACE[3]
    assert torque == pytest.approx(-2.0 * 9.81 * arm[0], rel=1e-9)  # right-handed about y weight pulls x down
    pushed = joints.drive(slider_in_plane("linkage"), "j", "ram")
    assert kt.kinematics.mobility(pushed).undriven == 0
    assert pushed.all_drives["ram"].bar == "ram"


def test_faults_of_drives_and_screws():
    ball = made("spherical", ("A", "B"))
    with pytest.raises(InputError, match="joint 'j', a spherical one, has no angle and no slide"):
        joints.drive(ball, "j", "motor")
    with pytest.raises(InputError, match="no joint called 'k'"):
        joints.drive(ball, "k", "motor")
    with pytest.raises(ModelError, match="is a drive or a member already"):
        joints.drive(made("revolute", ("A", "B")), "j", "A.A0-A1")
    with pytest.raises(ModelError, match="no travel in a turn"):
        joints.screw(two_bodies(3), "j", bodies=("A", "B"), at=PLACE[3], axis="z", pitch=0.0)


def test_info_tells_of_joints(tmp_path):
    from click.testing import CliRunner

    from kinetruss.cli import main

    model = made("revolute", (GROUND, "B"))
    kt.write(model, tmp_path / "m.yaml")
    done = CliRunner().invoke(main, ["info", str(tmp_path / "m.yaml")])
    value = joints.conditioning(model, "j")
    head, row = done.stdout.split("Joints\n")[1].splitlines()[:2]
    assert head.split() == ["joint", "kind", "of", "freedoms", "smallest", "singular", "value"]
    assert row.split() == ["j", "revolute", "ground", "and", "B", "1", number(value)]


@pytest.mark.slow
@pytest.mark.parametrize("form", ["direct", "linkage"])
@pytest.mark.parametrize("at", [(2, 0), (3, 0), (2.2, 0.3), "X", "Y", (2, 1)])
def test_a_slide_where_a_body_has_a_node_already(at, form):
    """The point on the line may be a node of either body: the couplings name the one that is there."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1), "X": (2, 0), "Y": (3, 0), "Z": (2, 1)}, fixed=["A", "B", "C"],
        bodies={"base": kt.Body(nodes=("A", "B", "C"), mass=1), "sled": kt.Body(nodes=("X", "Y", "Z"), mass=1)},
    )  # fmt: skip
    joined = kt.library.joints.prismatic(model, "s", bodies=("base", "sled"), at=at, axis="x", size=0.7, form=form)
    assert kt.kinematics.mobility(joined).degrees_of_freedom == 1
    named = {name for one in joined.couplings.values() for term, _ in one.terms for name in (*term.line, term.point)}
    assert named <= set(joined.nodes) and set(joined.joints["s"].nodes) <= set(joined.nodes)
