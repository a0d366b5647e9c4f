"""Bodies as records: what they add to a model, files, faults with their mends."""

import re

import numpy as np
import pytest
import yaml

import kinetruss as kt
from kinetruss.kinematics import mobility

CORNERS = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
MORE = CORNERS | {"P": (1, 1, 1), "Q": (2, 1, 1), "R": (1, 1, 0), "S": (2, 0, 0), "S2": (3, 0, 0), "X2": (1, 1e-9, 0)}
FOUR = tuple(CORNERS)


def made(body, nodes=MORE, **fields):
    return kt.Model(nodes=nodes, bodies={"b": body}, **fields)


def test_bars_are_added_once():
    model = made({"nodes": FOUR, "mass": 2.0}, CORNERS)
    assert not model.bars and len(model.whole.bars) == 6
    assert all(name in model.whole.inner.bars and bar.kind == "rigid" for name, bar in model.whole.bars.items())
    assert {owner.text for owner in model.whole.inner.bars.values()} == {"body b"}
    assert model.with_(title="again").whole.bars == model.whole.bars
    assert len(made({"nodes": FOUR}, CORNERS, bars={"own": ("Y", "X")}).whole.bars) == 6


def test_braces_go_with_their_body():
    model = made({"nodes": FOUR, "mass": 2.0}, CORNERS, bars={"own": ("O", "X")})
    assert list(model.bars) == ["own"] and len(model.whole.bars) == 6
    assert list(model.with_(bodies={}).whole.bars) == ["own"]


@pytest.mark.parametrize(("shared", "bars", "freedoms"), [(1, 12, 9), (2, 11, 7), (3, 9, 6), (4, 6, 6)])
def test_shared_nodes_are_joints(shared, bars, freedoms):
    """Spherical joint, revolute, welds: 12 freedoms of two bodies less 3, 5, 6; no bar is redundant."""
    rng = np.random.default_rng(3)
    names = [f"N{k}" for k in range(8 - shared)]
    nodes = {name: tuple(rng.normal(size=3)) for name in names}
    found = kt.Model(nodes=nodes, bodies={"a": kt.Body(nodes=names[:4]), "b": kt.Body(nodes=names[-4:])})
    assert len(found.whole.bars) == bars
    counts = mobility(found)
    assert (counts.degrees_of_freedom, counts.self_stress) == (freedoms, 0)


