"""The benchmark of sizing runs; how fast it is depends on the machine and is not judged here."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "sizing.py"


def test_one_json_object_with_a_row_a_case():
    done = subprocess.run([sys.executable, SCRIPT, "--json", "--cases", "bay"], check=True, capture_output=True, text=True)
    (row,) = json.loads(done.stdout)["rows"]
    assert set(row) == {"case", "seconds", "iterations", "mass_before", "mass_after"}
    assert row["iterations"] >= 2
    assert 0 < row["mass_after"] < row["mass_before"]
    assert 0 < row["seconds"] < 60
