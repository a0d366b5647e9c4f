"""What is written for other programs, read by them: masses, places, motions, inverse dynamics; and read back."""

from pathlib import Path
from xml.etree import ElementTree as ET

import ezdxf
import meshio
import mujoco
import numpy as np
import pytest
import yaml

import kinetruss as kt
from kinetruss import runs
from reference.loops import MujocoTree, PinocchioTree
from samples import fourbar, tripod

DATA = Path(__file__).parents[1] / "data"
FIVE = {"motor_left": (0.0, -0.5), "motor_right": (0.0, 0.6)}


def five_bar() -> kt.Model:
    return kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml").model.with_(springs={})


def along(model: kt.Model, moves, written) -> tuple[np.ndarray, list[np.ndarray]]:
    """Drive forces of a motion, and values of the joints in the file, their rates and accelerations."""
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=7)
    forces = kt.dynamics.inverse(model, motion)
    names = list(moves)
    given = [getattr(motion, key).sel(drive=names).values for key in ("drive_position", "drive_velocity", "drive_acceleration")]
    given[0] = given[0] - [written.offsets[name] for name in names]
    return forces.drive_force.sel(drive=names).values, given


def agree(found, wanted, tolerance=1e-10):
    assert np.abs(wanted).max() > 0.01
    np.testing.assert_allclose(found, wanted, rtol=0, atol=tolerance * np.abs(wanted).max())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("make", "moves"),
    [
        (five_bar, FIVE),
        (lambda: fourbar(21), {"motor": None}),
        (kt.library.mechanisms.delta, {f"arm{k}": None for k in (1, 2, 3)}),
    ],
    ids=["five_bar", "fourbar", "delta"],
)
def test_inverse_dynamics_of_what_is_written(tmp_path, make, moves):
    model = make()
    xml = kt.exchange.write(model, tmp_path / "robot.xml")
    urdf = kt.exchange.write(model, tmp_path / "robot.urdf")
    steps = dict(zip(moves, (0.35, -0.25, 0.15), strict=False))
    moves = {name: (xml.offsets[name], xml.offsets[name] + steps[name]) for name in moves}
    found, given = along(model, moves, xml)
    # rods have no moment about their line here; MuJoCo needs one, 1e-12 of the others
    agree(found, MujocoTree(xml.files[0], list(moves)).torques(*given))
    beside = yaml.safe_load(urdf.files[1].read_text())
    tree = PinocchioTree(urdf.files[0], [tuple(pair) for pair in beside["closed_loop"]], list(moves), beside["joint_name"])
    tree.model.gravity.linear[:] = (*(model.gravity or (0, 0)), 0.0)[:3]
    agree(found, tree.torques(*given))
    # and back: another model of the same robot
    gravity = (*(model.gravity or (0, 0)), 0.0)[:3]
    for back in (kt.exchange.read(xml.files[0]), kt.exchange.read(urdf.files[0], closures=urdf.files[1])):
        assert back.freedoms == kt.kinematics.mobility(model).degrees_of_freedom
        again, _ = along(back.model.with_(gravity=gravity), {name: (0.0, steps[name]) for name in moves}, xml)
        agree(again, found)


@pytest.mark.slow
def test_masses_and_places_in_mujoco(tmp_path):
    model = kt.exchange.read(DATA / "parallel.xml").model
    written = kt.exchange.write(model, tmp_path / "arms.xml")
    ours, theirs = mujoco.MjModel.from_xml_path(str(written.files[0])), mujoco.MjModel.from_xml_path(str(DATA / "parallel.xml"))
    own, given = mujoco.MjData(ours), mujoco.MjData(theirs)
    mujoco.mj_forward(ours, own)
    mujoco.mj_forward(theirs, given)
    for name in ("arm1", "rod2b", "platform"):
        one, two = ours.body(name).id, theirs.body(name).id
        np.testing.assert_allclose(ours.body_mass[one], theirs.body_mass[two], rtol=1e-13)
        np.testing.assert_allclose(own.xipos[one], given.xipos[two], atol=1e-13)
        tensors = [m.ximat[k].reshape(3, 3) @ np.diag(i) @ m.ximat[k].reshape(3, 3).T
                   for m, k, i in ((own, one, ours.body_inertia[one]), (given, two, theirs.body_inertia[two]))]  # fmt: skip
        np.testing.assert_allclose(*tensors, atol=1e-11 * tensors[1].max())


def test_a_tendon_and_a_slider_have_the_force_of_the_leg(tmp_path):
    """Six driven lengths: tendons of MuJoCo, sliders of URDF."""
    model = kt.library.mechanisms.stewart(platform_mass=12.0)
    legs = [f"leg{k}" for k in range(1, 7)]
    forces = kt.statics.at_poses(model, [{}]).drive_force.sel(drive=legs).values[0]
    written = kt.exchange.write(model, tmp_path / "hexapod.xml")
    mj = mujoco.MjModel.from_xml_path(str(written.files[0]))
    data = mujoco.MjData(mj)
    mujoco.mj_inverse(mj, data)
    moments = np.zeros((mj.nu, mj.nv))
    mujoco.mju_sparse2dense(moments, data.actuator_moment, data.moment_rownnz, data.moment_rowadr, data.moment_colind)
    order = [mj.actuator(name).id for name in legs]
    np.testing.assert_allclose(moments[order].T @ forces, data.qfrc_inverse, atol=1e-10 * np.abs(forces).max())
    urdf = kt.exchange.write(model, tmp_path / "hexapod.urdf")
    back = kt.exchange.read(urdf.files[0], closures=urdf.files[1])
    assert back.freedoms == 6
    assert len(back.closures) == 6
    again = kt.statics.at_poses(back.model, [{}]).drive_force.sel(drive=legs).values[0]
    np.testing.assert_allclose(again, forces, atol=1e-9 * np.abs(forces).max())


