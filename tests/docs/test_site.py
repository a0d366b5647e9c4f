"""What the site shows is so: the model reference is of the schema, and its Python is its YAML. `make docs` runs tutorials."""

import ast
import inspect
import re
import sys
from pathlib import Path

import pytest

import kinetruss as kt
from kinetruss.model import Model

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "docs" / "site"))

import api  # noqa: E402
import gallery  # noqa: E402
import made  # noqa: E402
import tables  # noqa: E402

pytestmark = pytest.mark.slow


def test_every_table_has_a_description():
    assert [name for name, field in Model.model_fields.items() if not field.description] == []


def test_every_table_has_an_example_in_the_reference():
    shown = {name for entry in tables.SOURCE["tables"].values() for name in re.findall(r"^(\w+):", entry["yaml"], re.MULTILINE)}
    assert set(Model.model_fields) - shown == {"kinetruss", "title", "joints", "gauge_zero"}


def test_every_field_of_the_reference_has_a_meaning_and_a_type_in_words(tmp_path):
    ((_, page),) = tables.pages(tmp_path)
    rows = [re.split(r" (?<!\\)\| ", line.strip("| ")) for line in page.splitlines() if line.startswith("| `")]
    assert len(rows) > 250
    assert "| `kind` | `rigid`, `driven`, `elastic`, `cable`, `free` | `'rigid'` | ``rigid`` keeps its length" in page
    for row in rows:
        assert len(row) == 4, row
        assert row[3].strip(), row
        assert not re.search(r"tuple|Table|Filled|OrName|\b_|>>>", row[1] + row[3]), row


@pytest.mark.parametrize("table", tables.SOURCE["tables"])
def test_the_python_of_the_reference_is_its_yaml(table, tmp_path):
    model = tables.model_of(table, tmp_path)
    shown = "\n".join(tables._beside(table, tables.SOURCE["tables"][table], tmp_path))
    code = re.search(r"```python\n(.*?)```", shown, re.DOTALL)[1]
    entries = [line for line in re.split(r"\n(?=\w)", code.strip()) if line]
    again = {key: eval(value, {"kt": kt}) for key, _, value in (line.partition("=") for line in entries)}
    for key, value in again.items():
        held = getattr(model, key)
        if isinstance(value, dict):
            assert {name: held[name] for name in value} == value
        else:
            assert held == value


def test_the_reference_lists_all_public_names(tmp_path):
    written = dict(api.pages(tmp_path))
    for package in api.PACKAGES:
        if package not in kt.__all__:
            continue
        page = written[f"api/{package}.md"]
        for name in getattr(kt, package).__all__:
            one = getattr(getattr(kt, package), name)
            if inspect.isfunction(one) or inspect.isclass(one):
                assert f"\n### {name}\n" in page, name


def test_headings_of_docstrings_are_bold():
    text = "\n".join(api.text_of(inspect.getdoc(kt.kinematics.assemble)))
    for heading in ("Parameters", "Returns", "Raises", "Notes"):
        assert f"\n\n**{heading}**\n\n" in text
    for _, page in api.pages(Path()):
        assert r"\*\*" not in page


def test_examples_of_the_reference_are_code():
    for _, page in api.pages(Path()):
        for block in re.findall(r"```pycon\n(.*?)```", page, re.DOTALL):
            lines = [line[4:] for line in block.splitlines() if line.startswith((">>> ", "... "))]
            ast.parse("\n".join(lines))


def test_every_example_is_in_one_group_of_the_gallery():
    shown = [name for names in gallery.GROUPS.values() for name in names]
    assert sorted(shown) == sorted(kt.library.example_files())


def test_the_reference_of_the_model_begins_with_the_model():
    page = dict(api.pages(Path()))["api/model.md"]
    assert re.findall(r"^### (\w+)$", page, re.MULTILINE)[:3] == ["Model", "Node", "Bar"]


@pytest.mark.parametrize("file", ["src/kinetruss/viewer/bundle.js", "src/kinetruss/library/delta.yaml", "docs/site/gallery.py"])
def test_the_site_is_computed_again_when_what_it_is_made_from_changes(file, tmp_path):
    path = tmp_path / file
    for one in (path, tmp_path / "requirements.lock"):
        one.parent.mkdir(parents=True, exist_ok=True)
        one.write_text("one")
    before = made.key(tmp_path)
    cached = path.parent / "__pycache__" / "kernel.nbi"
    cached.parent.mkdir()
    cached.write_text("compiled")
    assert made.key(tmp_path) == before
    path.write_text("two")
    assert made.key(tmp_path) != before
