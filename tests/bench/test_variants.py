"""The benchmark of variants runs; how fast it is depends on the machine and is not judged here."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "variants.py"


def test_one_json_object_with_a_row_a_size():
    command = [sys.executable, SCRIPT, "--json", "--variants", "2", "--repeats", "1"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    found = json.loads(done.stdout)
    (row,) = found["rows"]
    assert set(row) == {"variants", "samples", "seconds", "command_seconds"}
    assert (row["variants"], row["samples"]) == (2, 500)
    assert 0 < row["seconds"] < row["command_seconds"]
