"""Permissions that bind: root may write anywhere, so a child of root gives up that right first."""

import os
import shutil

import pytest

__all__ = ["bound"]


def bound() -> list[str]:
    """What a command begins with so that modes of files and folders hold for it; skips the test where that cannot be had."""
    if not hasattr(os, "geteuid"):
        pytest.skip("the test needs POSIX modes of files, which this system lacks")
    if os.geteuid() != 0:
        return []
    if shutil.which("setpriv") is None:
        pytest.skip("modes of files do not bind root, and there is no setpriv to give that up")
    return ["setpriv", "--bounding-set=-all", "--inh-caps=-all", "--"]
