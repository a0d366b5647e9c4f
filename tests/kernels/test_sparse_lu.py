"""LU in a kept order of elimination, against LAPACK on the full matrix."""

import numba
import numpy as np
import pytest

import kinetruss as kt
from kinetruss.kernels.sweep.blocks import SPARSE, factor, factor_gradients, solve, solve_transposed, workspace
from kinetruss.kernels.sweep.lu import FAILED, new_order, sparse_again, sparse_first, sparse_solve, sparse_solve_transposed
from kinetruss.mechanics import arrange, compile

BEFORE = 3
"""Rows of the common array ahead of the block."""


@numba.njit
def _in_order(first, second, full, right):
    """Order from `first`; y and z of second y = right, second^T z = right; signs of both determinants, multiplications."""
    n = len(full)
    lu, order, left = np.zeros((BEFORE + n, n)), new_order(BEFORE + n, n), np.empty((2, n), np.bool_)
    lu[BEFORE:] = first
    parity, sign, count = sparse_first(lu, full, left, order, BEFORE, left.shape[1])
    lu[BEFORE:] = second
    again = sparse_again(lu, order, BEFORE, BEFORE + n)
    y, z, spare = right.copy(), right.copy(), np.empty(n)
    if again != FAILED:
        sparse_solve(lu, order, BEFORE, BEFORE + n, y, spare)
        sparse_solve_transposed(lu, order, BEFORE, BEFORE + n, z, spare)
    return y, z, parity * sign, parity * again if again != FAILED else FAILED, count


def _sparse(n, rng):
    """A regular matrix of about three numbers a row beside a full diagonal in a random order of columns."""
    full = rng.random((n, n)) < 2.5 / n
    full[np.arange(n), rng.permutation(n)] = True
    return full


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_solves_in_a_kept_order(seed):
    rng = np.random.default_rng(seed)
    n = 15 + 4 * seed
    full = _sparse(n, rng)
    first = np.where(full, rng.uniform(0.5, 1.0, (n, n)) * rng.choice([-1, 1], (n, n)), 0.0)
    second = first * rng.uniform(0.95, 1.05, (n, n))
    right = rng.standard_normal(n)
    y, z, sign, again, count = _in_order(first, second, full.copy(), right)
    bound = 1e-14 * np.linalg.cond(second) * n
    assert np.abs(y - np.linalg.solve(second, right)).max() < bound * np.abs(y).max()
    assert np.abs(z - np.linalg.solve(second.T, right)).max() < bound * np.abs(z).max()
    assert sign == np.linalg.slogdet(first)[0]
    assert again == np.linalg.slogdet(second)[0]
    assert count < n**3 / 12


@pytest.mark.slow
def test_an_arrow_is_eliminated_from_its_shaft():
    """Full last row and column, else a diagonal: one multiplication a row in that order, n^3/3 in the other."""
    n = 20
    arrow = 2.0 * np.eye(n)
    arrow[0, :] = arrow[:, 0] = 1.0
    arrow[0, 0] = 30.0
    *_, count = _in_order(arrow, arrow, arrow != 0, np.ones(n))
    assert count == n - 1


@pytest.mark.slow
def test_an_order_is_given_up_when_a_multiplier_explodes():
    first = np.array([[1.0, 1.0, 0.0], [1.0, -1.0, 1.0], [0.0, 1.0, 2.0]])
    second = first.copy()
    second[0, 0] = 1e-9
    *_, again, _ = _in_order(first, second, first != 0, np.ones(3))
    assert again == FAILED


@numba.njit
def _of_block(plan, values, x, spoil, right):
    """Solutions with the factors of block 0 for given gradients; its order of elimination was found at x, and was it kept?"""
    w = workspace(plan)
    w.target[plan.driven] = values[plan.drive[plan.driven]]
    w.inverse[plan.driven] = 1.0 / w.target[plan.driven]
    factor(plan, w, 0, x, 0)
    before = w.order.row.copy()
    for k in range(len(spoil)):
        w.gradient[k] = spoil[k]
    sign = factor_gradients(plan, w, 0)
    y, z = right.copy(), right.copy()
    solve(plan, w, 0, y)
    solve_transposed(plan, w, 0, z)
    return y, z, sign, w.state[0], np.all(before == w.order.row)


@pytest.mark.slow
@pytest.mark.parametrize("swaps", [False, True])
def test_blocks_look_for_another_order_where_theirs_fails(swaps):
    """A platform of 21 rows with the gradients of its own, or of another configuration in which pivots vanish."""
    system = compile(kt.library.mechanisms.stewart(platform_mass=12.0))
    plan = arrange(system).plan
    n = plan.ptr[1]
    assert n == 21
    d = system.x0.reshape(-1)[plan.B[:, None] + np.arange(3)] - system.x0.reshape(-1)[plan.A[:, None] + np.arange(3)]
    gradient = d / np.linalg.norm(d, axis=1, keepdims=True)
    if swaps:
        gradient = np.random.default_rng(0).standard_normal((n, 3)) * np.array([1.0, 1e-6, 1.0])
        gradient[::2, 0] = 1e-6
    matrix = np.zeros((n, n))
    matrix[plan.entry_row, plan.entry_col] = plan.entry_sign * gradient[plan.entry_row, plan.entry_axis]
    right = np.random.default_rng(1).standard_normal(n)
    y, z, sign, state, kept = _of_block(plan, system.drive_start, system.x0.reshape(1, -1), gradient, right)
    assert state == SPARSE
    assert kept != swaps
    assert sign == np.linalg.slogdet(matrix)[0]
    # backward stable: the residual is round-off of the products that make it
    assert np.abs(matrix @ y - right).max() < 1e-12 * np.abs(matrix).max() * np.abs(y).max()
    assert np.abs(matrix.T @ z - right).max() < 1e-12 * np.abs(matrix).max() * np.abs(z).max()
