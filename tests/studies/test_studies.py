"""Studies: their files, their points, and numbers that are those of single runs."""

import csv
import json
import math

import duckdb
import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner
from scipy.stats import qmc

import kinetruss as kt
from kinetruss import runs, studies
from kinetruss.cli import main
from kinetruss.errors import InputError, ModelError, StoreError
from kinetruss.studies import evaluating
from kinetruss.studies.brief_runs import LEVELS
from kinetruss.studies.evaluating import Task, evaluate
from kinetruss.studies.sampling import points_of
from kinetruss.studies.side_by_side import Copies
from samples import fourbar, tripod

RESULTS = {
    "peak": "peak_member_force", "power": "peak_drive_power", "mass": "mass", "crank": "max(abs(member_force[crank]))/kN",
    "tip": "max(position[C, y])",
}  # fmt: skip
PEAK = {"peak": "peak_member_force"}
MASSES = {"nodes.C.mass": {"between": ["0.2 kg", "1 kg"]}}


def study_of(**changes):
    given = {"model": fourbar(61), "run": "turn", "variables": MASSES, "sample": {"grid": 5}, "results": PEAK}
    return studies.Study(**(given | changes))


def done(**changes):
    return studies.run_study(study_of(**changes), workers=0)


# Files.

FILE = """\
model: four_bar.yaml
run: turn
variables:
  nodes.C.mass: {between: [0.2 kg, 1 kg]}
sample: {sobol: 8}
"""


@pytest.fixture
def file(tmp_path):
    kt.write(fourbar(21), tmp_path / "four_bar.yaml")
    (tmp_path / "mass.study.yaml").write_text(FILE)
    return tmp_path / "mass.study.yaml"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("sobol: 8", "sobol: 9", r":5:\d+: sample: sobol: 9 is no power of two.*for example 8"),
        ("sobol: 8", "sobel: 8", r":5:\d+: sample\.sobel: .*Did you mean 'sobol'"),
        ("[0.2 kg, 1 kg]", "[0.2 kg, 1 m]", r":4:\d+: variables\.nodes\.C\.mass.* two numbers with the same unit"),
        ("[0.2 kg, 1 kg]", "[1 kg, 0.2 kg]", r":4:\d+: variables.* Give the smaller number first"),
        ("between", "normel", r":4:\d+: variables.*normel.*Did you mean 'normal'"),
        ("sobol: 8", "grid: 1", r"variables\.nodes\.C\.mass is between two numbers"),
        ("nodes.C.mass", "nodes.Q.mass", r":4:3: variables\.nodes\.Q\.mass: nodes\.Q\.mass: 'Q' is not known here"),
        (
            "nodes.C.mass: {between: [0.2 kg, 1 kg]}",
            "title: [a, b]",
            r":4:3: variables\.title: does nothing.*'turn' depends on",
        ),
        ("nodes.C.mass", "safety.yielding", r":4:3: variables\.safety\.yielding: yielding: '0\.\d* kg' is not a number"),
        ("run: turn", "run: turm", r"no run called 'turm'"),
        ("model:", "kinetruss: 1\nmodel:", r":1:1: kinetruss: is a model, not a study"),
        ("four_bar.yaml", "fourbar.yaml", r"fourbar\.yaml: model: there is no such file.*four_bar\.yaml"),
    ],
)
def test_faults_are_told_before_work_with_their_place(file, tmp_path, old, new, message):
    file.write_text(FILE.replace(old, new))
    with pytest.raises(InputError, match=f"(?s){message}"):
        studies.run_study(file, tmp_path / "out", workers=0)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"results": {"peak": "max(abs(member_farce))"}}, r"results\.peak: .*'member_farce'.*member_force"),
        ({"results": {"peak": "member_force[crank]"}}, "no single number: it has one for each time"),
        (
            {"results": PEAK, "variables": {"safety.yielding": ["1", "2"]}, "sample": None},
            "does nothing to",
        ),
        ({"variables": {"a": {"paths": ["nodes.C.mass"], "values": ["1", "2"]}} | MASSES}, "as 'a' does"),
        ({"sample": None}, "is a range, and the study has no sample"),
    ],
)
def test_results_and_variables_that_say_nothing(changes, message):
    with pytest.raises(InputError, match=message):
        studies.run_study(study_of(**changes), workers=0)


# Points.


