"""Every tool where it is looked for: on the toolbar, at the right button and under a finger; by mouse or by keys alone."""

from __future__ import annotations

from itertools import combinations

import pytest

from hand import Hand, drawn

pytestmark = pytest.mark.slow

BOXES = """[...document.querySelectorAll('.drawing .names text, .drawing .values text, .drawing .diagram text')]
  .filter((one) => one.getAttribute('display') !== 'none').map((one) => one.getBoundingClientRect())
  .map(({ x, y, width, height }) => [x + 1, y + 2, x + width - 1, y + height - 2])"""


def tool(hand: Hand, name: str) -> None:
    hand.page.locator(".palette").get_by_label(name, exact=True).click()


def at_once(hand: Hand, words: str) -> None:
    """Type into the field beside what was just drawn."""
    hand.shown.until("!document.querySelector('.value').hidden")
    hand.page.keyboard.type(words)
    hand.press("Enter")


def data(hand: Hand) -> dict:
    return hand.state()["data"]


def test_a_four_bar_with_forces_by_mouse_alone(show, served):
    hand = drawn(show, served, width=1440)
    hand.pull((0, 0, 0), (0, 0.2, 0))
    hand.pull("B", (0.5, 0.4, 0))
    hand.pull("C", (0.6, 0, 0))
    tool(hand, "Pin")
    hand.click("A")
    hand.click("D")
    tool(hand, "Turn")
    hand.click((0, 0.1, 0))
    tool(hand, "Force")
    hand.pull("C", (0.5, 0.3, 0))
    state = hand.state()
    assert (state["fixed"], data(hand)["drives"]) == ({"A": "xy", "D": "xy"}, {"motor": {"kind": "angle", "bar": "b1"}})
    arrow = state["loads"][0]
    assert arrow["node"] == "C"
    assert arrow["force"][0] == 0
    assert arrow["force"][1] < 0
    words = hand.page.locator(".drawing .values text").all_text_contents()
    assert words == [f"{-arrow['force'][1]:g} N"]  # the value stands at the arrow
    hand.press("Escape")
    # the same from the menu at the right button; a tool that is used once gives back the one before
    hand.click("B", button="right")
    hand.page.get_by_role("menuitem", name="Mass", exact=True).click()
    at_once(hand, "3 kg")
    assert data(hand)["nodes"]["B"] == {"at": [0, 0.2], "mass": "3 kg"}
    assert hand.js("draw.tool") == "force"
    hand.click((0.55, 0.2, 0), button="right")
    hand.page.get_by_role("menuitem", name="Line load", exact=True).click()
    hand.click((0.7, 0.2, 0))
    at_once(hand, "2 kN/m")
    assert data(hand)["loads"]["q_b3"] == {"member": "b3", "force": ["2 kN/m", "0 kN/m"]}
    hand.button("Undo")
    hand.button("Undo")
    assert "q_b3" not in data(hand)["loads"]
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_angles_and_rates_are_read_and_typed_in_degrees(show, served):
    hand = drawn(show, served, width=1440)
    hand.pull((0, 0, 0), (0, 0.2, 0))
    tool(hand, "Pin")
    hand.click("A")
    tool(hand, "Turn")
    hand.click((0, 0.1, 0))
    hand.button("New run")
    assert hand.page.get_by_label("runs.run1.trajectory.moves.motor", exact=True).input_value() == "90 deg, 120 deg"
    hand.choose("runs.run1.trajectory", ": ConstantRate")
    label = "runs.run1.trajectory.rates"
    assert hand.page.get_by_label(f"new name in {label}", exact=True).input_value() == "motor"  # the drive that is meant
    hand.page.get_by_label(f"new value in {label}", exact=True).fill("60")
    hand.page.get_by_label(f"add to {label}", exact=True).click()
    hand.write("runs.run1.trajectory.duration", "6 s")
    hand.page.get_by_label("apply runs.run1.trajectory", exact=True).click()
    made = data(hand)["runs"]["run1"]["trajectory"]
    assert made == {"kind": "constant_rate", "rates": {"motor": "60 deg/s"}, "duration": "6 s"}
    hand.js("draw.change('a rate in rad/s', [[['runs', 'run1', 'trajectory', 'rates', 'motor'], Math.PI]])")
    hand.settle()
    assert hand.page.get_by_label(f"{label}.motor", exact=True).input_value() == "180 deg/s"
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def cursor(hand: Hand, node: str | tuple[float, float]) -> None:
    """Bring the cursor of the keys to a node or a point of the grid."""
    hand.page.locator("svg.drawing").focus()
    if not hand.js("Boolean(draw.cursor)"):
        hand.press("ArrowRight")
    to = hand.js("draw.at(given)", node)[:2] if isinstance(node, str) else node
    for k, keys in enumerate((("ArrowLeft", "ArrowRight"), ("ArrowDown", "ArrowUp"))):
        steps = round((to[k] - hand.js("draw.cursor")[k]) / hand.js("draw.camera.grid"))
        hand.press_at_once(*[keys[steps > 0]] * abs(steps))
    hand.settle()


