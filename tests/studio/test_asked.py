"""Linkages asked for in a drawing, drawings to begin with, and files to take away, without a network."""

from __future__ import annotations

import ast
import io
import json
import re
import time

import numpy as np
import pypdf
import pytest

import drawn
import kinetruss as kt
from four_bars import four_bar
from kinetruss.studio import Session
from kinetruss.studio.beginnings import STARTERS, starter
from kinetruss.studio.drawing import model_of, read_text
from kinetruss.studio.poses import at_rest
from kinetruss.studio.taken import python_of, taken

FLAP = [(0.0, 0.0, 0.0), (0.3, 0.2, 0.6), (0.4, 0.6, 1.4)]


@pytest.fixture
def drawing(tmp_path) -> Session:
    return Session(draw=True, folder=tmp_path)


def say(session: Session, **message) -> dict:
    return session.answer(json.dumps(message))


def made(session: Session, **message):
    """The file of a message, when it is made."""
    answer = say(session, do="take", **message)
    end = time.monotonic() + 120
    while answer["kind"] == "running":
        assert time.monotonic() < end
        time.sleep(0.05)
        answer = say(session, do="running")
    return session.results.pages[answer["number"]] if answer["kind"] == "taken" else answer


def passes(model: kt.Model, run: str, node: str, place: tuple[float, ...]) -> bool:
    """Whether a node ends a run at a place."""
    motion = kt.kinematics.follow(model, model.runs[run].trajectory, samples=31)
    return bool(np.abs(motion.position.sel(node=node).values[-1] - place).max() < 1e-9)


@pytest.mark.slow
def test_a_linkage_that_was_found_comes_into_the_drawing_and_passes(drawing):
    answer = say(drawing, do="ask", positions=FLAP, point=0.2)
    assert {row["kind"] for row in answer["rows"]} == {"four-bar", "slider-crank"}
    assert "four-bars" in answer["message"].lower()
    first = answer["rows"][0]
    assert max(first["error"], 1e-9) == 1e-9
    assert len(first["picture"]["path"]) > 30
    put = say(drawing, do="choose", number=0)
    assert put["made"] == {"member": "crank"}
    assert passes(drawing.model, "through", "P", (0.4, 0.6))
    # another one takes its place, or stands beside it under other names once something else was done
    say(drawing, do="choose", number=1)
    assert list(drawing.model.bars) == ["crank", "rocker"]
    say(drawing, do="set", path=["title"], value="two")
    slider = next(k for k, row in enumerate(answer["rows"]) if row["kind"] == "slider-crank")
    say(drawing, do="choose", number=slider)
    model = drawing.model
    assert list(model.bars) == ["crank", "rocker", "crank2"]
    assert list(model.links) == ["coupler", "coupler2"]
    assert kt.kinematics.mobility(model).degrees_of_freedom == 2
    say(drawing, do="undo")
    assert list(drawing.model.bars) == ["crank", "rocker"]


def test_a_picture_is_that_of_the_pose_where_the_motion_stands(tmp_path):
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    session = drawn.drawing(model)
    _, arrays = drawn.unpacked(drawn.asked(session, do="sweep", drives=["motor"]))
    pictures = {sample: made(session, form="svg", sample=sample).content for sample in (90, 200)}
    for sample, picture in pictures.items():
        crank = arrays["drive_position"][sample, 0]
        turned = four_bar((0.1, 0.35, 0.3), 0.4, float(crank))  # the same linkage, drawn so
        forces = at_rest(turned, np.array([node.at for node in turned.nodes.values()]))
        path = kt.report.picture(forces, tmp_path / "pose.svg", model=turned)
        assert lines(picture) == pytest.approx(lines(path.read_bytes()), abs=2e-3)
    assert lines(pictures[90]) != pytest.approx(lines(pictures[200]), abs=2e-3)
    assert lines(made(session, form="svg").content) == pytest.approx(
        lines(kt.report.picture(model, tmp_path / "own.svg").read_bytes()), abs=1e-9
    )
    say(session, do="set", path=["title"], value="another")
    assert made(session, form="svg", sample=90)["message"] == "The motion is not known any more. Play it again."


def lines(picture: bytes) -> list[float]:
    """All numbers of the lines of a picture."""
    return [float(one) for path in re.findall(rb' d="([^"]*)"', picture) for one in re.findall(rb"-?\d+\.?\d*", path)]


def test_what_is_no_task_is_said_and_changes_nothing(drawing):
    assert "3, 4 or 5" in say(drawing, do="ask", positions=FLAP[:2])["message"]
    assert say(drawing, do="ask")["kind"] == "error"
    assert "Ask again" in say(drawing, do="choose", number=0)["message"]
    assert not drawing.data["nodes"]


@pytest.mark.slow
def test_a_linkage_is_not_put_into_space(drawing):
    say(drawing, do="ask", positions=FLAP)
    say(drawing, do="fresh", dim=3)
    say(drawing, do="add", at=[0, 0, 0])
    assert "plane" in say(drawing, do="choose", number=0)["message"]


