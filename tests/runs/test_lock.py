"""One writer a run folder: who is refused, what it is told, and what is left of those that were killed."""

import errno
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import kinetruss as kt
from kinetruss import runs
from kinetruss.errors import InputError, KinetrussError, StoreError
from kinetruss.io import export
from kinetruss.results import folder as _folder, lock as _lock, reading
from kinetruss.results.archive import Archive
from kinetruss.results.folder import ARCHIVE, Ledger, claimed
from kinetruss.results.lock import LOCK, hold, holding, is_locked
from kinetruss.results.store import create, open_store, store_whole
from permissions import bound
from samples import fourbar
from stores import archived, ended, members, stopped

HOLD = """
import sys
from pathlib import Path
from kinetruss.results.lock import hold
hold(Path(sys.argv[1]))
print("held", flush=True)
sys.stdin.read()
"""
VARIANTS = {"runs.turn.samples": [5, 6]}


class Holder:
    """Another process that holds a folder until it is ended."""

    def __init__(self, folder: Path) -> None:
        command = [sys.executable, "-c", HOLD, str(folder)]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline() == "held\n"

    def kill(self) -> None:
        self.process.send_signal(signal.SIGKILL)
        self.process.communicate()


@pytest.fixture(scope="module")
def stored(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("stored") / "run"
    runs.run(fourbar(9), out=path, block=4)
    return path


@pytest.fixture
def folder(stored, tmp_path) -> Path:
    shutil.copytree(stored, tmp_path / "run")
    return tmp_path / "run"


def contents(folder: Path) -> dict[str, bytes]:
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def writers(folder: Path) -> dict[str, object]:
    model = fourbar(5)
    return {
        "plain": lambda: runs.run(model, out=folder),
        "overwrite": lambda: runs.run(model, out=folder, overwrite=True),
        "resume": lambda: runs.resume(folder),
        "variants": lambda: runs.run_variants(model, VARIANTS, out=folder, overwrite=True),
        "one variant": lambda: runs.run_variants(model, {"runs.turn.samples": [5]}, out=folder, overwrite=True),
        "whole": lambda: store_whole(folder, open_store(folder).ledger, "{}", {}, overwrite=True),
    }


def test_a_folder_that_another_writer_removes_as_empty_is_made_again(tmp_path, monkeypatch):
    """Another writer fails, and takes away the folder that it made, after ours was found there and before it is locked."""
    folder, gone = tmp_path / "run", []

    def after_the_other(path):
        if len(gone) < 3:
            gone.append(path.rmdir())
        return hold(path)

    monkeypatch.setattr(_lock, "hold", after_the_other)
    with holding(folder):
        assert len(gone) == 3
        assert is_locked(folder)
    assert not folder.exists()


def test_a_folder_that_is_removed_time_and_again_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(_lock, "hold", lambda path: [path.rmdir(), hold(path)])
    with pytest.raises(StoreError, match="cannot be written: No such file"), holding(tmp_path / "run"):
        pass


@pytest.mark.slow
@pytest.mark.parametrize("way", ["plain", "overwrite", "resume", "variants", "one variant", "whole"])
def test_whoever_writes_is_named_to_the_second_and_loses_nothing(folder, way):
    stopped(folder, 4)
    holder = Holder(folder)
    before = contents(folder)
    try:
        assert runs.load(folder).state == "running"
        with pytest.raises(StoreError) as told:
            writers(folder)[way]()
    finally:
        holder.kill()
    for word in (
        str(folder),
        "another process",
        f"process {holder.process.pid} on {socket.gethostname()}, since 20",
        "Wait for it",
    ):
        assert word in str(told.value)
    assert contents(folder) == before
    assert runs.load(folder).state == "incomplete"  # the killed one hinders nobody
    if way == "plain":
        with pytest.raises(InputError, match="holds a run already"):
            writers(folder)[way]()
        return
    writers(folder)[way]()
    assert not (folder / LOCK).exists()


@pytest.mark.slow
def test_variants_spare_a_run_among_them_that_is_being_written(tmp_path):
    out = tmp_path / "out"
    found = runs.run_variants(fourbar(5), VARIANTS, out=out)
    one = next(iter(found.paths.values()))
    holder = Holder(one)
    before = contents(out)
    try:
        with pytest.raises(StoreError, match=f"{one.name} is being written by another process"):
            runs.run_variants(fourbar(5), {"runs.turn.samples": [7, 8]}, out=out, overwrite=True)
    finally:
        holder.kill()
    assert contents(out) == before
    assert len(runs.run_variants(fourbar(5), {"runs.turn.samples": [7, 8]}, out=out, overwrite=True)) == 2
    assert sorted(item.name for item in out.iterdir()) == ["samples=7", "samples=8"]


def test_a_refused_run_leaves_no_folder(tmp_path):
    with pytest.raises(InputError, match="No run called|no run called"):
        runs.run(fourbar(5), "walk", tmp_path / "a" / "b")
    loose = fourbar(drives={}, bars={"p": {"ends": ("A", "B"), "kind": "driven"}, "q": ("B", "C")},
                    runs={"turn": kt.Run(trajectory=kt.Quintic(moves={"p": (1, 2)}, duration=1.0))})  # fmt: skip
    with pytest.raises(KinetrussError):
        runs.run(loose, out=tmp_path / "a" / "b")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_what_a_killed_process_left_before_its_first_block_is_no_hindrance(tmp_path):
    out = tmp_path / "run"
    out.mkdir()
    Holder(out).kill()
    assert [item.name for item in out.iterdir()] == [LOCK]
    assert runs.run(fourbar(5), out=out).whole
    assert not (out / LOCK).exists()


def test_one_who_asks_hinders_no_writer(tmp_path):
    """Asking takes the lock for a moment; a writer that comes in this moment waits for it."""
    import fcntl
    import threading

    (tmp_path / LOCK).touch()
    asking = os.open(tmp_path / LOCK, os.O_RDONLY)
    fcntl.flock(asking, fcntl.LOCK_SH)
    threading.Timer(0.1, os.close, [asking]).start()
    hold(tmp_path).release()


def test_a_lock_whose_file_is_taken_away_meanwhile_is_none(tmp_path, monkeypatch):
    """Between opening and locking the holder before ends and removes the file: what is locked then is nobody's."""
    real, first = _lock._taken, []

    def taken(path, handle, **more):
        if not first:
            first.append(True)
            (path / LOCK).unlink()
        return real(path, handle, **more)

    monkeypatch.setattr(_lock, "_taken", taken)
    held = hold(tmp_path)
    assert is_locked(tmp_path)
    held.release()


def test_a_holder_that_has_not_signed_yet_is_waited_for(tmp_path, monkeypatch):
    held = hold(tmp_path)
    note = (tmp_path / LOCK).read_text()
    (tmp_path / LOCK).write_text("")
    monkeypatch.setattr(_lock.time, "sleep", lambda _seconds: (tmp_path / LOCK).write_text(note))
    with pytest.raises(StoreError, match=f"process {os.getpid()} on"):
        _lock.check_unlocked(tmp_path)
    held.release()


@pytest.mark.parametrize(
    ("machine", "alive", "refused"),
    [(None, True, True), (None, False, False), ("elsewhere", False, True)],
    ids=["alive here", "dead here", "elsewhere"],
)
def test_where_a_file_system_has_no_locks_the_note_decides(tmp_path, monkeypatch, machine, alive, refused):
    def none(handle, how):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr("fcntl.flock", none)
    monkeypatch.setattr(_lock, "PAUSE", 0.0)
    child = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    if not alive:
        child.communicate()
    note = {"process": child.pid, "machine": machine or socket.gethostname(), "since": "2024-01-01"}
    (tmp_path / LOCK).write_text(json.dumps(note))
    assert is_locked(tmp_path) == refused
    if refused:
        with pytest.raises(StoreError, match=f"process {child.pid} on {machine or socket.gethostname()}, since 2024-01-01"):
            hold(tmp_path)
    else:
        hold(tmp_path).release()
        assert not (tmp_path / LOCK).exists()
    child.communicate()


def ledger(samples: int = 6, block: int = 2) -> Ledger:
    return Ledger(run="turn", samples=samples, block=block, options={}, provenance={})


def rows(first: int) -> dict[str, xr.Dataset]:
    return {"motion": xr.Dataset({"q": ("time", np.arange(first, first + 2.0))}, {"time": ("time", [first, first + 1.0])})}


@pytest.mark.parametrize("replaced", [False, True])
def test_a_folder_removed_under_its_writer_is_not_written_to_again(tmp_path, replaced):
    path = tmp_path / "run"
    writer = create(path, ledger(), '"old"')
    writer.append(rows(0))
    shutil.rmtree(path)
    if replaced:
        other = create(path, ledger(), '"new"')
        other.append(rows(0))
        before = contents(path)
    for write in (
        lambda: writer.append(rows(2)),
        lambda: writer.pause("INTERRUPTED", "", 0.0),
        lambda: ended(writer, "COMPLETED"),
    ):
        with pytest.raises(StoreError, match=r"was removed or replaced .* Run it again"):
            write()
    writer.release()
    if not replaced:
        assert not path.exists()
        return
    assert contents(path) == before
    other.append(rows(2))  # and it still holds its folder
    assert is_locked(path)
    other.release()


def test_a_folder_replaced_in_the_middle_of_a_block_is_not_said_to_hold_it(tmp_path, monkeypatch):
    path = tmp_path / "run"
    writer = create(path, ledger(), '"old"')

    def replaced(*_given: object) -> None:
        shutil.rmtree(path)
        create(path, ledger(), '"new"').release()
        raise FileNotFoundError(errno.ENOENT, "No such file or directory")

    monkeypatch.setattr("kinetruss.results.store.Archive.append", replaced)
    with pytest.raises(StoreError, match="was removed or replaced") as told:
        writer.append(rows(0))
    assert "--overwrite" not in str(told.value)
    writer.release()


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere no path leads to a folder that was renamed")
def test_a_folder_that_is_renamed_between_check_and_write_takes_the_block_along(tmp_path, monkeypatch):
    path, check = tmp_path / "run", _lock.Lock.check
    writer = create(path, ledger(), '"old"')
    writer.append(rows(0))

    def replaced(self: _lock.Lock) -> None:
        check(self)
        path.rename(tmp_path / "moved")
        create(path, ledger(), '"new"').release()

    monkeypatch.setattr(_lock.Lock, "check", replaced)
    writer.append(rows(2), state={"x": np.zeros(2)})
    monkeypatch.undo()
    assert not open_store(path).ledger.committed
    assert not (path / "state").exists()
    assert open_store(tmp_path / "moved").read("motion").q.values.tolist() == [0, 1, 2, 3]
    with pytest.raises(StoreError, match="was removed or replaced"):
        ended(writer, "COMPLETED")


def test_a_link_is_as_good_as_its_folder(tmp_path):
    (tmp_path / "real").mkdir()
    link = tmp_path / "link"
    link.symlink_to("real")
    with claimed(link, overwrite=False), pytest.raises(StoreError, match="being written by this process"):
        hold(tmp_path / "real")
    assert runs.run(fourbar(5), out=link).whole
    runs.run_variants(fourbar(5), {"runs.turn.samples": [6]}, out=link, overwrite=True)
    assert runs.load(tmp_path / "real").good == 6
    assert link.is_symlink()
    (tmp_path / "nowhere").symlink_to(tmp_path / "gone")
    with pytest.raises(InputError, match=r"link to .*gone, which is not there"):
        runs.run(fourbar(5), out=tmp_path / "nowhere")


def test_a_lock_file_that_is_a_link_is_not_written_through(tmp_path):
    (tmp_path / "letter").write_text("mine")
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / LOCK).symlink_to(tmp_path / "letter")
    with pytest.raises(StoreError, match="cannot be written"):
        hold(tmp_path / "run")
    assert (tmp_path / "letter").read_text() == "mine"


