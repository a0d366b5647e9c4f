"""Linear smoothers of a noisy record: value, rate and acceleration, their covariance, and the noise.

Both smoothers are linear in the record, so that their covariance is exact for white noise.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LEAST_ROWS", "Smooth", "savitzky_golay", "smoothing_spline"]

Floats = Any

DEGREE = 5
"""Of the polynomials of Savitzky and Golay."""
SPLINE, PENALISED = 7, 4
"""Degree of the smoothing spline, and the derivative that it keeps small."""
LEAST_ROWS = 16
ROUGH = 0.6
"""Largest number of parameters of a curve per row; noise cannot be distinguished from a motion that needs more."""
MOST_KNOTS = 300
"""Largest number of coefficients of a smoothing spline; a longer record has knots at some of its rows."""
EVEN = 1e-3
"""Largest difference of a step from the mean one, as its fraction, in a record of even steps."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Smooth:
    """A smoothed column.

    jet (rows, 3): value, rate, acceleration. covariance (rows, 3, 3) of these three. noise : standard deviation of one
    reading, and noise_error its standard error. freedom : effective number of parameters of the curve. rough : the record has
    more detail than the smoother can follow.
    """

    jet: NDArray[np.float64]
    covariance: NDArray[np.float64]
    noise: float
    noise_error: float
    freedom: float
    rough: bool


class _Spline:
    """Splines on knots at rows, in the basis in which fit and roughness are both diagonal.

    fitted (k, m): the basis at the used rows, orthonormal. at (3, rows, m): the basis and its two derivatives at all rows.
    roughness (m,): of each basis function, 0 for the four of a cubic.
    """

    def __init__(self, times: Floats, used: Floats) -> None:
        rows = times[used]
        m = min(len(rows), MOST_KNOTS)
        # not-a-knot: with a knot at every row but four at each end there are as many coefficients as rows
        inner = rows[np.round(np.linspace(4, len(rows) - 5, m - SPLINE - 1)).astype(int)]
        self.scale = (times[-1] - times[0]) / (m - 1)
        start = times[0]
        knots = (np.concatenate([[start] * (SPLINE + 1), inner, [times[-1]] * (SPLINE + 1)]) - start) / self.scale
        u = (times - start) / self.scale
        B = _basis(u[used], knots, 0)
        Q, R = np.linalg.qr(B)
        breaks = np.unique(knots)
        h, middle = np.diff(breaks) / 2, (breaks[1:] + breaks[:-1]) / 2
        nodes, weights = np.polynomial.legendre.leggauss(SPLINE - PENALISED + 1)
        places = (middle[:, None] + h[:, None] * nodes).ravel()
        highest = _basis(places, knots, PENALISED) * np.sqrt(h[:, None] * weights).ravel()[:, None]
        # singular values of D R^-1 are the roots of the roughness, so that the smallest keep half of all digits
        _, s, Vt = np.linalg.svd(np.linalg.qr(highest)[1] @ np.linalg.inv(R))
        s[-PENALISED:] = 0.0
        turn = np.linalg.solve(R, Vt.T)
        self.fitted, self.roughness = Q @ Vt.T, s**2
        self.at = np.stack([_basis(u, knots, order) @ turn / self.scale**order for order in range(3)])


def _basis(u: Floats, knots: Floats, order: int) -> Floats:
    """A derivative (len(u), m) of all B-splines at u."""
    from scipy.interpolate import BSpline

    m, k = len(knots) - SPLINE - 1, SPLINE
    change = np.eye(m)
    # coefficients of the derivative: k (c_i+1 - c_i)/(t_i+k+1 - t_i+1)
    for _ in range(order):
        width = knots[k + 1 : -1] - knots[1 : -k - 1]
        change = (k / width)[:, None] * np.diff(change, axis=0)
        knots, k = knots[1:-1], k - 1
    return BSpline.design_matrix(np.clip(u, knots[k], knots[-k - 1]), knots, k) @ change


def smoothing_spline(times: Floats, columns: Floats, used: Floats) -> list[Smooth]:
    """Smoothing splines of degree 7 to columns (rows, k) at times (rows,); only `used` (rows,) rows are fitted.

    They minimise sum (y - f)^2 + p integral f''''^2 dt with the p of largest restricted likelihood. The acceleration is smooth
    and free at the ends, where that of SciPy's cubic `make_smoothing_spline` is 0. The covariance is that of the curve given
    the record, which holds the bias as well as the noise. Source: Wahba (1983), J. R. Statist. Soc. B 45, 133 (covariance);
    Wahba (1985), Ann. Statist. 13, 1378 (likelihood); Nychka (1988), J. Am. Statist. Assoc. 83, 1134 (coverage).
    """
    basis = _Spline(times, used)
    return [_smoothed(basis, column[used]) for column in columns.T]


