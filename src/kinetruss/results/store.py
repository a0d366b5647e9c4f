"""The run store: a folder with a run, written in blocks of samples, and readable after a kill at any instant.

COUNT is the number of samples before the state. The file is written before the ledger counts the block, and the previous
one is removed afterwards. So after a kill at any instant there is a state for the count in the ledger.
"""

from __future__ import annotations

import io
import json
import os
import warnings
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import numpy as np

from kinetruss.errors import StoreError
from kinetruss.results.folder import (
    ARRAYS,
    FORMAT,
    LEDGER,
    MODEL,
    STATE,
    Ledger,
    Stamp,
    atomic,
    check_target,
    clear,
    failure,
    is_store,
    read_ledger,
    stamp_of,
    write_ledger,
)
from kinetruss.results.lock import Lock, cannot_write, hold, is_locked
from kinetruss.results.packed import is_packed, packed_groups, unpacked
from kinetruss.results.zarr_files import (
    DESCRIPTION,
    describe_array,
    describe_group,
    is_array,
    is_text,
    names_of,
    plain,
    resize,
    text_of,
    write_chunk,
)

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray


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


# The run store: a folder with a run, written in blocks of samples, and readable after a kill at any instant.
#
#     OUT/kinetruss.json     ledger: what run this is, how many samples are good (`committed`), how it ended
#     OUT/model.json         the model
#     OUT/results.zarr       Zarr v3 groups motion, forces/CASE/total, ..., chunked along time by block
#     OUT/state/COUNT.npz    of a running simulation: the state of its integration after COUNT samples
#     OUT/pictures           the pictures
#
# A block first writes whole chunks of every array, then the ledger, by rename: a kill between the two leaves chunks that
# nobody reads. Arrays have their full length from the start, so that no description of an array changes during the run.
# Names along a dimension (nodes, members) are attributes of their group.

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
    stamp: Stamp | None

    def read(self, group: str) -> xr.Dataset:
        """One dataset, cut to the good samples; arrays are loaded when used.

        For a run that has not ended, only variables with a time axis: the others are known only at the end.

        Raises
        ------
        StoreError : no such group, or not readable; also later, if an array that is used no longer exists.
        """
        try:
            found: xr.Dataset | None = _read(self.path, group, self.ledger)
            failed = None
        except StoreError as error:
            found, failed = None, error
        if stamp_of(self.path / MODEL) != self.stamp:
            raise StoreError(f"{self.path} was replaced by another run while it was read. Read it again.") from failed
        if found is None:
            raise failed  # type: ignore[misc]
        return found

    def state(self) -> dict[str, NDArray[Any]] | None:
        """The state of the integration after the last good sample; None for runs without one.

        Raises
        ------
        StoreError : it is damaged.
        """
        return read_state(self.path, self.ledger.committed)


