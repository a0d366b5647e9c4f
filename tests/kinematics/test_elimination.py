"""Rank and null spaces by elimination, against all singular values: hundreds of structures, and matrices of chosen values."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.mechanics import RANK_TOLERANCE, compile, eliminated, jacobian, rearrange
from kinetruss.mechanics.elimination import Elimination
from kinetruss.mechanics.null_space import Spaces

SHAPES = ((9, 4), (4, 3, 3))


def _lattice(seed, shape, off, share, driven):
    """A lattice of nodes on a grid, `off` away from it, with a share of the bars between neighbours, some of them driven."""
    rng = np.random.default_rng(seed)
    places = np.array(list(np.ndindex(*shape)), float)
    near = [(i, j) for i in range(len(places)) for j in range(i) if np.abs(places[i] - places[j]).max() < 1.5]
    places += off * rng.standard_normal(places.shape)
    kept = [pair for pair in near if rng.random() < share]
    bars = {
        f"b{k}": kt.Bar(ends=(f"n{i}", f"n{j}"), kind="driven" if rng.random() < driven else "rigid")
        for k, (i, j) in enumerate(kept)
    }
    nodes = {f"n{i}": tuple(place) for i, place in enumerate(places)}
    return kt.Model(nodes=nodes, bars=bars, fixed=[f"n{i}" for i in range(int(np.prod(shape[1:])))])


def _rank(J):
    values = np.linalg.svd(J, compute_uv=False)
    return int(np.sum(values > RANK_TOLERANCE * values.max(initial=0.0)))


@pytest.mark.slow
@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("off", [0.0, 0.2, 1e-4, 1e-7, 3e-9])
def test_has_the_rank_of_the_singular_values(shape, off):
    doubts, kinds = 0, set()
    for seed in range(30):
        system = compile(_lattice(seed, shape, off, (0.35, 0.55, 0.75)[seed % 3], (0.0, 0.1, 0.4)[seed % 4 % 3]))
        J, own = jacobian(system, system.x0), system.row_drive < 0
        found = eliminated(system, system.x0)
        if found is None:
            doubts += 1
            continue
        rank = _rank(J)
        assert (found.rank, found.first) == (rank, _rank(J[own])), seed
        kinds.add((rank < J.shape[1], rank < J.shape[0]))
        np.testing.assert_allclose(found.self_stress @ J, 0.0, atol=1e-10)
        np.testing.assert_allclose(found.free @ J.T, 0.0, atol=1e-10)
        assert _rank(found.self_stress) == len(J) - rank
        assert _rank(found.free) == J.shape[1] - rank
        assert own[found.independent].sum() == found.first
    assert doubts == 0 if off in (0.0, 0.2) else doubts < 30
    assert len(kinds) > 1  # mechanisms, redundancy or both


@pytest.mark.slow
@pytest.mark.parametrize("gap", range(4, 15))
def test_a_rank_is_sure_only_where_it_is_right(gap):
    rng, sure = np.random.default_rng(gap), 0
    for _ in range(20):
        r, c = rng.integers(45, 90, 2)
        small = rng.integers(0, 6)
        values = np.concatenate([10 ** rng.uniform(-2, 0, min(r, c) - small), 10.0**-gap * rng.uniform(0.2, 5, small)])
        U, V = (np.linalg.qr(rng.standard_normal((n, min(r, c))))[0] for n in (r, c))
        J = (U * values) @ V.T
        J /= np.linalg.norm(J, axis=1).max()
        found = Elimination(J)
        sure += found.sure
        assert not found.sure or found.rank == _rank(J)
    assert sure > 10 or gap in range(5, 14)


@pytest.mark.slow
def test_the_tidy_vectors_are_those_of_the_singular_vectors():
    for seed in range(12):
        system = compile(_lattice(seed, (9, 4), 0.2 * (seed % 2), (0.4, 0.75)[seed // 6], 0.0))
        J = jacobian(system, system.x0)
        sure, plain = Spaces(J, sure=eliminated(system, system.x0)), Spaces(J)
        assert sure.sure is not None
        for side in ("left", "right"):
            np.testing.assert_allclose(getattr(sure, side), getattr(plain, side), atol=1e-9)


@pytest.mark.slow
def test_forces_of_redundant_structures_do_not_depend_on_the_way(monkeypatch):
    for seed in range(6):
        model = _lattice(seed, (9, 4), 0.1, 0.8, 0.0).with_(gravity=(0, -9.81))
        model = model.with_(nodes={name: kt.Node(at=node.at, mass=1.0) for name, node in model.nodes.items()})
        system = compile(model)
        quick = rearrange(system, system.x0, None)
        if quick.plan is None:
            continue
        with monkeypatch.context() as now:
            now.setattr("kinetruss.mechanics.arrangement.FEW", 10**6)
            dense = rearrange(system, system.x0, None)
        np.testing.assert_array_equal(quick.not_unique, dense.not_unique)
        np.testing.assert_allclose(quick.weight, dense.weight)


def test_what_is_no_number_is_not_sure():
    J = np.eye(50)
    J[3, 4] = np.nan
    assert not Elimination(J).sure
    J[3, 4] = np.inf
    assert not Elimination(J).sure
