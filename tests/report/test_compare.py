"""Runs compared: what can be shown by name, how runs are told apart, the table of maxima."""

import csv
import json

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report, runs, strength
from kinetruss.errors import InputError
from kinetruss.report import curves
from kinetruss.report.comparisons import run_labels
from kinetruss.report.pictures import ALIASES, BUNDLES, QUANTITIES
from kinetruss.report.pictures.quantities import ELASTIC, SIMULATION, TURNING
from kinetruss.report.plots import specification
from samples import fourbar, tripod

LIFT = "runs.lift.trajectory.duration"


@pytest.fixture(scope="module")
def slow_and_fast():
    """Two durations of the tripod."""
    return list(runs.run_variants(tripod(), {LIFT: ["1 s", "2"]}).values())


@pytest.fixture(scope="module")
def truss():
    """The triangular truss in 3 s."""
    return runs.run(kt.read(kt.library.example_files()["triangular_truss"][0]))


@pytest.fixture(scope="module")
def let_go():
    """A double pendulum that falls, twice."""
    model = kt.read(kt.library.example_files()["double_pendulum"][0])
    return list(runs.run_variants(model, {"runs.fall.t_end": ["1 s", "2"], "runs.fall.samples": ["41"]}, "fall").values())


@pytest.fixture(scope="module")
def turned():
    """A geared crank in two durations."""
    gear, motor = kt.Gear(ratio=5.0), kt.library.drives.MOTOR_LACY
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=1.0)}, fixed=["O"], gravity=(0, -9.81),
        bars={"crank": kt.Bar(ends=("O", "A"), mass=0)}, drives={"turn": kt.AngleDrive("crank", gear=gear, motor=motor)},
        runs={"lift": kt.Run(trajectory=kt.Quintic(moves={"turn": (0, 1.0)}, duration=1.0), samples=41)},
    )  # fmt: skip
    return list(runs.run_variants(model, {LIFT: ["1 s", "2"]}).values())


@pytest.mark.slow
@pytest.mark.parametrize("name", TURNING)
def test_torque_and_rate_of_a_geared_angle_with_what_holds_it(turned, slow_and_fast, name):
    (panel,) = specification(turned, name).panels
    assert panel.unit in ("N m", "rad/s")
    (curve,) = curves(turned[0], name)
    if name == "drive_torque":
        position = turned[0].motion.data["drive_position"].values[:, 0]
        np.testing.assert_allclose(curve.static, 9.81 * 0.4 * np.cos(position), atol=1e-12)
    with pytest.raises(InputError, match="no quantity"):
        curves(slow_and_fast[0], name)


@pytest.mark.slow
@pytest.mark.parametrize("name", [*(name for name in QUANTITIES if name not in (*TURNING, *ELASTIC)), *ALIASES, *BUNDLES])
def test_every_name_shows_something_with_a_unit(slow_and_fast, let_go, name):
    told = {*SIMULATION, *(bundle for bundle, names in BUNDLES.items() if {*names} & {*SIMULATION})}
    figure = specification(let_go if name in told else slow_and_fast, name)
    assert figure.panels
    for panel in figure.panels:
        assert panel.unit or name in ("singularity", *SIMULATION[5:])
        assert all(len(values) == 41 for values in panel.lines.values())
        assert len(panel.lines) <= 14


def test_names_are_those_of_the_results(truss):
    data = [truss.motion.data, truss.forces["all"].data, truss.sections["all"].data, truss.demand["all"].data]
    timed = {str(name) for one in data for name, variable in one.data_vars.items() if variable.dims[:1] == ("time",)}
    assert timed - set(QUANTITIES) == {"part_length", "part_start"}  # where a section lies: nothing to look at


