"""Drawings, tables, graphs and meshes of other programs as models."""

from __future__ import annotations

from pathlib import Path

import compas
import ezdxf
import meshio
import numpy as np
import pytest
from click.testing import CliRunner
from compas.datastructures import Graph, Mesh

import kinetruss as kt
from kinetruss.cli import main

PLACES = {"A": (0.0, 0.0), "B": (1.0, 0.0), "C": (0.5, 0.8)}


def drawing(path: Path, **given: object) -> Path:
    """A triangle in mm with a driven line, supports and a label."""
    document = ezdxf.new(units=4)
    space = document.modelspace()
    space.add_line((0, 0, 0), (1000, 0, 0), dxfattribs={"layer": "chord"})
    space.add_lwpolyline([(0, 0), (500, 800), (1000, 0.0004)], dxfattribs={"layer": "web"})
    space.add_polyline3d([(500, 800, 0), (500, 0, 0)], dxfattribs={"layer": "Active jacks"})
    space.add_line((0, 0, 0), (1000, 0, 0))
    space.add_circle((0, 0), 20, dxfattribs={"layer": "SUPPORTS"})
    space.add_point((1000, 0), dxfattribs={"layer": "SUPPORTS"})
    space.add_circle((700, 700), 20, dxfattribs={"layer": "SUPPORTS"})
    space.add_text("mast", dxfattribs={"insert": (505, 400)})
    space.add_arc((0, 0), 5, 0, 90)
    document.saveas(path)
    return path


def test_dxf(tmp_path):
    found = kt.exchange.read(drawing(tmp_path / "mast.dxf"))
    model = found.model
    assert list(model.bars) == ["chord.1", "web.1", "web.2", "mast"]
    assert model.bars["mast"].kind == "driven"
    assert [tuple(node.at) for node in model.nodes.values()] == [(0, 0), (1, 0), (0.5, 0.8), (0.5, 0)]
    assert dict(model.fixed) == {"n1": "xy", "n2": "xy"}
    assert sorted(one.what for one in found.left_out) == ["ARC", "line", "support"]
    coarse = kt.exchange.read(tmp_path / "mast.dxf", tolerance="600 mm", active=["web"], fixed=["chord"])
    assert len(coarse.model.nodes) == 2
    assert not coarse.model.fixed


def test_dxf_blocks_curves_and_crossings(tmp_path):
    """A brace drawn once as a block, put in turned, larger, and in a row; a quarter circle; lines that only cross."""
    document = ezdxf.new(units=5)
    brace = document.blocks.new("BRACE")
    brace.add_line((0, 0), (100, 0))
    brace.add_line((0, 0), (0, 100), dxfattribs={"layer": "post"})
    outer = document.blocks.new("PAIR")
    outer.add_blockref("BRACE", (0, 0), dxfattribs={"xscale": 2, "yscale": 2, "rotation": 90})
    space = document.modelspace()
    space.add_blockref("PAIR", (1000, 0), dxfattribs={"layer": "web"})
    row = space.add_blockref("BRACE", (0, 0), dxfattribs={"layer": "row"})
    row.dxf.column_count, row.dxf.column_spacing = 3, 100
    space.add_arc((0, 500), 100, 0, 90, dxfattribs={"layer": "rim"})
    space.add_line((0, 300), (100, 400), dxfattribs={"layer": "x"})
    space.add_line((0, 400), (100, 300), dxfattribs={"layer": "x"})
    space.add_line((50, 0), (50, -50), dxfattribs={"layer": "tee"})
    space.add_blockref("LOST", (0, 0))
    path = tmp_path / "blocks.dxf"
    document.saveas(path)
    found = kt.exchange.read(path, arcs=16)
    bars = found.model.bars
    assert [name for name in bars if name[:3] not in ("rim", "x.1", "x.2", "tee")] == [
        "web.1", "post.1", "row.1", "post.2", "row.2", "post.3", "row.3", "post.4",
    ]  # fmt: skip
    at = found.model.nodes
    np.testing.assert_allclose([at[end].at for end in bars["web.1"].ends], [(10, 0), (10, 2)], atol=1e-12)
    np.testing.assert_allclose([at[end].at for end in bars["post.1"].ends], [(10, 0), (8, 0)], atol=1e-12)
    rim = np.array([at[end].at for name, bar in bars.items() if name.startswith("rim") for end in bar.ends])
    assert len(rim) == 8
    np.testing.assert_allclose(np.linalg.norm(rim - (0, 5), axis=1), 1.0, atol=1e-12)
    assert [text.strip() for text in found.notes[1:3]] == ["row.1 and tee.1 at (0.5, 0, 0) m", "x.1 and x.2 at (0.5, 3.5, 0) m"]
    assert [(one.what, one.why) for one in found.left_out] == [("INSERT", "the block 'LOST' is not in the file")]
    bare = kt.exchange.read(path, skip=["x", "R*"])
    assert not {name[0] for name in bare.model.bars} & {"x", "r"}
    assert sum(one.why == "its layer is skipped" for one in bare.left_out) == 4
    plain = kt.exchange.read(path)
    assert "give --arcs N" in next(one.why for one in plain.left_out if one.what == "ARC")
    with pytest.raises(kt.InputError, match="arcs is 2. Give 3 to 360"):
        kt.exchange.read(path, arcs=2)


