"""Statics pose by pose: forms of input, agreement with a motion at rest, use by strength, refusals."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError
from kinetruss.mechanics import compile

POSES = [{"bay.beta": -0.1}, {}, {"bay.beta": 0.15, "bay.gamma": 0.05}]


def bay(**changes):
    fields = {"gravity": (0, 0, 9.81), "tip_force": (0, 0, 46)}
    return kt.library.vgt.double_octahedral(**fields | changes)


@pytest.mark.slow
def test_a_motion_at_rest_has_the_same_forces():
    model = bay()
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-0.15, 0.15)), samples=5)
    static = kt.dynamics.inverse(model, motion).static
    poses = [{"bay.beta": beta} for beta in kt.kinematics.platform(model, motion, ("N7", "N9", "N8")).beta.values]
    found = kt.statics.at_poses(model, poses)
    for name in ("member_force", "end_force", "joint_force", "reaction", "drive_force", "interface_force", "interface_moment"):
        np.testing.assert_allclose(found.data[name].values, static.data[name].values, atol=1e-11)


@pytest.mark.slow
def test_all_forms_of_poses_agree():
    model = bay()
    found = kt.statics.at_poses(model, POSES)
    lengths = found.motion.drive_position.values
    for other in (lengths, found.motion.position.values, {"a": POSES[0], "b": POSES[1], "c": POSES[2]}):
        again = kt.statics.at_poses(model, other)
        np.testing.assert_allclose(again.member_force.values, found.member_force.values, atol=1e-11)
    alone = kt.statics.at_poses(model, POSES[2])
    np.testing.assert_allclose(alone.member_force.values[0], found.member_force.values[2], atol=1e-13)
    text = kt.statics.at_poses(model, [{"M7": "1.2 m"}, {"M7": 1.2}])
    np.testing.assert_array_equal(text.member_force.values[0], text.member_force.values[1])


@pytest.mark.slow
def test_neither_order_nor_neighbours_count():
    model = bay()
    one, two = kt.statics.at_poses(model, POSES), kt.statics.at_poses(model, POSES[::-1])
    np.testing.assert_array_equal(one.member_force.values, two.member_force.values[::-1])


def test_poses_have_names():
    found = kt.statics.at_poses(bay(), {"stowed": {}, "tilted": {"bay.beta": 0.1}})
    assert found.member_force.dims == ("time", "member")
    assert found.time.values.tolist() == [0.0, 1.0]
    assert found.time.attrs["long_name"] == "pose"
    np.testing.assert_array_equal(found.member_force.sel(pose="tilted"), found.member_force.values[1])
    np.testing.assert_array_equal(found.motion.length.sel(pose="stowed"), found.motion.length.values[0])


def test_strength_takes_them():
    metal = kt.Material(E=71e9, density=2711.5, yield_strength=240e6)
    model = bay(material=metal)
    found = kt.statics.at_poses(model, POSES)
    verdict = kt.strength.check(model, found)
    alone = [kt.strength.check(model, kt.statics.at_poses(model, [pose])).table()[0].utilisation for pose in POSES]
    assert verdict.table()[0].utilisation == pytest.approx(max(alone), rel=1e-12)
    sections = kt.strength.sections(model, found)
    # weight bends a member at rest as a uniform load bends a beam: m g l/8 across it at the middle
    bar = model.bars["M19"]
    ends = [found.motion.position.sel(node=end).values[1] for end in bar.ends]
    u = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    mass = compile(model).rods[list(model.members).index("M19"), 0]
    across = np.linalg.norm(np.cross(u, [0, 0, 9.81]))
    M = np.linalg.norm(sections.section_M.sel(part="M19").isel(station=3).values[1])
    assert pytest.approx(mass * across * np.linalg.norm(ends[1] - ends[0]) / 8, rel=1e-12) == M


def test_weights():
    """Reactions sum to what is said to weigh."""
    model = bay(payload_mass=2.0, tip_force=None)
    members = compile(model).rods[:, [0, 3]].sum()
    for weight, total in ((True, members + 6), ("lumped", 6.0), (False, 0.0)):
        found = kt.statics.at_poses(model, [{}], weight=weight)
        np.testing.assert_allclose(found.reaction.sum(dim="support").values[0], [0, 0, -9.81 * total], atol=1e-11)
    with pytest.raises(InputError, match="weight=None: give True"):
        kt.statics.at_poses(model, [{}], weight=None)


def test_coordinate_and_angle_drives():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 1), "C": (2, 0)}, fixed={"A": "xy", "C": "y"}, bars={"a": ("A", "B"), "b": ("B", "C")},
        drives={"slide": kt.CoordinateDrive(node="C", axis="x")}, loads={"l": kt.NodalForce(node="B", force=(0.0, -10.0))},
    )  # fmt: skip
    x = np.array([2.0, 1.6, 2.4])
    found = kt.statics.at_poses(model, x[:, None])
    height = np.sqrt(2 - x**2 / 4)
    # the wedge: each bar carries 5/sin, its horizontal part 5 x/(2 h) is what the slide holds
    np.testing.assert_allclose(found.drive_force.values[:, 0], -5 * x / (2 * height), rtol=1e-12)
    crank = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")},
                     loads={"l": kt.NodalForce(node="B", force=(0.0, -10.0))})  # fmt: skip
    found = kt.statics.at_poses(crank, [{"turn": "0 deg"}, {"turn": "60 deg"}, {"turn": "180 deg"}])
    np.testing.assert_allclose(found.drive_force.values[:, 0], [20, 10, -20], atol=1e-12)


def test_loads_in_time():
    table = kt.NodalForce(node="N8", times=(0.0, 1.0), forces=((0, 0, 0), (0, 0, 90.0)))
    model = bay(gravity=None, tip_force=None).with_(loads={"t": table}, load_cases={"half": kt.LoadCase(loads={"t": 0.5})})
    one, two = kt.statics.at_poses(model, POSES, time=0.5), kt.statics.at_poses(model, POSES, load_case="half", time=1.0)
    np.testing.assert_allclose(one.reaction.sum(dim="support").values, [[0, 0, -45.0]] * 3, atol=1e-11)
    np.testing.assert_allclose(one.member_force, two.member_force, atol=1e-12)
    assert (one.load_case, two.load_case) == ("all", "half")


@pytest.mark.parametrize(
    ("poses", "message"),
    [
        ([{"bay.betta": 0.1}], r"poses\.0\.moves\.bay\.betta.*Did you mean 'bay.beta'"),
        ([{}, {"M7": "10 deg"}], r"'M7' is a length"),
        ([{"M7": 1.2, "bay.beta": 0.1}], "the pose 'bay' that moves them"),
        ([{}, {"bay.beta": 1.4}], r"Pose 1: .*out of reach"),
        ([{"M7": -1.0}], "must stay above 0 m"),
        (np.zeros((2, 4)), r"shape \(2, 4\), expected \(poses, drives = 3\) or \(poses, n_nodes = 9, dim = 3\)"),
        (np.full((2, 3), np.nan), r"poses\[0, \'M7\'\]: nan, expected finite numbers"),
        ([{"M7": 1.2}, 3.0], "not a mix of both"),
        ([], "No pose is given|have shape"),
    ],
)
def test_refusals(poses, message):
    with pytest.raises(InputError, match=message):
        kt.statics.at_poses(bay(), poses)


def test_a_pose_out_of_reach_keeps_those_before_it():
    with pytest.raises(AnalysisError, match=r"Pose 'far' cannot be reached: \d+\.\d% of the way") as caught:
        kt.statics.at_poses(bay(), {"near": {"M7": 1.2}, "far": {"M7": 2.5}, "there": {}})
    assert caught.value.result.member_force.sizes["time"] == 1
    with pytest.raises(AnalysisError) as caught:
        kt.statics.at_poses(bay(), [{"M7": 2.5}])
    assert caught.value.result is None


def test_drives_that_fight():
    nodes = {"A": (0, 0), "B": (2, 0), "C": (1, 1)}
    bars = {name: {"ends": ends, "kind": "driven"} for name, ends in (("a", ("A", "C")), ("b", ("B", "C")), ("c", ("A", "C")))}
    model = kt.Model(nodes=nodes, fixed=["A", "B"], bars=bars)
    good = kt.statics.at_poses(model, [dict.fromkeys("abc", 1.5)])
    assert good.message.startswith("The force of these members is not unique")
    with pytest.raises(InputError, match=r"Pose '1': the drives contradict each other: the others fix '[ac]', which is off"):
        kt.statics.at_poses(model, [{}, {"a": 1.5, "b": 1.5, "c": 1.6}])
