"""The coefficients and the algebra of DOP853; rows of four-bars through singular positions, and what it cannot do."""

import math

import numpy as np
import pytest
from scipy.integrate import DOP853
from scipy.integrate._ivp import dop853_coefficients as published

import kinetruss as kt
from kinetruss.kernels.integrate import dop853 as method, dop853 as table, state as m
from kinetruss.library import mechanisms
from reference.linkages import row_of_four_bars
from reference.marching import march


def full_matrix():
    A = np.zeros((16, 16))
    for s in range(16):
        A[s, table.COL[table.PTR[s] : table.PTR[s + 1]]] = table.VAL[table.PTR[s] : table.PTR[s + 1]]
    return A


A = full_matrix()
B, C = A[12, :12], table.C


def test_coefficients_are_the_published_ones():
    np.testing.assert_array_equal(A, published.A)
    np.testing.assert_array_equal(C, published.C)
    np.testing.assert_array_equal(table.E3, published.E3[:12])
    np.testing.assert_array_equal(table.E5, published.E5[:12])
    np.testing.assert_array_equal(table.D, published.D)


def test_stages_lie_at_their_nodes():
    np.testing.assert_allclose(A.sum(1), C, atol=1e-14)


def trees(order):
    """Conditions b . phi = 1/gamma of all rooted trees of an order (Hairer I, theorem II.2.13), as (phi, gamma)."""
    made = {1: [(np.ones(12), 1)]}

    def products(total, largest):
        if total == 0:
            yield np.ones(12), 1
        for size in range(min(total, largest[0]), 0, -1):
            for k, (phi, gamma) in enumerate(made[size]):
                if size == largest[0] and k > largest[1]:
                    continue
                for rest, other in products(total - size, (size, k)):
                    yield (A[:12, :12] @ phi) * rest, gamma * other

    for n in range(2, order + 1):
        made[n] = [(phi, gamma * n) for phi, gamma in products(n - 1, (n - 1, 10**9))]
    return made


def test_order_conditions_up_to_order_8():
    made = trees(8)
    assert [len(made[n]) for n in range(1, 9)] == [1, 1, 2, 4, 9, 20, 48, 115]
    for n in range(1, 9):
        for phi, gamma in made[n]:
            assert B @ phi == pytest.approx(1.0 / gamma, abs=2e-15 * 10)


def test_weights_of_errors_vanish_on_lower_orders():
    made = trees(5)
    for n, weights in ((3, table.E3), (5, table.E5)):
        for order in range(1, n + 1):
            for phi, _ in made[order]:
                assert weights @ phi == pytest.approx(0.0, abs=1e-14)
        assert max(abs(weights @ phi) for phi, _ in trees(n + 1)[n + 1]) > 1e-6


def pendulum(t, y):
    return np.array([y[1], -9.81 * np.sin(y[0]) - 0.1 * t * y[1]])


def one_step(y, h):
    """A step of the compiled algebra from y at t = 0: new state, stages, coefficients of the interpolant."""
    K, out, F = np.zeros((16, 2)), np.zeros(2), np.zeros((8, 2))
    K[0] = pendulum(0.0, y)
    for s in range(1, 13):
        method.stage_state(y, K, s, h, out)
        K[s] = pendulum(C[s] * h, out)
    new = out.copy()
    for s in range(13, 16):
        method.stage_state(y, K, s, h, out)
        K[s] = pendulum(C[s] * h, out)
    method.dense_coefficients(y, new, K, h, F)
    return new, K, F


def test_a_step_is_that_of_the_published_method():
    y, h = np.array([1.0, 0.3]), 0.2
    new, K, F = one_step(y, h)
    solver = DOP853(pendulum, 0.0, y, 10.0, rtol=1e-4, atol=1e-4, first_step=h, max_step=h)
    solver.step()
    assert solver.t == h
    np.testing.assert_allclose(new, solver.y, rtol=1e-14)
    dense, out = solver.dense_output(), np.zeros(2)
    for s in (0.0, 0.1, 0.5, 0.83, 1.0):
        method.interpolate(F, s, out)
        np.testing.assert_allclose(out, dense(s * h), rtol=1e-14)
    scale = np.array([1e-5, 2e-5])
    error = method.error_norm(K, h, scale)
    assert error == pytest.approx(solver._estimate_error_norm(K[:13], h, scale), rel=1e-8)


