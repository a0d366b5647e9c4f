"""Factors of sparse matrices: singular ones are told, never handed to SuperLU where they would ruin its memory."""

import numpy as np
from hypothesis import given, strategies as st
from scipy.sparse import csr_array, random_array
from scipy.sparse.csgraph import structural_rank

from kinetruss.mechanics.rows import SYMMETRIC, factors_of, matched

SIZE = 22


def symmetric(seed):
    """A sparse symmetric matrix, many of them with columns without entries or without a matching."""
    dice = np.random.default_rng(seed)
    half = random_array((SIZE, SIZE), density=dice.uniform(0.02, 0.15), rng=dice, format="csr")
    matrix = csr_array(half + half.T)
    matrix.setdiag(np.where(dice.random(SIZE) < 0.4, 0.0, dice.random(SIZE)))
    matrix.eliminate_zeros()
    return matrix


@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 1e-3, 0.1]))
def test_a_matrix_without_a_matching_has_no_factors(seed, threshold):
    matrix = symmetric(seed)
    factors = factors_of(matrix, permc_spec="NATURAL", diag_pivot_thresh=threshold, **SYMMETRIC)
    if structural_rank(matrix) < SIZE:
        assert factors is None
    elif factors is not None and threshold == 0.1:
        wanted = np.random.default_rng(seed).standard_normal(SIZE)
        found = factors.solve(matrix @ wanted)
        assert np.abs(matrix @ (found - wanted)).max() < 1e-6 * max(1.0, np.abs(found).max())


@given(st.integers(0, 2**32 - 1))
def test_rows_without_a_diagonal_entry_decide_for_a_symmetric_pattern(seed):
    matrix = symmetric(seed)
    whole = structural_rank(matrix) == SIZE
    assert matched(matrix, symmetric=False) == matched(matrix, symmetric=True) == whole


def test_singular_in_numbers_alone():
    assert factors_of(csr_array(np.ones((3, 3)))) is None
    assert factors_of(csr_array((2, 2))) is None
    assert np.allclose(factors_of(csr_array(np.diag([1.0, 2.0]))).solve(np.ones(2)), [1.0, 0.5])
