"""Diagrams over the structure and symbols of supports, in the page of a result and in the drawing."""

from __future__ import annotations

from pathlib import Path

import pytest

import loaded_frames as frames
from hand import Hand
from kinetruss import viewer
from kinetruss.report.pictures.over_structure import of_run
from kinetruss.runs import run
from kinetruss.strength.curves import curves, only
from samples import fourbar
from served import serve

pytestmark = pytest.mark.slow


def labelled(found) -> list[tuple[str, float]]:
    """What is written of curves: links count once for each part."""
    rows = [(one.part, float(one.values[k])) for one in found.curves for k in one.extremes]
    return sorted(rows, key=lambda row: -abs(row[1]))


@pytest.fixture(scope="module")
def places(tmp_path_factory) -> dict[str, Path]:
    place = tmp_path_factory.mktemp("over")
    portal, space = (run(one, "rest") for one in (frames.portal(), frames.space()))
    return {"portal": viewer.write(portal, place / "portal.html"), "space": viewer.write(space, place / "space.html")}


def agree(shown, found) -> None:
    """Every value that a picture writes is that of the results; the largest of all is among them."""
    rows, labels = labelled(found), shown.js("app.over[0].labels")
    assert labels
    assert abs(labels[0]["value"]) == pytest.approx(abs(rows[0][1]), rel=1e-5)
    near = 1e-5 * abs(rows[0][1])  # of tops between stations, and of numbers with seven digits
    for one in labels:
        assert any(name == one["member"] and abs(value - one["value"]) <= near for name, value in rows), one


def test_the_page_draws_what_is_chosen_for_the_load_case_shown(show, places):
    portal = run(frames.portal(), "rest")
    shown = show(places["portal"], width=1000, height=700)
    assert shown.js("app.offered.map((one) => one.id)") == ["N", "V", "M", "deflection"]
    for case in ("snow", "wind"):
        shown.js(f"app.setCase('{case}')")
        for quantity in ("N", "V", "M", "deflection"):
            shown.page.select_option("select[aria-label=diagram]", quantity)
            shown.drawn()
            agree(shown, of_run(portal, quantity, case))
            assert (quantity == "deflection") == ("times as large" in shown.page.locator(".told").inner_text())
    shown.page.select_option("select[aria-label=diagram]", "")
    shown.drawn()
    assert shown.js("app.over[0].node.childElementCount") == 0
    assert shown.complaints == []


@pytest.mark.parametrize(("width", "scheme"), [(1000, "light"), (390, "dark")])
def test_values_do_not_cover_each_other_and_stay_in_the_picture(show, places, width, scheme):
    shown = show(places["space"], width=width, height=780, scheme=scheme)
    space = run(frames.space(), "rest")
    for quantity in ("M2", "M3", "torque"):
        shown.js(f"app.setDiagram('{quantity}')")
        shown.drawn()
        agree(shown, of_run(space, quantity))
        boxes, size = shown.js("app.over[0].boxes"), shown.js("[view.canvas.clientWidth, view.canvas.clientHeight]")
        for k, one in enumerate(boxes):
            assert one[0] >= -1 and one[1] >= -1 and one[2] <= size[0] + 1 and one[3] <= size[1] + 1
            assert all(one[2] <= b[0] or b[2] <= one[0] or one[3] <= b[1] or b[3] <= one[1] for b in boxes[:k])


def test_bars_of_a_mechanism_have_theirs_at_every_instant(show, tmp_path):
    model = fourbar()
    found = run(model, next(iter(model.runs)))
    shown = show(viewer.write(found, tmp_path / "turn.html"), width=1000, height=700)
    assert "deflection" not in shown.js("app.offered.map((one) => one.id)")
    forces = next(iter(found.forces.values()))
    kept = shown.js("Array.from(scene.time)")
    times = found.motion.whole["time"].values
    for k in (0, len(kept) // 3, len(kept) - 1):
        sample = int(abs(times - kept[k]).argmin())
        for quantity in ("N", "V", "M"):
            shown.js(f"(app.setDiagram('{quantity}'), app.goTo({k}))")
            shown.drawn()
            agree(shown, curves(model, only(forces, sample), quantity))


def test_the_drawing_draws_them_on_request_and_never_those_before_an_edit(show, tmp_path):
    one = serve(frames.simple(), tmp_path)
    try:
        shown = show(f"{one.address}draw/")
        hand = Hand(shown)
        marks = "[...document.querySelectorAll('[data-kind]')].map((one) => `${one.dataset.support} ${one.dataset.kind}`)"
        kinds = shown.page.evaluate(f"[...new Set({marks})].sort()")
        assert kinds == ["A pin", "B roller"]
        shown.page.select_option("select[aria-label=diagram]", "M")
        shown.until("kinetruss.draw.diagram.found")
        text = "[...document.querySelectorAll('.drawing .diagram text')].map((one) => one.textContent)"
        assert shown.page.evaluate(text) == ["20 kN m"]
        assert "side in tension" in shown.page.locator(".told").inner_text()
        # a load twice as large; between the edit and the answer nothing is shown
        shown.page.evaluate("kinetruss.draw.ask({do: 'set', path: ['loads', 'q', 'force'], value: [0, -20000]})")
        shown.until("kinetruss.draw.state.data.loads.q.force[1] === -20000 && kinetruss.draw.diagram.found")
        hand.settle()
        assert shown.page.evaluate(text) == ["40 kN m"]
    finally:
        one.process.kill()
        one.process.communicate()
