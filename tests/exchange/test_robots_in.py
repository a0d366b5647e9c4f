"""Robots with loops from URDF and MJCF: inverse dynamics against minimal coordinates, masses against the programs."""

from pathlib import Path

import mujoco
import numpy as np
import pytest

import kinetruss as kt
from reference.loops import MujocoTree, PinocchioTree, Tree

DATA = Path(__file__).parents[1] / "data"


def torques(model: kt.Model, moves: dict[str, tuple[float, float]]) -> tuple[np.ndarray, list[np.ndarray]]:
    """Of the drives along a motion, and their values, rates and accelerations."""
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=9)
    forces = kt.dynamics.inverse(model, motion)
    names = list(moves)
    given = [getattr(motion, key).sel(drive=names).values for key in ("drive_position", "drive_velocity", "drive_acceleration")]
    return forces.drive_force.sel(drive=names).values, given


def against(tree: Tree, model: kt.Model, moves: dict[str, tuple[float, float]]) -> None:
    found, given = torques(model, moves)
    wanted = tree.torques(*given)
    assert np.abs(wanted).max() > 1.0
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


def test_five_bar_against_pinocchio():
    found = kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml")
    tree = PinocchioTree(DATA / "robot.urdf", [("tip_left", "tip_right")], ["motor_left", "motor_right"])
    tree.laws = {tree.column("motor_left"): (0.1, 0.02, 0.0)}
    against(tree, found.model, {"motor_left": (0.0, -0.5), "motor_right": (0.0, 0.6)})


@pytest.mark.slow
def test_three_arms_against_mujoco():
    found = kt.exchange.read(DATA / "parallel.xml")
    tree = MujocoTree(DATA / "parallel.xml", ["motor1", "motor2", "motor3"])
    against(tree, found.model, {"motor1": (0.0, 0.4), "motor2": (0.0, -0.3), "motor3": (0.0, 0.2)})


WRIST = """<mujoco model="wrist"><compiler angle="radian" eulerseq="xyz"/><worldbody>
<body name="arm" pos="0 0 1" euler="0.1 0.2 0.3">
 <joint name="j0" axis="0 0 1" ref="0.2"/><geom type="capsule" size="0.03" fromto="0 0 0 0.5 0 0"/>
 <frame pos="0.5 0 0" axisangle="1 0 0 0.4"><body name="hand">
  <joint name="a" axis="1 0 0" stiffness="3" springref="0.4" damping="0.7"/>
  <joint name="b" axis="0 1 0"/><joint name="c" axis="0 0 1"/>
  <geom type="ellipsoid" size="0.05 0.08 0.12" pos="0.1 0.02 0" zaxis="1 1 0"/>
  <geom type="cylinder" size="0.03 0.1" pos="0.2 0 0"/>
  <geom type="box" size="0.05 0.08" fromto="0 0 0 0.2 0.1 0.05" mass="0.7"/>
  <geom pos="0.3 0 0" xyaxes="0 1 0 1 0 0" size="0.02"/>
  <site name="tip" pos="0.3 0 0"/></body></frame></body>
</worldbody><actuator><motor joint="j0"/><motor joint="a"/><motor joint="b"/><motor joint="c"/></actuator></mujoco>"""


@pytest.mark.slow
def test_crossing_axes_and_shapes(tmp_path):
    """A wrist of three axes through one point, with bodies without mass between; a value that is not 0 where it is drawn."""
    path = tmp_path / "wrist.xml"
    path.write_text(WRIST)
    found = kt.exchange.read(path)
    assert found.model.nodes["tip"].mass == 0
    drawn = {"j0": (0.2, 0.7), "a": (0.0, 1.0), "b": (0.0, 0.5), "c": (0.0, -0.7)}
    against(MujocoTree(path, list(drawn)), found.model, drawn)


