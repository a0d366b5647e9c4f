"""Whatever stands in a field, it is taken or refused in words: no other error, no warning, and never without a mend."""

import datetime as dt
from collections.abc import Iterator

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.library import builders
from kinetruss.model import Record

VALUES = [
    5, -1, 1.5, 1e400, float("nan"), 10**400, "9" * 300, 1j, True, None, "", "w", "x y", "1 kg", b"x",
    [], [1], [1, 2], [1, 2, 3], ["a", "b", "c"], [[1]], [[1, 2], [3]], [[float("nan"), 0, 1]], [[True]], [None], [[None]], [{}],
    (), set(), object(), dt.date(2020, 1, 1), np.array(["a"]),
    {}, {"x": 1}, {1: 2}, {"a": None}, {"a": []}, {"a": {}}, {"a": 1, "kind": "sine"}, {"a": {"ends": 5}}, {"a": {"kind": []}},
    {"kind": None}, {"kind": 5}, {"kind": "nope"}, {"kind": []}, {"kind": {}},
]  # fmt: skip


def records() -> Iterator[type[Record]]:
    builders()
    waiting = [Record]
    while waiting:
        below = waiting.pop().__subclasses__()
        waiting += below
        yield from below


@pytest.mark.slow
@pytest.mark.parametrize("record", [pytest.param(one, id=f"{one.__module__}.{one.__name__}") for one in records()])
def test_every_field_takes_any_value_or_refuses_it_with_a_mend(record):
    refused = 0
    for field in record.model_fields:
        for value in VALUES:
            try:
                record(**{field: value})
            except kt.ModelError as error:
                refused += 1
                assert all(fault.message and fault.mend not in ("", "Mend the value.") for fault in error.faults), error
    assert refused or not record.model_fields


@pytest.mark.parametrize("elements", [[[0, 1, 10**30]], [[0.5, 1, 2]], [[True, False, True]], [[float("inf"), 1, 2]], "0 1 x"])
def test_elements_that_are_no_whole_numbers(elements):
    with pytest.raises(kt.ModelError, match=r"Give (one row of node numbers|rows of equal length)"):
        kt.Membrane(nodes=("A", "B", "C"), elements=elements, thickness=0.001)


@pytest.mark.parametrize("axis", [5, True, ["a", "b", "c"], [0, 0, 0], [1, 2], {"x": 1}, "up"])
def test_an_axis_is_a_letter_or_three_numbers(axis):
    with pytest.raises(kt.ModelError, match="axis"):
        kt.AngleDrive("crank", axis=axis)


def test_an_axis_may_be_text_and_an_array():
    assert kt.AngleDrive("crank", axis=["0", "3", "4"]).axis == kt.AngleDrive("crank", axis=np.array([0, 3, 4])).axis
