"""How kernels are compiled: cached on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

import numba

__all__ = ["kernel", "kernel_inline"]

kernel = numba.njit(cache=True, error_model="numpy", fastmath={"contract"}, nogil=True)
"""A kernel that Python or a cold path calls."""

kernel_inline = numba.njit(cache=True, error_model="numpy", fastmath={"contract"}, nogil=True, forceinline=True)
"""A step of a hot loop; as a call it would cost more than it does (records of arrays are passed by value)."""
