"""Closed-loop robots, each in MJCF and in URDF: inverse dynamics against minimal coordinates of MuJoCo and of Pinocchio."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
import robot_texts
from reference.loops import MujocoTree, PinocchioTree

ROBOTS = {
    "delta": (robot_texts.delta, {"arm0": 0.2, "arm1": -0.15, "arm2": 0.1}, 3),
    "scara": (robot_texts.scara, {"arm1": -0.2, "arm2": 0.15, "quill": 0.06, "tool": 0.8}, 4),
    "three_rrr": (robot_texts.three_rrr, {"low0": 0.1, "low1": -0.08, "low2": 0.12}, 3),
    "gough": (robot_texts.gough, {f"rod{k}": 0.02 * (k % 3) for k in range(6)}, 6),
    "leg": (robot_texts.leg, {"thigh": 0.3, "shank": -0.4, "crank0": 0.2, "crank1": -0.15}, 4),
}


def moved(found, steps):
    """Forces of the drives; values, rates and accelerations of the joints in the file."""
    names = list(steps)
    moves = {name: (found.offsets[name], found.offsets[name] + step) for name, step in steps.items()}
    motion = kt.kinematics.follow(found.model, kt.Quintic(moves=moves, duration=0.5), samples=7)
    given = [getattr(motion, key).sel(drive=names).values for key in ("drive_position", "drive_velocity", "drive_acceleration")]
    given[0] = given[0] - [found.offsets[name] for name in names]
    return kt.dynamics.inverse(found.model, motion).drive_force.sel(drive=names).values, given


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("dialect", ["mjcf", "urdf"])
def test_inverse_dynamics_against_minimal_coordinates(tmp_path, name, dialect):
    make, steps, freedoms = ROBOTS[name]
    robot = make()
    steps = {f"{part}_joint": step for part, step in steps.items()}
    if dialect == "mjcf":
        path = robot.mjcf(tmp_path)
        found, tree = kt.exchange.read(path), MujocoTree(path, robot.drives)
        tree.laws = {tree.column(one.joint): (0.0, one.friction, 0.0) for one in robot.parts if one.friction}
    else:
        path, beside = robot.urdf(tmp_path)
        found = kt.exchange.read(path, closures=beside)
        tree = PinocchioTree(path, robot.pairs, robot.drives, robot.balls)
        tree.laws = {tree.column(one.joint): (one.damping, one.friction, 0.0) for one in robot.parts if one.kind != "ball"}
    assert (found.mobility.degrees_of_freedom, found.mobility.undriven) == (freedoms, 0)
    force, given = moved(found, steps)
    wanted = tree.torques(*given)
    assert np.abs(wanted).max() > 1.0
    np.testing.assert_allclose(force, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


@pytest.mark.slow
@pytest.mark.parametrize("name", ["delta", "three_rrr", "leg"])
def test_robots_return_from_mjcf(tmp_path, name):
    """With the friction of joints, and rotors as wheels that are coupled to them."""
    make, steps, freedoms = ROBOTS[name]
    robot = make()
    steps = {f"{part}_joint": step for part, step in steps.items()}
    found = kt.exchange.read(robot.mjcf(tmp_path))
    written = kt.exchange.write(found.model, tmp_path / "again.xml")
    assert not {one.what for one in written.left_out} & {"couplings", "springs", "drive", "actuators"}
    back = kt.exchange.read(written.files[0])
    assert (back.mobility.degrees_of_freedom, back.mobility.undriven) == (freedoms, 0)
    text = written.files[0].read_text()
    assert text.count("armature=") == sum(one.armature > 0 for one in robot.parts)
    assert "rotor" not in text
    first, again = (moved(one, steps)[0] for one in (found, back))
    np.testing.assert_allclose(
        again, first, rtol=0, atol=1e-9 * np.abs(first).max()
    )  # rods get a small moment about their line


GEARED = """<mujoco><compiler angle="radian"/><worldbody><body name="a">
<joint name="j" axis="0 1 0" frictionloss="2" armature="0.3"/><inertial pos="0.2 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>
<body name="b" pos="0.4 0 0"><joint name="ball" type="ball" frictionloss="1" armature="0.1"/>
<inertial pos="0.1 0 0" mass="1" diaginertia="0.01 0.01 0.01"/></body></body></worldbody>
<actuator><motor name="m" joint="j" gear="{gear}" ctrlrange="-1 1"/></actuator></mujoco>"""


@pytest.mark.slow
@pytest.mark.parametrize(("gear", "ratio"), [("20 0 0", 20.0), ("-20", None), ("20 1", 20.0), ("0", None)])
def test_gears_of_hinges(tmp_path, gear, ratio):
    path = tmp_path / "geared.xml"
    path.write_text(GEARED.format(gear=gear))
    found = kt.exchange.read(path)
    assert getattr(found.model.drives["j"].gear, "ratio", None) == ratio
    lost = {one.what for one in found.left_out}
    assert lost == {"frictionloss", "armature", "motor: ctrlrange" if ratio else "motor: ctrlrange, gear"}  # those of the ball
    again = kt.exchange.read(kt.exchange.write(found.model, tmp_path / "again.xml").files[0])
    assert getattr(again.model.drives["j"].gear, "ratio", None) == ratio
    assert again.model.springs["j.spring"].friction == 2.0
    assert again.model.bodies["j.rotor"].inertia == found.model.bodies["j.rotor"].inertia
    urdf = kt.exchange.write(found.model, tmp_path / "again.urdf")
    assert {one.what for one in urdf.left_out} == {"armature", "gear"} if ratio else {"armature"}
    assert kt.exchange.read(urdf.files[0], closures=urdf.files[1]).model.springs["j.spring"].friction == 2.0


@pytest.mark.slow
@pytest.mark.parametrize("word", ["frictionloss", "armature", "damping"])
def test_laws_below_zero_are_faults(tmp_path, word):
    path = tmp_path / "geared.xml"
    path.write_text(GEARED.format(gear="1").replace('frictionloss="2" armature="0.3"', f'{word}="-2"'))
    with pytest.raises(kt.InputError, match=f"geared.xml:2:1: <joint name='j'>: has the {word} -2. Give 0 or more."):
        kt.exchange.read(path)
