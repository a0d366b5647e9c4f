"""What the page says of what it does not know, of what is not unique, of short runs, and to those who use keys."""

from __future__ import annotations

import pytest

import kinetruss as kt
from kinetruss import runs, viewer
from samples import tripod

pytestmark = pytest.mark.slow

TUBE = kt.Tube(outer=0.02, inner=0.016)
UNKNOWN = kt.Material(E=70e9, density=2700)


def square(**changes) -> kt.Model:
    """A braced square that is turned: redundant, and its yield strength unknown."""
    nodes = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    bars = {a + b: kt.Bar(ends=(a, b), section=TUBE, material=UNKNOWN) for a, b in ("AB", "BC", "CD", "DA", "AC", "BD")}
    fields = {
        "title": "square", "nodes": nodes, "fixed": ["A"], "bars": bars, "drives": {"turn": kt.AngleDrive("AB")},
        "loads": {"pull": kt.NodalForce(node="C", force=(200.0, 0))},
        "runs": {"turn": kt.Run(trajectory=kt.Quintic(moves={"turn": (0.0, 0.4)}, duration=0.03), samples=31)},
    }  # fmt: skip
    return kt.Model(**fields | changes)


@pytest.fixture(scope="module")
def short() -> runs.RunResult:
    return runs.run(square(), "turn")


def test_a_run_of_30_ms_plays_in_seconds(show, short, tmp_path):
    shown = show(viewer.write(short, tmp_path / "view.html"))
    speed = shown.js("app.speed")
    assert 3 <= 0.03 / speed <= 12
    assert str(speed) in [one.split("×")[0] for one in shown.page.get_by_label("speed").locator("option").all_inner_texts()]
    shown.press("Space")
    shown.until("app.index > 2")
    assert shown.js("app.index") < 31 or not shown.js("app.playing")
    shown.press("Space", "+")
    assert shown.js("app.speed") > speed


def test_what_is_not_checked_and_what_is_not_unique_is_said(show, short, tmp_path):
    shown = show(viewer.write(short, tmp_path / "view.html"))
    head, *_ = short.forces["all"].data.attrs["not_unique"]
    table = shown.page.locator(".table")
    assert "not unique" in table.inner_text()
    assert "†" in table.locator(f'tr[data-name="{head}"]').inner_text()
    assert "not unique" in shown.page.locator(".legend").inner_text()
    sure = shown.js("[...scene.members.keys()].filter((k) => !scene.unsure.has(k))")
    grey = shown.js("view.bars.colourOf(scene.members.indexOf(given))", head)
    assert max(grey) - min(grey) < 255 * 0.5
    assert len(sure) < 6
    shown.page.get_by_label("colour by").select_option("utilisation")
    assert "not checked" in shown.page.locator(".legend").inner_text()
    tension = shown.js("scene.members.findIndex((_, k) => scene.value('force', view.frame, k) > 0)")
    assert shown.js("Number.isNaN(scene.value('utilisation', view.frame, given))", tension)
    shown.js("app.pick({type: 'member', name: scene.members[given]})", tension)
    text = shown.page.locator(".inspector").inner_text()
    assert "yield: no yield strength" in text
    assert "not checked" in text
    assert shown.complaints == []


def test_worst_of_the_run_stands_in_the_heading(show, tmp_path):
    run = runs.run(square(material=None), "turn")
    scene = viewer.scene(run)
    header = scene.header | {
        "channels": [{**one, "over_run": one["id"] in ("stress", "buckling")} for one in scene.header["channels"]]
    }
    page = tmp_path / "view.html"
    page.write_text(viewer.page(viewer.Scene(header=header, arrays=scene.arrays)), encoding="utf-8")
    shown = show(page)
    heads = [one.replace("\n", " ") for one in shown.page.locator(".table thead th").all_inner_texts()]
    assert "Axial force now (kN)" in heads
    assert "Stress worst of run (GPa)" in heads


