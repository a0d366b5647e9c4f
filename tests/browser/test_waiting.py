"""Answers that take long: what the pages show meanwhile; and what of the panel is in sight."""

from __future__ import annotations

import numpy as np
import pytest

from hand import Hand, drawn
from kinetruss import viewer
from samples import fourbar
from served import serve

pytestmark = pytest.mark.slow

HOLD = """
const Real = window.WebSocket;
window.held = [];
window.holding = false;
window.letGo = () => {
  window.holding = false;
  for (const act of window.held.splice(0)) act();
};
window.WebSocket = class extends Real {
  addEventListener(type, act) {
    const late = (event) => (window.holding ? window.held.push(() => act(event)) : act(event));
    super.addEventListener(type, type === "message" ? late : act);
  }
};
"""
"""Answers of the studio are held back from `holding = true` on, until `letGo()`."""
LATE = 300
"""ms after an edit at which the page must say that it is computed."""


def four_bar(hand: Hand) -> None:
    """A held four-bar without a drive; its first bar is picked."""
    hand.write("grid step in m", "0.1")
    hand.pull((0, 0, 0), (0, 0.1, 0))
    hand.pull("B", (0.3, 0.3, 0))
    hand.pull("C", (0.4, 0, 0))
    hand.held("A")
    hand.held("D")
    hand.choose("pick a node", "C")
    hand.write("force on C along y", "-100 N")
    hand.choose("pick a member", "b1")


def hold(hand: Hand) -> None:
    hand.page.clock.install()
    hand.page.evaluate("window.holding = true")


def test_an_edit_that_takes_long_is_said_to_be_computed_and_the_state_before_is_not_shown(show, served):
    hand = drawn(show, served, script=HOLD)
    four_bar(hand)
    words, doing = hand.page.locator(".verdicts .words"), hand.page.locator(".sheetpane .busy")
    assert "1 mechanism is left" in words.inner_text()
    assert not doing.is_visible()
    hold(hand)
    hand.page.get_by_label("driven angle of b1", exact=True).select_option("on")
    hand.page.clock.run_for(LATE)
    assert doing.inner_text() == hand.page.locator(".verdicts .busy").inner_text() == "Computing ..."
    assert words.locator("p").is_hidden()
    assert words.inner_text() == ""
    hand.page.evaluate(
        "kinetruss.draw.hear(JSON.stringify({ kind: 'busy', text: 'Compiling (first start only): 3 kernels, 12 s' }))"
    )
    assert doing.inner_text() == "Compiling (first start only): 3 kernels, 12 s"
    hand.page.evaluate("window.letGo()")
    hand.settle()
    assert not doing.is_visible()
    assert words.locator("p").inner_text().strip() == "Stable, with one drive."
    assert "holding torque" in hand.page.locator(".state").inner_text()
    # forces of before are not those of another load
    tags = hand.page.locator(".drawing .tag", has_text="N")
    assert tags.count() == 3
    hand.page.evaluate("window.holding = true")
    hand.press_at_once("Control+z")
    hand.page.clock.run_for(LATE)
    assert doing.is_visible()
    assert tags.count() == 0
    assert hand.page.locator(".state table").first.is_hidden()
    hand.page.evaluate("window.letGo()")
    hand.settle()
    assert "1 mechanism is left" in words.inner_text()
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_what_is_quick_does_not_flicker(show, served):
    hand = drawn(show, served, script=HOLD)
    four_bar(hand)
    hold(hand)
    hand.page.clock.pause_at(
        hand.js("Date.now() / 1000 + 60")
    )  # from here on no time passes for the page but what is given to it
    hand.page.get_by_label("driven angle of b1", exact=True).select_option("on")
    busy, words = hand.page.locator(".busy:visible"), hand.page.locator(".verdicts .words")
    hand.page.clock.run_for(100)
    assert busy.count() == 0
    assert "1 mechanism is left" in words.inner_text()
    hand.page.clock.run_for(LATE - 100)
    assert busy.count() > 0


def test_a_run_is_said_to_be_computed_at_once_and_its_last_result_goes(show, served):
    hand = drawn(show, served, script=HOLD)
    four_bar(hand)
    hand.choose("driven angle of b1", "on")
    hand.button("New run")
    hand.page.get_by_label("do run run1").click()
    hand.shown.until("kinetruss.draw.entries.ran.run1")
    assert "101 of 101 samples." in hand.page.locator(".about").first.inner_text()
    hold(hand)
    hand.page.get_by_label("do run run1").click()
    row = hand.page.locator(".doing")
    assert row.locator("span").inner_text() == "Computing run1 ..."
    assert hand.page.get_by_text("101 of 101 samples.").count() == 0
    running = {"kind": "running", "name": "run1", "done": 0, "total": 101, "what": "samples", "note": "Compiling"}
    hand.js("draw.entries.hear(given)", running)
    assert row.locator("span").inner_text() == "Computing run1: 0 of 101 samples. Compiling"


