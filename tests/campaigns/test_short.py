"""Two campaigns for some seconds each; their long forms are commands in CONTRIBUTING.md."""

import os

import pytest

from campaigns import cache, two_writers


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no copies of processes here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of copies beside threads; none of theirs is used
def test_two_writers(tmp_path):
    found = two_writers.campaign(tmp_path, rounds=5, seed=3)
    assert found.faults == []
    assert found.counts["read: read"] > 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="modes of files are those of POSIX")
def test_cache(tmp_path):
    found = cache.campaign(tmp_path / "cache", rounds=2, starts=2, seed=3)
    assert found.faults == []
