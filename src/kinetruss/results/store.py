"""The run store: a folder with a run, written in blocks of samples, and readable after a kill at any instant.

    OUT/kinetruss.json      ledger: what run this is, how many samples are good (`committed`), how it ended
    OUT/model.json          the model
    OUT/results.zarr.zip    Zarr v3 groups motion, forces/CASE/total, ... in an archive, chunked along time by block
    OUT/state/COUNT.npz     of a running simulation: the state of its integration after COUNT samples
    OUT/pictures            the pictures

A block is appended to the archive, then the ledger counts it and the bytes that are good, by rename: a kill between the two
leaves bytes that nobody reads, and that are cut off when the run goes on. The state of a block is written before the ledger
counts it, and the previous one is removed afterwards. When a run ends, the archive gets its directory.
"""

from __future__ import annotations

import io
import json
import os
import zipfile
from collections.abc import Callable, Mapping
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import numpy as np

from kinetruss.errors import StoreError
from kinetruss.results.archive import Archive
from kinetruss.results.encoding import DESCRIPTION, cut, encoded
from kinetruss.results.folder import (
    ARCHIVE,
    ARRAYS,
    DRAFT,
    FORMAT,
    LEDGER,
    MODEL,
    STATE,
    Ledger,
    atomic,
    check_target,
    claimed,
    clear,
    failure,
    is_store,
    read_ledger,
    remove,
    stamp_of,
    write_ledger,
)
from kinetruss.results.lock import Lock, cannot_write, hold, is_locked
from kinetruss.results.reading import Content, content, dataset
from kinetruss.results.user_parts import users

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

VERDICT, ENVELOPE = "verdict", "envelope"
"""Groups that are written once, at the end."""
ORDER = ("pairs", "envelope", "motion", "simulation", "statics", "forces", "sections", VERDICT, "demand")


@dataclass(frozen=True, slots=True)
class Store:
    """A run folder opened for reading; `groups` are the paths of the datasets in it, e.g. ``forces/all/total``."""

    path: Path
    ledger: Ledger
    model_text: str
    groups: tuple[str, ...]
    content: Content

    def read(self, group: str, *, whole: bool = False) -> xr.Dataset:
        """One dataset, cut to the good samples; arrays are loaded when used. whole : with inner parts (`Result.whole`).

        For a run that has not ended, only variables with a time axis: the others are known only at the end.

        Raises
        ------
        StoreError : no such group, or not readable; also later, if an array that is used no longer exists.
        """
        self.content.check()
        found = dataset(self.content, group, self.ledger)
        return found if whole else users(found)

    def state(self) -> dict[str, NDArray[Any]] | None:
        """The state of the integration after the last good sample; None for runs without one.

        Raises
        ------
        StoreError : it is damaged.
        """
        return read_state(self.path, self.ledger.committed)


@dataclass(frozen=True, slots=True)
class End:
    """The end of a run: its status and message, and the `groups` known only then."""

    status: str
    message: str = ""
    groups: Mapping[str, xr.Dataset] = field(default_factory=dict)


