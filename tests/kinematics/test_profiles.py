"""Laws of motion: closed forms, end conditions, derivatives, and the step response against the matrix exponential."""

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from scipy.linalg import expm

from kinetruss.kernels.motion import profiles

TIMES = np.linspace(0.0, 1.7, 41)
NEAR_ONE = st.floats(-1e-6, 1e-6).map(lambda e: 1 + e)


def slope(function, t, h=1e-3):
    """Central difference of order 8."""
    weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
    return sum(w * (function(t + k * h) - function(t - k * h)) for k, w in weights.items()) / h


SMOOTH = {
    "quintic": lambda t: profiles.quintic(t, 2.0),
    "steady": profiles.steady,
    "sine": lambda t: profiles.sine(t, 0.9, 0.4),
    "cyclic": lambda t: profiles.cyclic(t, 0.9),
    "under-damped": lambda t: profiles.step_response(t, 3.0, 0.4),
    "critical": lambda t: profiles.step_response(t, 3.0, 1.0),
    "over-damped": lambda t: profiles.step_response(t, 3.0, 1.7),
    "third order": lambda t: profiles.step_response(t, 3.0, 0.8, 6.0),
    "triple pole": lambda t: profiles.step_response(t, 3.0, 1.0, 3.0),
}


@pytest.mark.parametrize("law", SMOOTH.values(), ids=SMOOTH)
def test_rates_are_the_slopes_of_values(law):
    t = np.linspace(0.1, 1.6, 13)
    _, rate, acceleration = law(t)
    assert rate == pytest.approx(slope(lambda s: law(s)[0], t), abs=1e-10)
    assert acceleration == pytest.approx(slope(lambda s: law(s)[1], t), abs=1e-10)


def test_quintic_rests_at_both_ends_and_holds_outside():
    value, rate, acceleration = profiles.quintic(np.array([-1.0, 0.0, 1.0, 2.0, 5.0]), 2.0)
    assert value.tolist() == [0, 0, 0.5, 1, 1]
    assert rate.tolist() == [0, 0, 15 / 16, 0, 0]
    assert acceleration.tolist() == [0, 0, 0, 0, 0]


@given(st.floats(0.01, 0.5), st.floats(0.1, 10))
def test_trapezoid_reaches_one_with_constant_accelerations(ramp, duration):
    t = np.array([0.0, ramp / 2, ramp, 0.5, 1 - ramp / 2, 1.0]) * duration
    value, rate, acceleration = profiles.trapezoid(t, duration, ramp)
    top = 1 / (1 - ramp)
    assert value[[0, 3, 5]] == pytest.approx([0, 0.5, 1], abs=1e-14)
    assert value[1] == pytest.approx(top * ramp / 8)
    assert rate * duration == pytest.approx([0, top / 2, top, top, top / 2, 0], abs=1e-12)
    assert acceleration[[0, 1, 4, 5]] * duration**2 == pytest.approx(np.array([1, 1, -1, -1]) * top / ramp)


def test_trapezoid_stands_outside_its_time():
    value, rate, acceleration = profiles.trapezoid(np.array([-0.1, 1.1]), 1.0, 0.25)
    assert (value.tolist(), rate.tolist(), acceleration.tolist()) == ([0, 1], [0, 0], [0, 0])


def test_cyclic_goes_there_and_back():
    value, rate, _ = profiles.cyclic(np.array([0.0, 0.25, 0.5, 1.0]), 1.0)
    assert value == pytest.approx([0, 0.5, 1, 0], abs=1e-15)
    assert rate == pytest.approx([0, np.pi, 0, 0], abs=1e-14)


