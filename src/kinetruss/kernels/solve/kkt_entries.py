"""Factor and solve with the solver at hand; no other is compiled."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.solve.kkt_dense import dense_factor, dense_solve
from kinetruss.kernels.solve.kkt_sparse import sparse_factor, sparse_solve
from kinetruss.kernels.solve.kkt_sweep import sweep_factor, sweep_solve
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["call_factor", "call_solve"]


@kernel_bare
def call_factor(eq: Equations, ws: Workspace, x: F1) -> float:
    """`factor` of the solver at hand."""
    if eq.solver == e.DENSE:
        return dense_factor(eq, ws, x)
    if eq.solver == e.SPARSE:
        return sparse_factor(eq, ws, x)
    return sweep_factor(eq, ws, x)


@kernel_bare
def call_solve(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """`solve` with the factors at hand."""
    if eq.solver == e.DENSE:
        dense_solve(eq, ws, f, gamma, a, N)
    elif eq.solver == e.SPARSE:
        sparse_solve(eq, ws, f, gamma, a, N)
    else:
        sweep_solve(eq, ws, f, gamma, a, N)
