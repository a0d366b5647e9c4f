"""The campaign of random structures, for some seconds; planted faults show that it sees them."""

import importlib.util
import sys
from pathlib import Path

import pytest

import kinetruss as kt

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def oracle():
    spec = importlib.util.spec_from_file_location("campaign_oracle", Path(__file__).parent / "oracle.py")
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = found  # records look their annotations up there
    spec.loader.exec_module(found)
    return found


def test_no_number_is_wrong_in_silence(oracle, tmp_path):
    found = oracle.campaign({"linear": 30, "inverse": 6, "forward": 6}, seed=20, out=tmp_path / "cases.jsonl")
    assert oracle.bad(found) == {}
    assert found.total() == 42 == len((tmp_path / "cases.jsonl").read_text().splitlines())
    for kind, least in (("linear", 20), ("inverse", 3), ("forward", 3)):
        assert found[f"{kind} match"] >= least


def spoiled(result, name, factor):
    data = result.data.copy(deep=True)
    data[name] = data[name] * factor
    return result.with_(data=data)


@pytest.mark.parametrize(("kind", "name", "factor"), [
    ("linear", "member_force", 1 + 1e-4), ("linear", "displacement", 1 + 1e-4), ("inverse", "member_force", 1 + 1e-4),
    ("inverse", "member_force", float("nan")), ("forward", "acceleration", 1 + 1e-4), ("forward", "position", 1 + 1e-4),
])  # fmt: skip
def test_planted_faults_are_seen(oracle, monkeypatch, kind, name, factor):
    right = {"linear": kt.statics.linear, "inverse": kt.dynamics.inverse, "forward": kt.dynamics.simulate}[kind]

    def wrong(*arguments, **options):
        found = right(*arguments, **options)
        if kind == "forward":
            return found.with_(motion=spoiled(found.motion, name, factor))
        return spoiled(found, name, factor)

    monkeypatch.setattr(kt.statics if kind == "linear" else kt.dynamics, right.__name__, wrong)
    found = oracle.campaign({kind: 8}, seed=20)
    assert found[f"{kind} MISMATCH"] >= 2
    assert oracle.bad(found)


def test_tracebacks_and_unfinished_counts_are_seen(oracle, monkeypatch):
    def broken(*_, **__):
        raise ZeroDivisionError

    monkeypatch.setattr(kt.statics, "linear", broken)
    assert oracle.bad(oracle.campaign({"linear": 3}, seed=1)) == {"linear TRACEBACK": 3}
    assert oracle.bad(oracle.campaign({"linear": 3}, seed=1, wall=-1.0)) == {"UNFINISHED": 3}