def test_interpolant_and_its_rate_are_of_order_7_and_6():
    errors, rates = [], []
    for h in (0.1, 0.05):
        _, _, F = one_step(np.array([1.0, 0.3]), h)
        out, slope = np.zeros(2), np.zeros(2)
        method.interpolate(F, 0.4, out)
        method.interpolate_rate(F, 0.4, h, slope)
        truth = fine(0.4 * h)
        errors.append(np.abs(out - truth).max())
        rates.append(np.abs(slope - pendulum(0.4 * h, truth)).max())
    assert np.log2(errors[0] / errors[1]) == pytest.approx(8.0, abs=0.7)
    assert np.log2(rates[0] / rates[1]) == pytest.approx(7.0, abs=0.7)


def fine(t):
    """The solution at t by 64 steps."""
    y = np.array([1.0, 0.3])
    at = 0.0
    for _ in range(64):
        K, out = np.zeros((16, 2)), np.zeros(2)
        K[0] = pendulum(at, y)
        for s in range(1, 13):
            method.stage_state(y, K, s, t / 64, out)
            K[s] = pendulum(at + C[s] * t / 64, out)
        y, at = out.copy(), at + t / 64
    return y


def test_rate_of_the_interpolant_is_its_derivative():
    _, _, F = one_step(np.array([1.0, 0.3]), 0.2)
    slope, right, left = np.zeros(2), np.zeros(2), np.zeros(2)
    for s in (0.1, 0.45, 0.9):
        method.interpolate_rate(F, s, 0.2, slope)
        method.interpolate(F, s + 1e-6, right)
        method.interpolate(F, s - 1e-6, left)
        np.testing.assert_allclose(slope, (right - left) / (2e-6 * 0.2), rtol=1e-8)


def test_next_step_follows_the_error():
    assert method.next_step.py_func(1.0, 2.0**8, 1.0, False) == pytest.approx(0.45)
    assert method.next_step.py_func(1.0, 1e20, 1.0, False) == pytest.approx(0.333)
    assert method.next_step.py_func(1.0, 1e-14, 1e-4, False) > 4.0
    assert method.next_step.py_func(1.0, 1e-9, 1e-4, True) == 1.0


def test_stiffness_estimates_the_fastest_mode():
    omega = 50.0
    K, last, new = np.zeros((16, 2)), np.array([0.0, 0.0]), np.array([1e-6, 3e-5])
    K[11], K[12] = 0.0, [new[1], -(omega**2) * new[0]]
    assert method.stiffness(K, last, new, 0.1, 1) <= 0.1 * omega * 1.001


# on equations of motion


@pytest.mark.slow
@pytest.mark.parametrize("loops", [2, 40])
def test_rows_of_four_bars_through_flat_positions(loops):
    """Ten seconds, ten positions in which all loops are singular at once."""
    times = np.linspace(0, 10, 21)
    run = march(mechanisms.n_four_bar(loops=loops), times, kt.DOP853())
    theta, _ = row_of_four_bars(loops, times)
    assert run.code == m.DONE
    for k in (0, loops):
        place = run.node(f"B{k}") - [k, 0, 0]
        np.testing.assert_allclose(place[:, 0], np.sin(theta), atol=3e-8)
        np.testing.assert_allclose(place[:, 1], np.cos(theta), atol=3e-8)
    assert np.abs(run.energy - run.energy[0]).max() < 1e-9 * run.kinetic.max()
    flat = np.flatnonzero(np.diff(np.floor(row_of_four_bars(loops, np.linspace(0, 10, 20001))[0] / math.pi + 0.5)))
    passed = run.memory.passages[: run.count("passages_met")]
    np.testing.assert_allclose(passed[:, 0], np.linspace(0, 10, 20001)[flat], atol=1e-3)
    assert np.all(passed[:, 1] < 1e-3) and np.all(passed[:, 2] == 1.0)


@pytest.mark.slow
@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-12])
def test_flat_positions_at_other_tolerances(rtol):
    run = march(mechanisms.n_four_bar(loops=2), [0, 10.0], kt.DOP853(rtol=rtol, atol=rtol / 10))
    theta, _ = row_of_four_bars(2, np.array([10.0]))
    assert run.code == m.DONE
    assert abs(run.node("B0")[-1, 0] - np.sin(theta[0])) < 300 * rtol + 1e-10


def spring(stiffness, damping=0.0, mass=1.0, stretch=0.01):
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1 + stretch, 0), mass=mass)}, fixed={"O": "xy", "P": "y"},
        bars={"s": kt.Bar(ends=("O", "P"), kind="elastic", stiffness=stiffness, damping=damping, natural_length=1.0)},
    )  # fmt: skip


def test_a_stiff_damper_is_noticed():
    run = march(spring(1.0, 1e7), [0, 10.0], kt.DOP853(max_steps=20000), isolated=False)
    assert run.code == m.STIFF
    assert run.count("steps") < 300
