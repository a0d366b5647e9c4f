"""What a reader sees first: the verdict, names, stripes, links, paths, on a phone and without WebGL."""

import itertools

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import runs, viewer
from kinetruss.display import OVER, rgb
from samples import fourbar, tripod

pytestmark = pytest.mark.slow

NO_WEBGL = """const asked = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.startsWith("webgl") ? null : asked.call(this, kind, ...more);
};"""
NAMES = """() => [...document.querySelectorAll(".names span")].filter((one) => one.style.visibility !== "hidden")
  .map((one) => one.getBoundingClientRect()).map((b) => [b.left, b.top, b.right, b.bottom])"""
SIZES = """[...document.querySelectorAll("button:not(.link), select")].filter((one) => one.offsetParent)
  .map((one) => one.getBoundingClientRect()).map((b) => Math.min(b.width, b.height))"""
SHADES = """(() => {
  const { width, height } = view.canvas, { data } = view.canvas.getContext("2d").getImageData(0, 0, width, height);
  return new Set(new Uint32Array(data.buffer)).size;
})()"""


def braced(**more) -> kt.Model:
    """A braced square: six bars share what five could carry; without yield strength."""
    corners = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    bars = {a + b: (a, b) for a, b in ("AB", "BC", "CD", "DA", "AC", "BD")}
    given = {
        "section": kt.Tube(outer=0.02, inner=0.016), "material": kt.Material(E=70e9, density=0.0),
        "loads": {"pull": kt.NodalForce(node="C", force=(100.0, 0))},
    }  # fmt: skip
    return kt.Model(nodes=corners, fixed={"A": "xy", "B": "y"}, bars=bars, **(given | more))


def test_the_verdict_leads_to_what_governs(show, tmp_path, lift):
    shown = show(viewer.write(lift, tmp_path / "lift.html"))
    told = viewer.scene(lift).header["verdict"]
    strip = shown.page.locator(".verdict")
    assert told["text"] in strip.inner_text()
    strip.get_by_role("button").click()
    rows = [*lift.verdict.table(), *(row for demand in lift.demand.values() for row in demand.table())]
    worst = max((row for row in rows if row.checked), key=lambda row: row.utilisation)
    assert shown.js("app.picked.name") == worst.member == told["governing"]["member"]
    assert shown.js("scene.time[app.index]") == pytest.approx(worst.time)
    assert shown.js("scene.header.load_case") == told["governing"]["load_case"]
    assert f"{100 * worst.utilisation:.3g} %" in strip.inner_text()
    assert shown.complaints == []


def test_an_overload_is_red_and_what_was_not_checked_is_striped(show, tmp_path):
    steel = kt.Material(E=210e9, density=7850, yield_strength=235e6)
    heavy = tripod(41, material=steel, loads={"push": kt.NodalForce(node="T", force=(0, 0, -4e6))}, load_cases={})
    shown = show(viewer.write(runs.run(heavy, "lift"), tmp_path / "heavy.html"))
    strip = shown.page.locator(".verdict")
    assert "Over capacity" in strip.inner_text()
    red = ", ".join(str(int(one)) for one in rgb(OVER))
    assert shown.js("getComputedStyle(document.querySelector('.verdict')).backgroundColor") == f"rgb({red})"
    model = braced()
    shown = show(viewer.write(kt.statics.at_poses(model, [{}]), tmp_path / "braced.html", model=model))
    assert "Strength not fully checked: 6 of 6 parts unchecked" in shown.page.locator(".verdict").inner_text()
    assert shown.page.locator("td.hatched", has_text="†").count() == 6
    assert shown.js("scene.members.every((_, k) => view.bars.hatchOf(k))")
    shown.page.get_by_label("colour by").select_option("utilisation")
    utilisation = viewer.scene(kt.statics.at_poses(model, [{}]), model=model).arrays["utilisation"][0]
    cells = shown.page.locator(".table tbody tr").evaluate_all("rows => rows.map((row) => row.children[3].textContent)")
    assert [one == "-" for one in cells] == np.isnan(utilisation).tolist()
    assert any(one == "-" for one in cells)
    assert shown.complaints == []


def test_names_cover_no_other_name(show, tmp_path):
    model = kt.library.vgt.double_octahedral(bays=1)
    shown = show(viewer.write(model, tmp_path / "bay.html"), width=760, height=560)
    if not shown.js("app.shown.names"):
        shown.press("a")
    for key in ("1", "2", "3"):
        shown.press(key)
        shown.drawn()
        found = shown.page.evaluate(NAMES)
        assert len(found) > 0.6 * (len(model.nodes) + len(model.members))
        for a, b in itertools.combinations(found, 2):
            assert a[2] <= b[0] + 0.5 or b[2] <= a[0] + 0.5 or a[3] <= b[1] + 0.5 or b[3] <= a[1] + 0.5


def test_paths_of_nodes_are_switched(show, tmp_path, turn):
    shown = show(viewer.write(turn, tmp_path / "turn.html"))
    names = "view.traces.shown.map((node) => scene.nodes[node])"
    shown.page.get_by_role("button", name="Paths").click()
    assert shown.js(names) == ["B", "C"]  # the coupler's ends; A and D are held
    path = turn.motion.position.values[:, 2]
    drawn = shown.js("[...view.traces.lines.get(2).geometry.attributes.position.array]")
    np.testing.assert_allclose(np.reshape(drawn, (-1, 3))[:, :2], path, atol=1e-6)
    shown.page.get_by_role("button", name="Paths").click()
    assert shown.js(names) == []
    shown.js("app.pick({type: 'node', name: 'C'})")
    shown.page.locator("button.trace").click()
    assert shown.js(names) == ["C"]
    assert shown.page.locator("button.trace").get_attribute("aria-pressed") == "true"