def test_dxf_and_back(tmp_path):
    model = tripod(5)
    written = kt.exchange.write(model, tmp_path / "tripod.dxf")
    drawing = ezdxf.readfile(written.files[0])
    assert drawing.header["$INSUNITS"] == 6
    assert len(drawing.modelspace().query("LINE")) == len(model.members)
    back = kt.exchange.read(written.files[0]).model
    assert set(back.members) == set(model.members)
    assert len(back.fixed) == len(model.fixed)
    for name, member in model.members.items():
        ends = {tuple(model.nodes[node].at) for node in member.ends}
        assert {tuple(back.nodes[node].at) for node in back.members[name].ends} == ends
        assert (back.bars[name].kind == "driven") == (name in model.driven_members)


@pytest.mark.slow
def test_vtu_and_pvd_of_a_run(tmp_path):
    model = tripod(5)
    run = runs.run(model, out=tmp_path / "run")
    written = kt.exchange.write(run, tmp_path / "film.pvd")
    assert len(written.files) == 6
    grid = meshio.read(written.files[3])
    np.testing.assert_array_equal(grid.points, run.motion.position.values[2])
    np.testing.assert_array_equal(grid.point_data["velocity"], run.motion.velocity.values[2])
    case = next(iter(run.forces.values()))
    np.testing.assert_array_equal(grid.cell_data["force"][0], case.member_force.values[2])
    times = [float(one.attrib["timestep"]) for one in ET.parse(written.files[0]).getroot().iter("DataSet")]
    np.testing.assert_array_equal(times, run.motion.time.values)
    pose = kt.exchange.write(run, tmp_path / "pose.vtu", time=float(times[2]))
    np.testing.assert_array_equal(meshio.read(pose.files[0]).points, grid.points)


def test_stl_is_closed_and_has_the_volume(tmp_path):
    corners = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "D": (0, 0, 1)}
    body = kt.Model(nodes=corners, bodies={"stone": kt.Body(nodes=tuple(corners), mass=1.0)})
    written = kt.exchange.write(body, tmp_path / "stone.stl")
    found = kt.library.bodies.from_stl(written.files[0], density=6.0)
    np.testing.assert_allclose(found.mass, 1.0, rtol=1e-6)
    bar = kt.Model(nodes={"A": (0, 0, 0), "B": (1, 2, 2)}, bars={"b": ("A", "B")}, section=kt.Rod(diameter=0.2))
    volume = kt.library.bodies.from_stl(kt.exchange.write(bar, tmp_path / "bar.stl").files[0], density=1.0).mass
    np.testing.assert_allclose(volume, 3 * 8 * 0.01 * np.sin(np.pi / 8), rtol=1e-5)  # a prism of sixteen sides
    assert len(meshio.read(tmp_path / "bar.stl").cells_dict["triangle"]) == 64


def test_files_that_are_there_stay(tmp_path):
    path = tmp_path / "arm.xml"
    path.write_text("mine")
    with pytest.raises(kt.InputError, match="is there already"):
        kt.exchange.write(five_bar(), path)
    assert path.read_text() == "mine"
    kt.exchange.write(five_bar(), path, overwrite=True)
    assert path.read_text().startswith("<mujoco")


def test_what_is_left_out_is_named(tmp_path):
    soft = kt.Spring(coordinate=kt.AngleDrive("crank"), stiffness=2.0, play=0.1, friction=0.2, slip=0.01)
    model = fourbar(5).with_(springs={"soft": soft})
    model = model.with_(bars=model.bars | {"string": kt.Bar(ends=("A", "C"), kind="cable", stiffness=3.0)})
    written = kt.exchange.write(model, tmp_path / "fourbar.xml")
    assert ("cable bar", "string") in {(one.what, one.where) for one in written.left_out}
    assert {(one.what, one.where) for one in written.left_out} >= {("play of a spring", "soft"), ("slip of a spring", "soft")}
    stiff = model.with_(springs={"soft": soft.with_(play=0.0)})
    written = kt.exchange.write(stiff, tmp_path / "fourbar.urdf")
    assert "URDF has no springs" in {one.why for one in written.left_out}


def test_an_active_member_with_mass_becomes_two_rods_and_a_slide(tmp_path):
    """Inverse dynamics of a driven triangle: base and tube slide in each other, in MuJoCo and back."""
    base = kt.Part(length=0.5, mass=3.0, masses=(kt.PointMass(at=0.2, mass=0.8),))
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 0.2, 0), "T": kt.Node(at=(0.6, 0.1, 0.8), mass=2.0)},
        fixed=["A", "B", "C"],
        bars={"a": kt.Bar(ends=("A", "T"), mass=0.7), "c": kt.Bar(ends=("C", "T"), mass=0.4)}, gravity=(0, 0, -9.81),
        active={"jack": kt.Active(ends=("B", "T"), base=base, tube=kt.Part(length=0.6, mass=1.5))},
    )  # fmt: skip
    start = float(np.linalg.norm(np.array(model.nodes["T"].at) - (1, 0, 0)))
    written = kt.exchange.write(model, tmp_path / "jack.xml")
    assert written.offsets["jack"] == pytest.approx(start, abs=1e-12)
    found, given = along(model, {"jack": (start, start + 0.1)}, written)
    agree(found, MujocoTree(written.files[0], ["jack"]).torques(*given), 1e-9)
