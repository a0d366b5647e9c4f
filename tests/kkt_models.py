"""Dense matrices for the tests of the solvers."""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.solve.kkt import factor, prepare_rows, project
from kinetruss.kernels.structure.mass import mass_times


@kernel
def _mass_column(eq, x, y, out):
    mass_times(eq, x, y, out)


def consistent(system, eq, ws, seed, t):
    """A random state on the rows at t, at the start configuration where no other can be closed."""
    for spread in (0.003, 0.0):
        rng = np.random.default_rng(seed)
        x = system.x0.reshape(-1) + spread * rng.normal(size=system.x0.size) * ~system.prescribed
        v = rng.normal(size=x.size) * ~system.prescribed
        good, _, _ = project(eq, ws, t, x, v, 1e-13)
        if good:
            return x, v
    raise AssertionError("the start itself cannot be closed")


def mass_matrix(eq, x):
    n = x.size
    M, out = np.zeros((n, n)), np.zeros(n)
    for c in range(n):
        _mass_column(eq, x, np.eye(n)[c].copy(), out)
        M[:, c] = out
    return M


def rows_matrix(eq, ws, t, x, v):
    """J (r, 3 n) at x."""
    y, w = x.copy(), v.copy()
    prepare_rows(eq, ws, t, y, w)
    factor(eq, ws, y)
    J = np.zeros((eq.row.size, x.size))
    for k in range(eq.row.size):
        J[k, eq.A[k] : eq.A[k] + 3] -= ws.u[:, k]
        J[k, eq.B[k] : eq.B[k] + 3] += ws.u[:, k]
    return J
