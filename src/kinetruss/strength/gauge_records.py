"""Measured strain: voltages of bridges, repeated records, and comparison with simulated strain."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.io import MAX_SIZE, StrainHistory, read_strains
from kinetruss.model import Bridge
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.model import Model


Floats = Any


def _arms(bridge: Bridge) -> tuple[float, float, float, float]:
    """Strain of the four arms over that of the first; arms 1 and 3 are opposite."""
    nu = bridge.poisson
    return {
        "quarter": (1.0, 0.0, 0.0, 0.0),
        "half_bending": (1.0, -1.0, 0.0, 0.0),
        "half_axial": (1.0, -nu, 0.0, 0.0),
        "half_opposite": (1.0, 0.0, 1.0, 0.0),
        "half_dummy": (1.0, 0.0, 0.0, 0.0),
        "full_bending": (1.0, -1.0, 1.0, -1.0),
        "full_axial": (1.0, -nu, 1.0, -nu),
    }[bridge.kind]


def _gauged(bridge: Bridge) -> tuple[float, float, float, float]:
    """1 for arms that are gauges, which all have the same temperature; 0 for resistors."""
    if bridge.kind == "half_dummy":
        return 1.0, 1.0, 0.0, 0.0
    one, two, three, four = (float(arm != 0) for arm in _arms(bridge))
    return one, two, three, four


def bridge_output(strain: ArrayLike, bridge: Bridge, factor: float, thermal: ArrayLike = 0.0) -> NDArray[np.float64]:
    """Output over excitation, V/V, at a strain (m/m): R1/(R1 + R2) - R4/(R3 + R4) with R_i = R (1 + k (a_i e + b_i t)).

    k is the gauge factor, less the share of the leads, R/(R + R_lead); of a ``linear`` bridge the first-order part. t is the
    `thermal` strain (m/m) that every gauge of the bridge reads besides; b_i is 1 for gauges, 0 for resistors.

    >>> import kinetruss as kt
    >>> quarter = kt.Bridge(kind="quarter", excitation=5.0, linear=True)
    >>> kt.strength.bridge_output(1e-3, quarter, factor=2.0).round(9).item()  # V/V: k e/4
    0.0005
    """
    x, y = (_seen(bridge, factor) * np.asarray(one, float) for one in (strain, thermal))
    a, b, c, d = (arm * x + gauge * y for arm, gauge in zip(_arms(bridge), _gauged(bridge), strict=True))
    if bridge.linear:
        return np.asarray((a - b + c - d) / 4)
    return np.asarray((1 + a) / (2 + a + b) - (1 + d) / (2 + c + d))


def bridge_reading(strain: ArrayLike, thermal: ArrayLike, bridge: Bridge, factor: float) -> NDArray[np.float64]:
    """The strain (m/m) that the output of a bridge stands for where all its gauges read a thermal strain (m/m) besides.

    >>> import kinetruss as kt
    >>> for kind in ("quarter", "half_opposite", "half_dummy", "full_bending"):
    ...     print(kind, kt.strength.bridge_reading(1e-3, 2e-4, kt.Bridge(kind=kind, excitation=5.0, linear=True), 2.0).round(9))
    quarter 0.0012
    half_opposite 0.0012
    half_dummy 0.001
    full_bending 0.001
    """
    output = bridge_output(strain, bridge, factor, thermal)
    return _solved(bridge.gain * bridge.excitation * output, bridge, factor)


def bridge_strain(volts: ArrayLike, bridge: Bridge, factor: float, times: ArrayLike | None = None) -> NDArray[np.float64]:
    """Strain (m/m) of readings (n,) V of a bridge; the inverse of `bridge_output`.

    Parameters
    ----------
    volts : readings, amplified by ``bridge.gain``. times : (n,) s, for a zero that drifts from ``zero`` at the first to
        ``zero_end`` at the last. factor : gauge factor.

    Raises
    ------
    InputError : a drift without times; a reading that no strain gives.

    Notes
    -----
    r = (V - zero)/(gain excitation). With x = k e and the arms a..d, r is a quotient of quadratics in x, solved for the root
    that is 0 with r. With a shunt, all readings are first scaled by what it should read over what it reads; it is across one
    arm, so that is the output of a quarter bridge. Source: Window, Strain Gauge Technology (1992); Hoffmann, An Introduction
    to Stress Analysis and Transducer Design (1989).

    Examples
    --------
    >>> import kinetruss as kt
    >>> full = kt.Bridge(kind="full_bending", excitation=5.0, gain=100.0)
    >>> volts = kt.strength.bridge_output(1e-3, full, factor=2.0) * full.excitation * full.gain
    >>> kt.strength.bridge_strain([volts], full, factor=2.0).round(9).tolist()  # m/m
    [0.001]
    """
    readings = np.asarray(volts, float)
    zero: Floats = bridge.zero
    if bridge.zero_end is not None:
        if times is None:
            raise InputError("The bridge has zero_end, a drifting zero: give the times of the readings.")
        t = np.asarray(times, float)
        zero = bridge.zero + (bridge.zero_end - bridge.zero) * (t - t[0]) / (t[-1] - t[0])
    readings = readings - zero
    if bridge.shunt is not None and bridge.shunt_reading is not None:
        # the resistor changes one arm, whatever the others carry
        alone = bridge.with_(kind="quarter")
        stands_for = shunt_strain(bridge.resistance or 0.0, bridge.shunt, factor)
        expected = bridge.gain * bridge.excitation * float(bridge_output(stands_for, alone, factor))
        readings = readings * (expected / bridge.shunt_reading)
    return _solved(readings, bridge, factor)


def shunt_strain(resistance: float, shunt: float, factor: float) -> float:
    """Strain (m/m, negative) that a resistor across an arm stands for: -R/(k (R + R_shunt)), both in ohm.

    >>> import kinetruss as kt
    >>> round(kt.strength.shunt_strain(120.0, 59880.0, 2.0), 9)  # m/m: -120/(2 * 60000)
    -0.001
    """
    return -resistance / (factor * (resistance + shunt))


def _seen(bridge: Bridge, factor: float) -> float:
    """Gauge factor of the arm with its lead."""
    return factor if bridge.resistance is None else factor * bridge.resistance / (bridge.resistance + bridge.lead)


def _solved(volts: Floats, bridge: Bridge, factor: float) -> NDArray[np.float64]:
    a, b, c, d = _arms(bridge)
    r = np.asarray(volts, float) / (bridge.gain * bridge.excitation)
    slope, k = a - b + c - d, _seen(bridge, factor)
    if bridge.linear:
        return np.asarray(4 * r / (slope * k))
    # (a c - b d) x^2 + slope x = r (2 + (a + b) x)(2 + (c + d) x)
    second = (a * c - b * d) - r * (a + b) * (c + d)
    first = slope - 2 * r * (a + b + c + d)
    inside = first**2 + 16 * r * second
    if np.any(inside < 0) or np.any(first <= 0):
        worst = float(np.abs(r).max())
        raise InputError(f"A reading of {worst:.3g} V/V is no strain of this bridge. Check excitation, gain and kind.")
    return np.asarray(8 * r / (first + np.sqrt(inside)) / k)


# Measured strain: voltages turned into strain, and repeated records averaged.


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


# Measured strain against simulated.

LEAST_SHARE = 0.3
"""Smallest part of the rate of a history that is neither constant nor like it: with less, a lag looks like an offset."""

_SUMMARY = {
    "offset": "mean of measured minus simulated",
    "rms": "root mean square of measured minus simulated",
    "scatter": "root mean square about the offset",
    "largest": "largest difference of measured minus simulated",
}


def compare_gauges(strains: xr.Dataset, measured: StrainHistory) -> xr.Dataset:
    """Compare a measured record with the simulated gauge readings.

    Parameters
    ----------
    strains : from `gauges`, best at the measured times; between other samples a cubic spline is laid. measured : from
        `io.read_strains`.

    Returns
    -------
    Dataset. ``measured``, ``simulated``, ``difference`` (time, column), 1e-6; ``offset``, ``rms``, ``scatter`` (rms about the
    offset), ``largest`` (column), 1e-6; ``scale``: slope of measured over simulated, ``correlation`` (column), ``shift`` s: the
    time by which the measured record lags, that of the best fit, NaN where offset and scale do as much; ``largest_time`` s;
    ``standard_error`` (column), 1e-6: of the means in the record, NaN for single readings.

    Raises
    ------
    ModelError : measured times outside the simulated ones, each with file and line. InputError : columns in volts.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model_file, *_ = files = kt.library.example_files()["strain_gauges"]
    >>> model = kt.read(model_file)
    >>> record = kt.io.read_strains(files[1], model)
    >>> strains = kt.runs.gauge_strains(model, "experiment_1", measured=record)
    >>> kt.strength.compare_gauges(strains, record).offset.sel(column="M6.axial").round(1).item()  # 1e-6
    -0.5
    """
    times = strains["time"].values
    inside(measured, float(times[0]), float(times[-1]))
    if measured.volts:
        raise InputError(f"{measured.source} is in volts. Read it by strength.measured_strains(model, file).")
    there = np.stack(list(measured.columns.values()), axis=1)
    here = np.stack([_at(times, _column(strains, name), measured.times) for name in measured.columns], axis=1)
    difference = there - here
    offset = difference.mean(axis=0)
    at = np.abs(difference).argmax(axis=0)
    summary = {
        "offset": offset,
        "rms": np.sqrt((difference**2).mean(axis=0)),
        "scatter": difference.std(axis=0),
        "largest": np.take_along_axis(difference, at[None], axis=0)[0],
    }
    history = {"measured": there, "simulated": here, "difference": difference}
    per = ("time", "column")
    data = {name: variable(per, values, "1e-6", f"{name} strain") for name, values in history.items()}
    data |= {name: variable(("column",), values, "1e-6", _SUMMARY[name]) for name, values in summary.items()}
    data["correlation"] = variable(("column",), _correlation(there, here), "", "correlation of measured and simulated")
    data["scale"] = variable(("column",), _scale(there, here), "", "slope of measured over simulated")
    shift = np.array([_shift(times, _column(strains, name), measured.times, one) for name, one in measured.columns.items()])
    data["shift"] = variable(("column",), shift, "s", "time by which the measured record lags")
    errors = [measured.errors.get(name, np.full(len(measured.times), np.nan)) for name in measured.columns]
    mean = [float(np.sqrt(np.nanmean(one**2))) if np.isfinite(one).any() else np.nan for one in errors]
    data["standard_error"] = variable(("column",), np.array(mean), "1e-6", "standard error of a measured mean")
    data["largest_time"] = variable(("column",), measured.times[at], "s", "time of the largest difference")
    time = variable(("time",), measured.times, "s", "time")
    return xr.Dataset(
        data,
        coords={"time": time, "column": list(measured.columns)},
        attrs={"kind": "gauge_comparison", "load_case": strains.attrs["load_case"], "measured": measured.source},
    )


def inside(measured: StrainHistory, first: float, last: float) -> None:
    """ModelError with the rows of a record that lie outside first to last, s; InputError for what is no record."""
    if not isinstance(measured, StrainHistory):
        raise InputError(
            f"measured: {type(measured).__name__}, expected a record. Read it by strength.measured_strains(model, file)."
        )
    slack = 1e-9 * max(abs(last - first), 1e-9)
    outside = np.flatnonzero((measured.times < first - slack) | (measured.times > last + slack))
    if not len(outside):
        return
    row = outside[0]
    also = f" and {len(outside) - 1} more rows are" if len(outside) > 1 else " is"
    message = f"t = {measured.times[row]:g} s{also} outside the run, {first:g} s to {last:g} s."
    mend = "Start the record's clock with the run, or cut the rows outside."
    raise ModelError([Fault(("measured",), message, mend, measured.lines[row], 1, file=measured.source)])


def _column(strains: xr.Dataset, name: str) -> NDArray[np.float64]:
    """Simulated history of a gauge, or of GROUP.axial, GROUP.bending_2, GROUP.bending_3."""
    if name in strains["gauge"].values:
        return np.asarray(strains["strain"].sel(gauge=name).values)
    group, _, component = name.rpartition(".")
    return np.asarray(strains["group_strain"].sel(group=group, component=component).values)


def _at(times: NDArray[np.float64], values: NDArray[np.float64], wanted: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values at the given times: those of samples at these times, else of a cubic spline."""
    near = np.abs(times[:, None] - wanted).argmin(axis=0)
    if np.allclose(times[near], wanted, rtol=0, atol=1e-9 * max(float(np.ptp(times)), 1e-9)):
        return np.asarray(values[near])
    wanted = np.clip(wanted, times[0], times[-1])
    from scipy.interpolate import make_interp_spline

    return np.asarray(make_interp_spline(times, values, k=min(3, len(times) - 1))(wanted))


