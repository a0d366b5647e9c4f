"""Broken files: what, where, expected and the fix; never a traceback, and nothing half written."""

from __future__ import annotations

import os
import random
import warnings
from pathlib import Path

import compas
import meshio
import pytest
from click.testing import CliRunner
from compas.datastructures import Graph

import kinetruss as kt
from kinetruss.cli import main

DATA = Path(__file__).parents[1] / "data"
ROUNDS = int(os.environ.get("KINETRUSS_EXCHANGE_ROUNDS", "40"))
URDF = (DATA / "robot.urdf").read_text()
MJCF = (DATA / "parallel.xml").read_text()
CLOSURES = (DATA / "robot.yaml").read_text()

CASES = [
    ("robot.urdf", URDF.replace("</robot>", ""), r"robot\.urdf:\d+:\d+: .*is not XML: no element found"),
    ("robot.urdf", '<!DOCTYPE r [<!ENTITY a "b">]>' + URDF.split("?>", 1)[1], r"robot\.urdf:1:\d+: .*document type"),
    ("robot.urdf", "<model/>", r"robot\.urdf:1:1: <model>: is the outermost element; expected <robot>"),
    (
        "robot.urdf",
        URDF.replace('<mass value="0.8"/>', '<mass value="0,8"/>'),
        r"robot\.urdf:8:1: <mass>: value is '0,8', which",
    ),
    ("robot.urdf", URDF.replace('<mass value="0.8"/>', '<mass value="nan"/>'), r"not finite"),
    ("robot.urdf", URDF.replace('<mass value="0.8"/>', ""), r"<inertial>: has no <mass>"),
    ("robot.urdf", URDF.replace('<mass value="0.8"/>', '<mass value="-1"/>'), r"mass -1 kg"),
    ("robot.urdf", URDF.replace('ixx="0.0006"', 'ixx="0.1"'), r"robot\.urdf:9 .*left_upper.*inertia.*Correct the masses"),
    (
        "robot.urdf",
        URDF.replace('parent link="left_upper"', 'parent link="left_uper"'),
        r"'left_uper'.*Did you mean 'left_upper'",
    ),
    ("robot.urdf", URDF.replace('child link="tool"', 'child link="left_lower"'), r"is the second joint that holds the link"),
    ("robot.urdf", URDF.replace('parent link="left_upper"', 'parent link="left_lower"'), r"belongs to a circle of links"),
    ("robot.urdf", URDF.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>', 1), r"axis without direction"),
    ("robot.urdf", URDF.replace('type="continuous"', 'type="screw"'), r"has the type 'screw', which is not carried"),
    ("robot.urdf", URDF.replace('<link name="tool">', '<link name="base">'), r"has the name of the link in line 4"),
    ("robot.urdf", '<robot name="r"/>', r"has no links"),
    ("arm.xml", MJCF.replace("</mujoco>", ""), r"arm\.xml:\d+:\d+: .*is not XML"),
    (
        "arm.xml",
        MJCF.replace('body2="platform"', 'body2="platfrm"', 1),
        r"arm\.xml:60:1: <connect name='ball1a'>: MuJoCo .* refuses it: unknown element 'platfrm'.*Did you mean 'platform'",
    ),
    ("arm.xml", MJCF.replace('childclass="rod"', 'childclass="rot"', 1), r"unknown default childclass.*Did you mean 'rod'"),
    ("arm.xml", MJCF.replace('joint="motor2"', 'joint="motor4"'), r"<motor.*>: .* target 'motor4'.*Did you mean"),
    ("arm.xml", MJCF.replace('type="box"', 'type="mesh"', 1), r"arm\.xml:\d+:1: <geom.*>: .*mesh"),
    ("arm.xml", MJCF.replace("<worldbody>", '<worldbody><replicate count="x"/>'), r"<replicate>: .*'count'"),
    ("arm.xml", MJCF.replace('angle="radian"', 'coordinate="global"'), r"<compiler>: .*global coordinates"),
    (
        "arm.xml",
        MJCF.replace('size="0.01" density', 'size="0" density'),
        r"arm\.xml:\d+:1: <geom.*>: .*size 0 must be positive",
    ),
    (
        "arm.xml",
        MJCF.replace('name="arm1" pos="0.2', 'name="arm1" pos="nan'),
        r"<body name='arm1'>: has a number that is not finite",
    ),
    ("arm.xml", "<mujoco/>", r"has no <worldbody>"),
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "text", "message"), CASES, ids=range(len(CASES)))
def test_faults_of_robots(tmp_path, name, text, message):
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(kt.InputError, match=message):
        kt.exchange.read(path, closures=DATA / "robot.yaml" if name.endswith("urdf") else None)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("closed_loop: [[tip_left, tip]]\ntype: [3d]", r"c\.yaml:1:\d+: .*no link or joint called 'tip'"),
        ("closed_loop: [[tip_left, tip_right]]\ntype: [3d, 6d]", r"closed_loop has 1 entry, type 2"),
        ("closed_loop: [[tip_left, tip_right]]\ntype: [4d]", r"type '4d' is not known.*Did you mean"),
        ("closed_loop: [tip_left, tip_right]", r"a closure names two frames"),
        ("closed_loop: [[tip_left, tip_left]]", r"closes 'tip_left' with itself"),
        ("name_mot: [motor]", r"no joint called 'motor' in the URDF"),
        ("joint_name: [elbow_left]\njoint_type: [SCREW]", r"joint_type 'SCREW' is not known"),
        ("nodes: {}", r"names no closures"),
        ("closed_loop: [[", r"c\.yaml:2:1: .*is not YAML"),
        ("", r"is empty"),
    ],
)
def test_faults_of_closures(tmp_path, text, message):
    (tmp_path / "c.yaml").write_text(text)
    with pytest.raises(kt.InputError, match=message):
        kt.exchange.read(DATA / "robot.urdf", closures=tmp_path / "c.yaml")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"dtype": "a/Graph", "data": {', r"g\.json:1:\d+: .*is not JSON"),
        ('{"dtype": "a/Graph", "data": {"node": {"0": {"x": "1"}}, "edge": {}}}', r"data\.node\.0: has the coordinates"),
        ('{"dtype": "a/Graph", "data": {"node": {"0": {"x": NaN}}, "edge": {}}}', r"holds NaN"),
        ('{"dtype": "a/Graph", "data": {"node": {"0": {}}, "edge": {"0": {"7": {}}}}}', r"data\.edge\.0\.7: names node '7'"),
        ('{"dtype": "a/Graph", "data": {"node": {}, "edge": {}}}', r"has no lines"),
        ('{"dtype": "a/Frame", "data": {}}', r"holds 0 graphs"),
        ('{"dtype": "a/Mesh", "data": {"vertex": {"0": {}}, "face": {"0": 3}}}', r"data\.face\.0: is 3; expected corners"),
    ],
)
def test_faults_of_graphs(tmp_path, text, message):
    (tmp_path / "g.json").write_text(text)
    with pytest.raises(kt.InputError, match=message):
        kt.exchange.read(tmp_path / "g.json")


