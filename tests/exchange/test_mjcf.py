"""MJCF as MuJoCo compiles it: in motion against MuJoCo itself, every field of its model, and a process with limits."""

from __future__ import annotations

import struct
import sys
from pathlib import Path

import mujoco
import numpy as np
import pytest
from mujoco.introspect.structs import STRUCTS

import kinetruss as kt
from kinetruss.exchange import mjcf_compile, mjcf_fields
from kinetruss.exchange.robot_files import robot_of
from kinetruss.io import MAX_SIZE
from reference.loops import MujocoTree

RAD = '<compiler angle="radian"/>'
ARM = (
    '<body name="a" pos="0 0 1" euler="0.1 0.2 0.3"><joint name="j" axis="0 1 0.2" {j}/><geom type="box" size=".1 .05 .2"'
    ' pos=".2 0 -.1"/>{x}<body name="b" pos=".4 .1 0"><joint name="k" type="hinge" axis="1 0.3 0" {k}/>'
    '<geom type="capsule" size=".05" fromto="0 0 0 .1 .3 .2"/></body></body>'
)
SPRUNG = 'stiffness="30" springref="0.5" damping="2"'
FRAMED = (
    '<frame pos=".1 .2 .3" euler=".3 .1 .2"><body name="a"><frame pos="0 .1 0" euler=".1 .5 0"><joint name="j" axis="0 1 0"/>'
    '<inertial pos=".1 0 0" mass="2" diaginertia=".1 .2 .25"/></frame><frame pos=".2 0 0">'
    '<joint name="k" axis="1 0 1"/></frame>'
    '<geom size=".3"/></body></frame>'
)
HALVES = '<geom group="4" size=".2" density="99"/><geom group="1" type="cylinder" size=".1 .2" pos=".1 .1 0" mass="3"/>'
SHELL = '<geom type="{}" size=".1 .2 .15" pos=".1 .2 .3" euler=".1 .2 .3" shellinertia="true" density="9"/>'
MESH = '<geom type="mesh" mesh="{}" density="500" pos=".1 0 .2" euler=".3 .1 .2"/>'
MESHES = '<asset><mesh name="{}" file="tetra.stl" scale="1 2 .5" inertia="{}"/></asset>'
SLIDE = '<body name="c"><joint name="s" type="slide" axis="1 0 1" ref=".1" {}/><geom size=".2"/></body>'

