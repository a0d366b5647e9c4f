"""The benchmark of solids measures what it says."""

import importlib.util
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

PLACE = Path(__file__).parents[2] / "bench" / "solids.py"


def test_rows_hold_what_the_page_says():
    spec = importlib.util.spec_from_file_location("bench_solids", PLACE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = module.measured(least=100, rounds=2)
    assert found["elements"] >= 100
    assert [row["case"] for row in found["rows"]] == ["force", "tangent"]
    for row in found["rows"]:
        assert set(row) == {"case", "ns_per_element", "bytes_per_element", "bound_ns", "ratio"}
        assert row["ns_per_element"] > 0 < row["bound_ns"]
