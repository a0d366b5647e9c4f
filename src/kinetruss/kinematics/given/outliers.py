"""Outliers of a record: readings far from what their neighbours say."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["outlying"]

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
