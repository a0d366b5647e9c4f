"""What tools of the drawing change, what of it is shown, and what members weigh."""

from __future__ import annotations

import json

import numpy as np
import pytest

import kinetruss as kt
from drawn import asked, unpacked
from kinetruss.studio import Session
from kinetruss.studio.first_use import used

BEAM = [
    [["nodes", "A"], [0, 0]],
    [["nodes", "B"], [2, 0]],
    [["nodes", "C"], [2, 1]],
    [["bars", "b1"], ["A", "B"]],
    [["links", "boom"], {"nodes": ["B", "C"], "section": {"kind": "rod", "diameter": "20 mm"}}],
    [["fixed", "A"], "xy"],
    [["material"], "steel_s235"],
    [["section"], {"kind": "rectangle", "width": "20 mm", "height": "40 mm"}],
    [["loads", "own"], {"member": "b1", "force": ["0 N/m", "-2 kN/m"], "shape": [0, 1], "start": "0.5 m"}],
    [["loads", "hook"], {"member": "boom", "force": ["3 kN", "0 N"], "at": "25 %"}],
]


@pytest.fixture
def session():
    return Session(draw=True)


def ask(session, **message):
    return session.answer(json.dumps(message))


def test_what_a_tool_changes_is_one_step_and_all_or_nothing(session):
    drawn = ask(session, do="change", changes=BEAM, words="a beam")
    assert (drawn["kind"], drawn["undo"], drawn["nodes"]) == ("drawing", "a beam", ["A", "B", "C"])
    wrong = [[["nodes", "D"], [3, 0]], [["bars", "b2"], ["B", "Z"]]]
    refused = ask(session, do="change", changes=wrong, words="a bar")
    assert "no node called 'Z'" in refused["message"]
    assert ask(session, do="show")["nodes"] == ["A", "B", "C"]
    assert ask(session, do="undo")["nodes"] == []


def test_loads_along_members_have_their_place_and_their_shape(session):
    loads = {one["name"]: one for one in ask(session, do="change", changes=BEAM, words="a beam")["loads"]}
    assert loads["own"] == {
        "name": "own", "member": "b1", "force": [0.0, -2000.0], "turns": False, "span": [0.25, 1.0], "shape": [0.0, 1.0],
    }  # fmt: skip
    assert loads["hook"]["at"] == 0.25
    assert loads["hook"]["force"] == [3000.0, 0.0]


def test_members_weigh_density_times_area_times_length(session):
    weights = ask(session, do="change", changes=BEAM, words="a beam")["weights"]
    density = kt.library.materials.STEEL_S235.density
    own = {"b1": density * 0.02 * 0.04 * 2.0, "boom": density * np.pi * 0.01**2 * 1.0}
    assert weights["members"] == pytest.approx(own)
    assert weights["all"] == pytest.approx(sum(own.values()))


def test_sections_of_the_catalogues_have_the_numbers_of_what_they_write(session):
    rows = ask(session, do="sections")["rows"]
    assert len({(one["name"], one["of"]) for one in rows}) == len(rows) > 100
    for one in rows:
        section = one["section"]
        tube = kt.Tube(**{key: section[key] for key in ("outer", "inner")}) if isinstance(section, dict) else None
        if tube is None:
            assert section in kt.library.sections.SECTIONS
            continue
        assert one["area"] == pytest.approx(np.pi / 4 * (tube.outer**2 - tube.inner**2), rel=1e-9)
        assert one["inertia"] == pytest.approx(np.pi / 64 * (tube.outer**4 - tube.inner**4), rel=1e-9)


def test_a_block_on_a_bar_is_no_loose_end(session):
    changes = [*BEAM[:4], [["nodes", "D"], [1, 0]], [["nodes", "E"], [1, 1]], [["bars", "crank"], ["E", "D"]]]
    assert ask(session, do="change", changes=changes, words="a lever")["hints"] != []
    block = {"terms": [[{"kind": "offset", "line": ["A", "B"], "point": "D"}, 1]]}
    drawn = ask(session, do="change", changes=[[["couplings", "block"], block]], words="a block")
    assert (drawn["hints"], drawn["pins"]) == ([], [])


CRANK = [
    [["nodes"], {"A": [0, 0], "B": [0, 0.2], "H": [0.4, 0.2], "G": [-0.3, 0.2]}],
    [["fixed"], {"A": "xy", "H": "xy", "G": "xy"}],
    [["bars", "crank"], ["A", "B"]],
    [["bars", "spring1"], {"ends": ["H", "B"], "kind": "elastic", "stiffness": "2 kN/m"}],
    [["bars", "rope1"], {"ends": ["G", "B"], "kind": "cable", "stiffness": "100 kN/m"}],
    [["drives", "motor"], {"kind": "angle", "bar": "crank"}],
    [["gravity"], [0, 0]],
]


def test_a_spring_and_a_rope_of_a_crank_pull_and_are_held_as_by_hand(session):
    drawn = ask(session, do="change", changes=CRANK, words="a crank")
    assert not any("all forces are zero" in words for words in drawn["missing"])
    header, arrays = unpacked(asked(session, do="sweep", drives=["motor"]))
    angle = arrays["drive_position"][:, 0].astype(float)
    tip = 0.2 * np.column_stack([np.cos(angle), np.sin(angle)])
    torque = np.zeros(len(angle))
    for name, end, drawn, stiffness in (("spring1", (0.4, 0.2), 0.4, 2000.0), ("rope1", (-0.3, 0.2), 0.3, 100e3)):
        way = end - tip
        length = np.linalg.norm(way, axis=1)
        pull = stiffness * (length - drawn)
        if name == "rope1":
            assert (pull < 0).any()
            pull = np.maximum(pull, 0.0)  # it only pulls
        shown = arrays["member_force"][:, header["members"].index(name)]
        np.testing.assert_allclose(shown, pull, atol=1e-6 * np.abs(pull).max())
        torque -= pull / length * (tip[:, 0] * way[:, 1] - tip[:, 1] * way[:, 0])  # what holds the crank against it
    np.testing.assert_allclose(arrays["drive_force"][:, 0], torque, atol=1e-6 * np.abs(torque).max())


def test_a_spring_that_nothing_holds_is_said_to_be_held_by_nothing(session):
    free = [
        [["nodes"], {"A": [0, 0.3], "B": [0, 0]}],
        [["bars", "spring1"], {"ends": ["A", "B"], "kind": "elastic", "stiffness": "1 kN/m"}],
    ]
    assert ask(session, do="change", changes=free, words="a spring")["why"] == "No forces yet: nothing holds the drawing."


@pytest.mark.parametrize("dim", [2, 3])
def test_what_is_compiled_before_for_drawings_is_computed_without_faults(dim):
    for session in used(dim):
        found = session.drawing.found
        assert (found.faults, found.apart, found.forces is not None) == ([], {}, True)


def test_the_angle_spring_of_one_member_in_space_has_the_axis_that_is_asked_for():
    session = Session(draw=True, dim=3)
    changes = [[["nodes"], {"A": [0, 0, 0], "B": [0, 0, 1]}], [["bars", "mast"], ["A", "B"]]]
    ask(session, do="change", changes=changes, words="a mast")
    refused = ask(session, do="make", what="angle_spring", members=["mast"])
    assert "points along the axis" in refused["message"]
    ask(session, do="rename", table="bars", old="mast", new="spring1")
    made = ask(session, do="make", what="angle_spring", members=["spring1"], axis="y")
    assert made["data"]["springs"]["spring2"]["coordinate"] == {"kind": "angle", "bar": "spring1", "axis": "y"}