def state_space(t, w, zeta, p):
    """The same response by the matrix exponential of the filter p/(s + p) in front of the oscillator."""
    drive = np.zeros((4, 4))
    drive[0, 1] = 1
    drive[1] = [-(w**2), -2 * zeta * w, w**2, 0]
    drive[2, 2:] = [-p, p]
    start = np.array([0.0, 0, 0, 1])
    if p == np.inf:  # no filter: the input is 1 at once
        drive[2], start = 0, np.array([0.0, 0, 1, 0])
    states = np.array([expm(drive * s) @ start for s in t])
    return states[:, 0], states[:, 1], states @ drive[1]


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(
    st.one_of(st.floats(0.02, 20), st.just(1.0), NEAR_ONE),
    st.one_of(st.floats(0.05, 50), NEAR_ONE, st.sampled_from([None, 1.0, "fast", "slow"])),
)
@example(1.0, 1.0)
@example(1.25, 2.0)
@example(1.25, 0.5)
@example(0.8, 2.0)
def test_step_response_is_that_of_the_state_space(zeta, third):
    w = 2.3
    if isinstance(third, str):  # coincide with a real pole
        fast = zeta + np.sqrt(max(zeta**2 - 1, 0))
        third = fast if third == "fast" else 1 / fast
    p = None if third is None else third * w
    t = np.array([0.0, 1e-3, 0.1, 0.7, 2.0, 5.0])
    for mine, exact, scale in zip(
        profiles.step_response(t, w, zeta, p), state_space(t, w, zeta, p or np.inf), (1, w, w**2), strict=True
    ):
        assert mine / scale == pytest.approx(exact / scale, abs=1e-12)


def test_step_response_of_the_thesis():
    # Lacy (1991), section 3.2: 1.2 m in 3 s, w = 6/(.8 * .9 * 3), third pole 2 w; independent exact values
    w = 6 / (0.8 * 0.9 * 3)
    x, rate, acceleration = (1.2 * y for y in profiles.step_response(np.array([0.3, 0.6, 1.8]), w, 0.8, 2 * w))
    assert x == pytest.approx([0.1117549612, 0.4496181216, 1.202058522], rel=1e-9)
    assert rate == pytest.approx([0.8540749994, 1.247668662, 0.08647093043], rel=1e-9)
    assert acceleration == pytest.approx([2.852215399, -0.08552517499, -0.4006192707], rel=1e-9)


def test_step_response_is_still_before_the_step():
    assert [y.tolist() for y in profiles.step_response(np.array([-1.0]), 3.0, 0.8, 6.0)] == [[0], [0], [0]]


@pytest.mark.parametrize(("points", "degree"), [(2, 1), (3, 2), (4, 3), (5, 3), (6, 5), (30, 5)])
def test_spline_reproduces_polynomials(points, degree):
    table = 10 + 2 * (np.arange(points) + np.random.default_rng(points).uniform(-0.3, 0.3, points)) / (points - 1)
    poly = np.polynomial.Polynomial(np.arange(1.0, degree + 2), domain=[10, 12])
    t = np.linspace(table[0], table[-1], 17)
    columns = np.column_stack([poly(table), np.ones(points)])
    laws = profiles.spline(t, table, columns)
    for order, law in enumerate(laws):
        exact = poly.deriv(order)(t) if order else poly(t)
        assert law[:, 0] == pytest.approx(exact, rel=1e-9, abs=1e-7)
        assert law[:, 1] == pytest.approx(1 if order == 0 else 0, abs=1e-9)


def test_spline_holds_outside_its_table():
    table = np.arange(8.0)
    value, rate, acceleration = profiles.spline(np.array([-1.0, 9.0]), table, (table**2)[:, None])
    assert value[:, 0] == pytest.approx([0, 49], abs=1e-12)
    assert not rate.any()
    assert not acceleration.any()


def test_spline_converges_at_order_six():
    errors = []
    for points in (21, 41):
        table = np.linspace(0, 2, points)
        value, _, _ = profiles.spline(TIMES, table, np.sin(3 * table)[:, None])
        errors.append(np.abs(value[:, 0] - np.sin(3 * TIMES)).max())
    assert np.log2(errors[0] / errors[1]) > 5.5