class Writer:
    """Writes a run block by block; `ledger` counts the committed samples. held : its lock, if the caller already has it."""

    def __init__(self, path: Path, ledger: Ledger, held: Lock | None = None) -> None:
        self.path = path
        self.ledger = ledger
        self._lock = held or hold(path)
        self._written: dict[str, set[str]] = {}

    def append(
        self, datasets: Mapping[str, xr.Dataset], wall_time: float = 0.0, state: Mapping[str, NDArray[Any]] | None = None
    ) -> None:
        """Write one block of samples of every group, and the state after it, then commit it.

        Groups without a time axis are written completely; the last one replaces the others.

        Raises
        ------
        StoreError : the disk is full or refuses; the committed samples stay readable. Or the folder was replaced.
        """
        self._lock.check()
        count = max((data.sizes["time"] for data in datasets.values() if "time" in data.dims), default=0)
        try:
            for group, data in datasets.items():
                self._write(group, data)
            if state is not None:
                write_state(self.path, self.ledger.committed + count, state)
            self._commit(replace(self.ledger, committed=self.ledger.committed + count, wall_time=wall_time))
            if state is not None:
                drop_states(self.path, self.ledger.committed)
        except OSError as error:
            raise self._failed(error) from error

    def pause(self, status: str, message: str, wall_time: float) -> None:
        """Store why the run was stopped; it can be continued."""
        self._lock.check()
        try:
            self._commit(replace(self.ledger, status=status, message=message, wall_time=wall_time))
        except OSError as error:
            raise self._failed(error) from error

    def close(self, status: str, message: str = "", wall_time: float | None = None) -> None:
        """Mark the run as ended, and cut arrays to the good samples if it stopped early."""
        try:
            self._lock.check()
            if self.ledger.committed < self.ledger.samples:
                _truncate(self.path, self.ledger.committed)
            wall = self.ledger.wall_time if wall_time is None else wall_time
            self._commit(replace(self.ledger, state="finished", status=status, message=message, wall_time=wall))
            drop_states(self.path)
        except OSError as error:
            raise self._failed(error) from error
        finally:
            self.release()

    def release(self) -> None:
        """Let another process write; the run does not change."""
        self._lock.release()

    def _failed(self, error: OSError) -> StoreError:
        try:
            self._lock.check()  # an error in a folder that was replaced does not concern this run
        except StoreError as gone:
            return gone
        return StoreError(failure(self.path, self.ledger, error))

    def _commit(self, ledger: Ledger) -> None:
        write_ledger(self.path, ledger)
        self.ledger = ledger

    def _write(self, group: str, data: xr.Dataset) -> None:
        known = self._written.setdefault(group, set())
        if new := {str(name) for name in data.variables} - known:
            _prepare(self.path, group, data, self.ledger)
            known |= new
        block, rows = self.ledger.committed // self.ledger.block, min(self.ledger.block, self.ledger.samples)
        for name, variable in data.variables.items():
            if is_text(variable):
                continue
            folder = self.path / ARRAYS / group / str(name)
            timed = variable.dims[:1] == ("time",)
            write_chunk(folder, block if timed else 0, variable.values, rows if timed else _rows(variable))


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
    writer = Writer(path, ledger, held)
    try:
        if is_store(path):
            clear(path, ledger=False)
        write_ledger(path, ledger)
        describe_group(path / ARRAYS, {"kinetruss_run": FORMAT})
        atomic(path / MODEL, model_text)  # from here on the run can be read and continued
    except OSError as error:
        writer.release()
        raise StoreError(failure(path, ledger, error)) from error
    return writer


def reopen(path: Path, ledger: Ledger, held: Lock | None = None) -> Writer:
    """Continue to write a run that did not end, after its last good sample.

    Raises
    ------
    StoreError : another process is writing it.
    """
    return Writer(path, replace(ledger, status="", message=""), held)


def open_store(path: Path) -> Store:
    """Open a run folder for reading.

    Raises
    ------
    StoreError : no run folder, one of a newer format, or one that is being replaced.
    """
    if not is_store(path):
        raise StoreError(f"{path} is not a kinetruss run: it has no {LEDGER}. Make one with: kinetruss run MODEL -o {path}")
    stamp = stamp_of(path / MODEL)
    record = read_ledger(path)
    if record["kinetruss_run"] > FORMAT:
        raise StoreError(f"{path} was written by a newer kinetruss. Update: pip install --upgrade kinetruss")
    try:
        ledger = Ledger(**record)
        text = (path / MODEL).read_text("utf-8")
        ended = ledger.state == "finished"
        groups = (
            tuple(name for name in _groups(path) if ended or name not in (VERDICT, ENVELOPE))
            if ledger.committed or ended
            else ()
        )
        again = read_ledger(path)
    except (OSError, TypeError, ValueError) as error:
        if is_locked(path):
            raise StoreError(
                f"{path} has just been started by another process and has no good sample yet. Try again soon."
            ) from error
        raise StoreError(f"{path} is damaged: {error}. Run it again with --overwrite.") from error
    if any(again[name] != record[name] for name in ("provenance", "options", "block", "samples")):
        raise StoreError(f"{path} was replaced by another run while it was read. Read it again.")
    return Store(path, ledger, text, groups, stamp)


