"""What is written is read back to the last bit, and a file appears whole or not at all."""

import json
import math
import os
import sys
from pathlib import Path

import pytest
from hypothesis import given, strategies as st
from jsonschema import Draft202012Validator

import kinetruss as kt
from elements.test_contract import MODELS
from kinetruss.io import schema
from kinetruss.io.emitting import _number, to_json, to_yaml
from kinetruss.io.yaml_text import parse_json, parse_yaml, plain
from kinetruss.limits import LARGEST, SMALLEST

sys.path.insert(0, str(Path(__file__).parents[2] / "docs" / "site"))

import tables

JUDGE = Draft202012Validator(schema())

real = st.floats(-LARGEST, LARGEST)
positive = st.floats(SMALLEST, LARGEST)
names = st.text(st.characters(exclude_categories=["C", "Z"], exclude_characters="/\\"), min_size=1, max_size=8)
awkward = st.sampled_from(
    ["no", "12:30", "null", "~", "1e3", "true", "- ", "N.4", "a,b", "{x}", "#", "'", '"', "é", "𝛼", "x: y"]
)
titles = st.text() | awkward

sections = st.builds(kt.Rod, diameter=positive) | st.builds(kt.Rectangle, width=positive, height=positive)


@st.composite
def histories(draw, count):
    """Times that grow, and as many vectors."""
    times = sorted(draw(st.lists(real, min_size=count, max_size=count, unique=True)))
    return times, [tuple(draw(st.tuples(real, real))) for _ in times]


@st.composite
def models(draw):
    """Planar models with a bit of everything."""
    taken = draw(st.lists(names | awkward.filter(lambda name: " " not in name), min_size=6, max_size=6, unique=True))
    nodes, (bar, lead) = taken[:4], taken[4:]
    spots = draw(st.lists(st.tuples(real, real), min_size=4, max_size=4, unique=True))
    times, forces = draw(histories(3))
    step = draw(st.floats(SMALLEST, LARGEST / 4))
    rod = draw(st.floats(SMALLEST, LARGEST / 4))
    part = kt.Part(length=rod, mass=1)
    apart = max(math.dist(*spots[:2]), 1e-20)  # of the driven bar
    shares = draw(st.tuples(st.floats(0.1, 0.3), st.floats(0.1, 0.3)))
    pace = [k * step for k in range(4)]
    return kt.Model(
        title=draw(titles),
        nodes={name: kt.Node(at=at, mass=draw(positive), coincident=True) for name, at in zip(nodes, spots, strict=True)},
        fixed={nodes[0]: draw(st.sampled_from(["x", "y", "xy", "yx"]))},
        bars={bar: kt.Bar(ends=nodes[:2], kind="driven", mass=draw(st.none() | positive), buckling=draw(positive))},
        active={lead: kt.Active(ends=nodes[2:], length=2 * rod, base=part, tube=part)},
        section=draw(
            st.none() | st.builds(kt.Rod, diameter=positive) | st.builds(kt.Rectangle, width=positive, height=positive)
        ),
        material=draw(st.none() | st.builds(kt.Material, E=positive, density=positive, source=titles)),
        gravity=draw(st.none() | st.tuples(real, real)),
        loads={"push": kt.NodalForce(node=nodes[1], times=times, forces=forces)},
        load_cases={"push": kt.LoadCase(loads={"push": draw(real)}), "none": kt.LoadCase(loads={})},
        trajectories={
            "go": kt.Quintic(moves={bar: (shares[0] * apart, shares[1] * apart)}, duration=draw(positive)),
            "seen": kt.Spline(times=pace, values={lead: [(2 + k / 10) * rod for k in range(4)]}),
        },
        runs={"go": kt.Run(trajectory="go", samples=draw(st.integers(2, 10**6)), load_cases=["none"])},
        safety=kt.Safety(yielding=draw(st.floats(1, LARGEST))),
    )


@given(models(), st.sampled_from([".yaml", ".json"]))
def test_round_trip(tmp_path_factory, model, suffix):
    path = tmp_path_factory.getbasetemp() / f"model{suffix}"
    kt.write(model, path)
    again = kt.read(path)
    assert again == model
    assert repr(again.model_dump()) == repr(model.model_dump())  # equal floats of other sign, -0.0, differ here


@pytest.mark.slow
@pytest.mark.parametrize("name", kt.library.example_files())
@pytest.mark.parametrize("suffix", [".yaml", ".yml", ".json"])
def test_examples(tmp_path, name, suffix):
    model = kt.read(kt.library.example_files()[name][0])
    path = kt.write(model, tmp_path / f"again{suffix}")
    assert kt.read(path) == model
    assert suffix != ".json" or list(JUDGE.iter_errors(json.loads(path.read_text("utf-8")))) == []


@given(real)
def test_numbers_keep_every_bit(value):
    assert float(_number(value)).hex() == value.hex()


leaves = titles | real | st.integers(-(10**9), 10**9) | st.booleans()
data = st.dictionaries(
    titles,
    st.recursive(leaves, lambda inner: st.lists(inner, max_size=15) | st.dictionaries(names, inner, max_size=9), max_leaves=30),
    min_size=1,
)


def as_text(value):
    """All scalars as the text a YAML file has of them."""
    if isinstance(value, dict):
        return {key: as_text(item) for key, item in value.items()}
    if isinstance(value, list):
        return [as_text(item) for item in value]
    if isinstance(value, bool):
        return str(value).lower()
    return value if isinstance(value, str) else _number(value) if isinstance(value, float) else str(value)


@given(data)
def test_any_data_as_yaml(tree):
    found, faults = parse_yaml(to_yaml(tree))
    assert plain(found) == as_text(tree)
    assert not faults


