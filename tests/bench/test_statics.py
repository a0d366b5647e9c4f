"""The benchmark of statics measures what it says."""

import importlib.util
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

CASES = ("cantilever", "crossed", "grid", "frame", "space")
PLACE = Path(__file__).parents[2] / "bench" / "statics.py"


def test_rows_hold_what_the_page_says():
    spec = importlib.util.spec_from_file_location("bench_statics", PLACE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = module.measured((40, 400))
    assert [row["case"] for row in found["rows"]] == [case for case in CASES for _ in range(2)]
    for row in found["rows"]:
        assert min(row["compile"], row["mobility"], row["linear"]) > 0
        assert row["unbalanced"] < (1e-11 if row["case"] in ("frame", "space") else 1e-12)
        assert row["message"] == ""
        assert (row["force_error"] is None) == (row["case"] != "cantilever")
    assert all(row["force_error"] < 1e-13 for row in found["rows"][:2])
    assert set(found["exponents"]) == set(CASES)
