"""The benchmark of forward dynamics runs and is right; how fast it is depends on the machine and is not judged here."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

BENCH = Path(__file__).resolve().parents[2] / "bench"
SCRIPT = BENCH / "forward.py"


def test_rows_and_ratios_without_peers():
    call = [sys.executable, SCRIPT, "--json", "--cases", "n_four_bar", "--sizes", "1", "--rounds", "1", "--no-growth"]
    found = json.loads(subprocess.run(call, check=True, capture_output=True, text=True).stdout)
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
    forward = _module()
    rows = [
        {"code": "kinetruss", "setting": "a", "error": 1e-7, "seconds": 2.0},
        {"code": "kinetruss", "setting": "b", "error": 1e-5, "seconds": 1.0},
        {"code": "mujoco", "setting": "c", "error": 2e-6, "seconds": 0.1},
        {"code": "exudyn", "setting": "d", "error": 1e-6, "seconds": 10.0},
    ]
    found = forward.ratio(rows, "chain", 1, 1e-6)
    assert (found["fastest_peer"], found["times_faster"]) == ("exudyn", 5.0)
    assert forward.ratio(rows, "chain", 1, 1e-8)["times_faster"] is None
    assert forward.ratio(rows[2:], "chain", 1, 1e-5)["times_faster"] == 0.0


def _module():
    spec = importlib.util.spec_from_file_location("bench_forward", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