def test_dxf_what_is_hidden(tmp_path):
    """Layers that are off or frozen, in blocks too, and invisible entities are left out and named, or taken on request."""
    document = ezdxf.new("R2010", units=6)
    space, layers = document.modelspace(), document.layers
    layers.add("Off").off()
    layers.add("ice").freeze()
    block = document.blocks.new("FRAME")
    block.add_line((0, 0), (1, 0))  # on the layer of the insertion
    block.add_line((0, 0), (0, 1), dxfattribs={"layer": "web"})
    block.add_line((1, 0), (0, 1), dxfattribs={"layer": "ICE"})
    block.add_line((1, 0), (1, 1), dxfattribs={"invisible": 1})
    space.add_line((0, 5), (1, 5), dxfattribs={"layer": "seen"})
    space.add_line((0, 6), (1, 6), dxfattribs={"layer": "OFF"})
    space.add_point((0, 5), dxfattribs={"layer": "ice"})
    space.add_blockref("FRAME", (0, 0), dxfattribs={"layer": "seen"})
    space.add_blockref("FRAME", (10, 0), dxfattribs={"layer": "off"})  # its lines on other layers are seen
    space.add_blockref("FRAME", (20, 0), dxfattribs={"layer": "ice"})  # nothing of it is
    space.add_blockref("FRAME", (30, 0), dxfattribs={"layer": "seen", "invisible": 1})
    path = tmp_path / "hidden.dxf"
    document.saveas(path)
    found = kt.exchange.read(path)
    assert list(found.model.bars) == ["seen.1", "seen.2", "web.1", "web.2"]
    why = [one.why.split(";")[0] for one in found.left_out]
    assert sorted(why) == sorted(
        ["its layer 'OFF' is off", "its layer 'off' is off"]
        + 2 * ["its layer 'ice' is frozen", "its layer 'ICE' is frozen"]
        + 3 * ["it is invisible"]
    )
    whole = kt.exchange.read(path, hidden=True)
    assert len(whole.model.bars) == 18
    assert [one.what for one in whole.left_out] == ["POINT"]
    out = tmp_path / "hidden.yaml"
    assert CliRunner().invoke(main, ["import", str(path), "--hidden", "-o", str(out)]).exit_code == 0
    assert len(kt.read(out).bars) == 18
    for line in list(space.query("LINE[layer=='seen']")) + list(space.query("INSERT")):
        space.delete_entity(line)
    document.saveas(path)
    with pytest.raises(kt.ModelError, match="no lines .* but LINE, POINT. Some are hidden: take them with --hidden"):
        kt.exchange.read(path)


