"""Missions: the envelope equals the worst of single runs, a kill loses nothing that was done, memory stays flat."""

from __future__ import annotations

import json
import math
import tracemalloc

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import HealthCheck, given, settings, strategies as st

import kinetruss as kt
from kinetruss import report
from kinetruss.cli import main
from kinetruss.runs.mission_results import pairs_of
from kinetruss.runs.missions import run_mission
from samples import tripod
from shows import shown

STEEL = kt.library.materials.STEEL_S235
share = st.floats(-1, 1, allow_subnormal=False).map(lambda value: round(value, 4))


def crane(moves=((0.1, -0.05), (0.15, 0.1)), loads=(200.0, 350.0), **changes):
    """A crane of two driven bars and two rigid ones, which bend under their weight."""
    start = (math.hypot(0.2, 1.3), math.hypot(1.4, 1.4))
    fields = {
        "nodes": {"A": (0, 0), "B": (1, 0), "C": (1.2, 1.3), "D": (2.4, 1.4)},
        "fixed": ["A", "B"],
        "bars": {
            "post": ("A", "C"),
            "lift": kt.Bar(ends=("B", "C"), kind="driven"),
            "boom": ("C", "D"),
            "swing": kt.Bar(ends=("B", "D"), kind="driven"),
        },
        "section": kt.Tube(outer=0.03, inner=0.026),
        "material": STEEL,
        "gravity": (0, -9.81),
        "safety": kt.Safety(yielding=1.5, buckling=2.0),
        "loads": {f"hook{k}": kt.NodalForce(node="D", force=(20.0, -force)) for k, force in enumerate(loads)},
        "load_cases": {f"case{k}": kt.LoadCase(loads={f"hook{k}": 1.0}) for k in range(len(loads))},
        "trajectories": {
            f"move{k}": kt.Quintic(moves={"lift": (start[0], start[0] + a), "swing": (start[1], start[1] + b)}, duration=0.8)
            for k, (a, b) in enumerate(moves)
        },
        "conditions": {
            "plain": kt.Condition(),
            "laden": kt.Condition(payloads={"D": 12.0}),
            "hot": kt.Condition(temperature=50.0),
            "stuck": kt.Condition(locked=("swing",)),
            "broken": kt.Condition(failed=("boom",)),
        },
        "runs": {
            "all": kt.Run(
                analysis="mission",
                motions=tuple(f"move{k}" for k in range(len(moves))),
                conditions=("plain", "laden", "hot", "stuck"),
                samples=31,
            )
        },
    }
    return kt.Model(**fields | changes)


def one_by_one(model, name="all"):
    """The runs of all pairs, done alone."""
    return [kt.run(*pair.alone(model, model.runs[name])) for pair in pairs_of(model, name)]


def assert_worst_of(mission, runs):
    wanted = {}
    for run in runs:
        for row in run.verdict.table():
            if row.checked:
                wanted[row.part, row.rule] = max(wanted.get((row.part, row.rule), -1.0), row.utilisation)
    found = {(row.part, row.rule): row.utilisation for row in mission.verdict.table() if row.checked}
    assert found == pytest.approx(wanted, rel=1e-9, abs=1e-14)
    # of a beam-column beyond Euler's load, whose utilisation is infinite, that of buckling counts
    used = [[row.utilisation for row in run.verdict.table() if row.checked and row.utilisation < math.inf] for run in runs]
    each = [max(one, default=math.nan) for one in used]
    assert mission.pairs["utilisation"].values == pytest.approx(each, rel=1e-9)
    assert mission.governing == int(np.argmax(each))
    force = np.max([np.abs(run.forces[next(iter(run.forces))].drive_force.values).max(axis=0) for run in runs], axis=0)
    assert mission.drives["value"].sel(quantity="force").values == pytest.approx(force, rel=1e-9)
    members = np.max([run.sections[next(iter(run.sections))].section_T.values.max(axis=(0, 2)) for run in runs], axis=0)
    assert np.all(mission.extremes["value"].sel(quantity="tension").values >= members - 1e-9 * np.abs(members))


