"""The drawing runs and is moved: by the mouse alone, by keys alone, on wide and narrow screens."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import kinetruss as kt
from four_bars import four_bar
from hand import Hand, drawn

pytestmark = pytest.mark.slow

PLAY = "kinetruss.draw.play"


def said(hand: Hand) -> str:
    return hand.page.locator(".motion .words").inner_text()


def check_pose(hand: Hand, model: kt.Model) -> None:
    """What is shown of a pose is what the library finds there."""
    state = hand.state()
    angle = state["drives"][0]["value"]
    start = np.array([node.at for node in model.nodes.values()])
    own = math.atan2(*(start[1] - start[0])[::-1])
    way = kt.Quintic(moves={"motor": (own, own + (angle - own) % (2 * math.pi))}, duration=1.0)
    motion = kt.kinematics.follow(model, way)
    x = motion.position.values[-1:]
    np.testing.assert_allclose(state["places"], x[0], atol=1e-6)
    still = kt.kinematics.from_arrays(model, [0.0], x, 0 * x, 0 * x)
    forces = kt.dynamics.inverse(model, still, static=False)
    np.testing.assert_allclose(state["force"], forces.member_force.values[0], rtol=1e-5, atol=1e-4)
    np.testing.assert_allclose(state["reaction"]["A"], forces.reaction.sel(support="A").values[0], rtol=1e-5, atol=1e-4)
    assert state["drives"][0]["force"] == pytest.approx(float(forces.drive_force.values[0, 0]), rel=1e-5, abs=1e-5)


def test_by_mouse_alone_from_an_empty_sheet_to_a_four_bar_that_runs_with_forces(show, served):
    hand = drawn(show, served, width=1440)
    assert hand.page.locator(".welcome").is_visible()
    hand.pull((-0.3, 0, 0), (-0.3, 0.1, 0))
    assert not hand.page.locator(".welcome").is_visible()
    hand.pull("B", (0, 0.3, 0))
    hand.pull("C", (0.1, 0, 0))
    assert said(hand) == "Nothing is driven yet. Next: Hold AHold D"
    hand.button("support at A")
    hand.button("support at D")
    hand.button("drive b1 about A")
    hand.shown.until(f"{PLAY}.playing")
    hand.button("load on C")
    hand.shown.until(f"{PLAY}.playing")
    hand.shown.until(f"{PLAY}.index > 5")  # bench/studio.py measures how fast
    hand.page.get_by_role("button", name="pause", exact=True).click()
    assert "motor: full turn. Largest torque 6.27" in said(hand)
    assert "b3 swings 38.5 deg" in said(hand)
    at, shown = hand.js("draw.play.index"), hand.js("state.places")
    nodes = {"A": (-0.3, 0), "B": (-0.3, 0.1), "C": (0, 0.3), "D": (0.1, 0)}
    model = kt.Model(
        nodes=nodes, fixed={"A": "xy", "D": "xy"}, bars={"b1": ("A", "B"), "b2": ("B", "C"), "b3": ("C", "D")},
        drives={"motor": kt.AngleDrive("b1")}, loads={"F": kt.NodalForce(node="C", force=(0, -100))}, gravity=(0, -9.81),
    )  # fmt: skip
    check_pose(hand, model)
    graph = hand.page.locator(".graph").bounding_box()
    hand.page.mouse.click(graph["x"] + 0.75 * graph["width"], graph["y"] + 50)  # the curve is a slider too
    assert hand.js("draw.play.index") != at
    check_pose(hand, model)
    shown = hand.js("state.places")
    hand.button("Keep this pose")
    state = hand.state()
    assert not hand.js("draw.play.away")
    np.testing.assert_allclose(state["places"], shown, atol=1e-6)
    lengths = [math.dist(state["places"][a], state["places"][b]) for a, b in ((0, 1), (1, 2), (2, 3))]
    np.testing.assert_allclose(lengths, [0.1, math.hypot(0.3, 0.2), math.hypot(0.1, 0.3)], atol=1e-12)
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_by_keys_alone_it_plays_is_stopped_and_is_moved(opened):
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    hand = opened(model)
    hand.page.locator("svg.drawing").focus()
    hand.press(" ")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    hand.press(" ")
    assert not hand.js("draw.play.playing")
    check_pose(hand, model)
    hand.page.get_by_label("time", exact=True).focus()
    before = hand.js("draw.play.index")
    hand.press("ArrowRight", "ArrowRight")
    assert hand.js("draw.play.index") == before + 2
    check_pose(hand, model)
    hand.page.locator("svg.drawing").focus()
    hand.press("Escape")
    assert not hand.js("draw.play.away")
    np.testing.assert_allclose(hand.state()["places"], [node.at for node in model.nodes.values()], atol=1e-15)
    hand.press("m")
    hand.page.evaluate("kinetruss.draw.keyboard.setCursor(kinetruss.draw.at('B'))")
    hand.press("Enter", "ArrowLeft", "ArrowLeft", "ArrowLeft")
    hand.press("Enter")
    state = hand.state()
    assert state["undo"] == "moving B"
    assert state["drives"][0]["value"] > math.pi / 2 + 0.1
    lengths = [math.dist(state["places"][a], state["places"][b]) for a, b in ((0, 1), (1, 2), (2, 3))]
    np.testing.assert_allclose(lengths, [0.1, 0.35, 0.3], atol=1e-12)


def test_which_tool_moves_and_which_changes_is_seen_at_the_pointer_with_lengths_and_angles(opened):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4))
    for key, words, kept in (("m", "lengths are kept", True), ("v", "changes lengths", False)):
        hand.page.locator("svg.drawing").focus()
        hand.press(key)
        x, y = hand.spot("B")
        hand.page.mouse.move(x + 1, y)
        assert hand.page.locator(".hand").text_content() == words
        hand.page.mouse.down()
        hand.page.mouse.move(x - 30, y + 5)
        hand.page.mouse.move(x - 60, y + 5)
        hand.settle()
        tags = hand.page.locator(".drawing .tag").all_text_contents()
        places = hand.js("state.places")
        b = np.array(places[1])
        angle = math.degrees(math.atan2(b[1], b[0]))
        _, length, _, shown, _ = next(one for one in tags if one.startswith("crank")).replace(",", "").split()
        assert [float(length), float(shown)] == pytest.approx([1000 * np.linalg.norm(b), angle], rel=5e-4)
        assert all(" mm, " in one for one in tags if one[:3] in ("cra", "rod"))
        hand.page.mouse.up()
        hand.settle()
        assert bool(abs(np.linalg.norm(b) - 0.1) < 1e-12) is kept
        hand.press("Control+z")
    hand.press("m")
    hand.page.mouse.move(*hand.spot("A"))
    hand.pull("A", (0.05, 0.05, 0))
    assert "A is held" in hand.page.locator(".head .banner").first.inner_text()


def test_what_blocks_is_said_and_it_goes_there_and_back(opened):
    hand = opened(four_bar((0.3, 0.2, 0.25), 0.5, 0.8))
    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.playing")
    assert said(hand).count("rod and rocker are in line at C.") == 2
    most = float(re.search(r"away from the dead point ([\d.]+) N m", said(hand))[1])
    torque = np.abs(hand.js("Array.from(draw.play.film.arrays.drive_force.data)"))
    assert most == pytest.approx(torque[torque <= 8 * np.sort(torque)[len(torque) // 2]].max(), rel=1e-3)
    assert torque.max() > 2 * most
    ways = hand.page.get_by_label("way through the range", exact=True)
    assert ways.locator("option").all_text_contents() == ["There and back", "Once"]
    last = hand.js("draw.play.film.frames - 1")
    passed = """[0.25, 0.75, 1.25, 1.75, 2.25].map((share) => {
      Object.assign(draw.play, { playing: true, clock: { at: 0, from: 0 } });
      draw.play.tick((1000 * share * draw.play.duration) / draw.play.speed);
      draw.play.playing = false;
      return draw.play.index / (draw.play.film.frames - 1);
    })"""
    np.testing.assert_allclose(hand.js(passed), [0.25, 0.75, 0.75, 0.25, 0.25], atol=2 / last)
    hand.page.evaluate(f"{PLAY}.pause(); {PLAY}.seek({last})")
    assert hand.page.locator(".motion .here").text_content().startswith("motor blocks at ")
    ways.select_option("once")
    hand.page.evaluate(f"{PLAY}.seek({last - 5}); {PLAY}.togglePlay()")
    hand.shown.until(f"!{PLAY}.playing")
    assert hand.js("draw.play.index") == last


def test_an_edit_goes_back_to_the_drawn_pose_and_the_motion_goes_on_anew(opened):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4))
    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 3")
    hand.choose("pick a node", "C")
    assert hand.js("draw.play.playing")  # what is picked is measured while it runs
    before = hand.js("draw.play.film.largest")
    hand.write("force on C along y", "-200 N")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.film.revision === kinetruss.draw.state.revision")
    assert hand.js("draw.play.film.largest") == pytest.approx(2 * before, rel=1e-6)
    hand.press("n")
    hand.page.locator("svg.drawing").focus()
    hand.press("n")
    hand.click((0.2, 0.1, 0))  # drawing begins at the drawn pose
    assert not hand.js("draw.play.away")
    assert len(hand.state()["nodes"]) == 4


SLOW = """(() => {
  const send = draw.post;
  let sweeps = 0;
  draw.post = (text) => {
    const { do: what, number } = JSON.parse(text);
    if (what === "sweep" ? sweeps++ : number !== 999) return send(text);
    const late = { kind: "computing", number: 999, text: "Computing: 7 s" };
    const answer = window.ready ? { kind: "replaced", message: "Another one." } : late;
    setTimeout(() => draw.hear(JSON.stringify(answer)), 20);
  };
})()"""  # the first motion is not computed before the page has `ready`, and is then not that of the drawing any more


def test_while_a_motion_is_computed_edits_are_answered_and_what_is_played_is_the_changed_drawing(opened):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4))
    hand.js(SLOW)
    hand.page.get_by_role("button", name="▶ Play", exact=True).click()
    hand.shown.until("kinetruss.draw.busy.words === 'Computing: 7 s'")
    hand.js("void draw.edit({ do: 'set', path: ['loads', 'F', 'force'], value: [0, -50] })")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.film.revision === kinetruss.draw.state.revision")
    assert hand.js("draw.play.awaited") == 1
    hand.js("window.ready = true")
    hand.settle()
    assert hand.js("[draw.play.awaited, draw.play.failed, draw.play.playing]") == [0, "", True]
    hand.page.get_by_role("button", name="pause", exact=True).click()
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    check_pose(hand, model.with_(loads={"F": kt.NodalForce(node="C", force=(0, -50))}))
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


@pytest.mark.parametrize(("width", "scheme"), [(1440, "dark"), (820, "light"), (390, "dark")])
def test_on_every_screen_the_motion_is_at_hand(opened, width, scheme):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4), width=width, height=844, scheme=scheme, has_touch=True)
    hand.page.get_by_role("button", name="▶ Play", exact=True).tap()
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    hand.page.get_by_role("button", name="pause", exact=True).tap()
    assert hand.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    for one in hand.page.locator(".motion button, .motion select, .motion input").all():
        box = one.bounding_box()
        assert box["height"] >= 43.5, one
        assert 0 <= box["x"] <= box["x"] + box["width"] <= width
    sizes = hand.page.evaluate("[...document.querySelectorAll('.motion select')].map((one) => one.clientWidth - 30)")
    assert min(sizes) > 40
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