def test_dxf_nothing_is_lost_in_silence(tmp_path):
    """Marks on hidden layers hold nothing; empty blocks, texts of blocks, single points, layouts are named."""
    document = ezdxf.new("R2010", units=6)
    space, layers = document.modelspace(), document.layers
    layers.add("supports").off()
    layers.add("axes")
    document.blocks.new("PIN").add_circle((0, 0), 0.1)
    document.blocks.new("NOTHING")
    space.add_line((0, 0), (1, 0), dxfattribs={"layer": "axes"})
    space.add_lwpolyline([(3, 3)])
    pin = space.add_blockref("PIN", (0, 0), dxfattribs={"layer": "SUPPORTS"})
    space.add_blockref("NOTHING", (0, 0)).add_attrib("NAME", "far away", (9, 9))
    sheet = document.paperspace()
    sheet.add_line((0, 0), (7, 7))
    sheet.add_viewport((5, 5), (10, 10), (0, 0), 10).frozen_layers = ["axes"]
    path = tmp_path / "lost.dxf"
    document.saveas(path)
    found = kt.exchange.read(path)
    assert list(found.model.bars) == ["axes.1"] and not found.model.fixed
    assert [(one.what, one.why.partition(";")[0]) for one in found.left_out] == [
        ("LWPOLYLINE", "it has less than two points"),
        ("INSERT", "its layer 'SUPPORTS' is off"),
        ("INSERT", "the block 'NOTHING' is empty"),
        ("layout", "its paper space has 1 entity"),
        ("text 'far away'", "is beside no middle of a line without a name"),
    ]
    assert f"{path}: layout 'Layout1' does not show the layers axes; they are taken: --skip leaves them out" in found.notes
    pin.dxf.layer = "Support pins"
    document.saveas(path)
    assert dict(kt.exchange.read(path).model.fixed) == dict(kt.exchange.read(path, hidden=True).model.fixed) == {"n1": "xy"}


def test_damaged_dxf(tmp_path):
    """What ezdxf can repair is read, and a note says what was wrong."""
    path = tmp_path / "mast.dxf"
    text = drawing(path).read_text()
    begin = text.index("ENTITIES")
    line = text.index("LWPOLYLINE", begin)
    whole = kt.exchange.read(path)
    assert not any("damaged" in note for note in whole.notes)
    for damaged in (text[:-300], text.replace("ENDSEC", "ENDSEX"), text[:line] + text[text.index("\n", line + 20) + 1 :]):
        path.write_text(damaged)
        found = kt.exchange.read(path)
        assert [note for note in found.notes if note.startswith("the file is damaged (") and "Lines may be missing" in note]
        assert found.model.bars.keys() <= whole.model.bars.keys()
        assert "chord.1" in found.model.bars
    ezdxf.readfile(drawing(path)).saveas(path, fmt="bin")
    binary = path.read_bytes()
    assert kt.exchange.read(path).model == whole.model
    for nothing, why in (
        (text[: begin + 12].encode(), "missing ENDSEC"),
        (b"no drawing\n" * 9, "is not a DXF file"),
        (binary[:-900], "a value is missing, or is none there"),
    ):
        path.write_bytes(nothing)
        with pytest.raises(kt.ModelError, match=f"is no whole DXF file: .*{why}"):
            kt.exchange.read(path)


