"""What was not checked is a state of its own, never a utilisation of 0."""

from __future__ import annotations

import json
import math
import re

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss import report, runs, strength, viewer
from kinetruss.cli import main
from kinetruss.report.run_figures import specifications
from kinetruss.strength.verdict import highest, strength_histories, unchecked, worst_of

TUBE = kt.Tube(outer=0.02, inner=0.016)
KNOWN = kt.Material(E=70e9, density=2700, yield_strength=200e6)
UNKNOWN = kt.Material(E=70e9, density=2700)


def bracket(*, up: bool, first: kt.Material | None, second: kt.Material | None, weight: float = 0.0) -> kt.Model:
    """Two bars from a wall to a node that a force pulls (up) or pushes: both in tension, or both in compression."""
    drives = {"turn": kt.AngleDrive("arm")}
    bars = {
        name: kt.Bar(ends=(foot, "C"), section=None if material is None else TUBE, material=material)
        for name, foot, material in (("a", "A", first), ("b", "B", second))
    }
    return kt.Model(
        title="bracket", nodes={"A": (0, 0), "B": (4, 0), "C": (2, 1), "D": (3, 3)}, fixed=["A", "B"],
        bars=bars | {"arm": kt.Bar(ends=("C", "D"), mass=weight)}, drives=drives,
        loads={"pull": kt.NodalForce(node="C", force=(0, 500.0 if up else -500.0))},
        runs={"swing": kt.Run(trajectory=kt.Quintic(moves={"turn": (math.atan2(2, 1), 1.0)}, duration=1.0), samples=5)},
    )  # fmt: skip


materials = st.sampled_from([KNOWN, UNKNOWN, None])


@pytest.mark.slow
@settings(max_examples=20)
@given(up=st.booleans(), first=materials, second=materials)
def test_a_member_has_a_utilisation_only_where_a_checked_rule_speaks_of_it(up, first, second):
    model = bracket(up=up, first=first, second=second)
    run = runs.run(model, "swing")
    found, worst = strength_histories(model, run.forces["all"]), worst_of(model, run.verdict)
    missing = unchecked(model)
    for k, material in enumerate((first, second)):
        name = "ab"[k]
        used = found["utilisation"][:, k] if "utilisation" in found else np.full(5, np.nan)
        speaks = material is KNOWN or (material is UNKNOWN and not up)  # Euler's load needs no yield strength
        assert np.isfinite(used).all() == speaks
        assert not (used == 0).any()
        assert np.isfinite(worst["utilisation"][k] if "utilisation" in worst else np.nan) == speaks
        wanted = {id(KNOWN): None, id(UNKNOWN): "yield: no yield strength", id(None): "yield: no section"}[id(material)]
        assert missing.get(name) == wanted
        rows = [row for row in run.verdict.table() if row.member == name]
        assert math.isnan(highest(rows)) != speaks
        assert (name in [part for parts in run.verdict.not_checked().values() for part in parts]) == (material is not KNOWN)


@pytest.fixture(scope="module")
def stored(tmp_path_factory):
    """a: in tension, its yield strength unknown; b: checked whole."""
    out = tmp_path_factory.mktemp("bracket") / "run"
    runs.run(bracket(up=True, first=UNKNOWN, second=KNOWN), "swing", out)
    return out


def called(*arguments: object) -> str:
    done = CliRunner().invoke(main, [str(one) for one in arguments])
    assert done.exit_code == 0, done.output
    return done.stdout


@pytest.mark.slow
def test_the_summary_names_rule_reason_and_parts(stored):
    record = json.loads(called("info", stored, "--json"))
    assert record["not_checked"] == {"yield: no section": ["arm"], "yield: no yield strength": ["a"]}
    assert [row["part"] for row in record["worst"]] == ["b"]
    text = called("info", stored)
    table = text.partition("Not checked\n")[2].partition("\n\n")[0]
    assert ["yield: no yield strength", "1", "a"] in [re.split(" {2,}", line) for line in table.splitlines()]


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_the_page_and_the_picture_and_the_report_say_so(stored, tmp_path):
    run = runs.load(stored)
    scene = viewer.scene(run)
    assert scene.header["not_checked"]["a"] == "yield: no yield strength"
    assert np.isnan(scene.arrays["utilisation"][:, 0]).all()
    drawing = report.picture(run, tmp_path / "used.svg", colour="utilisation")
    assert "grey, broken: not checked" in drawing.read_text()
    page = report.document_page(run).html
    assert "yield: no yield strength" in page
    figures = [one for one in specifications(run) if one.name == "stresses"]
    assert any("no yield strength" in note for one in figures for note in one.notes)


@pytest.mark.slow
def test_the_export_holds_no_number_and_a_state(stored, tmp_path):
    called("export", stored, tmp_path / "v.csv", "--group", "verdict")
    head, *rows = [line.split(",") for line in (tmp_path / "v.csv").read_text().splitlines()]
    row = next(row for row in rows if row[:2] == ["a", "yield"])
    assert row[head.index("utilisation")] == "nan"
    assert row[head.index("note")] == "not checked: no yield strength"


def test_names_of_poses_stay_with_them():
    model = bracket(up=False, first=KNOWN, second=KNOWN, weight=3.0).with_(gravity=(0, -9.81))
    poses = {"upright": {"turn": 1.5}, "leaning": {"turn": 0.3}}
    forces = kt.statics.at_poses(model, poses)
    assert list(strength.sections(model, forces).data["pose"].values) == list(poses)
    verdict = strength.check(model, forces)
    assert {row.pose for row in verdict.table() if row.checked} <= set(poses)
    assert all(math.isnan(row.time) for row in verdict.table())
    assert any(pose in strength.table(verdict) for pose in poses)  # both ask for as much
    assert list(forces.to_dataframe().index) == list(poses)
    in_time = strength.check(model, runs.run(model, "swing").forces["all"])
    assert all(row.pose == "" for row in in_time.table())


def test_a_table_of_forces_holds_them_where_there_are_no_active_members():
    model = bracket(up=True, first=KNOWN, second=KNOWN)
    forces = runs.run(model, "swing").forces["all"]
    frame = forces.to_dataframe()
    assert frame.shape[0] == 5
    np.testing.assert_array_equal(frame["member_force[a]"], forces.member_force.sel(member="a"))
    assert strength.check(model, forces).to_dataframe().loc[("a", "yield"), "utilisation"] > 0