def test_points_are_those_of_their_distribution():
    two = {"a": {"between": ["1 mm", "3 mm"]}, "b": {"normal": ["0 N", "2 N"]}, "c": ["x", "y", "z"]}
    points = points_of(study_of(variables=two, sample={"sobol": 4096, "seed": 7}))
    a, b, c = (np.array(column) for column in zip(*points.rows, strict=True))
    assert points.units == ("mm", "N", None)
    np.testing.assert_allclose(np.histogram(a, 64, (1, 3))[0], 64)  # a net: as many in each interval
    assert abs(b.mean()) < 1e-2
    assert b.std() == pytest.approx(2, rel=1e-2)
    assert {name: int((c == name).sum()) for name in "xyz"} == pytest.approx({"x": 1365, "y": 1365, "z": 1365}, abs=2)
    again = points_of(study_of(variables=two, sample={"sobol": 4096, "seed": 7}))
    assert again.rows == points.rows


def test_a_latin_hypercube_has_one_point_in_every_slice():
    points = points_of(study_of(sample={"latin_hypercube": 50}, variables=MASSES | {"b": {"between": ["0", "1"]}}))
    for k, (low, width) in enumerate([(0.2, 0.8), (0, 1)]):
        slices = [int(50 * (row[k] - low) / width) for row in points.rows]
        assert sorted(slices) == list(range(50))


def test_points_of_python_and_of_a_table(tmp_path):
    cube = qmc.Halton(1, rng=1).random(6)
    assert [row[0] for row in points_of(study_of(sample=None), cube).rows] == pytest.approx((0.2 + 0.8 * cube[:, 0]).tolist())
    with pytest.raises(InputError, match=r"have the shape \(6, 2\)"):
        points_of(study_of(), np.zeros((6, 2)))
    (tmp_path / "p.csv").write_text('nodes.C.mass, gravity\n0.5 kg, ~\n0.7 kg, "[0, -9.81 m/s^2]"\n')
    points = points_of(study_of(variables={}, sample={"table": str(tmp_path / "p.csv")}))
    assert (points.units, points.rows[1]) == (("kg", None), (0.7, "[0, -9.81 m/s^2]"))
    (tmp_path / "p.csv").write_text("nodes.C.mass\n0.5 kg\n\n0.5 kg, 3\n")
    with pytest.raises(ModelError, match=r"p\.csv:4:1: table: has 2 cells, expected 1"):
        points_of(study_of(variables={}, sample={"table": str(tmp_path / "p.csv")}))


