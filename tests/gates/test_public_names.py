"""What the package shows to users: no room of the house, and nothing that the pages do not need."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import kinetruss as kt

ROOT = Path(__file__).parents[2]
INNER = ("kernels", "mechanics")
PAGES = [*ROOT.glob("docs/*.md"), ROOT / "README.md", *ROOT.glob("examples/**/*.py"), *ROOT.glob("examples/**/*.md")]


@pytest.mark.parametrize("name", INNER)
def test_the_rooms_of_the_house_are_no_public_names(name):
    assert name not in kt.__all__
    assert name not in dir(kt)


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_pages_and_examples_use_public_names(path):
    text = path.read_text(encoding="utf-8")
    assert not re.search(rf"(import|from) +kinetruss\.({'|'.join(INNER)})|\bkt\.({'|'.join(INNER)})\b", text)
    for name in re.findall(r"\bkt\.([A-Za-z_]\w*)", text):
        assert name in kt.__all__, f"kt.{name}"


def test_every_public_name_is_there():
    for name in kt.__all__:
        assert getattr(kt, name) is not None


@pytest.mark.parametrize("path", sorted((ROOT / "src").rglob("__init__.py")), ids=lambda path: path.parent.as_posix())
def test_no_exported_name_is_that_of_a_file_beside_it(path):
    """Python binds an imported module to its name in the package, so that the name would give the module."""
    package = ".".join(path.parent.relative_to(ROOT / "src").parts)
    imports = [one for one in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(one, ast.ImportFrom)]
    exported = {name.asname for one in imports if one.module != package for name in one.names}
    assert not exported & {one.stem for one in path.parent.glob("*.py")}
