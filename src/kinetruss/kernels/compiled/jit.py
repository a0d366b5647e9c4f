"""How kernels are compiled: kept on disk, IEEE division, fused multiply-add allowed, nothing reordered."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from inspect import signature
from pathlib import Path
from typing import Any

import numba
from numba import types
from numba.core.ccallback import CFunc
from numba.core.sigutils import normalize_signature

from kinetruss.kernels.compiled import fields as _fields  # noqa: F401 - teaches kernels to read records
from kinetruss.kernels.compiled.caches import Keeper, Kept, places_of, states_of
from kinetruss.kernels.compiled.drafts import DraftCompiler

__all__ = ["DRAFT", "HOT", "as_called", "folder", "keeper", "kernel", "kernel_bare", "kernel_entry", "kernel_inline"]

folder = Path(__file__).parents[2]
keeper = Keeper(states_of(folder), places_of(folder / "kernels"), folder)

# every option is stated for every kernel: Numba takes one that is not from the kernel that compiles it first
HOT: Any = {"error_model": "numpy", "fastmath": {"contract"}, "_nrt": False, "forceinline": False}
DRAFT: Any = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "pipeline_class": DraftCompiler}


def _kept(**options: Any) -> Any:
    """A decorator that compiles with these options, and keeps what it compiled."""

    def decorated(function: Callable[..., Any]) -> Any:
        found = numba.njit(nogil=True, **options, **DRAFT)(function)
        if found is not function:  # else compiling is switched off (NUMBA_DISABLE_JIT)
            found._cache = Kept(keeper, function)
            found.get_call_template = partial(as_called, found.get_call_template)
            found.entry = None
            found._compile_for_args = partial(_entered, found, found._insert, partial(_entry, found, function, options))
            found._insert = _nothing  # a draft has no address that Python could call
        return found

    return decorated


def as_called(template: Any, args: Any, kws: Any) -> Any:
    """How kernels call a kernel: one form for a number, whether its value is known or not; LLVM passes on those that are."""
    return template(tuple(types.unliteral(one) for one in args), {name: types.unliteral(one) for name, one in kws.items()})


def _entry(found: Any, function: Callable[..., Any], options: dict[str, Any]) -> Any:
    """What Python calls instead of a kernel: the call of it, compiled as a whole."""
    given, names = ", ".join(signature(function).parameters), {"kernel": found, "__name__": function.__module__}
    exec(f"def {function.__name__}({given}): return kernel({given})", names)  # noqa: S102 - Numba folds no *arguments
    made: Any = numba.njit(nogil=True, **options)(names[function.__name__])
    made._cache = Kept(keeper, function, "entry")
    return made


def _entered(found: Any, insert: Callable[..., None], entry: Callable[[], Any], *args: Any) -> Any:
    """The compiled entry of a kernel for these arguments; the next call with such finds it by itself."""
    found.entry = found.entry or entry()
    form = found.entry._compile_for_args(*args)
    insert([found.typeof_pyval(one)._code for one in args], form, False)
    return form


def _nothing(*_: Any) -> None:
    """No entry for Python."""


# Without references counted (`_nrt`), records and views of arrays cost nothing to hand around; counting took a third of the
# time of small systems. Kernels and Python call all kinds alike.

kernel: Any = _kept(**(HOT | {"_nrt": True}))
"""A kernel that may allocate."""

kernel_bare: Any = _kept(**HOT)
"""A kernel of a hot loop: it neither allocates nor gives back an array."""

kernel_inline: Any = _kept(**(HOT | {"forceinline": True}))
"""A step of a hot loop; as a call it would cost more than it does (records of arrays are passed by value)."""


def kernel_entry(kinds: Any, **options: Any) -> Any:
    """A decorator for a kernel with a C address, compiled at once for one signature; it allocates only if options say so."""

    def decorated(function: Callable[..., Any]) -> Any:
        args: Any = normalize_signature(kinds)
        found: Any = CFunc(function, args, locals={}, options=HOT | options)
        found._cache = Kept(keeper, function)
        found.compile()
        return found

    return decorated