# Numbers.


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("rows", [3, 70])
def test_numbers_are_those_of_single_runs(level, rows):
    """Alone and many in one sweep, with a mass, a place and a length of their own."""
    model, random = fourbar(61), np.random.default_rng(0)
    values = [
        (k, {"nodes.C.mass": float(a), "nodes.C.at.1": float(b), "nodes.B.mass": float(c)})
        for k, (a, b, c) in enumerate(random.uniform((0.1, 0.24, 0.2), (1.0, 0.26, 0.9), (rows, 3)))
    ]
    task = Task(model.model_dump_json(), "turn", tuple(RESULTS.items()), level=level)
    assert (evaluating.ready(task, values)[2] is not None) == (rows == 70 and level == LEVELS[0])
    found = evaluate(task, values)
    for k in range(0, rows, max(1, rows // 8)):
        want = studies.scalars(runs.run(kt.io.set_values(model, values[k][1]), "turn"), RESULTS)
        assert (found[k].row, found[k].status) == (k, "COMPLETED")
        assert found[k].numbers == pytest.approx(want, rel=1e-11)


def test_copies_that_one_of_them_stops_are_done_alone():
    """One is no model, and one cannot turn; the others have their numbers."""
    model = fourbar(61)
    values = [(k, {"nodes.C.mass": 0.5 + 0.01 * k, "nodes.C.at.0": 0.3}) for k in range(20)]
    values[4][1]["nodes.C.mass"] = -1.0
    values[7][1]["nodes.C.at.0"] = -0.02
    task = Task(model.model_dump_json(), "turn", (("peak", "peak_member_force"),))
    found = {one.row: one for one in evaluate(task, values)}
    assert sorted(found) == list(range(20))
    assert (found[4].status, found[4].numbers) == ("REFUSED", None)
    assert "must not be negative" in found[4].message
    assert found[7].status in kt.results.Status.__members__
    assert (found[7].numbers, found[7].message != "") == (None, True)
    want = studies.scalars(runs.run(kt.io.set_values(model, values[19][1]), "turn"), {"peak": "peak_member_force"})
    assert found[19].numbers == pytest.approx(want, rel=1e-11)


def test_copies_are_for_what_they_can_do():
    with pytest.raises(InputError, match="changes where a drive begins"):
        Copies(fourbar(21), "turn", ["nodes.B.at.0"])
    with pytest.raises(InputError, match="no value of a part"):
        Copies(fourbar(21), "turn", ["runs.turn.trajectory.duration"])


def test_what_does_not_converge_has_no_number():
    path = "runs.lift.trajectory.moves.LA.1"
    found = done(model=tripod(), run="lift", variables={path: [1.15, 9.0, 1.2]}, sample=None)
    assert found.good.tolist() == [True, False, True]
    assert math.isnan(found.data["peak"].values[1])
    assert found.failures == {str(found.status[1]): 1}
    assert "t = " in str(found.data["message"].values[1])
    for k, length in ((0, 1.15), (2, 1.2)):
        want = studies.scalars(runs.run(kt.io.set_value(tripod(), path, length), "lift"), PEAK)
        assert found.data["peak"].values[k] == want["peak"]


def test_a_closed_form_and_its_sensitivities():
    """A mass on a rod of length r that turns at the rate w: m r w^2, whose Sobol indices follow from those of m and w^2."""
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=2.0)}, fixed=["O"], bars={"rod": kt.Bar(ends=("O", "A"), mass=0)},
        drives={"motor": kt.AngleDrive("rod")},
        runs={"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": 10.0}, duration=0.1), samples=3)},
    )  # fmt: skip
    variables = {
        "m": {"paths": ["nodes.A.mass"], "between": ["1000 g", "3000 g"]},
        "w": {"paths": ["runs.turn.trajectory.rates.motor"], "between": ["9", "11"]},
    }
    found = done(model=model, variables=variables, sample={"saltelli": 256}, results={"f": "max(member_force[rod])"})
    m, w = found.data["m"].values / 1000, found.data["w"].values
    np.testing.assert_allclose(found.data["f"].values, m * 0.5 * w**2, rtol=1e-12)
    assert found.data["f"].attrs["units"] == "N"
    assert found.nominal["f"] == pytest.approx(100.0)
    # variances of independent factors: D_m, D_q of m and q = w^2; first order of m: D_m E(q)^2/D
    Dm, Em, Eq = 4 / 12, 2.0, 100 + 4 / 12
    Dq = (11**5 - 9**5) / (5 * 2) - Eq**2
    D = (Dm + Em**2) * (Dq + Eq**2) - (Em * Eq) ** 2
    want = {"m": Dm * Eq**2 / D, "w": Dq * Em**2 / D}
    total = {"m": 1 - want["w"], "w": 1 - want["m"]}
    one = found.summary
    for name in ("m", "w"):
        assert one.first["f"][name] == pytest.approx(want[name], abs=3 * one.first_error["f"][name])
        assert one.total["f"][name] == pytest.approx(total[name], abs=3 * one.total_error["f"][name])
        assert 0 < one.first_error["f"][name] < 0.1
    assert one.slope["f"]["m"] == pytest.approx(0.5 * Eq / 1000, rel=0.02)  # N/g
    assert one.slope["f"]["w"] == pytest.approx(Em * 0.5 * 20, rel=0.05)  # N/(rad/s)


