"""Drawing in the studio, by mouse and keys alone, from an empty page; the forces are those of the same model in Python."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from hand import drawn
from kinetruss import dynamics, kinematics
from kinetruss.library import cells
from served import WAIT, start

pytestmark = pytest.mark.slow

# Theo Jansen's published lengths of one leg, mm (T. Jansen, The Great Pretender, 010 Publishers, 2007)
JANSEN = {
    "b": 41.5,
    "c": 39.3,
    "d": 40.1,
    "e": 55.8,
    "f": 39.4,
    "g": 36.7,
    "h": 65.7,
    "i": 49.0,
    "j": 50.0,
    "k": 61.9,
    "m": 15.0,
}
FRAME = (-38.0, -7.8)
BARS = {"m": "OM", "j": "MT", "b": "PT", "e": "TL", "d": "PL", "k": "MK", "c": "PK", "f": "LA", "g": "KA", "h": "AF", "i": "KF"}


def forces_of(model: kt.Model, x: np.ndarray) -> dict[frozenset, float]:
    """Forces of a model at rest, by the ends of its members."""
    motion = kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])
    values = dynamics.inverse(model, motion, static=False).arrays["member_force"].values[0]
    return {frozenset(member.ends): force for member, force in zip(model.members.values(), values, strict=True)}


def meet(a, ra, b, rb, left: bool) -> np.ndarray:
    """The point at the distances ra of a and rb of b, to the left or the right of the way from a to b."""
    d = np.subtract(b, a)
    length = np.hypot(*d)
    along = (ra**2 - rb**2 + length**2) / (2 * length)
    across = np.sqrt(ra**2 - along**2) * (1 if left else -1)
    return a + along * d / length + across * np.array([-d[1], d[0]]) / length


def jansen() -> dict[str, np.ndarray]:
    """The nodes of the leg with its crank along x, m."""
    q = {name: value / 1000 for name, value in JANSEN.items()}
    O, P, M = np.zeros(2), np.array(FRAME) / 1000, np.array([q["m"], 0.0])
    T = meet(M, q["j"], P, q["b"], left=False)
    L = meet(T, q["e"], P, q["d"], left=False)
    K = meet(M, q["k"], P, q["c"], left=True)
    A = meet(L, q["f"], K, q["g"], left=False)
    F = meet(A, q["h"], K, q["i"], left=False)
    return {"O": O, "P": P, "M": M, "T": T, "L": L, "K": K, "A": A, "F": F}


def test_jansens_leg_is_drawn_by_hand_and_has_the_forces_of_the_library(show, served):
    hand = drawn(show, served)
    hand.closer("0.005", 3)
    places = jansen()
    hand.press("n")
    for name, place in places.items():
        hand.click((*place, 0))
        hand.write(f"name of {hand.state()['nodes'][-1]}", name)
    hand.press("f", "b")
    for name, (a, b) in BARS.items():
        hand.pull(a, b)
        hand.write(f"name of {hand.state()['members'][-1]['name']}", name)
    for axis, value in zip("xy", FRAME, strict=True):
        hand.choose("pick a node", "P")
        hand.write(f"{axis} of P", f"{value} mm")
    hand.held("O")
    hand.held("P")
    assert hand.state()["why"].startswith("No forces yet: 1 mechanism")
    hand.choose("pick a member", "m")
    hand.choose("driven angle of m", "on")
    for name, value in JANSEN.items():
        hand.choose("pick a member", name)
        hand.write(f"length of {name}", f"{value} mm")
    hand.choose("pick a node", "M")
    hand.write("x of M", "15 mm")
    hand.write("y of M", "0")
    hand.choose("pick a node", "F")
    hand.write("force on F along y", "100 N")
    hand.choose("section of the model", "tube_lacy_planar")
    hand.choose("material of the model", "aluminium_lacy")
    state = hand.state()
    assert (state["warnings"], state["missing"], state["faults"]) == ([], [], [])
    np.testing.assert_allclose(state["places"], list(places.values()), rtol=0, atol=1e-13)

    bars = {name: kt.Bar(ends=tuple(ends), length=JANSEN[name] / 1000) for name, ends in BARS.items()}
    model = kt.Model(
        nodes={name: tuple(place) for name, place in places.items()}, fixed=["O", "P"], bars=bars, gravity=(0, -9.81),
        section="tube_lacy_planar", material="aluminium_lacy", drives={"crank": kt.AngleDrive("m")},
        loads={"foot": kt.NodalForce(node="F", force=(0, 100))},
    )  # fmt: skip
    wanted = forces_of(model, kinematics.assemble(model))
    found = {frozenset(one["ends"]): force for one, force in zip(state["members"], state["force"], strict=True)}
    largest = max(map(abs, wanted.values()))
    assert {ends: found[ends] - wanted[ends] for ends in wanted} == pytest.approx(dict.fromkeys(wanted, 0), abs=1e-12 * largest)

    # the path of the foot follows at once: a closed curve, flat below
    hand.choose("node of the path", "F")
    hand.button("Show path")
    hand.shown.until("kinetruss.draw.curves.found && !kinetruss.draw.waiting")
    path = np.array(hand.js("draw.curves.found.path"))
    np.testing.assert_allclose(path[0], path[-1], atol=1e-9)
    np.testing.assert_allclose(path[0], places["F"], atol=1e-12)
    assert np.ptp(path[:, 0]) > 2 * np.ptp(path[:, 1])
    before = hand.js("draw.curves.found.force")
    hand.press("Control+z")  # the material
    hand.shown.until(f"JSON.stringify(kinetruss.draw.curves.found.force) !== '{hand.js('JSON.stringify(given)', before)}'")
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
    # and it is saved, as it is
    hand.press("Control+y")
    hand.page.locator("h1").click()
    hand.press("Control+s")
    assert kt.read(served.folder / "model.yaml").bars["k"].length == pytest.approx(0.0619)


def test_a_double_octahedral_bay_is_drawn_in_space_by_hand(show, served):
    given = cells.stack([cells.double_octahedron()], gravity=None)
    driven = {name: kt.Bar(ends=member.ends, kind="driven") for name, member in given.active.items()}
    bay = kt.Model(
        nodes=given.nodes, fixed=given.fixed, bars={**{name: bar.ends for name, bar in given.bars.items()}, **driven}
    )
    model = bay.with_(loads={"tip": kt.NodalForce(node="N8", force=(10.0, 20.0, -50.0))})
    hand = drawn(show, served)
    hand.page.get_by_role("button", name="New, in space").click()
    hand.settle()
    hand.button("Top")
    hand.closer("0.1", -2)
    hand.press("n")
    names = {}
    for name, node in bay.nodes.items():
        x, y, z = node.at
        hand.write("height of the work plane in m", f"{z:.3f}")
        hand.click((round(x, 1), round(y, 1), z))
        new = hand.state()["nodes"][-1]
        names[name] = new
        for axis, value in zip("xyz", (x, y, z), strict=True):
            hand.write(f"{axis} of {new}", repr(float(value)))
    assert len(set(names.values())) == 9
    hand.button("Corner")
    hand.page.locator("h1").click()
    hand.press("b")
    for member in bay.members.values():
        hand.pull(*(names[end] for end in member.ends))
    for name in bay.fixed:
        hand.held(names[name])
    assert len(hand.state()["warnings"]) == 0
    for name, member in bay.members.items():
        if name in driven:
            own = next(
                one["name"] for one in hand.state()["members"] if set(one["ends"]) == {names[end] for end in member.ends}
            )
            hand.choose("pick a member", own)
            hand.choose(f"kind of {own}", "driven")
    hand.choose("pick a node", names["N8"])
    for axis, words in zip("xyz", ("10 N", "20", "-50 N"), strict=True):
        hand.write(f"force on {names['N8']} along {axis}", words)
    state = hand.state()
    assert (state["warnings"], state["missing"], [one["unit"] for one in state["drives"]]) == ([], [], ["m"] * 3)
    wanted = forces_of(model, np.array([node.at for node in bay.nodes.values()]))
    found = {frozenset(one["ends"]): force for one, force in zip(state["members"], state["force"], strict=True)}
    largest = max(map(abs, wanted.values()))
    for ends, force in wanted.items():
        assert found[frozenset(names[end] for end in ends)] == pytest.approx(force, abs=1e-12 * largest)
    # it is dragged in its plane: the third coordinate stays
    hand.press("Escape")
    hand.page.locator("h1").click()
    hand.press("v")
    before = state["places"][7]
    x, y = hand.spot(names["N8"])
    hand.page.mouse.move(x, y)
    hand.page.mouse.down()
    hand.page.mouse.move(x + 40, y + 10, steps=6)
    hand.page.mouse.up()
    after = hand.state()["places"][7]
    assert after[2] == before[2]
    assert np.hypot(after[0] - before[0], after[1] - before[1]) > 0.02
    hand.press("Control+z")
    assert hand.state()["places"][7] == before
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_keys_alone_draw_a_triangle_and_the_text_follows_both_ways(show, served):
    hand = drawn(show, served)
    hand.page.locator("svg.drawing").focus()
    hand.press("n", "ArrowRight", "Enter", *["ArrowRight"] * 5, "Enter", "ArrowUp", "ArrowUp", "ArrowUp", "Enter")
    state = hand.state()
    assert state["nodes"] == ["A", "B", "C"]
    step = hand.js("draw.camera.grid")
    np.testing.assert_allclose(state["places"], np.array([[0, 0], [5, 0], [5, 3]]) * step, atol=1e-12)
    hand.press("b", "Enter", "ArrowDown", "ArrowDown", "ArrowDown", "Enter", *["ArrowLeft"] * 5, "Enter")
    assert [one["ends"] for one in hand.state()["members"]] == [["C", "B"], ["B", "A"]]
    area = hand.page.get_by_label("model as text")
    text = area.input_value()
    assert "b2: [B, A]" in text
    area.fill(text.replace("b2: [B, A]", "b2: [B, A]\n  b3: [A, C]").replace("gravity", "fixed: {A: xy, B: y}\ngravity"))
    hand.shown.until("kinetruss.draw.state.members.length === 3")
    assert hand.state()["mobility"]["undriven"] == 0
    area.fill(area.input_value().replace("b3: [A, C]", "b3: [A, Q]"))
    hand.shown.until("document.querySelector('.faults').textContent.includes('Q')")
    line = next(k for k, row in enumerate(area.input_value().splitlines(), 1) if "Q" in row)
    assert f"Line {line}" in hand.page.locator(".faults").inner_text()
    assert hand.page.locator(".lines .faulty").inner_text().strip() == str(line)
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_bar_from_beside_a_node_starts_at_the_node_to_which_the_grid_leads(show, served):
    hand = drawn(show, served)
    assert hand.page.locator(".faults").inner_text().strip() == ""  # an empty drawing has no faults
    step = hand.js("draw.camera.grid")
    hand.pull((-4 * step, 0, 0), (0, 2 * step, 0))
    beside = (0.3 * step, 1.7 * step, 0)  # farther from the node than a click may be, nearer than to the next line of the grid
    assert hand.js("draw.canvas.hit(draw.camera.project(given))", list(beside)) is None
    hand.pull(beside, (4 * step, 0, 0))
    assert [one["ends"] for one in hand.state()["members"]] == [["A", "B"], ["B", "C"]]
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def test_a_lost_studio_keeps_the_drawing_and_goes_on_with_it(show, served):
    hand = drawn(show, served)
    hand.press("b")
    hand.pull((0, 0, 0), (0.4, 0.2, 0))
    assert hand.state()["members"][0]["name"] == "b1"
    served.process.kill()
    served.process.wait(WAIT)
    hand.shown.until("kinetruss.draw.closed")
    assert "stays as it was last confirmed" in hand.page.locator(".banner").first.inner_text()
    assert hand.js("[...document.querySelectorAll('button, input, select, textarea')].every((one) => one.disabled)")
    assert hand.page.locator("path.bar").count() == 1
    again = start(served.folder)
    try:
        assert again.address == served.address  # the same port and token
        hand.shown.until("!kinetruss.draw.closed && !document.querySelector('.banner:last-of-type')?.hidden")
        hand.page.get_by_role("button", name="Go on with it").click(timeout=1000 * WAIT)
        hand.shown.until("kinetruss.draw.state.members.length === 1")
        hand.press("b")
        hand.pull("B", (0.6, 0, 0))
        assert len(hand.state()["members"]) == 2
    finally:
        again.process.kill()
        again.process.communicate()


def test_a_drag_shows_closed_poses_only_and_is_one_step(show, served):
    hand = drawn(show, served)
    hand.press("b")
    ends: Sequence[tuple] = [(-0.4, 0, 0), (-0.4, 0.2, 0), (0.2, 0.4, 0), (0.4, 0, 0)]
    for a, b in pairwise(ends):
        hand.pull(a, b)
    for name in "AD":
        hand.held(name)
    for k, name in enumerate(("b1", "b2", "b3")):
        hand.choose("pick a member", name)
        hand.write(f"length of {name}", f"{(0.2, 0.63, 0.45)[k]} m")
    hand.choose("pick a member", "b1")
    hand.choose("driven angle of b1", "on")
    hand.page.locator("h1").click()
    hand.press("v", "g")
    steps = hand.js("draw.undone = state.undo")
    hand.page.evaluate("""() => {
      const draw = kinetruss.draw, place = draw.place.bind(draw), lengths = [0.2, 0.63, 0.45];
      Object.assign(window, { worst: 0, seen: 0 });
      draw.place = (answer) => {
        place(answer);
        window.seen++;
        const { places } = draw.state;
        lengths.forEach((length, k) => {
          const [a, b] = [places[k], places[k + 1]];
          window.worst = Math.max(window.worst, Math.abs(Math.hypot(a[0] - b[0], a[1] - b[1]) - length));
        });
      };
    }""")
    x, y = hand.spot("B")
    hand.page.mouse.move(x, y)
    hand.page.mouse.down()
    for k in range(20):
        hand.page.mouse.move(x + 3 * k, y + k)
    hand.page.mouse.up()
    hand.settle()
    assert hand.page.evaluate("window.seen") > 2
    assert hand.page.evaluate("window.worst") < 1e-12
    assert hand.state()["undo"] == "moving B"
    hand.press("Control+z")
    assert hand.state()["undo"] == steps


@pytest.mark.parametrize(("width", "scheme"), [(1300, "light"), (900, "dark"), (400, "light")])
def test_nothing_runs_out_of_the_window_and_tools_can_be_touched(show, served, width, scheme):
    hand = drawn(show, served, width=width, height=850, scheme=scheme)
    assert hand.js("document.documentElement.scrollWidth") <= width
    sizes = hand.js("[...document.querySelectorAll('.rail button')].filter((one) => one.offsetParent)"
                    ".map((one) => Math.min(one.offsetWidth, one.offsetHeight))")  # fmt: skip
    assert min(sizes) >= 44
    hand.press("b")
    hand.pull((0, 0, 0), (0.2, 0.1, 0))
    assert hand.page.locator("path.bar").count() == 1
    unnamed = hand.js("[...document.querySelectorAll('button, input, select, textarea')].filter((one) => "
                      "!one.getAttribute('aria-label') && !one.textContent.trim() && !one.closest('label'))"
                      ".map((one) => one.outerHTML)")  # fmt: skip
    assert unnamed == []


def test_a_picture_is_placed_by_two_points(show, served, tmp_path):
    hand = drawn(show, served)
    picture = Path(tmp_path) / "sketch.svg"
    picture.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100"><rect width="200" height="100"/></svg>'
    )
    hand.page.locator("summary", has_text="Picture to trace").click()
    hand.page.get_by_label("picture to trace", exact=True).set_input_files(picture)
    hand.shown.until("kinetruss.draw.picture.image")
    hand.button("Place by two points")
    hand.js("draw.picture.pixel = (x, y) => { const { origin: o, turn: [c, s] } = draw.picture.image;"
            " return [o[0] + c * x + s * y, o[1] + s * x - c * y, 0]; }")  # fmt: skip
    for pixel in ([20, 80], [180, 80]):
        hand.page.mouse.click(*hand.spot(hand.js("draw.picture.pixel(...given)", pixel)))
    for label, words in (("x of the second point in m", "0"), ("y of the second point in m", "2")):
        field = hand.page.get_by_label(label, exact=True)
        field.fill(words)
    hand.button("Place")
    for pixel, place in (([20, 80], [0, 0]), ([180, 80], [0, 2]), ([20, 0], [-1, 0])):
        assert hand.js("draw.picture.pixel(...given)", pixel)[:2] == pytest.approx(place, abs=0.02)