def test_a_six_bar_sketched_in_cad(tmp_path):
    """A crank on a layer of motors, a closed triangle, pivots as circles, a centre line, a dimension; it turns and closes."""
    document = ezdxf.new(units=4, setup=True)
    space = document.modelspace()
    a, b, c, d, e, f, g = (0, 0), (400, 0), (-60, 150), (330, 260), (180, 380), (650, 40), (520, 330)
    for start, end, layer in ((a, c, "Motor crank"), (b, d, "rocker"), (e, g, "rod"), (f, (520.0002, 330.0001), "arm")):
        space.add_line(start, end, dxfattribs={"layer": layer})
    space.add_lwpolyline([c, d, e], close=True, dxfattribs={"layer": "plate"})
    for place in (a, b, f):
        space.add_circle(place, 12, dxfattribs={"layer": "Fixed pivots"})
    space.add_line((-100, 0), (700, 0), dxfattribs={"layer": "CENTER"})
    space.add_linear_dim(base=(0, -100), p1=a, p2=b).render()
    document.saveas(tmp_path / "six.dxf")
    found = kt.exchange.read(tmp_path / "six.dxf", skip=["center"])
    assert (found.mobility.degrees_of_freedom, found.mobility.undriven) == (1, 0)
    assert sorted(one.what for one in found.left_out) == ["DIMENSION", "LINE", "name"]
    assert list(found.model.drives) == ["Motor_crank.1.motor"]
    start = float(np.arctan2(150, -60))
    motion = kt.kinematics.follow(
        found.model, kt.Quintic(moves={"Motor_crank.1.motor": (start, start - 0.5)}, duration=1.0), samples=5
    )
    tip = motion.position.sel(node="n2").values
    np.testing.assert_allclose(tip[-1], np.hypot(0.06, 0.15) * np.array([np.cos(start - 0.5), np.sin(start - 0.5)]), atol=1e-12)
    assert "n2 and" not in " ".join(found.notes)


def test_dxf_without_unit(tmp_path):
    document = ezdxf.new(units=0)
    document.modelspace().add_line((0, 0), (1, 1))
    document.saveas(tmp_path / "a.dxf")
    with pytest.raises(kt.ModelError, match=r"a\.dxf.*no unit.*--unit mm"):
        kt.exchange.read(tmp_path / "a.dxf")
    assert kt.exchange.read(tmp_path / "a.dxf", unit="cm").model.nodes["n2"].at == (0.01, 0.01)


def test_dxf_without_lines(tmp_path):
    document = ezdxf.new(units=6)
    document.modelspace().add_circle((0, 0), 1)
    document.saveas(tmp_path / "a.dxf")
    with pytest.raises(kt.ModelError, match="no lines in its model space, but CIRCLE"):
        kt.exchange.read(tmp_path / "a.dxf")


def test_compas_graph(tmp_path):
    graph = Graph(name="pyramid")
    keys = [
        graph.add_node(x=x, y=y, z=z, is_support=z == 0, load=3) for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0.3, 0.3, 1))
    ]
    for key in keys[:3]:
        graph.add_edge(key, keys[3], q=1.0)
    compas.json_dump(graph, tmp_path / "pyramid.json")
    found = kt.exchange.read(tmp_path / "pyramid.json", unit="mm")
    assert found.model.nodes["n3"].at == (0.3e-3, 0.3e-3, 1e-3)
    assert set(found.model.fixed) == {"n0", "n1", "n2"}
    assert {frozenset(bar.ends) for bar in found.model.bars.values()} == {frozenset((f"n{k}", "n3")) for k in range(3)}
    assert {one.what for one in found.left_out} == {"attribute load", "attribute q"}
    assert found.mobility.degrees_of_freedom == 0


def test_compas_mesh_and_several(tmp_path):
    mesh = Mesh.from_polyhedron(8)
    compas.json_dump({"form": mesh, "more": [1, 2]}, tmp_path / "octahedron.json")
    found = kt.exchange.read(tmp_path / "octahedron.json")
    assert (len(found.model.nodes), len(found.model.bars)) == (6, 12)
    assert found.mobility.degrees_of_freedom == 6
    compas.json_dump([mesh, mesh], tmp_path / "two.json")
    with pytest.raises(kt.ModelError, match="holds 2 graphs"):
        kt.exchange.read(tmp_path / "two.json")


def test_tables(tmp_path):
    (tmp_path / "nodes.csv").write_text("node,x [mm],y [mm],mass [kg]\nA,0,0,\nB,1000,0,\nC,500,800,2\n")
    (tmp_path / "members.csv").write_text("member,from,to,kind\na,A,C,rigid\nb,B,C,active\n")
    found = kt.exchange.read(tmp_path / "nodes.csv", members=tmp_path / "members.csv", fixed=["A", "B"])
    assert {name: node.at for name, node in found.model.nodes.items()} == PLACES
    assert list(found.model.driven_members) == ["b"]
    assert found.mobility.undriven == 0
    with pytest.raises(kt.InputError, match="no node called 'D'"):
        kt.exchange.read(tmp_path / "nodes.csv", members=tmp_path / "members.csv", fixed=["D"])
    with pytest.raises(kt.InputError, match="table of members"):
        kt.exchange.read(tmp_path / "nodes.csv")


