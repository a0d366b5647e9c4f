"""No file imports itself by way of others, no two rooms each other, and none what another package keeps to itself."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "house.py"


def test_imports_go_one_way():
    found = json.loads(subprocess.run([sys.executable, SCRIPT, "--json"], check=True, capture_output=True).stdout)
    assert found["import circles"] == []
    # a rule of the model stands beside its record and names, for types, the model that it judges
    for circle in found["import circles with imports for types"]:
        assert all(module.startswith("kinetruss.model.") for module in circle.split())
    assert found["private imports across packages"] == 0
    assert found["files"] == len([*(SCRIPT.parents[1] / "src" / "kinetruss").rglob("*.py")])
