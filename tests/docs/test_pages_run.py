"""The Python of every page of the site runs as printed, its blocks one after the other. Tutorials: test_site.py."""

import re
from pathlib import Path

import pytest

import kinetruss as kt

pytestmark = pytest.mark.slow

DOCS = Path(__file__).parents[2] / "docs"
BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
PAGES = {
    str(page.relative_to(DOCS)): blocks
    for page in sorted(DOCS.rglob("*.md"))
    if "made" not in page.parts and (blocks := BLOCK.findall(page.read_text(encoding="utf-8")))
}


@pytest.fixture
def leg(tmp_path, monkeypatch):
    """A model file and a run, of the names that pages use."""
    monkeypatch.chdir(tmp_path)
    runs = {"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": "1 rev/s"}, duration=1.0), samples=11)}
    model = kt.library.mechanisms.four_bar().with_(runs=runs)
    kt.write(model, "slew.yaml")
    kt.run(model, "turn", out="runs/demo")


def test_pages_have_python():
    assert len(PAGES) > 20


@pytest.mark.parametrize("page", PAGES)
def test_the_python_of_a_page_runs(leg, page):
    if page == "notebook.md":
        pytest.importorskip("anywidget")
    names: dict[str, object] = {}
    for code in PAGES[page]:
        exec(compile(code, page, "exec"), names)
