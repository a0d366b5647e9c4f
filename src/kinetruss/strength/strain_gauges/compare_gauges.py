"""Measured strain against simulated."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.io import StrainHistory
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["compare_gauges", "inside"]

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
