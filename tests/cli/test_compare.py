"""Variants, their pictures and their table from the command line."""

import json
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import kinetruss as kt
from kinetruss import runs
from kinetruss.cli import main
from samples import tripod

TRIANGLE = kt.library.example_files()["triangular_truss"][0]
DURATION = "runs.extend.trajectory.duration"


def call(*arguments: object) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three durations of the triangular truss."""
    path = tmp_path_factory.mktemp("compare") / "out"
    done = call("run", TRIANGLE, "--set", f"{DURATION}=3,5,10", "--set", "runs.extend.samples=61", "-o", path)
    assert done.exit_code == 0, done.output
    assert "3 runs in" in done.stdout
    assert done.stderr == ""
    return path


@pytest.mark.slow
def test_each_variant_is_a_run_like_any_other(out):
    assert sorted(path.name for path in out.iterdir()) == ["duration=10", "duration=3", "duration=5"]
    assert "61 samples, t = 0 to 10 s" in call("info", out / "duration=10").stdout
    assert call("info", out / "duration=10", "--joints", "--member", "follower").exit_code == 0
    assert call("plot", out / "duration=5").exit_code == 0
    assert call("export", out / "duration=5", out.parent / "five.csv").exit_code == 0


@pytest.mark.slow
def test_variants_overlaid(out, tmp_path):
    paths = sorted(out.iterdir())  # what a shell makes of out/*
    done = call("plot", *paths, "--quantity", "von_mises", "--member", "follower", "-o", tmp_path / "a.png")
    assert (done.exit_code, done.stdout.strip()) == (0, str(tmp_path / "a.png"))
    whole = call("plot", out, "--quantity", "von_mises", "--member", "follower", "-o", tmp_path / "b.png")
    assert whole.exit_code == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize(
    "arguments",
    [
        "motion --member actuator",
        "von_mises --member follower",
        "components --member follower",
        "actuator_force",
        "torque --quantity current --quantity voltage",
    ],
)
def test_every_figure_of_the_thesis_by_one_command(out, tmp_path, arguments):
    done = call("plot", out, "--quantity", *shlex.split(arguments), "-o", tmp_path / "figure.svg")
    assert done.exit_code == 0, done.output
    assert "duration 10 s" in (tmp_path / "figure.svg").read_text()


def test_the_help_names_the_quantities():
    text = call("plot", "-h").stdout
    for name in (
        "von_mises",
        "S1",
        "bending_2",
        "shear_3",
        "drive_acceleration",
        "motor_torque",
        "current",
        "voltage",
        "thrust",
    ):
        assert name in text


@pytest.mark.slow
def test_wrong_names_are_answered_with_the_nearest(out, tmp_path):
    done = call("plot", out, "--quantity", "von_mise", "-o", tmp_path / "a.png")
    assert (done.exit_code, "Did you mean 'von_mises'?" in done.stderr) == (2, True)
    done = call("plot", out, "--quantity", "von_mises", "--member", "folower", "-o", tmp_path / "a.png")
    assert (done.exit_code, "Did you mean 'follower'?" in done.stderr) == (2, True)
    assert list(tmp_path.iterdir()) == []


def test_ten_seconds_come_near_rest(out, tmp_path):
    done = call("compare", out, "--quantity", "von_mises", "--member", "follower", "--json", "-o", tmp_path / "maxima.csv")
    rows = json.loads(done.stdout)["rows"]
    assert [row["run"] for row in rows] == ["duration 3 s", "duration 5 s", "duration 10 s"]
    distance = [row["motion_maximum"] / row["static_maximum"] for row in rows]
    assert distance[0] > 0.14 > distance[1] > 0.05
    assert distance[2] == pytest.approx(0.09 * distance[0], rel=1e-9)
    assert (tmp_path / "maxima.csv").read_text().startswith(f"{DURATION},")
    text = call("compare", out).stdout.splitlines()
    assert "at rest" in text[0]
    assert len(text) == 1 + 6 * 3


def test_an_unknown_parameter_stops_before_any_work(tmp_path):
    wanted = {
        "runs.extend.trajectory.duraton=3": "Did you mean 'duration'?",
        "runs.extnd.samples=3,4": "Did you mean 'extend'?",
        "library.payload_mas=3": "Did you mean 'payload_mass'",
        f"{DURATION}=3,4 kg": "'4 kg' is not a time (s). Write for example",
        "library.payload_mass=3 s": "'3 s' is not a mass (kg)",
        f"{DURATION}": "has no value",
        f"{DURATION}=": "empty value",
        f"{DURATION}=3,,5": "empty value",
        f"{DURATION}=3,3": "a value twice",
    }
    for setting, message in wanted.items():
        done = call("run", TRIANGLE, "--set", setting, "-o", tmp_path / "out")
        assert (done.exit_code, message in done.stderr) == (2, True), f"{setting}\n{done.output}"
    twice = call("run", TRIANGLE, "--set", f"{DURATION}=3", "--set", f"{DURATION}=5", "-o", tmp_path / "out")
    assert (twice.exit_code, "given twice" in twice.stderr) == (2, True)
    assert call("run", TRIANGLE, "fold", "--set", f"{DURATION}=3,4", "-o", tmp_path / "out").exit_code == 2
    assert list(tmp_path.iterdir()) == []


def test_what_does_not_go_with_set(out, tmp_path):
    assert call("run", "--resume", out / "duration=3", "--set", f"{DURATION}=3").exit_code == 2
    assert call("run", TRIANGLE, "--set", f"{DURATION}=3,4", "-o", tmp_path / "out", "--pictures").exit_code == 2


def test_a_folder_with_runs_is_replaced_only_when_told(out):
    again = ["run", TRIANGLE, "--set", f"{DURATION}=3,5,10", "--set", "runs.extend.samples=61", "-o", out]
    done = call(*again)
    assert (done.exit_code, "--overwrite" in done.stderr) == (2, True)
    assert call(*again, "--overwrite", "-q").stdout == ""


def test_values_in_brackets_and_json(tmp_path):
    done = call("run", TRIANGLE, "--set", "gravity=[0, -9.81],[0, -1.62 m/s^2]", "--set", "runs.extend.samples=5", "--json",
                "-o", tmp_path / "out")  # fmt: skip
    record = json.loads(done.stdout)
    assert record["schema"] == "kinetruss.variants/1"
    assert [entry["name"] for entry in record["variants"]] == ["gravity=0,-9.81", "gravity=0,-1.62m-s-2"]
    assert [entry["settings"]["gravity"] for entry in record["variants"]] == ["[0, -9.81]", "[0, -1.62 m/s^2]"]
    assert runs.load(record["variants"][1]["path"]).model.gravity == (0, -1.62)
    assert all(entry["worst"]["utilisation"] > 0 for entry in record["variants"])


@pytest.mark.slow
def test_a_variant_that_ends_early_is_said_and_the_exit_code_is_1(tmp_path):
    kt.write(tripod(11), tmp_path / "tripod.yaml")
    done = call("run", tmp_path / "tripod.yaml", "--set", "runs.lift.trajectory.moves.LA.1=1.15 m,9 m", "-o", tmp_path / "out")
    assert done.exit_code == 1
    assert [line.split()[1] for line in done.stdout.splitlines()[1:3]] == ["done", "out"]
    again = call("run", tmp_path / "tripod.yaml", "--set", "runs.lift.trajectory.moves.LA.1=1.15 m,9 m", "--json", "-o",
                 tmp_path / "json")  # fmt: skip
    assert [entry["whole"] for entry in json.loads(again.stdout)["variants"]] == [True, False]


def test_a_folder_without_runs_is_said(tmp_path):
    done = call("compare", tmp_path)
    assert (done.exit_code, "holds no run" in done.stderr) == (2, True)
    (tmp_path / "file").write_text("")
    assert "no run folder" in call("plot", tmp_path / "file").stderr
