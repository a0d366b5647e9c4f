"""Pictures without a screen: what draws them comes with the packages, what VTK draws by does not."""

from __future__ import annotations

import ctypes
import os
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from kinetruss import runs
from kinetruss.runs import RunResult
from samples import fourbar, tripod


def _draws() -> bool:
    if not sys.platform.startswith("linux"):
        return True
    for library in ("libEGL.so.1", "libOSMesa.so.8", "libOSMesa.so.6"):
        with suppress(OSError):
            ctypes.CDLL(library)
            return True
    return False


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Without EGL or OSMesa nothing can be drawn; where everything must be tested that is a failure."""
    if _draws() or os.environ.get("CI") == "true":
        return
    here = Path(__file__).parent
    for item in items:
        if here in item.path.parents:
            item.add_marker(pytest.mark.skip(reason="nothing draws without a screen (apt-get install libegl1 libgl1-mesa-dri)"))


@pytest.fixture(scope="session")
def turn() -> RunResult:
    """A plane four-bar linkage turned once."""
    return runs.run(fourbar(), "turn")


@pytest.fixture(scope="session")
def lift() -> RunResult:
    """A tripod, two load cases."""
    return runs.run(tripod(), "lift")
