"""What tools of the drawing change, what of it is shown, and what members weigh."""

from __future__ import annotations

import json

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.studio import Session

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