def hexapod(path: Path) -> None:
    """Six legs, each a cardan joint, a slider and a ball, under a plate."""
    bodies, closures, motors = [], [], []
    for k in range(6):
        low, high = np.radians(60 * k + (10 if k % 2 else -10)), np.radians(60 * k + (-18 if k % 2 else 18))
        start = np.array([0.5 * np.cos(low), 0.5 * np.sin(low), 0.0])
        way = np.array([0.3 * np.cos(high), 0.3 * np.sin(high), 0.6]) - start
        x, y, z = start.tolist()
        along = " ".join(map(repr, way.tolist()))
        bodies.append(
            f'<body name="low{k}" pos="{x!r} {y!r} {z!r}" zaxis="{along}"><joint name="u{k}" axis="1 0 0"/>'
            f'<joint name="v{k}" axis="0 1 0"/><geom type="cylinder" size="0.02 0.15" pos="0 0 0.15" mass="0.5"/>'
            f'<body name="high{k}" pos="0 0 {float(np.linalg.norm(way)) - 0.3!r}"><joint name="slide{k}" type="slide" '
            'range="-0.15 0.15"/><geom type="cylinder" size="0.015 0.15" pos="0 0 0.15" mass="0.3"/></body></body>'
        )
        closures.append(f'<connect body1="high{k}" body2="top" anchor="0 0 0.3"/>')
        motors.append(f'<motor joint="slide{k}"/>')
    top = '<body name="top" pos="0 0 0.6"><freejoint/><geom type="cylinder" size="0.3 0.01" mass="3"/></body>'
    path.write_text(
        f'<mujoco><compiler angle="radian"/><worldbody>{"".join(bodies)}{top}</worldbody>'
        f"<equality>{''.join(closures)}</equality><actuator>{''.join(motors)}</actuator></mujoco>"
    )


@pytest.mark.slow
def test_sliders_against_mujoco(tmp_path):
    path = tmp_path / "hexapod.xml"
    hexapod(path)
    found = kt.exchange.read(path)
    assert (found.freedoms, found.mobility.degrees_of_freedom, found.mobility.undriven) == (6, 6, 0)
    moves = {f"slide{k}": (0.0, 0.05 * (k % 3)) for k in range(6)}
    shifted = {name: (a + found.offsets[name], b + found.offsets[name]) for name, (a, b) in moves.items()}
    forces, given = torques(found.model, shifted)
    given[0] = given[0] - [found.offsets[name] for name in moves]
    wanted = MujocoTree(path, list(moves)).torques(*given)
    np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


ROD = """<mujoco><worldbody>
<body name="crank"><joint name="m" axis="0 1 0.1"/><geom type="capsule" size="0.02" fromto="0 0 0 0.2 0 0.05"/>
 <body name="rod" pos="0.2 0 0.05"><joint type="ball"/><geom type="capsule" size="0.01" fromto="0 0 0 0.3 0.1 0.3"/></body>
</body>
<body name="rocker" pos="0.8 0.1 0"><joint axis="0 1 0"/><geom type="capsule" size="0.02" fromto="0 0 0 -0.3 0 0.35"/></body>
</worldbody><equality><connect body1="rod" body2="rocker" anchor="0.3 0.1 0.3"/></equality>
<actuator><motor joint="m"/></actuator></mujoco>"""


@pytest.mark.slow
def test_a_rod_between_two_balls_does_not_spin(tmp_path):
    """Its turning about its line is left out and named; kinetic energy of the rest as of a rod."""
    path = tmp_path / "rod.xml"
    path.write_text(ROD)
    found = kt.exchange.read(path)
    assert found.freedoms == 2  # one of them the turning of the rod
    assert found.mobility.degrees_of_freedom == 1
    assert [one.where for one in found.left_out if one.what == "spin"] == [f"{path}:3 <body name='rod'>"]
    body = found.model.bodies["rod"]
    line = np.array([0.3, 0.1, 0.3]) / np.linalg.norm([0.3, 0.1, 0.3])
    inertia = mujoco.MjModel.from_xml_path(str(path)).body("rod").inertia
    expected = inertia.max() * (np.eye(3) - np.outer(line, line))
    np.testing.assert_allclose(np.array(body.inertia), expected, atol=1e-12 * inertia.max())