@given(data)
def test_any_data_as_json(tree):
    text = to_json(tree)
    assert json.loads(text) == tree
    found, faults = parse_json(text)
    assert plain(found) == tree
    assert not faults


def test_form(tmp_path):
    model = kt.Model(
        title="a pair, of bars",
        nodes={"no": (0, 0), "B": kt.Node(at=("36 in", 0), mass=2), "D": (0, 1)},
        fixed=["no"],
        bars={"b": ("no", "B"), "c": {"ends": ("no", "D"), "kind": "driven"}, "d": ("B", "D")},
        material=kt.Material(E="210 GPa", density=7850),
        trajectories={"t": kt.ConstantRate(rates={"c": "1 mm/s"}, duration=1e-5)},
    )
    assert (
        kt.write(model, tmp_path / "m.yaml").read_text()
        == """\
kinetruss: 1
title: "a pair, of bars"
nodes:
  "no": [0, 0]
  B: {at: [0.9144, 0], mass: 2}
  D: [0, 1]
fixed: {"no": xy}
bars:
  b: ["no", B]
  c: {ends: ["no", D], kind: driven}
  d: [B, D]
material: {E: 2.1e+11, density: 7850}
trajectories:
  t: {kind: constant_rate, rates: {c: 0.001 m/s}, duration: 0.00001}
"""
    )


def test_long_lists_are_wrapped(tmp_path):
    times = [k / 7 for k in range(200)]
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)},
        bars={"b": {"ends": ("A", "B"), "kind": "driven"}},
        trajectories={"t": kt.Spline(times=times, values={"b": [1 + t for t in times]})},
    )
    for suffix in ("yaml", "json"):
        path = kt.write(model, tmp_path / f"m.{suffix}")
        assert max(map(len, path.read_text().splitlines())) <= 120
        assert kt.read(path) == model


def test_a_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "m.yaml"
    model = kt.Model(nodes={"A": (0, 0)})
    kt.write(model, path)
    before = path.read_bytes()

    def full(descriptor):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(kt.StoreError, match=r"cannot be written: No space left on device\. Make room"):
        kt.write(model.with_(title="other"), path)
    assert path.read_bytes() == before
    assert [item.name for item in tmp_path.iterdir()] == ["m.yaml"]


def test_unknown_suffix(tmp_path):
    with pytest.raises(kt.InputError, match=r"Name a file that ends in \.yaml, \.yml, \.json"):
        kt.write(kt.Model(nodes={"A": (0, 0)}), tmp_path / "m.txt")


def test_motion_files_move_with_the_working_folder(tmp_path, monkeypatch):
    (tmp_path / "deep").mkdir()
    (tmp_path / "seen.csv").write_text("t,A.x,A.y,A.vx,A.vy,A.ax,A.ay\n0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n")
    model = kt.Model(nodes={"A": (0, 0)}, runs={"r": kt.Run(motion="seen.csv"), "s": kt.Run(motion=str(tmp_path / "seen.csv"))})
    monkeypatch.chdir(tmp_path)
    path = kt.write(model, "deep/m.yaml")
    assert 'motion: "../seen.csv"' in path.read_text()
    assert kt.read(path) == model
    assert kt.check(path) == []
    monkeypatch.chdir(tmp_path / "deep")
    assert kt.read("m.yaml").runs["r"].motion == "../seen.csv"
    assert kt.read("m.yaml").runs["s"].motion == str(tmp_path / "seen.csv")


def test_rates_and_forces_are_written_with_their_own_units(tmp_path):
    """Values of lengths or of angles, in every field that has such, whatever its record checks."""
    bars = {"ab": kt.Bar(ends=("A", "B"), mass=1.0), "bc": kt.Bar(ends=("B", "C"), mass=1.0)}
    turn = kt.AngleDrive("ab")
    six = ("1 deg",) * 6
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, fixed=["A"], bars=bars, drives={"turn": turn},
        bearings={"pin": kt.Bearing(member="ab", node="B", against="bc", friction=0.1, radius=0.01, slip="0.02 rad/s")},
        springs={
            "s": kt.Spring(coordinate=turn, stiffness="3 N m/rad", damping="1 N m s/rad", friction="2 N m", slip="3 deg/s")
        },
        trajectories={
            "steady": kt.ConstantRate(rates={"turn": "10 deg/s"}, duration=1),
            "seen": kt.Measured(
                times=range(6), values={"turn": six}, rates={"turn": ("2 deg/s",) * 6},
                accelerations={"turn": ("3 deg/s^2",) * 6},
            ),
        },
    )  # fmt: skip
    file = tmp_path / "model.yaml"
    kt.io.write(model, file)
    read = kt.read(file)
    assert "slip: 0.02 rad/s" in file.read_text("utf-8")
    for table in ("bearings", "springs", "trajectories"):
        assert getattr(read, table) == getattr(model, table)


KINDS = {f"{kind}, {name}": model for kind, models in MODELS.items() for name, model in models.items()}
"""A model of every kind of element; those of tables are the examples of the model reference."""


@pytest.mark.parametrize("suffix", ["yaml", "json"])
@pytest.mark.parametrize("name", [*KINDS, *tables.SOURCE["tables"]])
def test_every_table_and_kind_is_read_as_it_was_written(name, suffix, tmp_path):
    model = KINDS[name] if name in KINDS else tables.model_of(name, tmp_path)
    path = kt.write(model, tmp_path / f"again.{suffix}")
    assert kt.read(path) == model
    if suffix == "json":
        assert list(JUDGE.iter_errors(json.loads(path.read_text("utf-8")))) == []
