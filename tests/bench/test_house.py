"""No file imports itself by way of others, no two rooms each other, and none what another package keeps to itself."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

import house  # noqa: E402

pytestmark = pytest.mark.slow


def test_imports_go_one_way():
    files = house.sources(ROOT / "src" / "kinetruss")
    assert len(files) > 400
    assert house.circles(house.imports(files)) == []
    # a rule of the model stands beside its record and names, for types, the model that it judges
    for circle in house.circles(house.imports(files, types=True)):
        assert all(module.startswith("kinetruss.model.") for module in circle)
    assert house.private_imports(files) == 0
