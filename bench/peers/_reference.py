"""What is right at the end: closed form, 28-digit values, or the equations solved tightly by other means than is measured."""

from __future__ import annotations

import math

import numpy as np
from _cases import ANDREWS_END, Bars, G, chain_bars
from scipy.integrate import DOP853
from scipy.sparse import bmat, coo_matrix, csc_matrix
from scipy.sparse.linalg import splu
from scipy.special import ellipj, ellipk

RTOL, ATOL = 1e-12, 1e-13


def end_of(case: str, n: int) -> np.ndarray:
    """The state that is compared, flat."""
    if case == "andrews":
        return np.array(ANDREWS_END)
    if case == "n_four_bar":
        return n_four_bar_end(n)
    return chain_end(chain_bars(n, lumped=case == "chain_lumped"))


def error_of(case: str, state: np.ndarray, right: np.ndarray) -> float:
    """Largest difference: m, or rad for the angles of Andrews' mechanism (whole turns do not count)."""
    off = np.asarray(state) - right
    if case == "andrews":
        off -= 2 * math.pi * np.round(off / (2 * math.pi))
    worst = float(np.abs(off).max())
    return worst if math.isfinite(worst) else math.inf


def n_four_bar_end(n: int, t: float = 1.0) -> np.ndarray:
    """All windows move alike, one pendulum: theta'' = k sin(theta), theta(0) = 0, theta'(0) = 1, by elliptic functions."""
    k = G * ((n + 1) / 2 + n) / ((n + 1) / 3 + n)
    energy = 0.5 + 2 * k
    m = 2 * k / energy
    half = ellipj(math.sqrt(energy / 2) * t - ellipk(m), m)[3]
    theta = 2 * half + math.pi
    i = np.arange(n + 1)
    return np.stack([i + math.sin(theta), np.cos(theta) + 0.0 * i], 1).reshape(-1)


def chain_end(bars: Bars) -> np.ndarray:
    """[[M, J^T], [J, 0]] by SuperLU, SciPy's DOP853 at a tight tolerance, without projection (1 s)."""
    free = np.flatnonzero(~bars.fixed)
    keep = (3 * free[:, None] + np.arange(3)).reshape(-1)
    fixed = bars.points.reshape(-1).copy()
    mass = mass_matrix(bars)[keep][:, keep]
    load = (mass_matrix(bars) @ np.tile(bars.gravity, len(bars.points)) + bars.force.reshape(-1))[keep]
    rigid, soft = np.flatnonzero(bars.rigid), np.flatnonzero(~bars.rigid)
    half = len(keep)

    def slope(_, y):
        x, v = fixed.copy(), np.zeros(len(fixed))
        x[keep], v[keep] = y[:half], y[half:]
        force = load + _spring_forces(bars, soft, x, v)[keep]
        rows, gamma = _rows(bars, rigid, x, v)
        rows = rows[:, keep]
        whole = bmat([[mass, rows.T], [rows, None]], format="csc")
        return np.concatenate([y[half:], splu(whole).solve(np.concatenate([force, gamma]))[:half]])

    y = np.concatenate([fixed[keep], bars.velocity.reshape(-1)[keep]])
    solver = DOP853(slope, 0.0, y, bars.t_end, rtol=RTOL, atol=ATOL)
    while solver.status == "running":
        solver.step()
    return solver.y[:half]


def mass_matrix(bars: Bars) -> csc_matrix:
    """Consistent mass of uniform bars, mass/6 [[2, 1], [1, 2]] in every direction, and lumped masses."""
    count, dim = bars.points.shape
    i, j = bars.ends.T
    k = np.arange(count)
    row, column = np.concatenate([i, j, i, j, k]), np.concatenate([i, j, j, i, k])
    value = np.concatenate([bars.mass / 3, bars.mass / 3, bars.mass / 6, bars.mass / 6, bars.lump])
    each = np.arange(dim)[:, None]
    places = ((dim * row + each).reshape(-1), (dim * column + each).reshape(-1))
    return coo_matrix((np.tile(value, dim), places), (dim * count, dim * count)).tocsc()


def _spring_forces(bars: Bars, soft: np.ndarray, x: np.ndarray, v: np.ndarray) -> np.ndarray:
    p, q = bars.ends[soft].T
    X, V = x.reshape(-1, 3), v.reshape(-1, 3)
    d = X[q] - X[p]
    length = np.linalg.norm(d, axis=1)
    u = d / length[:, None]
    pull = bars.stiffness * (length - bars.lengths[soft]) + bars.damping * np.einsum("ij,ij->i", u, V[q] - V[p])
    force = np.zeros_like(X)
    np.add.at(force, p, pull[:, None] * u)
    np.subtract.at(force, q, pull[:, None] * u)
    return force.reshape(-1)


def _rows(bars: Bars, rigid: np.ndarray, x: np.ndarray, v: np.ndarray):
    """Rows of unit length and J a = -|dv|^2/L."""
    p, q = bars.ends[rigid].T
    X, V = x.reshape(-1, 3), v.reshape(-1, 3)
    length = bars.lengths[rigid]
    u, speed = (X[q] - X[p]) / length[:, None], V[q] - V[p]
    k = np.repeat(np.arange(len(rigid)), 3)
    columns = 3 * np.stack([p, q])[:, :, None] + np.arange(3)
    values = np.concatenate([-u.reshape(-1), u.reshape(-1)])
    rows = coo_matrix((values, (np.tile(k, 2), columns.reshape(-1))), (len(rigid), len(x))).tocsc()
    return rows, -np.einsum("ij,ij->i", speed, speed) / length
