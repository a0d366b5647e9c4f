"""Campaigns see what is planted, and those that `.ci/run` does not have run for some seconds."""

import os

import pytest

from campaigns import cache, measured, studio_attack, two_writers

pytestmark = pytest.mark.slow


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test needs os.fork, which this system lacks")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of copies beside threads; none of theirs is used
def test_two_writers(tmp_path):
    found = two_writers.campaign(tmp_path, rounds=1, seed=3)
    assert found.faults == []
    assert found.counts["first: done"] == 1
    found.wanted = found.wanted.copy()
    found.wanted[-1, -1, -1] += 1e-15
    found.check(tmp_path / "out", "planted", whole=True)
    assert "positions are not those of an undisturbed run" in found.faults[0]
    (tmp_path / "out" / "left.lock").touch()
    found.check(tmp_path / "out", "planted", whole=True)
    assert "left over: ['left.lock']" in found.faults[-1]


KEPT = """
import json, pathlib, sys
place = pathlib.Path(sys.argv[2]) / "kernels"
place.mkdir(parents=True, exist_ok=True)
for name in "abc":
    (place / f"{name}.kernel").write_bytes(bytes(64))
"""


@pytest.mark.parametrize(("says", "fault"), [
    ("print(json.dumps({'right': False, 'hits': 3, 'told': 0}))", "wrong numbers"),
    ("print(json.dumps({'right': True, 'hits': 0, 'told': 0}))", "'hits': 0, 'told': 0}, expected"),
    ("print(json.dumps({'right': True, 'hits': 3, 'told': 1}))", "'told': 1}, expected"),
    ("raise OSError('damaged')", "OSError: damaged"),
])  # fmt: skip
def test_cache(tmp_path, monkeypatch, says, fault):
    monkeypatch.setattr(cache, "SMALL", KEPT + says)
    found = cache.Campaign(tmp_path / "cache", starts=2, seed=3)
    found.damaged()
    assert any(fault in one for one in found.faults)


@pytest.mark.parametrize("even", [True, False])
@pytest.mark.parametrize("law", ["trapezoid", "step_response, order 3"])
def test_measured(law, even):
    found = measured.kind(law, 1e-3, even, count=20, seed=3)
    assert list(found.faults()) == []


def test_studio_attack(tmp_path):
    found = studio_attack.campaign(tmp_path, messages=120, seed=3)
    assert found.faults == []
    assert {"scene", "drawing", "error"} <= set(found.counts)
