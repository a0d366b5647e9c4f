"""A drawing moved by its nodes with all lengths kept: closed forms, and what follows in the file."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import kinetruss as kt
from four_bars import four_bar
from kinetruss.studio import Session


def dragged(desk: Session, drag: int | None = 1, **places) -> dict:
    answer = desk.answer(json.dumps({"do": "move", "places": places, "drag": drag, "keep": True}))
    assert answer["kind"] in ("moved", "drawing"), answer
    return answer


def lengths(desk: Session) -> np.ndarray:
    model = desk.model
    at = {name: np.array(node.at) for name, node in model.nodes.items()}
    return np.array([np.linalg.norm(at[a] - at[b]) for a, b in (bar.ends for bar in model.bars.values())])


@pytest.mark.parametrize("driven", [True, False])
def test_a_crank_follows_the_pointer_at_its_nearest_point_and_closes_the_loop(driven):
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    desk = Session(model if driven else model.with_(drives={}), draw=True)
    before = lengths(desk)
    for k in range(1, 80):  # once round, from outside and from inside of the circle
        angle, far = math.pi / 2 + k * math.pi / 40, 0.15 if k % 2 else 0.07
        aim = [far * math.cos(angle), far * math.sin(angle)]
        found = dragged(desk, B=aim)
        np.testing.assert_allclose(found["places"][1], np.array(aim) * 0.1 / far, atol=1e-6)
        np.testing.assert_allclose(lengths(desk), before, atol=1e-13)
        if driven:
            assert math.remainder(found["drives"][0]["value"] - angle, 2 * math.pi) == pytest.approx(0, abs=1e-5)
    assert len(desk.drawing.past) == 1  # one step of undo
    desk.answer('{"do": "undo"}')
    assert desk.data == desk.original.data


def test_what_is_drawn_by_length_follows_and_what_is_natural_stays():
    bars = {
        "boom": kt.Bar(ends=("A", "B")), "jack": kt.Bar(ends=("C", "B"), kind="driven", length=math.hypot(0.5, 0.8)),
        "spring": kt.Bar(ends=("C", "B"), kind="elastic", stiffness=1000),
    }  # fmt: skip
    nodes = {"A": (0, 0), "B": (1, 0.3), "C": (0.5, -0.5)}
    desk = Session(kt.Model(nodes=nodes, fixed={"A": "xy", "C": "xy"}, bars=bars), draw=True)
    radius = math.hypot(1, 0.3)
    for k in range(1, 11):
        angle = math.atan2(0.3, 1) + 0.05 * k
        found = dragged(desk, B=[2 * math.cos(angle), 2 * math.sin(angle)])
    tip = radius * np.array([math.cos(angle), math.sin(angle)])
    np.testing.assert_allclose(found["places"][1], tip, atol=1e-6)
    far = float(np.linalg.norm(np.array(found["places"][1]) - [0.5, -0.5]))
    assert desk.data["bars"]["jack"]["length"] == pytest.approx(far, abs=1e-14)
    assert desk.data["bars"]["spring"]["natural_length"] == pytest.approx(math.hypot(0.5, 0.8), abs=1e-15)
    force = dict(zip(desk.model.members, found["force"], strict=True))
    assert force["spring"] == pytest.approx(1000 * (far - math.hypot(0.5, 0.8)), rel=1e-9)


def test_what_stands_does_not_move_and_leaves_no_step():
    nodes = {"A": (0, 0), "B": (1, 0), "C": (0.5, 0.8)}
    bars = {"a": ("A", "C"), "b": ("B", "C")}
    desk = Session(kt.Model(nodes=nodes, fixed={"A": "xy", "B": "xy"}, bars=bars), draw=True)
    for aim in ([0.7, 1.2], [0.5, 0.8], [2, 2]):
        assert dragged(desk, C=aim)["places"][2] == [0.5, 0.8]
    assert not desk.drawing.past
    assert "No node called" in desk.answer('{"do": "move", "places": {"X": [0, 0]}, "keep": true}')["message"]


def test_what_floats_goes_along_as_a_whole_and_a_slide_follows():
    bars = {"a": ("A", "B"), "b": ("B", "C"), "c": ("C", "A")}
    desk = Session(kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (0.5, 0.8)}, bars=bars), draw=True)
    before = lengths(desk)
    found = dragged(desk, None, A=["100 mm", 0.2], B=[1.1, 0.2])
    np.testing.assert_allclose(found["places"], [[0.1, 0.2], [1.1, 0.2], [0.6, 1.0]], atol=1e-6)
    np.testing.assert_allclose(lengths(desk), before, atol=1e-13)
    slider = kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.1), "C": (0.3, 0)}, fixed={"A": "xy", "C": "y"}, bars={"a": ("A", "B"), "b": ("B", "C")},
        drives={"slide": kt.CoordinateDrive(node="C", axis="x")},
    )  # fmt: skip
    desk = Session(slider, draw=True)
    for x in np.linspace(0.3, 0.25, 6)[1:]:
        found = dragged(desk, C=[x, 0.05])
    np.testing.assert_allclose(found["places"][2], [0.25, 0.0], atol=1e-6)
    assert found["drives"][0]["value"] == pytest.approx(0.25, abs=1e-6)
