"""The bench of busy machines runs, and its cases are those that it names."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "bench"))

import busy


def test_rows_have_times_of_both(monkeypatch):
    monkeypatch.setattr(busy, "CASES", {"at rest": lambda: busy.frame(1, True), "lee": lambda: busy.lee(2)})
    rows = busy.measured(1)
    assert [row["case"] for row in rows] == ["at rest", "lee"]
    assert all(row["idle"] > 0 and row["busy"] > 0 for row in rows)
