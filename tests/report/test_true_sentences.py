"""What reports say, recomputed: a load that 'exceeds' another is larger, every part is named, no pose is drawn twice."""

import math
import re

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.report.document.inputs import members_of, nodes_of, total_mass
from kinetruss.report.run_figures import specifications

TUBE = kt.Tube(outer=0.0889, inner=0.0789)
SCALES = {"N": 1.0, "kN": 1e3, "MN": 1e6, "GN": 1e9, "mN": 1e-3}
SAID = re.compile(
    r"compression(?: times the factor [\d.]+)? \(([\d.e]+) (\w*N)\) (exceeds|reaches) Euler's load \(([\d.e]+) (\w*N)\)"
)


def strut(force, length=3.0, factor=2.5, section=TUBE):
    """A weightless strut between a held and a guided node, pressed along its axis."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (length, 0)}, fixed={"A": "xy", "B": "y"}, bars={"strut": ("A", "B")}, section=section,
        material="steel_s355", safety=kt.Safety(yielding=1.5, buckling=factor), gravity=(0, -9.81),
        loads={"push": kt.NodalForce(node="B", force=(-force, 0))}, runs={"stand": kt.Run(analysis="statics.linear")},
    )  # fmt: skip


def euler(model):
    (I, _), length = TUBE.second_moments, model.nodes["B"].at[0]
    return math.pi**2 * 210e9 * I / length**2


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(st.floats(1e3, 1e6), st.floats(1.0, 6.0), st.floats(1.0, 4.0))
def test_a_load_that_exceeds_is_larger(force, length, factor):
    model = strut(force, length, factor)
    verdict = kt.strength.check(model, kt.runs.forces_at_rest(model))
    rows = {row.rule: row for row in verdict.table()}
    said = SAID.search(rows["beam-column"].note)
    beyond = factor * force >= euler(model)
    assert bool(said) == beyond == math.isinf(rows["beam-column"].utilisation)
    first = verdict.table()[0]
    assert math.isfinite(first.utilisation)
    assert math.isfinite(first.margin)
    if said:
        one, other = float(said[1]) * SCALES[said[2]], float(said[4]) * SCALES[said[5]]
        assert one == pytest.approx(factor * force, rel=1e-3)
        assert other == pytest.approx(euler(model), rel=1e-3)
        assert one > other if said[3] == "exceeds" else one == other
        assert first.utilisation == max(rows["buckling"].utilisation, rows["yield"].utilisation)
        assert rows["buckling"].utilisation >= 1 - 1e-12


@pytest.fixture(scope="module")
def pressed():
    return kt.run(strut(135.7e3), "stand")


@pytest.mark.slow
def test_the_number_that_is_news_is_shown(pressed):
    first, over, checked = kt.report.lines(pressed)
    assert first.startswith("Governing: buckling of strut, 129 % of what is allowed: 135.7 kN of 105.5 kN")
    assert over == "2 of 3 limits that were checked are exceeded."
    assert checked == "Strength checked by every rule: 1 part."
    text = kt.report.summary(pressed).text
    assert "verdict: Over capacity; strut, buckling: 129 %" in text
    assert "compression times the factor 2.5 (339.3 kN) exceeds Euler's load (268 kN)" in text
    page = kt.report.document_page(pressed).html
    for words in (text, page):
        assert "∞" not in words
        assert "beyond its buckling load" not in words
        assert "verified" not in words.partition("kinetruss-report")[0]


def test_missions_and_runs_say_the_same():
    model = strut(135.7e3)
    row = {row.rule: row for row in kt.strength.check(model, kt.runs.forces_at_rest(model)).table()}["beam-column"]
    swept = model.with_(
        runs={"rest": kt.Run(analysis="statics.equilibrium"), "all": kt.Run(analysis="mission", motions=["rest"])}
    )
    found = {one.rule: one for one in kt.run(swept, "all").verdict.table()}
    assert found["beam-column"].note == row.note
    assert found["buckling"].utilisation == pytest.approx(1.2868, rel=1e-3)


def test_a_report_lists_every_node_and_member_with_its_mass():
    model = kt.library.vgt.double_octahedral(bays=2)
    nodes, members = nodes_of(model), members_of(model)
    assert [row["node"] for row in nodes] == list(model.nodes)
    assert [row["member"] for row in members] == list(model.members)
    lumped = sum(node.mass or 0.0 for node in model.nodes.values())
    assert total_mass(model) == pytest.approx(sum(row["mass"] for row in members) + lumped, rel=1e-12)


def test_a_full_turn_is_drawn_in_three_poses():
    model = kt.library.mechanisms.four_bar()
    turn = kt.Run(trajectory=kt.ConstantRate(rates={"motor": 2 * math.pi}, duration=1.0), samples=61)
    shape = specifications(kt.run(model.with_(runs={"turn": turn}), "turn"))[0]
    places = [stand.dots for stand in shape.stands]
    assert len(places) == 3
    size = np.ptp(places[0])
    assert min(np.abs(a - b).max() for k, a in enumerate(places) for b in places[:k]) > 0.05 * size


@pytest.mark.slow
def test_drives_have_their_curves_of_force_torque_and_power():
    turn = kt.Run(trajectory=kt.ConstantRate(rates={"motor": 2 * math.pi}, duration=1.0), samples=61)
    model = kt.read(kt.library.example_files()["four_bar"][0]).with_(runs={"turn": turn})
    run = kt.run(model)
    (drawn,) = [one for one in specifications(run) if one.name == "drives"]
    torque, power = drawn.panels
    assert (torque.quantity, torque.unit, power.unit) == ("torque", "N m", "W")
    energy = run.forces["all"].data["energy"].values
    gained = np.trapezoid(power.lines["motor"], drawn.time)
    assert np.allclose(power.lines["motor"], 2 * math.pi * torque.lines["motor"])
    assert gained == pytest.approx(float(energy[-1] - energy[0]), abs=1e-3 * np.abs(power.lines["motor"]).max())
    assert "Forces, torques and power of drives" in kt.report.document_page(run).html


@pytest.mark.parametrize(("count", "caption"), [(3, "of each part"), (20, ": the first 14 of 20 parts")])
def test_a_picture_of_the_first_parts_says_so(count, caption):
    """Bars that hang side by side."""
    nodes = {f"A{k}": (k, 0) for k in range(count)} | {f"B{k}": (k, -1) for k in range(count)}
    model = kt.Model(
        nodes=nodes, fixed={name: "xy" if name[0] == "A" else "x" for name in nodes}, section=TUBE, material="steel_s355",
        bars={f"b{k}": (f"A{k}", f"B{k}") for k in range(count)}, gravity=(0, -9.81),
        runs={"hang": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    (drawn,) = [one for one in specifications(kt.run(model)) if one.name == "stresses"]
    assert drawn.title == f"Highest stress{'' if caption[0] == ':' else ' '}{caption}"
    assert len(drawn.labels) == min(count, 14)


@pytest.mark.slow
def test_poses_are_told_by_their_names(tmp_path):
    poses = kt.Run(analysis="statics.at_poses", poses={"up": {"motor": "90 deg"}, "low": {"motor": "200 deg"}})
    model = kt.read(kt.library.example_files()["four_bar"][0]).with_(runs={"stand": poses})
    run = kt.run(model, "stand", tmp_path / "run")
    said = [kt.report.joints(run).text, kt.report.compare([run]).text, kt.report.summary(run).text]
    table = kt.io.export(tmp_path / "run", tmp_path / "run.csv").read_text().splitlines()
    free = CliRunner().invoke(main, ["explain", str(tmp_path / "run"), "--member", "crank"]).stdout
    for text in (*said, free.splitlines()[0]):
        assert re.search(r"\b(up|low)\b", text)
        assert not re.search(r"\bt = |\btime\b", text)
    assert [line.split(",")[0] for line in table] == ["pose", "up", "low"]
    assert "In time" not in kt.report.document_page(run).html.partition("kinetruss-report")[0]
