"""The counts of the source are right on a small tree of known figures."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "house.py"
KERNELS = """P, Q, R = range(3)
S, LIMIT = 3, 4
OTHER = 5


@kernel_bare
def read(x, y):
    for i in range(LIMIT):
        x[i] = x[P] + y.z[k.Q, S + 1]


def told(x):
    return x[R] + x[OTHER]
"""


def test_counts_of_a_known_tree(tmp_path):
    source = tmp_path / "src" / "kinetruss"
    (source / "one").mkdir(parents=True)
    (source / "kernels").mkdir()
    (source / "one" / "_a.py").write_text("from kinetruss.one._b import f\n\n\ndef g(a, b, c):\n    return f(a)\n")
    (source / "one" / "_b.py").write_text(
        "from kinetruss.one import _a\nfrom kinetruss.kernels._k import P\n\n\ndef f(a):\n    return _a\n"
    )
    (source / "one" / "_c.py").write_text("from kinetruss.two._d import h\nfrom kinetruss.two.face import d, e\n")
    (source / "one" / "_d.py").write_text("from kinetruss.two.face import d\n")
    (source / "two" / "face").mkdir(parents=True)
    (source / "two" / "face" / "__init__.py").write_text('__all__ = ["d"]\n')
    (source / "kernels" / "_k.py").write_text(KERNELS)
    (source / "__init__.py").write_text('_PACKAGES = "one two "\n_NAMES = {"two": "d"}\n')
    (source / "one" / "__init__.py").write_text('__all__ = ["a", "b"]  # noqa: X\n# why\n')
    (source / "two" / "__init__.py").write_text('__all__ = ["b", "d"]\n')
    found = json.loads(
        subprocess.run([sys.executable, SCRIPT, "--json", "--root", tmp_path], check=True, capture_output=True).stdout
    )
    assert (found["files"], found["lines"]) == (9, 20 + KERNELS.count("\n"))
    assert found["files in the largest folder"] == "4 in one"
    assert (found["import circles"], found["files in import circles"]) == (1, 2)
    assert found["most arguments outside builders"] == "3 in one/_a.py:g"
    assert found["places numbered by integers"] == 3
    assert found["inner modules imported across packages"] == 2
    assert found["private imports across packages"] == 1
    assert found["exported names"] == 5  # one.a, one.b, two.b, two.d, which the top has too, and the version
    assert found["comments per 100 lines"] == round(100 / found["lines"], 2)
    assert (found["comments per 100 lines of kernels"], found["pragmas"]) == (0, 1)


def test_imports_for_types_in_functions_and_of_packages_close_circles(tmp_path):
    source = tmp_path / "src" / "kinetruss"
    (source / "one").mkdir(parents=True)
    (source / "kernels").mkdir()
    (source / "kernels" / "k.py").write_text("K = 1\n")
    (source / "__init__.py").write_text('_PACKAGES = "one"\n_NAMES = {}\n')
    (source / "one" / "__init__.py").write_text("if TYPE_CHECKING:\n    from kinetruss.one.a import f\n")
    (source / "one" / "a.py").write_text("def f():\n    from kinetruss.b import g\n\n    return g\n")
    (source / "b.py").write_text("from kinetruss.one import f\n\n\ndef g():\n    return f\n")
    (source / "c.py").write_text("from kinetruss import b\n")
    found = json.loads(
        subprocess.run([sys.executable, SCRIPT, "--json", "--root", tmp_path], check=True, capture_output=True).stdout
    )
    assert (found["import circles"], found["files in import circles"]) == (1, 3)


def test_no_module_imports_itself_by_way_of_others():
    found = json.loads(subprocess.run([sys.executable, SCRIPT, "--json"], check=True, capture_output=True).stdout)
    assert found["import circles"] == 0


def test_packages_are_imported_by_the_names_that_they_declare():
    found = json.loads(subprocess.run([sys.executable, SCRIPT, "--json"], check=True, capture_output=True).stdout)
    assert found["inner modules imported across packages"] == 0


def test_kernels_read_fields_by_name():
    found = json.loads(subprocess.run([sys.executable, SCRIPT, "--json"], check=True, capture_output=True).stdout)
    assert found["places numbered by integers"] == 0
