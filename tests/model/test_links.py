"""Links in the model: what represents them, faults, and the advice that leads to them."""

from __future__ import annotations

import pytest

import kinetruss as kt
from kinetruss.errors import ModelError

NODES = {"A": (0, 0), "B": (1, 0), "C": (2, 0), "D": (0, 1), "E": kt.Node(at=(0, 0), coincident=True)}
SECTION = {"section": kt.Rod(diameter=0.02), "material": "steel_s235"}


def test_a_list_is_the_short_form_and_the_model_stays_as_it_was_given():
    model = kt.Model(nodes=NODES, fixed=["A"], links={"boom": ["A", "B", "C"]}, **SECTION)
    assert model.links["boom"] == kt.Link(nodes=("A", "B", "C"))
    assert not model.beams
    assert list(model.whole.beams) == ["boom.A-B", "boom.B-C"]
    assert model.whole.inner.nodes["boom.B.d1"].text == "link boom"
    assert "1 link" in repr(model)


FAULTS = {
    "unknown node": ({"links": {"l": ("A", "X")}}, "links.l.nodes.1: no node called 'X'"),
    "one node": ({"links": {"l": ("A",)}}, "expected at least 2"),
    "at one place": ({"links": {"l": ("A", "E", "C")}}, "two pins at one place: 'A' and 'E'"),
    "named twice": ({"links": {"l": ("A", "B", "A", "C")}}, "names 'A' twice"),
    "there and back": ({"links": {"l": ("A", "B", "A")}}, "goes from 'A' and back"),
    "two on two pins": ({"links": {"l": ("A", "B", "C"), "m": ("C", "A")}}, "in common with the rigid link 'l'"),
    "name of a bar": ({"links": {"l": ("A", "B")}, "bars": {"l": ("B", "C")}}, "'l' is also the name of a bar"),
    "name of a beam": ({"links": {"l": ("A", "B")}, "beams": {"l": ("B", "C")}, **SECTION}, "also the name of a beam"),
    "elastic without section": ({"links": {"l": kt.Link(nodes=("A", "B"), kind="elastic")}}, "no section and no material"),
    "length": ({"links": {"l": ("A", "B")}, "drives": {"d": kt.LengthDrive("l")}}, "'l' is a link, which keeps its length"),
    "weld": ({"links": {"l": kt.Link(nodes=("A", "B"), weld=["C"])}}, "'C' is no node of the link. Name one of A, B."),
    "hinge in the plane": ({"links": {"l": kt.Link(nodes=("A", "B"), hinges={"A": 3})}}, "is given in a planar model"),
    "clamped but pinned": ({"links": {"l": ("A", "B")}, "fixed": [], "clamped": ["A"]}, "the link 'l' is pinned there"),
    "damping": ({"links": {"l": kt.Link(nodes=("A", "B"), damping=1e-3)}, **SECTION}, "which does not vibrate"),
    "orientation": ({"links": {"l": kt.Link(nodes=("A", "B"), orientation=(0, 1))}}, "given in a planar model"),
    "other angle": ({"links": {"l": ("A", "B")}, "drives": {"d": kt.AngleDrive("k")}}, "no member called 'k'"),
}


@pytest.mark.parametrize("case", FAULTS)
def test_faults_are_told_before_work(case):
    given, words = FAULTS[case]
    with pytest.raises(ModelError) as caught:
        kt.Model(**({"nodes": NODES, "fixed": ["A"]} | given))
    assert words in str(caught.value)
    assert all(fault.mend for fault in caught.value.faults)
    assert ".d1" not in str(caught.value)


def test_elastic_links_may_share_two_pins():
    side = {"kind": "elastic", "nodes": ("A", "C")}
    model = kt.Model(nodes=NODES, fixed={"A": "xy", "C": "y"}, links={"l": side, "m": side}, **SECTION)
    assert kt.check(model) == []


def test_three_bars_on_a_line_are_led_to_a_link():
    data = {
        "nodes": {"A": (0, 0), "B": (1, 0.5), "C": (2, 1), "D": (0, -1)}, "fixed": ["A", "D"],
        "bars": {"ab": ("A", "B"), "bc": ("B", "C"), "ac": ("A", "C"), "ram": kt.Bar(ends=("D", "B"), kind="driven")},
        "runs": {"up": kt.Run(trajectory=kt.Quintic(moves={"ram": ("1.8028 m", "2 m")}, duration=4.0))},
    }  # fmt: skip
    (fault,) = kt.check(kt.Model(**data))
    assert "make one link of them (links: {boom: [A, B, C]})" in fault.message
    text = kt.kinematics.mobility(kt.Model(**data)).mechanism_texts()[0]
    assert "links: {boom: [A, B, C]}" in text
    assert "off the plane" not in text
    bars = {name: bar for name, bar in data["bars"].items() if name == "ram"}
    assert kt.check(kt.Model(**data | {"bars": bars, "links": {"boom": ("A", "B", "C")}})) == []


def test_a_body_on_a_line_is_led_to_a_link():
    for carriers in (None, ("A", "C")):
        with pytest.raises(ModelError, match='links: {boom: \\[A, B, C\\]}|links={"boom": \\["A", "B", "C"\\]}'):
            kt.Model(nodes=NODES, fixed=["A"], bodies={"boom": kt.Body(nodes=("A", "B", "C"), mass=100, carriers=carriers)})


def test_bars_that_cross_are_led_to_two_links():
    nodes = {"A": (0, 0), "B": (2, 0), "M": (1, 1), "C": (2, 2), "D": (0, 2)}
    pairs = ("AM", "MC", "AC", "BM", "MD", "BD")
    model = kt.Model(nodes=nodes, fixed={"A": "xy", "B": "y"}, bars={pair: tuple(pair) for pair in pairs})
    text = " ".join(kt.kinematics.mobility(model).mechanism_texts())
    assert "links: {boom: [A, M, C]}), and another of B, M and D: they turn freely at M" in text
