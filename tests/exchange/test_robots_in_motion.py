"""Trees of joints that other readers find odd, in motion: torques along random motions are those of Pinocchio."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio
import pytest

import kinetruss as kt

MASS = (
    '<inertial><origin xyz="{}" rpy="0.3 -0.2 0.5"/><mass value="{}"/>'
    '<inertia ixx="{}" iyy="{}" izz="{}" ixy="{}" ixz="0" iyz="0"/></inertial>'
)
BLOCK = MASS.format("0.1 -0.05 0.07", 1.3, 0.02, 0.03, 0.025, 0.004)
SMALL = MASS.format("0.02 0.01 -0.03", 0.4, 0.001, 0.0013, 0.0009, 0.0001)
DUMMY = MASS.format("0 0 0", 1e-3, 5e-20, 5e-20, 5e-20, 0)
NONE = MASS.format("0 0 0", 0, 0.02, 0.03, 0.04, 0)


def urdf(*joints: tuple[str, str, str, str, str], more: str = "") -> str:
    """A robot of joints: type, axis, place, contents of the parent's joint after the axis, mass of the child; a chain."""
    text = '<robot name="r"><link name="l0"/>'
    for k, (kind, axis, place, law, mass) in enumerate(joints, 1):
        text += (
            f'<link name="l{k}">{mass}</link><joint name="j{k}" type="{kind}"><parent link="l{k - 1}"/><child link="l{k}"/>'
            f'<origin xyz="{place}" rpy="0.1 0.2 -0.3"/><axis xyz="{axis}"/>{law}'
            '<limit lower="-1" upper="1" effort="9" velocity="9"/></joint>'
        )
    return text + more + "</robot>"


X, Y, Z, HERE, ASIDE = "1 0 0", "0 1 0", "0 0 1", "0 0 0", "0.3 0.1 -0.2"
ROBOTS = {
    "slide_slide_hinge": urdf(
        ("prismatic", X, HERE, "", ""), ("prismatic", Y, HERE, "", ""), ("revolute", Z, HERE, "", BLOCK)
    ),
    "three_slides_and_a_wrist": urdf(
        ("prismatic", X, HERE, "", ""),
        ("prismatic", Y, HERE, "", ""),
        ("prismatic", Z, HERE, "", ""),
        ("revolute", X, HERE, "", ""),
        ("revolute", Y, HERE, "", ""),
        ("revolute", Z, HERE, "", BLOCK),
    ),
    "wrist": urdf(
        ("revolute", Z, ASIDE, "", BLOCK), ("revolute", X, HERE, "", ""), ("revolute", Y, HERE, "", ""),
        ("revolute", "1 2 3", HERE, "", SMALL),
    ),
    "one_axis_twice": urdf(
        ("revolute", Z, ASIDE, "", BLOCK), ("revolute", X, ASIDE, "", SMALL), ("revolute", X, "0 0 0", "", BLOCK)
    ).replace('rpy="0.1 0.2 -0.3"/><axis xyz="1 0 0"', 'rpy="0 0 0"/><axis xyz="1 0 0"'),
    "axes_that_almost_meet": urdf(
        ("revolute", Z, ASIDE, "", BLOCK), ("revolute", X, ASIDE, "", SMALL), ("revolute", Y, "1e-7 0 0", "", BLOCK)
    ),
    "dummies": urdf(
        ("revolute", Y, ASIDE, "", BLOCK), ("revolute", X, ASIDE, "", DUMMY), ("prismatic", Z, HERE, "", DUMMY),
        ("revolute", X, ASIDE, "", SMALL), ("revolute", Z, HERE, "", DUMMY),
    ),
    "inertia_without_mass": urdf(("revolute", Y, ASIDE, "", BLOCK), ("revolute", X, ASIDE, "", NONE)),
    "leaf_without_mass": urdf(("revolute", Y, ASIDE, "", BLOCK), ("revolute", X, ASIDE, "", "")),
    "rod_and_plate": urdf(
        ("revolute", Y, ASIDE, "", MASS.format("0.1 0 0", 0.7, 0, 0.01, 0.01, 0)),
        ("revolute", X, ASIDE, "", MASS.format("0 0.1 0", 0.7, 0.01, 0.02, 0.03, 0)),
    ),
}  # fmt: skip


def along(path: Path, moves: dict[str, tuple[float, float]], leads: dict[str, dict[str, float]] | None = None) -> None:
    """Torques along a motion against Pinocchio's; leads : driven joint -> joints that follow it, with their factors."""
    found = kt.exchange.read(path)
    model, names, leads = found.model, list(moves), leads or {}
    shifted = {name: tuple(value + found.offsets[name] for value in moves[name]) for name in names}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=shifted, duration=0.4), samples=7)
    assert set(model.all_drives) == set(names)
    forces = kt.dynamics.inverse(model, motion).drive_force.sel(drive=names).values
    given = [getattr(motion, f"drive_{key}").sel(drive=names).values for key in ("position", "velocity", "acceleration")]
    given[0] = given[0] - [found.offsets[name] for name in names]
    tree = pinocchio.buildModelFromUrdf(str(path))
    data = tree.createData()
    wanted = np.zeros_like(forces)
    for k in range(len(forces)):
        q, v, a = pinocchio.neutral(tree), np.zeros(tree.nv), np.zeros(tree.nv)
        for column, name in enumerate(names):
            for follower, factor in {name: 1.0, **leads.get(name, {})}.items():
                joint = tree.joints[tree.getJointId(follower)]
                q[joint.idx_q], v[joint.idx_v], a[joint.idx_v] = (factor * one[k, column] for one in given)
        torque = pinocchio.rnea(tree, data, q, v, a)
        for column, name in enumerate(names):
            for follower, factor in {name: 1.0, **leads.get(name, {})}.items():
                wanted[k, column] += factor * torque[tree.joints[tree.getJointId(follower)].idx_v]
    assert np.abs(wanted).max() > 0.1
    np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("seed", [1, 2])
