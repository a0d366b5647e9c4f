"""Pictures without a screen: Chromium draws them, which does not come with the packages."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from kinetruss.display.browser import chromium


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Without Chromium nothing can be drawn; where everything must be tested that is a failure."""
    if chromium() or os.environ.get("CI") == "true":
        return
    here = Path(__file__).parent
    for item in items:
        if here in item.path.parents:
            item.add_marker(pytest.mark.skip(reason="no chromium on this machine (apt-get install chromium)"))
