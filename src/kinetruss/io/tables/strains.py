"""Measured strain histories."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import Fault, ModelError
from kinetruss.io.formats.text import MAX_SIZE
from kinetruss.io.tables.table import Table, read_table
from kinetruss.model import Model, nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["StrainHistory", "read_strains", "strain_columns"]

LARGEST = 0.1
"""Largest strain in a measured table; for a larger one the unit must be missing."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class StrainHistory:
    """A measured record: times (n_times,) s, columns by name (n_times,) in 1e-6, the file, and the line of each row.

    errors : standard error of every value, NaN where there is one reading only. volts : columns that are still voltages, V.
    """

    times: NDArray[np.float64]
    columns: dict[str, NDArray[np.float64]]
    source: str
    lines: tuple[int, ...]
    errors: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    volts: tuple[str, ...] = ()


def strain_columns(model: Model) -> list[str]:
    """Names a column may have: gauges, and GROUP.axial, GROUP.bending_2, GROUP.bending_3."""
    groups = dict.fromkeys(gauge.group for gauge in model.gauges.values() if gauge.group is not None)
    bending = ("bending_3",) if model.dim == 2 else ("bending_2", "bending_3")
    return [*model.gauges, *(f"{group}.{part}" for group in groups for part in ("axial", *bending))]


def read_strains(path: str | Path, model: Model, *, max_size: int = MAX_SIZE) -> StrainHistory:
    """Read a measured strain record.

    Parameters
    ----------
    path : CSV: ``t``, then a column per gauge or part of a group, e.g. ``G1 [microstrain]``, ``M6.axial [microstrain]``; a
    column without unit is strain in m/m. Readings of a gauge may be volts, ``G1 [mV]``: `strength.measured_strains` turns them
    into strain. Rows of the same time are averaged. max_size : bytes; a larger file is not read.

    Raises
    ------
    ModelError : all faults of the table, each with file, line and column: unknown columns, cells that are not a number,
    time that decreases, numbers too large to be strain.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model, record = kt.library.example_files()["strain_gauges"][:2]
    >>> history = kt.io.read_strains(record, kt.read(model))
    >>> list(history.columns), float(history.columns["M6.axial"][0])  # 1e-6
    (['M6.axial'], 4.07)
    """
    known = strain_columns(model)
    try:
        table = read_table(Path(path), lambda _: ("strain", "voltage"), max_size=max_size, repeats=True)
    except ModelError as error:
        raise ModelError([replace(fault, path=("measured",)) for fault in error.faults]) from None
    volts = tuple(name for name, one in table.columns.items() if one.quantity == "voltage")
    faults = [
        table.fault(f"column {name!r} is not a gauge or group of the model.", nearest(name, known), column=one.at)
        for name, one in table.columns.items()
        if name not in known
    ]
    if not table.columns:
        faults.append(table.fault("has no column but t.", f"Give one of: {', '.join(known) or 'no gauge in the model'}."))
    faults += [
        _too_large(table, name)
        for name, one in table.columns.items()
        if name not in volts and np.abs(one.values).max() > LARGEST
    ]
    if faults:
        raise ModelError([replace(fault, path=("measured",)) for fault in faults])
    times, first, which, count = np.unique(table.times, return_index=True, return_inverse=True, return_counts=True)
    columns, errors = {}, {}
    for name, one in table.columns.items():
        values = one.values if name in volts else 1e6 * one.values
        mean = np.bincount(which, values) / count
        spread = np.bincount(which, (values - mean[which]) ** 2)
        columns[name] = mean
        errors[name] = np.where(count > 1, np.sqrt(spread / np.maximum(count - 1, 1) / count), np.nan)
    lines = tuple(table.lines[int(k)] for k in first)
    return StrainHistory(times=times, columns=columns, errors=errors, source=str(path), lines=lines, volts=volts)


def _too_large(table: Table, name: str) -> Fault:
    column = table.columns[name]
    row = int(np.argmax(np.abs(column.values) > LARGEST))
    message = f"column {name!r} holds a strain of {column.values[row]:g} m/m."
    return table.fault(message, f"Give the unit in the header: {name} [microstrain].", table.lines[row], 1)
