"""Dimensions of a drawing: they follow its nodes and members, are undone, kept over restarts, and are no part of the file."""

from __future__ import annotations

import json

import kinetruss as kt
from drawn import drawing
from four_bars import four_bar
from kinetruss.studio import Session

FAR, LENGTH, ANGLE = {"nodes": ["B", "D"]}, {"members": ["rocker"]}, {"members": ["crank", "rod"]}


def ask(desk: Session, **command) -> dict:
    return desk.answer(json.dumps(command))


def measured(tmp_path) -> Session:
    """A saved four-bar with three dimensions."""
    path = kt.write(four_bar((0.1, 0.35, 0.3), 0.4), tmp_path / "bar.yaml")
    desk = drawing(kt.read(path), path, tmp_path)
    for one in (FAR, LENGTH, ANGLE):
        found = ask(desk, do="dimension", **one)
    assert found["dimensions"] == [FAR, LENGTH, ANGLE]
    return desk


def test_a_dimension_is_a_step_of_its_own_and_neither_another_model_nor_another_file(tmp_path):
    desk = measured(tmp_path)
    text, found = desk.drawing.state.text, desk.drawing.found
    assert (desk.drawing.revision, desk.dirty) == (0, False)  # what was computed still holds
    assert ask(desk, do="dimension", nodes=["D", "B"])["dimensions"] == [LENGTH, ANGLE]  # the same again removes it
    assert ask(desk, do="undo")["dimensions"] == [FAR, LENGTH, ANGLE]
    assert (desk.drawing.state.text, desk.drawing.found) == (text, found)
    assert not (tmp_path / ".kinetruss" / "bar.autosave.yaml").exists()
    for given, words in (
        ({"nodes": ["B", "Q"]}, "no node called 'Q'"), ({"members": ["rods"]}, "no member called 'rods'"),
        ({"nodes": ["B"]}, "two nodes"), ({"nodes": ["B", "B"]}, "two nodes"), ({}, "two nodes"),
        ({"nodes": ["B", "D"], "members": ["rod"]}, "two nodes"),
    ):  # fmt: skip
        assert words in ask(desk, do="dimension", **given)["message"]
    assert "for a drawing" in ask(Session(four_bar((0.1, 0.35, 0.3), 0.4)), do="dimension", **FAR)["message"]


def test_dimensions_follow_names_and_go_with_what_they_measure(tmp_path):
    desk = measured(tmp_path)
    assert ask(desk, do="rename", table="nodes", old="B", new="elbow")["dimensions"] == [
        {"nodes": ["D", "elbow"]},
        LENGTH,
        ANGLE,
    ]
    renamed = ask(desk, do="rename", table="bars", old="rod", new="arm")["dimensions"]
    assert renamed == [{"nodes": ["D", "elbow"]}, LENGTH, {"members": ["arm", "crank"]}]
    assert ask(desk, do="delete", members=["arm"])["dimensions"] == [{"nodes": ["D", "elbow"]}, LENGTH]
    assert ask(desk, do="delete", nodes=["elbow"])["dimensions"] == [LENGTH]
    added = ask(desk, do="add", at=[0, 0.1], name="elbow")
    assert added["dimensions"] == [LENGTH]  # a node of that name is another one
    for _ in range(3):
        found = ask(desk, do="undo")
    assert found["dimensions"] == renamed
    text = desk.drawing.state.text
    for k, name in enumerate(("rockers", "rockerss", "rocker")):  # typed letter by letter, and back
        found = ask(desk, do="text", text=text.replace("rocker", name), drag=7)
        assert (LENGTH in found["dimensions"]) == (k == 2)
    assert ask(desk, do="begin", name="Four-bar")["dimensions"] == []  # another drawing, with nodes of the same names
    assert len(ask(desk, do="undo")["dimensions"]) == 3


def test_dimensions_outlive_the_studio_beside_the_file_and_its_copy(tmp_path):
    desk = measured(tmp_path)
    assert "dimension" not in (tmp_path / "bar.yaml").read_text()
    again = drawing(kt.read(tmp_path / "bar.yaml"), tmp_path / "bar.yaml", tmp_path)
    assert again.first()["dimensions"] == [FAR, LENGTH, ANGLE]
    assert (again.first()["offer"], again.first()["undo"]) == (None, "")
    ask(desk, do="save", name="copy.yaml")
    ask(desk, do="dimension", **FAR)
    copy = drawing(kt.read(tmp_path / "copy.yaml"), tmp_path / "copy.yaml", tmp_path)
    assert copy.first()["dimensions"] == [LENGTH, ANGLE]
    for one in (LENGTH, ANGLE):
        ask(desk, do="dimension", **one)
    assert not list((tmp_path / ".kinetruss").glob("*.dimensions.json"))
    (tmp_path / ".kinetruss" / "bar.dimensions.json").write_text('[["nodes", ["B", "gone"]], ["nodes", [1, 2]], "x"]')
    assert drawing(kt.read(tmp_path / "bar.yaml"), tmp_path / "bar.yaml", tmp_path).first()["dimensions"] == []


def test_dimensions_of_a_drawing_that_was_not_saved_come_back_with_it(tmp_path):
    desk = measured(tmp_path)
    ask(desk, do="add", at=[0.4, 0.4], name="E", bar_from="C")
    ask(desk, do="dimension", nodes=["A", "E"])
    again = drawing(kt.read(tmp_path / "bar.yaml"), tmp_path / "bar.yaml", tmp_path)
    assert again.first()["offer"]
    assert ask(again, do="draft", keep=True)["dimensions"] == [FAR, LENGTH, ANGLE, {"nodes": ["A", "E"]}]
    other = drawing(kt.read(tmp_path / "bar.yaml"), tmp_path / "bar.yaml", tmp_path)
    assert ask(other, do="draft", keep=False)["dimensions"] == [FAR, LENGTH, ANGLE]
    assert ask(other, do="add", at=[0, 1], name="E")["dimensions"] == [FAR, LENGTH, ANGLE]