def _correlation(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    a, b = one - one.mean(axis=0), other - other.mean(axis=0)
    size = np.sqrt((a**2).sum(axis=0) * (b**2).sum(axis=0))
    flat = (np.ptp(one, axis=0) < 1e-9 * np.abs(one).max(axis=0)) | (np.ptp(other, axis=0) < 1e-9 * np.abs(other).max(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.where(flat, np.nan, (a * b).sum(axis=0) / size))


def _scale(measured: NDArray[np.float64], simulated: NDArray[np.float64]) -> NDArray[np.float64]:
    """Slope of the line of least squares, measured over simulated."""
    a, b = measured - measured.mean(axis=0), simulated - simulated.mean(axis=0)
    flat = np.ptp(simulated, axis=0) < 1e-9 * np.abs(simulated).max(axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.where(flat, np.nan, (a * b).sum(axis=0) / (b * b).sum(axis=0)))


def _shift(
    times: NDArray[np.float64], simulated: NDArray[np.float64], rows: NDArray[np.float64], measured: NDArray[np.float64]
) -> float:
    """The lag of a measured history, s, within a tenth of its length: that with which offset + scale x simulated fits best;
    NaN if these do not determine it.
    """
    from scipy.interpolate import make_interp_spline
    from scipy.optimize import minimize_scalar

    span = 0.1 * float(np.ptp(rows))
    inner = (rows >= times[0] + span) & (rows <= times[-1] - span)
    if (
        inner.sum() < 5
        or np.ptp(simulated) < 1e-9 * np.abs(simulated).max()
        or np.ptp(measured) < 1e-9 * np.abs(measured).max()
    ):
        return float("nan")
    curve, y = make_interp_spline(times, simulated, k=min(3, len(times) - 1)), measured[inner]

    def misfit(lag: float) -> float:
        here = curve(rows[inner] - lag)
        design = np.stack([np.ones(len(here)), here], axis=1)
        return float(((y - design @ np.linalg.lstsq(design, y, rcond=None)[0]) ** 2).sum())

    grid = np.linspace(-span, span, 41)
    k = int(np.argmin([misfit(lag) for lag in grid]))
    here, slope = curve(rows[inner] - grid[k]), curve(rows[inner] - grid[k], 1)
    design = np.stack([np.ones(len(here)), here], axis=1)
    rest = slope - design @ np.linalg.lstsq(design, slope, rcond=None)[0]
    if np.linalg.norm(rest) < LEAST_SHARE * np.linalg.norm(slope):
        return float("nan")
    bounds = (grid[max(k - 1, 0)], grid[min(k + 1, 40)])
    return float(minimize_scalar(misfit, bounds=bounds, method="bounded", options={"xatol": 1e-6 * span}).x)
