"""How kernels are compiled: cached on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

from pathlib import Path

import numba

from kinetruss.kernels._caches import drop_stale

__all__ = ["kernel", "kernel_inline", "kernel_inner"]

drop_stale(Path(__file__).parent)

kernel = numba.njit(cache=True, error_model="numpy", fastmath={"contract"}, nogil=True)
"""A kernel that Python or a cold path calls."""

kernel_inline = numba.njit(cache=True, error_model="numpy", fastmath={"contract"}, nogil=True, forceinline=True)
"""A step of a hot loop; as a call it would cost more than it does (records of arrays are passed by value)."""

kernel_inner = numba.njit(  # type: ignore[call-overload]  # the two options are not in its annotations
    cache=True, error_model="numpy", fastmath={"contract"}, nogil=True, no_cpython_wrapper=True, no_cfunc_wrapper=True
)
"""A kernel that only kernels call: without the wrappers for Python, whose compilation costs more than its own."""
