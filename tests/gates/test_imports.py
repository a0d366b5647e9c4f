"""Every package can be the first one that is imported, and what tests and benches import from the library is there."""

from __future__ import annotations

import ast
import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

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


@pytest.mark.parametrize("folder", ["tests", "bench", "docs", ".ci"])
def test_what_is_imported_from_the_library_is_there(folder):
    """Also in a campaign or a benchmark that only a slow run starts."""
    missing = set()
    for path in sorted((ROOT / folder).rglob("*.py")):
        imports = [one for one in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(one, ast.ImportFrom)]
        for one in imports:
            if one.module is None or one.module.partition(".")[0] != "kinetruss":
                continue
            module = importlib.import_module(one.module)
            for name in one.names:
                if not hasattr(module, name.name) and importlib.util.find_spec(f"{one.module}.{name.name}") is None:
                    missing.add(f"{path.relative_to(ROOT)}: {one.module}.{name.name}")
    assert not missing
