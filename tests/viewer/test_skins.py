"""Faces of membranes, solids and hinges in a scene: which they are, and the stress behind each."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import viewer
from kinetruss.elements.continua_arrays import body_faces, skin_of
from kinetruss.strength.element_stresses import skin_stress

STEEL = kt.Material(E=210e9, poisson=0.3, density=7850.0)


def block(**more) -> kt.Model:
    box = kt.library.meshes.box(size=(2.0, 1.0, 0.5), cells=(3, 2, 2))
    return kt.Model(nodes=box.nodes, material=STEEL, fixed=box.at(x=0.0), solids={"block": box.solid()}, **more)


def plate(six_nodes: bool, strain: str = "constant") -> kt.Model:
    mesh = kt.library.meshes.rectangle(width=2.0, height=1.0, columns=3, rows=2, six_nodes=six_nodes)
    return kt.Model(nodes=mesh.nodes, material=STEEL, membranes={"web": mesh.membrane(thickness=0.01, strain=strain)})


def places(model: kt.Model) -> np.ndarray:
    return np.array([(*node.at, 0.0)[:3] for node in model.nodes.values()])


def areas(model: kt.Model) -> np.ndarray:
    a, b, c = places(model)[skin_of(model).nodes].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def test_a_solid_shows_its_surface_only():
    model = block()
    nodes = skin_of(model).nodes
    edges, times = np.unique(np.sort(nodes[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0, return_counts=True)
    assert (times == 2).all()  # closed
    assert len(np.unique(nodes)) - len(edges) + len(nodes) == 2  # Euler: a ball
    assert areas(model).sum() == pytest.approx(2 * (2 * 1 + 2 * 0.5 + 1 * 0.5))
    x = places(model)
    a, b, c = (x[nodes] - x.mean(axis=0)).transpose(1, 0, 2)
    assert (np.einsum("fi,fi->f", a, np.cross(b, c)) > 0).all()  # seen from outside


@pytest.mark.parametrize(("six_nodes", "each"), [(False, 1), (True, 4)])
def test_a_membrane_shows_all_of_itself(six_nodes, each):
    model = plate(six_nodes)
    assert areas(model).sum() == pytest.approx(2.0)
    assert len(skin_of(model).nodes) == each * len(model.membranes["web"].elements)


@pytest.mark.parametrize(
    "model", [block(), plate(False), plate(True), plate(True, "linear")], ids=["solid", "3", "6", "linear"]
)
def test_each_face_has_the_stress_of_its_element(model):
    rng = np.random.default_rng(7)
    start = np.array([node.at for node in model.nodes.values()])
    rest = start + 1e-4 * rng.standard_normal(start.shape)
    name = [*model.membranes, *model.solids][0]
    wanted = kt.strength.elements(model, rest[None], name)["von_mises"].values[0]
    skin = skin_of(model)
    found = skin_stress(model, skin, np.array([start, rest]))
    assert np.abs(found[0]).max() < 1e-3 * found[1].max()
    for face, value in enumerate(found[1]):
        here = wanted[skin.element[face]]
        expected = here if here.ndim == 0 else here[skin.corner[face]] if len(here) == 4 else here.max()
        assert value == pytest.approx(expected)


def test_stress_of_faces_is_in_the_scene_of_a_rest_and_of_a_run():
    box = block(gravity=(0, 0, -9.81), loads={"tip": kt.NodalForce(node="n3", force=(0, 0, -1e5))})
    rest = kt.statics.equilibrium(box)
    told = viewer.unpack(viewer.pack(viewer.scene(rest, model=box)))
    skin = skin_of(box)
    values = kt.strength.elements(box, rest, "block")["von_mises"].values
    assert told.arrays["skin_stress"][0] == pytest.approx(values[skin.element], rel=1e-6)
    assert np.array_equal(told.arrays["skin"], skin.nodes)
    assert told.header["skins"] == [{"name": "block", "kind": "solid"}]
    assert [one["id"] for one in told.header["channels"]] == ["stress"]  # there is no member whose force could colour
    assert told.arrays["position"][0] == pytest.approx(rest.data["position"].values)
    sheet = plate(False).with_(gravity=(0.0, -9.81), fixed=("n0", "n1"))
    run = kt.dynamics.simulate(sheet, t_end=2e-4, method=kt.EnergyMomentum(step=1e-4))
    moved = viewer.scene(run, model=sheet)
    stress = kt.strength.elements(sheet, run, "web")["von_mises"].values
    assert moved.arrays["skin_stress"] == pytest.approx(stress)
    assert "skin_stress" in moved.header["histories"]


def test_where_stress_would_take_long_faces_stay_plain(monkeypatch):
    from kinetruss.strength import element_stresses as _skins

    monkeypatch.setattr(_skins, "MOST", 1)
    model = plate(False)
    assert skin_stress(model, skin_of(model), places(model)[None, :, :2]) is None


def test_hulls_of_bodies_are_closed():
    corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1), "I": (0.2, 0.2, 0.2)}
    model = kt.Model(nodes=corners, bodies={"b": kt.Body(nodes=tuple(corners), mass=2.0)})
    faces = body_faces(model, places(model))
    assert sorted(map(sorted, faces)) == [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]


def test_drives_that_turn_say_about_what():
    robot = kt.library.mechanisms.robot()
    drives = viewer.scene(robot).header["drives"]
    nodes = list(robot.nodes)
    hinges = [(one, robot.all_drives[one["name"]]) for one in drives if one["kind"] == "hinge"]
    assert hinges
    for told, drive in hinges:
        assert [nodes[k] for k in told["axis"]] == list(drive.axis)
        assert (nodes[told["start"]], nodes[told["end"]]) == (drive.start, drive.end)
        assert told["unit"] == "rad"
    for told in drives:
        if told["kind"] == "angle":
            assert told["about"] == pytest.approx(robot.all_drives[told["name"]].axis)
