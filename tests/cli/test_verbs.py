"""The command line: what it prints where, and how it exits."""

import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import xarray as xr
from click.testing import CliRunner, Result

import kinetruss as kt
from kinetruss import report, runs
from kinetruss.cli import main
from samples import fourbar, tripod

FAULTY = sorted((Path(__file__).parents[1] / "data" / "faulty").iterdir())
EARLY = """
kinetruss: 1
title: two legs
nodes: {A: [0, 0], B: [1.2, 0], T: [0.6, 0.8]}
fixed: [A, B]
bars:
  a: {ends: [A, T], kind: driven, mass: 1 kg}
  b: {ends: [B, T], mass: 1 kg}
runs:
  shrink: {trajectory: {kind: constant_rate, rates: {a: -1 m/s}, duration: 0.95 s}, samples: 101}
"""
LOOSE = """
kinetruss: 1
nodes: {A: [0, 0], B: [1, 0], C: [2, 0.5]}
fixed: [A]
bars: {a: {ends: [A, B], kind: driven, mass: 1}, b: {ends: [B, C], mass: 1}}
runs: {go: {trajectory: {kind: constant_rate, rates: {a: 0.1 m/s}, duration: 1 s}}}
"""


def call(*arguments: object) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a model file and its run."""
    path = tmp_path_factory.mktemp("cli")
    kt.write(tripod(21), path / "tripod.yaml")
    kt.write(fourbar(21), path / "fourbar.json")
    done = call("run", path / "tripod.yaml", "-o", path / "run", "-q")
    assert (done.exit_code, done.stdout) == (0, "")
    return path


def test_help_names_every_verb_and_shows_an_example():
    for flag in ("-h", "--help"):
        text = call(flag).stdout
        for verb in ("check", "run", "info", "verify", "examples", "export", "plot", "Example", "Exit codes"):
            assert verb in text
    for verb in main.commands:
        assert "kinetruss " + verb in call(verb, "-h").stdout


def test_version():
    assert call("--version").stdout.strip() == f"kinetruss, version {kt.__version__}"


@pytest.mark.slow
def test_help_and_check_load_nothing_heavy(folder):
    heavy = ("numba", "xarray", "matplotlib", "zarr", "pandas")
    code = (
        "import sys; from click.testing import CliRunner; from kinetruss.cli import main;"
        f"assert CliRunner().invoke(main, sys.argv[1:]).exit_code == 0; print([m for m in {heavy} if m in sys.modules])"
    )
    for arguments in (["--help"], ["check", str(folder / "tripod.yaml")], ["examples"]):
        found = subprocess.run([sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True)
        assert found.stdout.strip() == "[]"


def test_check_counts_what_is_whole(folder):
    done = call("check", folder / "tripod.yaml")
    assert done.exit_code == 0
    assert "no faults. 4 nodes (3 fixed), 3 active members, 1 load, 2 load cases, runs: lift." in done.stdout
    assert json.loads(call("check", folder / "tripod.yaml", "--json").stdout)["ok"] is True


@pytest.mark.slow
@pytest.mark.parametrize("path", FAULTY, ids=lambda path: path.name)
def test_check_refuses_every_faulty_file_with_place_and_mend(path):
    done = call("check", path)
    assert done.exit_code == 2
    assert "Traceback" not in done.output
    for line in done.stdout.splitlines():
        assert re.match(r"\S+\.(yaml|json|csv|toml):\d+:\d+: \S", line), line
    record = json.loads(call("check", path, "--json").stdout)
    assert record["ok"] is False
    for fault in record["faults"]:
        assert fault["message"]
        assert fault["mend"]


def test_check_says_which_node_moves_where_no_drive_holds_it(tmp_path):
    (tmp_path / "loose.yaml").write_text(LOOSE)
    done = call("check", tmp_path / "loose.yaml")
    assert done.exit_code == 2
    assert "freedoms that no drive holds" in done.stdout
    assert "moves along" in done.stdout


def test_a_large_file_is_refused_unless_allowed(folder):
    done = call("check", folder / "tripod.yaml", "--max-size", "1kB")
    assert done.exit_code == 2
    assert "limit of 1,000 bytes" in done.stdout
    assert "--max-size" in done.stdout
    assert call("check", folder / "tripod.yaml", "--max-size", "1MB").exit_code == 0
    assert call("check", folder / "tripod.yaml", "--max-size", "big").exit_code == 2


def test_a_missing_file_is_said_without_a_traceback(tmp_path):
    for verb in (["check"], ["run", "-o", tmp_path / "out"]):
        done = call(verb[0], tmp_path / "nothing.yaml", *verb[1:])
        assert done.exit_code == 2
        assert "no such file" in done.output
        assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_run_prints_the_page_and_draws(folder):
    done = call("run", folder / "fourbar.json", "-o", folder / "turn", "--pictures")
    assert done.exit_code == 0
    assert "Completed." in done.stdout
    assert "coupler" in done.stdout
    assert (folder / "turn" / "pictures" / "forces.svg").exists()


def test_run_as_json_prints_one_object(folder):
    done = call("run", folder / "tripod.yaml", "lift", "-o", folder / "json", "--json")
    record = json.loads(done.stdout)
    assert (record["schema"], record["status"], record["samples"]) == (
        "kinetruss.run/1",
        "COMPLETED",
        {"asked": 21, "good": 21},
    )
    assert done.stderr == ""


def test_run_refuses_before_any_work(folder):
    taken = call("run", folder / "tripod.yaml", "-o", folder / "run")
    assert taken.exit_code == 2
    assert "--overwrite" in taken.stderr
    foreign = call("run", folder / "tripod.yaml", "-o", folder, "--overwrite")
    assert foreign.exit_code == 2
    assert "never overwritten" in foreign.stderr
    unknown = call("run", folder / "tripod.yaml", "drop", "-o", folder / "new")
    assert unknown.exit_code == 2
    assert "no run called 'drop'. There are: lift" in unknown.stderr
    assert not (folder / "new").exists()
    assert call("run", folder / "tripod.yaml").exit_code == 2
    assert call("run", folder / "tripod.yaml", "--resume", folder / "run").exit_code == 2


def test_an_error_under_json_is_one_object_too(folder):
    done = call("run", folder / "tripod.yaml", "-o", folder / "run", "--json")
    record = json.loads(done.stdout)
    assert (done.exit_code, record["exit_code"]) == (2, 2)
    assert "holds a run already" in record["error"]


def test_a_path_that_ends_early_exits_with_1_and_keeps_what_is_good(tmp_path):
    (tmp_path / "early.yaml").write_text(EARLY)
    done = call("run", tmp_path / "early.yaml", "-o", tmp_path / "run")
    assert done.exit_code == 1
    assert "samples are good" in done.stdout
    again = call("info", tmp_path / "run")
    assert again.exit_code == 0
    assert "of 101 samples are good" in again.stdout


def test_a_freedom_that_no_drive_holds_stops_a_run_before_any_work(tmp_path):
    (tmp_path / "loose.yaml").write_text(LOOSE)
    done = call("run", tmp_path / "loose.yaml", "-o", tmp_path / "run")
    assert done.exit_code == 2
    assert "moves along" in done.stderr
    assert not (tmp_path / "run").exists()


def test_resume_of_an_ended_run_is_refused(folder):
    done = call("run", "--resume", folder / "run")
    assert done.exit_code == 2
    assert "nothing to resume" in done.stderr


def test_info_of_a_model_counts(folder):
    record = json.loads(call("info", folder / "fourbar.json", "--json").stdout)
    counts = {key: record[key] for key in ("nodes", "bars", "coordinates", "fixed", "rank", "degrees_of_freedom", "drives")}
    assert counts == {"nodes": 4, "bars": 3, "coordinates": 8, "fixed": 4, "rank": 3, "degrees_of_freedom": 1, "drives": 1}
    assert "1 degree of freedom" in call("info", folder / "fourbar.json").stdout


@pytest.mark.slow
def test_info_of_a_run_is_its_page(folder):
    assert call("info", folder / "run").stdout.strip() == report.summary(runs.load(folder / "run")).text.strip()
    assert json.loads(call("info", folder / "run", "--json").stdout)["run"] == "lift"


@pytest.mark.slow
def test_joint_forces_by_member_node_axis_and_time(folder):
    text = call("info", folder / "run", "--joints").stdout
    assert "shear_3" in text
    assert "supports" in text
    assert " N" in text and not re.search(r"(\d\.?){5}", text)  # four digits, with their unit (docs/numbers.md)
    record = json.loads(
        call("info", folder / "run", "--joints", "--node", "T", "--axis", "z", "--time", "0.5", "--json").stdout
    )
    assert record["time"] == pytest.approx(0.5)
    assert [row["member"] for row in record["joint_force"]] == ["LA", "LB", "LC"]
    told = call("info", folder / "run", "--joints", "--node", "T", "--axis", "z", "--time", "500 ms", "--json").stdout
    assert json.loads(told) == record
    assert list(record["joint_force"][0]["global"]) == ["z"]
    assert call("info", folder / "run", "--joints", "--member", "LX").exit_code == 2
    assert call("info", folder / "run", "--axis", "x").exit_code == 2
    assert call("info", folder / "tripod.yaml", "--joints").exit_code == 2


def test_info_of_another_folder_says_what_it_is_not(tmp_path):
    done = call("info", tmp_path)
    assert done.exit_code == 1
    assert "not a kinetruss run" in done.stderr


def test_examples_are_listed_copied_and_never_replace(tmp_path):
    listed = json.loads(call("examples", "--json").stdout)["examples"]
    assert "double_octahedral_slew" in {entry["name"] for entry in listed}
    assert all(entry["title"] for entry in listed)
    assert len(call("examples").stdout.splitlines()) == len(listed)
    done = call("examples", "measured_slew", "--copy", tmp_path / "ex")
    assert done.exit_code == 0
    assert {path.name for path in (tmp_path / "ex").iterdir()} == {"measured_slew.yaml", "measured_slew.csv"}
    assert call("examples", "measured_slew", "--copy", tmp_path / "ex").exit_code == 0
    (tmp_path / "ex" / "measured_slew.yaml").write_text("mine")
    again = call("examples", "measured_slew", "--copy", tmp_path / "ex")
    assert again.exit_code == 2
    assert (tmp_path / "ex" / "measured_slew.yaml").read_text() == "mine"
    assert "There are:" in call("examples", "nothing").stderr


@pytest.mark.slow
def test_exports_hold_what_the_run_holds(folder, tmp_path):
    pandas = pytest.importorskip("pandas")
    run = runs.load(folder / "run")
    for name in ("all.csv", "all.parquet", "all.nc"):
        assert call("export", folder / "run", tmp_path / name).exit_code == 0
    wide = pandas.read_csv(tmp_path / "all.csv")
    force = run.forces["pushed"].member_force.sel(member="LB").values
    assert wide["forces.pushed.total.member_force[LB] (N)"].tolist() == force.tolist()
    long = pandas.read_parquet(tmp_path / "all.parquet")
    chosen = long[(long.group == "forces/pushed/total") & (long.quantity == "member_force") & (long.names == "LB")]
    assert chosen.value.tolist() == force.tolist()
    with xr.open_dataset(tmp_path / "all.nc", group="forces/pushed/total") as data:
        assert data.member_force.sel(member="LB").values.tolist() == force.tolist()
        assert data.member_force.attrs["units"] == "N"


@pytest.mark.slow
def test_export_says_what_it_cannot_do(folder, tmp_path, monkeypatch):
    assert "Choose one of these endings" in call("export", folder / "run", tmp_path / "a.xls").stderr
    assert "It has: motion" in call("export", folder / "run", tmp_path / "a.csv", "--group", "wind").stderr
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    done = call("export", folder / "run", tmp_path / "a.parquet")
    assert done.exit_code == 2
    assert "pip install 'kinetruss[export]'" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_an_end_of_a_member_is_not_taken_for_a_node(folder):
    run = runs.load(folder / "run")
    assert [one.of for one in report.curves(run, "end_force", ["LA"])] == ["LA end A", "LA end B"]
    assert "end A (first node)" in run.forces["pushed"].end_force.attrs["long_name"]


@pytest.mark.slow
def test_plot_draws_a_quantity_and_all_pictures(folder, tmp_path):
    done = call("plot", folder / "run", "--quantity", "drive_force", "-o", tmp_path / "f.svg")
    assert (done.exit_code, (tmp_path / "f.svg").exists()) == (0, True)
    done = call("plot", folder / "run", folder / "run", "--member", "LA", "-o", tmp_path / "two.png", "--json")
    assert json.loads(done.stdout)["files"] == [str(tmp_path / "two.png")]
    assert call("plot", folder / "run").exit_code == 0
    assert (folder / "run" / "pictures" / "shape.png").exists()
    assert call("plot", folder / "run", "--quantity", "mood").exit_code == 2


def test_progress_goes_to_a_terminal_only(folder, tmp_path):
    done = call("run", folder / "tripod.yaml", "-o", tmp_path / "run")
    assert done.stderr == ""


@pytest.mark.slow
def test_a_full_disk_ends_with_1_and_shows_nothing_as_whole(folder, tmp_path):
    """A limit on the size of a file stands for the full disk; the process meets it while it writes the second block."""
    kt.write(fourbar(4001), tmp_path / "long.yaml")
    code = (
        "import resource, sys; import kinetruss.runs.running as work; from kinetruss.cli import main; first = work.groups_of\n"
        "def full(block):\n"
        "    if float(block.motion.data.time[0]) > 0: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, -1))\n"
        "    return first(block)\n"
        "work.groups_of = full; main(sys.argv[1:])"
    )
    command = [sys.executable, "-c", code, "run", tmp_path / "long.yaml", "-o", tmp_path / "run"]
    found = subprocess.run(command, capture_output=True, text=True, check=False)
    assert found.returncode == 1
    assert "Traceback" not in found.stderr
    assert f"{tmp_path / 'run'}: the disk is full" in found.stderr
    assert "2000 of 4001 samples are kept" in found.stderr
    assert "kinetruss run --resume" in found.stderr
    assert found.stdout == ""
    assert "2000 of 4001 samples are good" in call("info", tmp_path / "run").stdout
    assert call("run", "--resume", tmp_path / "run", "-q").exit_code == 0
    assert runs.load(tmp_path / "run").whole


def test_a_run_without_one_good_sample_is_said_to_be_so(tmp_path):
    """From the first instant on the lengths cannot be closed."""
    steady = "{kind: constant_rate, rates: {a: -1 m/s}, duration: 0.95 s}"
    far = EARLY.replace(steady, "{kind: quintic, moves: {a: [5, 6]}, duration: 1}")
    (tmp_path / "far.yaml").write_text(far)
    done = call("run", tmp_path / "far.yaml", "-o", tmp_path / "run", "--pictures")
    assert done.exit_code == 1
    assert "cannot be closed" in done.stdout
    assert "0 of 101 samples are good" in done.stdout
    info = call("info", tmp_path / "run")
    assert (info.exit_code, "0 of 101 samples are good" in info.stdout) == (0, True)
    for verb in (["plot", tmp_path / "run"], ["plot", tmp_path / "run", "--quantity", "length"],
                 ["export", tmp_path / "run", tmp_path / "run.csv"], ["info", tmp_path / "run", "--joints"]):  # fmt: skip
        refused = call(*verb)
        assert refused.exit_code in (1, 2)
        assert "no good sample" in refused.stderr


@pytest.mark.slow
def test_resume_goes_on(tmp_path):
    def stop(done: int, total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        runs.run(tripod(31), out=tmp_path / "run", block=10, progress=stop)
    assert "Incomplete" in call("info", tmp_path / "run").stdout
    done = call("run", "--resume", tmp_path / "run", "--json")
    assert done.exit_code == 0
    assert json.loads(done.stdout)["whole"] is True


@pytest.mark.slow
def test_every_example_is_without_fault():
    for entry in json.loads(call("examples", "--json").stdout)["examples"]:
        path = Path(kt.library.example_files()[entry["name"]][0])
        assert call("check", path).exit_code == 0


@pytest.mark.slow
def test_export_of_the_table_of_margins(folder, tmp_path):
    assert call("export", folder / "run", tmp_path / "m.csv", "--group", "verdict").exit_code == 0
    assert (tmp_path / "m.csv").read_text().startswith("part,rule,unit,value,limit,utilisation")


@pytest.mark.slow
def test_an_interrupt_says_how_to_go_on(folder, tmp_path):
    kt.write(fourbar(2_000_001), tmp_path / "long.yaml")  # half a minute: it cannot end by itself first
    command = [Path(sys.executable).parent / "kinetruss", "run", tmp_path / "long.yaml", "-o", tmp_path / "run"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        while running.poll() is None and not ((tmp_path / "run" / "kinetruss.json").exists() and runs_good(tmp_path / "run")):
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        out, error = running.communicate(timeout=60)
    assert (running.returncode, out) == (1, "")
    assert "of 2000001 samples are kept. Continue with: kinetruss run --resume" in error
    assert "Traceback" not in error


def runs_good(path: Path) -> int:
    return int(json.loads((path / "kinetruss.json").read_text())["committed"])


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("info", "run", "--axis", "x"), "go with --joints"),
        (("info", "run", "--joints", "--time", "3 kg"), "is not a time"),
        (("info", "nowhere"), "does not exist"),
        (("run", "tripod.yaml"), "-o OUT"),
        (("plot", "run", "--width"), "requires an argument"),
        (("check", "tripod.yaml", "--nonsense"), "--nonsense"),
    ],
)
def test_wrong_usage_is_one_object_too(folder, arguments, words):
    verb, *rest = arguments
    places = [folder / one if (folder / one).exists() else one for one in rest]
    plain, told = call(verb, *places), call(verb, "--json", *places)
    assert (plain.exit_code, told.exit_code) == (2, 2)
    assert (plain.stdout, told.stderr) == ("", "")
    record = json.loads(told.stdout)
    assert (record["schema"], record["exit_code"]) == ("kinetruss.error/1", 2)
    assert words in record["error"]
    assert words in plain.stderr
