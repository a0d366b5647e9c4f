"""Runs of format 1, a file for every chunk: they are read, and those that were killed are gone on with."""

import json
import os
import shutil
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
import zarr

import kinetruss as kt
from kinetruss import runs
from kinetruss.errors import StoreError
from kinetruss.results import store as _store
from kinetruss.results.folder import ARCHIVE, ARRAYS
from kinetruss.results.store import open_store
from samples import fourbar
from stores import as_format_1

WHOLE = ["kinetruss.json", "model.json", ARCHIVE]
BALL = kt.Model(
    nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1.0)}, fixed=["O"], bars={"rod": kt.Bar(ends=("O", "A"), mass=0.0)},
    gravity=(0, -10), section=kt.Rod(diameter=0.02), material="steel_s235",
    runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=1.0, samples=13)},
)  # fmt: skip
MISSION = fourbar(9, runs=fourbar(9).runs | {"all": kt.Run(analysis="mission", motions=("turn",), load_cases=None, samples=9)})


@pytest.fixture(scope="module")
def new(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("new") / "run"
    runs.run(fourbar(13), out=path, block=4)
    return path


@pytest.fixture
def old(new, tmp_path) -> Path:
    shutil.copytree(new, tmp_path / "old")
    return as_format_1(tmp_path / "old")


def killed(folder: Path, committed: int) -> Path:
    """A run of format 1 as a kill leaves it; chunks of samples that are not counted stay."""
    record = json.loads((folder / "kinetruss.json").read_text())
    record |= {"state": "writing", "committed": committed, "status": ""}
    (folder / "kinetruss.json").write_text(json.dumps(record))
    return folder


def same(one: Path, other: Path) -> None:
    """Two runs have the same groups, names, attributes and bits."""
    a, b = open_store(one), open_store(other)
    assert a.groups == b.groups
    assert a.ledger.committed == b.ledger.committed
    for group in a.groups:
        xr.testing.assert_identical(a.read(group).load(), b.read(group).load())


def names(folder: Path) -> list[str]:
    return sorted(one.name for one in folder.iterdir())


def test_a_folder_of_files_is_read(new, old):
    assert names(old) == ["kinetruss.json", "model.json", ARRAYS]
    plain = xr.open_zarr(old / ARRAYS, group="motion", chunks=None, consolidated=False)  # it is what zarr read
    np.testing.assert_array_equal(plain["position"].values, runs.load(new).motion.position.values)
    same(old, new)
    assert runs.load(old).whole
    assert runs.load(old).verdict.table() == runs.load(new).verdict.table()


@pytest.mark.parametrize("committed", [0, 4, 12, 13])
def test_a_killed_one_is_gone_on_with_to_the_last_bit(new, old, committed):
    killed(old, committed)
    if committed:
        half = runs.load(old)
        assert (half.state, half.good, half.verdict) == ("incomplete", committed, None)
        np.testing.assert_array_equal(half.motion.position, runs.load(new).motion.position[:committed])
    assert runs.resume(old).whole
    assert names(old) == WHOLE
    assert json.loads((old / "kinetruss.json").read_text())["kinetruss_run"] == 2
    same(old, new)


def test_a_killed_simulation_is_gone_on_with_from_its_state(tmp_path):
    def stop(done: int, _asked: int) -> None:
        if done == 8:
            raise KeyboardInterrupt

    runs.run(BALL, out=tmp_path / "new", block=4)
    with pytest.raises(KeyboardInterrupt):
        runs.run(BALL, out=tmp_path / "old", block=4, progress=stop)
    assert names(as_format_1(tmp_path / "old")) == ["kinetruss.json", "model.json", ARRAYS, "state"]
    runs.resume(tmp_path / "old")
    assert names(tmp_path / "old") == WHOLE
    same(tmp_path / "old", tmp_path / "new")


def test_a_mission_is_read_and_gone_on_with(tmp_path):
    def stop(*_: int) -> None:
        raise KeyboardInterrupt

    runs.run(MISSION, "all", tmp_path / "new")
    same(as_format_1(Path(shutil.copytree(tmp_path / "new", tmp_path / "whole"))), tmp_path / "new")
    with pytest.raises(KeyboardInterrupt):
        runs.run(MISSION, "all", tmp_path / "old", progress=stop)
    assert runs.load(as_format_1(tmp_path / "old")).state == "incomplete"
    runs.resume(tmp_path / "old")
    same(tmp_path / "old", tmp_path / "new")


def test_a_short_variant_in_an_archive_is_read(tmp_path):
    runs.run_variants(fourbar(9), {"runs.turn.samples": [9]}, out=tmp_path / "new")
    shutil.copytree(tmp_path / "new", tmp_path / "old")
    as_format_1(tmp_path / "old", archive=True)
    assert names(tmp_path / "old") == WHOLE
    with zarr.storage.ZipStore(tmp_path / "old" / ARCHIVE, mode="r") as archive:
        assert zarr.open_group(archive, mode="r")["motion/position"].shape[0] == 9
    same(tmp_path / "old", tmp_path / "new")
    data = (tmp_path / "old" / ARCHIVE).read_bytes()
    (tmp_path / "old" / ARCHIVE).write_bytes(data[: len(data) // 2])
    with pytest.raises(StoreError, match="is damaged: its archive has no directory"):
        runs.load(tmp_path / "old")


def test_it_gives_way_to_a_run_of_today_only_when_told(old):
    with pytest.raises(kt.InputError, match="holds a run already"):
        runs.run(fourbar(5), out=old)
    assert runs.run(fourbar(5), out=old, overwrite=True).whole
    assert names(old) == WHOLE
    assert runs.load(old).good == 5


def test_a_chunk_that_is_missing_or_damaged_is_an_error(old):
    file = old / ARRAYS / "forces/all/total/member_force/1.0"
    data = file.read_bytes()
    for new in (data[:-4] + bytes(4), data[: len(data) // 2], b""):
        file.write_bytes(new)
        with pytest.raises(StoreError, match=r"damaged: forces/all/total/member_force/1\.0 is not what was written"):
            runs.load(old).forces["all"].data["member_force"].load()
    file.unlink()
    with pytest.raises(StoreError, match=r"damaged: forces/all/total/member_force/1\.0 is missing"):
        runs.load(old).forces["all"].data["member_force"].load()


def test_who_reads_it_while_it_becomes_an_archive_is_told(old):
    killed(old, 8)
    half = runs.load(old)
    runs.resume(old)
    with pytest.raises(StoreError, match="was replaced by another run while it was read. Read it again"):
        half.motion.position.values  # noqa: B018 - read when used


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test needs os.fork, which this system lacks")
def test_a_kill_at_any_step_of_the_change_loses_nothing(new, old, tmp_path):
    killed(old, 8)
    last, ended = 0, False
    while not ended:
        path = tmp_path / str(last)
        shutil.copytree(old, path)
        child = os.fork()
        if not child:
            with suppress(BaseException):
                _until(last)
                store = open_store(path)
                _store.reopen(path, store.ledger).release()
                os._exit(0)
            os._exit(1)
        ended = os.waitpid(child, 0)[1] == 0
        assert runs.load(path).good == 8
        assert runs.resume(path).whole
        assert names(path) == WHOLE
        same(path, new)
        last += 1
    assert last > 6


def _until(last: int) -> None:
    """End this process after so many changes of the file system that the disk has."""
    left = iter(range(last))

    def counted(owner: object, name: str) -> None:
        real = getattr(owner, name)

        def step(*given: object, **more: object) -> object:
            if next(left, None) is None:
                os._exit(9)
            return real(*given, **more)

        setattr(owner, name, step)

    for owner, name in ((Path, "unlink"), (Path, "replace"), (shutil, "rmtree"), (os, "fsync")):
        counted(owner, name)
