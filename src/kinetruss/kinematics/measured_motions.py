"""Measured records of drives or pose coordinates: outliers, smoothing, noise and standard errors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr

from kinetruss.display import number
from kinetruss.errors import InputError, few, shown
from kinetruss.kinematics.smoothing import LEAST_ROWS, Smooth, savitzky_golay, smoothing_spline
from kinetruss.mechanics import ByIdentity
from kinetruss.model import Measured
from kinetruss.results import Result, variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray


Floats = Any

SIDE = 4
"""Rows on either side of a reading from which it is predicted."""
FAR = 5.0
"""Smallest distance of an outlier from its prediction, in robust standard deviations."""
NORMAL = 1 / 0.31864
"""Standard deviation of normal noise over the quartile of its size. An outlier spoils the predictions of its neighbours,
so that more than half of all rows may be off; a quarter is not."""


def outlying(times: Floats, column: Floats) -> Floats:
    """Mask (rows,) of the outliers of a column (rows,) at times (rows,), s.

    Each reading is predicted by the cubic through its neighbours, without itself. It is an outlier if it is `FAR` deviations
    off, by the quartile of all rows and by that of the rows around it (after Hampel), and farther than the cubic is from
    the parabola (so that a motion without noise has none). The farthest in its surroundings is taken out first, and the rest
    looked at again. Source: Hampel (1974), J. Am. Statist. Assoc. 69, 383 (deviations by ranks); Liu, Shah & Jiang (2004),
    Comput. Chem. Eng. 28, 1635 (filter).
    """
    n = len(column)
    found = np.zeros(n, np.bool_)
    distinct = np.diff(np.unique(column))
    step = float(distinct.min(initial=np.inf)) if len(distinct) < n // 2 else 0.0  # of a record with few digits
    floor = max(step, 1e-12 * float(np.abs(column).max())) if np.isfinite(step) else np.inf
    while (~found).sum() > 6 * SIDE:
        kept = np.flatnonzero(~found)
        off, between = _off(times[kept], column[kept])
        size = np.abs(off)
        width = min(len(kept), 8 * SIDE + 1)
        first = np.clip(np.arange(len(kept)) - width // 2, 0, len(kept) - width)
        around = np.lib.stride_tricks.sliding_window_view(size, width)[first]
        usual = NORMAL * np.maximum(np.quantile(size, 0.25), np.quantile(around, 0.25, axis=1))
        # near the ends a cubic extrapolates, and has its own distance from the parabola
        usually = np.median(np.lib.stride_tricks.sliding_window_view(between, width)[first], axis=1)
        usually[:SIDE], usually[-SIDE:] = between[:SIDE], between[-SIDE:]
        bad = size > FAR * np.maximum(usual, floor) + usually
        peak = size >= around.max(axis=1)
        if not (bad & peak).any():
            break
        found[kept[bad & peak]] = True
    return found


def _off(times: Floats, column: Floats) -> tuple[Floats, Floats]:
    """Distance of each reading from the cubic through its neighbours, and of cubic from parabola; both over the factor by which
    white noise spreads the prediction.
    """
    n = len(column)
    first = np.clip(np.arange(n) - SIDE, 0, n - 2 * SIDE - 1)
    index = first[:, None] + np.arange(2 * SIDE + 1)
    index = index[index != np.arange(n)[:, None]].reshape(n, 2 * SIDE)
    u = times[index] - times[:, None]
    u = u / np.abs(u).max(axis=1)[:, None]
    weights = [np.linalg.pinv(u[..., None] ** np.arange(k))[:, 0] for k in (4, 3)]
    cubic, parabola = ((one * column[index]).sum(axis=1) for one in weights)
    spread = np.sqrt(1 + (weights[0] ** 2).sum(axis=1))
    return (column - cubic) / spread, np.abs(cubic - parabola) / spread


# Measured records of drives or pose coordinates: smoothed, with noise, outliers and standard errors.

LAG = 3.0
"""Largest correlation of a residual with the next, times the root of the number of rows, that white noise may have."""
AGREE = 0.05
"""Largest misfit of given rates with values, as a fraction of their range."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Smoothed(Result):
    """A smoothed record; see `measured`. trajectory : the record with value, rate and acceleration at every row."""

    trajectory: Measured

    def outliers(self) -> list[tuple[str, float, float]]:
        """Coordinate, time (s) and distance from the smoothed curve (m or rad) of every outlier."""
        data = self.data
        return [
            (str(data["coordinate"].values[k]), float(data["time"].values[i]), float(data["residual"].values[i, k]))
            for k, i in np.argwhere(data["outlier"].values.T)
        ]


