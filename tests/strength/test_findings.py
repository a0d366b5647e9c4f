"""What a result says: OK, over capacity, not fully checked, not checked; no voice calls good what another one doubts."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report, runs, strength, viewer
from kinetruss.results import Row, Status
from kinetruss.strength.findings import demands, find
from kinetruss.studio.poses import strength_of
from samples import fourbar, tripod

STEEL = kt.Material(E=210e9, density=7850, yield_strength=235e6)


def pair(**more):
    """Two bars that carry a load."""
    given = {
        "nodes": {"A": (0, 0), "B": (2, 0), "C": (1, 1)},
        "fixed": ("A", "B"),
        "bars": {"left": ("A", "C"), "right": ("B", "C")},
        "section": kt.Tube(outer=0.02, inner=0.016),
        "material": STEEL,
        "loads": {"down": kt.NodalForce(node="C", force=(0, -1e3))},
    }
    return kt.Model(**(given | more))


def held(**more):
    """Their verdict."""
    model = pair(**more)
    return strength.check(model, kt.statics.at_poses(model, [{}]))


def motor(used: float, time: float = math.nan) -> Row:
    """A check of a motor."""
    return Row(
        part="motor", member="motor", rule="voltage", value=used, limit=1.0, unit="V", utilisation=used, margin=1 / used - 1,
        time=time,
    )  # fmt: skip


def test_ok_names_what_governs():
    verdict = held()
    found = find(verdict)
    worst = verdict.table()[0]
    assert (found.state, len(found.unchecked), found.parts) == ("ok", 0, ("left", "right"))
    assert (found.governing.part, found.governing.rule, found.governing.value) == (worst.part, worst.rule, worst.value)
    assert worst.utilisation < 1
    assert found.kind == "member"
    assert found.sentence == f"OK; {worst.place}"


def test_over_counts_the_others():
    found = find(held(loads={"down": kt.NodalForce(node="C", force=(0, -1e6))}))
    assert (found.state, len(found.over)) == ("over", 2)
    assert {row.status for row in found.over} == {"exceeded"}
    assert found.record["text"] == "Over capacity"
    assert found.record["more"] == ["1 more over"]


@pytest.mark.slow
def test_what_was_not_checked_is_no_ok():
    found = find(held(material=kt.Material(E=210e9, density=7850)))
    assert (found.state, len(found.unchecked), len(found.parts)) == ("open", 2, 2)
    assert found.text == "Strength not fully checked: 2 of 2 parts unchecked"
    assert found.governs.startswith("highest of what was checked: ")
    assert found.unchecked["left"] == ("yield: no yield strength", "beam-column: no yield strength")
    bars = {"left": ("A", "C"), "right": kt.Bar(ends=("B", "C"), section=kt.Tube(outer=0.02, inner=0.016), material="soft")}
    partly = held(bars=bars, materials={"soft": kt.Material(E=210e9, density=7850)})
    assert find(partly).text == "Strength not fully checked: 1 of 2 parts unchecked"
    assert (find(None).state, find(None).text) == ("none", "Strength was not checked: no member has forces")


def test_a_drive_may_govern():
    verdict = held()
    found = find(verdict, [motor(0.931, time=6.55)])
    assert (found.state, found.kind, found.record["governing"]["kind"]) == ("ok", "drive", "drive")
    assert found.governing.place == "motor, voltage: 93.1 % at 6.55 s"
    assert find(verdict, [motor(1 + 1e-12)]).state == "ok"  # at the limit, to round-off
    assert find(verdict, [motor(1.01)]).state == "over"
    assert find(verdict, [motor(0.931, time=6.55)], timed=False).governing.place == "motor, voltage: 93.1 %"


def test_the_demand_of_a_run_counts():
    run = runs.run(tripod(), "lift")
    used = [row.utilisation for row in run.verdict.table() if row.checked]
    used += [row.utilisation for row in demands(run.demand) if row.checked]
    assert run.finding.governing.utilisation == pytest.approx(max(used))


def test_a_rule_that_asks_nothing_leaves_nothing_unchecked():
    """A cable does not buckle: so it was said, and counted in reports as a part that was not checked."""
    rope = kt.Bar(
        ends=("D", "C"), kind="cable", stiffness=1e4, natural_length=1.9, section=kt.Rod(diameter=0.01), material=STEEL
    )
    nodes = {"A": (0, 0), "B": (2, 0), "C": (1, 1), "D": (1, 3)}
    model = pair(nodes=nodes, fixed=("A", "B", "D"), bars={"left": ("A", "C"), "right": ("B", "C"), "rope": rope})
    verdict = strength.check(model, runs.forces_at_rest(model))
    row = next(row for row in verdict.table() if (row.part, row.rule) == ("rope", "buckling"))
    assert (row.note, row.status) == ("a cable does not buckle", "not asked")
    assert find(verdict).state == "ok"
    assert not verdict.not_checked()
    old = Row(part="rope", member="rope", rule="buckling", value=0, limit=math.nan, unit="N", utilisation=math.nan,
              margin=math.nan, time=0.0, note="not checked: a cable does not buckle")  # fmt: skip
    assert old.status == "not asked"  # as older releases wrote it


def test_forces_that_are_not_sure_are_no_ok():
    model = pair()
    forces = runs.forces_at_rest(model).with_(status=Status.UNSURE)
    found = find(strength.check(model, forces))
    assert (found.state, found.text) == ("open", Status.UNSURE.value.rstrip("."))
    assert viewer.scene(forces, model=model).header["verdict"]["state"] == "open"
    assert strength_of(model, forces)[0] == [Status.UNSURE.value]
    assert not strength_of(model, forces.with_(status=Status.COMPLETED))[0]


@pytest.fixture(scope="module")
def early():
    """A run that ends before its end: the crank passes beyond what the linkage can reach."""
    model = fourbar(21, nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.25, 0.12), "D": (0.31, 0)})
    run = runs.run(model, "turn")
    assert not run.whole
    assert 1 < run.good < 21
    return run


def test_a_run_that_ends_early_is_good_in_no_voice(early):
    words = f"Not complete ({early.good} of 21 samples)"
    assert (early.finding.state, early.finding.text) == ("open", words)
    summary = report.summary(early)
    assert summary.record["verdict"]["state"] == "open"
    assert f"verdict: {words}; highest of what was checked: " in summary.text
    assert report.lines(early)[0].startswith(f"{words}. Governing: ")
    assert viewer.scene(early).header["verdict"]["text"] == words
    assert words in repr(early)
    compared = report.compare([early, early], "drive_force")
    assert compared.record[0]["partial"] == words
    assert f": {words}" in compared.text


def test_what_is_exceeded_in_a_part_of_a_run_is_over(early):
    weak = early.model.with_(material=kt.Material(E=71e9, density=2711.5, yield_strength=1e3))
    found = runs.run(weak, "turn").finding
    assert found.state == "over"
    assert found.more[-1].startswith("Not complete (")


def test_doubts_are_told_by_all():
    """An energy balance that does not close was a warning in the report alone."""
    run = runs.run(fourbar(21), "turn")
    assert not run.finding.doubts
    forces = run.forces["all"]
    data = forces.data.assign(energy_balance=forces.data["energy_balance"] + 1e-3 * float(np.abs(forces.data["power"]).max()))
    poor = kt.runs.RunResult(
        model=run.model, name=run.name, motion=run.motion, forces={"all": forces.with_(data=data)}, verdict=run.verdict,
        samples=run.samples,
    )  # fmt: skip
    (doubt,) = poor.finding.doubts
    assert doubt.startswith("The energy balance closes only to ")
    assert f"\nwarning: {doubt}\n" in report.summary(poor).text
    assert f"warning: {doubt}" in repr(poor)
    page = report.document_page(poor)
    assert page.record["warnings"] == [doubt]
    assert page.record["verdict"]["warnings"] == [doubt]
    assert doubt in viewer.scene(poor).header["verdict"]["more"]


def test_a_table_of_variants_tells_the_verdict_of_members_and_drives():
    found = runs.run_variants(tripod(), {"runs.lift.trajectory.duration": [0.2, 1.0]})
    for record, run in zip(report.variants(found).record, found.values(), strict=True):
        assert record["verdict"] == run.finding.text
        assert record["worst"]["utilisation"] < 1
    assert report.variants(found).record[0]["verdict"] == "Over capacity"  # a motor
    assert "Over capacity" in report.variants(found).text


def test_loads_between_joints_count_in_small_displacements():
    """100 kN amid a bar of the length sqrt 2: the moment F cos 45/4 sqrt 2 in its middle."""
    loads = {"push": kt.NodalForce(node="C", force=(100, -1e3)), "turn": kt.BodyForce(body="left", force=(0, -1e5))}
    cases = {"one": kt.LoadCase(loads={"push": 1.0}), "two": kt.LoadCase(loads={"turn": 1.0})}
    model = pair(loads=loads, load_cases=cases, runs={"small": kt.Run(analysis="statics.linear")})
    run = runs.run(model)
    assert run.finding.state == "over"
    middle = kt.strength.sections(model, run.forces["two"], [0.5]).section_M.sel(part="left").item()
    assert middle == pytest.approx(1e5 * np.sqrt(0.5) * np.sqrt(2) / 4, rel=1e-9)
    assert np.abs(kt.strength.sections(model, run.forces["one"], [0.5]).section_M).max() < 1e-9


def test_no_section_forces_in_small_displacements_where_a_mass_bends_a_bar():
    body = kt.Body(nodes=("A", "C"), mass=5.0)
    model = pair(bodies={"box": body}, gravity=(0, -9.81), runs={"small": kt.Run(analysis="statics.linear")})
    run = runs.run(model)
    assert not run.forces
    assert "Section forces are not computed: box on members, between their joints." in run.motion.message


def test_an_equilibrium_that_is_not_stable_is_a_doubt():
    nodes = {"A": (0, 0), "B": kt.Node(at=(0, 1), mass=1.0), "C": kt.Node(at=(0, 2), mass=1.0)}
    tower = pair(nodes=nodes, fixed=["A"], bars={"low": ("A", "B"), "high": ("B", "C")}, loads={}, gravity=(0, -9.81))
    run = runs.run(tower.with_(runs={"rest": kt.Run(analysis="statics.equilibrium")}))
    assert run.finding.doubts == ("The equilibrium under all loads is not stable: 2 modes of negative stiffness.",)
    assert f"warning: {run.finding.doubts[0]}" in report.summary(run).text
