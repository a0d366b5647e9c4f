"""Arrays of a run folder in Zarr version 3, written directly, and files that appear completely or not at all.

The zarr package takes 5 ms per array and block, mostly to pass work between threads; this module takes a tenth of it. A
run has some seventy arrays. Reading is done by zarr. Chunks are whole along every axis but the first.
Source: Zarr core specification, version 3.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numcodecs.zstd import Zstd

from kinetruss.results.folder import atomic
from kinetruss.results.lock import cannot_write

if TYPE_CHECKING:
    from numpy.typing import NDArray


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """A temporary file in the folder of `path`, which is made if needed; at the end it replaces `path`.

    If writing fails, the temporary file is removed and an old file at `path` stays. A pipe or a device is written directly.

    Raises
    ------
    StoreError : the file cannot be written.
    """
    draft = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists() and not (path.is_file() or path.is_dir()):
            yield path
        else:
            yield draft
            draft.replace(path)
    except OSError as error:
        raise cannot_write(path, error) from error
    finally:
        with suppress(OSError):
            draft.unlink(missing_ok=True)


DESCRIPTION = "zarr.json"
LEVEL = 0  # level of zstd, its default: higher levels do not compress floating-point numbers better


def describe_group(folder: Path, attributes: Mapping[str, Any]) -> None:
    """Make a group, or replace its attributes in one step."""
    folder.mkdir(parents=True, exist_ok=True)
    atomic(folder / DESCRIPTION, group_text(attributes), durable=False)


def describe_array(
    folder: Path, shape: Sequence[int], rows: int, dtype: np.dtype[Any], dims: Sequence[str], attributes: Mapping[str, Any]
) -> None:
    """Make an array of `shape` in chunks of `rows` along its first axis."""
    folder.mkdir(parents=True, exist_ok=True)
    atomic(folder / DESCRIPTION, array_text(shape, rows, dtype, dims, attributes), durable=False)


def group_text(attributes: Mapping[str, Any]) -> str:
    """The description of a group."""
    return json.dumps({"zarr_format": 3, "node_type": "group", "attributes": dict(attributes)})


def array_text(
    shape: Sequence[int],
    rows: int,
    dtype: np.dtype[Any],
    dims: Sequence[str],
    attributes: Mapping[str, Any],
    level: int = LEVEL,
) -> str:
    """The description of an array of `shape` in chunks of `rows` along its first axis."""
    # single bytes have no byte order
    order = {"configuration": {"endian": "little"}} if dtype.itemsize > 1 else {}
    record = {
        "zarr_format": 3,
        "node_type": "array",
        "shape": list(shape),
        "data_type": dtype.name,
        "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": _chunk(shape, rows)}},
        "chunk_key_encoding": {"name": "v2", "configuration": {"separator": "."}},
        "fill_value": {"f": "NaN", "b": False}.get(dtype.kind, 0),
        "codecs": [{"name": "bytes", **order}, {"name": "zstd", "configuration": {"level": level, "checksum": True}}],
        "attributes": dict(attributes),
        "dimension_names": list(dims),
    }
    return json.dumps(record)


def write_chunk(folder: Path, index: int, values: NDArray[Any], rows: int) -> None:
    """Write chunk `index` along the first axis; the last one is padded to its full number of rows.

    The file gets its name only when it is complete: others may be reading the run, and arrays without a time axis are
    rewritten with every block.
    """
    if not values.size:
        return
    if values.ndim and len(values) < rows:
        fill = np.nan if values.dtype.kind == "f" else 0
        values = np.concatenate([values, np.full((rows - len(values), *values.shape[1:]), fill, values.dtype)])
    draft = folder / "chunk.part"
    draft.write_bytes(encoded(values))
    draft.replace(folder / chunk_name(index, values.ndim))


def encoded(values: NDArray[Any], level: int = LEVEL) -> bytes:
    """The content of a chunk, with its checksum."""
    found: bytes = Zstd(level=level, checksum=True).encode(np.ascontiguousarray(values, values.dtype.newbyteorder("<")))
    return found


def is_text(variable: Any) -> bool:
    """True if a variable of a dataset holds names: these are stored in the attributes of its group."""
    return variable.dtype.kind in "OUST"


def text_of(variable: Any) -> dict[str, Any]:
    """A variable of names as an attribute; with its shape, which lists of no entries do not tell."""
    values = variable.values.astype(str)
    return {
        "dims": list(variable.dims),
        "shape": list(values.shape),
        "values": values.tolist(),
        "attrs": plain(variable.attrs),
    }


def names_of(text: Mapping[str, Any]) -> tuple[list[str], NDArray[Any], dict[str, str]]:
    """The variable of `text_of`: its axes, values and attributes."""
    values = np.asarray(text["values"], dtype=str)
    return text["dims"], values.reshape(text.get("shape", values.shape)), text["attrs"]


def plain(attributes: Mapping[Any, Any]) -> dict[str, str]:
    """Attributes of a variable as text."""
    return {str(key): str(value) for key, value in attributes.items()}


def chunk_name(index: int, dimensions: int) -> str:
    """The file of chunk `index` along the first axis."""
    return ".".join([str(index)] + ["0"] * (dimensions - 1))


def resize(description: Path, length: int) -> None:
    """Cut an array with a time axis to its first `length` entries."""
    record = json.loads(description.read_text("utf-8"))
    if record["node_type"] == "array" and record["dimension_names"][:1] == ["time"]:
        record["shape"][0] = length
        atomic(description, json.dumps(record), durable=False)


def is_array(description: Path) -> bool:
    """True for the description of an array, False for that of a group."""
    return bool(json.loads(description.read_text("utf-8"))["node_type"] == "array")


def _chunk(shape: Sequence[int], rows: int) -> list[int]:
    return [max(1, n) for n in (rows, *shape[1:])] if shape else []
