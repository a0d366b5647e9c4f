"""Arrivals of a polynomial at zero: against the roots it was made of, in any number of steps."""

import itertools

import numpy as np
import pytest
from hypothesis import assume, example, given, settings, strategies as st

from kinetruss.kernels.integrate.roots import DEEPEST, DEGREE, NODES, TO_BERNSTEIN, roots

BAND = 1e-12
"""Share of the largest value below which a value counts as zero."""


def arrivals(values, side, band=1e-13):
    """Places, ways and the side at the end, of the polynomial through values at Chebyshev's places."""
    b, n = TO_BERNSTEIN @ values, DEGREE
    stack, found, spare = np.zeros((DEEPEST + 2, n + 3)), np.zeros((2 * n + 8, 3)), np.zeros(n + 1)
    count, side = roots(b, n, side, band * np.abs(values).max(), 0.0, stack, found, spare)
    return found[:count, 0], found[:count, 1].astype(int), side


def product(t, places):
    return np.prod([t - one for one in places], axis=0) * (1.0 + (t - 0.3) ** 2)


def separate(places):
    """Whether the values between two roots are told from zero: six roots on a hundredth of the way are one, for a float."""
    largest = np.abs(product(NODES, places)).max() if len(places) else 1.0
    for a, b in itertools.pairwise(places):
        yield np.abs(product(np.linspace(a, b, 9), places)).max() > 10 * BAND * largest


@settings(max_examples=60, deadline=None)
@example([1, 2, 3, 4], [])
@given(st.lists(st.integers(1, 199), max_size=6, unique=True), st.lists(st.integers(1, 99), max_size=5, unique=True))
def test_every_root_is_found_once_however_the_way_is_cut(places, cuts):
    places = np.sort(np.array(places)) / 200.0
    assume(all(separate(places)))
    ends = np.array([0.0, *np.sort(cuts) / 100.0, 1.0])
    side, found, ways = int(np.sign(product(np.zeros(1), places)[0])) if len(places) else 1, [], []
    for a, b in itertools.pairwise(ends):
        values = product(a + (b - a) * NODES, places) if len(places) else np.ones(DEGREE + 1)
        at, way, side = arrivals(values, side, band=BAND)
        found, ways = [*found, *(a + (b - a) * at)], [*ways, *way]
    assert len(found) == len(places)
    np.testing.assert_allclose(found, places, atol=1e-6)
    assert all(one == -other for one, other in itertools.pairwise(ways))


@pytest.mark.parametrize("place", np.random.default_rng(4).uniform(0.02, 0.98, 12))
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_value_that_is_touched_is_reached_once(place, sign):
    at, way, side = arrivals(sign * (NODES - place) ** 2 * (1.0 + NODES), int(sign))
    assert len(at) == 1 and way[0] == -sign and side == sign
    assert at[0] == pytest.approx(place, abs=1e-6)


def test_what_stands_at_zero_does_not_arrive_there():
    assert arrivals(NODES * (1.0 + NODES), 0)[0].size == 0
    assert arrivals(np.zeros(DEGREE + 1) + 1e-20, 0)[0].size == 0
    at, _, side = arrivals(np.maximum(0.0, 1.0 - NODES) ** 3, 1)
    assert at.size == 1 and side == 0
