"""The text of a drawing: comments, order and untouched lines stay when the drawing, or the page with sliders, changes it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from drawn import drawing
from kinetruss.io.writing import changed_text, data_of
from kinetruss.library import example_files
from kinetruss.studio import Session

TEXT = """\
# an arm
kinetruss: 1
nodes: # where
  A: [0, 0]  # pin

  B: [2, 0] # roller
  C: {at: [1, 1500 mm], mass: 2 kg}  # apex
bars:  # all
  b1: [A, B] # base
  b2:
    ends:
      - B
      - C
    # heavy
    mass: 3
  # the last
  b3: {ends: [A, C], mass: 10 g} # strut
fixed: {A: xy, B: y} # held
# the end
"""
COMMENTS = [line.partition("#")[2] for line in TEXT.splitlines() if "#" in line]


def done(desk: Session, **command) -> dict:
    found = desk.answer(json.dumps(command))
    assert found["kind"] == "drawing", found
    return found


@pytest.fixture
def desk() -> Session:
    found = drawing()
    done(found, do="text", text=TEXT)
    return found


@pytest.mark.slow
def test_every_kind_of_edit_changes_its_own_lines_only(desk):
    for command, old, new in (
        ({"do": "move", "places": {"A": ["50 mm", 0]}}, "  A: [0, 0]  # pin", "  A: [50 mm, 0]  # pin"),
        ({"do": "set", "path": ["bars", "b2", "mass"], "value": "4 kg"}, "    mass: 3", "    mass: 4 kg"),
        ({"do": "set", "path": ["bars", "b3", "mass"], "value": None}, "  b3: {ends: [A, C], mass: 10 g} # strut",
         "  b3: [A, C] # strut"),
        ({"do": "rename", "table": "bars", "old": "b1", "new": "base"}, "  b1: [A, B] # base", "  base: [A, B] # base"),
        ({"do": "add", "at": [3, 3]}, None, "  D: [3, 3]"),
        ({"do": "set", "path": ["loads", "push"], "value": {"node": "C", "force": [1, 0]}}, None,
         "loads:\n  push: {node: C, force: [1, 0]}"),
        ({"do": "delete", "members": ["b3"]}, "  b3: {ends: [A, C], mass: 10 g} # strut\n", ""),
    ):  # fmt: skip
        text = done(desk, **command)["text"]
        if old is None:
            assert sorted(text.splitlines()) == sorted([*TEXT.splitlines(), *new.splitlines()])
        else:
            assert text == TEXT.replace(old, new)
        assert done(desk, do="undo")["text"] == TEXT


@pytest.mark.slow
def test_typing_is_one_step_until_the_text_is_left(desk):
    for k in range(3):
        done(desk, do="text", text=TEXT.replace("[2, 0]", f"[{3 + k}, 0]"), drag=-1)
    assert done(desk, do="undo")["text"] == TEXT
    for k in (-1, -2):
        done(desk, do="text", text=TEXT.replace("[2, 0]", f"[{3 - k}, 0]"), drag=k)
    assert "B: [4, 0] # roller" in done(desk, do="undo")["text"]


@pytest.mark.slow
def test_an_edit_of_every_example_keeps_its_comments():
    for name, (path, *_) in example_files().items():
        if path.name.endswith(".mission.yaml"):
            continue
        text = path.read_text(encoding="utf-8")
        data, _ = data_of(text, path.parent)
        node, entry = next(iter(data["nodes"].items()))
        place = [0.1 + k for k in range(len(entry["at"] if isinstance(entry, dict) else entry))]
        new = {**data, "nodes": {**data["nodes"], node: {**entry, "at": place} if isinstance(entry, dict) else place}}
        found = changed_text(text, data, new, path.parent)
        assert found is not None, name
        gone = [line for line in text.splitlines() if line not in found.splitlines()]
        assert len(gone) <= 3, (name, gone)  # the entry itself
        assert data_of(found, path.parent)[0] == new


def test_what_cannot_be_patched_is_written_anew_below_its_head():
    text = "# mine\nkinetruss: 1\nnodes: {A: [0, 0], B: &b [1, 0], C: *b}\nbars: {b1: [A, B]}  # one\n"
    desk = drawing()
    done(desk, do="text", text=text)
    found = done(desk, do="move", places={"B": [2, 0]})["text"]
    assert found.startswith("# mine\nkinetruss: 1\n")
    assert "  C: [1, 0]" in found
    assert data_of(found, Path())[0]["nodes"]["B"] == [2, 0]


SCALARS = st.one_of(st.integers(-9, 9), st.sampled_from(["1 mm", "yes", "a b", "x: y", "# no", "- 1", "", "*a", "2 kN"]))
VALUES = st.recursive(
    SCALARS, lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(st.sampled_from("pqrs"), inner, max_size=3)),
    max_leaves=6,
)  # fmt: skip
TABLES = st.dictionaries(st.sampled_from("abcdef"), st.dictionaries(st.sampled_from("uvwxyz"), VALUES, max_size=4), max_size=4)


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(TABLES, TABLES, st.randoms())
def test_a_patched_text_means_the_new_data_or_is_refused(before, after, random):
    from kinetruss.io.emitting import to_yaml

    lines = [f"{line}  # c{k}" if random.random() < 0.5 and not line.endswith("[") else line
             for k, line in enumerate(to_yaml({"title": "t", **before}).splitlines())]  # fmt: skip
    text = "\n".join(lines) + "\n"
    old = data_of(text, Path())[0]
    new = data_of(to_yaml({"title": "t", **after}), Path())[0]
    found = changed_text(text, old, new, Path())
    assert found is not None
    assert data_of(found, Path())[0] == new


@pytest.mark.slow
def test_the_page_with_sliders_saves_with_comments(tmp_path):
    file = tmp_path / "arm.yaml"
    file.write_text("# mine\n" + kt.library.example_files()["drive_train"][0].read_text(encoding="utf-8"), encoding="utf-8")
    text = file.read_text(encoding="utf-8")
    session = Session(kt.read(file), file, tmp_path, text=text)
    session.answer(json.dumps({"do": "mass", "node": "B", "mass": 1.5}))
    assert session.answer(json.dumps({"do": "save", "name": "arm.yaml"}))["kind"] == "saved"
    found = file.read_text(encoding="utf-8")
    gone = [line for line in text.splitlines() if line not in found.splitlines()]
    assert [line.split(":")[0].strip() for line in gone] == ["B"]
    assert kt.read(file).nodes["B"].mass == 1.5
