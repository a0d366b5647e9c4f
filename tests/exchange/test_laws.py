"""Couplings, springs and dampers of joints, and tendons: in, against MuJoCo and Pinocchio; and out again."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from reference.loops import MujocoTree, PinocchioTree

GEARED = """<mujoco model="geared"><compiler angle="radian"/>
<include file="parts/classes.xml"/>
<worldbody><site name="peg" pos="-0.2 0.1 0.3"/>
<body name="crank" childclass="arm"><joint name="h1"/><geom fromto="0 0 0 0.3 0 0.05"/>
 <body name="arm" pos="0.3 0 0.05"><joint name="h2" axis="0 1 0.2" ref="0.2"/><geom fromto="0 0 0 0.2 0 0.1"/>
  <site name="hook" pos="0.2 0 0.1"/></body></body>
<body name="cart" pos="0 0.5 0"><joint name="s" type="slide" axis="1 0 0.3" stiffness="60" springref="0.02" damping="3"/>
 <geom type="box" size="0.1 0.05 0.04" mass="2"/><site name="eye" pos="0.1 0 0"/></body>
</worldbody>
<equality><joint name="gears" joint1="h2" joint2="h1" polycoef="0.1 -2 0 0 0"/>
 <joint joint1="s" joint2="h1" polycoef="0 0.15"/><joint joint1="h1" joint2="h2" polycoef="0 0 1" active="false"/></equality>
<tendon><spatial name="band" stiffness="40" springlength="0.3" damping="0.6"><site site="hook"/><site site="eye"/></spatial>
 <spatial name="stay" stiffness="9"><site site="hook"/><site site="peg"/></spatial>
 <fixed name="sum"><joint joint="h1" coef="1"/></fixed></tendon>
<actuator><motor joint="h1" gear="5"/></actuator></mujoco>"""
CLASSES = """<mujocoinclude><default><joint damping="0.2"/><default class="arm">
<joint axis="0 1 0" stiffness="1.5"/><geom type="capsule" size="0.02" density="2700"/></default></default></mujocoinclude>"""


def geared(folder: Path, text: str = GEARED) -> Path:
    (folder / "parts").mkdir(exist_ok=True)
    (folder / "parts" / "classes.xml").write_text(CLASSES)
    (folder / "geared.xml").write_text(text)
    return folder / "geared.xml"


def moved(model: kt.Model, moves: dict[str, tuple[float, float]], offsets=None) -> tuple[np.ndarray, list[np.ndarray]]:
    """Drive forces along a motion; values of the joints in the file, rates, accelerations."""
    offsets = offsets or {}
    shifted = {name: (a + offsets.get(name, 0.0), b + offsets.get(name, 0.0)) for name, (a, b) in moves.items()}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=shifted, duration=0.4), samples=7)
    names = list(moves)
    given = [getattr(motion, key).sel(drive=names).values for key in ("drive_position", "drive_velocity", "drive_acceleration")]
    given[0] = given[0] - [offsets.get(name, 0.0) for name in names]
    return kt.dynamics.inverse(model, motion).drive_force.sel(drive=names).values, given


def agree(found, wanted, tolerance=1e-10):
    assert np.abs(wanted).max() > 0.1
    np.testing.assert_allclose(found, wanted, rtol=0, atol=tolerance * np.abs(wanted).max())


@pytest.mark.slow
def test_couplings_springs_and_tendons_against_mujoco(tmp_path):
    path = geared(tmp_path)
    found = kt.exchange.read(path)
    assert (found.freedoms, found.mobility.degrees_of_freedom, found.mobility.undriven) == (1, 1, 0)
    assert set(found.model.couplings) == {"gears", "coupling_11"}
    assert set(found.model.springs) == {"h1.spring", "h2.spring", "s.spring", "band.spring", "stay.spring"}
    lost = [one.what for one in found.left_out if one.what != "geom"]
    assert sorted(lost) == ["contact", "fixed", "joint equality"]
    assert found.model.drives["h1"].gear == kt.Gear(ratio=5)
    force, given = moved(found.model, {"h1": (0.0, 0.4)}, found.offsets)
    agree(force, MujocoTree(path, ["h1"]).torques(*given))


MIMIC = """<robot name="gripper"><link name="base"/>{links}
<joint name="drive" type="prismatic"><parent link="base"/><child link="ram"/><axis xyz="0 0 2"/>
 <limit lower="0" upper="0.1" effort="9" velocity="1"/><dynamics damping="4"/></joint>