class Writer:
    """Writes a run block by block into its archive; `ledger` counts the committed samples."""

    def __init__(self, path: Path, ledger: Ledger, archive: Archive, lock: Lock) -> None:
        self.path, self.ledger = path, ledger
        self._archive, self._lock = archive, lock

    def append(
        self,
        datasets: Mapping[str, xr.Dataset],
        wall_time: float = 0.0,
        state: Mapping[str, NDArray[Any]] | None = None,
        end: End | None = None,
    ) -> None:
        """Write one block of samples of every group, and the state after it, then commit it.

        Groups without a time axis are written completely; the last one replaces the others. end : of a run of which this is the
        last block; it is marked as ended in the same step, so that no part of what is known only then can be missing.

        Raises
        ------
        StoreError : the disk is full or refuses; the committed samples stay readable. Or the folder was replaced.
        """
        self._lock.check()
        count = self.ledger.committed + max(
            (data.sizes["time"] for data in datasets.values() if "time" in data.dims), default=0
        )
        try:
            for groups in [datasets] if end is None else [datasets, end.groups]:
                self._archive.append(dict(encoded(groups, self.ledger, self._attributes(groups))))
            if end is not None:
                self._finish(count, end, wall_time)
                return
            if state is not None:
                write_state(self._lock.folder, count, state)
            self._commit(committed=count, wall_time=wall_time)
            if state is not None:
                drop_states(self._lock.folder, count)
        except OSError as error:
            raise self._failed(error) from error

    def pause(self, status: str, message: str, wall_time: float) -> None:
        """Store why the run was stopped; it can be continued. One that has ended stays as it is."""
        self._lock.check()
        try:
            # an interrupt may have come after the file was replaced: what it counts is not taken back
            self.ledger = Ledger(**read_ledger(self._lock.folder))
            if self.ledger.state == "finished":
                drop_states(self._lock.folder)
                return
            self._archive.seal()
            self._commit(status=status, message=message, wall_time=wall_time)
        except OSError as error:
            raise self._failed(error) from error

    def _finish(self, count: int, end: End, wall_time: float) -> None:
        """Mark the run as ended, and cut arrays to the good samples if it stopped early."""
        if count < self.ledger.samples:
            names = [name for name in self._archive.members if name.endswith(DESCRIPTION)]
            self._archive.append({name: cut(self._archive.read(name), count) for name in names})
        self._archive.seal()
        self._commit(state="finished", committed=count, status=end.status, message=end.message, wall_time=wall_time)
        drop_states(self._lock.folder)

    def release(self) -> None:
        """Let another process write; the run does not change."""
        self._archive.close()
        self._lock.release()

    def _attributes(self, groups: Mapping[str, Any]) -> dict[str, Any]:
        """The attributes of groups that are in the archive."""
        names = {group: f"{group}/{DESCRIPTION}" for group in groups}
        there = {group: name for group, name in names.items() if name in self._archive.members}
        return {group: json.loads(self._archive.read(name))["attributes"] for group, name in there.items()}

    def _failed(self, error: OSError) -> StoreError:
        try:
            self._lock.check()  # an error in a folder that was replaced does not concern this run
        except StoreError as gone:
            return gone
        return StoreError(failure(self.path, self.ledger, error))

    def _commit(self, **changes: Any) -> None:
        ledger = replace(self.ledger, length=self._archive.length, **changes)
        write_ledger(self._lock.folder, ledger)
        self.ledger = ledger


def key(case: str) -> str:
    """The name of a load case as part of a path, encoded so that it cannot lead out of the folder.

    >>> key("hanging"), key(".."), key("a:b")
    ('hanging', '%2E.', 'a%3Ab')
    """
    quoted = quote(case, safe="")
    return f"%{ord(quoted[0]):02X}{quoted[1:]}" if quoted.startswith((".", "__")) else quoted


def create(path: Path, ledger: Ledger, model_text: str, *, overwrite: bool = False, held: Lock | None = None) -> Writer:
    """Begin a run in a new or empty folder; with `overwrite`, replace the run in it (and no other file).

    held : the folder's lock, if the caller already has it.

    Raises
    ------
    InputError : see `check_target`.
    StoreError : the folder cannot be made or written, or another process writes it.
    """
    check_target(path, overwrite)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise cannot_write(path, error) from error

    def begin(folder: Path) -> Ledger:
        clear(folder, keep=(LEDGER,))
        write_ledger(folder, ledger)
        (folder / ARCHIVE).touch()
        atomic(folder / MODEL, model_text)  # from here on the run can be read and continued
        return ledger

    return _opened(path, ledger, begin, held)


def store_whole(
    path: Path, ledger: Ledger, model_text: str, datasets: Mapping[str, xr.Dataset], *, overwrite: bool = False
) -> None:
    """Write a whole run at once; with `overwrite`, in place of the run in the folder. It is there completely or not at all.

    Nothing waits for the disk: of many short runs that would take most of the time.

    Raises
    ------
    InputError : see `check_target`.
    StoreError : the folder cannot be written, or another process writes it.
    """
    first = replace(ledger, committed=0, samples=ledger.committed, block=max(1, ledger.committed))
    with claimed(path, overwrite) as held:
        folder = held.folder
        draft = folder / DRAFT
        try:
            remove(draft)
            archive = Archive(draft)
            try:
                archive.append(dict(encoded(datasets, first, {})), durable=False)
                archive.seal(durable=False)
            finally:
                archive.close()
            clear(folder, keep=(DRAFT, LEDGER))
            # the ledger first, by which the folder is known as this package's; without its model it is not yet a run
            write_ledger(folder, replace(ledger, length=archive.length), durable=False)
            draft.rename(folder / ARCHIVE)
            atomic(folder / MODEL, model_text, durable=False)
        except OSError as error:
            raise StoreError(failure(path, replace(ledger, committed=0), error)) from error
        finally:
            with suppress(OSError):
                remove(draft)


def reopen(path: Path, ledger: Ledger, held: Lock | None = None) -> Writer:
    """Continue to write a run that did not end, after its last good sample.

    Raises
    ------
    StoreError : another process is writing it; its archive is damaged, or cannot be written.
    """

    def begin(folder: Path) -> Ledger:
        same = replace(ledger, status="", message="")
        found = _converted(folder, same) if ledger.kinetruss_run < FORMAT else same
        if (folder / ARRAYS).exists():
            # the model is written again, so that those who read the files are told that they are gone
            atomic(folder / MODEL, (folder / MODEL).read_text("utf-8"))
            remove(folder / ARRAYS)
        return found

    return _opened(path, ledger, begin, held)


