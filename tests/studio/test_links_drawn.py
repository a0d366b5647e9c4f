"""Links in the drawing: a node on a bar becomes a pin of it by one message; pins are deleted, renamed and copied."""

from __future__ import annotations

import pytest

from kinetruss.errors import InputError
from kinetruss.studio import copies, edits
from kinetruss.studio.judging import judged, on_members
from kinetruss.studio.new_parts import made

DATA = {
    "nodes": {"A": [0, 0], "B": [2, 0], "M": [1, 0], "Q": [1.5, 0], "P": [1, -1]},
    "fixed": {"A": "xy", "P": "xy"},
    "bars": {"boom": ["A", "B"], "ram": {"ends": ["P", "M"], "kind": "driven"}},
}


def test_a_bar_becomes_a_link_through_the_nodes_that_lie_on_it():
    places = {name: list(map(float, at)) for name, at in DATA["nodes"].items()}
    assert on_members(places, {"boom": ["A", "B"]}) == [("M", "boom"), ("Q", "boom")]
    one, name = edits.pinned(DATA, "boom", "Q")
    two, _ = edits.pinned(one, "boom", "M")
    assert name == "boom"
    assert two["links"] == {"boom": ["A", "M", "Q", "B"]}
    assert list(two["bars"]) == ["ram"]
    assert on_members(places, {"boom": two["links"]["boom"]}) == []
    found = judged(two)
    assert (found.faults, found.mobility.undriven) == ([], 0)


def test_section_and_mass_stay_and_other_fields_are_refused():
    given = {**DATA, "bars": {"boom": {"ends": ["A", "B"], "mass": "3 kg"}}}
    assert edits.pinned(given, "boom", "M")[0]["links"] == {"boom": {"nodes": ["A", "M", "B"], "mass": "3 kg"}}
    with pytest.raises(InputError, match="'boom' has kind, which a link has not"):
        edits.pinned({**DATA, "bars": {"boom": {"ends": ["A", "B"], "kind": "elastic"}}}, "boom", "M")
    with pytest.raises(InputError, match="No bar or link called 'x'"):
        edits.pinned(DATA, "x", "M")
    with pytest.raises(InputError, match="is a pin of 'boom' already"):
        edits.pinned(DATA, "boom", "A")


def test_links_follow_edits():
    data, _ = edits.pinned(DATA, "boom", "M")
    assert edits.renamed(data, "nodes", "M", "mid")["links"]["boom"] == ["A", "mid", "B"]
    assert edits.renamed(data, "links", "boom", "jib")["links"] == {"jib": ["A", "M", "B"]}
    assert edits.deleted(data, ["M"], [])[0]["links"]["boom"] == ["A", "B"]
    assert "links" not in edits.deleted(data, ["M", "B"], [])[0]
    assert "links" not in edits.deleted(data, [], ["boom"])[0]
    twice = copies.copied(data, ["A", "M", "B"], [0, 1], 1)
    assert len(twice["links"]) == 2
    assert len(twice["links"]["boom1"]) == 3


def test_a_bar_is_made_a_link_and_back():
    data, table, name = made(DATA, "link", [], ["boom"], {})
    assert (table, name, data["links"]["boom"]) == ("links", "boom", ["A", "B"])
    back, table, _ = made(data, "bar", [], ["boom"], {})
    assert (table, back["bars"]["boom"]) == ("bars", ["A", "B"])
    through, _ = edits.pinned(data, "boom", "M")
    with pytest.raises(InputError, match="is a link through A, M, B; a bar joins two nodes"):
        made(through, "bar", [], ["boom"], {})