@pytest.mark.parametrize("name", STARTERS)
def test_a_starter_is_a_whole_drawing_and_a_copy(drawing, name):
    """All of them have a picture and no faults, and the text that is drawn is that of the whole model."""
    model, _ = starter(name)
    row = next(one for one in say(drawing, do="starters")["rows"] if one["name"] == name)
    assert len(row["picture"]["places"]) > 2
    assert row["picture"]["lines"]
    assert row["picture"]["dim"] == model.dim
    data, faults = read_text(starter(name)[1], drawing.folder)
    assert not faults
    assert model_of(data, drawing.folder) == model


def test_beginning_can_be_undone(drawing):
    answer = say(drawing, do="begin", name="Truss bridge")
    assert answer["valid"]
    assert not answer["faults"]
    say(drawing, do="undo")
    assert not drawing.data["nodes"]
    assert "Did you mean" in say(drawing, do="begin", name="Trus bridge")["message"]


def test_hobermans_ring_opens_along_radial_lines():
    """All hinges of the outer and of the inner ring stay on their lines through the centre, alike."""
    model, _ = starter("Hoberman's ring")
    motion = kt.kinematics.follow(model, model.runs["open"].trajectory, samples=9)
    for ring in "EIO":
        names = [f"{ring}{k}" for k in range(8)]
        places = motion.position.sel(node=names).values
        radii = np.linalg.norm(places, axis=-1)
        angles = np.arctan2(places[..., 1], places[..., 0])
        assert np.ptp(radii, axis=1).max() < 1e-8
        assert np.abs(np.sin(angles - angles[0])).max() < 1e-8
        assert np.ptp(radii, axis=0).max() > 0.01


def test_the_pen_of_the_pantograph_draws_twice_as_large():
    model, _ = starter("Pantograph")
    motion = kt.kinematics.follow(model, model.runs["draw"].trajectory, samples=17)
    P, T = (motion.position.sel(node=name).values for name in "PT")
    np.testing.assert_allclose(T, 2 * P, atol=1e-12)


def test_the_chords_of_the_bridge_carry_its_moment():
    """Cut at the middle of the span: the lower chord has M/h, from the loads alone where the bridge has no mass."""
    model, _ = starter("Truss bridge")
    bare = model.with_(gravity=(0.0, 0.0))
    force = kt.statics.linear(bare).member_force
    moment = 100e3 * 8 - 40e3 * 4  # about U2, of the reaction and of the first load
    assert force.sel(member="bottom3").item() == pytest.approx(moment / 4, rel=1e-9)
    diagonals = [force.sel(member=f"diagonal{k}").item() for k in (2, 3, 4, 5)]
    assert min(diagonals) > 0


def test_text_and_python_make_the_same_model_again(drawing):
    say(drawing, do="begin", name="Scissor lift")
    text = made(drawing, form="yaml").content.decode()
    assert text == drawing.drawing.state.text
    code = made(drawing, form="python").content.decode()
    ast.parse(code)
    names: dict = {}
    exec(code, names)
    assert names["model"] == drawing.model


@pytest.mark.slow
def test_pictures_are_those_of_the_report(drawing, tmp_path):
    say(drawing, do="begin", name="Truss bridge")
    svg = made(drawing, form="svg")
    assert svg.name == "Truss_bridge.svg"
    kt.report.picture(drawing.model, tmp_path / "own.svg")
    assert svg.content.count(b"<path") == (tmp_path / "own.svg").read_bytes().count(b"<path")
    assert made(drawing, form="png").content.startswith(b"\x89PNG")
    (page,) = pypdf.PdfReader(io.BytesIO(made(drawing, form="pdf").content)).pages
    assert not page.images  # lines, and text that stays text
    assert all(name in page.extract_text() for name in drawing.model.nodes)


@pytest.mark.slow
def test_the_page_and_the_report_are_one_file(drawing):
    say(drawing, do="begin", name="Truss bridge")
    page = made(drawing, form="page").content.decode()
    assert "kinetruss-scene" in page
    assert "http-equiv" in page
    assert "Governing" in made(drawing, form="report").content.decode()


def test_a_drawing_without_runs_turns_once_in_its_page():
    model = kt.library.mechanisms.four_bar()
    file = taken("page", model, {}, "", "four-bar")
    assert file.name == "four-bar.html"
    assert b"kinetruss-scene" in file.content


def test_what_cannot_be_taken_is_said(drawing):
    say(drawing, do="begin", name="Truss bridge")
    assert "does not move" in made(drawing, form="gif")["message"]
    assert "No run called" in made(drawing, form="report", run="dream")["message"]
    say(drawing, do="fresh", dim=2)
    assert say(drawing, do="take", form="png")["kind"] == "error"


def test_python_keeps_units_as_they_were_typed():
    assert "'20 mm'" in python_of({"nodes": {"A": ["20 mm", 0]}}, "x")
