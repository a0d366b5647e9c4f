"""In a real browser: a drawing to begin with, a linkage that is asked for by mouse and by keys, a file that is taken away."""

from __future__ import annotations

import math

import pytest

import kinetruss as kt
from hand import drawn

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(("width", "scheme"), [(1300, "light"), (390, "dark")])
def test_an_empty_drawing_begins_with_pictures(show, served, width, scheme):
    hand = drawn(show, served, width=width, scheme=scheme)
    strip = hand.page.locator(".starters")
    assert strip.is_visible()
    assert strip.locator("svg.thumb").count() == strip.locator("button.card").count() >= 20
    assert hand.js("document.documentElement.scrollWidth") <= width
    strip.locator("button.card", has_text="Slider-crank").click()
    hand.settle()
    assert hand.state()["nodes"] == ["O", "P", "S"]
    assert not strip.is_visible()
    hand.press("Control+z")
    assert strip.is_visible()
    hand.page.get_by_role("button", name="hide the drawings to begin with").click()
    assert not strip.is_visible()


def test_three_positions_by_mouse_give_a_linkage_that_passes(show, served):
    hand = drawn(show, served)
    hand.press("q")
    for (x, y), (u, v) in (((-0.3, 0), (-0.1, 0)), ((0, 0.1), (0.2, 0.15)), ((0.2, 0.2), (0.35, 0.35))):
        hand.pull((x, y, 0), (u, v, 0))
    assert hand.js("draw.task.positions.length") == 3
    hand.button("Find linkages")
    cards = hand.page.get_by_role("button", name="put linkage")
    assert cards.count() > 8
    cards.first.click()
    state = hand.state()
    assert state["made"]["member"] == "crank"
    model = kt.Model(**{key: value for key, value in state["data"].items() if key != "kinetruss"})
    end = kt.kinematics.follow(model, model.runs["through"].trajectory, samples=31).position.isel(time=-1)
    assert end.sel(node="P").values.tolist() == pytest.approx([0.2, 0.2], abs=1e-9)
    P, Q = end.sel(node="P").values, end.sel(node="Q").values
    assert math.atan2(*(Q - P)[::-1]) == pytest.approx(math.pi / 4, abs=1e-9)
    hand.page.get_by_role("button", name="put linkage 2:").click()
    hand.settle()
    assert len(hand.state()["data"]["bars"]) <= 2  # in its place


def test_positions_and_paths_are_typed_too(show, served):
    hand = drawn(show, served)
    hand.page.get_by_text("Ask for a linkage", exact=True).click()
    for k in (1, 2, 3):
        hand.button("Type a position")
        hand.write(f"x of position {k}", f"{100 * k} mm")
        hand.write(f"angle of position {k}", f"{20 * k}")
    assert hand.js("draw.task.positions.map((row) => row[0])") == pytest.approx([0.1, 0.2, 0.3])
    assert hand.js("draw.task.positions.map((row) => row[2])") == pytest.approx([math.radians(20 * k) for k in (1, 2, 3)])
    hand.write("x of position 1", "wide")
    assert "length" in hand.page.locator(".banner").first.inner_text()
    hand.page.get_by_role("button", name="clear the task").click()
    area = hand.page.get_by_label("points of the path")
    area.fill("0, 0\n0.1, 0.02\n0.2, 0\n0.3, nothing")
    area.blur()
    assert "Line 4" in hand.page.locator(".banner").first.inner_text()
    area.fill("0, 0\n0.1, 0.02\n0.2, 0.02\n0.3, 0")
    area.blur()
    assert hand.js("draw.task.path.length") == 4


def test_a_path_by_mouse_is_closed_where_it_meets_its_start(show, served):
    hand = drawn(show, served)
    hand.press("w")
    ring = [(0.3 * math.cos(k * math.pi / 8), 0.15 * math.sin(k * math.pi / 8), 0) for k in range(17)]
    hand.pull(*ring)
    assert hand.js("draw.task.closed")
    points = hand.js("draw.task.path")
    assert len(points) == 24
    assert all((x / 0.3) ** 2 + (y / 0.15) ** 2 == pytest.approx(1, abs=0.12) for x, y in points)
    hand.press("Escape")
    hand.pull(*ring[:8])
    assert not hand.js("draw.task.closed")


def test_the_model_is_taken_as_a_file(show, served, tmp_path):
    hand = drawn(show, served)
    hand.page.locator(".starters button.card", has_text="Truss bridge").click()
    hand.settle()
    hand.page.unroute_all()
    with hand.page.expect_download() as coming:
        hand.page.get_by_role("button", name="take YAML").click()
    coming.value.save_as(tmp_path / "bridge.yaml")
    assert coming.value.suggested_filename == "Truss_bridge.yaml"
    assert len(kt.read(tmp_path / "bridge.yaml").bars) == 21
