"""Measured strain: voltages turned into strain, and repeated records averaged."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.io import MAX_SIZE, StrainHistory, read_strains
from kinetruss.strength.strain_gauges.bridge import bridge_strain

if TYPE_CHECKING:
    from kinetruss.model import Model

__all__ = ["measured_strains"]


def measured_strains(model: Model, paths: str | Path | Iterable[str | Path], *, max_size: int = MAX_SIZE) -> StrainHistory:
    """The mean of one or more records of strain or voltage, as strain.

    Parameters
    ----------
    paths : files as for `io.read_strains`; several are repetitions of one experiment. Columns in volts belong to gauges with
        a `bridge`.

    Returns
    -------
    StrainHistory in 1e-6, at the times of the first record that all records reach; ``errors``: standard errors, of several
    records from their scatter, of one from that of the readings repeated at one time (NaN for single readings).

    Raises
    ------
    ModelError : faults of the tables; a voltage of a gauge without a bridge. InputError : records of other columns, or that
        share no time.

    Examples
    --------
    >>> import kinetruss as kt
    >>> files = kt.library.example_files()["strain_gauges"]
    >>> record = kt.strength.measured_strains(kt.read(files[0]), files[1])
    >>> len(record.times), list(record.columns)
    (110, ['M6.axial'])
    """
    files = [paths] if isinstance(paths, str | Path) else list(paths)
    if not files:
        raise InputError("No record is named. Give at least one file.")
    records = [_in_strain(model, read_strains(path, model, max_size=max_size)) for path in files]
    if len(records) == 1:
        return records[0]
    first = records[0]
    for one in records[1:]:
        if set(one.columns) != set(first.columns):
            odd = ", ".join(sorted(set(one.columns) ^ set(first.columns)))
            raise InputError(f"{one.source} has other columns than {first.source}: {odd}. Give repetitions of one experiment.")
    start, end = (pick(choose(one.times) for one in records) for pick, choose in ((max, np.min), (min, np.max)))
    kept = (first.times >= start - 1e-9) & (first.times <= end + 1e-9)
    if kept.sum() < 2:
        raise InputError(f"{', '.join(str(one.source) for one in records)} share no time. Start their clocks together.")
    times = first.times[kept]
    columns, errors = {}, {}
    for name in first.columns:
        values = np.stack([np.interp(times, one.times, one.columns[name]) for one in records])
        columns[name] = values.mean(axis=0)
        errors[name] = values.std(axis=0, ddof=1) / np.sqrt(len(records))
    lines = tuple(line for line, keep in zip(first.lines, kept, strict=True) if keep)
    source = f"mean of {', '.join(one.source for one in records)}"
    return StrainHistory(times=times, columns=columns, errors=errors, source=source, lines=lines)


def _in_strain(model: Model, record: StrainHistory) -> StrainHistory:
    """A record with its voltages turned into strain."""
    columns, errors, faults = dict(record.columns), dict(record.errors), []
    for name in record.volts:
        gauge = model.gauges.get(name)
        if gauge is None or gauge.bridge is None:
            mend = (
                f"Give it a bridge, e.g. gauges: {{{name}: {{bridge: {{kind: quarter, excitation: 5 V}}}}}}, or give strains."
            )
            message = f"column {name!r} is a voltage, but the gauge has no bridge."
            faults.append(Fault(("measured",), message, mend, record.lines[0], 1, file=record.source))
            continue
        volts = columns[name]
        columns[name] = 1e6 * bridge_strain(volts, gauge.bridge, gauge.factor, record.times)
        moved = 1e6 * bridge_strain(volts + np.nan_to_num(errors[name]), gauge.bridge, gauge.factor, record.times)
        errors[name] = np.where(np.isnan(errors[name]), np.nan, np.abs(moved - columns[name]))
    if faults:
        raise ModelError(faults)
    return replace(record, columns=columns, errors=errors, volts=())