def test_torques_of_trees(tmp_path, name, seed):
    path = tmp_path / "r.urdf"
    path.write_text(ROBOTS[name])
    dice = np.random.default_rng(seed)
    count = ROBOTS[name].count("</joint>")
    along(path, {f"j{k}": tuple(dice.uniform(-0.6, 0.6, 2).tolist()) for k in range(1, count + 1)})


def test_mimic_led_by_a_link_without_mass_and_chains(tmp_path):
    """The leader has no mass and nothing behind it: it still moves what follows, and feels it; so in a chain of followers."""
    path = tmp_path / "r.urdf"
    leaf = (
        '<link name="knob"/><joint name="lead" type="revolute"><parent link="l1"/><child link="knob"/><axis xyz="1 0 0"/>'
        '<limit lower="-1" upper="1" effort="9" velocity="9"/></joint>'
    )
    path.write_text(
        urdf(
            ("revolute", Y, ASIDE, "", BLOCK),
            ("revolute", X, ASIDE, '<mimic joint="lead" multiplier="-0.7"/>', BLOCK),
            ("revolute", Z, ASIDE, '<mimic joint="j2" multiplier="2"/>', SMALL),
            more=leaf,
        )
    )
    along(path, {"j1": (0.1, 0.5), "lead": (0.0, 0.4)}, {"lead": {"j2": -0.7, "j3": -1.4}})


def test_mimic_of_a_held_joint(tmp_path):
    """What follows a fixed joint stays at the offset; a fixed joint follows nothing; both are said."""
    path = tmp_path / "r.urdf"
    path.write_text(
        urdf(
            ("fixed", X, ASIDE, '<mimic joint="j2"/>', BLOCK),
            ("revolute", X, ASIDE, "", BLOCK),
            ("revolute", Z, ASIDE, '<mimic joint="j1" offset="0.3"/>', SMALL),
        )
    )
    found = kt.exchange.read(path)
    assert (found.freedoms, found.mobility.degrees_of_freedom) == (1, 1)
    assert [one.what for one in found.left_out].count("mimic") == 2
    assert any("joint j3 " in text or "j3 by +0.3 rad" in text for text in found.notes)


def test_joint_in_a_plane(tmp_path):
    path = tmp_path / "r.urdf"
    path.write_text(urdf(("planar", "1 2 2", ASIDE, "", BLOCK)))
    found = kt.exchange.read(path)
    assert (found.freedoms, found.mobility.degrees_of_freedom) == (3, 3)
    normal = kt.exchange.robots.turn_about((0, 0, 1), -0.3) @ kt.exchange.robots.turn_about((0, 1, 0), 0.2)
    normal = normal @ kt.exchange.robots.turn_about((1, 0, 0), 0.1) @ np.array([1, 2, 2]) / 3
    slides = [joint.slide for joint in found.model.joints.values() if joint.slide]
    ways = [np.subtract(found.model.nodes[b].at, found.model.nodes[a].at) for a, b in slides]
    assert np.abs(np.array(ways) @ normal).max() < 1e-12
    assert any("gives no limits" in text for text in found.notes)


FIVE = Path(__file__).parents[1] / "data"


def test_asked_values_are_kept_or_told():
    kept = kt.exchange.read(FIVE / "robot.urdf", closures=FIVE / "robot.yaml", at={"motor_left": -0.3, "motor_right": 0.1})
    assert not any("was asked" in text for text in kept.notes)
    for name, value in (("motor_left", -0.3), ("motor_right", 0.1)):
        motion = kt.kinematics.follow(kept.model, kt.ConstantRate(rates={name: 0.0}, duration=1.0), samples=2)
        start = float(motion.drive_position.sel(drive=name)[0]) - kept.offsets[name]
        assert start == pytest.approx(value, abs=1e-12)
    asked = {"motor_left": -0.3, "motor_right": 0.1, "elbow_left": 0.9}  # two freedoms cannot keep three values
    over = kt.exchange.read(FIVE / "robot.urdf", closures=FIVE / "robot.yaml", at=asked)
    told = {text.split()[1]: float(text.split("(")[1].split(")")[0]) for text in over.notes if "was asked to be at" in text}
    assert told.keys() <= asked.keys()
    assert max(map(abs, told.values())) > 0.01
    for name in ("motor_left", "motor_right"):
        motion = kt.kinematics.follow(over.model, kt.ConstantRate(rates={name: 0.0}, duration=1.0), samples=2)
        start = float(motion.drive_position.sel(drive=name)[0]) - over.offsets[name]
        assert start - asked[name] == pytest.approx(told.get(name, 0.0), abs=1e-2 * abs(told.get(name, 0.0)) + 1e-9)
    with pytest.raises(kt.InputError, match="without a single value"):
        kt.exchange.read(FIVE / "robot.urdf", closures=FIVE / "robot.yaml", at={"tip_left_mount": 0.1})
