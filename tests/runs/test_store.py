"""The run store: blocks, ledger, what is seen of a run that did not end."""

import json
import resource
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
import zarr

from kinetruss.errors import InputError, StoreError
from kinetruss.results.encoding import encoded
from kinetruss.results.folder import ARCHIVE, Ledger, check_target, is_store
from kinetruss.results.lock import is_locked
from kinetruss.results.store import Writer, create, key, open_store, reopen
from stores import ended


def block(first: int, count: int = 10, size: int = 3) -> xr.Dataset:
    time = first + np.arange(count, dtype=float)
    values = time[:, None] * 10 + np.arange(size)
    coords = {"time": ("time", time, {"units": "s"}), "member": [f"M{i}" for i in range(size)]}
    force = (("time", "member"), values, {"units": "N", "long_name": "force"})
    return xr.Dataset({"force": force, "gauge": ("time", time)}, coords, {"kind": "motion", "not_unique": ["M1"]})


def ledger(samples: int = 30, size: int = 10) -> Ledger:
    return Ledger(run="turn", samples=samples, block=size, options={}, provenance={})


def opened(folder: Path) -> xr.Dataset:
    """The motion as the zarr package reads it."""
    with zarr.storage.ZipStore(folder / ARCHIVE, mode="r") as store:
        return xr.open_zarr(store, group="motion", consolidated=False).load()


def test_blocks_come_back_as_one_dataset(tmp_path):
    with_two = create(tmp_path / "run", ledger(), "{}")
    for first in (0, 10, 20):
        with_two.append({"motion": block(first), "forces/all/total": block(first)})
    ended(with_two, "COMPLETED")
    store = open_store(tmp_path / "run")
    assert store.groups == ("motion", "forces/all/total")
    assert store.ledger.whole
    xr.testing.assert_identical(store.read("motion").load(), block(0, 30))


def test_another_zarr_reader_sees_the_same(tmp_path):
    writer = create(tmp_path / "run", ledger(10), "{}")
    writer.append({"motion": block(0)})
    ended(writer, "COMPLETED")
    plain = opened(tmp_path / "run")
    np.testing.assert_array_equal(plain["force"].values, block(0)["force"].values)
    assert plain["force"].attrs["units"] == "N"


def written_only(writer: Writer, data: xr.Dataset) -> None:
    """Write a block that the ledger does not count."""
    writer._archive.append(dict(encoded({"motion": data}, writer.ledger, {})))


def test_only_committed_samples_are_read(tmp_path):
    writer = create(tmp_path / "run", ledger(), "{}")
    writer.append({"motion": block(0)})
    written_only(writer, block(10))  # on the disk, never counted: what a kill leaves behind
    store = open_store(tmp_path / "run")
    assert not store.ledger.whole
    assert store.read("motion").sizes["time"] == 10
    writer.release()


def test_reopening_goes_on_behind_the_last_good_sample(tmp_path):
    path = tmp_path / "run"
    writer = create(path, ledger(), "{}")
    writer.append({"motion": block(0)})
    written_only(writer, block(999))
    writer.release()
    again = reopen(path, open_store(path).ledger)
    again.append({"motion": block(10)})
    again.append({"motion": block(20)})
    ended(again, "COMPLETED")
    xr.testing.assert_identical(open_store(path).read("motion").load(), block(0, 30))


def test_a_run_that_stopped_early_is_cut_to_what_is_good(tmp_path):
    writer = create(tmp_path / "run", ledger(), "{}")
    writer.append({"motion": block(0)})
    ended(writer, "SINGULAR", "why")
    store = open_store(tmp_path / "run")
    assert (store.ledger.status, store.ledger.message, store.ledger.whole) == ("SINGULAR", "why", False)
    plain = opened(tmp_path / "run")
    assert plain.sizes["time"] == 10


def test_tables_known_at_the_end_join_their_group(tmp_path):
    writer = create(tmp_path / "run", ledger(10), "{}")
    writer.append({"demand/all": block(0)})
    rule = xr.Dataset({"value": ("rule", [1.0, 2.0]), "note": ("rule", ["a", "b"])}, {"rule": ["x", "y"]})
    writer.append({"demand/all": rule})
    ended(writer, "COMPLETED")
    found = open_store(tmp_path / "run").read("demand/all")
    assert found["note"].values.tolist() == ["a", "b"]
    assert found.sizes == {"time": 10, "member": 3, "rule": 2}