MOVING: dict[str, tuple[str, str, str, tuple[str, ...]]] = {
    # before the world; in the world; after it; joints
    "plain": (RAD, ARM.format(j="", k="", x=""), "", ("j", "k")),
    "gravity off": (RAD + '<option><flag gravity="disable"/></option>', ARM.format(j=SPRUNG, k="", x=""), "", ("j", "k")),
    "springs off": (
        RAD + '<option gravity="1 2 -8"/><option><flag spring="disable"/></option>',
        ARM.format(j=SPRUNG, k="", x=""), "", ("j", "k"),
    ),
    "dampers off, by a file": (RAD + '<include file="off.xml"/>', ARM.format(j=SPRUNG, k=SPRUNG, x=""), "", ("j", "k")),
    "joints and inertia in frames": (RAD, FRAMED, "", ("j", "k")),
    "springs by their time": (
        RAD + '<default><joint springdamper="1.5 .2" springref=".3"/></default>', ARM.format(j="", k="", x=""), "", ("j", "k"),
    ),
    "degrees and another order": (
        '<compiler angle="degree" eulerseq="zYx" coordinate="local" autolimits="false"/>',
        ARM.format(j='ref="20" springref="-30" stiffness="5"', k='ref="-10"', x=""), "", ("j", "k"),
    ),
    "groups of shapes": (
        '<compiler angle="radian" inertiafromgeom="true" inertiagrouprange="0 2"/>', ARM.format(j="", k="", x=HALVES), "",
        ("j", "k"),
    ),
    "total mass": ('<compiler angle="radian" settotalmass="7"/>', ARM.format(j="", k="", x=HALVES), "", ("j", "k")),
    "bounds": ('<compiler angle="radian" boundmass="9" boundinertia=".7"/>', ARM.format(j="", k="", x=""), "", ("j", "k")),
    "repaired inertia": (
        '<compiler angle="radian" balanceinertia="true"/>',
        '<body><joint name="j" axis="0 1 0"/><inertial pos=".1 .2 0" mass="1" diaginertia="1 2 9"/></body>', "", ("j",),
    ),
    "shells": (
        RAD, ARM.format(j="", k="", x="".join(SHELL.format(kind) for kind in ("box", "cylinder", "ellipsoid", "sphere"))), "",
        ("j", "k"),
    ),
    "a mesh": (RAD + MESHES.format("m", "convex"), ARM.format(j="", k="", x=MESH.format("m")), "", ("j", "k")),
    "the skin of a mesh": (RAD + MESHES.format("m", "shell"), ARM.format(j="", k="", x=MESH.format("m")), "", ("j", "k")),
    "copies": (
        RAD,
        '<replicate count="3" offset=".3 0 .1" euler=".2 0 0"><body name="a"><joint name="j" axis="0 1 0"/><geom size=".1"'
        ' pos=".2 0 .1"/></body></replicate>', "", ("j0", "j1", "j2"),
    ),
    "an attached model": (
        '<compiler angle="degree"/><asset><model name="other" file="parts/other.xml"/></asset>',
        '<body name="a"><joint name="j" axis="0 1 0" springref="30" stiffness="4"/><geom size=".1" pos=".2 0 0"/>'
        '<frame pos=".3 0 0" euler="30 40 0"><attach model="other" body="c" prefix="p_"/></frame></body>', "", ("j", "p_j"),
    ),
    "rotors and dampers of motors": (
        RAD, ARM.format(j=SPRUNG, k="", x=SLIDE.format("")),
        '<actuator><motor joint="j" gear="3" armature=".2" damping=".4"/><motor joint="s" armature=".3" damping=".5" gear="2"/>'
        '<motor jointinparent="k"/></actuator>', ("j", "s", "k"),
    ),
    "a slide with springs off": (
        RAD + '<option><flag spring="disable" damper="disable"/></option>', SLIDE.format(SPRUNG), "", ("s",),
    ),
    "ends of a site": (
        RAD, ARM.format(j="", k="", x='<site name="e" type="capsule" size=".01" fromto="0 0 0 .4 0 -.2"/>')
        + '<site name="f" pos="0 .3 1.5"/>',
        '<tendon><spatial stiffness="200" springlength=".1" damping="3"><site site="e"/><site site="f"/></spatial></tendon>',
        ("j", "k"),
    ),
}  # fmt: skip


def tetra(path: Path) -> None:
    """A tetrahedron as a binary STL file."""
    corners = [(0, 0, 0), (0.3, 0, 0), (0, 0.2, 0), (0, 0.1, 0.4)]
    rows = [[float(x) for k in face for x in corners[k]] for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))]
    path.write_bytes(bytes(80) + struct.pack("<I", 4) + b"".join(struct.pack("<12fH", 0, 0, 0, *row, 0) for row in rows))


def written(folder: Path, before: str, world: str, after: str, drives: tuple[str, ...] = ()) -> Path:
    """The file, an element a line, with those that it names beside it."""
    motors = "" if "<actuator>" in after else "".join(f'<motor joint="{name}"/>' for name in drives)
    after += f"<actuator>{motors}</actuator>" if motors else ""
    path = folder / "m.xml"
    path.write_text(f"<mujoco>{before}<worldbody>{world}</worldbody>{after}</mujoco>".replace("><", ">\n<"))
    tetra(folder / "tetra.stl")
    (folder / "off.xml").write_text('<mujocoinclude><option><flag damper="disable"/></option></mujocoinclude>')
    (folder / "parts").mkdir()
    (folder / "parts" / "other.xml").write_text(
        '<mujoco><compiler angle="radian" meshdir=".."/><asset><mesh name="t" file="tetra.stl"/></asset><worldbody>'
        '<body name="c"><joint name="j" axis="1 0 0" springref=".4" stiffness="3"/><geom type="mesh" mesh="t"/></body>'
        "</worldbody></mujoco>"
    )
    return path


