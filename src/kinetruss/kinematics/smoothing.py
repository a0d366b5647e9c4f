"""Smoothers of a noisy record: value, rate and acceleration, their covariance, and the noise.

The filter is linear in the record, so that its covariance is exact for white noise. The splines are averaged over how smooth
the motion may be, and their covariance says what the record leaves open about that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray


Floats = Any

DEGREE = 5
"""Of the polynomials of Savitzky and Golay."""
ORDERS = (2, 3, 4)
"""The derivatives that the splines keep small: of motions whose rate, acceleration or jerk may change suddenly."""
CUBIC = 4
"""Number of coefficients of a cubic; what is one costs nothing in any of the splines."""
STEP, LEAST_WEIGHT = 0.5, 1e-4
"""Decades from one smoothness to the next, and the smallest weight of one that counts."""
LEAST_FREEDOM = 1.0
"""Smallest number of parameters beyond a cubic: a smoother curve is a cubic, which a larger smoothness does not change."""
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
    """Splines of degree 2 order - 1 on knots at rows, in the basis in which fit and roughness are both diagonal.

    fitted (k, m): the basis at the used rows, orthonormal. at (3, rows, m): the basis and its two derivatives at all rows.
    roughness (m,): integral of the squared derivative of this order of each basis function; 0 for the last, polynomials.
    cubic (m, j): directions of the cubics in this basis, beyond those polynomials.
    """

    def __init__(self, times: Floats, used: Floats, order: int) -> None:
        rows, degree = times[used], 2 * order - 1
        m = min(len(rows), MOST_KNOTS)
        # not-a-knot: with a knot at every row but `order` at each end there are as many coefficients as rows
        inner = rows[np.round(np.linspace(order, len(rows) - 1 - order, m - degree - 1)).astype(int)]
        scale = (times[-1] - times[0]) / (m - 1)
        start = times[0]
        knots = (np.concatenate([[start] * (degree + 1), inner, [times[-1]] * (degree + 1)]) - start) / scale
        u = (times - start) / scale
        Q, R = np.linalg.qr(_basis(u[used], knots, degree, 0))
        breaks = np.unique(knots)
        h, middle = np.diff(breaks) / 2, (breaks[1:] + breaks[:-1]) / 2
        nodes, weights = np.polynomial.legendre.leggauss(order)
        places = (middle[:, None] + h[:, None] * nodes).ravel()
        highest = _basis(places, knots, degree, order) * np.sqrt(h[:, None] * weights).ravel()[:, None]
        # singular values of D R^-1 are the roots of the roughness, so that the smallest keep half of all digits
        _, s, Vt = np.linalg.svd(np.linalg.qr(highest)[1] @ np.linalg.inv(R))
        s[-order:] = 0.0
        turn = np.linalg.solve(R, Vt.T)
        self.fitted, self.roughness = Q @ Vt.T, s**2
        self.at = np.stack([_basis(u, knots, degree, one) @ turn / scale**one for one in range(3)])
        polynomials, _ = np.linalg.qr(np.polynomial.legendre.legvander(2 * u[used] / u[-1] - 1, CUBIC - 1))
        self.cubic = self.fitted.T @ polynomials[:, order:]
        self.cubic[-order:] = 0.0


@lru_cache(maxsize=4)
def _splines(times: bytes, used: bytes) -> tuple[_Spline, ...]:
    return tuple(_Spline(np.frombuffer(times), np.frombuffer(used, np.bool_), order) for order in ORDERS)


def _basis(u: Floats, knots: Floats, degree: int, order: int) -> Floats:
    """A derivative (len(u), m) of all B-splines of this degree at u."""
    from scipy.interpolate import BSpline

    m, k = len(knots) - degree - 1, degree
    change = np.eye(m)
    # coefficients of the derivative: k (c_i+1 - c_i)/(t_i+k+1 - t_i+1)
    for _ in range(order):
        width = knots[k + 1 : -1] - knots[1 : -k - 1]
        change = (k / width)[:, None] * np.diff(change, axis=0)
        knots, k = knots[1:-1], k - 1
    return BSpline.design_matrix(np.clip(u, knots[k], knots[-k - 1]), knots, k) @ change


def smoothing_spline(times: Floats, columns: Floats, used: Floats) -> list[Smooth]:
    """Smoothing splines to columns (rows, k) at times (rows,); only `used` (rows,) rows are fitted.

    A spline minimises sum (y - f)^2 + p integral (d^m f/dt^m)^2 dt. No m and p are chosen: the curve is the mean over m of 2,
    3, 4 and all p, each weighted by the restricted likelihood of the record. The covariance is that of the curve given the
    record: of the noise, of what each spline does not follow of its motion (sudden changes of the acceleration, for m = 3),
    and of the differences between the splines. Cubics are free in all of them, so that their likelihoods compare.

    Source: Wahba (1983), J. R. Statist. Soc. B 45, 133 (covariance); Wahba (1985), Ann. Statist. 13, 1378 (likelihood); Nychka
    (1988), J. Am. Statist. Assoc. 83, 1134 (coverage); Hoeting et al. (1999), Statist. Sci. 14, 382 (mean over models).
    """
    splines = _splines(np.ascontiguousarray(times, float).tobytes(), np.ascontiguousarray(used, np.bool_).tobytes())
    return [_averaged(splines, column[used]) for column in columns.T]


class _Fit(NamedTuple):
    """A spline of one smoothness p to a record, whose curve has the coefficients `curve` (m,).

    cost : minus the logarithm of its restricted likelihood. kept (m,) : share of each coefficient of the record that is in the
    curve. variance : of a reading. freedom : number of parameters. through (m, j), spread (j, j) : the directions in which the
    cubics are free, and the covariance of their coefficients for readings of variance 1.
    """

    spline: _Spline
    cost: float
    kept: Floats
    curve: Floats
    variance: float
    freedom: float
    through: Floats
    spread: Floats


def _fits(spline: _Spline, y: Floats) -> Iterator[_Fit]:
    """Splines from one through every row to one that is hardly more than a cubic."""
    n, z = len(y), spline.fitted.T @ y
    beyond = float(((y - spline.fitted @ z) ** 2).sum())
    rough = spline.roughness[spline.roughness > 0]
    for exponent in np.arange(-8.0 - np.log10(rough.max()), 2.0 - np.log10(rough.min()), STEP):
        # the inverse of the covariance 1 + 1/(p roughness) of a coefficient of the record
        left = 10.0**exponent * spline.roughness
        left /= 1 + left
        through = left[:, None] * spline.cubic
        spread = np.linalg.inv(spline.cubic.T @ through)
        free = spread @ (through.T @ z)
        freedom = float((1 - left).sum() + np.einsum("ka,ab,kb->", through, spread, through))
        if freedom < CUBIC + LEAST_FREEDOM:
            return
        energy = beyond + float((left * z**2).sum() - free @ (through.T @ z))
        cost = (n - CUBIC) * np.log(max(energy, 1e-300)) - np.log(left[left > 0]).sum() - np.linalg.slogdet(spread)[1]
        curve = (1 - left) * z + through @ free
        yield _Fit(spline, cost / 2, 1 - left, curve, energy / (n - CUBIC), freedom, through, spread)


def _averaged(splines: tuple[_Spline, ...], y: Floats) -> Smooth:
    """The mean of all splines, weighted by their likelihood."""
    found = [one for spline in splines for one in _fits(spline, y)]
    least = min(one.cost for one in found)
    found = [one for one in found if one.cost < least - math.log(LEAST_WEIGHT)]
    weight = np.exp(least - np.array([one.cost for one in found]))
    weight /= weight.sum()
    jets = np.stack([(one.spline.at @ one.curve).T for one in found])
    jet = np.tensordot(weight, jets, 1)
    apart = jets - jet
    covariance = np.einsum("k,kra,krb->rab", weight, apart, apart)
    for spline in splines:
        mine = [(w, one) for w, one in zip(weight, found, strict=True) if one.spline is spline]
        if mine:
            kept = sum(w * one.variance * one.kept for w, one in mine)
            covariance += np.einsum("ari,bri,i->rab", spline.at, spline.at, kept, optimize=True)
        for w, one in mine:
            free = spline.at @ one.through
            covariance += w * one.variance * np.einsum("ari,ij,brj->rab", free, one.spread, free)
    noise = math.sqrt(sum(w * one.variance for w, one in zip(weight, found, strict=True)))
    freedom = sum(w * one.freedom for w, one in zip(weight, found, strict=True))
    n, m = splines[0].fitted.shape
    error = noise / math.sqrt(2 * (n - freedom))
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
