"""Forces from functions of the user inside compiled code: compiled ones are called directly, Python ones through one callback.

The callback is a symbol of the process that cached code finds by its name, so that no function of Python costs a compilation.
"""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable
from typing import Any

import llvmlite.binding
import numba
import numpy as np
from numba import types
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel, kernel_entry
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.structure.applied import USER_FORCE, call_at, no_force

__all__ = ["call_force", "calling", "compiled_force", "no_force", "python_force"]

_SYMBOL = "kinetruss_python_force"
UserForce = Callable[[float, NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]], None]
_active = threading.local()


@ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_longlong)
def _callback(t: float, x: int, v: int, f: int, size: int) -> None:
    """Hand the vectors on as arrays; the function behind it lets no exception out."""
    vector = ctypes.c_double * size
    _active.force(t, *(np.ctypeslib.as_array(vector.from_address(place)) for place in (x, v, f)))


llvmlite.binding.add_symbol(_SYMBOL, ctypes.cast(_callback, ctypes.c_void_p).value)
_call: Any = types.ExternalFunction(_SYMBOL, types.void(types.float64, types.intp, types.intp, types.intp, types.int64))


@kernel_entry(USER_FORCE, _nrt=True)
def _hand_on(t: float, x: F1, v: F1, f: F1) -> None:
    _call(t, x.ctypes.data, v.ctypes.data, f.ctypes.data, x.size)


python_force: int = _hand_on.address or no_force
"""A user force that calls the function of `calling`."""


@kernel
def call_force(user: int, t: float, x: F1, v: F1, f: F1) -> None:
    """Let the user force at an address add to f (3 n,)."""
    call_at(user, t, x, v, f)


def calling(force: UserForce) -> None:
    """Let `python_force` call force(t, x, v, f) in this thread from now on; it must not raise."""
    _active.force = force


def compiled_force(function: Any) -> Any | None:
    """The function as the integrators take it, or None for a plain Python function.

    Compiled ones are `numba.cfunc` objects of the signature `USER_FORCE`, and functions under `numba.njit`.
    """
    if hasattr(function, "py_func") and hasattr(function, "overloads"):
        return numba.cfunc(USER_FORCE)(function.py_func)
    if hasattr(function, "native_name") and hasattr(function, "address"):
        if function._sig != USER_FORCE:
            raise TypeError(f"a compiled force has the signature {USER_FORCE}, not {function._sig}")
        return function
    return None
