"""How kernels are compiled: cached on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

import numba

__all__ = ["kernel", "kernel_inline"]

kernel = numba.njit(cache=True, error_model="numpy", fastmath={"contract"}, nogil=True)
kernel_inline = numba.njit(cache=True, error_model="numpy", fastmath={"contract"}, inline="always")