CLAIM = """
import sys
from pathlib import Path
from kinetruss.errors import StoreError
from kinetruss.results.folder import claimed
from kinetruss.results.lock import is_locked
try:
    with claimed(Path(sys.argv[1]), overwrite=True):
        print("claimed")
except StoreError as error:
    print(is_locked(Path(sys.argv[1])), error)
"""


@pytest.mark.slow
@pytest.mark.parametrize("below", ["", "new"])
def test_a_folder_that_may_not_be_written_is_said_to_be_so(tmp_path, below):
    folder = tmp_path / "run"
    folder.mkdir()
    folder.chmod(0o555)
    done = subprocess.run([*bound(), sys.executable, "-c", CLAIM, folder / below], capture_output=True, text=True, check=False)
    assert "cannot be written: Permission denied. Allow this user to write there, or name another place." in done.stdout, done
    assert done.stdout.startswith("False")


@pytest.mark.parametrize(
    ("number", "words"),
    [
        (errno.ENOSPC, "Make room and continue with: kinetruss run --resume"),
        (errno.EACCES, "Allow this user to write there and continue with"),
        (errno.EROFS, "Make the file system writable and continue with"),
        (errno.EIO, "Continue with: kinetruss run --resume"),
    ],
)
def test_what_is_kept_is_said_with_the_mend_that_fits(tmp_path, monkeypatch, number, words):
    writer = create(tmp_path / "run", ledger(), "{}")
    writer.append(rows(0))

    def refuse(*_given, **_more):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr("kinetruss.results.store.Archive.append", refuse)
    with pytest.raises(StoreError) as told:
        writer.append(rows(2))
    assert "2 of 6 samples are kept in it and good" in str(told.value)
    assert words in str(told.value)
    (tmp_path / "run" / "model.json").unlink()  # what is said to be kept is looked at
    with pytest.raises(StoreError, match=r"was changed by another program.* Run it again"):
        writer.append(rows(2))
    writer.release()


