"""Simulations from the command line: run, interrupt, go on, look, export, compare."""

import csv
import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import kinetruss as kt
from kinetruss import runs
from kinetruss.cli import main

EXAMPLE = kt.library.example_files()["double_pendulum"][0]
LOOSE = """
kinetruss: 1
title: two springs
nodes: {A: [0, 0], B: {at: [1, 0], mass: 1 kg}, C: [2, 0]}
fixed: {A: xy, B: y, C: xy}
bars:
  left: {ends: [A, B], kind: elastic, stiffness: 100 N/m, natural_length: 0.8 m}
  right: {ends: [B, C], kind: elastic, stiffness: 50 N/m}
runs:
  swing: {analysis: dynamics.simulate, t_end: 1 s, samples: 11}
  far: {analysis: dynamics.simulate, t_end: 1 s, samples: 11, events: {there: {length: left, value: 3 m}}}
  short: {analysis: dynamics.simulate, t_end: 9 s, samples: 11, method: {kind: dop853, max_steps: 20}}
"""


def call(*arguments: object) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("simulated")
    (path / "loose.yaml").write_text(LOOSE)
    done = call("run", EXAMPLE, "fall", "-o", path / "fall", "-q")
    assert (done.exit_code, done.output) == (0, "")
    return path


@pytest.mark.slow
def test_check_asks_for_no_drive_of_what_is_let_go(folder):
    for file in (EXAMPLE, folder / "loose.yaml"):
        done = call("check", file)
        assert done.exit_code == 0, done.output


@pytest.mark.slow
def test_the_page_tells_how_it_was_stepped_and_what_happened(folder):
    text = call("info", folder / "fall").stdout
    for words in ("Completed.", "Taylor series", "of the largest kinetic energy", "Worst members", "energy balance"):
        assert words in text
    assert re.search(r"under +0\.4595\d+ s  falling", text)
    record = json.loads(call("info", folder / "fall", "--json").stdout)
    assert record["simulation"]["method"] == "taylor"
    assert record["simulation"]["energy"]["largest_change"] < 1e-7
    assert record["simulation"]["events"][0]["name"] == "under"
    assert record["checks"]["energy_balance"]["relative"] < 1e-8


@pytest.mark.slow
def test_an_event_ends_a_run_with_exit_code_0(folder):
    done = call("run", EXAMPLE, "down", "-o", folder / "down")
    assert done.exit_code == 0
    assert "Completed: an event stopped the run as requested." in done.stdout
    assert "Stopped by half_a_metre (coordinate B.y falls through -0.5 m)" in done.stdout


def test_an_event_that_never_comes_is_said(folder):
    done = call("run", folder / "loose.yaml", "far", "-o", folder / "far")
    assert done.exit_code == 0
    assert "Did not come up to t = 1 s: there (length left crosses 3 m)." in done.stdout


def test_a_run_that_ends_early_exits_with_1(folder):
    done = call("run", folder / "loose.yaml", "short", "-o", folder / "short")
    assert done.exit_code == 1
    assert "Raise max_steps" in done.stdout
    assert "of 11 samples are good" in done.stdout


@pytest.mark.slow
def test_pictures_plots_exports_and_comparisons(folder, tmp_path):
    assert call("plot", folder / "fall").exit_code == 0
    assert (folder / "fall" / "pictures" / "energies.svg").exists()
    assert call("plot", folder / "fall", "--quantity", "energies", "-o", tmp_path / "e.svg").exit_code == 0
    assert call("plot", folder / "fall", "--quantity", "smallest_pivot", "-o", tmp_path / "p.png").exit_code == 0
    assert call("export", folder / "fall", tmp_path / "all.csv").exit_code == 0
    with (tmp_path / "all.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 501
    assert "simulation.kinetic_energy (J)" in rows[0]
    if call("export", folder / "fall", tmp_path / "all.nc").exit_code == 0:
        import xarray as xr

        with xr.open_dataset(tmp_path / "all.nc", group="simulation") as data:
            assert data["event_name"].values.tolist()[0] == "under"
    assert call("run", EXAMPLE, "down", "-o", tmp_path / "down", "-q").exit_code == 0
    compared = call("compare", folder / "fall", tmp_path / "down", "--quantity", "member_force", "--json")
    assert compared.exit_code == 0
    assert json.loads(compared.stdout)


def test_forces_at_an_instant(folder):
    done = call("info", folder / "fall", "--joints", "--time", "1", "--member", "upper", "--json")
    assert json.loads(done.stdout)["time"] == pytest.approx(1.0)
    assert call("explain", EXAMPLE, "--run", "fall", "--member", "upper", "--time", "1").exit_code == 0


def test_variants_of_a_simulation(folder, tmp_path):
    done = call("run", EXAMPLE, "fall", "--set", "runs.fall.t_end=0.5 s,1 s", "-o", tmp_path / "two")
    assert done.exit_code == 0, done.output
    assert len(list((tmp_path / "two").iterdir())) == 2


@pytest.mark.slow
def test_an_interrupt_leaves_a_readable_run_to_go_on_with(tmp_path):
    model = kt.read(EXAMPLE)
    slow = model.runs["fall"].with_(t_end=3000.0, samples=300_001, events={})
    kt.write(model.with_(runs={"fall": slow}), tmp_path / "long.yaml")
    command = [Path(sys.executable).parent / "kinetruss", "run", tmp_path / "long.yaml", "-o", tmp_path / "run"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        while running.poll() is None and not committed(tmp_path / "run"):
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        out, error = running.communicate(timeout=60)
    assert (running.returncode, out) == (1, "")
    assert "samples are kept. Continue with: kinetruss run --resume" in error
    assert "Traceback" not in error
    half = runs.load(tmp_path / "run")
    assert (half.status.name, half.state) == ("INTERRUPTED", "incomplete")
    assert half.good > 0
    assert "Incomplete: it was interrupted" in call("info", tmp_path / "run").stdout


def committed(path: Path) -> int:
    file = path / "kinetruss.json"
    return int(json.loads(file.read_text())["committed"]) if file.exists() else 0


def test_what_stands_still_has_no_shares_of_round_off(tmp_path):
    upright = """
kinetruss: 1
nodes: {A: [0, 0], B: [0, 1], C: [2, 1.5], D: [2, 0]}
fixed: [A, D]
gravity: [0, -9.81]
bars: {a: {ends: [A, B], mass: 1}, b: {ends: [B, C], mass: 1}, c: {ends: [C, D], mass: 1}}
runs: {stand: {analysis: dynamics.simulate, t_end: 1 s, samples: 11}}
"""
    (tmp_path / "upright.yaml").write_text(upright)
    done = call("run", tmp_path / "upright.yaml", "stand", "-o", tmp_path / "out")
    assert "nothing moves" in done.stdout
    assert re.search(r"energy balance +0 of the largest power", done.stdout)
