"""The adjoint of a motion through cells of its time, in which it is integrated by collocation; see gradients.run_adjoint."""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, I1, Floats

ROUNDS, CLOSE = 60, 1e-13
"""Iterations of the stages of a cell at most; relative change that counts as none."""


@kernel
def adjoint_cells(
    G: Floats,
    R: tuple[I1, I1, F2],
    h: F1,
    scheme: tuple[F1, F1, F2, F2, F1],
    jump: Floats,
    later: Floats,
    earlier: Floats,
    inner: Floats,
) -> int:
    """From the last cell to the first, the adjoints (cells, k, 2 f) at the end and the start of each, and the weights
    (cells, s, k, f) of the accelerations at its Gauss points. Returns how many cells are left where the stages do not settle.

    G (cells s, f, m), R (m, 2 f), by its rows: starts (m + 1,), columns and entries (cells s, entries) : z = mu G, and -z R is
    what the accelerations of weight mu count by places and velocities. scheme : c, b, A, A^2, b A. jump (cells, k, 2 f) : of
    the adjoint at the start of a cell; later[-1] is given.
    """
    (c, b, A, twice, above), (begin, column, entry) = scheme, R
    s, f, m, count = b.size, G.shape[1], G.shape[2], later.shape[1]
    first, mu, new, by, z = np.empty((s, f)), np.empty((s, f)), np.empty(f), np.empty((s, 2 * f)), np.empty(m)
    for n in range(h.size - 1, -1, -1):
        step = h[n]
        for r in range(count):
            end, start = later[n, r], earlier[n, r]
            size = 0.0
            for i in range(s):
                for j in range(f):
                    first[i, j] = step * (step * above[i] * end[j] + b[i] * end[f + j])
                    mu[i, j] = first[i, j]
                    size = larger(size, abs(first[i, j]))
            change = size
            for turn in range(ROUNDS + 1):
                # -mu da/d(x, v) of every stage
                for i in range(s):
                    g, d = G[n * s + i], entry[n * s + i]
                    for p in range(m):
                        z[p] = 0.0
                    for j in range(f):
                        weight = mu[i, j]
                        for p in range(m):
                            z[p] += weight * g[j, p]
                    for q in range(2 * f):
                        by[i, q] = 0.0
                    for p in range(m):
                        weight = -z[p]
                        for e in range(begin[p], begin[p + 1]):
                            by[i, column[e]] += weight * d[e]
                if change <= CLOSE * size:
                    break
                if turn == ROUNDS or not change < 1e30 * size:
                    return n + 1
                change = 0.0
                for i in range(s):
                    for j in range(f):
                        new[j] = first[i, j]
                    for l in range(s):
                        one, two = step * A[l, i], step * step * twice[l, i]
                        for j in range(f):
                            new[j] += two * by[l, j] + one * by[l, f + j]
                    for j in range(f):
                        change = larger(change, abs(new[j] - mu[i, j]))
                        mu[i, j] = new[j]
            for j in range(f):
                start[j] = end[j]
                start[f + j] = end[f + j] + step * end[j]
            for i in range(s):
                for j in range(f):
                    start[j] += by[i, j]
                    start[f + j] += step * c[i] * by[i, j] + by[i, f + j]
                    inner[n, i, r, j] = mu[i, j]
            if n:
                for q in range(2 * f):
                    later[n - 1, r, q] = start[q] + jump[n, r, q]
    return 0
