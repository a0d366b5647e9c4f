"""The page of examples: the figures of its table are those of the runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import kinetruss as kt

pytestmark = pytest.mark.slow

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


def test_the_page_tells_the_strokes_of_docking():
    model = kt.read(kt.library.example_files()["docking"][0])
    run = model.runs["dock"]
    for task in (run.targets, run.targets.with_(hold=("B3.M9",))):
        lengths = kt.kinematics.inverse(model, task, samples=run.samples).drive_position
        assert f"between {lengths.min().item():.3f} m and {lengths.max().item():.3f} m" in PAGE


def test_the_page_tells_the_deflection_of_the_crane():
    model = kt.read(kt.library.example_files()["space_crane"][0])
    run = model.runs["lift"]
    motion = kt.kinematics.inverse(model, run.targets, samples=run.samples)
    forces = kt.statics.at_poses(model, motion.position.values[[0, 30, 60]])
    low = -1e3 * kt.statics.deflection(model, forces).displacement.sel(node="B5.N8", axis="z").values
    assert f"{low[0]:.3f} mm at the start and {low[2]:.3f} mm at the end" in PAGE
    change = 1e3 * abs(kt.flexible.corrected(model, forces, at="B5.N8").change).max().item()
    assert f"change by {change:.3f} mm at most" in PAGE
    first = kt.flexible.frequencies(model, forces, modes=1).frequency.values[0, 0]
    assert f"with the load is {first:.2f} Hz" in PAGE