def test_rectangles_and_bodies_have_their_shapes(show, tmp_path):
    flat = fourbar(section=kt.Rectangle(width=0.02, height=0.005))
    shown = show(viewer.write(flat, tmp_path / "flat.html"))
    assert shown.js("[view.bars.rods.count, view.bars.boxes.count]") == [0, 3]
    matrix = np.array(shown.js("[...view.bars.boxes.instanceMatrix.array.slice(0, 16)]")).reshape(4, 4)
    high, wide = np.linalg.norm(matrix[0, :3]), np.linalg.norm(matrix[2, :3])
    assert wide / high == pytest.approx(4.0)  # the width lies across the plane
    assert abs(matrix[2, 2]) == pytest.approx(wide)
    assert np.linalg.norm(matrix[1, :3]) == pytest.approx(0.1)  # the crank's length
    andrews = kt.library.mechanisms.andrews()
    shown = show(viewer.write(andrews, tmp_path / "andrews.html"))
    assert shown.js("view.bodies.plates.length") == len(viewer.scene(andrews).header["bodies"])
    # both ends of each link lie on its plate
    far = shown.js("""Math.max(...view.bodies.plates.flatMap(({ body, plate }) => [0, 1].map((end) => {
        plate.updateMatrixWorld();
        const at = plate.worldToLocal(plate.position.clone().set(...view.now[scene.ends[2 * body.member + end]]));
        const box = plate.children[0].geometry;
        box.computeBoundingBox();
        return box.boundingBox.distanceToPoint(at);
    })))""")
    assert far == 0
    assert shown.complaints == []


def test_fingers_find_large_buttons_and_no_keys(show, tmp_path, lift):
    shown = show(viewer.write(lift, tmp_path / "lift.html"), 390, 844, has_touch=True, is_mobile=True)
    assert min(shown.js(SIZES)) >= 44
    assert shown.js("[...document.querySelectorAll('[title]')].filter((one) => /\\\\([A-Z?]\\\\)/.test(one.title)).length") == 0
    assert shown.js("document.querySelectorAll('kbd').length") == 0
    assert shown.js("document.documentElement.scrollWidth") <= 390
    shown.page.get_by_role("button", name="help").click()
    assert "tap to pick" in shown.page.get_by_role("dialog").inner_text()
    assert shown.complaints == []


def test_without_webgl_there_are_the_table_and_a_picture(show, tmp_path, lift):
    shown = show(viewer.write(lift, tmp_path / "lift.html"), script=NO_WEBGL)
    assert shown.js("app.flat")
    assert shown.page.locator(".table tbody tr").count() == len(lift.model.members)
    shown.drawn()
    assert shown.js(SHADES) > 10
    shown.press("End", "n", "2", "g", "y", "c", "d", "i", ".", "Escape")
    shown.drawn()
    assert shown.js("app.index") == 40
    assert shown.complaints == []


def test_a_live_page_that_nobody_answers_shows_its_still(show, tmp_path):
    path = tmp_path / "still.html"
    path.write_text(viewer.live_page("still", still=viewer.scene(fourbar())), encoding="utf-8")
    shown = show(path)
    shown.until("window.kinetruss.ready")
    assert "run the notebook" in shown.page.inner_text("body")
    assert shown.js("scene.members.length") == 3


def test_a_bent_beam_follows_its_deflection(show, tmp_path):
    """w = -P s^2 (3 l - s)/(6 E I) of a cantilever under a force at its tip; names and numbers are those of the beam."""
    force, stiffness = 1e-3, 200e9 * 0.01 * 0.02**3 / 12
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], beams={"arm": ("A", "B")}, material=kt.Material(E=200e9, density=0.0),
        section=kt.Rectangle(width=0.01, height=0.02), loads={"P": kt.NodalForce(node="B", force=(0, -force))},
    )  # fmt: skip
    shown = show(viewer.write(kt.statics.equilibrium(model), tmp_path / "arm.html", model=model))
    points = np.array(shown.js("scene.curves.points(view.now, scene.members.indexOf('arm'))"))
    s = np.linspace(0, 1, 13)
    np.testing.assert_allclose(points[:, 1], -force * s**2 * (3 - s) / (6 * stiffness), atol=1e-5 * force / (3 * stiffness))
    assert shown.js("[view.bars.rods.count, view.bars.boxes.count]")[1] == 12
    assert shown.page.locator(".title p").inner_text() == "equilibrium · 1 member, 2 nodes"
    shown.js("app.pick({type: 'member', name: 'arm'})")
    assert shown.page.locator(".inspector canvas[aria-label='Bending moment M']").count() == 1
    assert shown.page.locator(".inspector .freebody").count() == 0
    assert shown.complaints == []


def test_everything_that_moves_is_in_the_picture_and_fills_it(show, tmp_path, lift):
    shown = show(viewer.write(lift, tmp_path / "lift.html"))
    seen = np.array(
        shown.js("""Array.from({ length: scene.frames }, (_, frame) =>
        scene.nodes.map((_, node) => view.project(scene.position(frame, node)).slice(0, 2))).flat()""")
    )
    size = np.array(shown.js("[view.canvas.clientWidth, view.canvas.clientHeight]"))
    assert (seen >= 0).all()
    assert (seen <= size).all()
    assert (np.ptp(seen, axis=0) / size).max() > 0.45
