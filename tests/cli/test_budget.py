"""``kinetruss budget``: the table and the numbers of `runs.budget`."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("budget") / "bay.yaml"
    kt.write(kt.library.vgt.double_octahedral(), path)
    return path


def call(file, *words):
    return CliRunner().invoke(main, ["budget", str(file), *words])


@pytest.mark.slow
def test_the_table_has_units_and_shows_round_off_as_zero(file):
    words = ("--of", "bay.beta", "--of", "bay.gamma", "--tolerance", "M*.length=0.1 mm", "--samples", "50")
    done = call(file, *words, "--at", "bay.beta=5 deg")
    assert done.exit_code == 0, done.output
    first, second = (line.split() for line in done.stdout.splitlines()[1:3])
    assert first[:3] == ["bay.beta", "5", "deg"]
    assert second[:3] == ["bay.gamma", "0", "deg"]


@pytest.mark.slow
def test_the_object_has_the_numbers_of_the_api(file):
    done = call(file, "--of", "N8.x", "--tolerance", "M6.length=0.1 mm", "--samples", "20", "--seed", "3", "--json")
    found = json.loads(done.output)
    same = kt.runs.budget(kt.read(file), "N8.x", {"M6.length": 1e-4}, samples=20, seed=3)
    (row,) = found["quantities"]
    assert row["worst_case"] == float(same.worst_case[0]) == abs(row["share"]["M6.length"])
    assert row["monte_carlo"] == float(same.monte_carlo[0])
    assert found["tolerance"] == {"M6.length": 1e-4}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--tolerance", "M6.length"), "no name or no value. Write --tolerance NAME=VALUE"),
        (("--tolerance", "M6.length=1 mm", "--tolerance", "M6.length=2 mm"), "given twice"),
        (("--tolerance", "M6.length=1 kg"), "is not a length"),
        (("--tolerance", "M6.length=1 mm", "--at", "bay.beta=5 kg"), "5 kg"),
        (("--tolerance", "M6.length=1 mm", "--at", "bay.beta=5 mm"), "bay.beta"),
    ],
)
def test_wrong_usage_is_told(file, words, said):
    done = call(file, "--of", "N8.x", *words)
    assert done.exit_code == 2
    assert said in done.output
