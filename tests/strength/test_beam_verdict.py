"""Beams in the verdict of runs and missions: closed forms, positions out of balance, and what people read."""

from __future__ import annotations

import math

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss import report
from kinetruss.cli import main
from kinetruss.errors import InputError
from kinetruss.strength.verdict import strength_histories, unchecked, worst_of

STEEL = kt.library.materials.STEEL_S235
LENGTH, LOAD, PULL, SIDE = 2.0, 800.0, 5e3, 0.05


def cantilever(**changes) -> kt.Model:
    """A cantilever of one element with a load across its tip and one along it; a bar far from it."""
    fields = {
        "nodes": {"A": (0, 0), "B": (LENGTH, 0), "P": (0, 5), "Q": (1, 5)},
        "clamped": ["A"],
        "fixed": ["P", "Q"],
        "beams": {"arm": ("A", "B")},
        "bars": {"tie": ("P", "Q")},
        "section": kt.Rectangle(width=SIDE, height=SIDE),
        "material": STEEL,
        "safety": kt.Safety(yielding=1.5, buckling=2.0),
        "loads": {"tip": kt.NodalForce(node="B", force=(0, -LOAD)), "pull": kt.NodalForce(node="B", force=(PULL, 0))},
        "runs": {"still": kt.Run(analysis="statics.linear"), "here": kt.Run(analysis="statics.at_poses", poses={"it": {}})},
    }
    return kt.Model(**(fields | changes))


def row_of(verdict, part, rule):
    return next(row for row in verdict.table() if (row.part, row.rule) == (part, rule))


@pytest.mark.slow
def test_the_verdict_has_the_stress_of_a_cantilever():
    """N/A + M c/I at the clamp, with 1.5 V/A at the same point, over the yield strength and its safety factor."""
    area = SIDE**2
    normal = PULL / area + LOAD * LENGTH * (SIDE / 2) / (SIDE**4 / 12)
    exact = math.hypot(normal, math.sqrt(3) * 1.5 * LOAD / area)
    row = row_of(kt.run(cantilever(), "still").verdict, "arm", "yield")
    assert row.value == pytest.approx(exact, rel=1e-9)
    assert row.utilisation == pytest.approx(exact * 1.5 / STEEL.yield_strength, rel=1e-9)
    assert (row.position, row.station, row.load_case) == (0.0, 0.0, "all")
    column = row_of(kt.run(cantilever(), "still").verdict, "arm", "buckling")
    assert (column.value, column.note) == (0.0, "never in compression")


def test_pushed_beams_are_said_not_to_be_checked_for_buckling():
    run = kt.run(cantilever(loads={"push": kt.NodalForce(node="B", force=(-PULL, 0))}), "still")
    row = row_of(run.verdict, "arm", "buckling")
    assert row.value == pytest.approx(PULL, rel=1e-9)
    assert math.isnan(row.utilisation)
    assert any("statics.buckling" in what and parts == ["arm"] for what, parts in run.verdict.not_checked().items())
    soft = cantilever(material=STEEL.with_(yield_strength=None))
    assert row_of(kt.run(soft, "still").verdict, "arm", "yield").note == "not checked: no yield strength"
    assert unchecked(soft)["arm.chord"] == "yield: no yield strength"


def test_the_moment_between_the_ends_governs_and_is_found():
    """A beam on two supports under a uniform load: w l^2/8 in the middle, 0 at the ends."""
    model = cantilever(
        nodes={"A": (0, 0), "B": (LENGTH, 0)}, clamped=[], fixed={"A": "xy", "B": "y"}, bars={}, loads={}, gravity=(0, -9.81)
    )
    verdict = kt.run(model, "still").verdict
    weight = STEEL.density * SIDE**2 * 9.81
    row = row_of(verdict, "arm", "yield")
    assert row.station == pytest.approx(0.5)
    assert row.value == pytest.approx(weight * LENGTH**2 / 8 * (SIDE / 2) / (SIDE**4 / 12), rel=1e-9)


def test_a_pose_of_a_determinate_beam_is_judged_as_a_rigid_one():
    run = kt.run(cantilever(), "here")
    assert row_of(run.verdict, "arm", "yield").value == pytest.approx(
        row_of(kt.run(cantilever(), "still").verdict, "arm", "yield").value, rel=1e-9
    )
    assert run.forces["all"].reaction.sum("support").values[0] == pytest.approx([-PULL, LOAD], rel=1e-9)
    assert "Not in balance" not in run.message


PROP = {"fixed": {"P": "xy", "Q": "xy", "B": "y"}, "gravity": (0, -9.81)}


