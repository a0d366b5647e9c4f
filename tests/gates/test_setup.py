"""Setting up on a machine that lacks something: said in words, with the mend."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    for name in ("Makefile", "pyproject.toml", "requirements.lock", "requirements-demo.lock"):
        shutil.copy(ROOT / name, tmp_path)
    return tmp_path


def make(folder: Path, lacking: str) -> subprocess.CompletedProcess[str]:
    """``make setup`` with a Python that fails when it is asked for what is lacking."""
    python = folder / "python3"
    python.write_text(f'#!/bin/sh\ncase "$*" in *{lacking}*) exit 1;; *) exec {sys.executable} "$@";; esac\n')
    python.chmod(0o755)
    command = ["make", "setup", f"PYTHON={python}"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def test_a_python_without_ensurepip_names_the_package(copy):
    done = make(copy, "ensurepip")
    assert done.returncode != 0
    assert "apt-get install python3-venv" in done.stderr
    assert not (copy / ".venv").exists()


def test_an_old_python_is_named_with_the_way_to_another(copy):
    done = make(copy, "version_info")
    assert done.returncode != 0
    assert "needs Python 3.11 or newer" in done.stderr
    assert "make PYTHON=" in done.stderr
    assert not (copy / ".venv").exists()


@pytest.mark.parametrize("lock", ["requirements.lock", "requirements-demo.lock"])
def test_a_lock_pins_everything_by_hash_and_names_no_registry(lock):
    text = (ROOT / lock).read_text()
    assert not re.search(r"https?://", text)
    pins = re.findall(r"^[a-z0-9].*", text, re.MULTILINE)
    assert len(pins) > 40
    for entry in re.split(r"\n(?=[a-z0-9])", text):
        assert re.match(r"[\w.-]+==[\w.]+", entry), entry
        assert "--hash=sha256:" in entry, entry


def test_the_lock_covers_what_the_project_needs():
    pins = {name.lower() for name in re.findall(r"^([\w.-]+)==", (ROOT / "requirements.lock").read_text(), re.MULTILINE)}
    project = re.sub(r"(?m)^peers = .*$", "", (ROOT / "pyproject.toml").read_text())  # other codes, for one benchmark only
    needed = re.findall(r'"([A-Za-z][\w-]*)>=|"(types-PyYAML)"', project)
    assert {(a or b).lower() for a, b in needed} <= pins


def test_the_demo_installs_what_tests_install_and_no_browser():
    everything, demo = ((ROOT / lock).read_text() for lock in ("requirements.lock", "requirements-demo.lock"))
    assert set(re.findall(r"^[a-z0-9].*==[^ ;]*", demo, re.MULTILINE)) <= set(
        re.findall(r"^[a-z0-9].*==[^ ;]*", everything, re.MULTILINE)
    )
    assert not re.search(r"^(vtk|pyvista|playwright|pyarrow|mujoco)==", demo, re.MULTILINE)