def test_types_of_joints_from_the_yaml_file(tmp_path):
    """A ball, a cardan joint and a fixed one where URDF has hinges; a weld of two frames joins two links."""
    link = '<link name="{}"><inertial><mass value="1"/><origin xyz="0.2 0.01 0"/><inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>'  # noqa: E501
    joint = '<joint name="{0}" type="revolute"><parent link="{1}"/><child link="{2}"/><origin xyz="{3}" rpy="0.2 0 0"/></joint>'
    text = "".join(link.format(name) for name in "bcde") + "".join(
        joint.format(*one)
        for one in (("ball", "base", "b", "0 0 0"), ("cross", "b", "c", "0.4 0 0"), ("stiff", "c", "d", "0.4 0 0"))
    )
    path, beside = tmp_path / "chain.urdf", tmp_path / "chain.yaml"
    path.write_text(f'<robot name="chain"><link name="base"/>{text}{joint.format("last", "base", "e", "1 0 0")}</robot>')
    beside.write_text("joint_name: [ball, cross, stiff]\njoint_type: [SPHERICAL, CARDAN, FIXED]\nname_mot: last\n")
    found = kt.exchange.read(path, closures=beside)
    assert (found.freedoms, found.mobility.degrees_of_freedom, list(found.model.drives)) == (6, 6, ["last"])
    assert set(found.model.bodies) == {"b", "c", "cross_cross", "e"}
    assert found.model.bodies["c"].mass == 2.0
    beside.write_text("closed_loop: [[d, c]]\ntype: [6d]\nname_mot: [ball]\n")
    with pytest.raises(kt.InputError, match=r"chain.yaml:1: closure 'd_c' stays open by 0\.4"):
        kt.exchange.read(path, closures=beside)
    beside.write_text("closed_loop: [[stiff, e]]\ntype: [6d]\n")
    path.write_text(path.read_text().replace('xyz="1 0 0" rpy="0.2 0 0"', 'xyz="0.8 0 0" rpy="0.6 0 0"'))
    welded = kt.exchange.read(path, closures=beside)
    assert set(welded.model.bodies) == {"b", "c", "e"}  # one link with the mass of two
    assert welded.model.bodies["e"].mass == 2.0
    assert welded.freedoms == welded.mobility.degrees_of_freedom


def test_loops_that_are_open_where_they_are_drawn():
    """The undriven joints close them; a motor may be put elsewhere."""
    found = kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml", at={"motor_left": -0.3})
    model = found.model
    tip = np.array(model.nodes["tip_left_tip_right"].at)
    motion = kt.kinematics.follow(
        model, kt.Quintic(moves={"motor_left": (-0.3, 0.0), "motor_right": (0.0, 0.0)}, duration=1.0), samples=5
    )
    drawn = kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml").model
    end = motion.position.sel(node="tip_left_tip_right").values[-1]
    np.testing.assert_allclose(end, drawn.nodes["tip_left_tip_right"].at, atol=1e-12)
    assert np.linalg.norm(tip - end) > 0.05


@pytest.mark.slow
def test_a_pose_of_mjcf_leaves_the_anchors_where_the_file_has_them():
    """`connect` defines its second anchor in the pose of the file, not in the one that is asked for."""
    found = kt.exchange.read(DATA / "parallel.xml", at={"motor1": 0.3})
    forces, given = torques(found.model, {"motor1": (0.3, 0.5), "motor2": (0.0, -0.2), "motor3": (0.0, 0.1)})
    wanted = MujocoTree(DATA / "parallel.xml", ["motor1", "motor2", "motor3"]).torques(*given)
    np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


def test_a_floating_base():
    fixed = kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml")
    free = kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml", floating=True)
    assert free.freedoms == fixed.freedoms + 6
    assert free.mobility.degrees_of_freedom == fixed.mobility.degrees_of_freedom + 6
    assert not free.model.fixed


