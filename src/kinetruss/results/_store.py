"""The run store: a folder that holds a run, written in blocks of samples, and readable after a kill at any instant.

    OUT/kinetruss.json     ledger: what run this is, how many samples are good (`committed`), how it ended
    OUT/model.json         the model
    OUT/results.zarr       Zarr v3 groups motion, forces/CASE/total, ..., chunked along time by block
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
import zarr

from kinetruss.errors import StoreError
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

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Store", "Writer", "create", "key", "open_store", "reopen"]

ORDER = ("motion", "forces", "sections", "verdict", "demand")


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


class Writer:
    """Writes a run block by block; `ledger` tells how far it is safe."""

    def __init__(self, path: Path, ledger: Ledger) -> None:
        self.path = path
        self.ledger = ledger
        self._lock = lock(path)
        self._arrays: dict[str, Any] = {}

    def append(self, datasets: Mapping[str, xr.Dataset], wall_time: float = 0.0) -> None:
        """Write one block of samples of every group, then count it as good.

        Groups without a time axis are written whole; the last one written counts.

        Raises
        ------
        StoreError : the disk is full or refuses; the samples counted before stay readable.
        """
        count = max((data.sizes["time"] for data in datasets.values() if "time" in data.dims), default=0)
        try:
            for group, data in datasets.items():
                self._write(group, data)
            self._commit(replace(self.ledger, committed=self.ledger.committed + count, wall_time=wall_time))
        except OSError as error:
            raise StoreError(failure(self.path, self.ledger, error)) from error

    def close(self, status: str, message: str = "", wall_time: float | None = None) -> None:
        """Mark the run as ended, and cut arrays to what is good where the run stopped early."""
        try:
            if self.ledger.committed < self.ledger.samples:
                _truncate(self.path, self.ledger.committed)
            wall = self.ledger.wall_time if wall_time is None else wall_time
            self._commit(replace(self.ledger, state="finished", status=status, message=message, wall_time=wall))
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
        arrays = self._arrays.setdefault(group, {})
        if not {str(name) for name in data.variables} <= arrays.keys():
            arrays |= _prepare(self.path, group, data, self.ledger)
        start = self.ledger.committed
        for name, variable in data.variables.items():
            array = arrays[str(name)]
            if array is None:  # names, in the group's attributes
                continue
            values = np.asarray(variable.values)
            if variable.dims[:1] == ("time",):
                array[start : start + len(values)] = values
            else:
                array[...] = values


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
        zarr.create_group(str(path / ARRAYS), zarr_format=3, attributes={"kinetruss_run": FORMAT})
    except OSError as error:
        raise StoreError(failure(path, ledger, error)) from error
    return Writer(path, ledger)


def reopen(path: Path, ledger: Ledger) -> Writer:
    """Go on writing a run that did not end, behind its last good sample.

    Raises
    ------
    StoreError : another process is writing it.
    """
    return Writer(path, ledger)


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
    found = {file.parent.parent.relative_to(root).as_posix() for file in root.glob("**/zarr.json") if _is_array(file)}
    return tuple(sorted(found, key=lambda name: (ORDER.index(name.split("/")[0]), name)))


def _is_array(file: Path) -> bool:
    return bool(json.loads(file.read_text("utf-8"))["node_type"] == "array")


def _prepare(path: Path, group: str, data: xr.Dataset, ledger: Ledger) -> dict[str, Any]:
    """Arrays of a group by name: made for all samples, or found where a run is resumed; None for names."""
    node = zarr.open_group(str(path / ARRAYS), mode="a", zarr_format=3, path=group)
    texts, numeric = _split(data)
    arrays: dict[str, Any] = dict.fromkeys(texts)
    for name in numeric:
        variable = data.variables[name]
        timed = variable.dims[:1] == ("time",)
        shape = (ledger.samples, *variable.shape[1:]) if timed else variable.shape
        chunks = (min(ledger.block, ledger.samples), *variable.shape[1:]) if timed else variable.shape
        if name in node:
            arrays[name] = node[name]
            continue
        arrays[name] = node.create_array(
            name, shape=shape, chunks=tuple(max(1, n) for n in chunks), dtype=variable.dtype,
            # one file a chunk, without a tree of folders for its indices: quicker to write and to remove
            chunk_key_encoding={"name": "v2", "separator": "."}, fill_value=np.nan if variable.dtype.kind == "f" else 0,
            dimension_names=[str(d) for d in variable.dims], attributes={k: str(v) for k, v in variable.attrs.items()},
        )  # fmt: skip
    before: dict[str, Any] = dict(node.attrs)
    coords = list(dict.fromkeys([*before.get("coords", []), *map(str, data.coords)]))
    order = list(dict.fromkeys([*before.get("order", []), *map(str, data.data_vars)]))
    new = {
        "names": before.get("names", {}) | texts,
        "attrs": before.get("attrs", {}) | data.attrs,
        "coords": coords,
        "order": order,
    }
    if new != before:
        node.update_attributes(new)
    return arrays


def _split(data: xr.Dataset) -> tuple[dict[str, Any], list[str]]:
    """Variables of text (kept as names in attributes: shape and flat list) and names of numeric ones (kept as arrays)."""
    texts: dict[str, Any] = {}
    numeric: list[str] = []
    for name, variable in data.variables.items():
        if variable.dtype.kind in "OUST":
            texts[str(name)] = {"dims": list(variable.dims), "values": np.asarray(variable.values).astype(str).tolist(),
                                "attrs": {k: str(v) for k, v in variable.attrs.items()}}  # fmt: skip
        else:
            numeric.append(str(name))
    return texts, numeric


def _read(path: Path, group: str, committed: int) -> xr.Dataset:
    import xarray as xr

    root = str(path / ARRAYS)
    try:
        data = xr.open_zarr(root, group=group, chunks=None, consolidated=False, zarr_format=3, decode_cf=False)
    except (OSError, KeyError, ValueError) as error:
        raise StoreError(f"{path} has no readable {group!r}: {error}") from error
    names, attrs, coords, order = (data.attrs.pop(key, {}) for key in ("names", "attrs", "coords", "order"))
    if "time" in data.dims:
        data = data.isel(time=slice(0, committed))
    texts = {name: (text["dims"], np.asarray(text["values"]), text["attrs"]) for name, text in names.items()}
    data = data.assign(texts)
    return xr.Dataset({n: data.variables[n] for n in order}, {n: data.variables[n] for n in coords}, attrs)


def _truncate(path: Path, committed: int) -> None:
    """Cut every array with a time axis to the samples that are good."""
    for file in (path / ARRAYS).glob("**/zarr.json"):
        if _is_array(file):
            array = zarr.open_array(str(file.parent), mode="r+", zarr_format=3)
            names = getattr(array.metadata, "dimension_names", None) or ()
            if names[:1] == ("time",):
                array.resize((committed, *array.shape[1:]))
