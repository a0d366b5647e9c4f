"""The page of every shipped example, from its folder on disk: it opens, plays to its end, and shows no word for a number."""

import pytest

from kinetruss import runs, viewer
from shipped import RUNS, named, stored

pytestmark = pytest.mark.slow

FIRST = list({name: (name, run) for name, run in reversed(RUNS)}.values())[::-1]


@pytest.mark.parametrize(("name", "run"), FIRST, ids=lambda one: one)
def test_view(show, tmp_path, name, run):
    found = runs.load(stored(name, run))
    shown = show(viewer.write(found, tmp_path / "view.html"))
    assert shown.js("window.kinetruss.ready"), shown.page.inner_text("body")
    end = found.good - 1
    for channel in ["", *shown.js("scene.header.channels.map((one) => one.id)")]:
        shown.js(f"(app.setChannel({channel!r}), app.goTo({end}))")
        assert named(shown.page.inner_text("body")) == ""
    for kind in ("member", "node"):
        if shown.js(f"scene.{kind}s.length"):
            shown.js(f"app.pick({{type: '{kind}', name: scene.{kind}s[0]}})")
            assert named(shown.page.inner_text("body")) == ""
    assert shown.complaints == []
    assert shown.requests == []
