"""``kinetruss gauges``, and its text, table and picture."""

import csv
import json

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss import report
from kinetruss.cli import main
from kinetruss.io import read_strains
from kinetruss.runs import gauge_strains

FILES = kt.library.example_files()["strain_gauges"]
MODEL = str(FILES[0])
RECORDS = {path.stem[-1]: str(path) for path in FILES[1:]}


def call(*words):
    return CliRunner().invoke(main, ["gauges", *map(str, words)])


def test_the_example_comes_with_its_records_and_says_what_they_are():
    assert sorted(RECORDS) == ["1", "2"]
    for path in FILES[1:]:
        assert path.read_text().startswith("# Constructed, not measured")
    assert "constructed, not measured" in FILES[0].read_text()


def test_readings():
    found = call(MODEL, "--run", "experiment_1")
    assert found.exit_code == 0
    line = next(line for line in found.stdout.splitlines() if line.startswith("M6.axial"))
    assert [float(word) for word in line.split()[1:3]] == pytest.approx([4.6949, 7.7208])
    record = json.loads(call(MODEL, "--run", "experiment_1", "--json").stdout)
    assert record["schema"] == "kinetruss.gauges/1"
    assert record["samples"] == 110
    assert record["measured"] is None
    assert record["strain"]["G2"]["largest_time"] == pytest.approx(6.431)


@pytest.mark.slow
@pytest.mark.parametrize(("number", "rows", "offset"), [("1", 110, -0.524), ("2", 80, 0.5)])
def test_experiments_measured_against_simulated(number, rows, offset):
    """Constructed to differ as the thesis reports: 13 % to 5 % below in the first, 0.5e-6 in the second."""
    words = [MODEL, "--run", f"experiment_{number}", "--measured", RECORDS[number]]
    assert "Measured minus simulated (1e-6)" in call(*words).stdout
    record = json.loads(call(*words, "--json").stdout)["measured"]
    assert record["rows"] == rows
    column = record["columns"]["M6.axial"]
    assert column["offset"] == pytest.approx(offset, abs=1e-3)
    assert column["correlation"] > 0.999


def test_the_first_experiment_lies_below_the_simulation_all_along():
    """By 13 % at the start and 5 % at the end, but for its noise; in the thesis the simulated strain is the higher one."""
    model = kt.read(MODEL)
    record = read_strains(RECORDS["1"], model)
    found = kt.strength.compare_gauges(kt.runs.gauge_strains(model, "experiment_1", measured=record), record)
    below = -(found["difference"] / found["simulated"]).values[:, 0]
    share = found["time"].values / found["time"].values[-1]
    assert below.min() > 0
    np.testing.assert_allclose(below, 0.13 - 0.08 * share, atol=0.02)
    assert np.abs(below - (0.13 - 0.08 * share)).mean() < 0.006


@pytest.mark.slow
def test_tables_and_pictures(tmp_path):
    words = [MODEL, "--run", "experiment_2"]
    table = tmp_path / "strain.csv"
    assert call(*words, "-o", table).stdout.endswith(f"{table}\n")
    again = call(*words, "--measured", table, "--json")  # what is written can be read as a record
    assert json.loads(again.stdout)["measured"]["columns"]["G1"]["rms"] == pytest.approx(0, abs=1e-9)
    both = tmp_path / "both.csv"
    call(*words, "--measured", RECORDS["2"], "-o", both)
    head = next(csv.reader(both.read_text().splitlines()))
    assert head[1:] == [f"M6.axial {kind} [microstrain]" for kind in ("measured", "simulated", "difference")]
    for name in ("plain.png", "overlay.svg"):
        extra = ["--measured", RECORDS["2"]] if "overlay" in name else []
        assert call(*words, *extra, "-o", tmp_path / name).exit_code == 0
        assert (tmp_path / name).stat().st_size > 5000
    refused = call(*words, "-o", tmp_path / "strain.xls")
    assert refused.exit_code == 2
    assert "write to a table, .csv, or a picture" in refused.stderr
    (tmp_path / "file").write_text("")
    full = call(*words, "-o", tmp_path / "file" / "x.png")
    assert full.exit_code == 1
    assert "cannot be written" in full.stderr


@pytest.mark.slow
def test_a_run_folder(tmp_path):
    model = kt.read(MODEL)
    kt.run(model, "experiment_2", tmp_path / "out")
    assert call(tmp_path / "out").stdout == call(MODEL, "--run", "experiment_2").stdout


def test_unknown_parts_of_a_group_are_left_out():
    model = kt.read(MODEL)
    pair = {
        name: gauge.with_(angle=angle)
        for (name, gauge), angle in zip(model.gauges.items(), (0.0, 3.141592653589793), strict=False)
    }
    strains = gauge_strains(model.with_(gauges=pair), "experiment_2")
    assert "M6.bending_2" not in report.gauges(strains).text
    assert report.gauges(strains).record["strain"]["M6.bending_2"] is None
    assert "M6.bending_3 [microstrain]" in report.gauges(strains).rows[0]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ["--run", "experiment_1", "--measured", RECORDS["2"]],
            "t = 6.534 s and 25 more rows are outside the run, 0 s to 6.431 s",
        ),
        (["--run", "experiment_1", "--measured", "not_there.csv"], "not_there.csv: measured: there is no such file"),
        (["--run", "experiment_3"], "no run called 'experiment_3'"),
        (["--measured", RECORDS["1"]], "has 2 runs; name one"),
    ],
)
def test_wrong_usage(words, said):
    found = call(MODEL, *words)
    assert found.exit_code == 2
    assert said in found.stderr
    assert "Traceback" not in found.output


def test_a_model_without_gauges():
    found = call(kt.library.example_files()["triangular_truss"][0])
    assert found.exit_code == 2
    assert "The model has no gauges" in found.stderr


def test_record_of_a_group_reads_back():
    record = read_strains(RECORDS["1"], kt.read(MODEL))
    assert list(record.columns) == ["M6.axial"]
    assert record.times[1] == pytest.approx(0.059)
    assert record.columns["M6.axial"][0] == pytest.approx(4.07)
