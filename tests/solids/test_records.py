"""Records of membranes and solids: reading, writing, faults; meshes."""

import meshio
import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError, ModelError

STEEL = kt.Material(E=210e9, density=7850.0)
SQUARE = {"A": (0.0, 0.0), "B": (1.0, 0.0), "C": (1.0, 1.0), "D": (0.0, 1.0)}


def plate(**fields):
    fields = {"elements": [["A", "B", "C"], ["A", "C", "D"]], "thickness": "10 mm", "material": STEEL} | fields
    return kt.Model(nodes=SQUARE, membranes={"p": kt.Membrane(**fields)})


@pytest.mark.parametrize("suffix", ["yaml", "json"])
def test_written_and_read_again(tmp_path, suffix):
    grid = kt.library.meshes.box(size=(1.0, 1.0, 1.0), cells=(2, 2, 1))
    model = kt.Model(nodes=grid.nodes, material=STEEL, solids={"many": grid.solid()})
    assert len(model.solids["many"].elements) > 20  # one text in the file
    for one in (
        model,
        plate(),
        plate(axis=(1, 2), orthotropic=kt.Orthotropic(E1=2e9, E2=1e9, nu12=0.2, G12=5e8), material=None),
    ):
        path = kt.write(one, tmp_path / f"model.{suffix}")
        again = kt.read(path)
        assert again.membranes == one.membranes
        assert again.solids == one.solids


def test_tables_in_several_forms_are_one():
    forms = [[[0, 1, 2]], np.array([[0, 1, 2]]), "0 1 2", "0, 1, 2\n"]
    found = {kt.Membrane(nodes=["A", "B", "C"], elements=form, thickness=1.0).elements for form in forms}
    assert found == {((0, 1, 2),)}
    assert kt.Membrane(elements=[["A", "B", "C"]], thickness=1.0).nodes == ("A", "B", "C")


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"elements": [["A", "C", "B"]]}, "clockwise"),
        ({"elements": [["A", "B", "X"]]}, "no node called 'X'"),
        ({"elements": [[0, 1, 7]], "nodes": list(SQUARE)}, "name node 7"),
        ({"elements": [[0, 1, 1]], "nodes": list(SQUARE)}, "flat"),
        ({"elements": [[0, 1]], "nodes": list(SQUARE)}, "triangles have 3 or 6"),
        ({"elements": "0 1 b", "nodes": list(SQUARE)}, "whole numbers"),
        ({"material": None}, "no material"),
        ({"material": "unobtainium"}, "no material called"),
        ({"thickness": 0.0}, "greater than 0"),
        ({"axis": (1, 0, 0)}, "3 components"),
        ({"axis": (0, 0)}, "no direction"),
        ({"material": STEEL.with_(poisson=0.5), "plane": "strain"}, "incompressible"),
        ({"orthotropic": kt.Orthotropic(E1=2e9, E2=1e9, nu12=0.2, G12=5e8)}, "together with material"),
        ({"orthotropic": kt.Orthotropic(E1=2e9, E2=1e9, nu12=0.2, G12=5e8), "material": None, "plane": "strain"}, "E3, nu13"),
    ],
)
def test_faults_of_membranes(fields, words):
    with pytest.raises(ModelError, match=words):
        plate(**fields)


def test_thickness_is_asked_for():
    with pytest.raises(ModelError, match="thickness"):
        kt.Membrane(elements=[["A", "B", "C"]])


def test_faults_of_solids():
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "D": (0, 0, 1), "E": (1, 1, 0)}
    for rows, words in (([["A", "C", "B", "D"]], "inside out"), ([["A", "B", "C", "E"]], "flat")):
        with pytest.raises(ModelError, match=words):
            kt.Model(nodes=nodes, solids={"s": kt.Solid(elements=rows, material=STEEL)})
    with pytest.raises(ModelError, match="planar"):
        kt.Model(nodes=SQUARE, solids={"s": kt.Solid(elements=[list("ABCD")], material=STEEL)})
    with pytest.raises(ModelError, match="axis"):
        flat = kt.Membrane(elements=[["A", "B", "C"]], thickness=0.1, material=STEEL, axis=(0, 0, 1))
        kt.Model(nodes=nodes, membranes={"m": flat})
    with pytest.raises(ModelError, match="parallel"):
        turned = kt.Solid(elements=[["A", "B", "C", "D"]], material=STEEL, axes=((1, 0, 0), (2, 0, 0)))
        kt.Model(nodes=nodes, solids={"s": turned})


def test_impossible_orthotropic_ratios():
    with pytest.raises(ModelError, match="energy for nothing"):
        kt.Orthotropic(E1=1e9, E2=4e9, nu12=0.6, G12=1e9)
    with pytest.raises(ModelError, match="energy for nothing"):
        kt.Orthotropic(E1=1e9, E2=1e9, nu12=0.6, G12=1e9, E3=1e9, nu13=0.6, nu23=0.6)


def test_meshes_of_meshio_and_plain_arrays(tmp_path):
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [5, 5, 0]], float)
    rows = np.array([[0, 2, 1], [0, 2, 3]])  # one the wrong way round, a point of nobody
    meshio.Mesh(points, [("triangle", rows)]).write(tmp_path / "m.vtu")
    for mesh in (kt.library.meshes.read(tmp_path / "m.vtu"), kt.library.meshes.mesh(points[:, :2], rows)):
        assert mesh.points.shape == (4, 2)
        model = kt.Model(nodes=mesh.nodes, material=STEEL, membranes={"p": mesh.membrane(thickness=0.1)})
        assert len(model.membranes["p"].elements) == 2
    with pytest.raises(InputError, match="quad"):
        kt.library.meshes.read(meshio.Mesh(points, [("quad", np.array([[0, 1, 2, 3]]))]))
    with pytest.raises(InputError, match="no mesh file"):
        kt.library.meshes.read(tmp_path / "none.vtu")
    with pytest.raises(InputError, match="shape"):
        kt.library.meshes.mesh(points, [[0, 1]])


def test_a_result_without_positions_and_an_unknown_part():
    model = plate()
    with pytest.raises(InputError, match="No membrane or solid called 'q'"):
        kt.strength.elements(model, np.array(list(SQUARE.values())), "q")
    with pytest.raises(InputError, match="positions: shape "):
        kt.strength.elements(model, np.zeros((3, 2)), "p")