def test_a_link_with_mass_and_no_inertia(tmp_path):
    """A pendulum of a mass point: torque m g r sin and m r^2 times the acceleration; base masses rest on the ground."""
    path = tmp_path / "pendulum.urdf"
    path.write_text(
        '<robot name="p"><link name="base"><inertial><mass value="5"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>'
        '<link name="bob"><inertial><origin xyz="0 0 -0.5"/><mass value="2"/></inertial></link>'
        '<joint name="pin" type="revolute"><parent link="base"/><child link="bob"/><axis xyz="0 1 0"/></joint></robot>'
    )
    found = kt.exchange.read(path)
    assert {one.what for one in found.left_out} == {"mass", "inertia"}
    forces, (angle, _, acceleration) = torques(found.model, {"pin": (0.2, 1.3)})
    np.testing.assert_allclose(forces, 2 * 9.81 * 0.5 * np.sin(angle) + 2 * 0.25 * acceleration, atol=1e-10)


def test_a_uniform_rod_hung_at_its_end(tmp_path):
    """Its mass is carried near its ends, where its joint is: moment m g l/2 cos t + m l^2/3 times the acceleration."""
    m, length, path = 1.2, 0.8, tmp_path / "rod.urdf"
    j = m * length**2 / 12
    path.write_text(
        f'<robot name="r"><link name="base"/><link name="rod"><inertial><origin xyz="{length / 2} 0 0"/><mass value="{m}"/>'
        f'<inertia ixx="0" iyy="{j!r}" izz="{j!r}"/></inertial></link><joint name="pin" type="revolute">'
        '<parent link="base"/><child link="rod"/><axis xyz="0 -1 0"/></joint></robot>'
    )
    forces, (angle, _, acceleration) = torques(kt.exchange.read(path).model, {"pin": (0.2, 1.3)})
    wanted = m * 9.81 * length / 2 * np.cos(angle) + m * length**2 / 3 * acceleration
    np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


def cad_five_bar(folder: Path) -> tuple[Path, Path]:
    """As CAD exporters write it: motors about z of turned frames, small spheres where the loop closes, one frame of a tool."""
    mass = '<inertial><origin xyz="{}" rpy="0 0 0"/><mass value="{}"/><inertia ixx="{}" ixy="0" ixz="0" iyy="{}" iyz="{}" izz="{}"/></inertial>'  # noqa: E501
    bar, rod = ("4.4e-4", "2.7e-5", "1e-6", "4.6e-4"), ("1.4e-3", "2.7e-5", "1e-6", "1.4e-3")
    links = {
        "frame": mass.format("0 0 0.05", 0.02, *bar), "crank1": mass.format("0 0.05 0.001", 0.2, *bar),
        "crank2": mass.format("0 0.05 0.001", 0.2, *bar), "rod1": mass.format("0 -0.1 0.001", 0.25, *rod),
        "rod2": mass.format("0 0.1 0.001", 0.25, *rod), "eff": mass.format("0 0 0", "1e-9", 0, 0, 0, 0),
        "ball1": mass.format("0 0 0", 0.02, "2e-6", "2e-6", 0, "1e-20"),
        "ball2": mass.format("0 0 0", 0.03, "3e-6", "3e-6", 0, "1e-20"),
    }  # fmt: skip
    limit = '<limit effort="1" velocity="20"/><joint_properties friction="0.0"/>'
    turned = "-1.5707963267948966 0.021 1.5707963267948966"
    joints = (
        ("mot1", "frame", "crank1", "-0.05 0 0.1", turned), ("mot2", "frame", "crank2", "-0.05 0.02 0.1", turned),
        ("free1", "crank1", "rod1", "0 0.1 0", "3.141592653589793 0 0.6"), ("free2", "crank2", "rod2", "0 0.1 0", "0 0 -0.5"),
        ("loop_A", "rod1", "ball1", "0 -0.2 0", "0 0 0"), ("loop_B", "rod2", "ball2", "0 0.2 0", "3.141592653589793 0 0"),
    )  # fmt: skip
    text = "".join(f'<link name="{name}">{own}</link>' for name, own in links.items()) + "".join(
        f'<joint name="{name}" type="revolute"><origin xyz="{xyz}" rpy="{rpy}"/><parent link="{one}"/><child link="{two}"/>'
        f'<axis xyz="0 0 1"/>{limit}</joint>'
        for name, one, two, xyz, rpy in joints
    )
    tool = '<joint name="eff_frame" type="fixed"><origin xyz="0.01 -0.2 0" rpy="-1.57 1.57 0"/><parent link="rod1"/><child link="eff"/><axis xyz="0 0 0"/></joint>'  # noqa: E501
    (folder / "five.urdf").write_text(f'<robot name="onshape">{text}{tool}</robot>')
    (folder / "five.yaml").write_text("closed_loop: [['loop_A', 'loop_B']]\ntype: ['6d']\nname_mot: ['mot1', 'mot2']\n")
    return folder / "five.urdf", folder / "five.yaml"