@pytest.mark.slow
def test_import_writes_a_whole_model_or_nothing(tmp_path):
    out = tmp_path / "model.yaml"
    run = CliRunner()
    broken = tmp_path / "broken.urdf"
    broken.write_text(URDF.replace("</robot>", ""))
    done = run.invoke(main, ["import", str(broken), "-o", str(out)])
    assert (done.exit_code, list(tmp_path.iterdir())) == (2, [broken])
    arguments = ["import", str(DATA / "robot.urdf"), "--closures", str(DATA / "robot.yaml"), "-o", str(out)]
    done = run.invoke(main, [*arguments, "--at", "motor_left=-5 deg"])
    assert done.exit_code == 0, done.output
    assert "1 loop; joints and closures leave 2 freedoms" in done.output
    assert "1 condition of it is redundant: the rest of the robot implies it" in done.output
    assert "limit: a model has no limits at joints" in done.output
    assert "robot.urdf:33 <joint name='motor_left'>" in done.output
    model = kt.read(out)
    assert list(model.drives) == ["motor_left", "motor_right"]
    assert run.invoke(main, ["info", str(out)]).exit_code == 0
    out.write_text(out.read_text() + done.output.split("add a run: ")[1])
    assert run.invoke(main, ["run", str(out), "-o", str(tmp_path / "run")]).exit_code == 0
    done = run.invoke(main, arguments)
    assert done.exit_code == 2
    assert "is there already" in done.output
    assert run.invoke(main, [*arguments, "--overwrite", "--json"]).exit_code == 0
    done = run.invoke(main, ["import", str(out), "-o", str(out), "--overwrite"])
    assert "is the file to import itself" in done.output
    done = run.invoke(main, ["export", str(out), str(tmp_path / "back.urdf")])
    assert done.exit_code == 0, done.output
    assert (tmp_path / "back.closures.yaml").exists()
    assert run.invoke(main, ["export", str(out), str(tmp_path / "back.csv")]).exit_code == 2