@pytest.mark.slow
@pytest.mark.parametrize("dim", [2, 3])
def test_more_nodes_are_held_without_redundance(dim):
    rng = np.random.default_rng(5)
    nodes = {f"N{k}": tuple(rng.normal(size=dim)) for k in range(9)}
    nodes["M"] = tuple(np.mean([nodes["N0"], nodes["N1"]], axis=0))  # in line with two of them
    order = ["N0", "N1", "M", *(f"N{k}" for k in range(2, 9))]
    found = kt.Model(nodes=nodes, bodies={"b": kt.Body(nodes=order, carriers=["N0", "N1", "N2", "N3"][: dim + 1])})
    assert len(found.whole.bars) == dim * 10 - dim * (dim + 1) // 2
    counts = mobility(found)
    assert (counts.degrees_of_freedom, counts.self_stress) == (dim * (dim + 1) // 2, 0)


def test_fixed_nodes_need_no_bar_between_them():
    found = made({"nodes": FOUR}, CORNERS, fixed=["O", "X"])
    assert len(found.whole.bars) == 5
    assert mobility(found).degrees_of_freedom == 1


def test_straining_bodies_are_not_braced():
    assert not made({"nodes": FOUR, "mass": 1.0, "kind": "straining"}).whole.bars
    assert not made({"nodes": FOUR, "mass": 1.0, "brace": False}).whole.bars


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
@pytest.mark.parametrize("inertia", [(0.3, 0.4, 0.5), np.diag([0.3, 0.4, 0.5]), None])
def test_files(tmp_path, suffix, inertia):
    center = None if inertia is None else (0.1, 0.2, 0.3)
    frame = kt.Frame(origin=(0, 0, 1), axes=((0, 1, 0), (-1, 0, 0), (0, 0, 1)))
    body = kt.Body(nodes=FOUR, mass=2.0, center=center, inertia=inertia, frame=frame, carriers=("X", "Y", "Z", "O"))
    model = made(body, bars={"own": ("O", "X")})
    assert kt.read(kt.write(model, tmp_path / f"m{suffix}")) == model


def test_units_in_files(tmp_path):
    text = "nodes: {O: [0, 0, 0], X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1]}\nbodies:\n  b:\n    nodes: [O, X, Y, Z]\n"
    text += "    mass: 500 g\n    center: [10 mm, 0, 0]\n    inertia: [20 kg cm^2, 20 kg cm^2, 0.003]\n"
    (tmp_path / "m.yaml").write_text(text)
    body = kt.read(tmp_path / "m.yaml").bodies["b"]
    assert body.mass == 0.5
    assert body.center == (0.01, 0, 0)
    assert np.allclose(body.inertia, (0.002, 0.002, 0.003), rtol=1e-15)


FAULTS = [
    ({"nodes": ("O", "X", "Y", "R")}, "'O', 'X', 'Y', 'R' lie in one plane", "Add a node beside them to the model"),
    ({"nodes": ("O", "X", "Y", "R", "P")}, "lie in one plane", 'Take others: carriers=["X", "Y", "R", "P"].'),
    ({"nodes": ("O", "X", "S")}, "'O', 'X', 'S' lie on one line", 'in place of the body (links={"b": ["O", "X", "S"]})'),
    ({"nodes": ("O", "X", "S", "S2")}, "'O', 'X', 'S', 'S2' lie on one line", "Add two nodes beside them"),
    ({"nodes": ("O", "X", "S", "S2"), "carriers": ("O", "S2")}, "has 4 nodes on one line", "they need no mass"),
    ({"nodes": ("O", "X", "Y", "X2")}, "'X' and 'X2' stand almost at one place, 1.0e-09 m apart", "Add a node beside them"),
    ({"nodes": ("O", "X", "Y", "R"), "carriers": ("O", "X", "Y")}, "has 4 nodes in one plane", "it needs no mass"),
    ({"nodes": ("O", "X", "Y", "no")}, "no node called 'no'", "There are"),
    ({"nodes": ("O", "X", "Y", "O")}, "names 'O' twice", "once"),
    ({"nodes": ("O",)}, "is one node", "Give 4 nodes"),
    ({"nodes": FOUR, "carriers": ("O", "P")}, "'P' is no node of the body", "Add it"),
    ({"nodes": (*FOUR, "P"), "carriers": (*FOUR, "P")}, "names 5 nodes", "Name 4"),
    ({"nodes": FOUR, "mass": -1}, "-1 must not be negative", "positive"),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0, 0)}, "has center but no inertia", "Give inertia"),
    ({"nodes": FOUR, "mass": 1, "inertia": (1, 1, 1)}, "has inertia but no center", "Give center"),
    ({"nodes": FOUR, "center": (0, 0, 0), "inertia": (1, 1, 1)}, "is 0, but an inertia", "Give the mass"),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0), "inertia": (1, 1, 1)}, "has 2 components", "Give 3"),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": (1, 2, 5)}, "exceeds the sum of the others", "centre"),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": (1, -1, 1)}, "negative principal moment", "0 or more"),
    (
        {"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": ((1, 2, 0), (2, 1, 0), (0, 0, 2))},
        "negative principal moment: -1, 2, 3", "signs off the diagonal",
    ),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": (1, 1, 3)}, "3 > 2", "at most 2 kg m^2"),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": (0, 0, 0)}, "the mass is a point", "to a node"),
    ({"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": 1.0}, "is one number in a model of dimension 3", "three"),
    (
        {"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": ((1, 0.2, 0), (0.1, 1, 0), (0, 0, 1))},
        "is not symmetric: entries 1,2 and 2,1 are 0.2 and 0.1", "same value",
    ),
    ({"nodes": FOUR[:3], "mass": 1, "center": (0, 0, 1), "inertia": (1, 2, 3)}, "mass off the plane", "Give four nodes"),
    ({"nodes": FOUR[:2], "mass": 1, "center": (0, 0, 0), "inertia": (1, 1, 1)}, "mass off the line", "0 about the line"),
    (
        {"nodes": FOUR, "mass": 1, "center": (0, 0, 0), "inertia": (0, 1, 1)},
        "has no moment of inertia about its own line", "Let two nodes of that line carry it",
    ),
    ({"nodes": FOUR, "frame": {"axes": ((1, 0, 0), (0, 1, 0), (0, 0, -1))}}, "left-handed", "Turn the last axis round"),
    ({"nodes": FOUR, "frame": {"axes": ((1, 0, 0), (0, 1, 0), (0, 0.1, 1))}}, "unit vectors at right angles", "normal"),
    ({"nodes": FOUR, "frame": {"axes": ((1, 0), (0, 1))}}, "has 2 rows of 2, 2 numbers", "Give 3 rows"),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("body", "message", "mend"), FAULTS)
