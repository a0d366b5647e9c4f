"""The page of kinetruss view, looked at and used in a browser."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import action_models
import kinetruss as kt
from kinetruss import strength, viewer
from kinetruss.display import limits_of
from samples import fourbar, tripod

pytestmark = pytest.mark.slow

BACK = np.array([0xF7, 0xF8, 0xFA])
SEQUENTIAL = ("#482878", "#3e4a89", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725")
DIVERGING = ("#053a7a", "#2b7bba", "#8fc1e3", "#d4d4d4", "#f2b279", "#d9662b", "#8c2d04")


@pytest.fixture(scope="module")
def pages(tmp_path_factory, turn, lift) -> dict[str, Path]:
    place = tmp_path_factory.mktemp("pages")
    return {
        "turn": viewer.write(turn, place / "turn.html"),
        "lift": viewer.write(lift, place / "lift.html", case="pushed"),
        "two": viewer.write(lift, place / "two.html", beside=turned(), labels=("light", "heavy")),
        "free": viewer.write(fourbar(drives={}, runs={}), place / "free.html"),
    }


def turned():
    """The same legs under half the gravity, sampled otherwise."""
    from kinetruss import runs

    return runs.run(tripod(61, gravity=(0, 0, -4.9)), "lift")


def pixels(shown) -> np.ndarray:
    """The picture as (height, width, 3)."""
    shown.drawn()
    box = shown.page.locator(".pane canvas").first.bounding_box()
    image = Image.open(io.BytesIO(shown.page.screenshot(clip=box)))
    return np.asarray(image.convert("RGB")).astype(int)


def wanted_colour(value: float, largest: float) -> np.ndarray:
    """The colour of a force by the table in the documentation."""
    table = np.array([[int(one[k : k + 2], 16) for k in (1, 3, 5)] for one in DIVERGING])
    place = (value / largest + 1) / 2 * (len(table) - 1)
    return np.array([np.interp(place, range(len(table)), column) for column in table.T])


def every_key(shown) -> None:
    keys = "c c C m m g l b h a a v v d r n n N p P w t / Escape 1 2 3 4 f i k j o , . x + - ? Escape"
    keys += " Home ArrowRight End ArrowLeft"
    shown.press(*(("Shift+" + key.lower()) if len(key) == 1 and key.isupper() else key for key in keys.split()))


@pytest.mark.parametrize("name", ["turn", "lift", "two", "free"])
def test_a_picture_comes_and_nothing_is_asked_of_the_network(show, pages, name):
    shown = show(pages[name])
    assert shown.js("window.kinetruss.ready")
    shown.press("h")  # without the grid
    not_blank(pixels(shown))
    if name in ("turn", "two"):
        every_key(shown)
    for label in ("Ghost", "Names", "Loads", "Grid", *["Paths"] * (name != "free"), "Panel", "dark or light", "help"):
        shown.page.get_by_role("button", name=label, exact=True).click()
    shown.press("Escape")
    shown.drawn()
    assert shown.requests == []
    assert shown.complaints == []


def not_blank(picture: np.ndarray) -> None:
    """Something of the size of a structure stands before the background."""
    other = np.abs(picture[150:] - BACK).max(axis=2) > 40
    assert other.mean() > 0.005
    rows, columns = np.nonzero(other)
    assert np.ptp(rows) > 100
    assert np.ptp(columns) > 150


def along(member: int, part: float) -> str:
    """Where a point of a member is on the screen, at a part of its length."""
    ends = [f"view.now[scene.ends[{2 * member + end}]][i]" for end in (0, 1)]
    return f"view.project([0, 1, 2].map((i) => {1 - part} * {ends[0]} + {part} * {ends[1]})).slice(0, 2)"


def test_colours_and_legend_are_those_of_the_forces(show, pages, turn):
    shown = show(pages["turn"])
    force = turn.forces["all"].data["member_force"].values
    largest = limits_of("diverging", force)[1]
    shown.press("a", "h", "l")
    for frame in (0, 13, 31):
        shown.js("app.goTo(given)", frame)
        picture = pixels(shown)
        for k, value in enumerate(force[frame]):
            wanted = wanted_colour(value, largest)
            assert shown.js("view.bars.colourOf(given)", k) == pytest.approx(wanted, abs=1.0)
            x, y = map(round, shown.js(along(k, 0.3)))
            seen = picture[y - 1 : y + 2, x - 1 : x + 2].reshape(-1, 3).mean(axis=0)
            # lit: darker or lighter than its own colour, but of the same hue
            assert seen / seen.max() == pytest.approx(wanted / wanted.max(), abs=0.17), (frame, k, value, seen, wanted)
    # and the legend says it in words and numbers
    text = shown.page.locator(".legend").inner_text()
    assert "Axial force" in text
    assert "compression" in text
    assert "tension" in text
    assert f"{largest:.3g}" in text
    shown.page.get_by_label("colour by").select_option("buckling")
    assert "no compression" in shown.page.locator(".legend").inner_text()


def test_keys_drive_time(show, pages):
    shown = show(pages["turn"])
    shown.press("ArrowRight", "ArrowRight", "Shift+ArrowRight", "ArrowLeft")
    assert shown.js("app.index") == 11
    shown.press("End")
    assert shown.js("view.frame") == 40
    shown.press("Home", "+", "-", "Space")
    assert shown.js("[app.speed, app.playing]") == [shown.js("app.speeds")[shown.js("app.speeds").index(0.1) - 1], True]
    shown.until("app.index > 3")
    shown.press("Space")
    assert not shown.js("app.playing")
    time = shown.js("app.lead.time[app.index]")
    assert float(shown.page.locator("output.time").inner_text().split()[0]) == pytest.approx(time, rel=1e-3)
    slider = shown.page.get_by_role("slider", name="time")
    slider.focus()
    shown.press("End")
    assert shown.js("app.index") == 40


def test_keys_pick_and_the_panel_follows(show, pages, lift):
    shown = show(pages["lift"])
    shown.press("n", "n")
    assert shown.page.locator(".inspector h2").inner_text().startswith("LB")
    shown.press("End")
    force = lift.forces["pushed"].data["member_force"].values[-1, 1]
    row = shown.page.locator(".values tr", has_text="Axial force").inner_text()
    assert f"{abs(force):.4g}"[:5] in row
    assert ("tension" if force > 0 else "compression") in row
    shown.press("Shift+p")
    assert shown.page.locator(".inspector h2").inner_text().startswith("T")
    shown.press("t")
    assert shown.js("view.traces.shown.map((node) => scene.nodes[node])") == ["T"]
    shown.press("Escape")
    assert shown.js("app.picked") is None
    shown.press("c", "c")
    assert shown.js("app.channel.id") == "utilisation"
    shown.press("/", *"lc")
    assert shown.page.locator(".table tbody tr").count() == 1
    shown.press("Enter")
    assert shown.js("app.picked.name") == "LC"


def test_the_pointer_picks_turns_and_approaches(show, pages):
    shown = show(pages["lift"])
    for member in range(3):
        x, y = shown.js(along(member, 0.4))
        shown.page.locator(".pane canvas").click(position={"x": x, "y": y})
        assert shown.js("app.picked") == {"type": "member", "name": ("LA", "LB", "LC")[member]}
    x, y = shown.js("view.project(view.now[3])")[:2]
    shown.page.locator(".pane canvas").click(position={"x": x, "y": y})
    assert shown.js("app.picked") == {"type": "node", "name": "T"}
    shown.page.locator(".pane canvas").click(position={"x": 15, "y": 380})
    assert shown.js("app.picked") is None
    shown.page.locator(".table").get_by_role("button", name="LC").click()
    assert shown.js("app.picked.name") == "LC"
    # dragging turns, the wheel approaches
    before = shown.js("view.camera.position.toArray()")
    box = shown.page.locator(".pane canvas").bounding_box()
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    shown.page.mouse.move(*middle)
    shown.page.mouse.down()
    shown.page.mouse.move(middle[0] + 60, middle[1] + 20, steps=3)
    shown.page.mouse.up()
    after = shown.js("view.camera.position.toArray()")
    assert np.linalg.norm(np.subtract(after, before)) > 0.1
    shown.page.mouse.wheel(0, -300)
    shown.until(f"Math.hypot(...view.camera.position.toArray()) < {np.linalg.norm(after)} - 0.01")
    shown.press("1")
    assert shown.js("view.camera.position.toArray()") == pytest.approx(before)


@pytest.mark.parametrize("name", ["turn", "lift"])
def test_embedded_numbers_are_those_of_the_results(show, pages, request, name):
    run = request.getfixturevalue(name)
    shown = show(pages[name])
    case = run.forces["pushed" if name == "lift" else "all"].data
    known = {one: run.motion.data[one].values for one in ("position", "velocity", "acceleration")}
    known |= {one: case[one].values for one in ("member_force", "joint_force", "reaction", "drive_force")}
    for one, values in known.items():
        found = np.array(shown.js("[...scene.arrays[given].data]", one))
        assert np.array_equal(found, values.astype("f4").reshape(-1).astype(float)), one
    used = viewer.scene(run, case=case.attrs["load_case"]).arrays["stress"]
    found = np.array(shown.js("[...scene.arrays.stress.data]"))
    assert np.array_equal(found, used.astype("f4").reshape(-1).astype(float), equal_nan=True)


DIAGRAM = "(() => { app.goTo(given[1]); return app.diagrams(given[0]); })()"


@pytest.mark.parametrize("name", ["turn", "lift"])
def test_diagrams_along_a_member_are_those_of_strength(show, pages, request, name):
    run = request.getfixturevalue(name)
    shown = show(pages[name])
    forces = run.forces["pushed" if name == "lift" else "all"]
    sections = strength.sections(run.model, forces, stations=41)
    stress = strength.stresses(run.model, sections)["von_mises"]
    for frame in (0, 9, 33):
        for member in run.model.members:
            found = shown.js(DIAGRAM, [member, frame])
            place = {part: [i for i, one in enumerate(found["parts"]) if one == part] for part in set(found["parts"]) - {""}}
            for part, at in place.items():
                compare(found, at, sections.data.isel(time=frame).sel(part=part), stress.isel(time=frame).sel(part=part))


def compare(found, at, section, stress) -> None:
    given = {"T": section.section_T.values, "stress": stress.values}
    given |= {f"V{one}": section.section_V.sel(transverse=one).values for one in section.transverse.values}
    given |= {f"M{one}": section.section_M.sel(moment=one).values for one in section.moment.values}
    largest = max(np.abs(values).max() for key, values in given.items() if key != "stress")
    for key, values in given.items():
        seen = np.array([found[key][i] for i in at])
        scale = np.abs(values).max() if key == "stress" else largest
        assert seen == pytest.approx(values, abs=2e-5 * scale), key
    assert found["s"][at[-1]] - found["s"][at[0]] == pytest.approx(float(section.part_length), rel=1e-5)


@pytest.mark.parametrize("lean", [False, True])
@pytest.mark.parametrize(
    "way",
    [
        "by_hinge",
        "scissor_by_a_node",
        "clamped",
        "loaded",
        "screw",
        "telescope",
        "loaded_telescope",
        "elbow",
        "loaded_along",
        "telescope_under_a_load",
    ],
)
def test_diagrams_of_bars_that_are_driven_pinned_and_loaded(show, tmp_path, way, lean):
    """Where couples, pins, loads and bodies act on bars the page shows what strength has; also with joint forces left out."""
    rng = np.random.default_rng(5)
    model = getattr(action_models, way)(rng)
    forces = action_models.moved(model, rng, samples=3)
    full = viewer.scene(forces, model=model)
    arrays = {name: values for name, values in full.arrays.items() if name != "joint_force" or not lean}
    path = tmp_path / "page.html"
    path.write_text(viewer.page(viewer.Scene(header=full.header, arrays=arrays)))
    shown = show(path)
    sections = strength.sections(model, forces, stations=41)
    stress = strength.stresses(model, sections)["von_mises"]
    for member in model.members:
        found = shown.js(DIAGRAM, [member, 1])
        for part in set(found["parts"]) - {""}:
            at = [i for i, one in enumerate(found["parts"]) if one == part]
            compare(found, at, sections.data.isel(time=1).sel(part=part), stress.isel(time=1).sel(part=part))


BODY = """((body) => ({
    axes: body.state.axes, ends: body.terms.slice(0, 2).map((one) => one.force), all: body.terms.map((one) => one.force),
}))(app.freeBody(given))"""


def test_end_forces_left_out_of_a_large_scene_are_formed_again(show, tmp_path, lift):
    """A scene without joint forces gives the same free bodies, from accelerations and member forces."""
    full = viewer.scene(lift, case="pushed")
    arrays = {name: values for name, values in full.arrays.items() if name != "joint_force"}
    path = tmp_path / "lean.html"
    path.write_text(viewer.page(viewer.Scene(header=full.header, arrays=arrays)))
    shown = show(path)
    joint = lift.forces["pushed"].data["joint_force"].values
    for frame in (0, 20):
        shown.js("app.goTo(given)", frame)
        for k, member in enumerate(lift.model.members):
            body = shown.js(BODY, member)
            seen = np.array(body["ends"]) @ np.array(body["axes"])
            assert seen == pytest.approx(joint[frame, k], abs=2e-5 * np.abs(joint).max())
            assert np.sum(body["all"][:3], axis=0) == pytest.approx(body["all"][3], abs=1e-4 * np.abs(joint).max())


def test_two_runs_move_together_in_the_same_colours(show, pages, lift):
    shown = show(pages["two"], width=1200)
    assert shown.js("app.views.length") == 2
    shown.js("app.goTo(30)")
    times = shown.js("app.views.map((one) => one.scene.time[one.frame])")
    assert times == pytest.approx([times[0]] * 2, abs=0.02)
    assert shown.js("app.views[0].limits") == shown.js("app.views[1].limits")
    shown.press("3")
    assert shown.js("app.views[0].camera.position.x") == pytest.approx(shown.js("app.views[1].camera.position.x"))
    shown.press("n")
    assert shown.page.locator(".inspector h3").all_inner_texts() == ["light", "heavy"]
    assert shown.page.locator(".pane .label").all_inner_texts() == ["light", "heavy"]
    assert "Axial force, heavy" in shown.page.locator(".table thead").inner_text().replace("\n", " ")
    # load cases are chosen in the page
    for case in ("pushed", "standing"):
        shown.page.get_by_label("load case").select_option(case)
        shown.js("app.goTo(17)")
        force = lift.forces[case].data["member_force"].values[17]
        seen = shown.js("[0, 1, 2].map((k) => scene.value('force', view.frame, k))")
        assert seen == force.astype("f4").astype(float).tolist()
        assert shown.js("view.loads.arrows.length") == (1 if case == "pushed" else 0)
    shown.press("e")
    assert shown.js("app.views.map((one) => one.scene.header.load_case)") == ["pushed", "pushed"]
    assert shown.complaints == []


def test_a_mechanism_swings(show, pages):
    shown = show(pages["free"])
    shown.press("m")
    assert shown.js("app.mode") == 0
    start = shown.js("scene.position(0, 1)")
    shown.until(f"Math.hypot(view.now[1][0] - {start[0]}, view.now[1][1] - {start[1]}) > 0.005")
    assert shown.js("view.now[0]") == pytest.approx(shown.js("scene.position(0, 0)"))
    shown.press("m")
    assert shown.js("view.now[1]") == pytest.approx(start)


def test_bodies_are_seen_as_faces(show, tmp_path):
    corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    solid = kt.Model(nodes=corners, fixed=("O",), bodies={"b": kt.Body(nodes=tuple(corners), mass=2.0)})
    bare = kt.Model(nodes=corners, fixed=("O",), bars={name: bar.ends for name, bar in solid.whole.bars.items()})
    seen = []
    for name, model in (("solid", solid), ("bare", bare)):
        shown = show(viewer.write(model, tmp_path / f"{name}.html"))
        shown.press("r")  # without sections, triangles of rigid bars are shown first
        seen.append(pixels(shown))
        assert shown.complaints == []
        assert shown.js("view.bodies.hulls.length") == (4 if model is solid else 0)
    assert (np.abs(seen[0] - seen[1]).max(axis=2) > 20).mean() > 0.03  # faces between the same bars


def test_faces_of_a_solid_have_the_colours_of_their_stress(show, tmp_path):
    box = kt.library.meshes.box(size=(2.0, 1.0, 1.0), cells=(2, 1, 1))
    load = {"tip": kt.NodalForce(node=box.nearest((2, 1, 1)), force=(0, 0, -1e6))}
    steel = kt.Material(E=210e9, poisson=0.3, density=0.0)
    model = kt.Model(nodes=box.nodes, material=steel, fixed=box.at(x=0.0), solids={"b": box.solid()}, loads=load)
    rest = kt.statics.equilibrium(model)
    told = viewer.scene(rest, model=model)
    shown = show(viewer.write(rest, tmp_path / "solid.html", model=model))
    stress = told.arrays["skin_stress"][0]
    assert shown.js("app.channel.id") == "stress"
    limits = limits_of("sequential", stress)
    assert shown.js("app.limits") == list(limits)
    table = np.array([[int(one[k : k + 2], 16) for k in (1, 3, 5)] for one in SEQUENTIAL])
    for face, value in enumerate(stress):
        place = value / limits[1] * (len(table) - 1)
        wanted = [np.interp(place, range(len(table)), column) for column in table.T]
        assert shown.js("view.skins.colourOf(given)", face) == pytest.approx(wanted, abs=1.0)
    shown.press("h", "l", "b")
    not_blank(pixels(shown))
    every_key(shown)
    assert (shown.requests, shown.complaints) == ([], [])


def test_a_ring_lies_about_the_axis_of_a_hinge(show, tmp_path):
    robot = kt.library.mechanisms.robot()
    shown = show(viewer.write(robot, tmp_path / "robot.html"))
    rings = shown.js("""view.drives.shown.filter(({ drive }) => drive.kind === "hinge").map(({ drive, mark }) => {
        const [p, q] = drive.axis.map((node) => view.now[node]), u = q.map((x, i) => x - p[i]), L = Math.hypot(...u);
        const up = mark.up.clone().set(0, 0, 1).applyQuaternion(mark.quaternion).toArray();
        const along = up.reduce((sum, x, i) => sum + x * u[i] / L, 0);
        return [along, Math.hypot(...mark.position.toArray().map((x, i) => x - (p[i] + q[i]) / 2))];
    })""")
    assert len(rings) == 2
    for cosine, apart in rings:
        assert (cosine, apart) == pytest.approx((1, 0), abs=1e-6)
    assert "motor" in shown.page.locator(".legend").inner_text()
    assert shown.complaints == []


def test_a_model_of_nodes_alone_is_shown(show, tmp_path):
    shown = show(viewer.write(kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=("A",)), tmp_path / "nodes.html"))
    every_key(shown)
    shown.press("Escape", "m")
    shown.until("app.mode === -1")
    shown.drawn()
    shown.until("!view.waiting")  # nothing is left to be drawn where nothing moves
    assert len(np.unique(pixels(shown).reshape(-1, 3), axis=0)) > 10
    assert (shown.requests, shown.complaints) == ([], [])


BOXES = """(node) => [...node.querySelectorAll("button, select, input, h1")].filter((one) => one.offsetParent).map((one) => {
    const box = one.getBoundingClientRect();
    return [box.left, box.top, box.right, box.bottom];
})"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_overlaps_or_sticks_out(show, pages, scheme):
    shown = show(pages["lift"], scheme=scheme)
    assert shown.js("app.theme") == scheme
    for width, height in ((1280, 800), (900, 600), (400, 780)):
        shown.page.set_viewport_size({"width": width, "height": height})
        shown.until(f"innerWidth === {width} && view.canvas.clientWidth <= {width} && view.canvas.width > 0")
        assert shown.js("document.scrollingElement.scrollWidth") <= width
        boxes = shown.page.locator(".toolbar").evaluate(BOXES)
        for k, one in enumerate(boxes):
            for other in boxes[:k]:
                assert one[0] >= other[2] or one[2] <= other[0] or one[1] >= other[3] or one[3] <= other[1], (one, other)
    back = pixels(shown)[-40, 30]
    assert (back.mean() < 60) == (scheme == "dark")


