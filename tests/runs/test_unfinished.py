"""A run that was killed, interrupted or is still being written is shown as such everywhere, and can be gone on with."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.results import Status
from kinetruss.results.folder import ARCHIVE
from kinetruss.results.lock import hold
from kinetruss.results.store import open_store
from kinetruss.runs import RunResult, load, resume, run
from samples import fourbar
from stores import stopped

BLOCK, SAMPLES = 4, 13


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("whole") / "run"
    run(fourbar(SAMPLES), out=path, block=BLOCK)
    return path


@pytest.fixture
def half(whole, tmp_path) -> Path:
    shutil.copytree(whole, tmp_path / "half")
    return stopped(tmp_path / "half", 8)


@pytest.mark.slow
def test_no_part_of_it_looks_completed(half):
    found = load(half)
    assert (found.status, found.state, found.whole, found.verdict) == (Status.INTERRUPTED, "incomplete", False, None)
    for part in (found.motion, found.forces["all"], found.forces["all"].static, found.sections["all"]):
        assert (part.status, part.message) == (Status.INTERRUPTED, f"8 of {SAMPLES} samples are good.")
        assert not part.status.ok
    held = hold(half)
    found = load(half)
    assert (found.status, found.state, found.motion.status.ok) == (Status.RUNNING, "running", False)
    held.release()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("verb", "place", "words"),
    [
        ("info RUN", "stdout", "Incomplete: it was interrupted. Continue with: kinetruss run --resume"),
        ("info RUN", "stdout", "8 of 13 samples are good"),
        ("info RUN --json", "stdout", '"whole": false'),
        ("info RUN --json", "stdout", '"state": "incomplete", "status": "INTERRUPTED"'),
        ("export RUN RUN/run.csv", "stderr", "not complete: 8 of 13 samples are good"),
        ("view RUN -o RUN/view.html --no-open", "stderr", "not complete: 8 of 13 samples are good"),
        ("plot RUN --quantity member_force -o RUN/plot.svg", "stderr", "not complete: 8 of 13 samples are good"),
        ("compare RUN", "stderr", "not complete: 8 of 13 samples are good"),
        ("picture RUN -o RUN/shape.svg", "stderr", "not complete: 8 of 13 samples are good"),
        ("report RUN --no-open --no-pdf --no-view", "stderr", "not complete: 8 of 13 samples are good"),
    ],
)
def test_every_verb_that_shows_it_says_so(half, verb, place, words):
    done = CliRunner().invoke(main, verb.replace("RUN", str(half)).split())
    assert done.exit_code == 0, done.output
    assert words in getattr(done, place)
    assert "Worst members" not in done.stdout
    if verb.startswith("report"):
        assert "This run is not complete." in (half / "report" / "report.html").read_text(encoding="utf-8")


@pytest.mark.slow
def test_its_page_says_so(half):
    header = kt.viewer.scene(load(half)).header
    assert header["status"] == Status.INTERRUPTED.value
    assert header["message"] == f"8 of {SAMPLES} samples are good."


@pytest.mark.slow
def test_an_exported_file_says_so_by_itself(half):
    netcdf = pytest.importorskip("netCDF4")
    kt.io.export(half, half / "run.nc")
    with netcdf.Dataset(half / "run.nc") as data:
        told = data["motion"]
        assert (told.state, told.samples_good, told.samples_asked) == ("unfinished", 8, SAMPLES)


@pytest.mark.slow
@pytest.mark.parametrize("status", ["", "INTERRUPTED"])
@pytest.mark.parametrize("committed", [4, 12, SAMPLES])
def test_it_is_gone_on_with_to_the_end_of_a_run_that_was_never_stopped(whole, tmp_path, committed, status):
    """Also where it was stopped behind its last block, and only the end was left to be written."""
    shutil.copytree(whole, tmp_path / "run")
    found = resume(stopped(tmp_path / "run", committed, status))
    assert (found.status, found.message, found.whole, found.good) == (Status.COMPLETED, "", True, SAMPLES)
    assert found.motion.status is Status.COMPLETED
    wanted = load(whole)
    assert [row.utilisation for row in found.verdict.table()] == [row.utilisation for row in wanted.verdict.table()]
    assert open_store(tmp_path / "run").ledger.status == open_store(whole).ledger.status


def _stopped_and_resumed(model: kt.Model, folder: Path) -> tuple[RunResult, RunResult]:
    """A run without interruption, and one that was interrupted after its second block."""

    def stop(done: int, total: int) -> None:
        if done == 2 * BLOCK:
            raise KeyboardInterrupt

    run(model, out=folder / "whole", block=BLOCK)
    with pytest.raises(KeyboardInterrupt):
        run(model, out=folder / "half", block=BLOCK, progress=stop)
    assert load(folder / "half").good == 2 * BLOCK
    assert resume(folder / "half").whole
    return load(folder / "whole"), load(folder / "half")


@pytest.mark.slow
@pytest.mark.parametrize("analysis", ["dynamics.inverse", "kinematics.follow", "statics.at_poses", "statics.deflection"])
def test_every_analysis_along_a_motion_goes_on(analysis, tmp_path):
    model = fourbar(SAMPLES)
    along = model.runs["turn"].with_(analysis=analysis)
    _stopped_and_resumed(model.with_(runs={"turn": along}), tmp_path)
    whole, half = (tmp_path / name for name in ("whole", "half"))
    assert (half / ARCHIVE).read_bytes() == (whole / ARCHIVE).read_bytes()
    assert {file.name for file in half.iterdir()} == {file.name for file in whole.iterdir()}


@pytest.mark.slow
def test_whole_turns_between_samples_survive_an_interrupt(tmp_path):
    """A crank that turns 40 times from one sample to the next: what was between them is there again at the end."""
    spin = kt.ConstantRate(rates={"motor": 100.0}, duration=2.5 * (SAMPLES - 1))
    fast = fourbar(SAMPLES).with_(runs={"spin": kt.Run(analysis="kinematics.follow", trajectory=spin, samples=SAMPLES)})
    asked, found = _stopped_and_resumed(fast, tmp_path)
    times = asked.motion.whole["between_time"].values
    assert len(times) > 100 * SAMPLES
    assert (np.diff(times) > 0).all()
    for name in ("between_time", "between_position", "between_velocity"):
        np.testing.assert_array_equal(found.motion.whole[name], asked.motion.whole[name])


def test_a_motion_that_was_interrupted_has_what_lies_between_its_samples(tmp_path):
    """A crank turns 20 times within 5 intervals: its turns are counted from the states between them, also before the end."""

    def stop(done: int, total: int) -> None:
        if done == 4:
            raise KeyboardInterrupt

    turn = kt.Quintic(moves={"turn": (0.0, 40 * np.pi)}, duration=1.0)
    crank = kt.Model(
        nodes={"O": (0, 0), "A": (1, 0)}, fixed=["O"], bars={"crank": kt.Bar(ends=("O", "A"))},
        drives={"turn": kt.AngleDrive(bar="crank")},
        runs={"r": kt.Run(analysis="kinematics.follow", trajectory=turn, samples=6)},
    )  # fmt: skip
    run(crank, out=tmp_path / "whole", block=2)
    with pytest.raises(KeyboardInterrupt):
        run(crank, out=tmp_path / "half", block=2, progress=stop)
    half, every = load(tmp_path / "half"), load(tmp_path / "whole").motion.data
    passed = every["between_time"].values < every["time"].values[3]
    assert half.good == 4
    assert passed.sum() > 100
    for name in ("between_time", "between_position", "between_velocity"):
        np.testing.assert_array_equal(half.motion.data[name].values, every[name].values[passed])
    x = np.concatenate([half.motion.data["position"].values[:3, 1], half.motion.data["between_position"].values[:, 1]])
    x = x[np.argsort(np.concatenate([half.motion.data["time"].values[:3], half.motion.data["between_time"].values]))]
    x = np.concatenate([x, half.motion.data["position"].values[3:, 1]])
    counted = np.unwrap(np.arctan2(x[:, 1], x[:, 0]))[-1]
    assert abs(counted - 40 * np.pi * (10 * 0.6**3 - 15 * 0.6**4 + 6 * 0.6**5)) < 1e-9
    resume(tmp_path / "half")
    again = load(tmp_path / "half").motion.data
    for name, values in every.data_vars.items():
        np.testing.assert_array_equal(again[name].values, values.values)
