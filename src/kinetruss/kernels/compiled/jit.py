"""How kernels are compiled: kept on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numba
from numba import types
from numba.core.ccallback import CFunc
from numba.core.sigutils import normalize_signature

from kinetruss.kernels.compiled import fields as _fields  # noqa: F401 - teaches kernels to read records
from kinetruss.kernels.compiled.caches import Keeper, Kept, places_of, states_of
from kinetruss.kernels.compiled.inner import InnerCompiler

__all__ = ["folder", "keeper", "kernel", "kernel_bare", "kernel_entry", "kernel_inline", "kernel_inner", "kernel_making"]

folder = Path(__file__).parents[1]
keeper = Keeper(states_of(folder), places_of(folder), folder)

_hot: Any = {"error_model": "numpy", "fastmath": {"contract"}, "_nrt": False}
_inner: Any = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "pipeline_class": InnerCompiler}


def _kept(**options: Any) -> Any:
    """A decorator that compiles with these options, and keeps what it compiled."""

    def decorated(function: Callable[..., Any]) -> Any:
        found = numba.njit(nogil=True, **options)(function)
        if found is not function:  # else compiling is switched off (NUMBA_DISABLE_JIT)
            found._cache = Kept(keeper, function)
            found.get_call_template = partial(_called, found.get_call_template)
            if "pipeline_class" in options:  # a draft has no address that Python could call
                found._insert, found._compile_for_args = _nothing, partial(_refused, function)
        return found

    return decorated


def _called(template: Any, args: Any, kws: Any) -> Any:
    """How kernels call a kernel: one form for a number, whether its value is known or not; LLVM passes on those that are."""
    return template(tuple(types.unliteral(one) for one in args), {name: types.unliteral(one) for name, one in kws.items()})


def _nothing(*_: Any) -> None:
    """No entry for Python."""


def _refused(function: Callable[..., Any], *_: Any, **__: Any) -> None:
    name = f"{function.__module__}.{function.__qualname__}"
    raise TypeError(f"{name} is a kernel for kernels only. Call its py_func, or compile it as a `kernel` or `kernel_bare`.")


kernel: Any = _kept(**(_hot | {"_nrt": True}))
"""A kernel that Python or a cold path calls; it may allocate."""

# Without references counted (`_nrt`), records and views of arrays cost nothing to hand around; counting took a third of the
# time of small systems. Such a kernel neither allocates nor gives back an array.

kernel_bare: Any = _kept(**_hot)
"""A kernel that Python and hot loops call; it allocates nothing."""

kernel_inline: Any = _kept(forceinline=True, **_hot, **_inner)
"""A step of a hot loop; as a call it would cost more than it does (records of arrays are passed by value)."""

kernel_inner: Any = _kept(**_hot, **_inner)
"""A kernel that only kernels call: without the wrappers for Python, whose compilation costs more than its own."""

kernel_making: Any = _kept(**(_hot | _inner | {"_nrt": True}))
"""The same for one that allocates."""


def kernel_entry(signature: Any, **options: Any) -> Any:
    """A decorator for a kernel with a C address, compiled at once for one signature; it allocates nothing unless told."""

    def decorated(function: Callable[..., Any]) -> Any:
        args: Any = normalize_signature(signature)
        found: Any = CFunc(function, args, locals={}, options=_hot | options)
        found._cache = Kept(keeper, function)
        found.compile()
        return found

    return decorated
