"""What is in a run folder, read when it is used: a missing or damaged chunk, or another run in its place, is an error.

The arrays are members of an archive; before format 2 they were files in a folder, by the same names.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from xarray.backends import BackendArray
from xarray.core import indexing

from kinetruss.errors import StoreError
from kinetruss.results.archive import Members, content_of, listed, walked
from kinetruss.results.encoding import DESCRIPTION, along_time, chunk_name, decoded, rows_of, text_of
from kinetruss.results.folder import ARCHIVE, ARRAYS, MODEL, Ledger, Stamp, stamp_of


@dataclass(frozen=True, slots=True)
class Content:
    """What a run folder holds.

    stamp : of the model, which identifies a run: it is written once, as the last step of the start, and removed first when
    the run is replaced. members : of the archive; None for files in a folder. nodes : descriptions of groups and arrays.
    """

    path: Path
    stamp: Stamp | None
    members: Members | None
    nodes: Mapping[str, Mapping[str, Any]]

    def __post_init__(self) -> None:
        for name in self.nodes:
            if name and (parent := name.rpartition("/")[0]) not in self.nodes:
                raise ValueError(f"{parent}/{DESCRIPTION} is missing".removeprefix("/"))

    @property
    def groups(self) -> set[str]:
        """Paths of the groups that hold arrays."""
        return {name.rpartition("/")[0] for name, record in self.nodes.items() if record["node_type"] == "array"}

    def read(self, name: str) -> bytes:
        """A member.

        Raises
        ------
        StoreError : it is missing or damaged, or another run has replaced this one.
        """
        try:
            found, what = self._read(name), ""
        except (FileNotFoundError, KeyError):
            what = f"{name} is missing"
        except (OSError, ValueError) as error:
            what = str(error)
        self.check()
        if what:
            raise StoreError(f"{self.path} is damaged: {what}. Run it again with --overwrite.")
        return found

    def check(self) -> None:
        """Raise an error if another run has replaced this one."""
        if stamp_of(self.path / MODEL) != self.stamp:
            raise StoreError(f"{self.path} was replaced by another run while it was read. Read it again.")

    def _read(self, name: str) -> bytes:
        if self.members is None:
            return (self.path / ARRAYS / name).read_bytes()
        member = self.members[name]
        with (self.path / ARCHIVE).open("rb") as file:
            return content_of(file, name, member)


def content(path: Path, ledger: Ledger, stamp: Stamp | None) -> Content:
    """What the folder of a run with this ledger and stamp holds.

    Raises
    ------
    OSError, ValueError : it is missing or damaged.
    """
    if ledger.kinetruss_run == 1 and (root := path / ARRAYS).is_dir():
        members = None
        texts = {file.relative_to(root).as_posix(): file.read_bytes() for file in root.rglob(DESCRIPTION)}
    else:
        with (path / ARCHIVE).open("rb") as file:
            members = listed(file) if ledger.state == "finished" else walked(file, ledger.length)
            texts = {name: content_of(file, name, one) for name, one in members.items() if name.endswith(DESCRIPTION)}
    return Content(path, stamp, members, {name.rpartition("/")[0]: json.loads(text) for name, text in texts.items()})


def dataset(content: Content, group: str, ledger: Ledger) -> xr.Dataset:
    """One dataset, cut to the good samples; arrays are loaded when used.

    For a run that has not ended, only variables with a time axis: the others are known only at the end.

    Raises
    ------
    StoreError : no such group, or not readable.
    """
    if group not in content.nodes:
        raise StoreError(f"{content.path} has no readable {group!r}.")
    attributes = content.nodes[group]["attributes"]
    found: dict[str, xr.Variable] = {}
    for name in (*attributes["coords"], *attributes["order"]):
        if name in attributes["names"]:
            found[name] = xr.Variable(*text_of(attributes["names"][name]))
        elif record := content.nodes.get(f"{group}/{name}"):
            array: Any = indexing.LazilyIndexedArray(_Stored(content, f"{group}/{name}", record, ledger.committed))
            kept = indexing.MemoryCachedArray(indexing.CopyOnWriteArray(array))  # type: ignore[no-untyped-call]
            found[name] = xr.Variable(record["dimension_names"], kept, record["attributes"])
        else:
            raise StoreError(f"{content.path} is damaged: {group}/{name} is missing. Run it again with --overwrite.")
    ended = ledger.state == "finished"
    data = {name: found[name] for name in attributes["order"] if ended or "time" in found[name].dims}
    return xr.Dataset(data, {name: found[name] for name in attributes["coords"]}, attributes["attrs"])


class _Stored(BackendArray):
    """An array of a run, of which xarray reads what it needs."""

    def __init__(self, content: Content, place: str, record: Mapping[str, Any], committed: int) -> None:
        self._content, self._place, self._record = content, place, record
        length = [committed] if along_time(record) else record["shape"][:1]
        self.shape = (*length, *record["shape"][1:])
        self.dtype = np.dtype(record["data_type"])

    def __getitem__(self, key: indexing.ExplicitIndexer) -> Any:
        return indexing.explicit_indexing_adapter(key, self.shape, indexing.IndexingSupport.BASIC, self._values)

    def _values(self, key: Sequence[Any]) -> Any:
        if not self.shape:
            return self._chunk(0)
        if 0 in self.shape[1:]:
            return np.empty(self.shape, self.dtype)[tuple(key)]
        start, stop, step = key[0].indices(self.shape[0]) if isinstance(key[0], slice) else (key[0], key[0] + 1, 1)
        rows = rows_of(self._record)
        before = start // rows * rows
        parts = [self._chunk(index) for index in range(start // rows, -(-stop // rows))]
        found = np.concatenate(parts or [np.empty((0, *self.shape[1:]), self.dtype)])[start - before : stop - before : step]
        return found[(slice(None) if isinstance(key[0], slice) else 0, *key[1:])]

    def _chunk(self, index: int) -> Any:
        name = f"{self._place}/{chunk_name(index, len(self.shape))}"
        try:
            return decoded(self._content.read(name), self._record)
        except ValueError as error:
            path = self._content.path
            raise StoreError(f"{path} is damaged: {name} {error}. Run it again with --overwrite.") from error
