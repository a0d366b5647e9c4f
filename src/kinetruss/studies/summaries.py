"""What the rows of a study say: distributions of the results, and how they depend on the variables."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

QUANTILES = {"q05": 0.05, "median": 0.5, "q95": 0.95}
DRAWS = 200
"""Resamples of a bootstrap."""
SEED = 0


@dataclass(frozen=True, kw_only=True)
class Summary:
    """Numbers by result.

    spread : result -> count, mean, error (standard error of the mean), deviation, least, q05, median, q95, largest, and the
        rows of least and largest. Rows without numbers are not in it.
    rank : result -> variable -> Spearman's rank correlation, -1 to 1. slope, slope_error : result -> variable -> coefficient of
        the linear regression by all variables, SI by unit of the variable, and its standard error; linear : result -> the share
        of the variance that this regression explains.
    first, total : result -> variable -> Sobol indices, with first_error and total_error from a bootstrap; of Saltelli's design,
        else empty. base : base points of it whose rows all have numbers. Variables that are texts are in Sobol indices alone.
    """

    spread: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    rank: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    slope: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    slope_error: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    linear: Mapping[str, float] = field(default_factory=dict)
    first: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    first_error: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    total: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    total_error: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    base: int = 0


def summary_of(
    data: xr.Dataset, variables: Sequence[str], results: Sequence[str], good: NDArray[np.bool_], base_points: int
) -> Summary:
    """The summary of a table; base_points : of Saltelli's design, else 0."""
    numbers = [name for name in variables if data[name].dtype.kind == "f"]
    X = np.stack([data[name].values[good] for name in numbers], axis=1) if numbers else np.zeros((int(good.sum()), 0))
    rows = data["row"].values[good]
    found: dict[str, Any] = {name: {} for name in Summary.__dataclass_fields__ if name != "base"}
    for name in results:
        y = data[name].values[good]
        known = np.isfinite(y)
        if not known.any():
            continue
        found["spread"][name] = _spread(y[known], rows[known])
        found["rank"][name] = dict(zip(numbers, _ranks(X[known], y[known]), strict=True))
        slopes, errors, share = regression(X[known], y[known])
        found["slope"][name], found["slope_error"][name] = (dict(zip(numbers, one, strict=True)) for one in (slopes, errors))
        found["linear"][name] = share
    base = 0
    if base_points:
        for name in results:
            y = np.where(good, data[name].values, np.nan)
            indices = sobol_indices(y, base_points, len(variables))
            if indices is not None:
                base, *parts = indices
                for key, values in zip(("first", "total", "first_error", "total_error"), parts, strict=True):
                    found[key][name] = dict(zip(variables, values.tolist(), strict=True))
    return Summary(**found, base=base)


def _spread(y: NDArray[np.float64], rows: NDArray[np.int64]) -> dict[str, float]:
    deviation = float(y.std(ddof=1)) if len(y) > 1 else math.nan
    return {
        "count": len(y),
        "mean": float(y.mean()),
        "error": deviation / math.sqrt(len(y)),
        "deviation": deviation,
        "least": float(y.min()),
        **{name: float(np.quantile(y, share)) for name, share in QUANTILES.items()},
        "largest": float(y.max()),
        "row of least": int(rows[y.argmin()]),
        "row of largest": int(rows[y.argmax()]),
    }


def _ranks(X: NDArray[np.float64], y: NDArray[np.float64]) -> list[float]:
    """Spearman's correlation of every column; NaN where one of both does not change."""
    from scipy.stats import rankdata

    if len(y) < 3:
        return [math.nan] * X.shape[1]
    return [_correlation(rankdata(x), rankdata(y)) for x in X.T]


def _correlation(x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
    x, y = x - x.mean(), y - y.mean()
    size = math.sqrt(float(x @ x) * float(y @ y))
    return float(x @ y) / size if size > 0 else math.nan


def regression(X: NDArray[np.float64], y: NDArray[np.float64]) -> tuple[list[float], list[float], float]:
    """Coefficients of y by the columns of X (rows, d) with a constant, their standard errors, and the explained share of the
    variance; NaN where rows are too few or columns depend on each other.
    """
    count, width = X.shape
    nothing = [math.nan] * width
    if not width or count <= width + 1:
        return nothing, nothing, math.nan
    size = X.std(axis=0)
    if (size == 0).any() or not (total := float(((y - y.mean()) ** 2).sum())) > 0:
        return nothing, nothing, math.nan
    Z = np.column_stack([np.ones(count), (X - X.mean(axis=0)) / size])
    found, _, rank, _ = np.linalg.lstsq(Z, y, rcond=None)
    if rank <= width:
        return nothing, nothing, math.nan
    rest = float(((y - Z @ found) ** 2).sum())
    error = np.sqrt(rest / (count - width - 1) * np.diag(np.linalg.inv(Z.T @ Z)))
    return (found[1:] / size).tolist(), (error[1:] / size).tolist(), 1 - rest / total


def sobol_indices(
    y: NDArray[np.float64], count: int, width: int
) -> tuple[int, NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]] | None:
    """Base points that count, first and total indices (d,), and their standard errors, from results in Saltelli's design.

    y : (count (d + 2),) of A, B, and A with the column of each variable from B; NaN without a number: its base point is left
    out. None if less than four are left, or nothing changes.

    Notes
    -----
    S_k = mean(f_B (f_k - f_A))/V (A. Saltelli et al., Computer Physics Communications 181 (2010) 259, table 2, formula b), with
    f less its mean, and T_k = mean((f_A - f_k)^2)/(2 V) (M. J. W. Jansen, 1999); V : variance of f_A and f_B together.
    """
    table = y.reshape(width + 2, count)
    table = table[:, np.isfinite(table).all(axis=0)]
    if table.shape[1] < 4 or not table[:2].std() > 0:
        return None
    first, total = _indices(table)
    random = np.random.default_rng(SEED)
    draws = [_indices(table[:, random.integers(0, table.shape[1], table.shape[1])]) for _ in range(DRAWS)]
    errors = [np.nanstd([one[k] for one in draws], axis=0, ddof=1) for k in (0, 1)]
    return table.shape[1], first, total, errors[0], errors[1]


def _indices(table: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    table = table - table[:2].mean()
    A, B, mixed = table[0], table[1], table[2:]
    variance = table[:2].var()
    if not variance > 0:
        nothing = np.full(len(mixed), np.nan)
        return nothing, nothing
    return (B * (mixed - A)).mean(axis=1) / variance, ((A - mixed) ** 2).mean(axis=1) / (2 * variance)
