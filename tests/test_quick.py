"""Every package and every folder of tests belongs to a part, and a change is told by its parts."""

import subprocess
import sys
from pathlib import Path

import pytest

import quick

TESTS = Path(__file__).parent
NONE = {"data", "reference"}
"""Folders without tests of their own."""


def folders(place):
    return {one.name for one in place.iterdir() if one.is_dir() and one.name != "__pycache__"}


def test_every_package_and_every_folder_of_tests_has_a_part():
    assert folders(quick.ROOT / "src/kinetruss") == quick.PARTS.keys() - {"package", "project"}
    assert {one for part in quick.PARTS.values() for one in part} == folders(TESTS) - NONE


@pytest.mark.parametrize(
    "files, parts",
    [
        (["src/kinetruss/statics/linear_statics.py", "docs/index.md"], ["statics"]),
        (["src/kinetruss/units.py", "tests/rows/test_hinges.py"], ["kernels", "package"]),
        (["tests/runs/test_run.py"], ["results", "runs"]),
        (["README.md", "tests/hand.py", "tests/data/robot.urdf"], []),
    ],
)
def test_files_belong_to_parts(files, parts):
    assert quick.touched(files) == parts


def test_changes_are_those_not_committed_or_the_last_commit(tmp_path):
    def git(*words):
        subprocess.run(
            ["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=tmp_path, check=True, capture_output=True
        )

    git("init")
    for name in ("first", "second"):
        (tmp_path / name).write_text(name)
        git("add", name)
        git("commit", "-m", name)
        assert quick.changed(tmp_path) == [name]
    (tmp_path / "third").write_text("new")
    (tmp_path / "first").write_text("changed")
    assert quick.changed(tmp_path) == ["third", "first"]


def test_an_unknown_part_is_told_with_those_that_are_known():
    ended = subprocess.run([sys.executable, TESTS / "quick.py", "statix"], capture_output=True, text=True)
    assert ended.returncode == 2
    assert "No part 'statix'" in ended.stderr and "statics" in ended.stderr
