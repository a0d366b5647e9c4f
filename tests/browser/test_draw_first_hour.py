"""What people who draw for the first time do: wrong clicks, missing units, several pages, long runs, fingers."""

from __future__ import annotations

from itertools import combinations

import pytest

import kinetruss as kt
from hand import Hand, drawn

pytestmark = pytest.mark.slow


def banner(hand: Hand) -> str:
    return hand.page.locator(".head .banner").first.inner_text()


def readout(hand: Hand) -> str:
    return hand.page.locator(".readout").inner_text()


def type_nodes(hand: Hand, *places: tuple[float, ...]) -> None:
    """Coordinate after coordinate, Tab between them, Enter at the end; the next node can be typed at once."""
    hand.page.get_by_label("x of the new node", exact=True).click()
    for place in places:
        for k, value in enumerate(place):
            if k:
                hand.page.keyboard.press("Tab")
            hand.page.keyboard.type(str(value))
        hand.page.keyboard.press("Enter")
        hand.settle()
        hand.shown.until("document.activeElement.getAttribute('aria-label') === 'x of the new node'")


def test_wrong_clicks_with_the_bar_tool_have_an_answer(show, served):
    hand = drawn(show, served)
    hand.write("grid step in m", "1")  # an empty drawing takes the scale of its grid
    assert 8 <= hand.js("draw.camera.scale") <= 150
    hand.write("grid step in m", "50 furlongs")
    assert "is a length" in banner(hand)
    assert hand.js("draw.camera.grid") == 1
    hand.write("grid step in m", "1000 mm")
    assert "grid 1 m" in readout(hand)
    hand.pull((0, 0, 0), (4, 0, 0))
    hand.page.mouse.move(*hand.spot((3, 3, 0)))
    assert "3, 3 m" in readout(hand)
    hand.pull((2, 0, 0), (2, 3, 0))
    notes = hand.page.locator(".words li", has_text="note").all_inner_texts()
    assert [one.split(" but")[0] for one in notes] == ["note C lies on b1"]
    hand.click("A")  # the bar tool: begins a bar, and the node's fields are at hand
    hand.button("hold A")
    assert hand.state()["fixed"] == {"A": "xy"}
    hand.click("B")  # the bar that was begun is given up in the panel: none from A to B
    hand.press("Escape")
    assert len(hand.state()["members"]) == 2
    hand.pull("A", "B")
    assert banner(hand).startswith("b1 joins A and B already.")
    assert hand.js("[...draw.picked.members]") == ["b1"]
    assert len(hand.state()["members"]) == 2
    hand.choose("section of b1", "own")
    hand.write("outer diameter, section of b1", "60")
    hand.page.get_by_label("set section of b1", exact=True).click()
    assert "60 mm" in banner(hand)
    assert "section" not in hand.js("JSON.stringify(state.data.bars)")
    hand.page.locator("h1").click()
    hand.press("Escape")  # wherever the focus is
    assert hand.js("draw.picked.nodes.size + draw.picked.members.size") == 0
    hand.page.get_by_label("file name", exact=True).fill("bridge")
    hand.button("Save")
    assert kt.read(served.folder / "bridge.yaml").bars["b1"].ends == ("A", "B")
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_nodes_are_typed_in_space_and_all_are_in_sight(show, served):
    hand = drawn(show, served)
    hand.button("Draw in space")
    type_nodes(hand, (0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 5), (3, 0, 5), (0, 3, 5))
    assert len(hand.state()["nodes"]) == 6
    assert hand.js("draw.canvas.seen.every(([x, y]) => x > 0 && y > 0 && x < draw.camera.width && y < draw.camera.height)")
    box = hand.page.locator("svg.drawing").bounding_box()
    hand.page.mouse.move(box["x"] + 20, box["y"] + 300)
    hand.page.mouse.wheel(0, -3000)
    assert "out of sight" in readout(hand)
    hand.page.get_by_role("button", name="Show all").first.click()
    assert "out of sight" not in readout(hand)
    assert "nothing holds the drawing" in hand.state()["why"]
    assert [one for one in hand.state()["warnings"] if one["kind"] == "mechanism"] == []  # that it floats is said once