@pytest.mark.slow
@settings(max_examples=6, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.tuples(share, share), min_size=1, max_size=3), st.floats(50, 900))
def test_the_envelope_is_the_worst_of_the_runs_done_one_by_one(moves, force):
    model = crane([(0.2 * a, 0.2 * b) for a, b in moves], (round(force, 1), 100.0))
    assert_worst_of(kt.run(model), one_by_one(model))


@pytest.mark.slow
def test_active_members_and_their_motors_too():
    bay = kt.library.vgt.double_octahedral(bays=1, gravity=(0, 0, -9.81), payload_mass=20.0, material="aluminium_6061_t6")
    model = bay.with_(
        trajectories={
            "up": kt.Quintic(moves={"bay.beta": (0, 0.15)}, duration=1.0),
            "side": kt.Quintic(moves={"bay.gamma": (0, 0.1)}, duration=0.5),
        },
        conditions={"plain": kt.Condition(), "lying": kt.Condition(gravity=(0, -9.81, 0))},
        runs={"all": kt.Run(analysis="mission", motions=("up", "side"), conditions=("plain", "lying"), samples=41)},
    )
    assert_worst_of(kt.run(model), one_by_one(model))


def test_motors_have_their_peaks_over_all_pairs():
    model = kt.read(kt.library.example_files()["double_octahedral_slew"][0])
    name = next(iter(model.runs))
    asked = {"all": kt.Run(analysis="mission", motions=(name,), conditions=("still", "heavy"))}
    model = model.with_(
        conditions={"still": kt.Condition(), "heavy": kt.Condition(gravity=(0, 0, -15.0))}, runs={**model.runs, **asked}
    )
    mission, runs = kt.run(model, "all"), one_by_one(model)
    for quantity in ("current", "voltage", "torque", "rms current"):
        wanted = np.max([run.demand[next(iter(run.demand))].value.sel(quantity=quantity).values for run in runs], axis=0)
        assert mission.trains["value"].sel(quantity=quantity).values == pytest.approx(wanted, rel=1e-9)
    energy = np.max([run.demand[next(iter(run.demand))].drawn_energy.values for run in runs], axis=0)
    assert mission.trains["value"].sel(quantity="drawn energy").values == pytest.approx(energy, rel=1e-9)


@pytest.mark.slow
def test_drives_have_energy_and_root_mean_square_of_their_histories():
    model = crane()
    mission, runs = kt.run(model), one_by_one(model)
    energies, roots = [], []
    for run in runs:
        forces, t = next(iter(run.forces.values())), run.motion.time.values
        power = forces.drive_force.values * run.motion.drive_velocity.values
        energies.append(np.trapezoid(np.maximum(power, 0), t, axis=0))
        roots.append(np.sqrt(np.trapezoid(forces.drive_force.values**2, t, axis=0) / (t[-1] - t[0])))
    assert mission.drives["value"].sel(quantity="energy").values == pytest.approx(np.max(energies, axis=0), rel=1e-9)
    assert mission.drives["value"].sel(quantity="rms force").values == pytest.approx(np.max(roots, axis=0), rel=1e-9)
    for drive, record in model.all_drives.items():
        turns = record.kind == "angle"
        units = dict(zip(mission.drives.quantity.values, mission.drives.unit.sel(drive=drive).values, strict=True))
        assert (units["force"], units["rate"]) == (("N m", "rad/s") if turns else ("N", "m/s"))
        assert (units["power"], units["energy"]) == ("W", "J")


@pytest.mark.slow
def test_poses_are_motions_of_a_mission():
    model = crane()
    poses = {"low": {}, "high": {"lift": 1.4, "swing": 2.0}}
    model = model.with_(
        runs={
            "poses": kt.Run(analysis="statics.at_poses", poses=poses),
            "all": kt.Run(analysis="mission", motions=("poses", "move0"), conditions=("plain", "laden"), samples=21),
        }
    )
    assert_worst_of(kt.run(model, "all"), one_by_one(model))


