"""Rank of large structures: what the sparse way finds is what all singular values say; long trusses are no mechanisms."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.mechanics import compile, null_space as _null_space
from kinetruss.mechanics.mode_texts import moves_text, ranked
from kinetruss.mechanics.null_space import tidy

COUNTS = ("rank", "degrees_of_freedom", "undriven", "self_stress")


def truss(seed, count, dim, bars, fixed, *, rounded):
    """Random nodes and bars; on a lattice where rounded, so that special positions come up."""
    chance = np.random.default_rng(seed)
    x = chance.normal(size=(count, dim)) * 2
    x = np.unique(np.round(x), axis=0) if rounded else x
    count = len(x)
    pairs = {}
    for _ in range(bars):
        a = int(chance.integers(count))
        b = (a + int(chance.integers(1, 9))) % count
        if a != b:
            pairs[min(a, b), max(a, b)] = (f"n{a}", f"n{b}")
    ends = {f"b{a}_{b}": pair for (a, b), pair in pairs.items()}
    nodes = {f"n{k}": tuple(map(float, at)) for k, at in enumerate(x)}
    return kt.Model(nodes=nodes, fixed=[f"n{k}" for k in range(min(fixed, count))], bars=ends)


def both(model, monkeypatch):
    """Mobility by all singular values, and by inverse iteration."""
    monkeypatch.setattr(_null_space, "DENSE", 10**6)
    dense = kt.kinematics.mobility(model)
    monkeypatch.setattr(_null_space, "DENSE", 0)
    sparse = kt.kinematics.mobility(model)
    for one in (dense, sparse):  # found when first asked for, so while the setting is still this
        monkeypatch.setattr(_null_space, "DENSE", 10**6 if one is dense else 0)
        _ = one.mechanisms, one.self_stress_states, one.second_order, one.smallest_singular_value
    return dense, sparse


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(
    st.integers(0, 2**32 - 1), st.integers(2, 25), st.sampled_from([2, 3]), st.integers(0, 70), st.integers(0, 3), st.booleans()
)
def test_sparse_and_dense_ranks_agree(seed, count, dim, bars, fixed, rounded):
    model = truss(seed, count, dim, bars, fixed, rounded=rounded)
    with pytest.MonkeyPatch.context() as monkeypatch:
        dense, sparse = both(model, monkeypatch)
    assert [getattr(dense, name) for name in COUNTS] == [getattr(sparse, name) for name in COUNTS]
    np.testing.assert_allclose(sparse.mechanisms, dense.mechanisms, atol=1e-8)
    np.testing.assert_allclose(sparse.self_stress_states, dense.self_stress_states, atol=1e-8)
    assert sparse.mechanism_texts() == dense.mechanism_texts()
    if min(dense.spaces.shape) and dense.rank == min(dense.spaces.shape):
        assert sparse.smallest_singular_value == pytest.approx(dense.smallest_singular_value, rel=1e-6, abs=1e-12)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 5), st.integers(0, 20))
def test_names_follow_from_the_space_not_from_the_basis(seed, count, more):
    """Any basis of one space gives the same vectors: bases differ between processors."""
    chance = np.random.default_rng(seed)
    basis = np.linalg.qr(np.round(chance.normal(size=(count + more, count))) + np.eye(count + more, count) * 5)[0]
    turned = basis @ np.linalg.qr(chance.normal(size=(count, count)))[0]
    np.testing.assert_allclose(tidy(turned), tidy(basis), atol=1e-9)


def test_equal_sizes_stand_in_their_own_order():
    assert ranked(np.array([1 - 2e-16, 0.3, 1.0, 1 - 1e-16, 0.3 + 1e-16, 0.0]), 1e-6) == [0, 2, 3, 1, 4]
    mode = np.array([[1 - 1e-16, 0], [0, -1.0], [1.0, -1e-12]])
    system = compile(kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1)}, bars={"AB": ("A", "B")}))
    assert moves_text(system, mode).startswith("A moves along x (+1.000), B moves along y (-1.000), C moves along x")


def panels(count, *, crossed=False):
    nodes = {f"b{i}": (float(i), 0.0) for i in range(count + 1)} | {f"t{i}": (float(i), 1.0) for i in range(count + 1)}
    bars = {}
    for i in range(count):
        bars |= {f"B{i}": (f"b{i}", f"b{i + 1}"), f"T{i}": (f"t{i}", f"t{i + 1}"),
                 f"D{i}": (f"b{i}", f"t{i + 1}"), f"V{i}": (f"b{i + 1}", f"t{i + 1}")}  # fmt: skip
        if crossed:
            bars[f"E{i}"] = (f"t{i}", f"b{i + 1}")
    return kt.Model(nodes=nodes, fixed=["b0", "t0"], bars=bars)


@pytest.mark.slow
@pytest.mark.parametrize("crossed", [False, True])
def test_long_trusses_are_no_mechanisms_and_a_bar_less_is_found(crossed):
    """3,000 panels: the softest bending is strained by 1e-7 only. Without one chord, the part beyond turns about one node."""
    whole = panels(3000, crossed=crossed)
    found = kt.kinematics.mobility(whole)
    assert (found.undriven, found.self_stress) == (0, 3000 if crossed else 0)
    cut = {"T1500", "E1500", "D1500"} if crossed else {"T1500"}
    broken = kt.kinematics.mobility(whole.with_(bars={name: bar for name, bar in whole.bars.items() if name not in cut}))
    assert (broken.undriven, broken.self_stress) == (2 if crossed else 1, 2999 if crossed else 0)
    assert np.abs(broken.mechanisms[:, :1500]).max() < 1e-6  # bottom nodes before the cut stand still


@pytest.mark.slow
def test_bending_of_a_very_long_truss_is_told_from_a_mechanism(monkeypatch):
    """As if it were so long that its softest bending were below the tolerance: its bars part by no more than they stretch."""
    model = panels(400)
    least = kt.kinematics.mobility(model).smallest_singular_value
    monkeypatch.setattr(_null_space, "RANK_TOLERANCE", 2 * least)
    assert kt.kinematics.mobility(model).undriven == 0


@pytest.mark.slow
def test_a_flat_grid_in_space_has_a_freedom_for_every_node():
    """Nothing holds the nodes across the plane: counted at once, and named."""
    side = 14
    nodes = {f"n{i}_{j}": (float(i), float(j), 0.0) for i in range(side) for j in range(side)}
    bars = {}
    for i in range(side):
        for j in range(side):
            for k, (a, b) in enumerate(((i + 1, j), (i, j + 1), (i + 1, j + 1))):
                if f"n{a}_{b}" in nodes:
                    bars[f"b{i}_{j}_{k}"] = (f"n{i}_{j}", f"n{a}_{b}")
    found = kt.kinematics.mobility(kt.Model(nodes=nodes, bars=bars, fixed=["n0_0", "n0_1"]))
    assert found.undriven == side**2 - 2
    assert found.mechanism_texts(1)[0].startswith("n0_2 moves along z (+1.000)")
    assert "more mechanisms" in str(found)