class _Column(NamedTuple):
    """A column: jet (rows, 3), covariance (rows, 3, 3), the smoother of its values or rates (None: all is given), outliers,
    and sentences on given rates that do not fit.
    """

    jet: NDArray[np.float64]
    covariance: NDArray[np.float64]
    smooth: Smooth | None
    of: str
    outlier: NDArray[np.bool_]
    misfit: tuple[str, ...]


@one_thread
def measured(record: Measured) -> Smoothed:
    """Smooth a measured record, estimate its noise, find its outliers, and give rates and accelerations with standard errors.

    Parameters
    ----------
    record : `kt.Measured`, or from `io.read_measured`. Rates and accelerations that it has are used as they are.

    Returns
    -------
    Smoothed, a result. ``value``, ``rate``, ``acceleration`` (time, coordinate), m or rad, per s, per s^2, and their standard
    errors ``value_error``, ``rate_error``, ``acceleration_error`` (NaN: given, so not known); ``covariance`` (time, coordinate,
    order, other) of the three at one row; ``residual`` (time, coordinate): reading minus curve; ``outlier`` (time,
    coordinate). ``noise`` (coordinate): standard deviation of one reading, of a rate where rates are smoothed;
    ``noise_error``: its own standard error; ``freedom``: effective number of parameters of the curve. ``trajectory``: the
    smoothed record, for `kinematics.follow`. The message names outliers, noise that is not white, given rates that are not
    those of the values, and records whose noise cannot be distinguished from the motion.

    Raises
    ------
    InputError : fewer than 16 rows to smooth; steps that are not even, for Savitzky and Golay.

    Notes
    -----
    Both smoothers are linear. The standard errors are those of white noise of the estimated size; for the spline they hold its
    bias as well. See `smoothing_spline`, `savitzky_golay` and `outlying` for the sources.

    >>> import numpy as np, kinetruss as kt
    >>> t = np.linspace(0, 2, 81)
    >>> noise = 1e-4 * np.random.default_rng(1).standard_normal(81)
    >>> found = measured(kt.Measured(times=t, values={"M7": 1 + 0.1 * np.sin(2 * t) + noise}))
    >>> bool(abs(found.noise.item() - 1e-4) < 3 * found.noise_error.item())
    True
    """
    if not isinstance(record, Measured):
        raise InputError(f"{shown(record)} is not a measured record. Give kt.Measured(times=..., values={{drive: ...}}).")
    found, names = _completed(ByIdentity(record)), list(record.values)
    times = np.array(record.times)
    jet = np.stack([one.jet for one in found], axis=1)
    readings = np.stack([_readings(record, name, one.of) for name, one in zip(names, found, strict=True)], axis=1)
    per = ("time", "coordinate")
    data: dict[str, Any] = {}
    for order, word in enumerate(("value", "rate", "acceleration")):
        unit = ("m or rad", "m/s or rad/s", "m/s^2 or rad/s^2")[order]
        error = np.stack([np.sqrt(one.covariance[:, order, order]) for one in found], axis=1)
        data[word] = variable(per, jet[:, :, order], unit, f"smoothed {word}")
        data[f"{word}_error"] = variable(per, np.where(error == 0, np.nan, error), unit, f"standard error of the {word}")
    curve = np.stack([one.jet[:, 1 if one.of == "rate" else 0] for one in found], axis=1)
    data["residual"] = variable(per, readings - curve, "m or rad", "reading minus smoothed curve")
    data["outlier"] = variable(per, np.stack([one.outlier for one in found], axis=1), "", "reading far from its neighbours")
    covariance = np.stack([one.covariance for one in found], axis=1)
    data["covariance"] = variable((*per, "order", "other"), covariance, "", "covariance of value, rate, acceleration")
    for key, text in (
        ("noise", "standard deviation of one reading"),
        ("noise_error", "standard error of the noise"),
        ("freedom", "effective number of parameters of the curve"),
    ):
        values = np.array([np.nan if one.smooth is None else getattr(one.smooth, key) for one in found])
        data[key] = variable(("coordinate",), values, "", text)
    whole = {name: tuple(jet[:, k].T) for k, name in enumerate(names)}
    trajectory = record.with_(
        values={name: one[0] for name, one in whole.items()},
        rates={name: one[1] for name, one in whole.items()},
        accelerations={name: one[2] for name, one in whole.items()},
    )
    coords = {"time": variable(("time",), times - times[0], "s", "time from the first row"), "coordinate": names}
    dataset = xr.Dataset(data, coords=coords, attrs={"kind": "measured"})
    return Smoothed(data=dataset, message=measured_notes(record), trajectory=trajectory)


