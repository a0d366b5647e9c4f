"""What given states and forces leave of the equations of motion, at many instants at once."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.solve.accelerations import row_gammas
from kinetruss.kernels.solve.kkt import add_constraint_forces, prepare_rows, row_along, row_gradients
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import mass_times


@kernel
def residuals(eq: Equations, ws: Workspace, t: F1, x: F2, v: F2, a: F2, N: F2, out: F2) -> None:
    """f - M a - J^T N of the free coordinates, N, then J a - gamma of the rows, m/s^2, into out (times, free + rows).

    x, v, a (times, 3 n), N (times, rows); prescribed coordinates of x, v and a are set. Without user forces and the friction
    of bearings.
    """
    free, held, held_motion, count = eq.free, eq.held, eq.held_motion, eq.free.size
    for i in range(t.size):
        prepare_rows(eq, ws, t[i], x[i], v[i])
        for k in range(held.size):
            a[i, held[k]] = ws.now[2, held_motion[k]]
        row_gradients(eq, ws, x[i])
        applied(eq, 0, t[i], x[i], v[i], ws.f)
        mass_times(eq, x[i], a[i], ws.h)
        for c in range(ws.f.size):
            ws.f[c] -= ws.h[c]
        add_constraint_forces(eq, ws, N[i], ws.f)
        for j in range(count):
            out[i, j] = ws.f[free[j]]
        row_gammas(eq, ws, x[i], v[i], ws.gamma)
        row_along(eq, ws, a[i], ws.multiplier)
        for k in range(ws.gamma.size):
            out[i, count + k] = ws.multiplier[k] - ws.gamma[k]
