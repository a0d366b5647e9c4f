"""Every package can be the first one that is imported: no circle of imports shows by another order only."""

from __future__ import annotations

import subprocess
import sys

import pytest

CODE = """
import importlib.util, sys
import kinetruss
listed = [name for name in kinetruss.__all__ if importlib.util.find_spec(f"kinetruss.{name}")]
packages = [name for name in listed if name not in ("notebook", "studio")]
for first in packages:
    for name in [name for name in sys.modules if name.startswith("kinetruss") and ".kernels" not in name]:
        del sys.modules[name]
    importlib.import_module(f"kinetruss.{first}")
print(len(packages))
"""


@pytest.mark.slow
def test_every_package_can_be_imported_first():
    done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 15