def test_one_writer_at_a_time(tmp_path):
    writer = create(tmp_path / "run", ledger(), "{}")
    assert is_locked(tmp_path / "run")
    with pytest.raises(StoreError, match="being written by this process"):
        reopen(tmp_path / "run", ledger())
    writer.release()
    assert not is_locked(tmp_path / "run")


@pytest.mark.parametrize("overwrite", [False, True])
def test_a_folder_of_something_else_is_never_replaced(tmp_path, overwrite):
    (tmp_path / "thesis.tex").write_text("years of work")
    with pytest.raises(InputError, match="not empty and is not a kinetruss run"):
        check_target(tmp_path, overwrite)
    (tmp_path / "kinetruss.json").write_text("{}")  # the name alone does not make it a run
    with pytest.raises(InputError, match="not a kinetruss run"):
        check_target(tmp_path, overwrite)
    assert (tmp_path / "thesis.tex").read_text() == "years of work"


def test_a_run_is_replaced_only_when_asked_and_other_files_in_it_stay(tmp_path):
    writer = create(tmp_path, ledger(), "{}")
    writer.append({"motion": block(0)})
    ended(writer, "COMPLETED")
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="holds a run already"):
        check_target(tmp_path, overwrite=False)
    create(tmp_path, ledger(), '{"new": 1}', overwrite=True).release()
    assert (tmp_path / "notes.txt").read_text() == "mine"
    assert open_store(tmp_path).groups == ()
    assert open_store(tmp_path).model_text == '{"new": 1}'


def test_overwriting_does_not_follow_a_link_out_of_the_folder(tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "data").write_text("keep")
    path = tmp_path / "run"
    create(path, ledger(), "{}").release()
    (path / ARCHIVE).unlink()
    for name, target in ((ARCHIVE, "data"), ("results.zarr", ""), ("state", "")):
        (path / name).symlink_to(elsewhere / target)
    create(path, ledger(), "{}", overwrite=True).release()
    assert [(one.name, one.read_text()) for one in elsewhere.iterdir()] == [("data", "keep")]


def test_a_file_is_no_folder(tmp_path):
    (tmp_path / "out").write_text("")
    with pytest.raises(InputError, match="is a file"):
        check_target(tmp_path / "out", overwrite=True)


def test_what_is_not_a_run_is_said(tmp_path):
    assert not is_store(tmp_path)
    with pytest.raises(StoreError, match=r"not a kinetruss run: it has no kinetruss\.json"):
        open_store(tmp_path)
    (tmp_path / "kinetruss.json").write_text(json.dumps({"kinetruss_run": 99}))
    with pytest.raises(StoreError, match="newer kinetruss"):
        open_store(tmp_path)
    (tmp_path / "kinetruss.json").write_text(json.dumps({"kinetruss_run": 1}))
    with pytest.raises(StoreError, match="damaged"):
        open_store(tmp_path)


def test_names_cannot_lead_out_of_the_folder(tmp_path):
    writer = create(tmp_path / "run", ledger(10), "{}")
    writer.append({f"forces/{key('..')}/total": block(0), f"forces/{key('a:b')}/total": block(0)})
    ended(writer, "COMPLETED")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run"]
    assert len(open_store(tmp_path / "run").groups) == 2


def test_a_full_disk_keeps_what_was_good(tmp_path):
    """A limit on the size of a file stands for the full disk: both refuse the write."""
    path = tmp_path / "run"
    writer = create(path, ledger(40_000, 20_000), "{}")
    rng = np.random.default_rng(1)

    def noise(first: int) -> xr.Dataset:  # does not compress
        data = block(first, 20_000)
        return data.assign(force=data["force"] * 0 + rng.random(data["force"].shape))

    writer.append({"motion": noise(0)})
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, before[1]))
    try:
        with pytest.raises(StoreError) as caught:
            writer.append({"motion": noise(20_000)})
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        writer.release()
    assert str(path) in str(caught.value)
    assert "20000 of 40000 samples are kept" in str(caught.value)
    assert "kinetruss run --resume" in str(caught.value)
    store = open_store(path)
    assert (store.ledger.committed, store.ledger.state) == (20_000, "writing")
    assert np.isfinite(store.read("motion")["force"].values).all()