def test_what_is_typed_stays_while_another_page_draws(show, served):
    hand, other = drawn(show, served), drawn(show, served)
    hand.write("title", "first")
    field = hand.page.get_by_label("title", exact=True)
    field.click()
    hand.page.keyboard.press("End")
    hand.page.keyboard.type(" of al")
    other.press("n")
    other.click((0, 0, 0))
    hand.shown.until("kinetruss.draw.state.nodes.length === 1")
    assert field.input_value() == "first of al"
    hand.page.keyboard.type("l")
    hand.page.keyboard.press("Enter")
    assert hand.state()["data"]["title"] == "first of all"
    field.click()
    hand.page.keyboard.type("!")
    other.click((0.2, 0, 0))
    hand.shown.until("kinetruss.draw.state.nodes.length === 2")
    hand.page.locator("h1").click()  # typed before the panel was made anew: it is taken when the field is left
    assert hand.state()["data"]["title"] == "first of all!"


def test_a_long_run_shows_its_progress_and_is_stopped_while_one_draws(show, served):
    hand = drawn(show, served)
    for way in (((0, 0, 0), (0.2, 0.3, 0)), ("B", (0.4, 0, 0))):
        hand.pull(*way)
    for name in ("A", "C"):
        hand.held(name)
    hand.choose("pick a member", "b2")
    hand.choose("kind of b2", "driven")
    hand.choose("pick a member", "b1")
    hand.choose("kind of b1", "driven")
    hand.button("New run")
    hand.write("runs.run1.samples", "900000")
    hand.page.get_by_label("do run run1").click()
    bar = hand.page.get_by_label("progress of run1")
    hand.shown.until("kinetruss.draw.entries.doing?.done > 0")
    assert float(bar.get_attribute("max")) == 900_000
    hand.choose("pick a node", "B")
    hand.write("x of B", "0.22")  # drawing goes on
    assert hand.state()["places"][1][0] == 0.22
    hand.page.reload()
    hand.page.wait_for_selector("#kinetruss[data-state]")
    hand.settle()
    hand.page.get_by_label("stop run run1").click()
    hand.shown.until("!kinetruss.draw.entries.doing")
    assert banner(hand) == "The run run1 was stopped."
    assert bar.count() == 0
    hand.write("runs.run1.samples", "11")
    hand.page.get_by_label("do run run1").click()
    hand.shown.until("kinetruss.draw.entries.ran.run1")
    assert "11 of 11 samples." in hand.page.locator(".about").first.inner_text()
    assert hand.page.get_by_text("The drawing has changed since.").count() == 0
    hand.choose("pick a node", "B")
    hand.write("x of B", "0.23")
    assert hand.page.get_by_text("The drawing has changed since.").count() == 1
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_names_keep_apart_and_fingers_pick_several_on_a_phone(show, served):
    hand = drawn(show, served, width=390, height=800, has_touch=True)
    hand.button("Draw in space")
    hand.page.locator("summary", has_text="Copy, mirror, stack").click()
    hand.write("number of cells", "2")
    hand.button("Stack")
    boxes = hand.page.evaluate(
        "() => [...document.querySelectorAll('.drawing .names text')].filter((one) => one.getAttribute('display') !== 'none')"
        ".map((one) => one.getBBox()).map(({ x, y, width, height }) => [x, y + 2, x + width, y + height - 2])"
    )
    assert len(boxes) > 8
    for a, b in combinations(boxes, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1], (a, b)
    hand.button("Pick several: as with Shift held")
    for name in hand.state()["nodes"][:3]:
        hand.page.touchscreen.tap(*hand.spot(name))
        hand.settle()
    assert hand.js("[...draw.picked.nodes]") == hand.state()["nodes"][:3]
    assert hand.page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_the_sliders_of_an_empty_drawing_lead_back_to_it(show, served):
    shown = show(served.address.removesuffix("draw/"))
    assert "it needs nodes and bars" in shown.page.locator(".failure").inner_text()
    back = shown.page.get_by_role("link", name="Go to the drawing")
    assert back.evaluate("(link) => link.href") == served.address
