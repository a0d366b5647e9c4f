"""Factor and solve, compiled once and called by name: whatever integrates does not compile the solvers into itself again.

Each entry is a symbol of the process that cached code finds by its name. A pointer takes no records: buffers and vectors are
handed over by address. How long vectors are, the equations tell; nobody asks it of the buffers of a record, whose table says
where each of its arrays ends.
"""

from __future__ import annotations

from typing import Any

import llvmlite.binding
from numba import types

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_entry, kernel_inline
from kinetruss.kernels.compiled.parts import array_at
from kinetruss.kernels.solve.kkt_dense import dense_factor, dense_solve
from kinetruss.kernels.solve.kkt_sparse import sparse_factor, sparse_solve
from kinetruss.kernels.solve.kkt_sweep import sweep_factor, sweep_solve
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["call_factor", "call_solve"]

_pointer: Any = types.CPointer
_ints, _reals = _pointer(types.int64), _pointer(types.float64)
_records = (_ints, _reals, _ints, _reals)
_FACTOR = types.float64(*_records, _reals)
_SOLVE = types.void(*_records, _reals, _reals, _reals, _reals)


@kernel_inline
def _records_at(a, b, c, d):  # type: ignore[no-untyped-def]
    """The equations on the buffers at a, b, the workspace on those at c, d."""
    return Equations(array_at(a, 0), array_at(b, 0)), Workspace(array_at(c, 0), array_at(d, 0))


@kernel_entry(_FACTOR)
def _factor(a, b, c, d, x):  # type: ignore[no-untyped-def]
    eq, ws = _records_at(a, b, c, d)
    y = array_at(x, eq.local.size)
    if eq.solver == e.DENSE:
        return dense_factor(eq, ws, y)
    if eq.solver == e.SPARSE:
        return sparse_factor(eq, ws, y)
    return sweep_factor(eq, ws, y)


@kernel_entry(_SOLVE)
def _solve(a, b, c, d, f, gamma, acceleration, pulls):  # type: ignore[no-untyped-def]
    eq, ws = _records_at(a, b, c, d)
    n, rows = eq.local.size, eq.kind.size
    push, second, out, N = array_at(f, n), array_at(gamma, rows), array_at(acceleration, n), array_at(pulls, rows)
    if eq.solver == e.DENSE:
        dense_solve(eq, ws, push, second, out, N)
    elif eq.solver == e.SPARSE:
        sparse_solve(eq, ws, push, second, out, N)
    else:
        sweep_solve(eq, ws, push, second, out, N)


for _name, _entry in (("factor", _factor), ("solve", _solve)):
    llvmlite.binding.add_symbol(f"kinetruss_{_name}", _entry.address)

_call_factor = types.ExternalFunction("kinetruss_factor", types.float64(*[types.intp] * 5))
_call_solve = types.ExternalFunction("kinetruss_solve", types.void(*[types.intp] * 8))


@kernel_bare
def call_factor(eq, ws, x):  # type: ignore[no-untyped-def]
    """`factor` of the solver at hand."""
    return _call_factor(eq.ints.ctypes.data, eq.reals.ctypes.data, ws.ints.ctypes.data, ws.reals.ctypes.data, x.ctypes.data)


@kernel_bare
def call_solve(eq, ws, f, gamma, a, N):  # type: ignore[no-untyped-def]
    """`solve` with the factors at hand; f, a (3 n,), gamma, N (r,)."""
    _call_solve(
        eq.ints.ctypes.data, eq.reals.ctypes.data, ws.ints.ctypes.data, ws.reals.ctypes.data, f.ctypes.data,
        gamma.ctypes.data, a.ctypes.data, N.ctypes.data,
    )  # fmt: skip