def test_tables_of_a_spreadsheet(tmp_path):
    """Semicolons, decimal commas, columns in another order, a byte order mark, units in round brackets."""
    nodes, members = tmp_path / "nodes.csv", tmp_path / "members.csv"
    nodes.write_text("Y (cm);X [mm];Node;Mass [kg]\n0;0;A;\n0,0;1000,0;B;\n80;500;C;2,5\n", encoding="utf-8-sig")
    members.write_text("to\tfrom\tmember\nC\tA\ta\nC\tB\tb\n")
    model = kt.exchange.read(nodes, members=members, fixed=["A", "B"]).model
    assert {name: node.at for name, node in model.nodes.items()} == PLACES
    assert model.nodes["C"].mass == 2.5
    assert model.bars["b"].ends == ("B", "C")
    for text, message in (
        ("node;x [mm];y [mm]\nA;1.000,5;0\n", r"nodes.csv:2:1: .*'1.000,5' is not a number, in column 'x'"),
        ("node,x [mm],y [mm]\nA,1,5,0\n", r"has 4 cells; the header has 3. .*use semicolons"),
    ):
        nodes.write_text(text)
        with pytest.raises(kt.ModelError, match=message):
            kt.exchange.read(nodes, members=members)


def test_meshes(tmp_path):
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.2], [0, 0, 1], [5, 5, 5]]
    cells = [("line", [[0, 1], [1, 4]]), ("triangle", [[0, 1, 2], [0, 2, 3]])]
    meshio.Mesh(points, cells, point_data={"heat": np.arange(6.0)}).write(tmp_path / "sail.vtu")
    found = kt.exchange.read(tmp_path / "sail.vtu", material="steel_s235", thickness="2 mm", fixed=["n0"])
    model = found.model
    assert set(model.nodes) == {f"n{k}" for k in range(5)}
    assert {bar.ends for bar in model.bars.values()} == {("n0", "n1"), ("n1", "n4")}
    assert len(model.membranes["skin"].elements) == 2
    assert model.membranes["skin"].thickness == 0.002
    assert {one.what for one in found.left_out} == {"point", "data heat"}
    meshio.Mesh(points[:5], [("tetra", [[0, 1, 2, 4], [0, 2, 3, 4]]), ("quad", [[0, 1, 2, 3]])]).write(tmp_path / "block.msh")
    solid = kt.exchange.read(tmp_path / "block.msh", material="steel_s235", unit="cm")
    assert len(solid.model.solids["solid"].elements) == 2
    assert solid.model.nodes["n1"].at == (0.01, 0, 0)
    assert [one.what for one in solid.left_out][:1] == ["quad cells"]
    with pytest.raises(kt.InputError, match="--material"):
        kt.exchange.read(tmp_path / "block.msh")


@pytest.mark.parametrize(("package", "path"), [("ezdxf", "a.dxf"), ("meshio", "a.vtu")], ids=["drawings", "meshes"])
def test_a_package_that_is_missing_is_named(monkeypatch, tmp_path, package, path):
    monkeypatch.setitem(__import__("sys").modules, package, None)
    with pytest.raises(kt.InputError, match=rf"needs the package {package}. Install it: pip install 'kinetruss\[exchange\]'"):
        kt.exchange.read(tmp_path / path)


def test_unknown_suffix_and_option(tmp_path):
    with pytest.raises(kt.InputError, match=r"suffix '\.step'"):
        kt.exchange.read(tmp_path / "a.step")
    with pytest.raises(kt.InputError, match=r"a \.dxf file has no option 'closures'"):
        kt.exchange.read(tmp_path / "a.dxf", closures="b.yaml")