def _groups(path: Path) -> tuple[str, ...]:
    """Datasets in the folder: groups with arrays, in a fixed order."""
    root = path / ARRAYS
    if is_packed(path):
        return tuple(sorted(packed_groups(path), key=lambda name: (ORDER.index(name.split("/")[0]), name)))
    found = {file.parent.parent.relative_to(root).as_posix() for file in root.glob(f"**/{DESCRIPTION}") if is_array(file)}
    return tuple(sorted(found, key=lambda name: (ORDER.index(name.split("/")[0]), name)))


def _prepare(path: Path, group: str, data: xr.Dataset, ledger: Ledger) -> None:
    """Describe the group and its arrays, for all samples; existing arrays of a resumed run stay."""
    root = path / ARRAYS
    for parent in reversed(Path(group).parents[:-1]):
        if not (root / parent / DESCRIPTION).exists():
            describe_group(root / parent, {})
    texts = {str(name): text_of(variable) for name, variable in data.variables.items() if is_text(variable)}
    _describe(root / group, data, texts)
    for name, variable in data.variables.items():
        folder = root / group / str(name)
        if str(name) in texts or (folder / DESCRIPTION).exists():
            continue
        timed = variable.dims[:1] == ("time",)
        shape = (ledger.samples, *variable.shape[1:]) if timed else variable.shape
        rows = min(ledger.block, ledger.samples) if timed else _rows(variable)
        describe_array(folder, shape, rows, variable.dtype, [str(dim) for dim in variable.dims], plain(variable.attrs))


def _describe(folder: Path, data: xr.Dataset, texts: dict[str, Any]) -> None:
    """Names, order and attributes of a dataset, merged with those of its group."""
    description = folder / DESCRIPTION
    before = json.loads(description.read_text("utf-8"))["attributes"] if description.exists() else {}
    new = {
        "names": before.get("names", {}) | texts,
        "attrs": before.get("attrs", {}) | data.attrs,
        "coords": list(dict.fromkeys([*before.get("coords", []), *map(str, data.coords)])),
        "order": list(dict.fromkeys([*before.get("order", []), *map(str, data.data_vars)])),
    }
    if new != before:
        describe_group(folder, new)


def _rows(variable: Any) -> int:
    """Rows per chunk of an array without a time axis: all."""
    return max(1, variable.shape[0]) if variable.shape else 1


def _read(path: Path, group: str, ledger: Ledger) -> xr.Dataset:
    import xarray as xr

    data = unpacked(path, group) if is_packed(path) else _opened(path, group, -(-ledger.committed // ledger.block))
    names, attrs, coords, order = (data.attrs.pop(key, {}) for key in ("names", "attrs", "coords", "order"))
    if "time" in data.dims:
        data = data.isel(time=slice(0, ledger.committed))
    data = data.assign({name: names_of(text) for name, text in names.items()})
    if ledger.state != "finished":
        order = [name for name in order if name in data.variables and "time" in data.variables[name].dims]
    if lost := [name for name in (*coords, *order) if name not in data.variables]:
        raise StoreError(f"{path} is damaged: {group}/{lost[0]} is missing. Run it again with --overwrite.")
    return xr.Dataset({n: data.variables[n] for n in order}, {n: data.variables[n] for n in coords}, attrs)


def _opened(path: Path, group: str, blocks: int) -> xr.Dataset:
    import xarray as xr

    from kinetruss.results.array_reading import RunArrays

    try:
        root = RunArrays(path / ARRAYS, blocks=blocks)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # the description of the array may be just being written
            data: xr.Dataset = xr.open_zarr(root, group=group, chunks=None, consolidated=False, zarr_format=3, decode_cf=False)
    except (OSError, KeyError, ValueError) as error:
        raise StoreError(f"{path} has no readable {group!r}: {error}") from error
    return data


def _truncate(path: Path, committed: int) -> None:
    """Cut every array with a time axis to the good samples."""
    for description in (path / ARRAYS).glob(f"**/{DESCRIPTION}"):
        resize(description, committed)