def test_a_pose_in_which_balance_does_not_decide_the_forces_of_beams_is_not_judged():
    """The reactions of a pose of a propped cantilever are one choice of many: it says so, and gives no stress of 0."""
    model = cantilever(**PROP)
    run = kt.run(model, "here")
    forces = run.forces["all"]
    assert forces.attrs["undecided"] == ["arm"]
    assert "Balance alone does not decide" in run.message
    assert row_of(run.verdict, "arm", "yield").note.startswith("not checked: the positions are not those")
    with pytest.raises(InputError, match=r"statics\.equilibrium"):
        kt.strength.beams(model, forces)
    at_rest = kt.statics.equilibrium(model)
    with pytest.raises(InputError, match="not the .* inner ones"):
        kt.statics.at_poses(model, at_rest.position.values[None])
    balanced = kt.statics.at_poses(model, at_rest)
    assert "not_balanced" not in balanced.attrs
    assert row_of(kt.strength.check(model, balanced), "arm", "yield").checked


def vibrating(folder):
    """The cantilever let go, its motion as a table of all nodes, and the simulation."""
    model = cantilever(runs={"swing": kt.Run(analysis="dynamics.simulate", t_end=0.05, samples=41)}, gravity=(0, -9.81))
    run = kt.run(model, "swing")
    data, columns = run.motion.whole, {"t": run.motion.whole["time"].values}
    for node in map(str, data["node"].values):
        for kind, name in (("", "position"), ("v", "velocity"), ("a", "acceleration")):
            columns |= {f"{node}.{kind}{axis}": data[name].sel(node=node, axis=axis).values for axis in "xy"}
    path = folder / "swing.csv"
    np.savetxt(path, np.column_stack(list(columns.values())), delimiter=",", header=",".join(columns), comments="", fmt="%.17g")
    return model, run, path


@pytest.mark.slow
def test_a_simulated_run_a_mission_and_the_pictures_have_the_same_utilisation(tmp_path):
    model, run, path = vibrating(tmp_path)
    whole = run.verdict
    stress = kt.strength.beams(model, run.forces["all"], stations=97).von_mises
    assert row_of(whole, "arm", "yield").value == pytest.approx(float(stress.max()), rel=1e-12)
    again = model.with_(
        runs={
            "given": kt.Run(motion=str(path)),
            "all": kt.Run(analysis="mission", motions=("given",)),
        }
    )
    mission = kt.run(again, "all", tmp_path / "out")
    for one in (mission, kt.runs.load(tmp_path / "out")):
        for rule in ("yield", "buckling"):
            wanted, found = row_of(whole, "arm", rule), row_of(one.verdict, "arm", rule)
            assert found.value == pytest.approx(wanted.value, rel=1e-6)
            assert found.time == wanted.time
            assert found.note == wanted.note
        assert one.pairs["part"].values[0] == "arm"
        assert one.pairs["utilisation"].values[0] == pytest.approx(row_of(whole, "arm", "yield").utilisation, rel=1e-6)
        bending = one.extremes.sel(part="arm", quantity="bending")
        along = kt.strength.beams(model, run.forces["all"], stations=97).section_M.sel(moment="3")
        assert float(bending.value) == pytest.approx(float(abs(along).max()), rel=1e-6)
    chord = list(model.whole.members).index("arm.chord")
    shown = strength_histories(model, run.forces["all"])["utilisation"][:, chord]
    assert shown.max() == pytest.approx(row_of(whole, "arm", "yield").utilisation, rel=1e-12)
    assert worst_of(model, whole)["stress"][chord] == pytest.approx(float(stress.max()), rel=1e-12)
    text = report.summary(run).text
    assert "arm" in text.partition("Worst members")[2]


def test_a_mission_of_poses_says_that_its_beams_are_not_checked():
    model = cantilever(
        **PROP,
        runs={
            "here": kt.Run(analysis="statics.at_poses", poses={"it": {}}),
            "all": kt.Run(analysis="mission", motions=("here",)),
        },
    )
    mission = kt.run(model, "all")
    assert row_of(mission.verdict, "arm", "yield").note.startswith("not checked: the positions")
    assert "Balance alone does not decide" in next(iter(mission.findings.values()))
    assert "arm" in report.summary(mission).text.partition("Not checked")[2]


def test_the_command_line_tells_beams(tmp_path):
    path = tmp_path / "arm.yaml"
    kt.write(cantilever(), path)
    call = CliRunner().invoke
    assert "1 beam" in call(main, ["check", str(path)]).output
    head, arm = call(main, ["info", str(path)]).output.split("Beams\n")[1].splitlines()[:2]
    assert head.split() == ["beam", "kind", "ends", "length", "section", "clamped", "at"]
    assert arm.split() == ["arm", "elastic", "A", "to", "B", "2", "m", "rectangle", "A"]
    refused = call(main, ["explain", str(path), "--member", "arm"])
    assert refused.exit_code == 2
    assert "strength.beams" in str(refused.output) + str(refused.exception)
    path.write_text(path.read_text().replace("arm:", "arm:\n    stiffening: 0.001", 1))
    assert call(main, ["check", str(path)]).exit_code == 2
