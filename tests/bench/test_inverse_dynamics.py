"""The benchmark runs and is right; how fast it is depends on the machine and is not judged here."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "inverse_dynamics.py"


def test_one_json_object_with_a_row_a_size():
    done = subprocess.run([sys.executable, SCRIPT, "--json", "--bays", "1"], check=True, capture_output=True, text=True)
    found = json.loads(done.stdout)
    assert set(found) == {"rows", "exponent"}
    assert [row["bays"] for row in found["rows"]] == [1]
    (row,) = found["rows"]
    assert set(row) == {"bays", "us_per_sample", "peak_mb", "max_relative_error"}
    assert row["us_per_sample"] > 0
    assert row["peak_mb"] < 1000
    assert row["max_relative_error"] < 1e-12
