"""Critical loads: published values, and where Euler's hands over to Johnson's."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from kinetruss.errors import InputError
from kinetruss.strength import END_CONDITIONS, amplification, critical_load, end_condition, euler_load, johnson_load, transition

E = 71e9


def second_moment(outer, inner):
    return math.pi / 64 * (outer**4 - inner**4)


@pytest.mark.parametrize(
    ("outer", "inner", "length", "load"),
    [  # Lacy (1991): follower and tube of the triangular truss; bars of the double-octahedral truss; its tube alone
        (0.0254, 0.022225, 2.0, 1481.196),
        (0.75 * 0.0254, 0.62 * 0.0254, 0.889, 3055.11),
        (0.75 * 0.0254, 0.63 * 0.0254, 0.254, 35257.82),
        (0.75 * 0.0254, 0.62 * 0.0254, 1.2192, 1624.4),
        (0.75 * 0.0254, 0.63 * 0.0254, 1.2192, 1530.3),
    ],
)
def test_euler_loads_of_the_thesis(outer, inner, length, load):
    assert euler_load(E, second_moment(outer, inner), length) == pytest.approx(load, rel=3e-5)


def test_end_conditions():
    assert END_CONDITIONS["clamped-pinned"] == pytest.approx(2.0457, abs=5e-5)
    root = math.pi * math.sqrt(END_CONDITIONS["clamped-pinned"])
    assert math.tan(root) == pytest.approx(root, rel=1e-9)
    assert euler_load(E, 1e-9, 1.0, "clamped-free") == pytest.approx(euler_load(E, 1e-9, 2.0))
    assert euler_load(E, 1e-9, 1.0, "clamped-clamped") == pytest.approx(euler_load(E, 1e-9, 0.5))
    with pytest.raises(InputError, match="fixed-fixed"):
        end_condition("fixed-fixed")
    with pytest.raises(InputError, match="greater than 0"):
        end_condition(0.0)


positive = {
    "area": st.floats(1e-6, 1e-2),
    "radius": st.floats(1e-3, 0.5),
    "strength": st.floats(1e7, 2e9),
    "C": st.floats(0.2, 4),
}


@given(**positive)
def test_johnson_meets_euler_with_the_same_slope_at_half_the_squash_load(area, radius, strength, C):
    I = area * radius**2
    length = float(transition(E, strength, C)) * radius
    assert euler_load(E, I, length, C) == pytest.approx(area * strength / 2, rel=1e-9)
    assert johnson_load(E, I, area, length, strength, C) == pytest.approx(area * strength / 2, rel=1e-9)
    h = 1e-4 * length
    slopes = [
        (f(length + h) - f(length - h)) / (2 * h)
        for f in (lambda x: euler_load(E, I, x, C), lambda x: johnson_load(E, I, area, x, strength, C))
    ]
    assert slopes[0] == pytest.approx(slopes[1], rel=1e-5)


@given(**positive)
def test_critical_load_falls_with_length_and_never_passes_yield(area, radius, strength, C):
    I = area * radius**2
    lengths = np.linspace(0.01, 3, 200) * float(transition(E, strength, C)) * radius
    load = critical_load(E, I, area, lengths, strength, C)
    assert np.all(np.diff(load) < 0)
    assert np.all(load <= area * strength)
    assert np.all(load <= euler_load(E, I, lengths, C) * (1 + 1e-12))


def test_without_yield_strength_there_is_only_euler():
    assert critical_load(E, 1e-9, 1e-4, 0.1) == euler_load(E, 1e-9, 0.1)
    assert critical_load(E, 1e-9, 1e-4, 0.1, np.nan) == euler_load(E, 1e-9, 0.1)


def test_amplification():
    assert amplification(0.0, 100.0) == 1.0
    assert amplification(25.0, 100.0, factor=0.85, safety=2.0) == pytest.approx(0.85 / 0.5)
    assert np.isinf(amplification([100.0, 130.0], 100.0)).all()
    # a pinned beam-column under uniform load: the exact factor lies 3 % above at most, and meets it at both ends
    k = np.linspace(0.05, 0.95, 19) * math.pi / 2
    exact = 2 * (1 / np.cos(k) - 1) / k**2
    ratio = exact / amplification((2 * k / math.pi) ** 2, 1.0)
    assert np.all((ratio >= 1) & (ratio < 1.035))
