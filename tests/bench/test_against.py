"""Times beside another revision are taken of both sides, and what became slower is told by the exit code."""

import importlib.util
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def against():
    spec = importlib.util.spec_from_file_location("bench_against", ROOT / "bench" / "against.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_both_sides_are_measured(against):
    (row,) = against.measured({"now": ROOT / "src", "then": ROOT / "src"}, 1, ["linear small"])
    assert row["case"] == "linear small"
    assert row["now"] > 0 < row["then"]
    assert row["ratio"] == row["now"] / row["then"]


@pytest.mark.parametrize(("ratio", "code"), [(1.05, 0), (0.5, 0), (1.2, 1)])
def test_exit_code(against, monkeypatch, capsys, ratio, code):
    row = {"case": "follow small", "now": ratio, "then": 1.0, "ratio": ratio}
    monkeypatch.setattr(against, "measured", lambda *_: [row])
    monkeypatch.setattr(against, "checkout", lambda *_: None)
    monkeypatch.setattr(sys, "argv", ["against.py", "REV", "--json"])
    assert against.main() == code
    assert '"ratio"' in capsys.readouterr().out


def test_every_case_runs(against):
    for name in ("follow small", "inverse small", "simulate small", "linear small"):
        assert against.CASES[name]()() is not None
