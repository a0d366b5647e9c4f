"""The page of kinetruss studio, used in a browser."""

from __future__ import annotations

import json
from collections.abc import Iterator

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import dynamics, kinematics
from samples import tripod
from served import Served, serve, start

pytestmark = pytest.mark.slow


def dyad() -> kt.Model:
    """Two bars whose lengths are driven; flat on the ground they are singular."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": kt.Node(at=(0.5, 0.6), mass=5.0)}, fixed=("A", "B"), gravity=(0, -9.81),
        bars={"left": kt.Bar(ends=("A", "C"), kind="driven"), "right": kt.Bar(ends=("B", "C"), kind="driven")},
        section=kt.Tube(outer=0.02, inner=0.016), material=kt.Material(E=71e9, density=2700.0, yield_strength=240e6),
    )  # fmt: skip


@pytest.fixture(scope="module")
def served(tmp_path_factory) -> Iterator[dict[str, Served]]:
    models = {"tripod": tripod(), "dyad": dyad()}
    found = {name: serve(model, tmp_path_factory.mktemp(name)) for name, model in models.items()}
    yield found
    for one in found.values():
        one.process.kill()
        one.process.communicate()


def ask(shown, **command):
    return shown.page.evaluate("(command) => kinetruss.live.ask(command)", command)


def settled(shown) -> None:
    shown.until("!kinetruss.live.waiting && !kinetruss.live.wanted && !kinetruss.live.queue.length")


def slide(shown, name: str, value: float) -> None:
    """Put a slider somewhere, as a pointer does."""
    slider = shown.page.locator(f'[data-drive="{name}"] input[type=range]')
    slider.evaluate(
        "(node, value) => { node.value = value; node.dispatchEvent(new Event('input', { bubbles: true })); }", value
    )
    settled(shown)


def clean(shown) -> None:
    assert shown.requests == []
    assert shown.complaints == []


def test_a_slider_moves_the_model_and_its_forces_are_those_of_the_interface(show, served):
    shown = show(served["tripod"].address)
    before = shown.js("view.now")
    shown.page.locator('[data-drive="LA"] input[type=range]').focus()
    shown.press(*["ArrowRight"] * 5)
    settled(shown)
    slide(shown, "LB", 1.17)
    found = ask(shown, do="query")
    assert found["values"]["LA"] == pytest.approx(1.0305, abs=1.3e-3)
    assert found["values"]["LA"] > 1.0296
    assert found["values"]["LB"] == pytest.approx(1.17, abs=2.6e-4)
    model = tripod()
    x = kinematics.assemble(model, found["values"])
    motion = kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])
    forces = dynamics.inverse(model, motion, static=False).data
    for name in ("member_force", "reaction", "drive_force"):
        wanted = forces[name].values[0]
        np.testing.assert_allclose(found[name], wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())
    # what is drawn and told is that pose
    assert shown.js("view.now") != before
    np.testing.assert_allclose(shown.js("view.now"), x, atol=1e-6)
    told = shown.js("scene.members.map((_, k) => scene.value('force', 0, k))")
    np.testing.assert_allclose(told, forces["member_force"].values[0], rtol=1e-6)
    cell = shown.page.locator('.table tr[data-name="LA"] td').first.inner_text()
    assert float(cell.split()[0].replace("−", "-")) == pytest.approx(forces["member_force"].values[0, 0], rel=1e-3)
    clean(shown)


def test_the_picture_is_not_blank_and_moves(show, served):
    shown = show(served["tripod"].address)
    canvas = shown.page.locator(".pane canvas")
    shown.drawn()
    first = canvas.screenshot()
    slide(shown, "LA", 1.25)
    shown.drawn()
    second = canvas.screenshot()
    assert first != second
    assert min(len(first), len(second)) > 10_000


def test_a_slider_stops_at_the_last_good_pose_with_a_reason(show, served):
    shown = show(served["dyad"].address)
    slide(shown, "left", 0.52)
    slide(shown, "right", 0.47)
    banner = shown.page.locator(".controls .banner")
    assert banner.is_visible()
    assert "singular" in banner.inner_text() or "cannot be closed" in banner.inner_text()
    found = ask(shown, do="query")
    assert found["values"]["right"] > 0.48
    slider = shown.page.locator('[data-drive="right"] input[type=range]')
    assert float(slider.input_value()) == pytest.approx(found["values"]["right"], abs=3e-4)
    lengths = [np.linalg.norm(np.subtract(found["position"][k], found["position"][2])) for k in (0, 1)]
    assert lengths == pytest.approx([found["values"]["left"], found["values"]["right"]], abs=1e-12)
    slide(shown, "right", 0.8)
    assert banner.is_hidden()
    clean(shown)


def test_two_pages_at_once(show, served):
    one, two = show(served["tripod"].address), show(served["tripod"].address)
    slide(one, "LA", 1.2)
    slide(two, "LB", 0.9)
    a, b = ask(one, do="query")["values"], ask(two, do="query")["values"]
    assert (round(a["LA"], 3), round(a["LB"], 3)) == (1.2, 1.03)
    assert (round(b["LA"], 3), round(b["LB"], 3)) == (1.03, 0.9)


def test_members_are_switched_and_loads_edited(show, served):
    shown = show(served["dyad"].address)
    shown.js("app.pick({ type: 'member', name: 'left' })")
    shown.page.get_by_role("button", name="elastic", exact=True).click()
    settled(shown)
    assert shown.js("scene.header.kinds") == ["elastic", "driven"]
    assert shown.page.locator('[data-drive="left"]').count() == 0
    shown.page.get_by_role("button", name="cut", exact=True).click()
    settled(shown)
    assert shown.js("scene.members") == ["right"]
    assert shown.js("view.now[2][1]") < 0  # it hangs
    shown.page.get_by_role("button", name="Back to the file's model").click()
    settled(shown)
    assert shown.js("scene.members") == ["left", "right"]
    shown.page.get_by_text("Gravity, payload, loads").click()
    shown.page.get_by_label("payload in kg").fill("50")
    shown.page.get_by_label("payload in kg").press("Tab")
    settled(shown)
    shown.page.get_by_role("button", name="-x").click()
    settled(shown)
    assert shown.js("scene.header.gravity") == [-9.81, 0]
    forces = ask(shown, do="query")["member_force"]
    heavy = dyad().with_(gravity=(-9.81, 0), nodes={**dyad().nodes, "C": kt.Node(at=(0.5, 0.6), mass=50.0)})
    wanted = dynamics.inverse(heavy, kinematics.from_arrays(heavy, [0.0], *still(heavy)), static=False)
    np.testing.assert_allclose(forces, wanted.data["member_force"].values[0], rtol=1e-9)
    clean(shown)


def test_edits_are_undone_and_done_again(show, served):
    shown = show(served["dyad"].address)
    undo, redo = (shown.page.get_by_role("button", name=name, exact=True) for name in ("Undo", "Redo"))
    assert undo.is_disabled() and redo.is_disabled()
    ask(shown, do="mass", node="C", mass=50.0)
    ask(shown, do="switch", member="left", to="rigid")
    assert undo.get_attribute("title") == "Undo making left rigid"
    undo.click()
    shown.until("kinetruss.live.setup.redo === 'making left rigid'")
    settled(shown)
    assert shown.js("scene.header.kinds") == ["driven", "driven"]
    shown.page.locator(".pane canvas").focus()
    shown.press("Control+z")
    shown.until("kinetruss.live.setup.masses.C === 5")
    assert undo.is_disabled()
    redo.click()
    shown.press("Control+y")
    shown.until("kinetruss.live.setup.members[0].role === 'rigid'")
    assert ask(shown, do="query")["values"].keys() == {"right"}
    clean(shown)


def still(model):
    x = kinematics.assemble(model)[None]
    return x, 0 * x, 0 * x


def test_key_frames_run_and_the_worst_instant_is_one_click_away(show, served):
    shown = show(served["tripod"].address)
    for value in (1.0, 1.2, 0.9):
        slide(shown, "LA", value)
        shown.page.get_by_role("button", name="Set key frame here").click()
    shown.page.get_by_role("button", name="Run", exact=True).click()
    shown.until("kinetruss.live.running")
    settled(shown)
    assert shown.js("app.lead.frames") == 201
    assert not shown.page.locator(".timebar").is_hidden()
    first = shown.page.locator(".controls table.numbers tr").nth(-3).locator("button")
    shown.page.get_by_role("button", name="beam-column").first.click()
    assert shown.js("app.picked.type") == "member"
    assert first.inner_text() in ("largest tension", "largest compression")
    shown.page.get_by_role("button", name="Back to the sliders").click()
    shown.until("!kinetruss.live.running")
    settled(shown)
    slide(shown, "LA", 1.1)
    assert ask(shown, do="query")["values"]["LA"] == pytest.approx(1.1, abs=3e-4)
    clean(shown)


def test_another_file_is_overwritten_only_after_a_second_click(show, served):
    other = served["dyad"].folder / "other.yaml"
    other.write_text("years of work")
    shown = show(served["dyad"].address)
    shown.page.get_by_label("file name").fill("other.yaml")
    shown.page.get_by_role("button", name="Save", exact=True).click()
    settled(shown)
    banner = shown.page.locator(".controls .banner")
    assert "other.yaml exists already" in banner.inner_text()
    assert other.read_text() == "years of work"
    banner.get_by_role("button", name="Overwrite").click()
    settled(shown)
    shown.until("document.querySelector('.controls .banner').textContent.startsWith('Written: other.yaml')")
    assert banner.get_by_role("button").count() == 0
    assert kt.read(other).nodes == kt.read(served["dyad"].folder / "model.yaml").nodes
    clean(shown)


@pytest.mark.parametrize(("width", "scheme"), [(1300, "dark"), (900, "light"), (420, "light")])
def test_nothing_runs_out_of_the_window(show, served, width, scheme):
    shown = show(served["tripod"].address, width=width, height=800, scheme=scheme)
    assert shown.js("document.documentElement.scrollWidth") <= width
    assert shown.js("document.querySelector('.controls').scrollWidth <= document.querySelector('.controls').clientWidth")
    assert shown.js("view.canvas.clientWidth") > 150


def test_the_page_says_when_the_studio_ends(show, tmp_path):
    one = serve(dyad(), tmp_path)
    shown = show(one.address)
    assert one.stop() == 0
    shown.until("kinetruss.live.closed")
    assert "has ended" in shown.page.locator(".controls .banner").inner_text()
    assert shown.js("[...document.querySelectorAll('.controls input, .controls button')].every((one) => one.disabled)")
    one.process.communicate()


def test_a_field_shows_what_is_reached_and_never_keeps_what_is_not(show, served):
    shown = show(served["tripod"].address)
    settled(shown)
    field = shown.page.get_by_label("value of LA in mm")
    for typed in ("99999", ""):
        field.fill(typed)
        field.press("Enter")
        settled(shown)
        shown.until("Math.abs(Number(document.querySelector('[data-drive=LA] input[type=number]').value) "
                    "- 1000 * kinetruss.live.controls.last.values.LA) < 1e-3")  # fmt: skip
    assert ask(shown, do="query")["values"]["LA"] == pytest.approx(1.3)  # the limit of the drive
    shown.page.locator("summary", has_text="Gravity, payload").click()
    gravity = shown.page.get_by_label("gravity z")
    gravity.fill("")
    gravity.press("Enter")
    shown.until("document.querySelector('.banner').textContent.includes('set back')")
    assert shown.page.get_by_label("gravity z").input_value() == "-9.81"
    mass = shown.page.get_by_label("payload in kg")
    mass.fill("-3")
    mass.press("Enter")
    shown.until("document.querySelector('[aria-label=\"payload in kg\"]').value === '20'")


def test_a_page_that_lost_its_studio_goes_on_with_its_changes(show, tmp_path):
    one = serve(dyad(), tmp_path)
    shown = show(one.address)
    slide(shown, "left", 0.9)
    shown.page.get_by_role("button", name="Set key frame here").click()
    ask(shown, do="mass", node="C", mass=50.0)
    forces = ask(shown, do="query")["member_force"]
    one.process.kill()
    one.process.communicate()
    shown.until("kinetruss.live.closed")
    assert "goes on with them" in shown.page.locator(".controls .banner").inner_text()
    again = start(tmp_path, str(tmp_path / "model.yaml"))
    try:
        assert again.address == one.address
        shown.until("!kinetruss.live.closed")
        assert shown.page.locator(".controls .banner").inner_text() == "The studio answers again."
        assert ask(shown, do="query")["member_force"] == pytest.approx(forces, rel=1e-9)
        assert shown.page.get_by_label("payload in kg").is_enabled()
        assert shown.js("kinetruss.live.controls.frames.frames.length") == 1
        slide(shown, "left", 0.8)
        assert ask(shown, do="query")["values"]["left"] == pytest.approx(0.8, abs=3e-4)
        reached = ask(shown, do="query")["values"]["left"]
        side = next((tmp_path / ".kinetruss").glob("model.page-*.json"))
        while json.loads(side.read_text())["values"]["left"] != reached:  # kept when the slider has rested
            shown.page.wait_for_timeout(50)
        shown.page.close()
        again.process.kill()
        again.process.communicate()
        again = start(tmp_path, str(tmp_path / "model.yaml"))
        other = show(again.address)  # a new page: it asks first
        assert ask(other, do="query")["values"]["left"] != reached
        go = other.page.get_by_role("button", name="Go on with them")
        go.click()
        other.until("kinetruss.live.controls.frames.frames.length === 1")
        settled(other)
        assert go.count() == 0
        assert ask(other, do="query")["values"]["left"] == reached
        assert other.complaints == []
    finally:
        again.process.kill()
        again.process.communicate()


@pytest.mark.parametrize("changed", [False, True])
def test_a_page_that_is_loaded_again_goes_on_with_its_changes(show, tmp_path, changed):
    """Also over a file that another program has changed meanwhile."""
    one = serve(dyad(), tmp_path)
    try:
        shown = show(one.address)
        if changed:
            file = tmp_path / "model.yaml"
            file.write_text(file.read_text(encoding="utf-8").replace("9.81", "1.62"), encoding="utf-8")
        ask(shown, do="mass", node="C", mass=50.0)
        slide(shown, "left", 0.9)
        forces = ask(shown, do="query")["member_force"]
        shown.page.wait_for_timeout(1000)  # the slider rests
        shown.page.reload()
        shown.page.wait_for_selector("#kinetruss[data-state]")
        settled(shown)
        assert ask(shown, do="query")["member_force"] == pytest.approx(forces, rel=1e-9)
        assert "goes on with its changes" in shown.page.locator(".controls .banner").inner_text()
        assert ask(shown, do="save", name="model.yaml", pose=False, frames=[], replace=False)["kind"] == (
            "exists" if changed else "saved"
        )
        other = show(one.address)  # another page begins with the file's model
        assert ask(other, do="query")["member_force"] != pytest.approx(forces, rel=1e-3)
        clean(other)
    finally:
        one.process.kill()
        one.process.communicate()
