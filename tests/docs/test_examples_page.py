"""The page of examples: the figures of its table are those of the runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import kinetruss as kt

PAGE = (Path(__file__).parents[2] / "docs" / "examples.md").read_text(encoding="utf-8")
ROWS = [
    tuple(cell.strip() for cell in line.strip("|").split("|"))
    for line in re.findall(r"^\| \w+ \| \w+ \| \d.*$", PAGE, re.MULTILINE)
]


def test_every_example_of_the_table_has_its_picture():
    assert {name for name, *_ in ROWS} == set(re.findall(r"\(pictures/example_(\w+)\.png\)", PAGE))


@pytest.mark.parametrize("row", ROWS, ids=[" ".join(row[:2]) for row in ROWS])
def test_the_table_says_what_the_run_gives(row):
    name, run, drives, largest, governing, motor = row
    model = kt.read(kt.library.example_files()[name][0])
    told = kt.report.summary(kt.run(model, run)).record
    force, worst = told["largest_forces"][0], told["worst"][0]
    nearest = max((one["nearest_limit"] for one in told["motors"]), key=lambda one: one["utilisation"])
    assert drives == str(len(model.driven_members))
    assert largest == f"{force['member']}, {abs(force['force']):.1f} N"
    assert governing == f"{worst['part']}, {worst['rule']}, {100 * worst['utilisation']:.1f} %"
    assert motor == f"{nearest['quantity']}, {100 * nearest['utilisation']:.1f} %"
