"""The largest von Mises stress of a section, and located maxima, against brute force."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kinetruss.kernels.sections.peaks import (
    GENERAL,
    MOMENT_RESULTANT,
    MOMENT_SUM,
    RECTANGLE,
    ROUND,
    UNKNOWN,
    least_tension,
    peaks,
    von_mises,
)
from kinetruss.kernels.sections.records import Polynomials

stress = st.one_of(st.just(0.0), st.floats(1e-6, 1e3), st.floats(-1e3, -1e-6))
ANGLE = np.linspace(0, 2 * np.pi, 4001)
GRID = np.linspace(-1, 1, 401)


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(stress, stress, stress, stress, stress)
def test_round_section_against_the_whole_circumference(a, b2, b3, k2, k3):
    sigma = a + b2 * np.sin(ANGLE) - b3 * np.cos(ANGLE)
    tau = k2 * np.sin(ANGLE) - k3 * np.cos(ANGLE)
    brute = np.sqrt(np.max(sigma**2 + 3 * tau**2))
    found = von_mises(ROUND, a, b2, b3, k2, k3)
    assert found >= brute * (1 - 1e-12)
    assert found <= brute * (1 + 1e-5)


def on_the_circle(a, b2, b3, k2, k3):
    """Largest von Mises stress among all stationary points: the roots of a quartic in tan(angle/2), and both ends of it."""
    c, s, one = np.array([-1.0, 0, 1]), np.array([0.0, 2, 0]), np.array([1.0, 0, 1])  # (1 - w^2, 2 w, 1 + w^2)
    sigma, tau = a * one + b2 * s - b3 * c, k2 * s - k3 * c
    slope = np.convolve(sigma, b2 * c + b3 * s) + 3 * np.convolve(tau, k2 * c + k3 * s)
    # the derivative by the angle is that polynomial over (1 + w^2)^2; a double root has an imaginary part of rounding
    slope[np.abs(slope) < 1e-15 * np.abs(slope).max()] = 0.0
    w = np.roots(slope).real
    angle = np.concatenate([2 * np.arctan(w), [np.pi], ANGLE])
    vm = np.sqrt((a + b2 * np.sin(angle) - b3 * np.cos(angle)) ** 2 + 3 * (k2 * np.sin(angle) - k3 * np.cos(angle)) ** 2)
    return vm.max()


# equal magnitudes, right angles between bending and shear and slight departures from both: saddles and flat tops
alike = st.tuples(
    st.sampled_from([0.0, 1.0, -1.0, 2.0, 1.0 / 3]), st.sampled_from([0.0, 1e-12, 1e-7, 1e-4, -1e-3, 0.02])
).map(sum)  # fmt: skip
shared = st.sampled_from([1.0, 1e3, 1e-3, 1e8])


@pytest.mark.slow
@settings(max_examples=400, deadline=None)
@given(alike, alike, alike, alike, alike, st.sampled_from([1.0, np.sqrt(3), 1 / np.sqrt(3)]), shared)
def test_round_section_against_all_roots_of_its_quartic(a, b2, b3, k2, k3, ratio, unit):
    load = unit * np.array([a, b2, b3, ratio * k2, ratio * k3])
    found, wanted = von_mises(ROUND, *load), on_the_circle(*load)
    assert wanted * (1 - 1e-13) <= found <= wanted * (1 + 1e-7)


@pytest.mark.slow
@settings(max_examples=100, deadline=None)
@given(stress, stress, stress, stress, st.floats(1e-9, 1e-2), st.floats(0, 6.3))
def test_round_section_where_a_saddle_lies_near_the_top(a, b, k, other, small, turn):
    """Bending and shear nearly in one plane: the most bent point is a saddle, or nearly."""
    c, s = np.cos(turn), np.sin(turn)
    load = (a, b * s, b * c, k * c - small * other * s, -k * s - small * other * c)
    found, wanted = von_mises(ROUND, *load), on_the_circle(*load)
    assert wanted * (1 - 1e-13) <= found <= wanted * (1 + 1e-7)


def test_round_section_in_closed_form():
    a, b, k = 3.0, 2.0, 1.5
    assert von_mises(ROUND, a, 0.0, 0.0, 0.0, 0.0) == pytest.approx(a, rel=1e-15)
    assert von_mises(ROUND, 0.0, 0.0, 0.0, k, 0.0) == pytest.approx(np.sqrt(3) * k, rel=1e-15)
    assert von_mises(ROUND, a, 0.6 * b, 0.8 * b, 0.0, 0.0) == pytest.approx(a + b, rel=1e-15)
    assert von_mises(ROUND, -a, b, 0.0, 0.0, 0.0) == pytest.approx(a + b, rel=1e-15)
    # bending and shear in one plane: with K = 3 k^2, a parabola in the cosine, a^2 + K + a^2 b^2/(K - b^2) at its vertex
    K = 3 * 4.0**2
    assert von_mises(ROUND, a, 0.0, b, 4.0, 0.0) ** 2 == pytest.approx(a**2 + K + (a * b) ** 2 / (K - b**2), rel=1e-14)
    # shear across the plane of bending: the most bent point has the most shear
    assert von_mises(ROUND, a, b, 0.0, k, 0.0) ** 2 == pytest.approx((a + b) ** 2 + 3 * k**2, rel=1e-14)
    assert von_mises(ROUND, 0.0, 0.0, 0.0, 0.0, 0.0) == 0


@given(stress, stress, stress, stress, stress, st.integers(-90, 90))
def test_stress_grows_with_the_forces(a, b2, b3, k2, k3, decades):
    for shape in (ROUND, RECTANGLE):
        plain = von_mises(shape, a, b2, b3, k2, k3)
        load = np.array([a, b2, b3, k2, k3]) * 10.0**decades
        if shape == ROUND or abs(decades) < 60:
            assert von_mises(shape, *load) == pytest.approx(plain * 10.0**decades, rel=1e-12)


@given(st.tuples(*[stress] * 5), st.tuples(*[stress] * 5))
def test_the_stress_of_a_sum_is_at_most_the_sum_of_stresses(one, other):
    one, other = np.array(one), np.array(other)
    for shape in (ROUND, RECTANGLE, GENERAL):
        assert von_mises(shape, *(one + other)) <= (von_mises(shape, *one) + von_mises(shape, *other)) * (1 + 1e-12)


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(stress, stress, stress, stress, stress)
def test_rectangle_against_the_whole_section(a, b2, b3, k2, k3):
    y, z = np.meshgrid(GRID, GRID)
    sigma = a + b2 * z - b3 * y
    brute = np.sqrt(np.max(sigma**2 + 3 * ((k2 * (1 - y**2)) ** 2 + (k3 * (1 - z**2)) ** 2)))
    found = von_mises(RECTANGLE, a, b2, b3, k2, k3)
    assert found >= brute * (1 - 1e-12)
    assert found <= brute * (1 + 1e-4)


@settings(max_examples=100, deadline=None)
@given(*[st.floats(0.01, 1)] * 5)
def test_rectangle_whose_sides_and_inside_compete(a, b2, b3, k2, k3):
    y, z = np.meshgrid(GRID[200:], GRID[200:])
    brute = np.sqrt(np.max((a + b2 * z + b3 * y) ** 2 + 3 * ((k2 * (1 - y**2)) ** 2 + (k3 * (1 - z**2)) ** 2)))
    found = von_mises(RECTANGLE, a, b2, b3, k2, k3)
    assert brute * (1 - 1e-12) <= found <= brute * (1 + 1e-4)


@given(stress, stress, stress, stress, stress)
def test_never_below_the_two_points_nor_above_the_bound(a, b2, b3, k2, k3):
    shear = np.hypot(k2, k3)
    for shape, fibre in ((ROUND, np.hypot(b2, b3)), (RECTANGLE, abs(b2) + abs(b3)), (GENERAL, abs(b2) + abs(b3))):
        found = von_mises(shape, a, b2, b3, k2, k3)
        assert found >= (abs(a) + fibre) * (1 - 1e-12)
        assert found >= np.sqrt(a**2 + 3 * shear**2) * (1 - 1e-12)
        assert found <= np.sqrt((abs(a) + abs(b2) + abs(b3)) ** 2 + 3 * shear**2) * (1 + 1e-12)


@given(stress, stress, stress, st.floats(-10, 10))
def test_a_round_section_has_no_preferred_direction(a, b, k, turn):
    c, s = np.cos(turn), np.sin(turn)
    plain = von_mises(ROUND, a, 0.0, b, k, 0.0)
    turned = von_mises(ROUND, a, s * b, c * b, c * k, -s * k)
    assert turned == pytest.approx(plain, rel=1e-9, abs=1e-12)


def test_an_unknown_section_has_no_stress():
    assert np.isnan(von_mises(UNKNOWN, 1.0, 1.0, 1.0, 1.0, 1.0))


def polynomials(rng, count):
    """Coefficients of parts whose moment is the integral of their shear, as members have them; some with a nut inside."""
    coef, nut = np.empty((count, 1, 2, 17)), np.full((count, 1), 2.0)
    for i in range(count):
        nut[i] = rng.choice([2.0, rng.uniform(0.1, 0.9)])
        for j in range(2):
            T, V2, V3 = rng.normal(size=(3, 3))
            if j:
                T, V2, V3 = (np.array([-y[1] - y[2], y[1], y[2]]) for y in (T, V2, V3))
            M2 = np.array([0, V3[0], V3[1] / 2, V3[2] / 3])
            M3 = -np.array([0, V2[0], V2[1] / 2, V2[2] / 3])
            if j:
                M2[0], M3[0] = -M2.sum(), -M3.sum()
            coef[i, 0, j] = np.concatenate([T, V2, V3, M2, M3])
    return coef, nut


def ends_of(nut):
    """Where the segments of every part end: at the nut, and beyond every station."""
    return np.stack([nut, np.full_like(nut, 2.0)], axis=-1)


def values(coef, nut, xi, path=False):
    """T, V2, V3, M2, M3 of one part at many stations, on both sides of the nut."""
    rows = []
    for j in range(1 if nut > 1 or path else 2):
        lo, hi = (0.0, min(nut, 1.0)) if j == 0 else (nut, 1.0)
        x = lo + (hi - lo) * xi
        rows.append([np.polyval(c[::-1], x) for c in np.split(coef[j], [3, 6, 9, 13])])
    return np.concatenate(rows, axis=1)


@pytest.mark.slow
@pytest.mark.parametrize("measure", [ROUND, RECTANGLE, GENERAL, MOMENT_RESULTANT, MOMENT_SUM])
def test_maxima_along_a_part_are_located_not_sampled(measure):
    rng = np.random.default_rng(measure)
    coef, nut = polynomials(rng, 60)
    scale = np.array([[[1.0, 4.0, 3.0, 0.7]]])
    value, place = np.empty((60, 1)), np.empty((60, 1))
    moment = measure >= MOMENT_RESULTANT
    peaks(Polynomials(coef, ends_of(nut), nut), np.array([measure], np.int64), scale, np.array([moment]), 12, value, place)
    xi = np.linspace(0, 1, 4001)
    for i in range(60):
        T, V2, V3, M2, M3 = values(coef[i, 0], nut[i, 0], xi, path=moment)
        if measure == MOMENT_RESULTANT:
            dense = 4 * np.hypot(M2, M3)
        elif measure == MOMENT_SUM:
            dense = 4 * abs(M2) + 3 * abs(M3)
        else:
            dense = np.array([von_mises(measure, *row) for row in np.stack([T, 4 * M2, 3 * M3, 0.7 * V2, 0.7 * V3], axis=1)])
        assert value[i, 0] >= dense.max() * (1 - 1e-9)
        assert value[i, 0] <= dense.max() * (1 + 1e-5)
        assert 0 <= place[i, 0] <= 1


def test_least_tension_in_closed_form():
    rng = np.random.default_rng(8)
    coef, nut = polynomials(rng, 200)
    value, place = np.empty((200, 1)), np.empty((200, 1))
    least_tension(Polynomials(coef, ends_of(nut), nut), np.array([True]), value, place)
    xi = np.linspace(0, 1, 4001)
    for i in range(200):
        T = values(coef[i, 0], nut[i, 0], xi, path=True)[0]
        assert value[i, 0] <= T.min() + 1e-12
        assert value[i, 0] >= T.min() - 1e-6
        assert np.polyval(coef[i, 0, 0, 2::-1], place[i, 0]) == pytest.approx(value[i, 0])
