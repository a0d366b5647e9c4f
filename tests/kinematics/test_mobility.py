"""Rank, mechanisms and self-stress of structures whose counts are known."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

import kinetruss as kt

CORNERS = {"a": (0, 0, 0), "b": (1, 0, 0), "c": (0, 1, 0), "d": (0, 0, 1)}


def all_pairs(nodes) -> dict:
    return {f"{p}{q}": (p, q) for p, q in combinations(nodes, 2)}


@pytest.mark.parametrize(("count", "bars"), [(4, 6), (5, 10), (6, 15)])
def test_complete_graphs_in_space(count: int, bars: int) -> None:
    """All pairs of n points in general position: rank 3 n - 6, the rest are states of self-stress."""
    rng = np.random.default_rng(count)
    nodes = {f"n{i}": tuple(rng.normal(size=3)) for i in range(count)}
    found = kt.kinematics.mobility(kt.Model(nodes=nodes, bars=all_pairs(nodes)))
    assert (found.bars, found.rank, found.degrees_of_freedom) == (bars, 3 * count - 6, 6)
    assert found.self_stress == bars - found.rank
    assert found.maxwell == found.undriven - found.self_stress


def test_octahedron_is_rigid_and_its_square_is_not() -> None:
    nodes = {"e": (1, 0, 0), "w": (-1, 0, 0), "n": (0, 1, 0), "s": (0, -1, 0), "t": (0, 0, 1), "b": (0, 0, -1)}
    bars = {k: v for k, v in all_pairs(nodes).items() if k not in ("ew", "ns", "tb")}
    octahedron = kt.kinematics.mobility(kt.Model(nodes=nodes, bars=bars))
    assert (octahedron.bars, octahedron.rank, octahedron.self_stress) == (12, 12, 0)
    square = {k: nodes[k] for k in "ensw"}
    ring = kt.kinematics.mobility(
        kt.Model(nodes=square, bars={"en": ("e", "n"), "nw": ("n", "w"), "ws": ("w", "s"), "se": ("s", "e")})
    )
    assert ring.degrees_of_freedom == 12 - 4


def test_rank_not_count_decides() -> None:
    """A straight bar pair: as many bars as coordinates, yet one mechanism and one self-stress."""
    flat = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, fixed=["A", "C"], bars={"l": ("A", "B"), "r": ("B", "C")})
    found = kt.kinematics.mobility(flat)
    assert (found.maxwell, found.undriven, found.self_stress) == (0, 1, 1)
    assert found.mechanism_texts()[0].startswith("B moves along y (+1.000) -- stiff to second order only")
    assert found.self_stress_texts() == ["l +1.000, r +1.000"]


def test_mechanisms_do_not_stretch_and_self_stress_is_in_balance() -> None:
    rng = np.random.default_rng(3)
    nodes = {f"n{i}": tuple(rng.normal(size=3)) for i in range(6)}
    bars = dict(list(all_pairs(nodes).items())[:13])
    model = kt.Model(nodes=nodes, bars=bars, fixed=["n0"])
    found = kt.kinematics.mobility(model)
    x = np.array(list(nodes.values()))
    ends = np.array([[int(n[1:]) for n in pair] for pair in bars.values()])
    u = x[ends[:, 1]] - x[ends[:, 0]]
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    for mode in found.mechanisms:
        assert np.abs(np.einsum("bc,bc->b", u, mode[ends[:, 1]] - mode[ends[:, 0]])).max() < 1e-12
    for state in found.self_stress_states:
        force = np.zeros_like(x)
        np.add.at(force, ends[:, 0], state[:, None] * u)
        np.subtract.at(force, ends[:, 1], state[:, None] * u)
        assert np.abs(force[1:]).max() < 1e-12


def test_double_octahedral_bay() -> None:
    found = kt.kinematics.mobility(kt.library.vgt.double_octahedral())
    assert (found.coordinates, found.fixed, found.bars) == (27, 9, 15)
    assert (found.rank, found.degrees_of_freedom, found.drives, found.undriven) == (15, 3, 3, 0)


def test_drive_texts_and_position_argument() -> None:
    model = kt.Model(nodes=CORNERS, bars=all_pairs(CORNERS), fixed=["a", "b", "c"])
    assert kt.kinematics.mobility(model).self_stress == 3
    with pytest.raises(kt.InputError, match=r"expected \(n_nodes = 4, dim = 3\)"):
        kt.kinematics.mobility(model, np.zeros((3, 3)))


def test_flat_arrangements_are_told_from_mechanisms_that_go_on():
    square = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (1, 1, 0), "D": (0, 1, 0)}
    bars = {a + b: (a, b) for a, b in ("AB", "BC", "CD", "DA", "AC", "BD")}
    flat = kt.kinematics.mobility(kt.Model(nodes=square, bars=bars))
    assert flat.undriven == 7
    assert all(any(abs(mode[:, 2]) > 0) == soft for mode, soft in zip(flat.mechanisms, flat.second_order, strict=True))
    assert "second order only" in str(flat)
    apex = kt.Model(nodes=square | {"Q": (0.5, 0.5, 0.7)}, bars=bars | {"Q" + a: ("Q", a) for a in "ABCD"})
    assert kt.kinematics.mobility(apex).undriven == 6  # rigid in space
    assert not any(kt.kinematics.mobility(apex).second_order)
    cranks = {"A": (0, 0), "B": (1, 0), "C": (2, 0), "P": (0.3, 1), "Q": (1.3, 1), "R": (2.3, 1)}
    links = {"a": ("A", "P"), "b": ("B", "Q"), "c": ("C", "R"), "pq": ("P", "Q"), "qr": ("Q", "R")}
    parallel = kt.kinematics.mobility(kt.Model(nodes=cranks, fixed=["A", "B", "C"], bars=links))
    assert (parallel.self_stress, parallel.second_order) == (0, (False,))
    doubled = kt.kinematics.mobility(kt.Model(nodes=cranks, fixed=["A", "B", "C"], bars=links | {"pr": ("P", "R")}))
    assert (doubled.self_stress, doubled.second_order) == (1, (False,))  # redundant, and yet it turns


def test_a_frame_of_rigid_beams_counts_as_one_rotation():
    """Two beams welded at B: three places and a rotation; each beam takes two, the support two of the seven."""
    beams = {name: kt.Beam(ends=tuple(name), kind="rigid", mass=1.0) for name in ("AB", "BC")}
    corner = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1)}, fixed=["A"], beams=beams)
    found = kt.kinematics.mobility(corner)
    assert (found.coordinates, found.fixed, found.bars, found.rank, found.degrees_of_freedom) == (7, 2, 4, 4, 1)
    # in space on a clamp by a hinge: two rotations, one beam with three, the hinge with two
    door = kt.Model(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0)}, clamped=["A"],
        beams={"door": kt.Beam(ends=("A", "B"), kind="rigid", mass=1.0, hinges={"A": (0, 0, 1)})},
    )  # fmt: skip
    found = kt.kinematics.mobility(door)
    assert (found.coordinates, found.fixed, found.rank, found.degrees_of_freedom) == (9, 3, 5, 1)


def test_what_stands_for_a_rigid_link_is_no_bar_of_the_user():
    """A crank and a rocker without sections, which are rigid, and a bar between them: one bar of the user."""
    four = {"O": (0, 0), "A": (0.5, 1), "B": (2, 1.5), "P": (2.4, 2), "C": (2, 0)}
    found = kt.kinematics.mobility(kt.Model(
        nodes=four, fixed=["O", "C"], bars={"ab": ("A", "B")}, links={"crank": ["O", "A"], "rocker": ["C", "B", "P"]},
    ))  # fmt: skip
    assert str(found).startswith("1 rigid bar, 2 links (rigid, as ")
    assert found.degrees_of_freedom == 1
    assert found.bars - found.link_bars == 1
    assert found.maxwell == found.coordinates - found.fixed - found.bars == found.undriven - found.self_stress


def test_links_in_a_dead_position_are_not_told_to_become_a_link():
    """O, M and C on one line: M moves across it to first order, and the links are straight already; of bars it may be one."""
    straight = {"nodes": {"O": (0, 0), "M": (1, 0), "C": (2, 0)}, "fixed": ["O", "C"]}
    pairs = {"a": ("O", "M"), "b": ("M", "C")}
    links, bars = (kt.Model(**straight, **{key: pairs}) for key in ("links", "bars"))
    said = [kt.kinematics.mobility(one).mechanism_texts()[0] for one in (links, bars)]
    assert all("M moves along y" in one and "stiff to second order only" in one for one in said)
    assert "draw it beside that position" in said[0] and "is a link" not in said[0]
    assert "a member with a pin in its middle is a link" in said[1]


@pytest.mark.parametrize("dim", [2, 3])
def test_a_body_without_braces_takes_none_from_links(dim):
    """A free link through three nodes has 3 (in space 6) freedoms, whether a body without braces holds masses on it or not."""
    nodes = {name: (x, 0.0, 0.0)[:dim] for name, x in zip("ABC", (0, 1, 2), strict=True)}
    body = {"load": kt.Body(nodes=("A", "B"), carriers=("A", "B"), mass=1.0, brace=False)}
    free = [kt.kinematics.mobility(kt.Model(nodes=nodes, links={"l": list("ABC")}, bodies=one)).undriven for one in ({}, body)]
    assert free[0] == free[1]
    assert dim == 3 or free[0] == 3


def test_a_body_without_braces_needs_none_where_bars_hold_it():
    nodes = {"A": (0, 0), "B": (1, 0), "C": (0, 1), "D": (1, 1)}
    bars = {"ab": ("A", "B"), "bc": ("B", "C"), "ca": ("C", "A")}
    own, other = kt.Body(nodes=("A", "B", "C"), mass=1.0, brace=False), kt.Body(nodes=("B", "C", "D"), mass=1.0)
    found = kt.kinematics.mobility(kt.Model(nodes=nodes, bars=bars, bodies={"own": own, "other": other}))
    assert (found.undriven, found.self_stress, found.bars) == (3, 0, 5)