@pytest.mark.slow
@pytest.mark.parametrize("name", MOVING)
def test_motion_against_mujoco(tmp_path, name):
    """Inertia, bias, springs and dampers: torques along random motions with speed and acceleration."""
    before, world, after, drives = MOVING[name]
    path = written(tmp_path, before, world, after, drives)
    found, tree = kt.exchange.read(path), MujocoTree(path, list(drives))
    chance = np.random.default_rng(list(MOVING).index(name))
    home = {joint: float(tree.model.qpos0[at]) for joint, at in zip(drives, tree.at, strict=True)}
    moves = {joint: tuple(found.offsets[joint] + home[joint] + chance.uniform(-0.15, 0.15, 2)) for joint in drives}
    motion = kt.kinematics.follow(found.model, kt.Quintic(moves=moves, duration=0.4), samples=5)
    given = [getattr(motion, key).sel(drive=list(drives)).values for key in ("drive_position", "drive_velocity")]
    given.append(motion.drive_acceleration.sel(drive=list(drives)).values)
    given[0] = given[0] - [found.offsets[joint] for joint in drives]
    wanted = tree.torques(*given)
    force = kt.dynamics.inverse(found.model, motion).drive_force.sel(drive=list(drives)).values
    np.testing.assert_allclose(force, wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())


TWO = (
    '<body name="a" pos=".1 .2 .3" euler="10 20 30"><freejoint/><geom type="box" size=".1 .2 .3"/>'
    '<site name="s" pos=".1 0 .2" euler="5 6 7"/></body><body name="b" pos=".5 .2 .3" euler="-10 20 30"><freejoint/>'
    '<geom type="box" size=".1 .2 .3"/><site name="t" pos=".1 .3 .2" euler="5 6 70"/></body>'
)


@pytest.mark.slow
@pytest.mark.parametrize("bodies", ['body1="a" body2="b"', 'body1="b"'])
@pytest.mark.parametrize(
    "condition",
    ['weld {}', 'weld {} anchor="1 2 3"', 'weld {} relpose=".3 .1 .2 .9 .1 .2 .3" anchor=".1 .2 .5"',
     'connect {} anchor="1 2 3"',
     'weld site1="s" site2="t"', 'connect site1="s" site2="t"', 'weld {} torquescale="0" anchor="1 2 3"'],
)  # fmt: skip
def test_gaps_of_closures_are_those_of_mujoco(tmp_path, condition, bodies):
    """At a random pose: of places, and of a weld sin(angle/2), the length of MuJoCo's residual of rotation."""
    path = written(tmp_path, "", TWO, f"<equality><{condition.format(bodies)}/></equality>")
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_integratePos(model, data.qpos, np.random.default_rng(1).normal(size=model.nv), 0.7)
    mujoco.mj_forward(model, data)
    one = robot_of(path, max_size=MAX_SIZE).closures[0]
    frames = {model.body(k).name: (data.xmat[k].reshape(3, 3), data.xpos[k]) for k in range(model.nbody)}
    places, turns = [], []
    for link, frame in zip(one.links, one.frames, strict=True):
        R, x = frames[link]
        places.append(x + R @ frame[:3, 3])
        turns.append(R @ frame[:3, :3])
    np.testing.assert_allclose(places[0] - places[1], data.efc_pos[:3], atol=1e-14)
    assert one.kind == ("weld" if condition.startswith("weld") and "torque" not in condition else "ball")
    if one.kind == "weld":
        cosine = (np.trace(turns[0].T @ turns[1]) - 1) / 2
        np.testing.assert_allclose(np.sqrt((1 - cosine) / 2), np.linalg.norm(data.efc_pos[3:6]), atol=1e-12)


def test_tendons_couple_joints(tmp_path):
    """A condition of two fixed tendons is a coupling of their joints."""
    tendons = '<tendon><fixed name="u"><joint joint="j" coef="2"/><joint joint="k" coef="-1"/></fixed>'
    tendons += '<fixed name="v"><joint joint="s" coef="3"/></fixed></tendon>'
    condition = '<equality><tendon tendon1="u" tendon2="v" polycoef=".2 .5 0 0 0"/></equality>'
    path = written(tmp_path, RAD, ARM.format(j='ref=".3"', k="", x=SLIDE.format("")), tendons + condition)
    (one,) = robot_of(path, max_size=MAX_SIZE).couplings
    assert one.factors == {"j": 2.0, "k": -1.0, "s": -1.5}
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    data.qpos[:] = (0.4, 0.7, -0.2)
    mujoco.mj_forward(model, data)
    at = {name: float(data.qpos[model.joint(name).qposadr[0]]) for name in "jks"}
    row = int(np.flatnonzero(data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY)[0])
    gap = sum(factor * at[name] for name, factor in one.factors.items()) - one.value
    np.testing.assert_allclose(gap, data.efc_pos[row], atol=1e-15)


