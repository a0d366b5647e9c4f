"""Gauge readings, and comparison with measured ones, as text, data, table and picture."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, number
from kinetruss.errors import InputError
from kinetruss.report._page import Page

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

__all__ = ["gauges", "gauges_picture"]

READING = ("gauge", "on", "start", "end", "least", "at", "largest", "at")
COMPARED = ("column", "rows", "offset", "scale", "rms", "scatter", "correlation", "lag", "largest", "at", "error")


def gauges(strains: xr.Dataset, compared: xr.Dataset | None = None) -> Page:
    """Readings of each gauge and group; with a comparison, the difference of a measured record.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["strain_gauges"][0])
    >>> page = kt.report.gauges(kt.runs.gauge_strains(model, "experiment_1"))
    >>> [line.split()[0] for line in page.text.splitlines()[2:]]
    ['G1', 'G2', 'G3', 'M6.axial', 'M6.bending_2', 'M6.bending_3']
    """
    return Page(
        found=strains,
        as_record=partial(_record, compared=compared),
        as_text=partial(_text, compared=compared),
        as_rows=partial(_rows, compared=compared),
    )


def _text(strains: xr.Dataset, compared: xr.Dataset | None = None) -> str:
    """The page as text: readings of each gauge and group; with a comparison, the difference of the measured record."""
    rows = []
    for name, place, values in _curves(strains):
        entry = _extremes(strains["time"].values, values)
        if entry is not None:
            cells = [number(entry[key], 5) for key in ("start", "end", "least")]
            when = [instant(entry[key]) for key in ("least_time", "largest_time")]
            rows.append((name, place, *cells, when[0], number(entry["largest"], 5), when[1]))
    parts = [f"Strain (1e-6), load case {strains.attrs['load_case']}{_zeroed(strains)}\n{Table(READING, rows).text}"]
    if compared is not None:
        rows = [
            (
                name,
                str(compared.sizes["time"]),
                *(number(entry[key], 4) for key in ("offset", "scale", "rms", "scatter", "correlation")),
                instant(entry["shift"]) if math.isfinite(entry["shift"]) else "-",
                number(entry["largest"], 4),
                instant(entry["largest_time"]),
                number(entry["standard_error"], 3) if math.isfinite(entry["standard_error"]) else "-",
            )
            for name, entry in _comparison(compared).items()
        ]
        parts.append(f"Measured minus simulated (1e-6), {compared.attrs['measured']}\n{Table(COMPARED, rows).text}")
    return "\n\n".join(parts)


def _zeroed(strains: xr.Dataset) -> str:
    return ", zeroed" if np.any(strains["zero"].values) else ""


def _curves(strains: xr.Dataset) -> list[tuple[str, str, NDArray[np.float64]]]:
    """Name, place and history of every gauge and part of a group."""
    found = [
        (str(name), str(strains["part"].values[k]), strains["strain"].values[:, k])
        for k, name in enumerate(strains["gauge"].values)
    ]
    if "group_strain" in strains:
        for i, group in enumerate(strains["group"].values):
            for j, component in enumerate(strains["component"].values):
                found.append((f"{group}.{component}", "", strains["group_strain"].values[:, i, j]))
    return found


def _extremes(times: NDArray[np.float64], values: NDArray[np.float64]) -> dict[str, float] | None:
    if not np.isfinite(values).all():
        return None
    low, high = int(values.argmin()), int(values.argmax())
    numbers = {"start": values[0], "end": values[-1], "least": values[low], "largest": values[high]}
    numbers |= {"least_time": times[low], "largest_time": times[high]}
    return {key: float(value) for key, value in numbers.items()}


def _comparison(compared: xr.Dataset) -> dict[str, dict[str, float]]:
    keys = ("offset", "scale", "rms", "scatter", "correlation", "shift", "largest", "largest_time", "standard_error")
    return {
        str(name): {key: float(compared[key].values[k]) for key in keys} for k, name in enumerate(compared["column"].values)
    }


def _record(strains: xr.Dataset, compared: xr.Dataset | None = None) -> dict[str, Any]:
    """The page as plain data, strains in 1e-6."""
    times = strains["time"].values
    readings = {name: _extremes(times, values) for name, _, values in _curves(strains)}
    record: dict[str, Any] = {
        "load_case": strains.attrs["load_case"],
        "samples": len(times),
        "strain": readings,
        "zero": dict(zip(map(str, strains["gauge"].values), strains["zero"].values.tolist(), strict=True)),
        "measured": None,
    }
    if compared is not None:
        columns = {
            name: {key: value if math.isfinite(value) else None for key, value in entry.items()}
            for name, entry in _comparison(compared).items()
        }
        record["measured"] = {"file": compared.attrs["measured"], "rows": compared.sizes["time"], "columns": columns}
    return record


def _rows(strains: xr.Dataset, compared: xr.Dataset | None = None) -> list[list[Any]]:
    """Histories as a table for `io.read_strains`; for a comparison the measured and simulated ones and their difference."""
    if compared is None:
        kept = [(name, values) for name, _, values in _curves(strains) if np.isfinite(values).all()]
        times = strains["time"].values
    else:
        kinds = ("measured", "simulated", "difference")
        kept = [
            (f"{name} {kind}", compared[kind].values[:, k])
            for k, name in enumerate(compared["column"].values)
            for kind in kinds
        ]
        times = compared["time"].values
    head = ["t", *(f"{name} [microstrain]" for name, _ in kept)]
    columns = [times, *(values for _, values in kept)]
    return [head, *(list(map(float, row)) for row in zip(*columns, strict=True))]


def gauges_picture(strains: xr.Dataset, compared: xr.Dataset | None, file: str | Path, title: str = "") -> Path:
    """Draw gauges and groups over time; with a comparison, measured over simulated, and their difference below.

    Raises
    ------
    InputError : not the suffix of a picture. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> model = kt.read(kt.library.example_files()["strain_gauges"][0])
    >>> strains = kt.runs.gauge_strains(model, "experiment_1")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.gauges_picture(strains, None, f"{folder}/gauges.svg").name
    'gauges.svg'
    """
    from kinetruss.report.pictures.draw import SUFFIXES, draw, write
    from kinetruss.report.pictures.specs import Histories, Panel

    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: write to a table, .csv, or a picture, {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    if compared is None:
        lines = {name: values for name, _, values in _curves(strains) if np.isfinite(values).all()}
        panels = [Panel(quantity="strain", unit="1e-6", lines=lines)]
        times = strains["time"].values
    else:
        times = compared["time"].values
        lines, misses = {}, {}
        for k, name in enumerate(map(str, compared["column"].values)):
            lines[f"{name} measured"] = compared["measured"].values[:, k]
            lines[f"{name} simulated"] = compared["simulated"].values[:, k]
            misses[f"{name} difference"] = compared["difference"].values[:, k]
        panels = [Panel(quantity="strain", unit="1e-6", lines=lines)]
        panels.append(Panel(quantity="measured - simulated", unit="1e-6", lines=misses))
    figure = Histories(name="gauges", title=title or "Strain gauges", time=times, panels=tuple(panels))
    write(draw(figure), path)
    return path
