"""Cells from CSV tables, and cells in model files."""

import pytest

import kinetruss as kt
from kinetruss.library import cells

NODES = """# a panel of 1 m x 0.8 m
node,x [mm],y [mm],mass [kg],face.base,face.top
A,0,0,,1,
B,1000,0,,2,
C,0,800,1.5,,1
D,1000,800,,,2
"""
MEMBERS = """member,from,to,kind,section
left,A,C,,
right,B,D,,tube_lacy_planar
top,C,D,,
brace,A,D,active,
"""
PANEL = cells.cell(
    nodes={"A": (0, 0), "B": (1, 0), "C": {"at": (0, 0.8), "mass": 1.5}, "D": (1, 0.8)},
    bars={
        "left": ("A", "C"), "right": {"ends": ("B", "D"), "section": "tube_lacy_planar"},
        "top": ("C", "D"), "brace": ("A", "D"),
    },
    faces={"base": ["A", "B"], "top": ["C", "D"]},
    active=["brace"],
)  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "nodes.csv").write_text(NODES, encoding="utf-8")
    (tmp_path / "members.csv").write_text(MEMBERS, encoding="utf-8")
    return tmp_path


def read(folder, library):
    path = folder / "model.yaml"
    path.write_text(f"kinetruss: 1\nlibrary:\n{library}", encoding="utf-8")
    return kt.read(path)


def test_two_tables_are_a_cell(folder):
    assert kt.io.read_cell(folder / "nodes.csv", folder / "members.csv") == PANEL
    more = kt.io.read_cell(folder / "nodes.csv", folder / "members.csv", faces={"side": ["D", "B"]}, active="left")
    assert list(more.faces) == ["base", "top", "side"]
    assert [name for name, bar in more.bars.items() if bar.kind == "driven"] == ["left", "brace"]


def test_a_file_stacks_cells_of_tables_beside_it(folder):
    model = read(folder, "  name: cells.stack\n  cells: [{nodes: nodes.csv, bars: members.csv, count: 3}]\n")
    assert model == cells.stack([PANEL] * 3)
    assert kt.kinematics.mobility(model).undriven == 0
    kt.write(model, folder / "whole.yaml")
    assert kt.read(folder / "whole.yaml") == model


def test_a_file_has_every_assembly(folder):
    bay = "{kind: double_octahedron, base: 1.2 m, longeron: 0.9 m"
    stack = read(
        folder, f"  name: cells.stack\n  cells: [{bay}, count: 5}}, {bay}, beta: 5 deg, section: tube_lacy_planar}}]\n"
    )
    one = {"base": 1.2, "longeron": 0.9}
    last = cells.double_octahedron(**one, beta="5 deg", section="tube_lacy_planar")
    assert stack == cells.stack([cells.double_octahedron(**one)] * 5 + [last])
    ring = read(folder, "  name: cells.ring\n  cells: [{kind: panel, lean: 60 deg, count: 6}]\n")
    assert ring == cells.ring([cells.panel(lean="60 deg")] * 6)
    branch = read(
        folder, "  name: cells.branch\n  hub: {kind: cube}\n  arms: {top: {kind: cube}, side1: [{kind: cube, count: 2}]}\n"
    )
    assert branch == cells.branch(cells.cube(), {"top": cells.cube(), "side1": [cells.cube()] * 2})
    text = """  name: cells.assemble
  cells:
    hub: {kind: octahedron, side: 1 m}
    arm: {kind: chain, on: hub.side1, cells: [{kind: octahedron, count: 2, active: "batten[4-6]"}]}
    tip: {kind: tetrahedron, on: arm, turn: 1, mirrored: x}
  links: {stay: [hub.N6, arm.B2.N4]}
"""
    arm = cells.chain([cells.octahedron(active="batten[4-6]")] * 2, on="hub.side1")
    tip = cells.tetrahedron(on="arm", turn=1, mirrored="x")
    expected = cells.assemble({"hub": cells.octahedron(), "arm": arm, "tip": tip}, links={"stay": ("hub.N6", "arm.B2.N4")})
    assert read(folder, text) == expected


def test_faults_of_a_file_have_their_place(folder):
    with pytest.raises(kt.ModelError, match=r"model\.yaml:5:\d+: library\.cells\.1\.sid: 'sid' is not known here"):
        read(folder, "  name: cells.stack\n  cells: [{kind: octahedron},\n    {kind: octahedron, sid: 1 m}]\n")
    with pytest.raises(kt.ModelError, match=r"library\.cells\.0\.longeron: 0\.5 m cannot span"):
        read(folder, "  name: cells.stack\n  cells: [{kind: double_octahedron, longeron: 0.5 m}]\n")
    with pytest.raises(kt.ModelError, match=r"library\.cells\.B2: B2\.base has 4 corners, B1\.top has 3"):
        read(folder, "  name: cells.stack\n  cells: [{kind: octahedron}, {kind: cube}]\n")
    with pytest.raises(kt.ModelError, match=r"none\.csv: library: there is no such file"):
        read(folder, "  name: cells.stack\n  cells: [{nodes: none.csv, bars: members.csv}]\n")


@pytest.mark.parametrize(
    ("nodes", "members", "message"),
    [
        (NODES.replace("x [mm]", "x"), MEMBERS,
         r"nodes\.csv:2:1: .*column 'x' has no unit\. Write it in the header, e\.g\. x \[m\]"),
        (NODES.replace("y [mm]", "y [kg]"), MEMBERS, r"column 'y' has the unit \[kg\], no unit of length\. Write e\.g\. \[m\]"),
        (NODES.replace("y [mm]", "why"), MEMBERS, r"(?s)column 'why' is not known here.*column 'y' is missing\. Add it"),
        (NODES.replace("800,1.5", "high,1.5"), MEMBERS, r"nodes\.csv:5:1: .*'high' is not a number, in column 'y'"),
        (NODES.replace("\nD,", "\nC,"), MEMBERS, r"nodes\.csv:6:1: .*'C' is no new name of a node"),
        (NODES.replace(",,2,", ",,1,"), MEMBERS, r"'1' is no free number of a corner, in column face\.base"),
        (NODES, MEMBERS.replace(",to,", ",until,"), r"members\.csv:1:1: .*column 'to' is missing"),
        (NODES, MEMBERS.replace("active", "activ"), r"members\.csv:5:1: .*kind 'activ' is not known\. Did you mean 'active'"),
        (NODES, MEMBERS + "x,A\n", r"members\.csv:6:1: .*has 2 cells; the header has 5"),
        (NODES, "", r"members\.csv:1:1: .*has no rows\. Give a header \(member, from, to\)"),
        (NODES, MEMBERS.replace("A,D", "A,Z"), r"bars\.brace: there is no node 'Z' in the cell"),
    ],
)  # fmt: skip
def test_faulty_tables_are_named(folder, nodes, members, message):
    (folder / "nodes.csv").write_text(nodes, encoding="utf-8")
    (folder / "members.csv").write_text(members, encoding="utf-8")
    with pytest.raises(kt.ModelError, match=message):
        kt.io.read_cell(folder / "nodes.csv", folder / "members.csv")
