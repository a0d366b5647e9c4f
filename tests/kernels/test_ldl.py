"""L D L^T of sparse matrices against dense solves: real, complex, with a pattern, as a skyline; dependent rows are dropped."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_array, csr_array

from kinetruss.kernels.solve.ldl import COORDINATE, ROW, ldl_dropped, ldl_factor, ldl_solve
from kinetruss.mechanics.sparse_plan import _columns, _targets


def pattern(dense, skyline):
    """ptr, below, target and the places (row, column) of the values of a symmetric matrix."""
    n = len(dense)
    low, high = np.nonzero(np.triu(dense, 1))
    if skyline:
        reach = [max([*np.flatnonzero(dense[j]), j]) for j in range(n)]
        for j in range(n):  # columns that are reached reach as far
            for i in range(j + 1, reach[j] + 1):
                reach[i] = max(reach[i], reach[j])
        below = np.concatenate([np.arange(j + 1, reach[j] + 1) for j in range(n)]).astype(np.int64)
        ptr = np.cumsum([0, *(reach[j] - j for j in range(n))])
        return ptr, below, np.zeros(0, np.int64)
    upper = csr_array(coo_array((np.ones(len(low)), (high, low)), shape=dense.shape))
    upper.sort_indices()
    ptr, below = _columns(n, upper.indptr.astype(np.int64), upper.indices.astype(np.int64))
    return ptr, below, _targets(ptr, below)


def values(dense, ptr, below):
    column = np.repeat(np.arange(len(dense)), np.diff(ptr))
    return np.concatenate([dense[below, column], np.diag(dense)])


def sparse(n, dice):
    root = np.where(dice.random((n, n)) < 0.15, dice.normal(size=(n, n)), 0.0)
    return root @ root.T + n * np.eye(n)


@pytest.mark.parametrize("skyline", [False, True])
@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("n", [1, 2, 7, 30])
def test_solutions_are_those_of_dense_algebra(n, turned, skyline):
    dice = np.random.default_rng(n)
    A, wanted = sparse(n, dice), dice.normal(size=n)
    if turned:
        A, wanted = A + 1j * np.where(A != 0.0, sparse(n, dice), 0.0), wanted + 1j * dice.normal(size=n)
        A = np.tril(A) + np.tril(A, -1).T
    ptr, below, target = pattern(A, skyline)
    value, b = values(A, ptr, below), A @ wanted
    ldl_factor(ptr, below, target, value)
    ldl_solve(ptr, below, target, value, b)
    assert b == pytest.approx(wanted, abs=1e-12)


def test_a_row_that_depends_on_others_is_dropped():
    dice = np.random.default_rng(3)
    M, J = np.diag(dice.uniform(1.0, 2.0, 6)), dice.normal(size=(3, 6))
    J[2] = J[0] - 2.0 * J[1]
    A = np.block([[M, J.T], [J, np.zeros((3, 3))]])
    ptr, below, target = pattern(A, skyline=False)
    value, gain, sort = values(A, ptr, below), np.empty(9), np.array([COORDINATE] * 6 + [ROW] * 3)
    assert ldl_dropped(ptr, below, target, value, sort, gain) < 1e-6
    f = dice.normal(size=6)
    b = np.concatenate([f, np.zeros(3)])
    ldl_solve(ptr, below, target, value, b)
    assert b[8] == 0.0
    assert J @ b[:6] == pytest.approx(0.0, abs=1e-12)
    assert M @ b[:6] + J.T @ b[6:] == pytest.approx(f, abs=1e-12)
