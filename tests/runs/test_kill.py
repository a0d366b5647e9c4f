"""A run that is killed without warning, as a process."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from kinetruss.results.store import open_store
from kinetruss.runs import load, resume, run
from samples import fourbar

SAMPLES, BLOCK = 3_000, 100
CHILD = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parents[1])!r})
from samples import fourbar
from kinetruss.runs import run
run(fourbar({SAMPLES}), out=sys.argv[1], block={BLOCK}, progress=lambda done, total: print(done, flush=True))
"""


@pytest.mark.slow
def test_a_kill_at_any_instant_leaves_good_samples_and_a_run_to_resume(tmp_path):
    path = tmp_path / "run"
    with subprocess.Popen([sys.executable, "-c", CHILD, str(path)], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        told = [int(child.stdout.readline()) for _ in range(3)]
        assert load(path).state == "running"
        time.sleep(0.037)  # into the middle of a block
        os.kill(child.pid, signal.SIGKILL)
        told += [int(line) for line in child.stdout]
    assert child.returncode == -signal.SIGKILL
    half = load(path)
    assert told[-1] <= half.good < SAMPLES  # what was reported as done is there
    assert (half.state, half.whole, half.good % BLOCK) == ("incomplete", False, 0)
    whole = run(fourbar(SAMPLES))
    np.testing.assert_allclose(half.motion.position.values, whole.motion.position.values[: half.good], atol=1e-12)
    done = resume(path)
    assert done.whole
    assert open_store(path).ledger.wall_time > half.wall_time
    np.testing.assert_allclose(done.forces["all"].member_force.values, whole.forces["all"].member_force.values, atol=1e-9)
    np.testing.assert_allclose(done.verdict.utilisation.values, whole.verdict.utilisation.values, rtol=1e-9)


@pytest.mark.slow
def test_a_run_can_be_read_at_any_time_while_it_is_written(tmp_path):
    path, reads = tmp_path / "run", 0
    longer = CHILD.replace(
        f"fourbar({SAMPLES})", f"fourbar({4 * SAMPLES})"
    )  # on a busy machine a read takes as long as blocks do
    with subprocess.Popen([sys.executable, "-c", longer, str(path)], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        child.stdout.readline()
        while (state := load(path)).state == "running":
            assert np.isfinite(state.motion.position.values).all()
            reads += 1
        child.stdout.read()
    assert reads > 3
    assert child.returncode == 0
    assert load(path).whole


@pytest.mark.parametrize("name", ["kinetruss.json", "model.json"])
def test_a_run_cut_off_before_its_first_files_stand_is_done_anew(tmp_path, monkeypatch, name):
    """As a kill between the writing of a file and its renaming leaves the folder."""
    path, before = tmp_path / "run", Path.replace

    def cut(draft, target):
        if Path(target).name == name:
            raise KeyboardInterrupt
        return before(draft, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", cut)
        with pytest.raises(KeyboardInterrupt):
            run(fourbar(9), out=path)
    assert f"{name}.part" in [one.name for one in path.iterdir()]
    # without a ledger nobody can tell a run in it; with one it asks to be replaced
    assert run(fourbar(9), out=path, overwrite=name == "model.json").whole
    assert not list(path.glob("*.part"))
