"""The run store: a folder that holds a run, written in blocks of samples, and readable after a kill at any instant.

    OUT/kinetruss.json     ledger: what run this is, how many samples are good (`committed`), how it ended
    OUT/model.json         the model
    OUT/results.zarr       Zarr v3 groups motion, forces/CASE/total, ..., chunked along time by block
    OUT/state/COUNT.npz    of a simulation on its way: where its integration stands behind COUNT samples
    OUT/pictures           what the report drew

A block first writes whole chunks of every array, then the ledger, by rename: a kill between the two leaves chunks that
nobody reads. Arrays have their full length from the start, so that no array's own description is rewritten on the way.
Names along a dimension (nodes, members) stand in the attributes of their group.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import numpy as np

from kinetruss.errors import StoreError
from kinetruss.results._checkpoint import drop_states, read_state, write_state
from kinetruss.results._folder import (
    ARRAYS,
    FORMAT,
    LEDGER,
    MODEL,
    Ledger,
    atomic,
    check_target,
    clear,
    failure,
    is_store,
    lock,
    write_ledger,
)
from kinetruss.results._packed import is_packed, packed_groups, unpacked
from kinetruss.results._zarr import DESCRIPTION, describe_array, describe_group, is_array, resize, write_chunk

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

__all__ = ["Store", "Writer", "create", "key", "open_store", "reopen"]

ORDER = ("motion", "simulation", "forces", "sections", "verdict", "demand")


@dataclass(frozen=True, slots=True)
class Store:
    """A run folder opened for reading; `groups` are the paths of the datasets in it, e.g. ``forces/all/total``."""

    path: Path
    ledger: Ledger
    model_text: str
    groups: tuple[str, ...]

    def read(self, group: str) -> xr.Dataset:
        """One dataset, cut to the samples that are good; arrays load when used.

        Raises
        ------
        StoreError : no such group, or not readable.
        """
        return _read(self.path, group, self.ledger.committed)

    def state(self) -> dict[str, NDArray[Any]] | None:
        """Where the integration stands behind the last good sample; None for runs that need no such thing.

        Raises
        ------
        StoreError : it is damaged.
        """
        return read_state(self.path, self.ledger.committed)


class Writer:
    """Writes a run block by block; `ledger` tells how far it is safe."""

    def __init__(self, path: Path, ledger: Ledger) -> None:
        self.path = path
        self.ledger = ledger
        self._lock = lock(path)
        self._written: dict[str, set[str]] = {}

    def append(
        self, datasets: Mapping[str, xr.Dataset], wall_time: float = 0.0, state: Mapping[str, NDArray[Any]] | None = None
    ) -> None:
        """Write one block of samples of every group, and the state behind it, then count it as good.

        Groups without a time axis are written whole; the last one written counts.

        Raises
        ------
        StoreError : the disk is full or refuses; the samples counted before stay readable.
        """
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
            raise StoreError(failure(self.path, self.ledger, error)) from error

    def pause(self, status: str, message: str, wall_time: float) -> None:
        """Note why the run stands still; it can be gone on with."""
        try:
            self._commit(replace(self.ledger, status=status, message=message, wall_time=wall_time))
        except OSError as error:
            raise StoreError(failure(self.path, self.ledger, error)) from error

    def close(self, status: str, message: str = "", wall_time: float | None = None) -> None:
        """Mark the run as ended, and cut arrays to what is good where the run stopped early."""
        try:
            if self.ledger.committed < self.ledger.samples:
                _truncate(self.path, self.ledger.committed)
            wall = self.ledger.wall_time if wall_time is None else wall_time
            self._commit(replace(self.ledger, state="finished", status=status, message=message, wall_time=wall))
            drop_states(self.path)
        except OSError as error:
            raise StoreError(failure(self.path, self.ledger, error)) from error
        finally:
            self.release()

    def release(self) -> None:
        """Let another process write; the run stays as it is."""
        if self._lock is not None:
            os.close(self._lock)
            self._lock = None

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
            if _is_text(variable):
                continue
            folder = self.path / ARRAYS / group / str(name)
            timed = variable.dims[:1] == ("time",)
            write_chunk(folder, block if timed else 0, variable.values, rows if timed else _rows(variable))


def key(case: str) -> str:
    """The name of a load case as part of a path: nothing in it can lead out of the folder.

    >>> key("hanging"), key(".."), key("a:b")
    ('hanging', '%2E.', 'a%3Ab')
    """
    quoted = quote(case, safe="")
    return f"%{ord(quoted[0]):02X}{quoted[1:]}" if quoted.startswith((".", "__")) else quoted


def create(path: Path, ledger: Ledger, model_text: str, *, overwrite: bool = False) -> Writer:
    """Begin a run in a new or empty folder; with `overwrite`, replace the run in it (and nothing else in it).

    Raises
    ------
    InputError : see `check_target`.
    StoreError : the folder cannot be made or written.
    """
    check_target(path, overwrite)
    try:
        path.mkdir(parents=True, exist_ok=True)
        if is_store(path):
            clear(path)
        write_ledger(path, ledger)
        atomic(path / MODEL, model_text)
        describe_group(path / ARRAYS, {"kinetruss_run": FORMAT})
    except OSError as error:
        raise StoreError(failure(path, ledger, error)) from error
    return Writer(path, ledger)


def reopen(path: Path, ledger: Ledger) -> Writer:
    """Go on writing a run that did not end, behind its last good sample.

    Raises
    ------
    StoreError : another process is writing it.
    """
    return Writer(path, replace(ledger, status="", message=""))


def open_store(path: Path) -> Store:
    """Open a run folder for reading.

    Raises
    ------
    StoreError : no run folder, or one of a newer format.
    """
    if not is_store(path):
        raise StoreError(f"{path} is no kinetruss run: it has no {LEDGER}. Make one with: kinetruss run MODEL -o {path}")
    record = json.loads((path / LEDGER).read_text("utf-8"))
    if record["kinetruss_run"] > FORMAT:
        raise StoreError(f"{path} was written by a newer kinetruss. Update: pip install --upgrade kinetruss")
    try:
        ledger = Ledger(**record)
        text = (path / MODEL).read_text("utf-8")
    except (OSError, TypeError) as error:
        raise StoreError(f"{path} is damaged: {error}. Run it again with --overwrite.") from error
    return Store(path, ledger, text, _groups(path) if ledger.committed or ledger.state == "finished" else ())


def _groups(path: Path) -> tuple[str, ...]:
    """Datasets in the folder: groups that hold arrays, in a fixed order."""
    root = path / ARRAYS
    if is_packed(path):
        return tuple(sorted(packed_groups(path), key=lambda name: (ORDER.index(name.split("/")[0]), name)))
    found = {file.parent.parent.relative_to(root).as_posix() for file in root.glob(f"**/{DESCRIPTION}") if is_array(file)}
    return tuple(sorted(found, key=lambda name: (ORDER.index(name.split("/")[0]), name)))


def _prepare(path: Path, group: str, data: xr.Dataset, ledger: Ledger) -> None:
    """Describe the group and its arrays, for all samples; what is there already (of a resumed run) stays."""
    root = path / ARRAYS
    for parent in reversed(Path(group).parents[:-1]):
        if not (root / parent / DESCRIPTION).exists():
            describe_group(root / parent, {})
    texts = {str(name): _text(variable) for name, variable in data.variables.items() if _is_text(variable)}
    _describe(root / group, data, texts)
    for name, variable in data.variables.items():
        folder = root / group / str(name)
        if str(name) in texts or (folder / DESCRIPTION).exists():
            continue
        timed = variable.dims[:1] == ("time",)
        shape = (ledger.samples, *variable.shape[1:]) if timed else variable.shape
        rows = min(ledger.block, ledger.samples) if timed else _rows(variable)
        attributes = {key: str(value) for key, value in variable.attrs.items()}
        describe_array(folder, shape, rows, variable.dtype, [str(dim) for dim in variable.dims], attributes)


def _describe(folder: Path, data: xr.Dataset, texts: dict[str, Any]) -> None:
    """Names, order and attributes of a dataset, joined to those its group has already."""
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
    """Rows of a chunk of what has no time axis: all."""
    return max(1, variable.shape[0]) if variable.shape else 1


def _is_text(variable: Any) -> bool:
    return variable.dtype.kind in "OUST"


def _text(variable: Any) -> dict[str, Any]:
    """A variable of names, as it is kept in the attributes of its group."""
    values = np.asarray(variable.values).astype(str).tolist()
    return {"dims": list(variable.dims), "values": values, "attrs": {key: str(value) for key, value in variable.attrs.items()}}


def _read(path: Path, group: str, committed: int) -> xr.Dataset:
    import xarray as xr

    data = unpacked(path, group) if is_packed(path) else _opened(path, group)
    names, attrs, coords, order = (data.attrs.pop(key, {}) for key in ("names", "attrs", "coords", "order"))
    if "time" in data.dims:
        data = data.isel(time=slice(0, committed))
    texts = {name: (text["dims"], np.asarray(text["values"]), text["attrs"]) for name, text in names.items()}
    data = data.assign(texts)
    return xr.Dataset({n: data.variables[n] for n in order}, {n: data.variables[n] for n in coords}, attrs)


def _opened(path: Path, group: str) -> xr.Dataset:
    import xarray as xr

    root = str(path / ARRAYS)
    try:
        data: xr.Dataset = xr.open_zarr(root, group=group, chunks=None, consolidated=False, zarr_format=3, decode_cf=False)
    except (OSError, KeyError, ValueError) as error:
        raise StoreError(f"{path} has no readable {group!r}: {error}") from error
    return data


def _truncate(path: Path, committed: int) -> None:
    """Cut every array with a time axis to the samples that are good."""
    for description in (path / ARRAYS).glob(f"**/{DESCRIPTION}"):
        resize(description, committed)