def test_two_runs_stand_side_by_side_within_the_panel(show, short, tmp_path):
    other = runs.run(square(title="another", loads={}), "turn")
    page = viewer.write(short, tmp_path / "two.html", beside=other, labels=("loaded", "empty"))
    shown = show(page, width=1200)
    heads = shown.page.locator(".table thead th").all_inner_texts()
    assert [one.split("\n")[0] for one in heads[1:]] == ["Axial force, loaded", "Axial force, empty"]
    scroll = "document.querySelector('.table .scroll')"
    assert shown.js(f"{scroll}.scrollWidth <= {scroll}.clientWidth + 1")
    shown.page.get_by_label("colour by").select_option("stress")
    assert "Stress, empty" in shown.page.locator(".table thead").inner_text().replace("\n", " ")
    title = shown.page.locator(".toolbar .title").inner_text()
    assert "square | another" in title
    assert "loaded: run turn" in title
    assert "empty: run turn" in title


def test_one_member_is_one_member(show, tmp_path):
    nodes = {"A": (0, 0), "B": (1, 0)}
    model = kt.Model(nodes=nodes, fixed=["A"], bars={"a": ("A", "B")}, drives={"turn": kt.AngleDrive("a")})
    assert "1 member, 2 nodes" in show(viewer.write(model, tmp_path / "one.html")).page.locator(".toolbar").inner_text()


def test_the_help_keeps_the_focus_and_gives_it_back(show, short, tmp_path):
    shown = show(viewer.write(short, tmp_path / "view.html"))
    shown.page.get_by_label("colour by").focus()
    shown.js("app.toggleHelp()")
    dialog = shown.page.get_by_role("dialog")
    assert dialog.get_attribute("aria-modal") == "true"
    for _ in range(5):
        shown.press("Tab")
        assert shown.js("app.help.contains(document.activeElement)")
    shown.press("Shift+Tab")
    assert shown.js("app.help.contains(document.activeElement)")
    shown.press("Escape")
    assert shown.js("document.activeElement.getAttribute('aria-label')") == "colour by"


def test_pressure_is_one_short_arrow_a_node_and_the_panel_says_what_presses(show, tmp_path):
    mesh = kt.library.meshes.mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 0.2)],
                                  [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])  # fmt: skip
    held = dict.fromkeys(mesh.names[:4], "xyz")
    loads = {f"p{k}": kt.Pressure(face=tuple(mesh.names[n] for n in one), pressure=2e4) for k, one in enumerate(mesh.elements)}
    material = kt.Material(E=70e9, poisson=0.3, density=0.0)
    model = kt.Model(
        nodes=mesh.nodes, fixed=held, material=material, membranes={"skin": mesh.membrane(thickness=1e-3)}, loads=loads
    )
    scene = viewer.scene(model)
    assert sorted(one["node"] for one in scene.header["loads"]) == [0, 1, 2, 3, 4]
    assert all(one["name"] == "pressure" for one in scene.header["loads"])
    area = sum(abs(scene.arrays["load_force"][0, :, 2])) / 2e4
    assert area == pytest.approx(1.0)  # seen from above the roof covers a square metre
    shown = show(viewer.write(model, tmp_path / "roof.html"))
    assert shown.js("view.loads.arrows.length") == 5
    panel = shown.page.locator(".inspector").inner_text()
    assert "20" in panel
    assert "kPa on 4 faces" in panel
    assert "5" in panel


def test_a_member_beyond_buckling_raises_an_alarm():
    from kinetruss.studio import Session

    slender = kt.Tube(outer=0.004, inner=0.003)
    nodes = {"A": (0.5, 0, 0), "B": (-0.25, 0.433, 0), "C": (-0.25, -0.433, 0), "T": kt.Node(at=(0, 0, 0.9), mass=20.0)}
    bars = {"L" + end: kt.Bar(ends=(end, "T"), kind="driven", section=slender, material=UNKNOWN) for end in "ABC"}
    session = Session(kt.Model(nodes=nodes, fixed=("A", "B", "C"), bars=bars, gravity=(0, 0, -9.81)))
    alarms = session.instant().alarms
    assert len(alarms) == 3
    assert all("buckles" in one for one in alarms)
    assert Session(tripod()).instant().alarms == []