def test_faults(body, message, mend):
    with pytest.raises(kt.ModelError) as error:
        made(body)
    found = error.value.faults
    assert len(found) == 1
    assert found[0].path[:2] == ("bodies", "b")
    assert message in found[0].message
    assert mend in found[0].mend


LINE = {f"N{k}": (k, 2.0 * k, 1.0 - k) for k in range(4)}
ASIDE = {"P": (0.0, 1.0, 3.0), "Q": (2.0, 0.0, 0.0)}


@pytest.mark.parametrize(
    ("nodes", "freedoms"),
    [
        (LINE, 6), ({k: LINE[k] for k in ("N0", "N1", "N2")}, 6), (LINE | {"P": ASIDE["P"]}, 6), (LINE | ASIDE, 6),
        (CORNERS | {"Z": (1, 1, 0)}, 6), ({"O": (0, 0), "X": (1, 0), "S": (2, 0)}, 3),
    ],
)  # fmt: skip
def test_what_is_offered_in_place_of_points_that_span_nothing_holds(nodes, freedoms):
    """Taken at its word the mend makes a rigid body of six (three) freedoms, without self-stress."""
    names = tuple(nodes)
    with pytest.raises(kt.ModelError, match="on one line|in one plane") as error:
        made({"nodes": names, "mass": 2.0}, nodes)
    mend = error.value.faults[0].mend
    more = re.search(r"nodes=(\{.*?\]\})", mend)
    added = yaml.safe_load(more[1]) if more else {}
    carriers = yaml.safe_load(re.search(r"carriers=(\[.*?\])", mend)[1])
    found = made(
        {"nodes": (*names, *added), "mass": 2.0, "carriers": carriers}, nodes | {k: tuple(v) for k, v in added.items()}
    )
    counts = mobility(found)
    assert (counts.degrees_of_freedom, counts.self_stress) == (freedoms, 0)


def test_two_nodes_at_one_place():
    with pytest.raises(kt.ModelError, match=r"'X' and 'T' stand at one place, \(1, 0, 0\)\. Keep one of them\. Add a node"):
        made({"nodes": ("O", "X", "Y", "T")}, CORNERS | {"T": kt.Node(at=(1, 0, 0), coincident=True)})
    with pytest.raises(kt.ModelError, match=r"Keep one of them\.$"):
        made({"nodes": (*FOUR, "T")}, CORNERS | {"T": kt.Node(at=(1, 0, 0), coincident=True)})


def test_a_driven_bar_within_a_rigid_body():
    with pytest.raises(kt.ModelError, match="is rigid, but 'own' drives the distance of its nodes 'O' and 'X'"):
        made({"nodes": FOUR}, bars={"own": kt.Bar(ends=("O", "X"), kind="driven")})


def test_check_tells_all_faults_of_a_file(tmp_path):
    text = "nodes: {O: [0, 0, 0], X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1]}\nbodies:\n  b: {nodes: [O, X, Y, W], mass: -2}\n"
    (tmp_path / "m.yaml").write_text(text + "  c: {nodes: [O, X, Y, Z], mass: 1, center: [0, 0, 0], inertia: [1, 1, 3]}\n")
    found = {fault.path: fault for fault in kt.check(tmp_path / "m.yaml")}
    assert set(found) == {("bodies", "b", "nodes", 3), ("bodies", "b", "mass"), ("bodies", "c", "inertia")}
    assert found["bodies", "c", "inertia"].line == 4