def test_stress_is_the_largest_along_the_member_with_the_same_at_rest(truss):
    (curve,) = curves(truss, "von_mises", ["follower"])
    total = strength.stresses(truss.model, truss.sections["all"])["von_mises"].sel(part="follower").max("station")
    still = strength.sections(truss.model, truss.forces["all"].static)
    rest = strength.stresses(truss.model, still)["von_mises"].sel(part="follower").max("station")
    np.testing.assert_array_equal(curve.values, total.values)
    np.testing.assert_array_equal(curve.static, rest.values)
    assert curve.unit == "Pa"


def test_a_signed_component_is_that_of_one_station(truss):
    (curve,) = curves(truss, "bending_3", ["follower"])
    stress = strength.components(truss.model, truss.sections["all"])["bending_3"].sel(part="follower").values
    column = np.abs(stress).max(axis=0).argmax()
    np.testing.assert_array_equal(curve.values, stress[:, column])
    (end,) = curves(truss, "axial", ["follower"], station=1.0)
    np.testing.assert_array_equal(end.values, strength.components(truss.model, truss.sections["all"])["axial"].sel(
        part="follower").values[:, -1])  # fmt: skip


def test_a_member_stands_for_its_parts_and_those_without_section_are_left_out(truss):
    assert [curve.of for curve in curves(truss, "von_mises", ["actuator"])] == ["actuator.tube"]
    with pytest.raises(InputError, match="no von_mises of actuator.base: it needs a section and a material"):
        curves(truss, "von_mises", ["actuator.base"])


def test_at_rest_the_actuator_holds_the_member_force(truss):
    (curve,) = curves(truss, "thrust", ["actuator"])
    held = truss.forces["all"].static.member_force.sel(member="actuator").values
    np.testing.assert_array_equal(curve.static, -held)


def test_units_of_drives_by_their_kind(truss):
    assert curves(truss, "drive_velocity")[0].unit == "m/s"
    turned = runs.run(fourbar(11))
    assert [curves(turned, name)[0].unit for name in ("drive_position", "drive_acceleration", "drive_force")] == [
        "rad", "rad/s^2", "N m"
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("quantity", "members", "message"),
    [
        ("von_mise", (), "no quantity called 'von_mise'. Did you mean 'von_mises'"),
        ("von_mises", ("LB.tub",), "'LB.tub' is not in von_mises. Did you mean 'LB.tube'"),
        ("energy", ("LA",), "leave out --member"),
    ],
)
def test_the_nearest_names_are_offered(slow_and_fast, quantity, members, message):
    with pytest.raises(InputError, match=message):
        specification(slow_and_fast, quantity, members)


def test_wrong_stations_and_cases(slow_and_fast):
    with pytest.raises(InputError, match="has no stations"):
        specification(slow_and_fast, "member_force", station=0.5)
    with pytest.raises(InputError, match="not a fraction"):
        specification(slow_and_fast, "von_mises", station=2)
    with pytest.raises(InputError, match="No load case called 'pushd'. Did you mean 'pushed'"):
        specification(slow_and_fast, "member_force", case="pushd")
    turned = runs.run(fourbar(11))
    with pytest.raises(InputError, match="no quantity called 'current'"):
        specification([turned], "current")


def test_runs_are_told_apart_by_what_was_set(slow_and_fast):
    assert run_labels(slow_and_fast) == ["duration 1 s", "duration 2 s"]
    figure = specification(slow_and_fast, "von_mises", ["LA.tube"])
    assert list(figure.panels[0].lines) == list(figure.panels[0].dashed) == ["duration 1 s", "duration 2 s"]
    assert figure.time[-1] == 2
    assert figure.panels[0].times["duration 1 s"][-1] == 1
    assert figure.title == "Largest von Mises stress over the section: LA.tube"


@pytest.mark.slow
def test_runs_are_told_apart_by_their_models_or_else_by_their_folders(tmp_path):
    made = [runs.run(tripod(5, gravity=(0, 0, g)), out=tmp_path / f"g{k}") for k, g in enumerate((-9.81, -1.62))]
    assert run_labels(made) == ["2 -9.81", "2 -1.62"] or run_labels(made) == ["gravity.2 -9.81", "gravity.2 -1.62"]
    other = runs.run(fourbar(5), out=tmp_path / "turn")
    assert run_labels([made[0], other]) == ["g0", "turn"]
    assert run_labels([made[0], made[0]]) == ["g0 (1)", "g0 (2)"]
    assert run_labels([other]) == ["turn"]