class Pavilion(Mesh):
    """A mesh of a user's own module, which the reader cannot import."""


class Frame(Graph):
    """Likewise of a graph."""


class Tower(Frame):
    """Two steps away from it."""


def test_compas_classes_of_other_packages(tmp_path):
    """They are known by the classes from which they are derived; what is derived from others is left out and named."""
    graph = Tower()
    for key, (x, y) in PLACES.items():
        graph.add_node(key, x=x, y=y, z=0)
    graph.add_edge("A", "B")
    graph.add_edge("B", "C")
    mesh = Pavilion.from_vertices_and_faces([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    for one, bars in ((graph, 2), (mesh, 4)):
        compas.json_dump(one, tmp_path / "own.json")
        assert "inheritance" in (tmp_path / "own.json").read_text()
        assert len(kt.exchange.read(tmp_path / "own.json").model.bars) == bars
    other = {"dtype": "a.b/Field", "inheritance": ["compas.datastructures/Datastructure"], "data": {"vertex": {}, "face": {}}}
    (tmp_path / "own.json").write_text(compas.json_dumps([other]))
    with pytest.raises(kt.ModelError, match="holds 0 graphs"):
        kt.exchange.read(tmp_path / "own.json")


OLD = {
    "attributes": {"name": "shell"}, "dva": {"x": 0.0, "y": 0.0, "z": 0.0, "is_anchor": False}, "dea": {}, "dfa": {},
    "vertex": {"0": {"is_anchor": True}, "1": {"x": 2.0}, "2": {"x": 2.0, "y": 1.0}, "3": {"y": 1.0, "z": 0.0}},
    "face": {"0": [0, 1, 2], "1": [0, 2, 3]}, "facedata": {}, "edgedata": {}, "max_vertex": 3, "max_face": 1,
}  # fmt: skip


@pytest.mark.parametrize("wrapped", [
    lambda data: data,
    lambda data: {"dtype": "compas.datastructures/Mesh", "value": data},
    lambda data: {"compas": "1.17.4", "datatype": "compas.datastructures.Mesh", "data": data},
    lambda data: {"dtype": "my.shells/Shell", "value": data, "guid": "0"},
    lambda data: [{"dtype": "compas.geometry/Point", "value": [0, 0, 0]}, {"mesh": data}],
    lambda data: data | {"face": {"0": {"0": "1", "1": "2", "2": "0"}, "1": {"0": "2", "2": "3", "3": "0"}}},
    lambda data: data | {"face": {"0": ["0", "1", "2", "0"], "1": ["0", "2", "3", "0"]}, "edge": {}, "halfedge": {}},
], ids=["bare", "value", "datatype", "own class", "in a list", "corner to corner", "closed faces"])  # fmt: skip
def test_meshes_of_compas_1(tmp_path, wrapped):
    """All the forms in which they were saved give the same five sides and one support."""
    path = tmp_path / "old.json"
    path.write_text(compas.json_dumps(wrapped(OLD)))
    found = kt.exchange.read(path, unit="mm")
    assert sorted(found.model.bars) == ["n0-n1", "n1-n2", "n2-n0", "n2-n3", "n3-n0"]
    assert dict(found.model.fixed) == {"n0": "xy"}
    assert found.model.nodes["n2"].at == (0.002, 0.001)


@pytest.mark.parametrize("table", ["node", "vertex"])
def test_networks_of_compas_1(tmp_path, table):
    data = {"dna": {"x": 1.0}, "dva": {"x": 1.0}, table: {"0": {}, "1": {"y": 1.0}}, "edge": {"0": {"1": {}}, "1": {}}}
    (tmp_path / "old.json").write_text(compas.json_dumps({"dtype": "compas.datastructures/Network", "value": data}))
    found = kt.exchange.read(tmp_path / "old.json").model
    assert list(found.bars) == ["n0-n1"]
    assert [node.at for node in found.nodes.values()] == [(1.0, 0.0), (1.0, 1.0)]
