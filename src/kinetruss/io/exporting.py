"""A stored run as CSV, Parquet or netCDF."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.errors import InputError, StoreError
from kinetruss.results.folder import whole_file
from kinetruss.results.store import Store, open_store
from kinetruss.results.wide_tables import flat, labels, units_of

if TYPE_CHECKING:
    import xarray as xr


BATCH = 1000
"""Number of samples read at a time."""


def export(
    out: str | Path, file: str | Path, *, groups: Sequence[str] = (), more: Mapping[str, xr.Dataset] | None = None
) -> Path:
    """Write the good samples of a run to one file; the suffix chooses the format.

    Parameters
    ----------
    out : run folder. file : ``.csv``: one row per instant, one column per value, ``group.quantity[names] (unit)``, or
    with ``groups=("verdict",)`` one row per entry; ``.parquet``: one row per value; ``.nc``: netCDF, all arrays with units.
    groups : only datasets whose path begins with one of these, e.g. ``motion``, ``forces``, ``forces/hanging/total``.
    more : further datasets over the same samples, by path, e.g. the quantities of a run.

    Returns
    -------
    The path written. It appears only when it is complete.

    Raises
    ------
    InputError : an unknown suffix or group, or a package of the extra ``export`` that is not installed.
    StoreError : the run cannot be read or the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = kt.run(model, out=Path(folder, "run"))
    ...     file = kt.io.export(Path(folder, "run"), Path(folder, "run.csv"), groups=["motion"])
    ...     rows = file.read_text().splitlines()
    >>> len(rows), rows[0].split(",")[0]  # a head and 361 instants
    (362, 'time (s)')
    """
    path = Path(file)
    writers: dict[str, Callable[[Store, list[str], Path, Mapping[str, xr.Dataset]], None]] = {
        ".csv": _csv,
        ".parquet": _parquet,
        ".nc": _netcdf,
    }
    if path.suffix not in writers:
        raise InputError(f"{path}: a run is exported to {', '.join(writers)}. Choose one of these endings.")
    store = open_store(Path(out))
    if not store.groups or not store.ledger.committed:
        raise StoreError(f"{store.path} has no good sample to export.")
    known = [*store.groups, *(more or {})]
    for wanted in groups:
        if not any(_within(name, wanted) for name in known):
            raise InputError(f"{store.path} has no {wanted!r}. It has: {', '.join(known)}.")
    chosen = [name for name in known if not groups or any(_within(name, wanted) for wanted in groups)]
    with whole_file(path) as draft:
        writers[path.suffix](store, chosen, draft, more or {})
    return path


def _within(name: str, wanted: str) -> bool:
    return name == wanted or name.startswith(wanted.rstrip("/") + "/")


def needed(package: str, extra: str = "export", what: str = "This format") -> Any:
    """Import a package of an extra; InputError with the install command if it is missing."""
    import importlib

    try:
        return importlib.import_module(package)
    except ImportError:
        raise InputError(f"{what} needs the package {package}. Install it: pip install 'kinetruss[{extra}]'") from None


def _read(store: Store, name: str, more: Mapping[str, xr.Dataset]) -> xr.Dataset:
    return more[name].copy() if name in more else store.read(name)


def _netcdf(store: Store, groups: list[str], path: Path, more: Mapping[str, xr.Dataset]) -> None:
    needed("netCDF4")
    mode: Literal["w", "a"] = "w"
    for group in groups:
        data = _read(store, group, more).load()
        data.attrs |= _state(store)
        for variable in data.variables.values():
            if variable.dtype.kind == "b":  # netCDF has no Boolean type
                variable.values = variable.values.astype("i1")
        try:
            data.to_netcdf(path, mode=mode, group=group, engine="netcdf4")
        except RuntimeError as error:  # error of the netCDF library if the disk is full
            raise OSError(str(error)) from error
        mode = "a"


def _state(store: Store) -> dict[str, Any]:
    """Attributes for readers of the file: the status of a run that is not complete."""
    ledger = store.ledger
    state = "finished" if ledger.state == "finished" else "unfinished"
    return {"state": state, "samples_good": ledger.committed, "samples_asked": ledger.samples}


def _csv(store: Store, groups: list[str], path: Path, more: Mapping[str, xr.Dataset]) -> None:
    if groups == ["verdict"]:
        _entries(store.read("verdict"), path)
        return
    histories = {name: data for name in groups if "time" in (data := _read(store, name, more)).dims}
    if not histories:
        raise InputError("Nothing along time was chosen; a CSV has one row per instant. For the table: groups=('verdict',).")
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        columns = [(name, str(key)) for name, data in histories.items() for key in data.data_vars if _timed(data[key])]
        start = next(iter(histories.values()))
        when, head = ("pose", "pose") if "pose" in start.coords else ("time", "time (s)")
        rows.writerow([head, *(one for name, key in columns for one in _heads(name, histories[name][key]))])
        for first in range(0, store.ledger.committed, BATCH):
            part = slice(first, first + BATCH)
            values = [flat(histories[name][key].isel(time=part)) for name, key in columns]
            # tolist gives Python floats, written with as many digits as it takes to read them back exactly
            moments = start[when].isel(time=part).values.tolist()
            rows.writerows([at, *row] for at, row in zip(moments, np.hstack(values).tolist(), strict=True))


def _timed(data: xr.DataArray) -> bool:
    return bool(data.dims[:1] == ("time",))


def _heads(group: str, data: xr.DataArray) -> Iterator[str]:
    for names, unit in zip(labels(data), units_of(data), strict=True):
        inside = f"[{','.join(names)}]" if names else ""
        yield f"{group.replace('/', '.')}.{data.name}{inside}{f' ({unit})' if unit else ''}"


def _entries(data: xr.Dataset, path: Path) -> None:
    """A table over (part, rule), one row per entry."""
    keys = [str(name) for name, one in data.data_vars.items() if one.dims == ("part", "rule")]
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["part", "rule", "unit", *keys])
        for i, part in enumerate(data["part"].values):
            for j, rule in enumerate(data["rule"].values):
                rows.writerow([part, rule, data["unit"].values[j], *(data[key].values[i, j] for key in keys)])


def _parquet(store: Store, groups: list[str], path: Path, more: Mapping[str, xr.Dataset]) -> None:
    arrow, parquet = needed("pyarrow"), needed("pyarrow.parquet")
    word = arrow.dictionary(arrow.int32(), arrow.string())
    schema = arrow.schema(
        [
            ("group", word),
            ("quantity", word),
            ("unit", word),
            ("names", word),
            ("time", arrow.float64()),
            ("value", arrow.float64()),
        ]
    )
    with parquet.ParquetWriter(path, schema, compression="zstd") as writer:
        for name in groups:
            data = _read(store, name, more)
            for key in data.data_vars:
                if _timed(data[key]):
                    for first in range(0, store.ledger.committed, BATCH):
                        writer.write_table(_long(arrow, schema, name, data[key].isel(time=slice(first, first + BATCH))))


def _long(arrow: Any, schema: Any, group: str, data: xr.DataArray) -> Any:
    names = [",".join(found) for found in labels(data)]
    count, own = data.sizes["time"], list(units_of(data))
    units = list(dict.fromkeys(own)) or [""]
    places = [units.index(unit) for unit in own]
    whole = count * len(names)

    def constant(text: str) -> Any:
        return arrow.DictionaryArray.from_arrays(np.zeros(whole, np.int32), arrow.array([text]))

    columns = [
        constant(group),
        constant(str(data.name)),
        arrow.DictionaryArray.from_arrays(np.tile(np.array(places, np.int32), count), arrow.array(units)),
        arrow.DictionaryArray.from_arrays(np.tile(np.arange(len(names), dtype=np.int32), count), arrow.array(names)),
        np.repeat(data["time"].values, len(names)),
        data.values.reshape(-1).astype(float),
    ]
    return arrow.table(columns, schema=schema)
