"""Drawings, tables, graphs and meshes of other programs as models."""

from __future__ import annotations

from pathlib import Path

import compas
import ezdxf
import meshio
import numpy as np
import pytest
from compas.datastructures import Graph, Mesh

import kinetruss as kt

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
