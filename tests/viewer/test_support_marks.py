"""Symbols of supports: one rule, and every place has what it says."""

import numpy as np
import pytest

import kinetruss as kt
import loaded_frames as frames
from drawn import drawing
from kinetruss import report, viewer
from kinetruss.display.symbols import SUPPORTS
from kinetruss.report.pictures.stands import stand
from kinetruss.viewer.places import Places
from kinetruss.viewer.support_marks import WORDS, support_marks

KINDS = {
    "A": ["clamp"], "B": ["roller"], "C": ["spring", "turning spring"], "D": ["roller"], "E": ["gap"], "F": ["pin"],
    "G": ["roller", "turn"], "H": ["gap", "gap"], "I": ["turning gap"],
}  # fmt: skip


def by_node(model) -> dict[str, list[dict]]:
    found: dict[str, list[dict]] = {}
    for one in support_marks(model):
        found.setdefault(one["node"], []).append(one)
    return found


def test_every_kind_of_support_has_its_symbol_in_the_direction_held():
    found = by_node(frames.every_support())
    assert {node: [one["kind"] for one in marks] for node, marks in found.items()} == KINDS
    assert {kind for kinds in KINDS.values() for kind in kinds} == set(SUPPORTS) == set(WORDS)
    assert found["A"][0]["along"] == [1.0, 0.0, 0.0]  # across the beam that leaves it
    assert found["B"][0]["along"] == [0.0, 1.0, 0.0]
    assert found["D"][0]["along"] == pytest.approx([-0.5, np.sqrt(0.75), 0.0])  # the axis y of the support, turned by 30 deg
    assert found["E"][0]["along"] == [0.0, 1.0, 0.0]  # it presses upwards
    assert sorted(one["along"][1] for one in found["H"]) == [-1.0, 1.0]  # a plate on each side
    assert [one["along"] for one in found["I"]] == [[0.0, 0.0, 1.0]]


def test_a_structure_hangs_from_supports_above_it_and_fixed_and_clamped_are_supports():
    bar = {"section": kt.Rod(diameter=0.01), "material": "steel_s235"}
    hung = kt.Model(
        nodes={"A": (0, 1), "B": (1, 1), "C": (0.5, 0)},
        fixed={"A": "xy", "B": "y"},
        bars={"a": ("A", "C"), "b": ("B", "C")},
        **bar,
    )
    assert [(one["kind"], one["along"]) for one in support_marks(hung)] == [("pin", [0, -1, 0]), ("roller", [0, -1, 0])]
    arm = kt.Model(nodes={"A": (0, 0, 0), "B": (0, 0, 1)}, clamped=["A"], beams={"arm": ("A", "B")}, **bar)
    assert support_marks(arm) == [{"node": "A", "kind": "clamp", "along": [0, 0, 1]}]
    ball = arm.with_(clamped=[], supports={"A": kt.Support(x="held", y="held", z="held", rotation="20 kN m/rad")})
    assert [(one["kind"], one["along"]) for one in support_marks(ball)] == [("pin", [0, 0, 1]), ("turning spring", [0, 0, 0])]


def test_pictures_pages_and_drawings_have_the_same_symbols(tmp_path):
    model = frames.every_support()
    wanted = [(one["node"], one["kind"], one["along"]) for one in support_marks(model)]
    scene = viewer.scene(model)
    header = scene.header
    assert [(header["nodes"][one["node"]], one["kind"], one["along"]) for one in header["support_marks"]] == wanted
    desk = drawing(model, kt.write(model, tmp_path / "frame.yaml"), tmp_path)
    assert [(one["node"], one["kind"], one["along"]) for one in desk.first()["supports"]] == wanted
    marks = stand(Places(scene)).supports
    assert [kind for kind, *_ in marks] == [kind for _, kind, _ in wanted]
    for (_, at, axes), (node, kind, along) in zip(marks, wanted, strict=True):
        assert at == pytest.approx(model.nodes[node].at)
        if not kind.startswith("turn"):
            assert axes[1] == pytest.approx(along[:2])
    text = report.picture(model, tmp_path / "frame.svg").read_text(encoding="utf-8")
    assert text.count("<use ") >= sum(len(SUPPORTS[kind]) for _, kind, _ in wanted)
