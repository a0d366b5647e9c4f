"""The verdict in one line: OK, over capacity, not fully checked, not checked."""

import pytest
from kinetruss.strength.governing import Governing, headline

import kinetruss as kt
from kinetruss import runs, strength
from samples import tripod

STEEL = kt.Material(E=210e9, density=7850, yield_strength=235e6)


def held(**more):
    """Forces in two bars that carry a load."""
    given = {
        "nodes": {"A": (0, 0), "B": (2, 0), "C": (1, 1)},
        "fixed": ("A", "B"),
        "bars": {"left": ("A", "C"), "right": ("B", "C")},
        "section": kt.Tube(outer=0.02, inner=0.016),
        "material": STEEL,
        "loads": {"down": kt.NodalForce(node="C", force=(0, -1e3))},
    }
    model = kt.Model(**(given | more))
    return strength.check(model, kt.statics.at_poses(model, [{}]))


def test_ok_names_what_governs():
    verdict = held()
    found = headline(verdict)
    worst = verdict.table()[0]
    assert (found.state, found.checked, found.parts) == ("ok", 2, 2)
    assert found.governing.used == worst.utilisation < 1
    assert found.governing.name == worst.part
    assert found.governing.rule == worst.rule


def test_over_counts_the_others():
    found = headline(held(loads={"down": kt.NodalForce(node="C", force=(0, -1e6))}))
    assert (found.state, found.others) == ("over", 1)
    assert found.record["text"] == "Over capacity"
    assert found.record["more"] == ["1 more over"]


@pytest.mark.slow
def test_what_was_not_checked_is_no_ok():
    found = headline(held(material=kt.Material(E=210e9, density=7850)))
    assert (found.state, found.checked, found.parts) == ("open", 0, 2)
    assert found.text == "Strength not fully checked: 0 of 2 parts checked"
    bars = {"left": ("A", "C"), "right": kt.Bar(ends=("B", "C"), section=kt.Tube(outer=0.02, inner=0.016), material="soft")}
    partly = held(bars=bars, materials={"soft": kt.Material(E=210e9, density=7850)})
    assert headline(partly).text == "Strength not fully checked: 1 of 2 parts checked"
    assert headline(None).state == "none"


def test_a_drive_may_govern():
    verdict = held()
    one = Governing(kind="drive", name="motor", member="motor", rule="voltage", used=0.931, time=6.55)
    found = headline(verdict, drives=[one])
    assert (found.state, found.governing.kind) == ("ok", "drive")
    assert found.governing.text == "motor, voltage: 93.1 % at 6.55 s"
    full = Governing(kind="drive", name="motor", member="motor", rule="voltage", used=1 + 1e-12)
    assert headline(verdict, drives=[full]).state == "ok"  # at the limit, to round-off
    over = Governing(kind="drive", name="motor", member="motor", rule="voltage", used=1.01)
    assert headline(verdict, drives=[over]).state == "over"
    assert headline(verdict, drives=[one], timed=False).governing.text == "motor, voltage: 93.1 %"


def test_the_demand_of_a_run_counts():
    run = runs.run(tripod(), "lift")
    found = headline(run.verdict, run.demand)
    used = [row.utilisation for row in run.verdict.table() if row.checked]
    used += [row.utilisation for one in run.demand.values() for row in one.table() if row.checked]
    assert found.governing.used == pytest.approx(max(used))