def _opened(path: Path, ledger: Ledger, begin: Callable[[Path], Ledger], held: Lock | None) -> Writer:
    """A writer of a folder that `begin` has made ready; the lock is released if that fails."""
    with ExitStack() as undone:
        lock = held or hold(path)
        undone.callback(lock.release)
        try:
            ready = begin(lock.folder)
            archive = Archive(lock.folder / ARCHIVE, ready.length)
        except ValueError as error:
            raise StoreError(f"{path} is damaged: {error}. Run it again with --overwrite.") from error
        except OSError as error:
            raise StoreError(failure(path, ledger, error)) from error
        undone.pop_all()
    return Writer(path, ready, archive, lock)


def _converted(path: Path, ledger: Ledger) -> Ledger:
    """The ledger of a run of format 1 after its files are members of an archive, by the same names.

    A kill before the ledger is replaced leaves the files as they were.
    """
    root = path / ARRAYS
    remove(path / ARCHIVE)
    archive = Archive(path / ARCHIVE)
    try:
        for file in sorted(one for one in root.rglob("*") if one.is_file() and one.suffix != ".part"):
            archive.append({file.relative_to(root).as_posix(): file.read_bytes()}, durable=False)
        archive.append({}, durable=True)
    finally:
        archive.close()
    ledger = replace(ledger, kinetruss_run=FORMAT, length=archive.length)
    write_ledger(path, ledger)
    return ledger


def open_store(path: Path) -> Store:
    """Open a run folder for reading.

    Raises
    ------
    StoreError : no run folder, one of a newer format, or one that is being replaced.
    """
    if not is_store(path):
        raise StoreError(f"{path} is not a kinetruss run: it has no {LEDGER}. Make one with: kinetruss run MODEL -o {path}")
    stamp = stamp_of(path / MODEL)
    try:
        record = read_ledger(path)
        if record["kinetruss_run"] > FORMAT:
            raise StoreError(f"{path} was written by a newer kinetruss. Update: pip install --upgrade kinetruss")
        ledger = Ledger(**record)
        text = (path / MODEL).read_text("utf-8")
        found = content(path, ledger, stamp)
    except (OSError, TypeError, ValueError, KeyError) as error:
        if is_locked(path):
            raise StoreError(
                f"{path} has just been started by another process and has no good sample yet. Try again soon."
            ) from error
        if stamp_of(path / MODEL) != stamp:
            raise StoreError(f"{path} was replaced by another run while it was read. Read it again.") from error
        raise StoreError(f"{path} is damaged: {error}. Run it again with --overwrite.") from error
    found.check()
    ended = ledger.state == "finished"
    seen = found.groups if ledger.committed or ended else ()
    groups = [name for name in seen if ended or name not in (VERDICT, ENVELOPE)]
    return Store(path, ledger, text, tuple(sorted(groups, key=lambda name: (ORDER.index(name.split("/")[0]), name))), found)


# States: COUNT is the number of samples before the state. The file is written before the ledger counts the block, and the
# previous one is removed afterwards. So after a kill at any instant there is a state for the count in the ledger.


def write_state(path: Path, count: int, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Write the state after `count` samples, in one step."""
    target = _file(path, count)
    target.parent.mkdir(exist_ok=True)
    packed = io.BytesIO()
    np.savez(packed, allow_pickle=False, **dict(arrays))
    draft = target.with_suffix(".part")
    with draft.open("wb") as file:
        file.write(packed.getvalue())
        file.flush()
        os.fsync(file.fileno())
    draft.replace(target)


def read_state(path: Path, count: int) -> dict[str, NDArray[Any]] | None:
    """The state after `count` samples, or None if there is none.

    Raises
    ------
    StoreError : the file is damaged.
    """
    file = _file(path, count)
    try:
        with file.open("rb") as handle, np.load(handle, allow_pickle=False) as found:
            return {name: found[name] for name in found.files}
    except FileNotFoundError:
        return None
    except (OSError, ValueError, EOFError, KeyError, zipfile.BadZipFile) as error:
        raise StoreError(f"{file} is damaged: {error}. Run it again with --overwrite.") from error


def drop_states(path: Path, keep: int | None = None) -> None:
    """Remove all states except that after `keep` samples."""
    folder = path / STATE
    kept = None if keep is None else _file(path, keep)
    for file in folder.glob("*.*"):
        if file != kept:
            file.unlink(missing_ok=True)
    if keep is None:
        with suppress(OSError):
            folder.rmdir()


def _file(path: Path, count: int) -> Path:
    return path / STATE / f"{count}.npz"
