"""A lit picture of every run of every shipped example, from its folder on disk."""

import pytest
from PIL import Image

from kinetruss import runs, viewer
from shipped import RUNS, stored

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(("name", "run"), RUNS, ids=lambda one: one)
def test_render(name, run, tmp_path):
    found = runs.load(stored(name, run))
    at = float(found.motion.time[-1])
    path = viewer.render(found, tmp_path / "end.png", at=at, size=(320, 240), ghost=True)
    with Image.open(path) as picture:
        assert picture.size == (320, 240)
        assert len(picture.getcolors(320 * 240)) > 20  # something is drawn
