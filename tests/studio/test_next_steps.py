"""What one click may add in space: each takes as many motions as it holds, holds nothing twice, and all lead to rest."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.studio.edits import supports, with_value
from kinetruss.studio.next_steps import clicks

PLACES = {"A": [0, 0, 0], "B": [1, 0, 0], "C": [0.4, 1, 0], "D": [0.4, 0.4, 0.8]}
TETRAHEDRON = {f"b{k}": list(ends) for k, ends in enumerate(combinations("ABCD", 2))}


def done(data: dict[str, Any], click: dict[str, Any]) -> dict[str, Any]:
    """The data after a click, as the page sends it."""
    number = len(data["bars"]) + len(data.get("drives", {}))
    if click["do"] == "hold":
        return with_value(data, ("fixed", click["node"]), click["axes"])
    if click["do"] == "join":
        return with_value(data, ("bars", f"n{number}"), click["ends"])
    kind = {"kind": "angle", "bar": click["bar"]} if click["do"] == "turn" else {"kind": "coordinate", "node": click["node"]}
    return with_value(data, ("drives", f"m{number}"), kind | {"axis": click["axis"]})


def offered(data: dict[str, Any]) -> tuple[kt.kinematics.Mobility, list[dict[str, Any]]]:
    model = kt.Model(**data)
    mobility = kt.kinematics.mobility(model)
    return mobility, clicks(data, model, mobility)


def check(data: dict[str, Any]) -> list[dict[str, Any]]:
    """What is offered, after each of it has been tried."""
    before, found = offered(data)
    for click in found:
        after = kt.kinematics.mobility(kt.Model(**done(data, click)))
        taken = len(click["axes"]) - len(supports(data).get(click["node"], "")) if click["do"] == "hold" else 1
        assert (after.undriven, after.self_stress) == (before.undriven - taken, before.self_stress), click
    return found


@pytest.mark.parametrize(
    "bars", [TETRAHEDRON, dict(list(TETRAHEDRON.items())[:2]), {"b2": ["A", "D"], "b4": ["B", "D"], "b5": ["C", "D"]}]
)
def test_the_first_click_again_and_again_leads_to_what_stands(bars):
    data: dict[str, Any] = {"nodes": PLACES, "bars": bars}
    for _ in range(20):
        found = check(data)
        if not found:
            break
        data = done(data, found[0])
    assert offered(data)[0].undriven == 0
    assert offered(data)[0].self_stress == 0


def test_what_nothing_holds_gets_supports_first_and_a_tetrahedron_six():
    data: dict[str, Any] = {"nodes": PLACES, "bars": TETRAHEDRON}
    for axes in ("xyz", "yz", "z"):
        found = check(data)
        assert {click["do"] for click in found} <= {"hold", "turn"}  # a bar inside would not hold it
        assert found[0] == {"do": "hold", "node": "ABC"[3 - len(axes)], "axes": axes}
        data = done(data, found[0])
    assert check(data) == []


def test_a_free_node_gets_bars_and_a_crank_a_drive_about_the_axis_about_which_it_turns():
    base = {name: TETRAHEDRON[name] for name in ("b0", "b1", "b3")}
    data: dict[str, Any] = {"nodes": PLACES, "fixed": {"A": "xyz", "B": "yz", "C": "z"}, "bars": base}
    assert [click["ends"] for click in check(data)] == [["A", "D"], ["C", "D"], ["B", "D"]]
    # held across y, its tip goes along x and z: about y
    places = {"A": [0, 0, 0], "B": [0.3, 0, 0.4]}
    found = check({"nodes": places, "fixed": {"A": "xyz", "B": "y"}, "bars": {"b": ["A", "B"]}})
    assert {"do": "turn", "bar": "b", "node": "A", "axis": "y"} in found
    # a flap about the x axis
    flap = {"nodes": {name: PLACES[name] for name in "ABC"}, "fixed": {"A": "xyz", "B": "yz"}, "bars": base}
    assert [click["axis"] for click in check(flap) if click["do"] == "turn"] == ["x", "x"]
    # a block on a rail along x
    rail = {"nodes": places, "fixed": {"B": "yz"}, "bars": {"b": ["A", "B"]}}
    assert {"do": "push", "node": "B", "axis": "x"} in check({**rail, "fixed": {"A": "yz", "B": "yz"}})


def test_what_only_turns_on_the_spot_has_no_click():
    beam = {"ends": ["A", "B"], "section": "tube_lacy_planar", "material": "aluminium_lacy"}
    places = {"A": [0, 0, 0], "B": [1, 0, 0]}
    found, none = offered({"nodes": places, "fixed": {"A": "xyz", "B": "yz"}, "beams": {"beam": beam}})
    assert found.undriven == 1
    assert none == []


def test_random_frames_are_offered_what_takes_a_motion():
    random = np.random.default_rng(7)
    seen = set()
    for _ in range(12):
        names = "ABCDEF"[: random.integers(4, 7)]
        pairs = list(combinations(names, 2))
        some = [pairs[k] for k in random.permutation(len(pairs))[: random.integers(3, 2 * len(names))]]
        data = {
            "nodes": {name: random.uniform(-1, 1, 3).round(3).tolist() for name in names},
            "fixed": dict(zip(names, ["xyz", "xyz", "xy"][: random.integers(0, 4)], strict=False)),
            "bars": {f"b{k}": list(ends) for k, ends in enumerate(some)},
        }
        seen |= {click["do"] for click in check(data)}
    assert {"hold", "turn", "join"} <= seen
