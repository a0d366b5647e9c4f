"""How kernels are compiled: cached on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numba

from kinetruss.kernels._caches import drop_stale

__all__ = ["kernel", "kernel_bare", "kernel_inline", "kernel_inner", "kernel_making"]

drop_stale(Path(__file__).parent)

_hot: Any = {"cache": True, "error_model": "numpy", "fastmath": {"contract"}, "nogil": True, "_nrt": False}
_inner: Any = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}

kernel: Any = numba.njit(**(_hot | {"_nrt": True}))
"""A kernel that Python or a cold path calls; it may allocate."""

# Without references counted (`_nrt`), records and views of arrays cost nothing to hand around; counting took a third of the
# time of small systems. Such a kernel neither allocates nor gives back an array.

kernel_bare: Any = numba.njit(**_hot)
"""A kernel that Python and hot loops call; it allocates nothing."""

kernel_inline: Any = numba.njit(forceinline=True, **_hot)
"""A step of a hot loop; as a call it would cost more than it does (records of arrays are passed by value)."""

kernel_inner: Any = numba.njit(**_hot, **_inner)
"""A kernel that only kernels call: without the wrappers for Python, whose compilation costs more than its own."""

kernel_making: Any = numba.njit(**(_hot | _inner | {"_nrt": True}))
"""The same for one that allocates."""