def test_names_and_titles_stay_text(show, tmp_path):
    bold = fourbar(title="<img src=x> & more", runs={}, drives={})
    bars = {f"<b>{name}": bar for name, bar in bold.bars.items()}
    shown = show(viewer.write(bold.with_(bars=bars), tmp_path / "evil.html"))
    assert shown.page.locator("h1").inner_text() == "<img src=x> & more"
    shown.press("n")
    assert shown.page.locator(".inspector h2").inner_text().startswith("<b>crank")
    assert shown.page.locator("#kinetruss :is(img, b b)").count() == 0
    assert (shown.requests, shown.complaints) == ([], [])


def test_a_damaged_page_says_so(show, tmp_path, turn):
    text = viewer.page(viewer.scene(turn))
    mark = 'data-label="turn">'
    place = text.index(mark) + len(mark)
    path = tmp_path / "damaged.html"
    path.write_text(text[:place] + text[place + 400 :])
    shown = show(path)
    assert shown.page.locator("#kinetruss").get_attribute("data-state") == "failed"
    assert "cannot be shown" in shown.page.locator("#kinetruss").inner_text()


def test_from_afar_bars_are_lines_of_their_colour_and_not_black(show, pages):
    shown = show(pages["lift"])
    solid = "[view.bars.rods, view.bars.balls, ...view.bars.rims.meshes].map((one) => one.visible)"
    shown.drawn()
    assert set(shown.js(solid)) == {True}
    shown.page.add_style_tag(content=".names, .pane svg, .pane .name { display: none }")
    shown.js("view.orbit(0, 0, 15)")
    shown.drawn()
    assert set(shown.js(solid)) == {False}
    box = shown.page.locator(".pane canvas").first.bounding_box()
    shown.js("(view.grid.visible = false, view.loads.group.visible = false, view.supports.mesh.visible = false, view.render())")
    middle = {"x": box["x"] + box["width"] / 2 - 20, "y": box["y"] + box["height"] / 2 - 20, "width": 40, "height": 40}
    image = np.asarray(Image.open(io.BytesIO(shown.page.screenshot(clip=middle))).convert("RGB")).astype(int)
    drawn = image[np.abs(image - BACK).sum(axis=2) > 60]
    assert len(drawn) > 3
    assert (np.ptp(drawn, axis=1) > 30).mean() > 0.3  # coloured, where outlines are grey
    shown.js("view.orbit(0, 0, 1 / 15)")
    shown.drawn()
    assert set(shown.js(solid)) == {True}
