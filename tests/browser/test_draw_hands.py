"""What the drawing page can do is done with a mouse, with keys, and with fingers on a phone, by one script for all."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any

import numpy as np
import pytest

import kinetruss as kt
from hands import WAYS, OneHand

pytestmark = pytest.mark.slow

HANDS = [("mouse", 1440), ("mouse", 820), ("fingers", 390), ("keys", 1440), ("keys", 820), ("keys", 390)]
PLAY = "kinetruss.draw.play"
CUT = """[...document.querySelectorAll('.sketch, .rail, .motion, .sheetpane')].flatMap((part) => [...part.querySelectorAll(
  'input[type=text], td, th, .words, .readout span, .legend span, select')]).filter((one) => one.offsetParent
  && one.scrollWidth > one.clientWidth + 1 && one.clientWidth).map((one) => one.outerHTML.slice(0, 200))"""
"""What shows only a part of its number or words."""
WORDS = """[...document.querySelectorAll('.drawing .names text, .drawing .values text, .drawing .diagram text')]
  .filter((one) => one.getAttribute('display') !== 'none').map((one) => one.getBoundingClientRect())
  .map(({ x, y, width, height }) => [x + 1, y + 2, x + width - 1, y + height - 2])"""
"""Boxes of the words in the picture."""


@pytest.fixture(params=HANDS, ids=[f"{way} {width}" for way, width in HANDS])
def hand(request, show, served) -> OneHand:
    """A hand of one way before an empty drawing."""
    way, width = request.param
    phone = {"has_touch": True, "is_mobile": True} if way == "fingers" else {}
    one = WAYS[way](show(served.address, width=width, height=900 if width > 390 else 844, **phone))
    one.button("hide the drawings to begin with")
    return one


def data(hand: OneHand) -> dict[str, Any]:
    return hand.state()["data"]


def lengths(hand: OneHand) -> dict[str, float]:
    state = hand.state()
    at = dict(zip(state["nodes"], state["places"], strict=True))
    return {one["name"]: math.dist(*(at[end] for end in one["ends"])) for one in state["members"]}


def apart(boxes: list[list[float]]) -> bool:
    return all(a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1] for a, b in combinations(boxes, 2))


def sound(hand: OneHand) -> None:
    """Nothing is cut or out of the window, and the page has not complained."""
    assert hand.js(CUT) == []
    assert hand.js("document.documentElement.scrollWidth <= innerWidth")
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_four_bar_is_drawn_loaded_played_kept_moved_and_changed(hand):
    hand.give((-0.4, -0.2), (-0.4, 0.0), (0.2, 0.2))
    assert hand.page.locator(".value").is_visible()
    hand.value("600 mm")  # at once: its new end moves, all else stays
    assert lengths(hand) == pytest.approx({"b1": 0.2, "b2": 0.6}, abs=1e-12)
    hand.give((0.4, -0.2))
    hand.tool("Pin")
    hand.give("A", "D")
    hand.tool("Turn")
    hand.give("b1")
    hand.tool("Force")
    hand.draw("C", (0.4, 0.0) if hand.js("draw.camera.grid") > 0.1 else (0.2, -0.1))
    hand.value("100 N")
    hand.menu("B", "Mass")
    hand.value("2 kg")
    state = hand.state()
    assert data(hand)["nodes"]["B"]["mass"] == "2 kg"
    assert math.hypot(*state["loads"][0]["force"]) == pytest.approx(100)
    assert sorted(hand.page.locator(".drawing .values text").all_text_contents()) == ["100 N"]
    # what holds the drive is the work of the force and of the weight, by differences of closed poses of the drawing itself
    model = kt.Model(**{key: value for key, value in state["data"].items() if key != "kinetruss"})
    angle, step = state["drives"][0]["value"], 1e-4
    way = kt.Quintic(moves={"motor": (angle, angle + step)}, duration=1.0)
    path = kt.kinematics.follow(model, way).position
    moved = path.isel(time=-1) - path.isel(time=0)
    force = np.array(state["loads"][0]["force"])
    work = float(moved.sel(node="C").values @ force) - 2 * 9.81 * float(moved.sel(node="B").values[1])
    assert state["drives"][0]["force"] == pytest.approx(-work / step, rel=1e-2)

    hand.menu("b3", "Line load")
    hand.give((0.0, -0.2))
    hand.value("2 kN/m")
    assert data(hand)["loads"]["q_b3"]["member"] == "b3"
    hand.button("Undo")
    hand.button("Undo")

    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    hand.button("pause")
    assert hand.js("draw.play.away")
    assert "full turn" in hand.page.locator(".motion .words").inner_text()
    hand.choose("way through the range", "Once")
    shown = hand.js("state.places")
    hand.button("Keep this pose")
    np.testing.assert_allclose(hand.state()["places"], shown, atol=1e-6)
    kept = lengths(hand)
    hand.button("Undo")

    for tool, same in (("Move", True), ("Pick", False)):
        hand.tool(tool)
        x, y = hand.place("B")
        hand.pull("B", (x + 0.2, y))
        assert (lengths(hand) == pytest.approx(kept, abs=1e-9)) is same
        assert hand.state()["undo"] == "moving B"
        hand.button("Undo")
    sound(hand)


def test_every_tool_that_holds_joins_drives_and_measures(hand):
    hand.tool("Link")
    hand.give((-0.4, 0.4), (-0.2, 0.4), (0.0, 0.4), (0.0, 0.4))
    assert data(hand)["links"] == {"link1": ["A", "B", "C"]}
    hand.tool("Clamp")
    hand.give("A")
    assert data(hand)["clamped"] == ["A"]
    hand.give("A")
    hand.tool("Roller")
    hand.draw("C", (0.2, 0.6))
    assert data(hand)["supports"] == {"C": {"y": "held", "turned": "45 deg"}}
    hand.tool("Spring foot")
    hand.give("A")
    hand.value("20 kN/m")
    assert data(hand)["supports"]["A"] == {"x": "held", "y": "20 kN/m"}
    hand.tool("Cylinder")
    hand.draw("C", (0.4, 0.0))
    hand.tool("Spring")
    hand.draw("B", (-0.2, 0.0))
    hand.value("3 kN/m")
    hand.tool("Rope")
    hand.draw("A", (-0.4, 0.0))
    hand.value("50 kN/m")
    bars = data(hand)["bars"]
    assert {name: (one["kind"], one["stiffness"]) for name, one in bars.items()} == {
        "spring1": ("elastic", "3 kN/m"), "rope1": ("cable", "50 kN/m")}  # fmt: skip
    assert data(hand)["active"]["cylinder1"]["ends"] == ["C", "D"]

    hand.tool("Bar")
    for ends in (((-0.4, -0.4), (0.4, -0.4)), ((0.0, -0.4), (0.0, -0.2)), ("G", (0.2, -0.2))):
        hand.draw(*ends)
        hand.tool("Bar")  # begins anew
    nodes = hand.state()["nodes"]
    assert nodes[6:] == ["G", "H", "I", "J", "K"]
    hand.tool("Slider")
    hand.give("I")
    assert data(hand)["couplings"]["block"] == {
        "terms": [[{"kind": "offset", "line": ["G", "H"], "point": "I"}, 1]],
        "value": 0,
    }
    hand.tool("Gear")
    hand.give("b2", "b3")
    hand.value("-20/40")
    assert data(hand)["couplings"]["gear"]["terms"] == [
        [{"kind": "angle", "bar": "b2"}, -0.5],
        [{"kind": "angle", "bar": "b3"}, -1],
    ]
    hand.tool("Hinge spring")
    hand.draw((-0.2, -0.4), "b3")
    hand.value("5 N m/rad")
    assert [one["stiffness"] for one in data(hand)["springs"].values()] == ["5 N m/rad"]
    hand.tool("Stroke")
    hand.give("b2")
    assert data(hand)["bars"]["b2"] == {"ends": ["I", "J"], "kind": "driven"}
    hand.tool("Roller")
    hand.give("H")
    hand.tool("Push")
    hand.give("H")
    assert data(hand)["drives"] == {"slide": {"kind": "coordinate", "node": "H", "axis": "x"}}
    hand.tool("Dimension")
    hand.draw("A", "D")
    hand.draw((-0.2, -0.4), "b3")
    hand.give((-0.2, -0.4))
    hand.value("750 mm")
    assert data(hand)["bars"]["b1"]["length"] == "750 mm"
    assert hand.page.locator(".drawing .values .measure").count() == 3
    hand.tool("Pick")
    hand.give("K")
    hand.button("Delete what is picked")
    assert "K" not in hand.state()["nodes"]
    hand.button("Undo")
    sound(hand)


def test_a_bridge_is_begun_read_given_sections_weighed_and_taken_away(hand, tmp_path):
    opened = hand.page.locator("summary", has_text="Begin from")
    hand.touch(opened)
    card = hand.page.locator(".sketch .card", has_text="Truss bridge")
    card.wait_for()
    hand.touch(card)
    hand.shown.until("kinetruss.draw.state.members.length > 20")
    hand.settle()
    if hand.page.locator(".rail .fold").is_visible():
        hand.touch(hand.page.locator(".rail .fold"))
    amounts = hand.page.locator(".drawing .values .amount:visible").all_text_contents()
    assert len(amounts) >= 1
    assert all(one.endswith("N") for one in amounts)
    assert apart(hand.js(WORDS))
    for what in "NVM":
        hand.choose("diagram", hand.page.get_by_label("diagram", exact=True).locator(f"option[value={what}]").text_content())
        hand.shown.until("kinetruss.draw.diagram.found")
        assert hand.page.locator(".drawing .diagram path, .drawing .diagram polygon").count() > 20
        assert apart(hand.js(WORDS))
    hand.choose("diagram", "Off")

    hand.tool("Pick")
    hand.give("bottom4")
    hand.button("catalogue, section of bottom4")
    hand.page.keyboard.type("steel 60.3")
    hand.shown.until("document.querySelectorAll('.catalogue tbody tr').length === 4")
    hand.touch(hand.page.locator(".catalogue tbody tr").nth(2).get_by_role("button"))
    hand.settle()
    area = math.pi * (0.0603**2 - 0.0523**2) / 4
    assert hand.js("state.weights.members.bottom4") == pytest.approx(7850 * area * 4)
    weight = hand.page.locator(".sketch .weight").inner_text()
    assert weight.startswith(f"weighs {7850 * area * 4:.1f}"[:11])
    hand.button("Colour by strength: how much of what is allowed is used")
    used = hand.state()["used"]
    stroke = hand.js("document.querySelector('path.bar[data-member=bottom4]').style.stroke")
    assert used["bottom4"] > 1
    assert stroke == "rgb(227, 0, 58)"
    sound(hand)

    # an edit that takes long is said to be computed, and nothing of before is shown
    hand.js("(draw.late = draw.hear.bind(draw), draw.hear = (...one) => (draw.held = () => draw.late(...one)), 0)")
    hand.touch(hand.page.get_by_role("button", name="Undo", exact=True))
    hand.shown.until("kinetruss.draw.held && !document.querySelector('.sheetpane .busy').hidden")
    assert hand.page.locator(".sheetpane .busy").inner_text() == "Computing ..."
    assert hand.page.locator(".drawing .tag:visible", has_text="kN").count() == 0
    hand.js("(draw.hear = draw.late, draw.held(), 0)")
    hand.settle()

    hand.page.unroute_all()
    with hand.page.expect_download() as coming:
        hand.touch(hand.page.get_by_role("button", name="take YAML"))
    coming.value.save_as(tmp_path / "bridge.yaml")
    assert len(kt.read(tmp_path / "bridge.yaml").bars) == 21