def fields() -> set[str]:
    return {one.name for one in STRUCTS["mjModel"].fields} - {"opt"} | {f"opt.{one.name}" for one in STRUCTS["mjOption"].fields}


def test_every_field_of_mujoco_has_its_row():
    rows = [
        *mjcf_fields.CARRIED,
        *mjcf_fields.LISTED,
        *(one for some in mjcf_fields.WITHOUT_INFLUENCE.values() for one in some),
    ]
    assert len(rows) == len(set(rows))
    assert set(rows) == fields()
    bits = {name for kind in (mujoco.mjtDisableBit, mujoco.mjtEnableBit) for name in kind.__members__ if "BL_" in name}
    assert {name.split("_")[1] for name in bits} == {one for some in mjcf_fields.FLAGS.values() for one in some}


def test_the_page_has_every_row():
    page = (Path(__file__).parents[2] / "docs" / "exchange.md").read_text()
    groups = {"carried": mjcf_fields.CARRIED, "listed when it is not at its default": tuple(mjcf_fields.LISTED)}
    groups |= {f"no influence on motion: {why}": names for why, names in mjcf_fields.WITHOUT_INFLUENCE.items()}
    rows = [f"| {what} | {', '.join(f'`{name}`' for name in names)} |" for what, names in groups.items()]
    assert [row for row in rows if row not in page] == []


LISTED = {
    # of the whole: before, attributes of the joint, inside the body, after; what is listed
    "density": ('<option density="1.2"/>', "", "", ""), "viscosity": ('<option viscosity="1e-5"/>', "", "", ""),
    "wind": ('<option wind="0 0 1"/>', "", "", ""), "flag sleep": ('<option><flag sleep="enable"/></option>', "", "", ""),
    "gravcomp": ("", "", '<body gravcomp="1"><joint axis="1 0 0"/><geom size=".1"/></body>', ""),
    "range": ("", 'range="-1 2"', "", ""), "actuatorfrcrange": ("", 'actuatorfrcrange="-3 3"', "", ""),
    "stiffness": ("", 'stiffness="3 1"', "", ""), "springyield": ("", 'stiffness="3" springyield=".1"', "", ""),
    "damping": ("", 'damping="1 0 2"', "", ""), "solreffriction": ("", 'frictionloss="1" solreffriction=".5 1"', "", ""),
    "solimpfriction": ("", 'frictionloss="1" solimpfriction=".5 .6 .1 .5 2"', "", ""),
    "solref": ("", "", "", '<equality><joint joint1="j" joint2="k" solref=".5 1"/></equality>'),
    "solimp": ("", "", "", '<equality><joint joint1="j" joint2="k" solimp=".5 .6 .1 .5 2"/></equality>'),
    "joint equality": ("", "", "", '<equality><joint joint1="j" joint2="k" polycoef="0 1 2 0 0"/></equality>'),
    "armature": ("", "", '<body><joint type="ball" armature=".1"/><geom size=".1"/></body>', ""),
    "motor: biasprm, biastype, ctrlrange, forcerange, gainprm": (
        "", "", "",
        '<actuator><general joint="j" ctrlrange="-1 1" forcerange="-2 2" gainprm="3" biastype="affine" biasprm="0 -3 0"/>'
        "</actuator>",
    ),
    "motor": ("", "", '<site name="s"/>', '<actuator><motor site="s" gear="1 0 0 0 0 0"/></actuator>'),
    "body drive": ("", "", "", '<actuator><adhesion body="a" ctrlrange="0 1"/></actuator>'),
    "ball drive": (
        "", "", '<body><joint type="ball" name="o"/><geom size=".1"/></body>', '<actuator><motor joint="o"/></actuator>',
    ),
    "fixed": ("", "", "", '<tendon><fixed stiffness="2"><joint joint="j" coef="1"/></fixed></tendon>'),
    "springlength": (
        "", "", '<site name="s" pos="1 0 0"/><site name="t"/>',
        '<tendon><spatial stiffness="3" springlength="0 .5"><site site="s"/><site site="t"/></spatial></tendon>',
    ),
    "contact": (
        "", "",
        '<body pos="3 0 0"><joint/><geom size="1"/><body><joint/><geom size=".1"/><body><joint axis="1 0 0"/><geom size="1"/>'
        "</body></body></body>", "",
    ),
}  # fmt: skip


