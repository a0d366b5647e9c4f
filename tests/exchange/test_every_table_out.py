"""Whatever a model has is in the file of another program, or is named as left out: every table, every writer."""

import pytest

import kinetruss as kt
from kinetruss.exchange.tables_out import CARRIED
from kinetruss.model.data import ModelData

TIP = kt.NodalForce(node="C", force=(0, -10))
BASE = {
    "nodes": {"A": (0, 0), "B": (0, 0.1), "C": (0.3, 0.25), "D": (0.4, 0)},
    "fixed": ["A", "D"],
    "bars": {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
    "drives": {"motor": kt.AngleDrive("crank")},
    "section": kt.Rectangle(width=0.02, height=0.005),
    "material": "steel_s235",
}
MORE_NODES = {**BASE["nodes"], "P": (0.5, 0), "Q": (0.7, 0), "R": (0.7, 0.2)}
ELASTIC = kt.Beam(ends=("P", "Q"), kind="elastic")
TURN = kt.ConstantRate(rates={"motor": 1.0}, duration=1.0)
"""Model field -> (fields beside it, the same with it): of an entry that acts."""
ADDED = {
    "beams": {"nodes": MORE_NODES, "beams": {"b": ELASTIC}, "fixed": ["A", "D", "P"]},
    "links": {"nodes": MORE_NODES, "links": {"l": ("P", "Q", "R")}, "fixed": ["A", "D", "P"]},
    "clamped": {"nodes": MORE_NODES, "beams": {"b": ELASTIC}, "clamped": ["P"]},
    "supports": {"supports": {"D": kt.Support(x="held", y="1 kN/m")}, "fixed": ["A"]},
    "membranes": {
        "nodes": MORE_NODES,
        "membranes": {"m": kt.Membrane(nodes=("P", "Q", "R"), elements=((0, 1, 2),), thickness=0.001, material="steel_s235")},
    },
    "gravity": {"gravity": (0, -9.81)},
    "loads": {"loads": {"tip": TIP}},
    "loads along": {"loads": {"along": kt.MemberLoad(member="crank", force=(0, -10))}},
    "load_cases": {"loads": {"tip": TIP}, "load_cases": {"one": {"loads": {"tip": 1}}}},
    "combinations": {
        "loads": {"tip": TIP},
        "load_cases": {"one": {"loads": {"tip": 1}}},
        "combinations": {"twice": {"cases": {"one": 2}}},
    },
    "conditions": {"conditions": {"hot": kt.Condition(temperature=40.0)}},
    "velocities": {"velocities": {"B": (-0.1, 0)}},
    "couplings": {
        "drives": {},
        "couplings": {"c": kt.Coupling(terms=((kt.AngleDrive("crank"), 1), (kt.AngleDrive("rocker"), -1)))},
    },
    "springs": {"springs": {"s": kt.Spring(coordinate=kt.AngleDrive("crank"), stiffness=2.0)}},
    "stops": {"stops": {"s": kt.Stop(coordinate=kt.AngleDrive("crank"), lower=-1.0, stiffness=2.0)}},
    "cylinders": {"cylinders": {"c": kt.Cylinder(nodes=("A", "C"), bore=0.05, rod=0.02, pressure_A=1e5)}},
    "trajectories": {"trajectories": {"turn": TURN}},
    "runs": {"runs": {"turn": kt.Run(trajectory=TURN)}},
    "quantities": {"quantities": {"q": "angle(crank)"}},
    "deflections": {"deflections": {"d": kt.DeflectionLimit("crank", "1 mm", measured_from="start")}},
    "safety": {"safety": {"yielding": 1.5}},
    "report": {"report": {"project": "p"}},
    "bearings": {"bearings": {"p": kt.Bearing(node="C", member="coupler", radius=0.01, friction=0.1)}},
}
OTHERWISE = {"springs": "stiffness"}
"""How else a writer names an entry of a field."""


def written(model, path):
    found = kt.exchange.write(model, path, overwrite=True)
    return [one.read_bytes() for one in found.files], {one.what for one in found.left_out}, found.left_out


@pytest.mark.parametrize("suffix", [one for one in kt.exchange.FORMATS if one != ".pvd"])
@pytest.mark.parametrize("case", ADDED)
def test_a_table_changes_the_file_or_is_named_as_left_out(tmp_path, suffix, case):
    """Written means that the file is another one than without it."""
    field = "loads" if case == "loads along" else case
    given = BASE | ADDED[case]
    model = kt.Model(**given)
    path = tmp_path / f"m{suffix}"
    files, named, left = written(model, path)
    if {field, OTHERWISE.get(field)} & named:
        assert any(one.where for one in left if one.what in (field, OTHERWISE.get(field)))
        return
    assert field in CARRIED[suffix]
    without = dict(given)
    del without[field]
    if field == "supports":
        without["fixed"] = BASE["fixed"]
    if field == "links":
        without["nodes"], without["fixed"] = BASE["nodes"], BASE["fixed"]
    assert written(kt.Model(**without), path)[0] != files, f"{field} is neither in a {suffix} nor named"


def test_every_field_of_a_model_is_carried_or_would_be_named():
    """A field that is new is named until a writer carries it; those that are carried are fields."""
    assert set(CARRIED) == set(kt.exchange.FORMATS)
    for fields in CARRIED.values():
        assert fields <= set(ModelData.model_fields)


def test_loads_along_members_are_named_with_their_names(tmp_path):
    model = kt.Model(**BASE | ADDED["loads along"])
    for suffix in (".xml", ".urdf", ".dxf", ".stl", ".vtu"):
        left = written(model, tmp_path / f"m{suffix}")[2]
        assert [one.where for one in left if one.what == "loads"] == ["along"]