def _smoothed(basis: _Spline, y: Floats) -> Smooth:
    from scipy.optimize import minimize_scalar

    n, m = basis.fitted.shape
    z = basis.fitted.T @ y
    beyond = float(((y - basis.fitted @ z) ** 2).sum())
    rough = basis.roughness[basis.roughness > 0]
    at = z[basis.roughness > 0] ** 2

    def likelihood(exponent: float) -> float:
        p = 10.0**exponent * rough
        energy = beyond + float((at * (p / (1 + p))).sum())
        return float(np.log1p(1 / p).sum() + (n - PENALISED) * np.log(max(energy, 1e-300)))

    grid = np.arange(-8.0, 2.0 - np.log10(rough.min()), 0.5)
    best = grid[int(np.argmin([likelihood(one) for one in grid]))]
    found = minimize_scalar(likelihood, bounds=(best - 0.5, best + 0.5), method="bounded")
    keep = 1 / (1 + 10.0**found.x * basis.roughness)
    left = beyond + float((z**2 * (1 - keep) ** 2).sum())
    freedom = float(keep.sum())
    noise = np.sqrt(left / (n - freedom))
    jet = (basis.at @ (keep * z)).T
    covariance = noise**2 * np.einsum("ari,bri,i->rab", basis.at, basis.at, keep, optimize=True)
    error = noise / np.sqrt(2 * (n - freedom))
    return Smooth(jet=jet, covariance=covariance, noise=noise, noise_error=error, freedom=freedom, rough=freedom > ROUGH * m)


def savitzky_golay(times: Floats, columns: Floats, used: Floats, window: int | None) -> list[Smooth]:
    """Savitzky-Golay filters of degree 5 over columns (rows, k) of even steps; rows that are not used are filled in between.

    The window is the given one, or that of least cross-validation among odd numbers of rows. The covariance is that of white
    noise; the bias of a window that is too long is not in it. Source: Savitzky & Golay (1964), Anal. Chem. 36, 1627.

    Raises
    ------
    InputError : steps that are not even.
    """
    steps = np.diff(times)
    step = float(steps.mean())
    if np.abs(steps - step).max() > EVEN * step:
        k = int(np.abs(steps - step).argmax())
        raise InputError(
            f"smoothing: savitzky_golay needs even steps; after t = {times[k]:g} s the step is {steps[k]:g} s, the mean one "
            f"{step:g} s. Set smoothing: spline."
        )
    filled = np.stack([np.interp(times, times[used], column[used]) for column in columns.T], axis=1)
    return [_filtered(column, step, window) for column in filled.T]


def _filtered(y: Floats, step: float, window: int | None) -> Smooth:
    n = len(y)
    tried = [window] if window else list(range(7, min(n, 201) + 1, 2))
    best = tried[int(np.argmin([_validated(y, one) for one in tried]))]
    table, half = _windows(best), best // 2
    # rows near the ends have the first or last window, all others the one around them
    place = np.concatenate([np.arange(half), np.full(n - 2 * half, half), np.arange(half + 1, best)])
    # E |(1 - H) y|^2 = noise^2 |1 - H|^2 where the filter follows the motion
    products = np.einsum("apw,bpw->pab", table, table)
    freedom = float((2 * table[0].diagonal() - products[:, 0, 0])[place].sum())
    jet = _over(y, table)
    noise = float(np.sqrt(((y - jet[:, 0]) ** 2).sum() / (n - freedom)))
    unit = (2 / ((best - 1) * step)) ** np.arange(3)
    return Smooth(
        jet=jet * unit,
        covariance=noise**2 * products[place] * unit[:, None] * unit,
        noise=noise,
        noise_error=noise / np.sqrt(2 * (n - freedom)),
        freedom=freedom,
        rough=freedom > ROUGH * n,
    )


def _validated(y: Floats, window: int) -> float:
    """Generalised cross-validation: mean squared residual over (1 - mean weight of a row's own reading)^2."""
    table, n, half = _windows(window), len(y), window // 2
    own = table[0].diagonal()
    mean = (own.sum() + (n - window) * own[half]) / n
    return float(((y - _over(y, table[:1])[:, 0]) ** 2).mean() / (1 - mean) ** 2)


@lru_cache(maxsize=128)
def _windows(window: int) -> Floats:
    """Weights (3, window, window) of value, rate and acceleration at each row of a window, in time over half a window."""
    u = np.linspace(-1, 1, window)
    power = np.arange(DEGREE + 1)
    fit = np.linalg.pinv(u[:, None] ** power)
    at = np.zeros((3, window, DEGREE + 1))
    for order in range(3):
        factor = np.array([math.perm(k, order) for k in power], float)
        at[order] = factor * u[:, None] ** np.maximum(power - order, 0)
    return at @ fit


def _over(y: Floats, table: Floats) -> Floats:
    """The filter over a column: (rows, orders)."""
    half, window = table.shape[1] // 2, table.shape[1]
    inner = np.lib.stride_tricks.sliding_window_view(y, window) @ table[:, half].T
    first, last = (table[:, :half] @ y[:window]).T, (table[:, half + 1 :] @ y[-window:]).T
    return np.concatenate([first, inner, last])
