"""How kernels are compiled: kept on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numba
from numba import types
from numba.core.ccallback import CFunc

from kinetruss.kernels.compiled import fields as _fields  # noqa: F401 - teaches kernels to read records
from kinetruss.kernels.compiled.caches import Keeper, Kept, places_of, states_of

try:
    from kinetruss.kernels.compiled import drafts
except Exception:  # noqa: BLE001 - Numba has another inside
    drafts = None  # type: ignore[assignment]

__all__ = ["DRAFTS", "compiled_at_address", "folder", "keeper", "kernel", "kernel_bare", "kernel_entry", "kernel_inline"]

folder = Path(__file__).parents[2]
keeper = Keeper(states_of(folder), places_of(folder / "kernels"), folder)
DRAFTS = drafts is not None and drafts.work()
"""Whether kernels are drafts (kernels.compiled.drafts)."""

config: Any = numba.config
# every option is stated for every kernel: Numba takes one that is not from the kernel that compiles it first
HOT: Any = {"error_model": "numpy", "fastmath": {"contract"}, "_nrt": False, "forceinline": False}


def _kept(**options: Any) -> Any:
    """A decorator that compiles with these options, and keeps what it compiled."""

    def decorated(function: Callable[..., Any]) -> Any:
        if config.DISABLE_JIT:
            return function
        found: Any
        if DRAFTS:
            found = drafts.drafted(function, options, partial(_keep, function))
        else:
            found = numba.njit(nogil=True, **options)(function)
            _keep(function, found, "kernel")
            found.entry = found
        found.get_call_template = partial(_as_called, found.get_call_template)
        found._compile_for_args = partial(_compiled, found._compile_for_args)
        return found

    return decorated


def _keep(function: Callable[..., Any], found: Any, form: str) -> None:
    """Keep what is compiled of a function."""
    found._cache = Kept(keeper, function, form, drafts.rebuilt if DRAFTS else None)


def _as_called(template: Any, args: Any, kws: Any) -> Any:
    """How kernels call a kernel: one form for a number, whether its value is known or not; LLVM passes on those that are."""
    return template(tuple(types.unliteral(one) for one in args), {name: types.unliteral(one) for name, one in kws.items()})


def _compiled(compiling: Callable[..., Any], *args: Any, **kws: Any) -> Any:
    """What Python's first call with such arguments compiles; where that fails, nothing is at work any more."""
    try:
        return compiling(*args, **kws)
    except BaseException:
        keeper.progress.rest()
        raise


# Without references counted (`_nrt`), records and views of arrays cost nothing to hand around; counting took a third of the
# time of small systems. Kernels and Python call all kinds alike.

kernel: Any = _kept(**(HOT | {"_nrt": True}))
"""A kernel that may allocate."""

kernel_bare: Any = _kept(**HOT)
"""A kernel of a hot loop: it neither allocates nor gives back an array."""

kernel_inline: Any = _kept(**(HOT | {"forceinline": True}))
"""A step of a hot loop; as a call it would cost more than it does (records of arrays are passed by value)."""


def compiled_at_address(function: Callable[..., Any], kinds: Any, of: Callable[..., Any], form: str, **options: Any) -> Any:
    """A kernel with a C address, compiled at once for a signature; kept as a form of a function. It allocates if options say
    so.
    """
    found: Any = CFunc(function, (kinds.args, kinds.return_type), locals={}, options=HOT | options)
    _keep(of, found, form)
    found.compile()
    return found


def kernel_entry(kinds: Any, **options: Any) -> Any:
    """A decorator for a kernel with a C address, compiled at once for one signature; it allocates only if options say so."""
    return lambda function: compiled_at_address(function, kinds, function, "kernel", **options)