@pytest.mark.slow
def test_a_let_go_actuator_stands_in_equilibrium_and_swings_in_a_simulation():
    """Motions may be equilibria and simulations: a released drive is free in them, and the envelope has their forces."""
    start = {"lift": math.hypot(0.2, 1.3), "swing": math.hypot(1.4, 1.4)}
    prop = kt.Bar(ends=("A", "D"), kind="elastic", section=kt.Rod(diameter=0.004), natural_length=2.7)
    model = crane(
        bars={**crane().bars, "prop": prop},
        conditions={
            "plain": kt.Condition(),
            "loose": kt.Condition(released=("swing",)),
            "stuck": kt.Condition(locked=("lift",)),
        },
        runs={
            "stand": kt.Run(analysis="statics.equilibrium"),
            "fall": kt.Run(analysis="dynamics.simulate", t_end=0.2, samples=21, tasks={name: kt.Hold() for name in start}),
            "all": kt.Run(analysis="mission", motions=("stand", "fall"), conditions=("plain", "loose", "stuck")),
        },
    )
    mission, runs = kt.run(model, "all"), one_by_one(model)
    assert_worst_of(mission, runs)
    # let go, the prop holds the boom: moments about C of its free body
    loose = runs[2]
    assert str(mission.pairs["label"].values[2]) == "stand, loose, case0"
    x = loose.motion.data.position.isel(time=0)
    force = loose.forces["case0"].data.member_force.isel(time=0)
    A, C, D = (x.sel(node=name).values for name in "ACD")
    tube, rod = np.pi / 4 * (0.03**2 - 0.026**2), np.pi / 4 * 0.004**2
    weight = 9.81 * 7850 * (tube * (math.dist(C, D) + math.hypot(1.4, 1.4)) + rod * math.hypot(2.4, 1.4))
    load, arm, pull = np.array([20.0, -200.0 - weight / 2]), D - C, (A - D) / math.dist(A, D)
    about = arm[0] * load[1] - arm[1] * load[0]
    needed = -about / (arm[0] * pull[1] - arm[1] * pull[0])
    assert float(force.sel(member="prop")) == pytest.approx(needed, rel=2e-3)
    assert abs(float(force.sel(member="swing"))) < 1e-6 * abs(needed)


def test_what_a_condition_makes_impossible_is_a_finding_and_the_rest_goes_on():
    model = crane()
    model = model.with_(runs={"all": model.runs["all"].with_(conditions=("plain", "broken"))})
    mission = kt.run(model)
    assert mission.whole and len(mission.findings) == 4
    assert "4 of 8 pairs cannot be" in mission.message
    assert all("broken" in label for label in mission.findings)
    assert mission.verdict.table()[0].load_case.split(", ")[1] == "plain"
    text = report.summary(mission).text
    assert "what to know" in text
    assert (mission.finding.state, mission.finding.text) == ("open", "4 of 8 pairs cannot be")
    assert f"verdict: {mission.finding.sentence}\nwarning: " in text
    assert report.summary(mission).record["verdict"]["state"] == "open"
    assert report.lines(mission)[0].startswith("4 of 8 pairs cannot be. Governing: ")
    assert "4 of 8 pairs cannot be" in repr(mission)


def test_a_motor_beyond_its_limit_is_over_capacity_in_a_mission_too():
    """What a mission says counts the limits of its drives; the studio counted its members alone."""
    model = tripod(21)
    fast = model.runs["lift"].with_(trajectory=kt.Quintic(moves={"LA": (1.0295630, 1.15)}, duration=0.2))
    runs = {"fast": fast, "all": kt.Run(analysis="mission", motions=("fast",))}
    mission = kt.run(model.with_(runs=runs), "all")
    single = kt.run(model.with_(runs={"fast": fast}), "fast")
    found, alone = mission.finding, single.finding
    assert (found.state, found.kind) == ("over", "drive")
    assert (found.governing.part, found.governing.rule) == (alone.governing.part, alone.governing.rule)
    assert found.governing.utilisation == alone.governing.utilisation
    assert len(found.over) == len(alone.over)
    assert found.unlimited == alone.unlimited
    assert report.lines(mission)[1].endswith("that were checked are exceeded.")


