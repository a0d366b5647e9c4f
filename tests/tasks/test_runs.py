"""Tasks in runs: from files, stored, resumed, with faults told."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

TEXT = """
kinetruss: 1
library: {name: vgt.double_octahedral, bays: 2, gravity: [0, 0, -9.81]}
runs:
  dock:
    targets:
      kind: combined
      tasks:
        - {kind: positioning, nodes: [B2.N7, B2.N9, B2.N8], moves: {x: 5 cm, y: [0, 1 cm, 0]}, free: [z], duration: 2 s}
        - {kind: gimbal, platform: [B2.N7, B2.N9, B2.N8], moves: {beta: 4 deg}, law: trapezoid, duration: 2 s}
      hold: [B1.M7]
    samples: 41
"""


@pytest.mark.slow
def test_a_run_from_a_file_does_its_task_and_can_be_stored(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT)
    model = kt.read(path)
    result = kt.run(model, "dock", tmp_path / "out")
    top = result.motion.data.sel(node=["B2.N7", "B2.N9", "B2.N8"]).mean("node").position.values
    assert top[-1, :2] == pytest.approx([0.05, 0.0], abs=1e-10)
    assert top[20, 1] == pytest.approx(0.01, abs=1e-10)
    assert np.ptp(result.motion.drive_position.sel(drive="B1.M7").values) < 1e-14
    assert result.forces
    again = kt.read(_written(model, tmp_path))
    assert again.runs["dock"].targets == model.runs["dock"].targets
    blocks = kt.run(model, "dock", tmp_path / "blocks", block=7)
    assert blocks.motion.position.values == pytest.approx(result.motion.position.values, abs=0)


def _written(model, tmp_path):
    kt.write(model, tmp_path / "again.yaml")
    return tmp_path / "again.yaml"


def test_a_run_has_one_motion_only():
    model = kt.library.vgt.double_octahedral()
    task = kt.Positioning(node="N8", moves={"z": 1.0})
    with pytest.raises(kt.ModelError, match="both motion and targets"):
        kt.Run(targets=task, motion="a.csv")
    with pytest.raises(kt.ModelError, match="has targets, which dynamics.simulate does not use"):
        kt.Run(analysis="dynamics.simulate", t_end=1.0, targets=task)
    with pytest.raises(kt.ModelError, match="no node called 'N88'"):
        model.with_(runs={"a": kt.Run(targets=kt.Positioning(node="N88"))})
    with pytest.raises(kt.ModelError, match="function of time"):
        kt.Run(targets=kt.Positioning(node="N8", moves={"z": lambda t: t}))


def test_out_of_reach_ends_a_run_early_with_its_words():
    model = kt.library.vgt.double_octahedral(bays=2, limits=("1.0 m", "1.35 m"))
    task = kt.Positioning(nodes=("B2.N7", "B2.N9", "B2.N8"), moves={"z": 8.0})
    result = kt.run(model.with_(runs={"far": kt.Run(targets=task, samples=21)}), "far")
    assert not result.status.ok
    assert 0 < len(result.motion.time) < 21
    assert "nearest pose" in result.message


@pytest.mark.slow
def test_a_mission_takes_tasks_among_its_motions(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text(
        TEXT + "  all: {analysis: mission, motions: [dock], conditions: [held]}\nconditions: {held: {locked: [B1.M9]}}\n"
    )
    model = kt.read(path)
    mission = kt.run(model, "all")
    alone = kt.run(model.with_(runs={"one": model.runs["dock"].with_(condition="held")}), "one")
    top = alone.motion.data.sel(node=["B2.N7", "B2.N9", "B2.N8"]).mean("node").position.values
    assert top[-1, :2] == pytest.approx([0.05, 0.0], abs=1e-10)  # the drives that are left do the task
    worst = float(alone.verdict.data.utilisation.max())
    assert float(mission.pairs.utilisation.max()) == pytest.approx(worst, rel=1e-12)
