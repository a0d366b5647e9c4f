"""``kinetruss explain``."""

import json

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main

EXAMPLES = {name: str(files[0]) for name, files in kt.library.example_files().items()}
SLEW = EXAMPLES["double_octahedral_slew"]


def call(*words):
    return CliRunner().invoke(main, ["explain", *map(str, words)])


def test_a_member_at_an_instant():
    """The line of the tutorial."""
    found = call(SLEW, "--member", "M6", "--time", "0.25")
    assert found.exit_code == 0
    assert "Free body of bar M6, A = N5 to B = N2; t = 0.25 s" in found.stdout
    same = call(SLEW, "--member", "M6", "--time", "250 ms")
    assert same.stdout == found.stdout


def test_exact_force_at_an_instant_between_samples(tmp_path):
    """M6 at its B end: 58.25112815 N at a quarter of the slew in one second."""
    fast = kt.io.set_values(kt.read(SLEW), {"trajectories.tilt.duration": 1.0})
    file = kt.write(fast, tmp_path / "fast.yaml")
    record = json.loads(call(file, "--member", "M6", "--time", "0.25", "--json").stdout)
    assert record["schema"] == "kinetruss.free_body/1"
    assert record["tension"]["B"] == pytest.approx(58.25112815, rel=1e-9)
    rest = json.loads(call(file, "--member", "M6", "--time", "0.25", "--json", "--rest").stdout)
    assert rest["tension"]["B"] != record["tension"]["B"]
    assert all(abs(x) < 1e-15 for body in rest["bodies"] for x in body["inertia"]["force"])


def test_default_instant_is_the_largest_force():
    record = json.loads(call(EXAMPLES["triangular_truss"], "--member", "follower", "--json").stdout)
    assert record["time"] == pytest.approx(1.735, abs=0.02)
    assert "load case all" in call(EXAMPLES["triangular_truss"], "--node", "B").stdout


@pytest.mark.slow
def test_systems(tmp_path):
    triangle = call(EXAMPLES["triangular_truss"], "--system", "--time", "0.6")
    assert "11 equations, 11 unknowns" in triangle.stdout
    file = tmp_path / "bay.csv"
    record = json.loads(call(SLEW, "--system", "--time", "0.25", "--csv", file, "--json").stdout)
    assert record["size"] == [117, 117]
    assert record["difference"] < 1e-12 * record["largest"] * record["condition"]
    assert record["csv"] == str(file)
    assert len(file.read_text().splitlines()) == 1 + 117 + 2
    apart = json.loads(call(SLEW, "--system", "--rods", "apart", "--time", "0.25", "--json").stdout)
    assert apart["size"] == [132, 132]


@pytest.mark.slow
def test_a_run_folder_and_a_model_without_runs(tmp_path):
    model = kt.read(EXAMPLES["four_bar"])
    kt.run(model, next(iter(model.runs)), tmp_path / "out")
    assert "Free body of bar crank" in call(tmp_path / "out", "--member", "crank", "--time", "0.1").stdout
    plain = kt.write(model.with_(runs={}), tmp_path / "still.yaml")
    assert "t = 0 s" in call(plain, "--member", "crank").stdout
    refused = call(plain, "--member", "crank", "--time", "1")
    assert refused.exit_code == 2
    assert "has no run" in refused.stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--member", "M66"], "No member called 'M66'. Did you mean"),
        (["--node", "N0"], "No node called 'N0'. Did you mean"),
        (["--member", "M6", "--time", "13"], "13 s is outside the run 'slew', 0 s to 12 s"),
        (["--member", "M6", "--time", "0,5"], "a comma in the number"),
        (["--member", "M6", "--time", "3 kg"], "is not a time"),
        (["--member", "M6", "--run", "slwe"], "no run called 'slwe'"),
        (["--member", "M6", "--case", "empty"], "No load case called 'empty'"),
        (["--member", "M6", "--node", "N1"], "Give one of --member NAME, --node NAME, --system."),
        ([], "Give one of"),
        (["--member", "M6", "--rods", "apart"], "--rods goes with --system"),
    ],
)
def test_wrong_usage(words, said):
    found = call(SLEW, *words)
    assert found.exit_code == 2
    assert said in found.stderr
    assert "Traceback" not in found.output