def enter(hand: Hand, *places: str | tuple[float, float]) -> None:
    for place in places:
        cursor(hand, place)
        hand.press("Enter")


def test_a_scissor_lift_by_keys_alone(show, served):
    hand = drawn(show, served, width=1440)
    hand.page.locator("svg.drawing").focus()
    hand.press("1")
    enter(hand, (0.0, 0.0), (0.2, 0.15), (0.4, 0.3), (0.4, 0.3))
    enter(hand, (0.4, 0.0), "B", (0.0, 0.3), (0.0, 0.3))
    assert data(hand)["links"] == {"link1": ["A", "B", "C"], "link2": ["D", "B", "E"]}
    hand.press("h")
    enter(hand, "A")
    hand.press("r")
    enter(hand, "D")
    cursor(hand, "D")
    hand.press("Shift+F10")  # the menu, where the cursor is
    names = hand.page.get_by_role("menuitem").all_inner_texts()
    assert {"Pin", "Roller", "Clamp", "Push", "Force", "Mass", "Slider", "Delete"} <= set(names)
    while hand.js("document.activeElement.textContent") != "Push":
        hand.press_at_once("ArrowDown")
    hand.press("Enter")
    assert data(hand)["drives"] == {"slide": {"kind": "coordinate", "node": "D", "axis": "x"}}
    hand.press("p")
    enter(hand, "C", (0.4, 0.1))
    at_once(hand, "1 kN")
    assert data(hand)["loads"]["F_C"]["force"] == ["0 kN", "-1 kN"]
    # virtual work: 1 kN falls by dy = -x/y dx of the height 2 y of both stages, x = 0.4 m and 0.3 m
    held = hand.state()["drives"][0]["force"]
    assert held == pytest.approx(-1000 * 0.4 / 0.3, rel=1e-9)
    assert hand.state()["hints"] == []
    hand.press("r")
    enter(hand, "D")  # the same support again frees the node
    assert "D" not in hand.state()["fixed"]
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_quick_return_gears_springs_and_dimensions(show, served):
    hand = drawn(show, served, width=820, height=1000)
    hand.pull((0, 0, 0), (0.2, 0.4, 0))
    hand.pull((0, 0.2, 0), (0.1, 0.2, 0))
    tool(hand, "Slider")
    hand.click("D")
    block = {"terms": [[{"kind": "offset", "line": ["A", "B"], "point": "D"}, 1]], "value": 0}
    assert data(hand)["couplings"] == {"block": block}
    assert hand.state()["hints"] == []  # a block lies on its bar on purpose
    assert hand.page.locator(".drawing .block").count() == 1
    tool(hand, "Pin")
    for name in "AC":
        hand.click(name)
    tool(hand, "Turn")
    hand.click((0.05, 0.2, 0))
    assert hand.state()["mobility"]["undriven"] == 0
    tool(hand, "Dimension")
    hand.click((0.15, 0.3, 0))
    at_once(hand, "450 mm")
    assert data(hand)["bars"]["b1"] == {"ends": ["A", "B"], "length": "450 mm"}
    assert hand.page.locator(".drawing .values .measure").all_text_contents() == ["450 mm"]  # as it was typed
    hand.press("b")
    hand.pull((-0.3, 0, 0), (-0.3, 0.1, 0))
    tool(hand, "Pin")
    hand.click("E")
    tool(hand, "Gear")
    hand.click((0.05, 0.2, 0))
    hand.click((-0.3, 0.05, 0))
    at_once(hand, "-20/40")
    gear = data(hand)["couplings"]["gear"]["terms"]
    assert gear == [[{"kind": "angle", "bar": "b2"}, -0.5], [{"kind": "angle", "bar": "b3"}, -1]]
    before = hand.js("draw.play.film?.frames || 0")
    hand.page.get_by_role("button", name="▶ Play", exact=True).click()
    hand.shown.until(f"kinetruss.draw.play.film?.frames > {before}")
    turn = """(() => { const { film } = draw.play, angle = (a, b, k) => { const p = film.position(k, film.nodes.indexOf(a)),
      q = film.position(k, film.nodes.indexOf(b)); return Math.atan2(q[1] - p[1], q[0] - p[0]); };
      const by = (a, b) => { const d = angle(a, b, film.here + 5) - angle(a, b, film.here);
        return Math.atan2(Math.sin(d), Math.cos(d)); };
      return by('E', 'F') / by('C', 'D'); })()"""
    assert hand.js(turn) == pytest.approx(-0.5, abs=1e-5)  # single precision of the film
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_supports_of_each_kind_and_a_cylinder(show, served):
    hand = drawn(show, served, width=1440)
    hand.pull((0, 0, 0), (0.4, 0, 0))
    hand.pull("B", (0.4, 0.3, 0))
    tool(hand, "Clamp")
    hand.click("B")
    assert "has a rotation to hold" in hand.page.locator(".head .banner").first.inner_text()
    hand.click("A")
    assert data(hand)["clamped"] == ["A"]
    assert data(hand)["links"] == {"b1": {"nodes": ["A", "B"], "weld": ["A"]}}
    tool(hand, "Roller")
    hand.pull("C", (0.6, 0.5, 0))
    assert data(hand)["supports"] == {"C": {"y": "held", "turned": "45 deg"}}
    assert {(one["node"], one["kind"]) for one in hand.state()["supports"]} == {("A", "clamp"), ("C", "roller")}
    tool(hand, "Pin")
    hand.click("C")
    assert (data(hand).get("supports"), hand.state()["fixed"]["C"]) == (None, "xy")
    tool(hand, "Cylinder")
    hand.pull("C", (0, 0.3, 0))
    made = data(hand)["active"]["cylinder1"]
    assert (made["ends"], made["limits"]) == (["C", "D"], [0.32, 0.56])
    tool(hand, "Turn")
    hand.click((0.2, 0, 0))
    assert data(hand)["drives"] == {"motor": {"kind": "angle", "bar": "b1"}}
    hand.click((0.2, 0, 0))
    assert "drives" not in data(hand)
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_section_is_found_beside_the_bar_and_its_strength_is_a_colour(show, served):
    hand = drawn(show, served, width=1440)
    hand.page.evaluate("kinetruss.draw.starters.begin('Truss bridge')")
    hand.shown.until("kinetruss.draw.state.members.length > 20")
    hand.choose("pick a member", "bottom4")
    model = hand.page.get_by_label("material of the model", exact=True).bounding_box()
    assert model["y"] + model["height"] < 900  # section and material of the model are above the fold
    hand.page.get_by_label("catalogue, section of bottom4").click()
    hand.page.keyboard.type("steel 60.3")
    rows = hand.page.locator(".catalogue tbody tr")
    hand.shown.until("document.querySelectorAll('.catalogue tbody tr').length === 4")
    assert rows.nth(2).inner_text().split()[0] == "60.3x4"
    rows.nth(2).get_by_role("button").click()
    hand.settle()
    assert data(hand)["bars"]["bottom4"]["section"] == {"kind": "tube", "outer": "60.3 mm", "inner": "52.3 mm"}
    area = 3.141592653589793 * (0.0603**2 - 0.0523**2) / 4
    assert hand.js("state.weights.members.bottom4") == pytest.approx(7850 * area * 4)
    hand.press("Escape", "8")
    used = hand.state()["used"]
    force = hand.state()["force"][[one["name"] for one in hand.state()["members"]].index("bottom4")]
    assert 1.0 < used["bottom4"] / (force / area / 235e6) < 1.1  # a tie of S235 without a factor, bent a little by its weight
    bars = "[...document.querySelectorAll('path.bar')].map((one) => [one.dataset.member, one.style.stroke])"
    colours = hand.js(f"Object.fromEntries({bars})")
    assert colours["bottom4"] == "rgb(227, 0, 58)"
    assert len({colours[name] for name in ("bottom1", "end1", "top3")}) == 3
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


