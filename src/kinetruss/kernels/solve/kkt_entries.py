"""Factor and solve, compiled once and called by name: whatever integrates does not compile the solvers into itself again.

Each entry is a symbol of the process that cached code finds by its name; buffers are handed over by address.
"""

from __future__ import annotations

from typing import Any

import llvmlite.binding
from numba import types

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_entry
from kinetruss.kernels.compiled.parts import array_at
from kinetruss.kernels.solve.kkt_dense import dense_factor, dense_solve
from kinetruss.kernels.solve.kkt_sparse import sparse_factor, sparse_solve
from kinetruss.kernels.solve.kkt_sweep import sweep_factor, sweep_solve
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["call_factor", "call_solve"]

_pointer: Any = types.CPointer
_ints, _reals, _size = _pointer(types.int64), _pointer(types.float64), types.int64
_records = (_ints, _size, _reals, _size, _ints, _size, _reals, _size)
_FACTOR = types.float64(*_records, _reals, _size)
_SOLVE = types.void(*_records, _reals, _reals, _reals, _size, _reals, _size)


@kernel_entry(_FACTOR)
def _factor(a, na, b, nb, c, nc, d, nd, x, nx):  # type: ignore[no-untyped-def]
    eq, ws = Equations(array_at(a, na), array_at(b, nb)), Workspace(array_at(c, nc), array_at(d, nd))
    y = array_at(x, nx)
    if eq.solver == e.DENSE:
        return dense_factor(eq, ws, y)
    if eq.solver == e.SPARSE:
        return sparse_factor(eq, ws, y)
    return sweep_factor(eq, ws, y)


@kernel_entry(_SOLVE)
def _solve(a, na, b, nb, c, nc, d, nd, f, gamma, acceleration, n, pulls, rows):  # type: ignore[no-untyped-def]
    eq, ws = Equations(array_at(a, na), array_at(b, nb)), Workspace(array_at(c, nc), array_at(d, nd))
    push, second, out, N = array_at(f, n), array_at(gamma, rows), array_at(acceleration, n), array_at(pulls, rows)
    if eq.solver == e.DENSE:
        dense_solve(eq, ws, push, second, out, N)
    elif eq.solver == e.SPARSE:
        sparse_solve(eq, ws, push, second, out, N)
    else:
        sweep_solve(eq, ws, push, second, out, N)


for _name, _entry in (("factor", _factor), ("solve", _solve)):
    llvmlite.binding.add_symbol(f"kinetruss_{_name}", _entry.address)

_plain = (types.intp, types.int64) * 4
_call_factor = types.ExternalFunction("kinetruss_factor", types.float64(*_plain, types.intp, types.int64))
_call_solve = types.ExternalFunction(
    "kinetruss_solve", types.void(*_plain, types.intp, types.intp, types.intp, types.int64, types.intp, types.int64)
)


@kernel_bare
def call_factor(eq, ws, x):  # type: ignore[no-untyped-def]
    """`factor` of the solver at hand."""
    return _call_factor(
        eq.ints.ctypes.data, eq.ints.size, eq.reals.ctypes.data, eq.reals.size, ws.ints.ctypes.data, ws.ints.size,
        ws.reals.ctypes.data, ws.reals.size, x.ctypes.data, x.size,
    )  # fmt: skip


@kernel_bare
def call_solve(eq, ws, f, gamma, a, N):  # type: ignore[no-untyped-def]
    """`solve` with the factors at hand."""
    _call_solve(
        eq.ints.ctypes.data, eq.ints.size, eq.reals.ctypes.data, eq.reals.size, ws.ints.ctypes.data, ws.ints.size,
        ws.reals.ctypes.data, ws.reals.size, f.ctypes.data, gamma.ctypes.data, a.ctypes.data, a.size, N.ctypes.data, N.size,
    )  # fmt: skip