@pytest.mark.slow
def test_what_is_not_at_its_default_is_listed_with_its_place(tmp_path):
    arm = '<body name="a">\n<joint name="j" axis="0 1 0" {}/>\n<geom size=".1" contype="0"/>{}</body>'
    other = '<body name="b"><joint name="k" axis="0 1 0"/><geom size=".1" contype="0" conaffinity="0"/></body>'
    for index, (what, (before, joint, inside, after)) in enumerate(LISTED.items()):
        folder = tmp_path / str(index)
        folder.mkdir()
        path = written(folder, before, arm.format(joint, inside) + other, after)
        found = robot_of(path, max_size=MAX_SIZE).left_out
        word = {"body drive": "adhesion", "ball drive": "motor"}.get(what, what.replace("motor:", "general:"))
        place = [one.where for one in found if one.what == word]
        assert place, (what, [str(one) for one in found])
        assert place[0].startswith(f"{path}:"), what


@pytest.mark.slow
@pytest.mark.parametrize(
    ("before", "joint", "mass", "after", "place"),
    [
        ("", "", "-1", "", "body name='a'"), ('<option gravity="0 0 nan"/>', "", "1", "", "option"),
        ("", "", "1", '<actuator><motor joint="j"/><motor joint="j" name="m" gear="nan"/></actuator>', "motor name='m'"),
        ("", 'armature="nan"', "1", "", "joint name='j'"),
    ],
)  # fmt: skip
def test_numbers_that_no_robot_has(tmp_path, before, joint, mass, after, place):
    world = f'<body name="a"><joint name="j" {joint}/><inertial pos="0 0 0" mass="{mass}" diaginertia="1 1 1"/></body>'
    with pytest.raises(kt.ModelError) as error:
        kt.exchange.read(written(tmp_path, before, world, after))
    assert f"<{place}>" in str(error.value)


def test_a_flag_without_influence_is_not_listed(tmp_path):
    flags = '<option><flag invdiscrete="enable" energy="enable" fwdinv="enable" warmstart="disable" island="disable"/></option>'
    world = '<body><joint axis="0 1 0"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>'
    assert robot_of(written(tmp_path, flags, world, ""), max_size=MAX_SIZE).left_out == []


@pytest.mark.parametrize("names", [("m.xml",), ("one.xml", "m.xml"), ("one.xml", "one.xml")])
def test_models_that_attach_each_other_without_end(tmp_path, names):
    text = (
        '<mujoco><asset><model name="x" file="{}"/></asset><worldbody><attach model="x" body="b" prefix="y"/><body name="b"/>'
        "</worldbody></mujoco>"
    )
    for here, there in zip(("m.xml", *names), names, strict=False):
        (tmp_path / here).write_text(text.format(there))
    with pytest.raises(kt.ModelError, match="there is no end"):
        kt.exchange.read(tmp_path / "m.xml")


def test_a_model_that_is_attached_twice(tmp_path):
    arm = (
        '<mujoco><worldbody><body name="b"><joint name="j" axis="0 1 0"/><geom size=".1" mass="2"/></body></worldbody></mujoco>'
    )
    (tmp_path / "arm.xml").write_text(arm)
    path = tmp_path / "m.xml"
    path.write_text(
        '<mujoco><asset><model name="x" file="arm.xml"/><model name="y" file="arm.xml"/></asset><worldbody><attach model="x" '
        'body="b" prefix="one_"/><frame pos="1 0 0"><attach model="y" body="b" prefix="two_"/></frame></worldbody></mujoco>'
    )
    found = robot_of(path, max_size=MAX_SIZE)
    assert [one.name for one in found.pivots] == ["one_j", "two_j"]
    assert all(one.where.startswith(f"{tmp_path / 'arm.xml'}:1 ") for one in found.pivots)


def test_a_model_at_its_defaults_lists_nothing(tmp_path):
    """Or the defaults here are not those of MuJoCo."""
    world = ARM.format(j='frictionloss="1"', k="", x='<site name="s"/>') + '<site name="t" pos="0 0 3"/>'
    after = (
        '<equality><joint joint1="j" joint2="k"/></equality><tendon><spatial stiffness="1" frictionloss="1"><site site="s"/>'
        '<site site="t"/></spatial></tendon><actuator><motor joint="j"/></actuator>'
    )
    found = robot_of(written(tmp_path, RAD, world, after), max_size=MAX_SIZE)
    assert {one.what for one in found.left_out} == {"geom"}