def originals(folder: Path) -> list[tuple[Path, dict[str, object]]]:
    """One good file of each kind, with the options that it needs."""
    import ezdxf

    document = ezdxf.new(units=6)
    document.modelspace().add_lwpolyline([(0, 0), (500, 800), (1000, 0)])
    document.saveas(folder / "a.dxf")
    graph = Graph()
    graph.add_edge(graph.add_node(x=0, y=0, z=0), graph.add_node(x=1, y=0, z=1))
    compas.json_dump(graph, folder / "g.json")
    points, cells = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]], [("line", [[0, 1], [1, 2]]), ("tetra", [[0, 1, 2, 3]])]
    for name, kind in (("m.vtu", "vtu"), ("m.msh", "gmsh22"), ("m.vtk", "vtk")):
        meshio.Mesh(points, cells).write(folder / name, file_format=kind)
    (folder / "n.csv").write_text("node,x [mm],y [mm]\nA,0,0\nB,1000,0\nC,500,800\n")
    (folder / "b.csv").write_text("member,from,to\na,A,C\nb,B,C\n")
    for name, text in (("r.urdf", URDF), ("p.xml", MJCF), ("c.yaml", CLOSURES)):
        (folder / name).write_text(text)
    mesh = {"material": "steel_s235"}
    robots = [("r.urdf", {"closures": DATA / "robot.yaml"}), ("c.yaml", {}), ("p.xml", {})]
    lines = [("a.dxf", {}), ("g.json", {}), ("n.csv", {"members": folder / "b.csv"}), ("b.csv", {})]
    meshes = [(name, mesh) for name in ("m.vtu", "m.msh", "m.vtk")]
    return [(folder / name, dict(options)) for name, options in (*robots, *lines, *meshes)]


def damaged(data: bytes, chance: random.Random) -> bytes:
    """Cut off, with bytes changed, with a piece twice or missing, or with another number."""
    at, end = sorted((chance.randrange(len(data)), chance.randrange(len(data))))
    kind = chance.randrange(6)
    if kind == 0:
        return data[:at]
    if kind == 1:
        return data[:at] + bytes([chance.randrange(256)]) + data[at + 1 :]
    if kind == 2:
        return data[:at] + data[min(end, at + 40) :]
    if kind == 3:
        return data[:end] + data[at : at + 60] + data[end:]
    words = [b"1e400", b"-1", b"nan", b"", b"0", b"999999999", b"[]", b"<a/>", b'"', b"\x00", b"\xff"]
    digits = [k for k, byte in enumerate(data) if 48 <= byte <= 57]
    spot = chance.choice(digits or range(len(data)))
    return data[:spot] + chance.choice(words) + data[spot + 1 :]


@pytest.mark.slow
def test_damaged_files_give_models_or_errors_of_kinetruss(tmp_path):
    chance = random.Random(1)
    files = originals(tmp_path)
    bad = tmp_path / "bad"
    bad.mkdir()
    read, refused = 0, 0
    for path, options in files:
        for _ in range(ROUNDS):
            target = bad / path.name
            target.write_bytes(damaged(path.read_bytes(), chance))
            what, given = target, dict(options)
            if path.name == "c.yaml":
                what, given = DATA / "robot.urdf", {"closures": target}
            elif path.name == "b.csv":
                what, given = tmp_path / "n.csv", {"members": target}
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    kt.exchange.read(what, **given)
                read += 1
            except kt.KinetrussError as error:
                refused += 1
                assert str(error).strip()
    assert read > 0
    assert refused > ROUNDS