def measured_law(record: Measured, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Value, rate and acceleration (n, k) at t (n,) s: the quintics with those of the rows."""
    curve = _curve(ByIdentity(record))
    return curve(t), curve(t, 1), curve(t, 2)


@lru_cache(maxsize=8)
def _curve(record: ByIdentity) -> Any:
    from scipy.interpolate import BPoly

    derivatives = np.stack([one.jet for one in _completed(record)], axis=2)
    return BPoly.from_derivatives(np.array(record.model.times), derivatives)


def measured_notes(record: Measured) -> str:
    """What the smoothing of a record says: noise, outliers, misfits."""
    said = []
    for name, one in zip(record.values, _completed(ByIdentity(record)), strict=True):
        if one.smooth is not None:
            of = "the rates of " if one.of == "rate" else ""
            said.append(f"Noise of {of}{name}: {number(one.smooth.noise, 3)} +- {number(one.smooth.noise_error, 2)} (SI).")
            said += _doubts(record, name, one)
        if one.outlier.any():
            said.append(_outliers(record, name, one))
        said += one.misfit
    return " ".join(said)


def _outliers(record: Measured, name: str, one: _Column) -> str:
    at = np.array(record.times)[one.outlier]
    when = few([f"{t:g}" for t in at], 6)
    replaced = record.outliers == "replace" and one.smooth is not None
    fate = "They are replaced by the smoothed curve." if replaced else "They are kept; outliers: replace smooths without them."
    if one.smooth is None:
        fate = "They are kept: the record gives the rates and accelerations there. Mend the rows."
    return f"{name} has {len(at)} outlier{'s' if len(at) > 1 else ''}, at t = {when} s. {fate}"


def _doubts(record: Measured, name: str, one: _Column) -> list[str]:
    """Sentences on noise that is not white, and on records without enough rows."""
    if one.smooth is None:
        return []
    order = 1 if one.of == "rate" else 0
    y = _readings(record, name, one.of)
    rest = (y - one.jet[:, order])[~one.outlier]
    if one.smooth.noise < 1e-9 * float(np.abs(y).max()):
        return []
    if one.smooth.rough:
        return [
            f"The curve of {name} needs {one.smooth.freedom:.0f} parameters for {len(y)} rows: its noise cannot be "
            "distinguished from its motion, and the standard errors are too small. Give more rows a second or a shorter record."
        ]
    # residuals of a smoother are correlated by about minus its parameters per row
    lag = float((rest[1:] * rest[:-1]).sum() / (rest**2).sum()) + one.smooth.freedom / len(rest)
    if abs(lag) > LAG / np.sqrt(len(rest)):
        return [
            f"The noise of {name} is not white (correlation {lag:.2f} from row to row), or the motion is faster than its rows: "
            "the standard errors are not good. Average the readings that belong together, or give more rows a second."
        ]
    return []


def _readings(record: Measured, name: str, of: str) -> NDArray[np.float64]:
    return np.array((record.rates if of == "rate" else record.values)[name], float)


@lru_cache(maxsize=8)
def _completed(key: ByIdentity) -> tuple[_Column, ...]:
    """The columns of a record, with all that is not given."""
    record: Measured = key.model
    times = np.array(record.times, float)
    if record.smoothed and len(times) < LEAST_ROWS:
        raise InputError(f"The record has {len(times)} rows; smoothing needs at least {LEAST_ROWS}. Give more, or a kt.Spline.")
    return tuple(_column(record, times, name) for name in record.values)


def _column(record: Measured, times: Floats, name: str) -> _Column:
    value = _readings(record, name, "value")
    if name not in record.rates:
        smooth, outlier = _smooth(record, times, value)
        return _Column(smooth.jet, smooth.covariance, smooth, "value", outlier, ())
    rate = _readings(record, name, "rate")
    covariance = np.zeros((len(times), 3, 3))
    if name in record.accelerations:
        acceleration = np.array(record.accelerations[name], float)
        jet = np.stack([value, rate, acceleration], axis=1)
        misfit = _misfit(times, value, rate, acceleration, (name, "values", "rates"))
        misfit += _misfit(times, rate, acceleration, np.gradient(acceleration, times), (name, "rates", "accelerations"))
        return _Column(jet, covariance, None, "value", outlying(times, value), misfit)
    smooth, outlier = _smooth(record, times, rate)
    covariance[:, 2, 2] = smooth.covariance[:, 1, 1]
    jet = np.stack([value, rate, smooth.jet[:, 1]], axis=1)
    misfit = _misfit(times, value, rate, smooth.jet[:, 1], (name, "values", "rates"))
    return _Column(jet, covariance, smooth, "rate", outlier, misfit)


def _smooth(record: Measured, times: Floats, column: Floats) -> tuple[Smooth, NDArray[np.bool_]]:
    outlier = outlying(times, column)
    used = ~outlier if record.outliers == "replace" else np.ones(len(times), np.bool_)
    used[[0, -1]] = True
    if record.smoothing == "spline":
        return smoothing_spline(times, column[:, None], used)[0], outlier
    return savitzky_golay(times, column[:, None], used, record.window)[0], outlier


def _misfit(times: Floats, y: Floats, rate: Floats, second: Floats, words: tuple[str, str, str]) -> tuple[str, ...]:
    """A sentence if the integral of given rates is not the change of the values.

    The integral is that of the quintic between two rows: h (r1 + r2)/2 + h^2 (a1 - a2)/12. Sums of it stay good where the
    values have noise, as differences of the values would not.
    """
    h = np.diff(times)
    piece = h * (rate[1:] + rate[:-1]) / 2 + h**2 * (second[:-1] - second[1:]) / 12
    summed = np.concatenate([[0.0], np.cumsum(piece)])
    off = (y - y.mean()) - (summed - summed.mean())
    size = max(float(np.ptp(y)), float(np.ptp(summed)))
    worst = float(np.abs(off).max())
    if size == 0 or worst <= AGREE * size:
        return ()
    name, what, of = words
    scale = float((summed - summed.mean()) @ (y - y.mean()) / max(((summed - summed.mean()) ** 2).sum(), 1e-300))
    return (
        f"The {of} of {name} are not those of its {what}: their integral is up to {worst:.3g} off, {worst / size:.0%} of the "
        f"range (the {what} change {scale:.4g} times as much). Correct the units or the columns, or leave the {of} out.",
    )
