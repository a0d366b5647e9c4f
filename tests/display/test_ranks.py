"""Order by size: of values that are equal but for round-off the first in their order comes first."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.display.ranks import largest, largest_first, levels, order_of, place_of_largest


def test_round_off_does_not_order():
    dice = np.random.default_rng(0)
    values = np.repeat([3.0, -2.0, 5.0, 0.0], 5)
    for _ in range(50):
        assert order_of(values * (1 + 1e-12 * dice.standard_normal(20))) == [
            *range(10, 15), *range(5), *range(15, 20), *range(5, 10)
        ]  # fmt: skip
        noisy = np.tile([1.0, 4.0, 2.0, 4.0], 5) * (1 + 1e-12 * dice.standard_normal(20))
        assert place_of_largest(noisy) == 1
        assert place_of_largest(noisy.reshape(5, 4), axis=1).tolist() == [1] * 5


def test_what_differs_is_ordered_and_nothing_is_lost():
    values = [2.0, math.nan, 1.0, math.inf, -math.inf, 2.0 + 1e-6, math.nan, math.inf]
    assert order_of(values) == [3, 7, 5, 0, 2, 4, 1, 6]
    assert levels(values) == [2, 5, 3, 0, 4, 1, 5, 0]
    assert largest_first([], abs) == []
    assert largest([-4.0, 3.0, 4.0], abs) == -4.0


def test_places_of_largest_are_those_of_numpy_where_values_differ():
    values = np.random.default_rng(1).standard_normal((7, 5))
    assert place_of_largest(values) == np.argmax(values)
    assert place_of_largest(values, axis=0).tolist() == np.argmax(values, axis=0).tolist()
    values[2] = math.nan
    assert place_of_largest(values) == np.nanargmax(values)
    values[4, 1], values[1, 3] = math.inf, -math.inf
    assert place_of_largest(values) == 21
    assert place_of_largest(np.full(3, math.nan)) == 0


@pytest.mark.parametrize("order", list(itertools.permutations("abc")))
def test_members_that_carry_the_same_stand_in_the_order_of_the_model(order):
    """Three bars at 120 deg under a load along their axis of symmetry carry the same, whatever round-off says."""
    angles = {name: 0.1 + k * math.tau / 3 for k, name in enumerate("abc")}
    at = {name: (math.cos(angle), math.sin(angle), 0.0) for name, angle in angles.items()}
    model = kt.Model(
        nodes={name.upper(): place for name, place in at.items()} | {"T": (0, 0, 1.3)},
        fixed=["A", "B", "C"],
        bars={name: (name.upper(), "T") for name in order},
        loads={"W": kt.NodalForce(node="T", force=(0, 0, -1e4))},
        section=kt.Rod(diameter=0.02),
        material="steel_s235",
    )
    rows = kt.strength.check(model, kt.runs.forces_at_rest(model)).table()
    of = [row.part for row in rows if row.rule == rows[0].rule]
    assert of == list(order)


def test_sizes_of_several_numbers_count_one_after_the_other():
    sizes = {"a": (0, 5.0), "b": (1, 2.0), "c": (1, 2.0 + 1e-12), "d": (1, float("nan")), "e": (1, 3.0)}
    assert largest_first(sizes, sizes.__getitem__) == ["e", "b", "c", "d", "a"]
    assert largest_first([], sizes.__getitem__) == []