@pytest.mark.slow
def test_a_mission_goes_on_after_its_last_pair(tmp_path):
    model, out = crane(), tmp_path / "out"
    whole = kt.run(model)

    def stop(done, _):
        if done == 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_mission(model, "all", out, progress=stop)
    part = kt.runs.load(out)
    assert (part.good, part.samples, part.state) == (5, 16, "incomplete") and not part.whole
    done = []
    again = kt.runs.resume(out, progress=lambda count, _: done.append(count))
    assert done[0] == 6 and again.whole
    for one in (again, kt.runs.load(out)):
        for name in ("value", "time_of", "pair"):
            assert np.array_equal(one.verdict.data[name].values, whole.verdict.data[name].values, equal_nan=True)
        assert one.pairs.identical(whole.pairs)
        assert one.drives.identical(whole.drives)
        assert one.extremes.identical(whole.extremes)


@pytest.mark.slow
def test_memory_does_not_grow_with_the_pairs():
    def peak(cases):
        model = crane(loads=tuple(np.linspace(50, 400, cases)))
        model = model.with_(runs={"all": kt.Run(analysis="mission", motions=("move0",), samples=401)})
        kt.run(model)
        tracemalloc.start()
        kt.run(model)
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return found

    few, many = peak(4), peak(40)
    assert many < 1.5 * few


@pytest.mark.slow
def test_a_long_motion_is_streamed_in_blocks(monkeypatch):
    from kinetruss.runs import missions as stream

    model = crane()
    whole = kt.run(model)
    monkeypatch.setattr(stream, "HELD", 0.0)
    monkeypatch.setattr("kinetruss.runs.plans.block_size", lambda _: 7)
    parts = kt.run(model)
    assert parts.verdict.data["value"].values == pytest.approx(whole.verdict.data["value"].values, rel=1e-9, nan_ok=True)
    assert parts.drives["value"].values == pytest.approx(whole.drives["value"].values, rel=1e-9)


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_every_command_shows_a_mission(tmp_path):
    out = str(tmp_path / "out")
    kt.run(crane(), "all", out)
    page, told = shown(tmp_path / "out", tmp_path)
    done = CliRunner().invoke(main, ["export", out, str(tmp_path / "wind.csv"), "--group", "wind"])
    assert f"The governing pair of {out} has no 'wind'. It has: motion" in done.stderr and "kinetruss-" not in done.stderr
    assert told["pairs_done"] == 16 and told["envelope"][0]["utilisation"] > 0
    assert "Report of a mission" in page


@pytest.mark.slow
def test_a_report_tells_of_infinite_utilisation(tmp_path):
    """Beyond Euler's load the beam-column rule has no finite number: the page has it as a text, and is written."""
    model = crane(loads=(4e5,))
    kt.run(model, out=tmp_path / "out")
    words = ["report", str(tmp_path / "out"), "-o", str(tmp_path / "page"), "--no-open", "--no-pdf", "--no-view"]
    done = CliRunner().invoke(main, words)
    assert done.exit_code == 0, (done.output, done.exception)
    page = (tmp_path / "page" / "report.html").read_text("utf-8")
    kept = json.loads(page.split('id="kinetruss-report">')[1].split("</script>")[0])
    assert kept["worked"] and '"Infinity"' in page


@pytest.mark.parametrize(
    ("fields", "said"),
    [
        ({}, "the mission is empty"),
        ({"motions": ("move0",), "conditions": ()}, "conditions is empty"),
        ({"motions": ("move0", "move0")}, "names 'move0' twice"),
        ({"motions": ("move0",), "condition": "hot"}, "belongs to one run"),
        ({"motions": ("mov0",)}, "no run or trajectory called 'mov0'"),
        ({"motions": ("move0",), "conditions": ("hott",)}, "no condition called 'hott'"),
        ({"motions": ("still",)}, "has no motion and no poses of its own"),
        ({"motions": ("move0",), "load_cases": ("windy",)}, "no load case called 'windy'"),
    ],
)
def test_what_is_wrong_with_a_mission_is_told_before_any_work(fields, said):
    with pytest.raises(kt.ModelError, match=said):
        crane(runs={"still": kt.Run(analysis="statics.linear"), "all": kt.Run(analysis="mission", **fields)})