@pytest.mark.parametrize(("width", "scheme"), [(1440, "light"), (820, "dark"), (390, "light")])
def test_no_words_lie_over_each_other_at_forty_bars_and_all_tools_are_in_sight(show, served, width, scheme):
    hand = drawn(show, served, width=width, height=844, scheme=scheme, has_touch=True)
    text = ["kinetruss: 1", "nodes:"]
    text += [f"  N{k}: [{0.5 * (k // 2)}, {0.4 * (k % 2) * (1 + k % 3)}]" for k in range(22)]
    text += ["fixed: {N0: xy, N20: y}", "bars:"]
    ends = [(k, k + 1) for k in range(21)] + [(k, k + 2) for k in range(20)]
    text += [f"  b{k}: [N{a}, N{b}]" for k, (a, b) in enumerate(ends)]
    text += ["loads:", *[f"  F{k}: {{node: N{k}, force: [0 N, -{k} kN]}}" for k in range(3, 20, 2)], ""]
    hand.js("draw.ask({ do: 'text', text: given })", "\n".join(text))
    hand.js("draw.fit()")
    assert len(hand.state()["members"]) == 41
    for show_diagram in ("", "N"):
        hand.js("draw.diagram.choose(given)", show_diagram)
        hand.settle()
        boxes = hand.js(BOXES)
        assert len(boxes) > 12
        for a, b in combinations(boxes, 2):
            assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1], (a, b)
    if width > 620:
        tools = hand.page.locator(".palette button:not(.head)").all()
        assert len(tools) > 20
        for one in tools:
            box = one.bounding_box()
            assert 0 <= box["x"] <= box["x"] + box["width"] <= width
            assert min(box["width"], box["height"]) >= 44
    # a finger that rests opens the menu of what lies under it
    hand.page.evaluate("document.querySelector('svg.drawing').scrollIntoView()")
    x, y = hand.spot("N10")
    touch = {"pointerType": "touch", "pointerId": 7, "clientX": x, "clientY": y, "button": 0, "bubbles": True}
    press = "(sheet.setPointerCapture = () => {}, sheet.dispatchEvent(new PointerEvent('pointerdown', given)), 0)"
    hand.js(press.replace("sheet", "draw.canvas.node"), touch)
    hand.shown.until("!document.querySelector('.menu').hidden")
    assert hand.page.locator(".menu b").inner_text() == "N10"
    assert hand.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