def test_a_run_of_statics_and_a_mission():
    rod = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")}, section=kt.Rod(diameter="10 mm"),
        material="steel_s235", loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))},
        runs={"pull": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    force = {"loads.pull.force.0": {"between": ["1 kN", "9 kN"]}}
    results = {"tip": "max(abs(displacement[B, x]))", "peak": "peak_displacement", "used": "max(utilisation)"}
    found = done(model=rod, run=None, variables=force, sample={"grid": 3}, results=results)
    F, EA = np.array([1e3, 5e3, 9e3]), 210e9 * math.pi * 0.005**2
    np.testing.assert_allclose(found.data["tip"].values, F * 2 / EA, rtol=1e-9)
    np.testing.assert_allclose(found.data["peak"].values, F * 2 / EA, rtol=1e-9)
    np.testing.assert_allclose(found.data["used"].values, F / (math.pi * 0.005**2) / 235e6, rtol=1e-9)
    one = fourbar(21)
    both = one.with_(runs={**one.runs, "all": kt.Run(analysis="mission", motions=["turn"])})
    drives = {"f": "peak_drive_force", "p": "peak_drive_power"}
    mission, single = done(model=both, run="all", results=drives), done(model=both, results=drives)
    for name in ("f", "p"):
        np.testing.assert_allclose(mission.data[name].values, single.data[name].values, rtol=1e-9)


def test_ishigami():
    """Indices of Ishigami's function by Saltelli's design, a = 7, b = 0.1: A. Saltelli et al., Sensitivity Analysis, 2000."""
    from kinetruss.studies.summaries import sobol_indices

    variables = {name: {"between": [str(-math.pi), str(math.pi)]} for name in "abc"}
    a, b, c = np.array(points_of(study_of(variables=variables, sample={"saltelli": 4096})).rows).T
    y = np.sin(a) + 7 * np.sin(b) ** 2 + 0.1 * c**4 * np.sin(a)
    base, first, total, first_error, total_error = sobol_indices(y, 4096, 3)
    assert base == 4096
    assert np.all(np.abs(first - [0.3139, 0.4424, 0.0]) < 4 * first_error + 1e-3)
    assert np.all(np.abs(total - [0.5576, 0.4424, 0.2437]) < 4 * total_error + 1e-3)
    assert np.all(total_error < 0.03)
    y[5] = np.nan  # a variant without a number takes its base point along
    assert sobol_indices(y, 4096, 3)[0] == 4095


# Folders.


def test_the_same_study_goes_on_and_another_is_refused(tmp_path, monkeypatch):
    out = tmp_path / "out"
    first = studies.run_study(study_of(), out, workers=0)
    monkeypatch.setattr("kinetruss.studies.working.evaluate", None)  # nothing is computed again
    again = studies.run_study(study_of(), out, workers=0)
    np.testing.assert_array_equal(first.data["peak"].values, again.data["peak"].values)
    np.testing.assert_array_equal(first.data["seconds"].values, again.data["seconds"].values)
    for changes, part in (
        ({"sample": {"grid": 6}}, "points"), ({"results": {"m": "mass"}}, "results"), ({"model": fourbar(62)}, "model"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=f"holds another study, with other .*{part}.*--overwrite"):
            studies.run_study(study_of(**changes), out, workers=0)
    runs.run(fourbar(5), out=tmp_path / "run")
    with pytest.raises(InputError, match="is no study, so it is never overwritten"):
        studies.run_study(study_of(), tmp_path / "run", workers=0, overwrite=True)
    with pytest.raises(StoreError, match="holds no study"):
        studies.load_study(tmp_path / "run")


def test_another_version_is_another_study(tmp_path, monkeypatch):
    studies.run_study(study_of(), tmp_path / "out", workers=0)
    monkeypatch.setattr("kinetruss.studies.working.__version__", "99")
    with pytest.raises(InputError, match="with other version of kinetruss"):
        studies.run_study(study_of(), tmp_path / "out", workers=0)


def test_results_are_read_by_pandas_and_duckdb(tmp_path):
    found = studies.run_study(study_of(variables=MASSES | {"gravity": ["~", "[0, -9.81 m/s^2]"]}), tmp_path / "out", workers=2)
    place = str(tmp_path / "out" / "results.parquet")
    frame = pd.read_parquet(place)
    assert frame["peak"].tolist() == found.data["peak"].values.tolist()
    assert frame["gravity"].tolist() == ["~", "[0, -9.81 m/s^2]"] * 5
    ((count, worst),) = duckdb.sql(
        f"select count(distinct row), max(peak) from '{place}' where status = 'COMPLETED'"
    ).fetchall()
    assert (count, worst) == (10, found.data["peak"].values.max())
    assert found.data.to_dataframe().loc[3, "nodes.C.mass"] == frame.loc[3, "nodes.C.mass"]


def test_a_study_in_use_is_refused(tmp_path):
    from kinetruss.results.lock import holding

    studies.run_study(study_of(), tmp_path / "out", workers=0)
    with holding(tmp_path / "out"), pytest.raises(StoreError, match="is being written by this process"):
        studies.run_study(study_of(), tmp_path / "out", workers=0)
    assert studies.load_study(tmp_path / "out").good.all()


# The command line and the page.


def test_the_command(file, tmp_path):
    out = tmp_path / "out"
    ended = CliRunner().invoke(main, ["study", str(file), "-o", str(out), "--json", "--pictures", "--workers", "1"])
    record = json.loads(ended.stdout)
    assert (ended.exit_code, record["variants"], record["good"]) == (0, 8, 8)
    assert record["summary"]["spread"]["mass"]["count"] == 8
    assert record["summary"]["slope"]["mass"]["nodes.C.mass"] == pytest.approx(1)
    assert {(out / "pictures" / name).is_file() for name in ("distributions.png", "scatter.svg")} == {True}
    shown = CliRunner().invoke(main, ["study", str(file), "-o", str(out)])
    assert "8 variants of run turn: all have numbers." in shown.stdout
    page = kt.report.study(studies.load_study(out))
    assert "peak_member_force" in page.html
    rows = list(csv.reader(page.write(tmp_path / "rows.csv").read_text().splitlines()))
    assert (len(rows), rows[0][:2]) == (9, ["row", "nodes.C.mass"])


def test_variants_of_a_model_are_the_simplest_study(file, tmp_path):
    out, model = tmp_path / "out", str(file.parent / "four_bar.yaml")
    wanted = ["--set", "nodes.C.mass=0.2 kg,1 kg", "--set", "gravity=~,[0, -9.81 m/s^2]"]
    ended = CliRunner().invoke(main, ["study", model, "turn", *wanted, "-o", str(out), "--json"])
    assert ended.exit_code == 0, ended.output
    found = studies.load_study(out)
    kept = runs.run_variants(model, {"nodes.C.mass": ["0.2 kg", "1 kg"], "gravity": ["~", "[0, -9.81 m/s^2]"]}, "turn")
    for k, run in enumerate(kept.values()):
        assert found.data["peak_member_force"].values[k] == studies.scalars(run)["peak_member_force"]
        assert found.data["peak_utilisation"].values[k] == studies.scalars(run)["peak_utilisation"]
    early = CliRunner().invoke(main, ["study", model, "turn", "--set", "nodes.C.mass=1 kg,-1 kg", "-o", str(tmp_path / "two")])
    assert early.exit_code == 1
    assert "1 refused" in early.stdout
    assert CliRunner().invoke(main, ["study", str(file), "turn", "-o", str(out)]).exit_code == 2


def test_gradients_at_the_model_as_it_is_and_parameters_in_other_processes():
    """The torque of a Delta robot by its arms: the regression over few variants near by is close to the exact gradient."""
    pick = kt.Positioning(node="Q", moves={"x": 0.2, "y": 0.1, "z": -0.7}, duration=0.3)
    delta = kt.library.mechanisms.delta().with_(runs={"pick": kt.Run(targets=pick, samples=11)})
    study = kt.studies.Study(
        model=delta, run="pick", sample={"latin_hypercube": 6}, results={"torque": "max(abs(drive_force))", "kg": "mass"},
        variables={"library.arm": {"between": ["345 mm", "355 mm"]}, "library.rod": {"between": ["795 mm", "805 mm"]}},
    )  # fmt: skip
    found = kt.studies.run_study(study, workers=2)
    assert found.good.all()
    exact = kt.gradient(kt.Response("max(abs(drive_force))", kt.run, delta), ["library.arm", "library.rod"]).values
    assert [*found.gradients["torque"].values()] == pytest.approx(exact, rel=1e-12)
    slope = found.summary.slope["torque"]
    assert [1e3 * slope[name] for name in found.gradients["torque"]] == pytest.approx(exact, rel=0.02)
    assert "gradient" in kt.report.study(found).text


def test_a_function_that_other_processes_cannot_find_is_told():
    model = kt.library.parametric(lambda span: _roof(span), span=4.0)
    study = kt.studies.Study(model=model, run="lean", variables={"parameters.span": ["3 m", "4 m"]}, results={"kg": "mass"})
    with pytest.raises(InputError, match="cannot find the function that builds the model"):
        kt.studies.run_study(study)


def _roof(span):
    return kt.Model(
        nodes={"A": (0, 0), "B": (span, 0), "C": (span / 2, 1.5)}, fixed=["A", "B"], bars={"l": ("A", "C"), "r": ("B", "C")},
        section=kt.Rod(diameter=0.02), material="steel_s235", runs={"lean": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