def test_the_live_page_says_what_it_computes(show, tmp_path):
    served = serve(fourbar(), tmp_path)
    try:
        shown = show(served.address, script=HOLD)
        shown.until("kinetruss.ready")
        shown.page.clock.install()
        shown.page.evaluate("window.holding = true")
        shown.js("kinetruss.live.move({ motor: 1.5 })")
        shown.page.clock.run_for(LATE)
        assert shown.page.locator(".stage .busy").inner_text() == "Computing ..."
        shown.page.evaluate("window.letGo()")
        shown.until("!kinetruss.live.waiting")
        assert not shown.page.locator(".stage .busy").is_visible()
        assert (shown.requests, shown.complaints) == ([], [])
    finally:
        served.process.kill()
        served.process.communicate()


FLAT = "[view.camera.position.clone().sub(view.controls.target).normalize().toArray(), view.controls.target.toArray()]"


def swept(shown, **button) -> tuple[np.ndarray, np.ndarray]:
    """Direction of the eye and the place looked at after a drag over the picture."""
    box = shown.page.locator(".pane canvas").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + 0.8 * box["height"]
    shown.page.mouse.move(x, y)
    shown.page.mouse.down(**button)
    shown.page.mouse.move(x + 60, y - 40, steps=5)
    shown.page.mouse.up(**button)
    shown.drawn()
    return tuple(np.array(one) for one in shown.js(FLAT))


@pytest.mark.parametrize("live", [True, False])
def test_a_planar_structure_stays_flat_and_a_drag_shifts_it(show, tmp_path, live):
    served = serve(fourbar(), tmp_path) if live else None
    try:
        shown = show(served.address if served else viewer.write(fourbar(), tmp_path / "flat.html"))
        shown.until("kinetruss.ready")
        at = np.array(shown.js(FLAT)[1])
        for button in ({}, {"button": "right"}):
            eye, now = swept(shown, **button)
            np.testing.assert_allclose(eye, [0, 0, 1], atol=1e-12)
            assert np.hypot(*(now - at)[:2]) > 0.01 * shown.js("scene.extent.size")
            at = now
        shown.js("app.orbit(0.3, 0.3, 1)")
        np.testing.assert_allclose(shown.js(FLAT)[0], [0, 0, 1], atol=1e-12)
        shown.js("app.toggleHelp()")
        words = shown.page.get_by_role("dialog").inner_text()
        assert "Drag to shift" in words
        assert "turn up" not in words
    finally:
        if served:
            served.process.kill()
            served.process.communicate()


def test_the_state_of_the_drawing_covers_no_row_of_the_panel(show, served):
    hand = drawn(show, served, height=620)
    four_bar(hand)
    hand.choose("driven angle of b1", "on")
    hand.button("New run")
    parts, head = hand.page.locator(".parts"), hand.page.locator(".sketch .head").bounding_box()
    assert parts.bounding_box()["y"] >= head["y"] + head["height"]
    for down in (0, 12, 25):
        parts.evaluate("(part, down) => (part.scrollTop = down)", down)
        seen = parts.evaluate("""(part) => [...part.querySelectorAll(".state .numbers")].map((table) => {
            const row = table.rows[0].cells[0].getBoundingClientRect();
            if (row.top < part.getBoundingClientRect().top - 1) return "";
            return document.elementFromPoint(row.left + 5, row.top + row.height / 2).textContent;
        })""")
        assert seen == ["drive", "reaction"]


def test_on_a_phone_every_tool_is_in_sight(show, served, tmp_path):
    hand = drawn(show, served, width=390, height=800, has_touch=True)
    out = """[...document.querySelectorAll(".toolbar button, .toolbar select, .toolbar input")]
      .filter((one) => one.offsetParent).map((one) => [one.textContent, one.getBoundingClientRect()])
      .filter(([, box]) => box.right > innerWidth || box.left < 0).map(([words]) => words)"""
    assert hand.js(out) == []
    hand.button("Draw in space")
    assert hand.js(out) == []
    assert hand.js("document.documentElement.scrollWidth <= innerWidth")
    shown = show(viewer.write(fourbar(), tmp_path / "flat.html"), 390, 800, has_touch=True)
    assert shown.js(out) == []


def test_no_field_cuts_the_number_that_it_shows(show, served):
    hand = drawn(show, served)
    four_bar(hand)
    hand.choose("pick a member", "b1")
    hand.write("length of b1", "0.1")
    hand.press("Escape", "v", "g")
    hand.page.locator("h1").click()
    hand.press("v")
    x, y = hand.spot("B")
    hand.page.mouse.move(x, y)
    hand.page.mouse.down()
    hand.page.mouse.move(x + 13, y + 1, steps=4)  # on a circle about A
    hand.page.mouse.up()
    place = hand.state()["places"][1]
    assert np.hypot(*place) == pytest.approx(0.1)
    assert place[0] not in (0.0, round(place[0], 6))
    cut = """[...document.querySelectorAll(".sketch input[type=text]")]
      .filter((one) => one.offsetParent && one.scrollWidth > one.clientWidth).map((one) => one.getAttribute("aria-label"))"""
    assert hand.js(cut) == []
    assert float(hand.page.get_by_label("x of B", exact=True).input_value()) == pytest.approx(place[0], rel=1e-6)
