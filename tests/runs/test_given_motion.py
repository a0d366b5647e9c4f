"""Runs that follow a motion from elsewhere: a table of node histories."""

from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.runs import RunResult, load, resume, run
from samples import fourbar


@pytest.fixture(scope="module")
def whole() -> RunResult:
    return run(fourbar(21))


def table(whole: RunResult, path: Path, nodes: str = "BC", kinds: str = " va") -> Path:
    """Write a motion as a node-history table."""
    data = whole.motion.data
    columns = {"t": data["time"].values}
    for node in nodes:
        for kind, name in (("", "position"), ("v", "velocity"), ("a", "acceleration")):
            for axis in "xy":
                if (kind or " ") in kinds:
                    columns[f"{node}.{kind}{axis}"] = data[name].sel(node=node, axis=axis).values
    np.savetxt(path, np.column_stack(list(columns.values())), delimiter=",", header=",".join(columns), comments="", fmt="%.17g")
    return path


def test_a_table_gives_the_forces_of_the_motion_it_came_from(whole, tmp_path):
    model = fourbar(runs={"given": kt.Run(motion=str(table(whole, tmp_path / "motion.csv")))})
    found = run(model, block=6)
    assert found.whole
    np.testing.assert_allclose(found.forces["all"].member_force.values, whole.forces["all"].member_force.values, atol=1e-10)
    assert found.motion.data.attrs["trajectory_space"] == "given"


@pytest.mark.slow
def test_a_model_file_names_its_table_and_a_broken_run_finds_it_again(whole, tmp_path, monkeypatch):
    table(whole, tmp_path / "motion.csv")
    monkeypatch.chdir(tmp_path)
    kt.write(fourbar(runs={"given": kt.Run(motion="motion.csv")}), "model.yaml")

    def stop(done: int, total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(kt.read("model.yaml"), out=tmp_path / "run", block=6, progress=stop)
    monkeypatch.chdir("/")
    assert load(tmp_path / "run").good == 6
    assert resume(tmp_path / "run").whole


def test_moving_nodes_and_their_rates_must_be_there(whole, tmp_path):
    with pytest.raises(InputError, match=r"no columns for C\. Add them"):
        kt.kinematics.from_csv(fourbar(), table(whole, tmp_path / "a.csv", nodes="B"))
    with pytest.raises(InputError, match="no accelerations"):
        kt.kinematics.from_csv(fourbar(), table(whole, tmp_path / "b.csv", kinds=" v"))