def test_spheres_where_a_loop_closes_do_not_spin(tmp_path):
    """Two spheres welded to each other turn about the axis of their hinges and move nothing; the rest is a five-bar."""
    path, beside = cad_five_bar(tmp_path)
    found = kt.exchange.read(path, closures=beside)
    assert (found.freedoms, found.mobility.degrees_of_freedom, found.mobility.undriven) == (3, 2, 0)
    assert [one.what for one in found.left_out if one.what == "spin"] == ["spin"]
    assert sum(body.mass for body in found.model.bodies.values()) == pytest.approx(0.95 + 1e-9, rel=1e-14)
    tree = PinocchioTree(path, [("loop_A", "loop_B")], ["mot1", "mot2"])
    forces, given = torques(found.model, {"mot1": (0.0, 0.3), "mot2": (0.0, -0.2)})
    wanted = tree.torques(*given)
    np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


@pytest.mark.parametrize(("word", "axes"), [("UJOINT_ZY", "zy"), ("UJOINT_XZ", "xz"), ("CARDAN", "xy")])
def test_universal_joints_of_the_yaml_file(tmp_path, word, axes):
    """Two crossing hinges in the frame of the joint, the first named axis first: as a chain that has them as joints."""
    mass = '<inertial><origin xyz="0.2 0.1 -0.3"/><mass value="1.5"/><inertia ixx="0.02" iyy="0.03" izz="0.04"/></inertial>'
    head = f'<robot name="r"><link name="base"/><link name="arm">{mass}</link>'
    pose = '<origin xyz="0.1 0 0.2" rpy="0.3 -0.2 0.5"/>'
    joint = '<joint name="{}" type="revolute"><parent link="{}"/><child link="{}"/>{}<axis xyz="{}"/></joint>'
    unit = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}
    short, long, beside = tmp_path / "short.urdf", tmp_path / "long.urdf", tmp_path / "u.yaml"
    short.write_text(head + joint.format("j", "base", "arm", pose, "0 0 1") + "</robot>")
    both = joint.format("a", "base", "mid", pose, unit[axes[0]]) + joint.format("b", "mid", "arm", "", unit[axes[1]])
    long.write_text(head + '<link name="mid"/>' + both + "</robot>")
    beside.write_text(f"joint_name: [j]\njoint_type: [{word}]\nname_mot: [j]\n")
    names = [f"j_{axis.upper()}" for axis in axes]
    one, two = kt.exchange.read(short, closures=beside).model, kt.exchange.read(long).model
    assert list(one.drives) == names
    found, _ = torques(one, dict.fromkeys(names, (0.2, 0.6)))
    wanted, _ = torques(two, {"a": (0.2, 0.6), "b": (0.2, 0.6)})
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-11 * np.abs(wanted).max())