<joint name="left" type="revolute"><parent link="base"/><child link="one"/><origin xyz="0.1 0 0" rpy="0.3 0.2 0.5"/>
 <axis xyz="0 -3 0"/><limit lower="-2" upper="2" effort="9" velocity="1"/>
 <mimic joint="drive" multiplier="6" offset="0.2"/></joint>
<joint name="right" type="revolute"><parent link="base"/><child link="two"/><origin xyz="-0.1 0 0"/><axis xyz="0 1 0"/>
 <limit lower="-2" upper="2" effort="9" velocity="1"/><mimic joint="left" multiplier="-1"/></joint></robot>"""


def gripper(folder: Path) -> Path:
    link = (
        '<link name="{}"><inertial><origin xyz="0.05 0.01 0.08" rpy="0.4 0.1 0.7"/><mass value="{}"/>'
        '<inertia ixx="0.01" iyy="0.012" izz="0.008" ixy="0.001" ixz="-0.0007" iyz="0.0004"/></inertial></link>'
    )
    text = "".join(link.format(name, mass) for name, mass in (("ram", 1.5), ("one", 0.7), ("two", 0.9)))
    (folder / "gripper.urdf").write_text(MIMIC.format(links=text))
    return folder / "gripper.urdf"


MIMICS = [("left", "drive", 6.0, 0.2), ("right", "left", -1.0, 0.0)]


@pytest.mark.slow
def test_joints_that_follow_others_against_pinocchio(tmp_path):
    """Axes that are negative or no unit vectors, and inertias with products about turned axes, count too."""
    path = gripper(tmp_path)
    (tmp_path / "g.yaml").write_text("name_mot: [drive]")
    for options in ({}, {"closures": tmp_path / "g.yaml"}):
        found = kt.exchange.read(path, **options)
        assert (found.freedoms, found.mobility.undriven, list(found.model.all_drives)) == (1, 0, ["drive"])
    force, given = moved(found.model, {"drive": (0.0, 0.08)}, found.offsets)
    wanted = PinocchioTree(path, [], ["drive"], mimics=MIMICS).torques(*given) + 4 * given[1]  # rnea has no damping
    agree(force, wanted)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('joint="drive"', 'joint="drove"', r"gripper.urdf:6:1: <mimic>: no joint called 'drove'.*Did you mean 'drive'"),
        ('<mimic joint="left"', '<mimic joint="right"', "joint 'right' follows itself"),
        ('type="prismatic"', 'type="floating"', "joint 'drive' has no single value"),
        ('<robot name="gripper">', '<robot name="${n}">', "is a macro of xacro.*xacro gripper.urdf"),
    ],
)
def test_faults_of_followers(tmp_path, old, new, message):
    path = gripper(tmp_path)
    path.write_text(path.read_text().replace(old, new, 1))
    with pytest.raises(kt.InputError, match=message):
        kt.exchange.read(path)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            'joint1="s"',
            'joint1="t"',
            r"geared.xml:11:1: <joint>: MuJoCo .* refuses it: unknown element 't' in equality constraint",
        ),
        (
            'joint1="s" joint2="h1"',
            'joint1="s" joint2="s"',
            r"geared.xml:11:1: <joint>: MuJoCo .* refuses it: element 's' is repeated",
        ),
        (
            '<site site="eye"/>',
            '<site site="eyes"/>',
            r"geared.xml:12:1: <site>: MuJoCo .* refuses it: site 'eyes' not found.*Did you mean 'eye'",
        ),
        ("parts/classes.xml", "parts/class.xml", r"geared.xml:2:1: <include>: file 'parts/class.xml' is not there"),
        ("parts/classes.xml", "../classes.xml", "is outside the folder of the model"),
        ("parts/classes.xml", "geared.xml", "a second time"),
    ],
)
def test_faults_of_laws(tmp_path, old, new, message):
    with pytest.raises(kt.InputError, match=message):
        kt.exchange.read(geared(tmp_path, GEARED.replace(old, new, 1)))


def four_bar() -> kt.Model:
    """Springs on the crank, between two bars and on a diagonal; a second crank geared to the first."""
    nodes = {"A": (0, 0), "B": (1, 0), "C": (0.1, 0.4), "D": (0.9, 0.7), "E": (0, -0.5), "F": (0.3, -0.6), "G": (-1, 0)}
    bars = {"crank": ("A", "C"), "coupler": ("C", "D"), "rocker": ("B", "D"), "second": ("E", "F")}
    elbow = kt.HingeDrive(axis="D", start="C", end="B")
    gears = ((kt.HingeDrive(axis="A", start="G", end="C"), 2.0), (kt.AngleDrive("second"), 3.0))
    diagonal = kt.Bar(ends=("C", "B"), kind="free", mass=0)
    return kt.Model(
        nodes=nodes, fixed=["A", "B", "E", "G"], gravity=(0, -9.81),
        bars={name: kt.Bar(ends=ends, mass=1.5) for name, ends in bars.items()} | {"diagonal": diagonal},
        drives={"motor": kt.AngleDrive("crank")}, couplings={"gears": kt.Coupling(terms=gears)},
        springs={
            "wound": kt.Spring(coordinate=kt.AngleDrive("crank"), stiffness=5.0, rest="50 deg", damping=0.3),
            "elbow": kt.Spring(coordinate=elbow, stiffness=4.0, preload=0.8),
            "strap": kt.Spring(coordinate=kt.LengthDrive("diagonal"), stiffness=70.0, rest=0.7, damping=2.0),
            "geared": kt.Spring(coordinate=kt.AngleDrive("second"), stiffness=2.0, rest=0.4),
        },
    )  # fmt: skip


def piston(dim: int) -> kt.Model:
    """A crank, a rod and a mass on a guide with a spring and a damper along it."""
    places = {"O": (0, 0, 0), "P": (0.1, 0.3, 0), "Q": (0.9, 0, 0)}
    nodes = {name: kt.Node(at=at[:dim], mass=2.0 * (name == "Q")) for name, at in places.items()}
    bars = {"crank": kt.Bar(ends=("O", "P"), mass=1.0), "rod": kt.Bar(ends=("P", "Q"), mass=0.8)}
    along = kt.Spring(coordinate=kt.CoordinateDrive(node="Q", axis="x"), stiffness=80.0, rest=0.8, damping=5.0)
    model = kt.Model(
        nodes=nodes,
        fixed={"O": "xyz"[:dim], "Q": "yz"[: dim - 1]} | ({"P": "z"} if dim == 3 else {}), bars=bars,
        gravity=(0, -9.81, 0)[:dim], springs={"along": along},
    )  # fmt: skip
    return model.with_(drives={"motor": kt.AngleDrive("crank") if dim == 2 else kt.CoordinateDrive(node="Q", axis="x")})


@pytest.mark.slow
@pytest.mark.parametrize(
    ("make", "step", "lost"),
    [(four_bar, 0.3, set()), (lambda: piston(2), 0.5, set()), (lambda: piston(3), 0.07, {"mass"})],
    ids=["springs_and_gears", "piston", "piston_in_space"],
)
def test_what_acts_and_what_is_guided_in_mujoco_and_back(tmp_path, make, step, lost):
    model = make()
    written = kt.exchange.write(model, tmp_path / "out.xml")
    assert {one.what for one in written.left_out} == lost
    start = written.offsets["motor"]
    force, given = moved(model, {"motor": (start, start + step)})
    given[0] = given[0] - start
    agree(force, MujocoTree(written.files[0], ["motor"]).torques(*given), 1e-8 if lost else 1e-10)
    back = kt.exchange.read(written.files[0])
    assert back.freedoms == 1
    again, _ = moved(back.model, {"motor": (0.0, step)}, back.offsets)
    agree(again, force, 1e-8 if lost else 1e-10)


def test_what_follows_in_urdf(tmp_path):
    model = four_bar().with_(springs={})
    damped = model.with_(springs={"brake": kt.Spring(coordinate=kt.AngleDrive("crank"), damping=0.4)})
    written = kt.exchange.write(damped, tmp_path / "out.urdf")
    assert {one.what for one in written.left_out} == {"gravity"}
    back = kt.exchange.read(written.files[0], closures=written.files[1])
    assert (back.freedoms, list(back.model.couplings)) == (1, ["second.E.mimic"])
    start = written.offsets["motor"]
    force, _ = moved(damped, {"motor": (start, start + 0.3)})
    again, _ = moved(back.model.with_(gravity=(0, -9.81, 0)), {"motor": (0.0, 0.3)})
    agree(again, force)


@pytest.mark.slow
def test_tendons_of_a_hexapod_come_back(tmp_path):
    model = kt.library.mechanisms.stewart(platform_mass=12.0)
    legs = [f"leg{k}" for k in range(1, 7)]
    written = kt.exchange.write(model, tmp_path / "hexapod.xml")
    back = kt.exchange.read(written.files[0])
    assert set(back.model.driven_members) == set(legs)
    assert (back.freedoms, back.mobility.undriven) == (6, 0)
    forces = [kt.statics.at_poses(one, [{}]).drive_force.sel(drive=legs).values for one in (model, back.model)]
    agree(forces[1], forces[0])