def test_maxima_with_their_times(slow_and_fast):
    found = report.compare(slow_and_fast, "member_force", members=["LB"], case="pushed").found
    assert [row.run for row in found] == ["duration 1 s", "duration 2 s"]
    for row, run in zip(found, slow_and_fast, strict=True):
        force = run.forces["pushed"].member_force.sel(member="LB")
        rest = run.forces["pushed"].static.member_force.sel(member="LB")
        at = int(abs(force).argmax("time"))
        assert (row.maximum, row.time) == (float(force[at]), float(force.time[at]))
        assert row.static_maximum == float(rest[int(abs(rest).argmax("time"))])
        assert row.ratio == pytest.approx(abs(row.maximum / row.static_maximum))
        assert row.motion_maximum == pytest.approx(float((force - rest)[int(abs(force - rest).argmax("time"))]))
        assert row.settings == {LIFT: row.run.split()[1].replace("1", "1 s")}


def test_slower_is_nearer_to_rest(slow_and_fast):
    """The same path in twice the time: what the motion adds to a force falls to a quarter."""
    fast, slow = report.compare(slow_and_fast, "member_force", members=["LA"]).found
    assert slow.motion_maximum == pytest.approx(fast.motion_maximum / 4, rel=1e-9)


def test_without_members_the_largest_of_all_counts(slow_and_fast):
    rows = report.compare(slow_and_fast, "member_force").found
    assert len(rows) == 2
    largest = abs(slow_and_fast[0].forces["standing"].member_force).max().item()
    assert abs(rows[0].maximum) == largest


def test_usual_quantities_are_those_that_all_have(slow_and_fast):
    assert {row.quantity for row in report.compare(slow_and_fast).found} == {
        "von_mises", "thrust", "drive_velocity", "motor_torque", "current", "voltage"
    }  # fmt: skip
    assert {row.quantity for row in report.compare([runs.run(fourbar(11))]).found} == {"von_mises", "drive_velocity"}


def test_the_table_as_text_data_and_file(slow_and_fast, tmp_path):
    page = report.compare(slow_and_fast)
    found, text = page.found, page.text.splitlines()
    assert len(text) == 1 + len(found)
    assert text[0].split()[:4] == ["quantity", "of", "run", "maximum"]
    assert json.loads(json.dumps(page.record))[0]["settings"] == {LIFT: "1 s"}
    with page.write(tmp_path / "new" / "maxima.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [float(row["maximum"]) for row in rows] == [one.maximum for one in found]
    assert [row[LIFT] for row in rows[:2]] == ["1 s", "2"]
    with pytest.raises(InputError, match=r"written as \.csv"):
        page.write(tmp_path / "maxima.xls")


def test_names_told_once_in_the_legend(slow_and_fast):
    from kinetruss.report.pictures.draw import draw

    canvas = draw(specification(slow_and_fast, "motion", ["LA"]))
    legends = [axes.get_legend() for axes in canvas.axes]
    assert [text.get_text() for text in legends[0].get_texts()] == ["duration 1 s", "duration 2 s"]
    assert legends[1] is legends[2] is None


@pytest.mark.slow
def test_long_names_are_not_cut():
    from kinetruss.report.pictures.draw import draw

    many = runs.run_variants(tripod(5), {LIFT: [1, 2], "nodes.T.mass": ["20 kg", "30 kg"], "nodes.T.at.2": ["0.9 m", "0.91 m"]})
    kept = [run for run in many.values() if run.good]
    canvas = draw(specification(kept, "thrust", ["LA"]))
    canvas.draw_without_rendering()
    frame = canvas.axes[0].get_legend().get_window_extent()
    assert frame.x1 <= canvas.bbox.x1
