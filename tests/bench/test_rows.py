"""Benchmarks run and are right; how fast anything is depends on the machine and is not judged here."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path[:0] = [str(BENCH), str(BENCH / "peers"), str(BENCH / "driven")]


def loaded(name):
    """A script of the benchmarks, as a module."""
    spec = importlib.util.spec_from_file_location(f"bench_{name}", BENCH / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def told(monkeypatch, capsys):
    """The JSON object that a script prints."""

    def call(name, *arguments):
        if name in ("driven", "forward"):  # they leave their workers behind
            call = [sys.executable, BENCH / f"{name}.py", "--json", *arguments]
            return json.loads(subprocess.run(call, check=True, capture_output=True, text=True).stdout)
        monkeypatch.setattr(os, "environ", os.environ.copy())  # some scripts ask for one thread
        monkeypatch.setattr(sys, "argv", [str(BENCH / f"{name}.py"), "--json", *arguments])
        loaded(name).main()
        return json.loads(capsys.readouterr().out)

    return call


def test_busy_machines(monkeypatch):
    busy = loaded("busy")
    monkeypatch.setattr(busy, "CASES", {"at rest": lambda: busy.frame(1, True), "lee": lambda: busy.lee(2)})
    rows = busy.measured(1)
    assert [row["case"] for row in rows] == ["at rest", "lee"]
    assert all(row["idle"] > 0 and row["busy"] > 0 for row in rows)


def test_forces_of_driven_trusses_are_those_of_dense_algebra(told):
    (row,) = told("driven", "--bays", "1", "--rounds", "1")["rows"]
    assert (row["code"], row["bays"]) == ("kinetruss", 1)
    assert row["error"] < 1e-13
    assert row["us_per_sample"] > 0


def test_the_dense_reference_keeps_power_balance():
    from _case import changes, course, right, times, truss

    bars, (x, v, a, tension) = truss(1), right(1)
    mass = bars.lump[:, None]
    inertia = np.einsum("sij,sij->s", v, mass * (a - bars.gravity) - bars.force)
    drives = -(tension @ changes(bars)) * course(times())[1]
    assert np.abs(x[:, bars.fixed] - bars.points[bars.fixed]).max() == 0
    assert drives == pytest.approx(inertia, abs=1e-10 * np.abs(inertia).max())


def test_a_wrong_force_counts_as_an_error():
    from _case import SETTLED, error_of, right

    state = right(1)[3].copy()
    assert error_of(1, state.reshape(-1).tolist()) == 0
    state[SETTLED + 5, 3] += 0.01 * np.abs(state).max()
    assert error_of(1, state.reshape(-1).tolist()) == pytest.approx(0.01, rel=1e-9)


def test_forward_dynamics_without_peers(told):
    found = told("forward", "--cases", "n_four_bar", "--sizes", "1", "--rounds", "1", "--no-growth")
    assert {row["code"] for row in found["rows"]} == {"kinetruss", "kinetruss.simulate"}
    assert min(row["error"] for row in found["rows"]) < 1e-10
    assert all(row["seconds"] > 0 for row in found["rows"])
    assert [ratio["error"] for ratio in found["ratios"]] == [1e-4, 1e-6, 1e-8]
    assert all(ratio["times_faster"] is None and ratio["seconds"] > 0 for ratio in found["ratios"])


def test_a_peer_that_is_not_there_is_left_out_with_its_reason(tmp_path):
    (tmp_path / "_worker.py").write_text((BENCH / "peers" / "_worker.py").read_text())
    call = [sys.executable, tmp_path / "_worker.py", "nobody"]
    said = subprocess.run(call, input='{"do": "hello"}\n', check=True, capture_output=True, text=True).stdout
    assert json.loads(said) == {"failed": "ModuleNotFoundError: No module named '_nobody'"}


def test_a_ratio_takes_measured_points_that_are_exact_enough():
    ratio = loaded("forward").ratio
    rows = [
        {"code": "kinetruss", "setting": "a", "error": 1e-7, "seconds": 2.0},
        {"code": "kinetruss", "setting": "b", "error": 1e-5, "seconds": 1.0},
        {"code": "mujoco", "setting": "c", "error": 2e-6, "seconds": 0.1},
        {"code": "exudyn", "setting": "d", "error": 1e-6, "seconds": 10.0},
    ]
    found = ratio(rows, "chain", 1, 1e-6)
    assert (found["fastest_peer"], found["times_faster"]) == ("exudyn", 5.0)
    assert ratio(rows, "chain", 1, 1e-8)["times_faster"] is None
    assert ratio(rows[2:], "chain", 1, 1e-5)["times_faster"] == 0.0


def test_gradients_are_exact():
    """By tables: those of a complex step of the whole, and of differences of statics."""
    found = loaded("gradients").through_tables()
    assert found["error_complex"] < 1e-12
    assert found["error_differences"] < 1e-7
    assert found["ratio"] > 0


def test_inverse_dynamics():
    """The row of a process; the script has one for each number of bays."""
    found = loaded("inverse_dynamics").row(1)
    assert found["us_per_sample"] > 0
    assert found["peak_mb"] < 1000
    assert found["max_relative_error"] < 1e-12


def test_robots(told):
    rows = told("robots", "--rounds", "1", "--cases", "delta_path", "stewart_path")["rows"]
    assert [row["case"] for row in rows if row["error"] is not None] == [
        "delta path: inverse_along",
        "stewart path: inverse_along",
    ]
    for row in rows:
        assert set(row) == {"case", "us_per_sample", "seconds", "error", "ratio"}
        assert row["error"] is None or row["error"] < 1e-11


def test_models_of_robots(told):
    """Each to the error wanted with a time, and again at 1e-11."""
    rows = told("robots", "--rounds", "1", "--cases", "models")["rows"]
    names = ["andrews, ten bars", "andrews, rigid beam", "robot", "delta"]
    assert [row["case"].removeprefix("models, ").split(":")[0] for row in rows] == names + names
    assert all(row["seconds"] > 0 and row["error"] <= 1e-8 for row in rows[:4])
    assert all(row["seconds"] is None and row["error"] < 1e-10 for row in rows[4:])


def test_sizing(told):
    (row,) = told("sizing", "--cases", "bay")["rows"]
    assert set(row) == {"case", "seconds", "iterations", "mass_before", "mass_after"}
    assert row["iterations"] >= 2
    assert 0 < row["mass_after"] < row["mass_before"]
    assert 0 < row["seconds"] < 60


def test_solids():
    found = loaded("solids").measured(least=100, rounds=2)
    assert found["elements"] >= 100
    assert [row["case"] for row in found["rows"]] == ["force", "tangent"]
    for row in found["rows"]:
        assert set(row) == {"case", "ns_per_element", "bytes_per_element", "bound_ns", "ratio"}
        assert row["ns_per_element"] > 0 < row["bound_ns"]


FRAMES = ("cantilever", "crossed", "grid", "frame", "space")


def test_statics():
    found = loaded("statics").measured((40, 400))
    assert [row["case"] for row in found["rows"]] == [case for case in FRAMES for _ in range(2)]
    for row in found["rows"]:
        assert min(row["compile"], row["mobility"], row["linear"]) > 0
        assert row["unbalanced"] < (1e-11 if row["case"] in ("frame", "space") else 1e-12)
        assert row["message"] == ""
        assert (row["force_error"] is None) == (row["case"] != "cantilever")
    assert all(row["force_error"] < 1e-13 for row in found["rows"][:2])
    assert set(found["exponents"]) == set(FRAMES)


def test_variants(told):
    (row,) = told("variants", "--variants", "2", "--repeats", "1")["rows"]
    assert set(row) == {"variants", "samples", "seconds", "command_seconds"}
    assert (row["variants"], row["samples"]) == (2, 500)
    assert 0 < row["seconds"] < row["command_seconds"]


@pytest.fixture(scope="module")
def against():
    return loaded("against")


def test_both_sides_of_a_comparison_are_measured(against):
    source = BENCH.parent / "src"
    (row,) = against.measured({"now": source, "then": source}, 1, ["linear small"])
    assert row["case"] == "linear small"
    assert row["now"] > 0 < row["then"]
    assert row["ratio"] == row["now"] / row["then"]


@pytest.mark.parametrize(("ratio", "code"), [(1.05, 0), (0.5, 0), (1.2, 1)])
def test_what_became_slower_is_told_by_the_exit_code(against, monkeypatch, capsys, ratio, code):
    row = {"case": "follow small", "now": ratio, "then": 1.0, "ratio": ratio}
    monkeypatch.setattr(against, "measured", lambda *_: [row])
    monkeypatch.setattr(against, "checkout", lambda *_: None)
    monkeypatch.setattr(sys, "argv", ["against.py", "REV", "--json"])
    assert against.main() == code
    assert '"ratio"' in capsys.readouterr().out


def test_every_case_of_a_comparison_runs(against):
    for name in ("follow small", "inverse small", "simulate small", "linear small"):
        assert against.CASES[name]()() is not None
