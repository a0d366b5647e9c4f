"""Applied forces: weight, loads on nodes and bodies, laws of bars, pins, springs, drives, rods, functions of the user."""

from __future__ import annotations

import ctypes
import math
import threading
from collections.abc import Callable
from typing import Any

import llvmlite.binding
import numba
import numpy as np
from llvmlite import ir
from numba import types
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_entry
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.compiled.views import intrinsic
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.element_table import element_forces, forces_of
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.laws import add_law_forces
from kinetruss.kernels.structure.mass import add_varying_forces
from kinetruss.kernels.structure.sums import sum_torques
from kinetruss.kernels.structure.tables import entry_at

_vector = types.float64[::1]
USER_FORCE = types.void(types.float64, _vector, _vector, _vector)
"""Signature of a user force: (t, x, v, f), flat over 3 node + axis; it adds to f."""


no_force = 0
"""A user force that adds nothing. Kernels take user forces as addresses: an object would cost more than a short run."""


@intrinsic
def call_at(typing_context: Any, address: Any, t: Any, x: Any, v: Any, f: Any) -> Any:  # noqa: ARG001
    """Call the compiled function of the signature `USER_FORCE` at an address."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kinds = [context.get_value_type(one) for one in signature.args[1:]]
        function = ir.FunctionType(ir.VoidType(), kinds)
        builder.call(builder.inttoptr(args[0], function.as_pointer()), args[1:])
        return context.get_dummy_value()

    return types.void(types.int64, *USER_FORCE.args), codegen


@kernel_bare
def _given(eq: Equations, t: float, x: F1, f: F1) -> None:
    """Given forces: on a coordinate; a thrust between two nodes; a torque on the line between two nodes of a plane."""
    kind, A, B, ptr, time, value = eq.force_kind, eq.force_A, eq.force_B, eq.force_ptr, eq.force_time, eq.force_value
    # F on a coordinate, F u at B and -F u at A of a thrust, T n/L of a torque
    for g in range(kind.size):
        amount = entry_at(time, value, ptr[g], ptr[g + 1], t)
        a, b = A[g], B[g]
        if kind[g] == e.COORDINATE_FORCE:
            f[a] += amount
            continue
        if kind[g] == e.SUM_FORCE:
            continue
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        square = dx * dx + dy * dy + dz * dz
        if kind[g] == e.ANGLE_FORCE:
            dx, dy, dz = -dy, dx, 0.0
            amount /= square
        else:
            amount /= math.sqrt(square)
        f[a] -= amount * dx
        f[a + 1] -= amount * dy
        f[a + 2] -= amount * dz
        f[b] += amount * dx
        f[b + 1] += amount * dy
        f[b + 2] += amount * dz


@kernel_bare
def applied(eq: Equations, user: int, t: float, x: F1, v: F1, f: F1) -> None:
    """The right-hand side f(t, x, v) of M a + J^T N = f over all coordinates into f (3 n,), N; user : address of a force."""
    constant = eq.constant
    # weight and constant forces
    for c in range(f.size):
        f[c] = constant[c]
    if eq.varying_A.size:
        add_varying_forces(eq, eq.gravity, x, v, f)
    if eq.law_A.size:
        add_law_forces(eq, x, v, f)
    element_forces(eq, t, x, v, f)
    if eq.force_kind.size:
        _given(eq, t, x, f)
        if eq.sums.size:
            sum_torques(eq, t, x, f)
    forces_of(eq.load, eq.load_ints, eq.load_reals, t, x, v, f)
    if user != 0:
        call_at(user, t, x, v, f)


# Forces from functions of the user inside compiled code: compiled ones are called directly, Python ones through one callback.
#
# The callback is a symbol of the process that cached code finds by its name, so that no function of Python costs a compilation.

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
