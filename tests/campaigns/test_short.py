"""The campaigns, for some seconds each; their long forms are commands in CONTRIBUTING.md."""

import importlib.util
import os
from pathlib import Path

import pytest


def script(name: str):
    """A campaign as a module."""
    spec = importlib.util.spec_from_file_location(f"campaign_{name}", Path(__file__).parent / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no copies of processes here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of copies beside threads; none of theirs is used
def test_two_writers(tmp_path):
    found = script("two_writers").campaign(tmp_path, rounds=5, seed=3)
    assert found.faults == []
    assert found.counts["read: read"] > 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="modes of files are those of POSIX")
def test_cache(tmp_path):
    found = script("cache").campaign(tmp_path / "cache", rounds=2, starts=2, seed=3)
    assert found.faults == []
