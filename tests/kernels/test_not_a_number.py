"""Numbers that are not finite: no solver indexes by them, and none calls what it found a solution."""

import numba
import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.equations import equations
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.cholesky import cholesky
from kinetruss.kernels.solve.kkt import project
from kinetruss.kernels.structure.applied import no_force
from kinetruss.kernels.sweep.lu import lu_factor, lu_solve, new_order, sparse_again, sparse_first, sparse_solve
from kinetruss.mechanics import compile

BAD = [np.nan, np.inf, -np.inf]


@numba.njit
def _dense(matrix, b):
    n = len(matrix)
    lu, pivot = matrix.copy(), np.full(n + 1, -1, np.int64)
    sign = lu_factor(lu, pivot, 0, n)
    lu_solve(lu, pivot, 0, n, b)
    return sign, pivot[:n]


@numba.njit
def _sparse(matrix, full, b):
    n = len(matrix)
    lu, order, left = matrix.copy(), new_order(n, n), np.empty((2, n), np.bool_)
    parity, sign, _ = sparse_first(lu, full, left, order, 0, left.shape[1])
    sparse_solve(lu, order, 0, n, b, np.empty(n))
    again = sparse_again(matrix.copy(), order, 0, n)
    return parity * sign, again, order.row, order.col


@numba.njit
def _definite(matrix):
    return cholesky(matrix, len(matrix))


@numba.njit
def _largest(values):
    size = 0.0
    for k in range(values.size):
        size = larger(size, abs(values[k]))
    return size


def spoilt(n, rng, bad):
    """A regular matrix with some, or all, of its entries spoilt."""
    matrix = rng.standard_normal((n, n)) + n * np.eye(n)
    matrix[rng.random((n, n)) < rng.choice([0.05, 0.5, 1.0])] = bad
    return matrix


@pytest.mark.slow
@pytest.mark.parametrize("bad", BAD)
@pytest.mark.parametrize("seed", range(6))
def test_pivots_stay_inside_the_matrix(bad, seed):
    rng = np.random.default_rng(seed)
    for n in (2, 3, 5, 9, 14, 21):
        matrix = spoilt(n, rng, bad)
        _, pivot = _dense(matrix, rng.standard_normal(n))
        assert (pivot >= np.arange(n)).all() and (pivot < n).all()
        _, _, row, col = _sparse(matrix, np.ones((n, n), np.bool_), rng.standard_normal(n))
        assert sorted(row) == sorted(col) == list(range(n))
        symmetric = np.where(np.isfinite(matrix) & np.isfinite(matrix.T), 0.1 * (matrix + matrix.T) + 4 * n * np.eye(n), bad)
        whole = np.isfinite(symmetric).all()
        assert _definite(symmetric) == whole


@pytest.mark.slow
@pytest.mark.parametrize("n", [2, 5, 14])
def test_a_matrix_without_a_number_is_singular(n):
    matrix = np.full((n, n), np.nan)
    assert _dense(matrix, np.ones(n))[0] == 0.0
    assert _sparse(matrix, np.ones((n, n), np.bool_), np.ones(n))[0] == 0.0


@pytest.mark.parametrize("place", range(4))
def test_no_size_is_lost_behind_one_that_is_no_number(place):
    values = np.array([1.0, 4.0, 2.0, 3.0])
    assert _largest(values) == 4.0
    values[place] = np.nan
    assert np.isnan(_largest(values))


@pytest.mark.parametrize("solver", ["dense", "sparse", "sweep"])
@pytest.mark.parametrize("bad", BAD)
def test_no_state_that_is_not_finite_is_called_settled(solver, bad):
    model = kt.library.mechanisms.double_pendulum()
    system = compile(model)
    eq, ws = equations(system, solver=solver, t_end=1.0)
    for place in range(eq.free.size):
        x, v = system.x0.reshape(-1).astype(float), system.velocity0.reshape(-1).astype(float)
        x[eq.free[place]] = bad
        a, N = np.zeros(x.size), np.zeros(eq.A.size)
        assert not project(eq, ws, 0.0, x.copy(), v.copy(), 1e-13)[0]
        evaluate(eq, ws, no_force, 0.0, x, v, a, N)
