"""The buttons *Next* in space: from an empty page to what carries a load, or moves; and words where no click helps."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from hand import Hand, drawn

pytestmark = pytest.mark.slow


def buttons(hand: Hand) -> list[str]:
    hand.settle()
    return hand.page.locator(".motion .next button").all_text_contents()


def press(hand: Hand, words: str) -> None:
    hand.page.locator(".motion .next").get_by_role("button").filter(has_text=words).first.click()
    hand.settle()


def raised(hand: Hand, height: str) -> None:
    hand.write("height of the work plane in m", height)


def balanced(hand: Hand, node: str) -> np.ndarray:
    """What the bars at a node do to it, N."""
    state = hand.state()
    at = dict(zip(state["nodes"], np.array(state["places"]), strict=True))
    total = np.zeros(3)
    for member, force in zip(state["members"], state["force"], strict=True):
        if node in member["ends"]:
            (other,) = set(member["ends"]) - {node}
            way = at[other] - at[node]
            total += force * way / np.linalg.norm(way)
    return total


@pytest.mark.parametrize(("width", "scheme"), [(1440, "light"), (390, "dark")])
def test_three_bars_and_a_node_become_a_tetrahedron_that_holds_a_load(show, served, width, scheme):
    hand = drawn(show, served, width=width, height=900, scheme=scheme, has_touch=True)
    hand.button("Draw in space")
    hand.button("hide the drawings to begin with")
    hand.page.evaluate("document.querySelector('svg.drawing').scrollIntoView()")
    for pair in (((-0.2, -0.2, 0), (0.2, -0.2, 0)), ("B", (0, 0.2, 0)), ("C", "A")):
        hand.pull(*pair)
    if width < 620:
        hand.page.locator(".rail .fold").click()
    raised(hand, "0.3")
    hand.js("draw.setTool('node')")
    hand.page.evaluate("document.querySelector('svg.drawing').scrollIntoView()")
    hand.click((0, 0, 0.3))
    assert hand.state()["nodes"] == ["A", "B", "C", "D"]
    assert buttons(hand) == ["Hold A", "Hold B", "Hold C"]
    free = [hand.js("state.mobility.undriven")]
    for words in ("Hold A", "Hold B along", "Hold C along z", "Bar A to D", "Bar B to D", "Bar C to D"):
        press(hand, words)
        free.append(hand.js("state.mobility.undriven"))
    assert free == [9, 6, 4, 3, 2, 1, 0]
    assert hand.js("state.mobility.self_stress") == 0
    assert buttons(hand) == ["100 N down at D"]
    press(hand, "100 N")
    assert buttons(hand) == []
    state = hand.state()
    assert hand.page.locator(".sketch .good").inner_text().startswith("Stable")
    assert balanced(hand, "D") == pytest.approx([0, 0, 100], abs=1e-6)
    assert np.sum(list(state["reaction"].values()), axis=0) == pytest.approx([0, 0, 100], abs=1e-6)
    model = kt.Model(**{key: value for key, value in state["data"].items() if key != "kinetruss"})
    assert kt.kinematics.mobility(model).undriven == 0
    hand.button("Undo")
    assert buttons(hand) == ["100 N down at D"]
    assert hand.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_bar_in_space_is_held_turned_and_played(opened):
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": kt.Node(at=(0.3, 0, 0.4), mass=1.0)}, bars={"b1": ("A", "B")}, fixed={"A": "xyz", "B": "y"}
    )
    hand = opened(model)
    assert buttons(hand)[-1] == "Turn b1 about A, axis y"
    press(hand, "Turn b1")
    hand.shown.until("kinetruss.draw.play.playing && kinetruss.draw.play.index > 3")
    hand.page.get_by_role("button", name="pause", exact=True).click()
    assert "full turn" in hand.page.locator(".motion .words").inner_text()
    place = hand.js("draw.at('B')")
    assert math.hypot(*place) == pytest.approx(0.5, abs=1e-6)
    assert place[1] == pytest.approx(0, abs=1e-9)


def test_what_no_click_stops_is_said(opened):
    beam = kt.Beam(ends=("A", "B"), section="tube_lacy_planar", material="aluminium_lacy")
    hand = opened(kt.Model(nodes={"A": (0, 0, 0), "B": (1, 0, 0)}, fixed={"A": "xyz", "B": "yz"}, beams={"beam": beam}))
    assert hand.js("state.mobility.undriven") == 1
    assert buttons(hand) == []
    assert "No single click stops it" in hand.page.locator(".motion .words").inner_text()