@pytest.mark.slow
def test_motors_that_are_switched_off_drive_nothing(tmp_path):
    actuators = '<actuator><motor joint="j" group="2"/><motor joint="k"/></actuator>'
    path = written(tmp_path, '<option actuatorgroupdisable="2"/>', ARM.format(j="", k="", x=""), actuators)
    robot = robot_of(path, max_size=MAX_SIZE)
    assert [one.drive for one in robot.pivots] == [None, "k"]
    path.write_text(path.read_text().replace("<option ", '<option><flag actuation="disable"/></option><option '))
    robot = robot_of(path, max_size=MAX_SIZE)
    assert [one.drive for one in robot.pivots] == [None, None]
    assert [one.what for one in robot.left_out if "off" in one.why] == ["motor", "motor"]


@pytest.mark.slow
@pytest.mark.parametrize("flag", ["equality", "constraint"])
def test_conditions_that_flags_switch_off(tmp_path, flag):
    after = '<equality><joint joint1="j" joint2="k"/><connect body1="b" anchor="0 0 0"/></equality>'
    option = f'<option><flag {flag}="disable"/></option>'
    robot = robot_of(written(tmp_path, option, ARM.format(j='frictionloss="2"', k="", x=""), after), max_size=MAX_SIZE)
    assert not robot.couplings
    assert not robot.closures
    assert robot.pivots[0].spring[3] == (0.0 if flag == "constraint" else 2.0)
    assert {one.what for one in robot.left_out if "flag" in one.why} == {"joint equality", "connect"}


@pytest.mark.slow
def test_files_of_meshes_that_are_not_there(tmp_path):
    """Named if a mass needs them; otherwise said, and read without."""
    mesh = '<asset><mesh name="m" file="gone.stl"/></asset><compiler meshdir="parts"/>'
    path = written(tmp_path, mesh, ARM.format(j="", k="", x='<geom type="mesh" mesh="m"/>'), "")
    with pytest.raises(
        kt.InputError, match=r"m\.xml:3:1: <mesh name='m'>: names the file '.*gone\.stl', which is not there.*<inertial>"
    ):
        kt.exchange.read(path)
    given = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    path.write_text(path.read_text().replace('<geom type="mesh"', f'{given}<geom type="mesh"'))
    found = kt.exchange.read(path)
    assert found.model.bodies["a"].mass == 1.0
    assert any("gone.stl" in note for note in found.notes)


@pytest.mark.slow
def test_the_process_has_limits(tmp_path, monkeypatch):
    copies = '<replicate count="4000"><replicate count="4000"><body><joint/><geom size=".1"/></body></replicate></replicate>'
    path = written(tmp_path, "", copies, "")
    monkeypatch.setattr(mjcf_compile, "SECONDS", 1)
    with pytest.raises(kt.InputError, match=r"m\.xml:1:1: <mujoco>: takes MuJoCo more than [13] s.*fewer copies"):
        kt.exchange.read(path)
    monkeypatch.setattr(mjcf_compile, "SECONDS", 60)
    monkeypatch.setattr(mjcf_compile, "MEMORY", 2**28)
    with pytest.raises(kt.InputError, match="ends MuJoCo: it needs more than 0.25 GB"):
        kt.exchange.read(path)


@pytest.mark.parametrize(
    ("script", "message"),
    [("import os; os.abort()", "ends MuJoCo with code -6"), ("print('no archive')", "ends MuJoCo with code 0"),
     ("raise ValueError('broken')", "ends MuJoCo with code 1: ValueError: broken"),
     ("import time; time.sleep(60)", "more than 1.5 s")],
)  # fmt: skip
def test_a_process_that_ends_otherwise(tmp_path, monkeypatch, script, message):
    (tmp_path / "child.py").write_text(script)
    monkeypatch.setattr(mjcf_compile.mjcf_child, "__file__", str(tmp_path / "child.py"))
    if "sleep" in script:
        monkeypatch.setattr(mjcf_compile, "SECONDS", 0.5)
    with pytest.raises(kt.InputError, match=message):
        kt.exchange.read(written(tmp_path, "", ARM.format(j="", k="", x=""), ""))


def test_without_mujoco(tmp_path, monkeypatch):
    path = written(tmp_path, "", ARM.format(j="", k="", x=""), "")
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(kt.InputError, match=r"needs the package mujoco. Install it: pip install 'kinetruss\[exchange\]'"):
        kt.exchange.read(path)
