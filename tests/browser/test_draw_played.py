"""While a drawing plays: strength as colour, rates and speeds as they are typed and chosen, dimensions as live numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from four_bars import four_bar
from hand import Hand
from kinetruss.studio.poses import at_rest, strength_of

pytestmark = pytest.mark.slow

PLAY = "kinetruss.draw.play"
NOT_CHECKED = "rgb(138, 138, 138)"
ROD = {"section": kt.Rod(diameter=0.005), "material": "steel_s235"}


def said(hand: Hand) -> str:
    return hand.page.locator(".motion .words").inner_text()


def linkage() -> kt.Model:
    """A four-bar whose rod has no section."""
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    return model.with_(bars={name: one.model_copy(update={} if name == "rod" else ROD) for name, one in model.bars.items()})


def seek(hand: Hand, index: int) -> None:
    """The slider at a sample, by keys."""
    slider = hand.page.get_by_label("time", exact=True)
    slider.focus()
    slider.fill(str(index))


def stop(hand: Hand) -> None:
    """Playing, then stopped at some pose away from the drawn one."""
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    hand.page.get_by_role("button", name="pause", exact=True).click()
    hand.settle()


def strokes(hand: Hand) -> dict[str, str]:
    return hand.js(
        "Object.fromEntries([...document.querySelectorAll('path.bar')].map((one) => [one.dataset.member, one.style.stroke]))"
    )


def test_strength_as_colour_follows_the_motion_and_the_largest_of_it_is_said(opened):
    model = linkage()
    hand = opened(model)
    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    assert not hand.js("draw.play.film.judged")  # computed when it is asked for
    hand.page.get_by_role("button", name="Colour by strength: how much of what is allowed is used").click()
    hand.shown.until(f"{PLAY}.film.judged && {PLAY}.playing")
    stop(hand)
    colours = {}
    for index in (40, 200):
        seek(hand, index)
        state = hand.state()
        pose = at_rest(model, np.array(state["places"]))
        known = strength_of(model, pose)[1]
        assert list(state["used"]) == list(known) == ["crank", "rocker"]
        assert state["used"] == pytest.approx(known, rel=1e-4)
        words = hand.page.locator(".legend").inner_text()
        most = max(known, key=known.get)
        assert f"most: {most}, " in words
        assert "not checked" in words
        colours[index] = strokes(hand)
    assert colours[40]["rocker"] != colours[200]["rocker"]
    assert colours[40]["rod"] == colours[200]["rod"] == NOT_CHECKED
    used = np.array(hand.js("Array.from(draw.play.film.arrays.used.data, (one) => (isNaN(one) ? null : one))"), float)
    used = used.reshape(-1, 3)
    names = hand.js("draw.play.film.judged")
    assert names == ["crank", "rod", "rocker"]
    sample, member = np.unravel_index(np.nanargmax(used), used.shape)
    value = hand.js("draw.play.film.value(given)", int(sample))
    told = f"of what is allowed, of {names[member]} at motor {math.degrees(value):.4g} deg. Not checked: rod."
    assert told in said(hand)
    hand.page.locator("svg.drawing").focus()
    hand.press("8")
    assert "Strength" not in said(hand)
    hand.press("Escape", "8")
    assert hand.state()["used"] == pytest.approx(strength_of(model, at_rest(model, kt.kinematics.assemble(model)))[1])
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_what_carries_more_than_is_allowed_is_said_wherever_the_motion_passes_it(opened):
    model = linkage()
    hand = opened(model.with_(loads={"F": kt.NodalForce(node="C", force=(0, -3000))}))
    hand.page.locator("svg.drawing").focus()
    hand.press("8", " ")
    stop(hand)
    assert hand.js("draw.play.film.most.value") > 1
    assert hand.page.locator(".motion .words .here").inner_text().startswith("Strength: at most ")


def test_a_rate_is_kept_as_it_is_typed_and_what_is_none_is_said_beside_it(opened):
    bars = {"boom": kt.Bar(ends=("A", "B"), kind="driven"), "jack": kt.Bar(ends=("C", "B"), kind="driven")}
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(1, 0.3), mass=2.0), "C": (0.5, -0.5)}, fixed={"A": "xy", "C": "xy"}, bars=bars
    )
    hand = opened(model)
    hand.button("▶ Play")
    stop(hand)
    hand.choose("forces while it moves", "on")
    rate = hand.page.get_by_label("rate of the drive", exact=True)
    usual = hand.js("draw.play.film.rate")
    assert rate.input_value() == ""
    assert rate.get_attribute("placeholder") == f"{1000 * usual:.4g} mm/s"
    hand.write("rate of the drive", "12 cm/s")
    assert (rate.input_value(), hand.js("draw.play.film.rate")) == ("12 cm/s", pytest.approx(0.12))
    assert "boom at 120 mm/s." in said(hand)
    hand.choose("way through the range", "once")
    hand.choose("drive that moves", "jack")
    assert rate.input_value() == "12 cm/s"
    assert "jack at 120 mm/s." in said(hand)
    hand.write("rate of the drive", "10 rpm")
    wrong = hand.page.locator(".motion .wrong")
    assert wrong.inner_text() == ("'10 rpm' is not a speed. Write for example 50 mm/s or 0.1 m/s. Shown at 120 mm/s.")
    assert (rate.input_value(), rate.get_attribute("aria-invalid")) == ("10 rpm", "true")
    assert hand.js("draw.play.film.rate") == pytest.approx(0.12)
    assert not hand.page.locator(".head .banner").first.is_visible()
    hand.write("rate of the drive", "0.05")
    assert (wrong.count(), rate.input_value(), hand.js("draw.play.film.rate")) == (0, "0.05", pytest.approx(0.05))
    hand.choose("pick a node", "B")
    hand.write("force on B along y", "-100 N")
    hand.shown.until(f"!{PLAY}.film")  # another drawing: another motion, at the same rate
    hand.button("▶ Play")
    stop(hand)
    assert (rate.input_value(), hand.js("draw.play.film.rate")) == ("0.05", pytest.approx(0.05))
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_the_speed_is_chosen_by_name_and_by_keys_and_stays(opened):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4))
    hand.button("▶ Play")
    stop(hand)
    assert hand.page.locator(".motion label", has=hand.page.get_by_label("speed", exact=True)).inner_text().startswith("Speed")
    hand.choose("speed", "0.2")
    assert hand.js("draw.play.speed") == 0.2
    hand.page.locator("svg.drawing").focus()
    hand.press("+", "+")
    assert (hand.js("draw.play.speed"), hand.page.get_by_label("speed", exact=True).input_value()) == (0.8, "0.8")
    hand.press("-", "-", "-")
    assert hand.js("draw.play.speed") == 0.1
    hand.choose("pick a node", "C")
    hand.write("force on C along y", "-200 N")
    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.playing")
    assert (hand.js("draw.play.speed"), hand.page.get_by_label("speed", exact=True).input_value()) == (0.1, "0.1")


MEASURES = ".drawing .values .measure"


def shown(hand: Hand) -> list[str]:
    return hand.page.locator(MEASURES).all_text_contents()


def measured(hand: Hand) -> list[str]:
    """What the dimensions B to D and the angle of crank and rod are in the pose shown."""
    a, b, c, d = map(np.array, hand.state()["places"])
    far = np.linalg.norm(d - b)
    u, v = a - b, c - b
    angle = math.degrees(math.acos(u @ v / np.linalg.norm(u) / np.linalg.norm(v)))
    return [f"{1000 * far:.4g} mm", f"{angle:.4g} deg"]


def test_dimensions_are_measured_where_the_motion_stops_and_outlive_the_page(opened):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4))
    hand.button("▶ Play")
    stop(hand)
    seek(hand, 60)
    hand.page.locator(".palette").get_by_label("Dimension", exact=True).click()
    hand.pull("B", "D")  # by the mouse, in the pose at which it stands
    assert hand.js("draw.play.away")
    assert hand.js("draw.play.index") == 60
    hand.page.locator("svg.drawing").focus()
    for name, key in (("crank", "Shift+Enter"), ("rod", "Enter")):  # by keys
        ends = f"state.members.find((one) => one.name === '{name}').ends.map((end) => draw.at(end))"
        hand.js(f"draw.keyboard.setCursor({ends}.reduce((p, q) => p.map((one, k) => (one + q[k]) / 2)))")
        hand.press(key)
    assert hand.state()["dimensions"] == [{"nodes": ["B", "D"]}, {"members": ["crank", "rod"]}]
    assert shown(hand) == measured(hand)
    before = shown(hand)
    hand.page.get_by_role("button", name="play", exact=True).click()
    hand.shown.until(f"{PLAY}.index > 70")
    hand.page.get_by_role("button", name="pause", exact=True).click()
    assert shown(hand) == measured(hand) != before
    hand.page.reload()
    hand.page.wait_for_selector("#kinetruss[data-state=ready]")
    hand.settle()
    assert shown(hand) == measured(hand)
    assert "not saved" not in hand.page.locator("h1").inner_text()  # no part of the file
    hand.press("Control+z")
    assert hand.state()["dimensions"] == [{"nodes": ["B", "D"]}]
    hand.press("Control+y")
    hand.choose("pick a node", "B")
    hand.write("name of B", "elbow")
    assert hand.state()["dimensions"] == [{"nodes": ["D", "elbow"]}, {"members": ["crank", "rod"]}]
    assert shown(hand) == measured(hand)
    hand.choose("pick a member", "rod")
    hand.button("Delete what is picked")
    assert len(shown(hand)) == 1
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_the_picture_and_the_report_are_taken_as_pdf(opened, tmp_path):
    hand = opened(four_bar((0.1, 0.35, 0.3), 0.4))
    hand.page.unroute_all()
    for name, file in (("take PDF", "model.pdf"), ("take Report as PDF", "model_report.pdf")):
        with hand.page.expect_download() as coming:
            hand.page.get_by_role("button", name=name, exact=True).click()
        coming.value.save_as(tmp_path / file)
        assert coming.value.suggested_filename == file
        assert (tmp_path / file).read_bytes().startswith(b"%PDF-")
        hand.settle()


def test_what_is_not_driven_is_let_go_by_keys_and_swings_with_the_forces_of_a_pendulum(opened):
    mass, length, g = 2.0, 0.5, 9.81
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(length, 0), mass=mass)}, fixed={"A": "xy"}, bars={"b": ("A", "B")},
        gravity=(0, -g), drives={"motor": kt.AngleDrive("b")},
    )  # fmt: skip
    hand = opened(model.with_(drives={}))
    assert said(hand).startswith("Nothing is driven yet: Play lets it go.")
    hand.page.locator("svg.drawing").focus()
    hand.press(" ")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    hand.press(" ")
    assert "Let go, from rest" in said(hand)
    assert hand.js("draw.play.film.time.at(-1)") == pytest.approx(6)
    for index in (20, 200):
        seek(hand, index)
        state = hand.state()
        below = -state["places"][1][1] / length
        assert state["force"][0] == pytest.approx(3 * mass * g * below, abs=1e-4)  # m v^2/l + m g sin, with v^2 = 2 g l sin
        assert np.hypot(*state["reaction"]["A"]) == pytest.approx(abs(state["force"][0]), abs=1e-4)
    hand.press("Escape")
    # the same of a drive that is let go, by mouse; a drive that holds leaves nothing to fall
    hand.js("draw.ask({ do: 'set', path: ['drives', 'motor'], value: { kind: 'angle', bar: 'b' } })")
    hand.settle()
    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.film")
    hand.choose("drive that moves", "let go")
    hand.shown.until(f"{PLAY}.film?.falls")
    stop(hand)
    seek(hand, 100)
    state = hand.state()
    assert (state["drives"][0]["force"], "the drives hold" in said(hand)) == (0, False)
    assert state["force"][0] == pytest.approx(-3 * mass * g * state["places"][1][1] / length, abs=1e-4)
    shown = state["places"][1]
    hand.button("Keep this pose")
    kept = hand.state()
    assert (hand.js("draw.play.away"), kept["undo"]) == (False, "the pose that was let go")
    assert kept["places"][1] == pytest.approx(shown, abs=1e-6)
    assert np.hypot(*kept["places"][1]) == pytest.approx(length, rel=1e-9)
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_diagram_is_that_of_the_pose_where_the_motion_stops(opened):
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    model = model.with_(bars={name: one.model_copy(update=ROD) for name, one in model.bars.items()}, gravity=(0, -9.81))
    hand = opened(model)
    hand.choose("diagram", "M")
    weight = 7850 * 9.81 * math.pi * 0.0025**2  # of the rod, N/m

    def check() -> None:
        hand.shown.until("kinetruss.draw.diagram.found && !kinetruss.draw.diagram.stale")
        state = hand.state()
        b, c = (state["places"][state["nodes"].index(name)] for name in "BC")
        middle = weight * abs(c[0] - b[0]) * 0.35 / 8  # q cos l^2 / 8
        found = hand.js("Object.fromEntries(draw.diagram.found.curves.map(({ part, values }) => [part, values]))")
        most = {part: max(map(abs, values)) for part, values in found.items()}
        assert most["rod"] == pytest.approx(middle, rel=1e-3)  # a page gets every fourth place
        assert most["crank"] == pytest.approx(abs(state["drives"][0]["force"]), rel=1e-5)  # at the motor
        assert hand.page.locator(".drawing .diagram text").count()

    check()
    hand.button("▶ Play")
    hand.shown.until(f"{PLAY}.playing && {PLAY}.index > 2")
    assert hand.page.locator(".told").first.inner_text() == "The diagram is shown where the motion stops."
    assert not hand.page.locator(".drawing .diagram text").count()
    stop(hand)
    for index in (90, 240):
        seek(hand, index)
        hand.settle()
        check()
    hand.press("Escape")
    hand.settle()
    check()
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
