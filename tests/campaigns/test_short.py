"""Four campaigns for some seconds each; their long forms are commands in CONTRIBUTING.md."""

import os

import pytest

from campaigns import cache, measured, studio_attack, two_writers

pytestmark = pytest.mark.slow


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test needs os.fork, which this system lacks")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of copies beside threads; none of theirs is used
def test_two_writers(tmp_path):
    found = two_writers.campaign(tmp_path, rounds=5, seed=3)
    assert found.faults == []
    assert found.counts["read: read"] > 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test changes POSIX modes of files, which this system lacks")
def test_cache(tmp_path):
    found = cache.campaign(tmp_path / "cache", rounds=2, starts=2, seed=3)
    assert found.faults == []


@pytest.mark.parametrize("even", [True, False])
@pytest.mark.parametrize("law", ["trapezoid", "step_response, order 3"])
def test_measured(law, even):
    found = measured.kind(law, 1e-3, even, count=20, seed=3)
    assert list(found.faults()) == []


def test_studio_attack(tmp_path):
    found = studio_attack.campaign(tmp_path, messages=120, seed=3)
    assert found.faults == []
    assert {"scene", "drawing", "error"} <= set(found.counts)
