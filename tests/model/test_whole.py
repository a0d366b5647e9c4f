"""A model stays as it was given; its whole has the inner parts behind the user's, with their owners."""

from __future__ import annotations

import json
from typing import Any

import pytest

import kinetruss as kt
from kinetruss.io.earlier import without_inner_parts
from kinetruss.mechanics import compile
from kinetruss.model.members import Brace

MATTER: dict[str, Any] = {"section": kt.Rod(diameter=0.02), "material": "steel_s235"}
TABLES = ("nodes", "fixed", "bars", "active", "bodies", "couplings")


def given() -> dict[str, Any]:
    """Hubs with arms, clamps and a hinge, a body, beams on a clamp and a hinge, and an active member."""
    rod = {"length": 0.4, "mass": 1.0}
    return {
        "nodes": {
            "A": (0, 0, 0), "B": (1, 0, 0), "C": (0.5, 0.8, 0), "D": (0.5, 0.3, 0.8), "T": (0.5, 0.3, 1.5),
            "P": (2, 0, 0), "Q": (3, 0, 0), "R": (3, 1, 0), "S": (3, 0, 1),
        },
        "fixed": {"A": "xyz", "B": "xyz", "C": "xyz"},
        "bars": {"a": ("A", "D"), "b": ("B", "D"), "mast": ("D", "T")},
        "active": {"c": {"ends": ("C", "D"), "base": rod, "tube": rod}},
        "hubs": {
            "D": kt.Hub(reach=0.05, hinges={"a": (-0.8, 0.5, 0)}, clamped=["mast"], section=kt.Rod(diameter=0.01)),
            "A": {"arms": {"a": 0.03}},
        },
        "bodies": {"box": {"nodes": ("Q", "R", "S"), "mass": 1.0, "carriers": ("Q", "R", "S")}},
        "beams": {"e": ("P", "Q"), "f": {"ends": ("Q", "R"), "hinges": {"Q": (0, 0, 1)}}},
        "clamped": ["P"],
        **MATTER,
    }  # fmt: skip


def test_a_model_has_what_it_was_given():
    data = given()
    model = kt.Model(**data)
    for table in TABLES:
        assert list(getattr(model, table)) == list(data.get(table, ()))
    assert model.bars["a"].ends == ("A", "D") and model.active["c"].ends == ("C", "D")
    again = model.with_(title="again")
    for table in TABLES:
        assert getattr(again.whole, table) == getattr(model.whole, table)
    assert model == kt.Model(**data)


def test_parts_of_the_user_come_first():
    model = kt.Model(**given())
    whole, system = model.whole, compile(model)
    for table in (*TABLES, "members"):
        own = list(getattr(model, table))
        order = list(getattr(whole, table))
        assert [name for name in order if name in own] == own
        assert order[: len(own)] == own
    inner = whole.inner
    for table in ("nodes", "bars", "bodies", "couplings"):
        assert list(getattr(whole, table)) == [*getattr(model, table), *getattr(inner, table)]
    assert list(whole.members) == [*model.members, *inner.bars] == list(system.members)
    assert list(whole.real_members) == [*model.members, *(arm.name for arms in inner.arms.values() for arm in arms)]
    assert list(whole.real_members) == list(whole.members)[: len(whole.real_members)]
    assert (system.given, system.model, system.nodes) == (model, whole, tuple(whole.nodes))


def test_every_inner_part_has_an_owner():
    inner = kt.Model(**given()).whole.inner
    tables = (inner.nodes, inner.bars, inner.bodies, inner.couplings)
    said = {name: owner.text for table in tables for name, owner in table.items()}
    assert said["D.a"] == said["D.a.axis1"] == said["D.hub"] == "hub D"
    assert said["P.d1"] == "rotation of P" and said["f.Q.axis"] == said["f.Q.d1"] == "beam f"
    assert said["e.chord"] == "beam e"
    assert any(name.startswith("box.") and text == "body box" for name, text in said.items())
    assert inner.nodes["f.Q.d2"].at == "Q" and not inner.bars["e.chord"].at


def test_plain_models_have_nothing_inner():
    model = kt.library.mechanisms.four_bar()
    assert model.whole.inner == kt.model.Inner()
    assert [getattr(model.whole, table) for table in TABLES] == [getattr(model, table) for table in TABLES]


def as_earlier(model: kt.Model) -> dict[str, Any]:
    """The data of a model with its inner parts and their marks, as earlier versions wrote them."""
    whole = model.whole
    data = json.loads(kt.model.WholeModel.model_dump_json(whole))
    for name, row in data["nodes"].items():
        row["director"] = name in whole.inner.nodes and whole.inner.nodes[name].table != "hubs"
    for name, row in data["bars"].items():
        row["brace"] = isinstance(whole.bars[name], Brace)
    for name, row in data["couplings"].items():
        owner = whole.inner.couplings.get(name)
        row["beam"] = owner.name if owner and owner.table == "beams" else None
    return data


def test_data_of_earlier_versions_lose_their_inner_parts(tmp_path):
    model = kt.Model(**given())
    data = as_earlier(model)
    assert "D.hub" in data["bodies"] and data["bars"]["a"]["ends"] == ["A.a", "D.a"]
    # what clamps hold was fixed too
    left = without_inner_parts(data)
    assert left["fixed"].pop("P") == "xyz"
    assert kt.Model.model_validate(left) == model
    path = tmp_path / "model.json"
    path.write_text(json.dumps(data))
    assert kt.read(path).with_(fixed=model.fixed) == model


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"nodes": given()["nodes"] | {"D.a": (9, 9, 9)}}, r"nodes\.D\.a|needs the name 'D.a'"),
        ({"nodes": given()["nodes"] | {"P.d1": (9, 9, 9)}}, "axis of the frame at 'P'"),
        ({"beams": {"e": ("P", "P.d1")}}, "'P.d1'"),
        ({"gauges": {"g": {"member": "e.chord", "factor": 2}}}, "only holds or shows a beam or a body"),
        ({"conditions": {"x": {"payloads": {"D.b": 1.0}}}}, "which is made for hub D"),
        ({"conditions": {"x": {"failed": ["D.b"]}}}, "which is made for hub D"),
    ],
)
def test_faults_about_inner_parts(change, said):
    with pytest.raises(kt.ModelError, match=said):
        kt.Model(**given() | change)
