"""Cells and what is assembled from them: places, names, counts by rank, faults of cells that do not fit."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import ArgumentError, ModelError
from kinetruss.kernels.motion.placement import place_bay
from kinetruss.library import cells, vgt

# (nodes, members, freedoms with drives held, freedoms of the drives) of a free cell, besides those of a rigid body
COUNTS = {
    "triangle": (3, 3, 0, 0),
    "panel": (4, 5, 0, 0),
    "tetrahedron": (4, 6, 0, 0),
    "octahedron": (6, 12, 0, 0),
    "decahedron": (7, 15, 0, 0),
    "prism": (6, 12, 0, 0),
    "cube": (8, 18, 0, 0),
    "double_octahedron": (9, 18, 3, 3),
    "quadruple_octahedron": (15, 36, 3, 6),
}
SHORT = {"base_length": 0.2, "tube_length": 0.1}
BAY = cells.double_octahedron(**SHORT)


def places(model):
    return np.array([node.at for node in model.nodes.values()])


def lengths(model):
    return {name: math.dist(*(model.nodes[end].at for end in member.ends)) for name, member in model.members.items()}


@pytest.mark.parametrize("kind", COUNTS)
def test_counts_by_rank(kind):
    model = cells.stack([getattr(cells, kind)()], fixed=())
    found, rigid = kt.kinematics.mobility(model), 3 if model.dim == 2 else 6
    counts = len(model.nodes), len(model.members), found.undriven - rigid, found.degrees_of_freedom - found.undriven
    assert counts == COUNTS[kind]
    assert found.self_stress == 0


@pytest.mark.parametrize("kind", ["tetrahedron", "octahedron", "decahedron"])
def test_edges_of_regular_solids_are_equal(kind):
    stack = cells.stack([getattr(cells, kind)(side="0.7 m")] * 4)
    assert list(lengths(stack).values()) == pytest.approx([0.7] * len(stack.members), rel=1e-13)
    assert kt.kinematics.mobility(stack).undriven == 0


@pytest.mark.slow
@settings(deadline=None, max_examples=20)
@given(st.integers(2, 6), st.floats(-0.2, 0.2), st.floats(-0.2, 0.2))
def test_a_stack_of_double_octahedra_is_the_chain_to_the_last_bit(bays, beta, gamma):
    chain = vgt.double_octahedral(bays, beta=beta, gamma=gamma)
    assert cells.stack([cells.double_octahedron(beta=beta, gamma=gamma)] * bays, title=chain.title) == chain
    # the closed form written out: frames R = (1 - 2 u u')(1 - 2 z z') one after the other (Lacy, 1991, chapter 6)
    height = 1.121825346
    one = place_bay(1.2192, 0.889, beta, gamma, height)
    normal = np.array([-np.sin(gamma), -np.sin(beta) * np.cos(gamma), np.cos(beta) * np.cos(gamma) + 1])
    u = normal / np.linalg.norm(normal)
    turn = (np.eye(3) - 2 * np.outer(u, u)) @ np.diag([1, 1, -1])
    origin, frame, expected = np.zeros(3), np.eye(3), [one[:3]]
    for _ in range(bays):
        expected.append(origin + one[3:] @ frame.T)
        origin, frame = origin + height * frame @ u, frame @ turn
    assert places(chain) == pytest.approx(np.vstack(expected), abs=1e-8)


def test_mirrored_twice_is_the_same():
    cell = cells.octahedron(top=0.8, beta=0.2, gamma=0.1, active=["longeron1"])
    for one in (cell, BAY, cells.chain([cell, cells.octahedron(side=0.8)])):
        assert cells.mirror(cells.mirror(one)) == one
    for axis in "xy":
        twice = cells.mirror(cells.mirror(cell, axis), axis)
        assert (twice.nodes, twice.bars, twice.faces) == (cell.nodes, cell.bars, cell.faces)


def test_a_cell_and_its_mirror_image_are_symmetric_about_the_face_between():
    cell = cells.octahedron(top=0.8, height=0.7)
    stack = cells.stack([cell, cells.mirror(cell)])
    low, high = (np.array([stack.nodes[f"{name}.N{k}"].at for k in (1, 2, 3)]) for name in ("B1", "B2"))
    assert high == pytest.approx(low * [1, 1, -1] + [0, 0, 1.4], abs=1e-14)


@pytest.mark.slow
def test_a_bay_on_its_head_keeps_its_pose():
    """Its own top has no battens: links take their place. The bay is its own mirror image, so the top is where it was."""
    battens = {f"batten{k}": (f"B2.N{k}", f"B2.N{k % 3 + 1}") for k in (1, 2, 3)}
    moves = {"B2.beta": (0.0, 0.2), "B2.gamma": (0.0, -0.1)}
    tops = []
    for model, names in (
        (cells.stack([BAY, cells.mirror(BAY)], links=battens), (1, 2, 3)),
        (cells.stack([BAY, BAY]), (7, 9, 8)),
    ):
        motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), times=[0.0, 1.0])
        tops.append(motion.position.sel(node=[f"B2.N{k}" for k in names]).values[-1])
    assert tops[0] == pytest.approx(tops[1], abs=1e-9)


def test_triangles_mirrored_in_turn_make_a_strip():
    strip = cells.stack([cells.triangle(), cells.triangle(mirrored="x")] * 3)
    along = np.array([0.5, math.sqrt(3) / 2])  # of the strip
    across = np.array([along[1], -along[0]])
    height = math.sqrt(3) / 2
    expected = [(0.0, 0.0), (0.5, height), (1.0, 0.0), (1.5, height), (2.0, 0.0), (2.5, height), (3.0, 0.0), (3.5, height)]
    assert sorted((places(strip) @ np.stack([along, across], axis=1)).round(12).tolist()) == pytest.approx(np.array(expected))
    assert len(strip.bars) == 2 * 8 - 3


def test_equal_tetrahedra_wind_in_a_helix():
    """Boerdijk and Coxeter: nodes on a helix, each turned by acos(-2/3) and risen by 1/sqrt(10) against the one before."""
    x = places(cells.stack([cells.tetrahedron()] * 9))
    steps = x[3:] - 3 * x[2:-1] + 3 * x[1:-2] - x[:-3]
    axis = np.linalg.svd(steps)[2][-1]
    rise = (x[1:] - x[:-1]) @ axis
    assert np.abs(rise) == pytest.approx([1 / math.sqrt(10)] * 11)
    apart = [np.linalg.norm(b - a) for a, b in zip(x, x[4:], strict=False)]
    assert apart == pytest.approx([apart[0]] * 8)


@pytest.mark.parametrize(
    ("cell", "count"),
    [
        (cells.triangle(), 6),
        (cells.panel(lean="36 deg", height=2), 10),
        (cells.cube(beta="60 deg", height=2), 6),
        (cells.prism(3, gamma="45 deg", height=1.5), 8),
        (cells.double_octahedron(beta="36 deg", **SHORT), 10),
    ],
)
def test_rings_close(cell, count):
    ring = cells.ring([cell] * count)
    shared = {name: len(cell.faces[name].nodes) for name in ("base", "top")}
    if cell.dim == 3:
        assert len(ring.nodes) == count * (len(cell.nodes) - shared["base"])
    assert set(ring.fixed) <= set(ring.nodes)
    own = lengths(cells.stack([cell]))
    for name, length in lengths(ring).items():
        assert length == pytest.approx(own[name.partition(".")[2]], abs=1e-12)
    with pytest.raises(ModelError, match=r"close\.B\d+\.top: corners of .* do not meet: they are up to .* m apart, .* deg"):
        cells.ring([cell] * (count - 1))


def test_branches_have_readable_names_and_stand_on_their_faces():
    model = cells.branch(
        cells.octahedron(), {"side1": [cells.octahedron()] * 2, "side2": cells.tetrahedron(), "top": [cells.octahedron()]}
    )
    assert [name for name in model.nodes if not name.startswith(("hub", "top"))] == [
        *(f"side1.B{k}.N{n}" for k in (1, 2) for n in (4, 5, 6)), "side2.N4",
    ]  # fmt: skip
    assert model.bars["side2.longeron1"].ends == ("hub.N2", "side2.N4")
    assert list(lengths(model).values()) == pytest.approx([1.0] * len(model.members))
    assert kt.kinematics.mobility(model).undriven == 0
    assert min(np.linalg.norm(a - b) for k, a in enumerate(places(model)) for b in places(model)[:k]) > 0.9


def test_an_arm_on_a_slanted_face_moves_in_pose():
    arm = cells.double_octahedron(base=1, longeron=0.8, active_length=1, **SHORT)
    model = cells.branch(cells.octahedron(), {"side1": [arm] * 2})
    moves = {"side1.B1.beta": (0.0, 0.2), "side1.B2.gamma": (0.0, 0.1)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), times=[0.0, 1.0])
    found = kt.kinematics.platform(
        model, motion, tuple(f"side1.B1.N{k}" for k in (7, 9, 8)), base=("hub.N1", "hub.N2", "hub.N4")
    )
    assert float(found["beta"].values[-1]) == pytest.approx(0.2, abs=1e-9)


def test_two_opposed_trusses_with_a_link():
    left = cells.chain([BAY] * 3, towards=(1, 0, 0))
    right = cells.chain([BAY] * 3, at=(8, 0, 0), towards=(-1, 0, 0))
    model = cells.assemble({"L": left, "R": right}, links={"link": ("L.B3.N8", "R.B3.N8")}, gravity=None)
    assert list(model.fixed) == [f"{side}.B1.N{k}" for side in "LR" for k in (1, 2, 3)]
    tops = [np.mean([model.nodes[f"{side}.B3.N{k}"].at for k in (7, 8, 9)], axis=0) for side in "LR"]
    reach = 3 * 1.121825346
    assert tops[0] == pytest.approx([reach, 0, 0], abs=1e-8)
    assert tops[1] == pytest.approx([8 - reach, 0, 0], abs=1e-8)
    assert model.poses["L.B2"].drives == ("L.B2.M7", "L.B2.M9", "L.B2.M11")


def test_each_cell_has_its_own_sections_drives_and_sizes():
    lower = cells.double_octahedron(top=1.0, upper_longeron=0.8, active_length=1.1, screw="screw_lacy_spatial", **SHORT)
    upper = cells.double_octahedron(base=1.0, longeron=0.8, active_length=1.0, section="tube_lacy_planar", **SHORT)
    model = cells.stack([lower, upper])
    assert model.section_of(model.bars["B1.M1"]) == kt.library.sections.TUBE_LACY_SPATIAL
    assert model.section_of(model.bars["B2.M1"]) == kt.library.sections.TUBE_LACY_PLANAR
    assert list(model.sections) == ["bar", "tube", "B2.bar", "B2.tube"]
    assert (model.active["B1.M7"].screw, model.active["B2.M7"].screw) == ("screw", None)
    assert list(model.poses) == ["B2"]  # the tapered bay has no closed form
    found = lengths(model)
    assert [found[f"B1.M{k}"] for k in range(1, 7)] == pytest.approx([0.889] * 6)
    assert [found[f"B1.M{k}"] for k in range(13, 19)] == pytest.approx([0.8] * 6)
    assert [found[f"B1.{name}"] for name in ("M7", "M9", "M11")] == pytest.approx([1.1] * 3)
    assert kt.kinematics.mobility(model).undriven == 0
    moved = kt.kinematics.assemble(model, {"B1.M7": 1.05})
    assert np.abs(moved - places(model)).max() > 0.01


def test_any_member_is_active_by_pattern():
    mast = cells.stack([cells.prism(3, side=0.6, height=0.5, active=("longeron*", "batten[4-6]"))] * 20)
    assert len(mast.driven_members) == 20 * 6
    assert mast.bars["B7.longeron2"].kind == "driven"
    assert kt.kinematics.mobility(mast).undriven == 0
    rods = {"base": {"length": "0.3 m", "mass": "1 kg"}, "tube": {"length": "0.3 m"}, "limits": ("0.4 m", "0.6 m")}
    cell = cells.prism(
        3, side=0.6, height=0.5, active={"longeron1": rods, "strut": rods | {"ends": ("N1", "N5")}, "batten6": {}}
    )
    assert list(cell.active) == ["longeron1", "strut"]
    assert (cell.active["strut"].tube.section, cell.active["strut"].base.mass) == ("bar", 1.0)
    assert cells.double_octahedron(active="longeron_lower").poses == {}
    assert len([b for b in cells.double_octahedron(active="longeron_lower").bars.values() if b.kind == "driven"]) == 6


def test_members_on_a_face_belong_to_the_lower_cell_and_masses_add():
    nodes = {"A": {"at": (0, 0), "mass": 1}, "B": (1, 0), "C": {"at": (0, 1), "mass": 2}, "D": (1, 1)}
    bars = {"low": ("A", "B"), "high": ("C", "D"), "left": ("A", "C"), "right": ("B", "D"), "brace": ("A", "D")}
    own = cells.cell(nodes=nodes, bars=bars, faces={"base": ["A", "B"], "top": ["C", "D"]}, section=None)
    model = cells.stack([own] * 3)
    assert "B2.low" not in model.bars
    assert [node.mass for node in model.nodes.values()] == [1, 0, 3, 0, 3, 0, 2, 0]
    assert kt.kinematics.mobility(model).undriven == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    "model",
    [
        cells.stack([cells.octahedron(), cells.octahedron(top=0.7), cells.octahedron(side=0.7, mirrored="z")]),
        cells.stack([BAY] * 3),
        cells.branch(cells.cube(), {"top": [cells.cube()] * 2, "side2": cells.cube()}),
        cells.stack([cells.panel(width=1, top=0.8), cells.panel(width=0.8)]),
    ],
)
def test_reactions_carry_the_weight(model):
    held = kt.dynamics.inverse(model, kt.kinematics.from_arrays(model, [0.0, 1.0], *_at_rest(model)))
    weight = sum(_mass(model, member) for member in model.members.values()) * 9.81
    assert held.reaction.values[0].sum(axis=0)[-1] == pytest.approx(weight, rel=1e-9)
    assert np.abs(held.reaction.values[0].sum(axis=0)[:-1]).max() < 1e-9 * weight


def _at_rest(model):
    x = np.repeat(places(model)[None], 2, axis=0)
    return x, 0 * x, 0 * x


def _mass(model, member):
    if isinstance(member, kt.Active):
        tube = member.tube
        return member.base.mass + model.section_of(tube).area * model.material_of(tube).density * tube.length
    length = math.dist(*(model.nodes[end].at for end in member.ends))
    return model.section_of(member).area * model.material_of(member).density * length


OCTAHEDRON = cells.octahedron()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: cells.stack([OCTAHEDRON, cells.octahedron(side=1.1)]),
         r"cells\.B2: B2\.base does not fit on B1\.top: .* 1\.1 m apart, expected 1 m\. Make its edges 1 m, or taper"),
        (lambda: cells.stack([OCTAHEDRON, cells.cube()]), r"cells\.B2: B2\.base has 4 corners, B1\.top has 3"),
        (lambda: cells.stack([OCTAHEDRON, cells.panel()]),
         r"cells\.B2: has 2 dimensions; the first cell has 3\. Join cells of the plane, or"),
        (lambda: cells.branch(OCTAHEDRON, {"side9": OCTAHEDRON}), r"arms\.side9: the hub has no face 'side9'\. Did you mean"),
        (lambda: cells.assemble({"A": OCTAHEDRON, "B": cells.octahedron(on="A.tip")}), r"cells\.B: there is no face 'A\.tip'"),
        (lambda: cells.assemble({"B": cells.octahedron(on="A"), "A": OCTAHEDRON}), r"cells\.B: there is no face 'A' among"),
        (lambda: cells.double_octahedron(longeron=0.5), r"longeron: 0\.5 m cannot span .* Make it longer than half"),
        (lambda: cells.double_octahedron(top=1.0, upper_longeron=0.4), r"upper_longeron: 0\.4 m cannot span"),
        (lambda: cells.double_octahedron(top=1.0, beta=0.1), r"beta: a tapered bay has no mirror plane, so no closed form"),
        (lambda: cells.double_octahedron(top=1.0, active_length=3),
         r"active_length: 3 m does not close the bay.*must lie between"),
        (lambda: cells.quadruple_octahedron(beta="170 deg"), r"beta: in each half, the pose .* is out of reach"),
        (lambda: cells.octahedron(beta="120 deg"), r"beta: tilted by 120 and 0 deg, the top cuts the base\. Tilt less"),
        (lambda: cells.triangle(left=0.2, right=0.3), r"base: sides of 1, 0\.2 and 0\.3 m close no triangle"),
        (lambda: cells.octahedron(active="longerons"), r"active\.longerons: 'longerons' matches no bar\. Did you mean"),
        (lambda: cells.octahedron(active={"longeron1": {"base": {"length": 1}}}),
         r"active\.longeron1: has no tube\. Give base"),
        (lambda: cells.octahedron(active={"longeron1": {"limits": (1, 2)}}), r"active\.longeron1: has limits, but no rods"),
        (lambda: cells.octahedron(side=-1, height="1 kg"), r"(?s)side: -1 must be greater.*height: '1 kg' is not a length"),
        (lambda: cells.octahedron(at=(1, 2)), r"at: has 2 components; the cell has 3"),
        (lambda: cells.octahedron(at=(1, 2, 3), on="A"), r"at: is given, but the cell stands on 'A'"),
        (lambda: cells.stack([OCTAHEDRON, cells.octahedron(active="batten1")]),
         r"bars\.batten1: is active, but lies on B1\.batten4"),
        (lambda: cells.stack([OCTAHEDRON], links={"longeron1": ("N1", "N5")}), r"links\.longeron1: is the name of a member"),
        (lambda: cells.stack([OCTAHEDRON], fixed=("N1", "N99")), r"fixed: there is no face 'N99'"),
        (lambda: cells.stack([]), r"cells: no cell is given"),
        (lambda: cells.ring([OCTAHEDRON]), r"cells: one cell makes no ring"),
        (lambda: cells.stack([{"kind": "octahedrom"}]),
         r"stack\.cells\.0: kind 'octahedrom' is not known\. Did you mean 'octahedron'"),
        (lambda: cells.stack([{"kind": "octahedron", "sid": 2}]),
         r"stack\.cells\.0\.sid: 'sid' is not known here\. Did you mean 'side'"),
        (lambda: cells.stack([{"kind": "octahedron", "count": 10**6}]), r"cells\.0\.count: these are 1000000 cells\. Use less"),
        (lambda: cells.cell(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "C")}),
         r"bars\.b: there is no node 'C' in the cell"),
        (lambda: cells.cell(nodes={"A": (0, 0), "B": (1, 0)}, faces={"top": ["A", "A"]}), r"faces\.top: names a node twice"),
        (lambda: cells.cell(nodes={"A": (0, 0), "B": (1, 0, 0)}), r"nodes\.B: has 3 coordinates, the first node 2"),
        (lambda: cells.assemble({"A": OCTAHEDRON, "B": cells.octahedron(at=(3, 0, 0))}, close={"A.top": "B.base"}),
         r"close\.A\.top: corners of A\.top and B\.base do not meet"),
        (lambda: cells.assemble({"A": cells.chain([OCTAHEDRON] * 2), "A.B1": cells.octahedron(at=(3, 0, 0))}),
         r"cells\.A\.B1: there would be two nodes called 'A\.B1\.N1'"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused_with_its_mend(make, message):
    with pytest.raises(ModelError, match=message) as caught:
        make()
    assert all(fault.mend for fault in caught.value.faults)


def test_a_turn_that_fits_is_offered():
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 2, 0), "D": (0, 0, 1), "E": (1, 0, 1), "F": (0, 2, 1)}
    bars = {f"{a}{b}": (a, b) for a, b in pairwise("ABCADEFDBECFA")}
    cell = cells.cell(nodes=nodes, bars=bars, faces={"base": ["B", "C", "A"], "top": ["D", "E", "F"]})
    with pytest.raises(ModelError, match=r"Give turn: 1\."):
        cells.stack([cell, cell])
    stack = cells.stack([cell, cell.with_(turn=1)])
    assert stack.nodes["B2.D"].at == pytest.approx((0, 0, 2))


def test_arguments_are_named():
    with pytest.raises(ArgumentError, match="octahedron: 'sid' is not known here. Did you mean 'side'"):
        cells.octahedron(sid=1)
    with pytest.raises(ArgumentError, match="mirror: 'z' is no axis of this cell. Give one of x, y"):
        cells.mirror(cells.triangle(), "z")


@pytest.mark.slow
def test_a_large_stack_has_every_cell():
    model = cells.stack([BAY] * 300)
    assert (len(model.nodes), len(model.members)) == (1803, 5400)
