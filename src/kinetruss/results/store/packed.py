"""A short run in one file: the same Zarr groups as in a run folder, as a ZIP archive, for many runs at a time.

    OUT/kinetruss.json      ledger
    OUT/model.json          the model
    OUT/results.zarr.zip    Zarr v3 in a ZIP archive (`zarr.storage.ZipStore` reads it), one chunk an array

Some seventy arrays as files of their own take longer to make than to compute. The files are made under other names and get
their own when they are complete: what is there is whole. Arrays are read here without the zarr package, which takes 5 ms for
each.
"""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import StoreError
from kinetruss.results.store.folder import (
    DRAFT,
    FORMAT,
    LEDGER,
    MODEL,
    PACKED,
    Ledger,
    claimed,
    clear,
    failure,
    is_store,
    ledger_text,
)
from kinetruss.results.store.zarr import DESCRIPTION, array_text, chunk_name, group_text
from kinetruss.results.store.zip import archived

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["is_packed", "pack", "packed_groups", "unpacked"]

LEVEL = -5  # of zstd: four times as fast as its default, for a fifth more of a small file


def pack(path: Path, ledger: Ledger, model_text: str, datasets: Mapping[str, xr.Dataset], *, overwrite: bool = False) -> None:
    """Write a whole run at once; with `overwrite`, in place of the run in the folder.

    Raises
    ------
    InputError : see `check_target`.
    StoreError : the folder cannot be written, or another process writes it.
    """
    with claimed(path, overwrite):
        draft = path / DRAFT
        try:
            shutil.rmtree(draft, ignore_errors=True)  # of a process that was killed
            draft.mkdir()
            (draft / PACKED).write_bytes(archived(_members(datasets)))
            (draft / MODEL).write_text(model_text, "utf-8")
            (draft / LEDGER).write_text(ledger_text(ledger), "utf-8")
            if is_store(path):
                clear(path, ledger=False)
            for name in (PACKED, LEDGER, MODEL):  # without its model it is no run yet
                (draft / name).rename(path / name)
        except OSError as error:
            raise StoreError(failure(path, replace(ledger, committed=0), error)) from error
        finally:
            shutil.rmtree(draft, ignore_errors=True)


def is_packed(path: Path) -> bool:
    """True for a run folder whose arrays are in one file."""
    return (path / PACKED).is_file()


def packed_groups(path: Path) -> set[str]:
    """Datasets in the archive: groups that hold arrays.

    Raises
    ------
    StoreError : a damaged archive.
    """
    try:
        with zipfile.ZipFile(path / PACKED) as archive:
            # an array has chunks, and they alone are no descriptions
            chunks = [name for name in archive.namelist() if not name.endswith(DESCRIPTION)]
    except (OSError, zipfile.BadZipFile) as error:
        raise StoreError(f"{path} is damaged: {error}. Run it again with --overwrite.") from error
    return {name.rsplit("/", 2)[0] for name in chunks}


def unpacked(path: Path, group: str) -> xr.Dataset:
    """One dataset of the archive, read as a whole, with the attributes that `open_store` expects on it.

    Raises
    ------
    StoreError : no such group, or a damaged archive.
    """
    import xarray as xr

    try:
        with zipfile.ZipFile(path / PACKED) as archive:
            attributes = json.loads(archive.read(f"{group}/{DESCRIPTION}"))["attributes"]
            names = [*attributes["coords"], *attributes["order"]]
            found = {name: _array(archive, f"{group}/{name}") for name in names if name not in attributes["names"]}
    except (OSError, KeyError, ValueError, zipfile.BadZipFile, RuntimeError) as error:
        raise StoreError(f"{path} has no readable {group!r}: {error}") from error
    return xr.Dataset(attrs=attributes).assign({name: xr.Variable(*one) for name, one in found.items()})


def _members(datasets: Mapping[str, xr.Dataset]) -> Any:
    """Name and content of every file of the archive."""
    yield DESCRIPTION, group_text({"kinetruss_run": FORMAT}).encode()
    parents = {parent.as_posix() for group in datasets for parent in Path(group).parents[:-1]}
    for parent in sorted(parents):
        yield f"{parent}/{DESCRIPTION}", group_text({}).encode()
    for group, data in datasets.items():
        texts: dict[str, Any] = {}
        arrays: dict[str, Any] = {}
        for name, variable in data.variables.items():
            (texts if variable.dtype.kind in "OUST" else arrays)[str(name)] = variable
        yield f"{group}/{DESCRIPTION}", group_text(_attributes(data, texts)).encode()
        for name, variable in arrays.items():
            yield from _array_files(f"{group}/{name}", variable)


def _attributes(data: xr.Dataset, texts: Mapping[str, Any]) -> dict[str, Any]:
    names = {
        name: {"dims": list(one.dims), "values": one.values.astype(str).tolist(), "attrs": _plain(one.attrs)}
        for name, one in texts.items()
    }
    return {"names": names, "attrs": dict(data.attrs), "coords": [*map(str, data.coords)], "order": [*map(str, data.data_vars)]}


def _array_files(place: str, variable: Any) -> Any:
    from numcodecs.zstd import Zstd

    values = np.ascontiguousarray(variable.values, variable.dtype.newbyteorder("<"))
    attributes = tuple(_plain(variable.attrs).items())
    yield f"{place}/{DESCRIPTION}", _description(values.shape, values.dtype, tuple(map(str, variable.dims)), attributes)
    if values.size:
        yield f"{place}/{chunk_name(0, values.ndim)}", Zstd(level=LEVEL, checksum=True).encode(values)


@lru_cache(maxsize=1024)
def _description(shape: tuple[int, ...], dtype: Any, dims: tuple[str, ...], attributes: tuple[tuple[str, str], ...]) -> bytes:
    """The description of an array in one chunk; the same for all variants of a run."""
    rows = max(1, shape[0]) if shape else 1
    return array_text(shape, rows, dtype, dims, dict(attributes), LEVEL).encode()


def _plain(attributes: Mapping[Any, Any]) -> dict[str, str]:
    return {str(key): str(value) for key, value in attributes.items()}


def _array(archive: zipfile.ZipFile, place: str) -> tuple[list[str], Any, dict[str, Any]]:
    """Dimensions, values and attributes of an array."""
    from numcodecs.zstd import Zstd

    record = json.loads(archive.read(f"{place}/{DESCRIPTION}"))
    shape, dtype = record["shape"], np.dtype(record["data_type"]).newbyteorder("<")
    values = np.empty(shape, dtype)
    if values.size:
        packed = archive.read(f"{place}/{chunk_name(0, len(shape))}")
        values = np.frombuffer(Zstd().decode(packed), dtype).reshape(shape)
    return record["dimension_names"], values, record["attributes"]