# -- reading while somebody writes -------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_chunk_that_is_not_there_is_an_error_and_no_number(folder):
    members = archived(folder)
    del members["forces/all/total/member_force/1.0"]
    (folder / ARCHIVE).unlink()
    archive = Archive(folder / ARCHIVE)
    archive.append(members)
    archive.seal()
    archive.close()
    found = runs.load(folder)
    with pytest.raises(StoreError, match=r"damaged: forces/all/total/member_force/1\.0 is missing"):
        found.forces["all"].data["member_force"].load()
    with pytest.raises(StoreError, match="damaged"):
        export(folder, folder.parent / "run.csv")
    assert not (folder.parent / "run.csv").exists()


@pytest.mark.slow
@pytest.mark.parametrize("how", ["cut", "noise", "one bit"])
@pytest.mark.parametrize("state", ["finished", "writing", "short variant"])
def test_a_member_that_is_not_as_it_was_written_is_an_error_and_no_number(folder, tmp_path, how, state):
    """Every member in turn, at its header, its name and its content; of a run that ended, and of one that did not."""
    if state == "short variant":
        folder = runs.run_variants(fourbar(9), {"runs.turn.samples": [9]}, out=tmp_path / "one").paths["samples=9"]
    if state == "writing":
        stopped(folder, 8)
    file = folder / ARCHIVE
    good, places = file.read_bytes(), members(folder)
    assert len(places) > 40
    for name, one in list(places.items())[::5]:
        for at in (one.at, one.at + 14, one.at + 34, one.at + 30 + len(name) + one.size // 2):
            new = {
                "cut": good[:at],
                "noise": good[:at] + bytes(255 - byte for byte in good[at:]),
                "one bit": good[:at] + bytes([good[at] ^ 4]) + good[at + 1 :],
            }
            file.write_bytes(new[how])
            with pytest.raises(StoreError, match=r"is damaged: .* Run it again with --overwrite"):
                found = open_store(folder)
                for group in found.groups:
                    found.read(group).load()
    file.write_bytes(good)
    for group in open_store(folder).groups:
        open_store(folder).read(group).load()


@pytest.mark.slow
@pytest.mark.parametrize("text", ["", "{", "[]", '{"nodes": 3}'])
def test_a_damaged_model_is_an_error_of_the_store(folder, text):
    (folder / "model.json").write_text(text)
    with pytest.raises(StoreError, match=r"damaged: model\.json holds no model"):
        runs.load(folder)


@pytest.mark.slow
def test_a_run_that_is_replaced_while_it_is_read_is_not_mixed_with_the_new_one(folder):
    found = runs.load(folder)
    runs.run(fourbar(9), out=folder, block=4, overwrite=True)
    with pytest.raises(StoreError, match="was replaced by another run while it was read. Read it again"):
        found.motion.position.values  # noqa: B018 - read when used
    assert runs.load(folder).motion.position.values.shape[0] == 9


@pytest.mark.slow
@pytest.mark.parametrize("damaged", [False, True])
@pytest.mark.parametrize("place", ["listed", "content_of"])
def test_an_archive_that_is_replaced_while_it_is_opened_is_not_told_as_damaged(folder, monkeypatch, place, damaged):
    real, done = getattr(reading, place), []

    def replaced(*given):
        if not done:
            done.append(place)
            runs.run(fourbar(9), out=folder, block=4, overwrite=True)
            if damaged:
                raise ValueError("what was read is half of the one and half of the other")
        return real(*given)

    monkeypatch.setattr(reading, place, replaced)
    with pytest.raises(StoreError, match="was replaced by another run while it was read. Read it again"):
        open_store(folder)
    assert done
    assert open_store(folder).ledger.whole


@pytest.mark.slow
def test_what_is_known_only_at_the_end_is_not_shown_before(folder):
    """A kill between the last block and the last word: the table of margins may be half written."""
    at = members(folder)["verdict/utilisation/0.0"].at
    stopped(folder, 9)
    os.truncate(folder / ARCHIVE, at + 50)
    found = runs.load(folder)
    assert (found.whole, found.state, found.verdict, found.good) == (False, "incomplete", None, 9)
    assert runs.resume(folder).verdict.table()


STEPS = ((Path, "unlink"), (Path, "rename"), (Path, "replace"), (Path, "mkdir"), (shutil, "rmtree"))
"""What changes the file system."""


def overwritten(path: Path, packed: bool, last: int) -> bool:
    """Replace a run in a copy of this process that ends at the last of so many changes; False where it came to the end."""
    child = os.fork()
    if child:
        return os.waitpid(child, 0)[1] != 0
    left = iter(range(last))

    def counted(real):
        def step(*given, **more):
            if next(left, None) is None:
                os._exit(9)
            return real(*given, **more)

        return step

    for owner, name in STEPS:
        setattr(owner, name, counted(getattr(owner, name)))
    with suppress(BaseException):
        if packed:
            new = Ledger(run="turn", samples=2, block=2, committed=2, state="finished", status="COMPLETED",
                         options={}, provenance={"new": 1})  # fmt: skip
            store_whole(path, new, fourbar(2).model_dump_json(), rows(0), overwrite=True)
        else:
            create(path, ledger(), fourbar(6).model_dump_json(), overwrite=True).release()
        os._exit(0)
    os._exit(1)


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="the test needs os.fork, which this system lacks")
@pytest.mark.parametrize("packed", [False, True])
def test_a_kill_at_any_step_of_an_overwrite_leaves_the_old_run_or_says_that_there_is_none(stored, tmp_path, packed):
    seen, killed, last = set(), True, 0
    while killed:
        path = tmp_path / str(last)
        shutil.copytree(stored, path)
        killed = overwritten(path, packed, last)
        seen.add(verdict_on(path))
        last += 1
    assert last > 8
    assert seen == {"old", "none"} | ({"new"} if packed else set())


def verdict_on(path: Path) -> str:
    """What a folder shows after a kill; resuming it must not continue with half of another run."""
    assert _folder.is_store(path)  # it can be overwritten again
    try:
        found = runs.load(path)
    except StoreError as error:
        assert "--overwrite" in str(error)
        return "none"
    if found.samples == 2:
        return "new" if found.whole and found.motion.data["q"].values.tolist() == [0, 1] else "mixed"
    assert (found.whole, found.good) == (True, 9)
    assert np.isfinite(found.motion.position.values).all()
    return "old"


def test_a_copy_of_the_process_releases_nothing(tmp_path):
    with holding(tmp_path) as held:
        child = os.fork()
        if child == 0:
            with suppress(BaseException):
                held.release()
            os._exit(0)
        os.waitpid(child, 0)
        assert is_locked(tmp_path)
    assert not is_locked(tmp_path)
