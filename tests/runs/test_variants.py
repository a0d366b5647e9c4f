"""Variants of a model: their names, their models, their runs."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import zarr
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss import runs
from kinetruss.errors import InputError, ModelError, StoreError
from kinetruss.results.folder import ARCHIVE
from kinetruss.runs.many import beside
from kinetruss.runs.variant_sets import short_paths, spread
from samples import fourbar, tripod
from stores import members

LIFT = "runs.lift.trajectory.duration"
TRUSS = """
kinetruss: 1
library: {name: vgt.triangular, payload_mass: 10 kg}
runs:
  extend: {trajectory: {kind: quintic, moves: {actuator: [2.5, 3.7]}, duration: 3}, samples: 31}
"""


def names(folder):
    """What is in a folder."""
    return sorted(path.name for path in folder.iterdir())


@pytest.fixture
def truss(tmp_path):
    path = tmp_path / "truss.yaml"
    path.write_text(TRUSS)
    return path


def test_all_combinations_the_last_path_fastest(truss):
    found = runs.variants(truss, {"runs.extend.trajectory.duration": ["3", "5 s"], "library.payload_mass": ["10 kg", 40]})
    assert list(found) == [
        "duration=3_payload_mass=10kg", "duration=3_payload_mass=40", "duration=5s_payload_mass=10kg",
        "duration=5s_payload_mass=40",
    ]  # fmt: skip
    assert [(m.runs["extend"].trajectory.duration, m.nodes["B"].mass) for m in found.values()] == [
        (3, 10), (3, 40), (5, 10), (5, 40)
    ]  # fmt: skip


def test_what_has_one_value_is_in_no_name():
    found = spread(fourbar(), {"runs.turn.samples": [5], "gravity": ["[0, -9.81 m/s^2]", "~"]})
    assert [one.name for one in found] == ["gravity=0,-9.81m-s-2", "gravity=none"]
    assert [one.settings["runs.turn.samples"] for one in found] == ["5", "5"]
    assert found[0].model.gravity == (0, -9.81)
    assert found[1].model.gravity is None


def test_a_library_model_of_another_size(tmp_path):
    (tmp_path / "chain.yaml").write_text("library: {name: vgt.double_octahedral}")
    found = runs.variants(tmp_path / "chain.yaml", {"library.bays": [1, 2]})
    assert [len(one.nodes) for one in found.values()] == [9, 15]


@pytest.mark.slow
@given(
    st.lists(
        st.text(alphabet="aB ./\\:*?\"<>|-_~%\n[]{}'$&;é", min_size=1, max_size=60), min_size=2, max_size=4, unique=True
    ).map(lambda texts: ["0x" + text for text in texts])
)
@settings(max_examples=60)
def test_names_are_safe_and_no_two_alike(texts):
    found = [one.name for one in spread(fourbar(), {"title": texts})]
    assert len({name.casefold() for name in found}) == len(found)
    for name in found:
        assert not set(name) & set("/\\:*?\"<>|\n $&;'")
        assert len(name) <= 110
        assert not name.endswith((".", " "))


def test_short_ends_of_paths():
    assert short_paths(["nodes.B1.N4.mass", "nodes.B2.N4.mass"]) == {
        "nodes.B1.N4.mass": "B1.N4.mass",
        "nodes.B2.N4.mass": "B2.N4.mass",
    }


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"runs.lift.trajectory.duraton": [3]}, r"duraton=3: .*'duraton' is not known here\. Did you mean 'duration'"),
        ({LIFT: ["3 s", "4 kg"]}, r"duration=4 kg: .*'4 kg' is not a time \(s\)\. Write for example"),
        ({LIFT: [3], "nodes.T.mass": [1, "-1 kg"]}, r"nodes\.T\.mass=-1 kg: nodes\.T\.mass: -1 must not be negative"),
        ({"library.bays": [1, 2]}, "library: the model was not built from a library model"),
    ],
)
def test_faults_are_told_of_the_setting_that_has_them(values, message):
    with pytest.raises(ModelError, match=message):
        runs.variants(tripod(), values)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({LIFT: []}, "has no list of values"),
        ({LIFT: "345"}, "has no list of values"),
        ({LIFT: [3, "3"]}, "has a value twice"),
    ],
)
def test_settings_that_say_nothing(values, message):
    with pytest.raises(InputError, match=message):
        runs.variants(tripod(), values)


def test_a_fault_of_the_file_keeps_its_place(tmp_path):
    (tmp_path / "bad.yaml").write_text(TRUSS.replace("10 kg", "10 s"))
    with pytest.raises(ModelError, match=r"bad\.yaml:3:\d+: library\.payload_mass"):
        runs.variants(tmp_path / "bad.yaml", {"library.payload_mass": ["10 kg"]})


def same(one: runs.RunResult, other: runs.RunResult) -> None:
    """Every number of two runs is the same."""
    pairs = [(one.motion.data, other.motion.data), (one.verdict.data, other.verdict.data)]
    assert list(one.forces) == list(other.forces)
    for case, forces in one.forces.items():
        pairs += [
            (forces.data, other.forces[case].data),
            (forces.static.data, other.forces[case].static.data),
            (one.sections[case].data, other.sections[case].data),
            (one.demand[case].data, other.demand[case].data),
        ]
    for a, b in pairs:
        assert set(a.data_vars) == set(b.data_vars)
        for name in a.data_vars:
            assert a[name].dims == b[name].dims
            np.testing.assert_array_equal(a[name].values, b[name].values, err_msg=str(name))


@pytest.mark.slow
def test_a_variant_is_the_run_of_its_model(tmp_path):
    """Stored and read again, or kept; what is not stored is computed again to the last bit."""
    values = {LIFT: [1, 2], "nodes.T.mass": [20, 30]}
    stored = runs.run_variants(tripod(), values, out=tmp_path / "out")
    kept = runs.run_variants(tripod(), values)
    assert list(stored) == list(kept) == list(stored.paths)
    for name, model in runs.variants(tripod(), values).items():
        same(stored[name], runs.run(model))
        same(kept[name], stored[name])
        assert stored[name].settings == kept[name].settings == stored.settings[name]
        assert stored[name].model == model
        assert stored[name].provenance["model"] == kept[name].provenance["model"]
        assert stored[name].whole and stored.whole[name]
    rows = [kept[name].verdict.table()[0] for name in kept]
    assert [(row.part, row.rule, row.utilisation, row.time) for row in rows] == list(stored.worst.values())


def test_the_archive_is_read_by_zarr(tmp_path):
    found = runs.run_variants(tripod(), {LIFT: [1, 2]}, out=tmp_path)
    path = found.paths["duration=1"]
    assert names(path) == ["kinetruss.json", "model.json", ARCHIVE]
    with zarr.storage.ZipStore(path / ARCHIVE, mode="r") as store:
        group = zarr.open_group(store, mode="r")
        np.testing.assert_array_equal(group["motion/position"][:], found["duration=1"].motion.position.values)
        assert group["motion/position"].attrs["units"] == "m"
        assert set(group["forces/pushed/total"].array_keys()) >= {"member_force", "time"}


def test_a_damaged_archive_is_said_to_be_so(tmp_path):
    path = runs.run_variants(tripod(), {LIFT: [1, 2]}, out=tmp_path).paths["duration=1"]
    data = (path / ARCHIVE).read_bytes()
    (path / ARCHIVE).write_bytes(data[: len(data) // 2])
    with pytest.raises(StoreError, match="is damaged: its archive has no directory"):
        runs.load(path).motion.position.values.sum()


@pytest.mark.slow
def test_long_runs_are_stored_block_by_block(tmp_path):
    found = runs.run_variants(fourbar(2500), {"runs.turn.trajectory.duration": [0.6, 0.7]}, out=tmp_path)
    for path in found.paths.values():
        assert [name for name in members(path) if name.startswith("motion/time/")] == [
            f"motion/time/{k}" for k in ("zarr.json", 0, 1)
        ]
    assert all(found.whole.values())
    assert found["duration=0.6"].settings == {"runs.turn.trajectory.duration": "0.6"}


def test_a_single_combination_is_the_folder_itself(tmp_path):
    found = runs.run_variants(tripod(), {LIFT: ["2 s"]}, out=tmp_path / "run")
    assert found.paths == {"duration=2s": tmp_path / "run"}
    assert runs.load(tmp_path / "run").motion.time.values[-1] == 2


def test_nothing_is_lost(tmp_path):
    out = tmp_path / "out"
    runs.run_variants(tripod(), {LIFT: [1, 2]}, out=out)
    with pytest.raises(InputError, match="holds runs already.*--overwrite"):
        runs.run_variants(tripod(), {LIFT: [1, 3]}, out=out)
    (out / "notes.txt").write_text("mine")
    (out / "duration=2" / "notes.txt").write_text("mine")
    runs.run_variants(tripod(), {LIFT: [1, 3]}, out=out, overwrite=True)
    assert names(out) == ["duration=1", "duration=2", "duration=3", "notes.txt"]
    assert names(out / "duration=2") == ["notes.txt"]
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes.txt").write_text("mine")
    for overwrite in (False, True):
        with pytest.raises(InputError, match="never overwritten"):
            runs.run_variants(tripod(), {LIFT: [1, 3]}, out=tmp_path / "other", overwrite=overwrite)
    assert names(tmp_path / "other") == ["notes.txt"]


@pytest.mark.slow
def test_a_run_gives_way_to_variants_only_when_told(tmp_path):
    runs.run(tripod(), out=tmp_path / "run")
    with pytest.raises(InputError, match="holds a run already"):
        runs.run_variants(tripod(), {LIFT: [1, 2]}, out=tmp_path / "run")
    with pytest.raises(InputError, match="refused"):
        runs.run_variants(tripod(), {LIFT: [1, 2], "runs.lift.load_cases": ["[refused]"]}, out=tmp_path / "run", overwrite=True)
    assert runs.load(tmp_path / "run").whole
    runs.run_variants(tripod(), {LIFT: [1, 2]}, out=tmp_path / "run", overwrite=True)
    assert names(tmp_path / "run") == ["duration=1", "duration=2"]


@pytest.mark.slow
def test_one_that_ends_early_does_not_stop_the_others(tmp_path):
    found = runs.run_variants(tripod(), {"runs.lift.trajectory.moves.LA.1": [1.15, 9.0, 1.2]}, out=tmp_path)
    assert [found.whole[name] for name in found] == [True, False, True]
    assert not found.status["LA.1=9.0"].ok
    assert 0 < found["LA.1=9.0"].good < 41


@pytest.mark.slow
def test_progress_counts_variants(tmp_path):
    seen = []
    runs.run_variants(tripod(5), {LIFT: [1, 2, 3, 4, 5, 6]}, out=tmp_path, progress=lambda *step: seen.append(step))
    assert seen == [(k, 6) for k in range(1, 7)]


def test_work_beside_each_other_is_done_once():
    assert dict(beside(lambda k: k * k, range(20), workers=3)) == {k: k * k for k in range(20)}


def test_pieces_of_a_process_that_dies_are_done_here():
    parent = os.getpid()

    def work(k: int) -> int:
        if os.getpid() != parent and k >= 4:
            os._exit(1)
        return k

    assert dict(beside(work, range(12), workers=2)) == {k: k for k in range(12)}


def test_errors_of_a_process_are_raised_here():
    def work(k: int) -> int:
        if k == 5:
            raise StoreError("the disk is full")
        return k

    with pytest.raises(StoreError, match="the disk is full"):
        dict(beside(work, range(12), workers=2))


FOR_EVER = """
import os, sys, time
from pathlib import Path
from kinetruss.runs.many import beside
def work(k):
    (Path(sys.argv[1]) / str(os.getpid())).touch()
    time.sleep(1000)
