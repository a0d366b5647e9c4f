"""The largest von Mises stress of a section, and located maxima, against brute force."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinetruss.kernels.sections.peaks import MOMENT_RESULTANT, MOMENT_SUM, least_tension, peaks
from kinetruss.kernels.sections.records import Polynomials
from kinetruss.kernels.sections.stress import GENERAL, RECTANGLE, ROUND, UNKNOWN, von_mises

stress = st.one_of(st.just(0.0), st.floats(1e-6, 1e3), st.floats(-1e3, -1e-6))
ANGLE = np.linspace(0, 2 * np.pi, 4001)
GRID = np.linspace(-1, 1, 401)


@settings(max_examples=200, deadline=None)
@given(stress, stress, stress, stress, stress)
def test_round_section_against_the_whole_circumference(a, b2, b3, k2, k3):
    sigma = a + b2 * np.sin(ANGLE) - b3 * np.cos(ANGLE)
    tau = k2 * np.sin(ANGLE) - k3 * np.cos(ANGLE)
    brute = np.sqrt(np.max(sigma**2 + 3 * tau**2))
    found = von_mises(ROUND, a, b2, b3, k2, k3)
    assert found >= brute * (1 - 1e-12)
    assert found <= brute * (1 + 1e-5)


@settings(max_examples=60, deadline=None)
@given(stress, stress, stress, stress, stress)
def test_rectangle_against_the_whole_section(a, b2, b3, k2, k3):
    y, z = np.meshgrid(GRID, GRID)
    sigma = a + b2 * z - b3 * y
    brute = np.sqrt(np.max(sigma**2 + 3 * ((k2 * (1 - y**2)) ** 2 + (k3 * (1 - z**2)) ** 2)))
    found = von_mises(RECTANGLE, a, b2, b3, k2, k3)
    assert found >= brute * (1 - 1e-12)
    assert found <= brute * (1 + 1e-4)


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
