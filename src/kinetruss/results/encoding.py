"""Datasets as the members of a Zarr archive, version 3, and back.

    GROUP/zarr.json         attributes of a dataset, its variables of text, the order of all variables
    GROUP/NAME/zarr.json    shape, type, axes and attributes of an array
    GROUP/NAME/K.0.0        its chunk K along the first axis; chunks are whole along the others

Arrays along time have their full length from the start, in chunks of a block of samples, so that their description does not
change during a run. The last chunk is filled up. The zarr package takes 5 ms for an array and a block; this takes a tenth.
Source: Zarr core specification, version 3.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any

import numpy as np
from numcodecs.zstd import Zstd

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.results.folder import Ledger

DESCRIPTION = "zarr.json"
LEVEL = -1
"""Level of zstd: less than half the time of its default, files are 5 % larger."""


def encoded(datasets: Mapping[str, xr.Dataset], ledger: Ledger, before: Mapping[str, Any]) -> Iterator[tuple[str, bytes]]:
    """Name and content of every member of some datasets, by group, for the samples behind those that `ledger` counts.

    before : attributes of the groups that exist, by group; the new names are added to theirs.
    """
    yield DESCRIPTION, _group({"kinetruss_run": ledger.kinetruss_run})
    for group, data in datasets.items():
        for parent in reversed(PurePosixPath(group).parents[:-1]):
            yield f"{parent}/{DESCRIPTION}", _group({})
        texts = {str(name): _text(variable) for name, variable in data.variables.items() if variable.dtype.kind in "OUST"}
        yield f"{group}/{DESCRIPTION}", _group(_joined(before.get(group, {}), data, texts))
        for name, variable in data.variables.items():
            if str(name) not in texts:
                yield from _array(f"{group}/{name}", variable, ledger)


def decoded(chunk: bytes, record: Mapping[str, Any]) -> NDArray[Any]:
    """The values of a chunk of an array with the description `record`. Raises ValueError if it is damaged."""
    try:
        values = np.frombuffer(Zstd().decode(chunk), np.dtype(record["data_type"]).newbyteorder("<"))
        return values.reshape(rows_of(record), *record["shape"][1:]) if record["shape"] else values.reshape(())
    except (RuntimeError, ValueError) as error:
        raise ValueError(f"is not what was written ({error})") from error


def rows_of(record: Mapping[str, Any]) -> int:
    """Rows of a chunk of an array with this description."""
    return int(record["chunk_grid"]["configuration"]["chunk_shape"][0]) if record["shape"] else 1


def chunk_name(index: int, dimensions: int) -> str:
    """The name of chunk `index` along the first axis."""
    return ".".join([str(index)] + ["0"] * (dimensions - 1))


def text_of(attributes: Mapping[str, Any]) -> tuple[list[str], NDArray[Any], dict[str, str]]:
    """The axes, values and attributes of a variable of text."""
    values = np.asarray(attributes["values"], dtype=str)
    return attributes["dims"], values.reshape(attributes.get("shape", values.shape)), attributes["attrs"]


def cut(description: bytes, length: int) -> bytes:
    """A description; if it is that of an array along time, of its first `length` entries."""
    record = json.loads(description)
    if along_time(record):
        record["shape"][0] = length
    return json.dumps(record).encode()


def along_time(record: Mapping[str, Any]) -> bool:
    """True for the description of an array with a time axis."""
    return bool(record["node_type"] == "array" and record["dimension_names"][:1] == ["time"])


def _array(place: str, variable: Any, ledger: Ledger) -> Iterator[tuple[str, bytes]]:
    """Description and chunk of an array."""
    values, timed = variable.values, variable.dims[:1] == ("time",)
    shape = (ledger.samples, *values.shape[1:]) if timed else values.shape
    rows = min(ledger.block, ledger.samples) if timed else (*shape, 1)[0]
    yield f"{place}/{DESCRIPTION}", _described(shape, rows, values.dtype, variable.dims, tuple(_plain(variable.attrs).items()))
    if not values.size:
        return
    if timed and len(values) < rows:
        fill = np.nan if values.dtype.kind == "f" else 0
        values = np.concatenate([values, np.full((rows - len(values), *values.shape[1:]), fill, values.dtype)])
    content = np.ascontiguousarray(values, values.dtype.newbyteorder("<"))
    index = ledger.committed // ledger.block if timed else 0
    yield f"{place}/{chunk_name(index, values.ndim)}", Zstd(level=LEVEL, checksum=True).encode(content)


def _group(attributes: Mapping[str, Any]) -> bytes:
    return json.dumps({"zarr_format": 3, "node_type": "group", "attributes": dict(attributes)}).encode()


def _joined(before: Mapping[str, Any], data: xr.Dataset, texts: dict[str, Any]) -> dict[str, Any]:
    """Text, order and attributes of a dataset, merged with those of its group."""
    return {
        "names": before.get("names", {}) | texts,
        "attrs": before.get("attrs", {}) | data.attrs,
        "coords": list(dict.fromkeys([*before.get("coords", []), *map(str, data.coords)])),
        "order": list(dict.fromkeys([*before.get("order", []), *map(str, data.data_vars)])),
    }


@lru_cache(maxsize=1024)
def _described(shape: Sequence[int], rows: int, dtype: Any, dims: Sequence[str], attributes: tuple[Any, ...]) -> bytes:
    """The description of an array; the same for all blocks of a run and for its variants."""
    # single bytes have no byte order
    order = {"configuration": {"endian": "little"}} if dtype.itemsize > 1 else {}
    record = {
        "zarr_format": 3,
        "node_type": "array",
        "shape": list(shape),
        "data_type": dtype.name,
        "chunk_grid": {
            "name": "regular",
            "configuration": {"chunk_shape": [max(1, n) for n in (rows, *shape[1:])] if shape else []},
        },
        "chunk_key_encoding": {"name": "v2", "configuration": {"separator": "."}},
        "fill_value": {"f": "NaN", "b": False}.get(dtype.kind, 0),
        "codecs": [{"name": "bytes", **order}, {"name": "zstd", "configuration": {"level": LEVEL, "checksum": True}}],
        "attributes": dict(attributes),
        "dimension_names": list(dims),
    }
    return json.dumps(record).encode()


def _text(variable: Any) -> dict[str, Any]:
    """A variable of text as an attribute; with its shape, which lists of no entries do not tell."""
    values = variable.values.astype(str)
    attributes = _plain(variable.attrs)
    return {"dims": list(variable.dims), "shape": list(values.shape), "values": values.tolist(), "attrs": attributes}


def _plain(attributes: Mapping[Any, Any]) -> dict[str, str]:
    """Attributes of a variable as text."""
    return {str(key): str(value) for key, value in attributes.items()}