dict(beside(work, range(6), workers=2))
"""


@pytest.mark.slow
@pytest.mark.skipif(
    not sys.platform.startswith("linux"),
    reason="variants are computed in one process except on Linux, so there is no child to outlive it",
)
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_no_copy_outlives_its_parent(tmp_path, how):
    with subprocess.Popen([sys.executable, "-c", FOR_EVER, str(tmp_path)], stderr=subprocess.PIPE) as parent:
        while len(copies := [int(name) for name in names(tmp_path)]) < 2:
            assert parent.poll() is None
            time.sleep(0.02)
        parent.send_signal(how)
        parent.communicate(timeout=30)
    until = time.monotonic() + 30
    while any(alive(one) for one in copies):
        assert time.monotonic() < until
        time.sleep(0.02)


def alive(process: int) -> bool:
    """A process that has ended may wait for whoever adopted it to take note."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_the_ledger_names_settings_and_what_is_derived(tmp_path):
    found = runs.run_variants(tripod(5), {LIFT: [1, 2]}, out=tmp_path)
    ledger = json.loads((found.paths["duration=2"] / "kinetruss.json").read_text())
    assert ledger["options"]["settings"] == {LIFT: "2"}
    assert ledger["options"]["derived"] == ["static", "sections", "demand"]
    assert (ledger["state"], ledger["committed"], ledger["samples"]) == ("finished", 5, 5)
    assert ledger["model_hash"] != json.loads((found.paths["duration=1"] / "kinetruss.json").read_text())["model_hash"]


def test_in_memory_nothing_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = runs.run_variants(tripod(5), {LIFT: [1, 2]})
    assert found.paths == {}
    assert len(found) == 2
    assert list(tmp_path.iterdir()) == []
    assert isinstance(found["duration=1"].model, kt.Model)
