"""Applied forces: weight, loads, laws of bars, pins, springs, drives, rods, the user; no inertia, no constraints."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.parts import intrinsic
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.constraints.springs import apply_springs
from kinetruss.kernels.constraints.terms import term_gradient
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.continua import add_continua_forces, add_damping_forces
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.followers import followers
from kinetruss.kernels.structure.laws import add_law_forces
from kinetruss.kernels.structure.mass import add_varying_forces
from kinetruss.kernels.structure.pins import add_pin_forces

__all__ = ["USER_FORCE", "applied", "call_at", "no_force"]

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
def _table(time: F1, value: F1, first: int, last: int, t: float) -> float:
    """Entry of a table at t: linear between, held outside."""
    if t <= time[first] or last - first == 1:
        return value[first]
    if t >= time[last - 1]:
        return value[last - 1]
    low, high = first, last - 1
    # bisection for the interval that holds t
    while high - low > 1:
        middle = (low + high) // 2
        if time[middle] <= t:
            low = middle
        else:
            high = middle
    share = (t - time[low]) / (time[high] - time[low])
    return value[low] + share * (value[high] - value[low])


@kernel
def _add_torque(eq: Equations, first: int, last: int, amount: float, x: F1, f: F1, scratch: F1) -> None:
    """f += amount times the gradient of terms first:last: a couple that follows the bodies."""
    kind, at, data = eq.term_kind, eq.term_at, eq.term_data
    # T dq/dx: g at P, -w1 g and -w2 g at nodes 1 and 2
    for k in range(first, last):
        term_gradient(kind, at, data, k, x, scratch)
        P, one, two = at[k, 0], at[k, 1], at[k, 2]
        for c in range(3):
            force = amount * scratch[c]
            f[P + c] += force
            f[one + c] -= scratch[3] * force
            f[two + c] -= scratch[4] * force


@kernel_late(allocates=True)
def _couples(eq: Equations, t: float, x: F1, f: F1) -> None:
    """Given torques on sums of terms."""
    kind, A, B, ptr = (
        eq.force_kind,
        eq.force_A,
        eq.force_B,
        eq.force_ptr,
    )
    time, value, scratch = eq.force_time, eq.force_value, np.empty(10)
    # torques on sums alone
    for g in range(kind.size):
        if kind[g] == e.SUM_FORCE:
            _add_torque(eq, A[g], B[g], _table(time, value, ptr[g], ptr[g + 1], t), x, f, scratch)


@kernel_bare
def _given(eq: Equations, t: float, x: F1, f: F1) -> None:
    """Given forces: on a coordinate; a thrust between two nodes; a torque on the line between two nodes of a plane."""
    kind, A, B, ptr, time, value = eq.force_kind, eq.force_A, eq.force_B, eq.force_ptr, eq.force_time, eq.force_value
    # F on a coordinate, F u at B and -F u at A of a thrust, T n/L of a torque
    for g in range(kind.size):
        amount = _table(time, value, ptr[g], ptr[g + 1], t)
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
    if eq.pin_P.size:
        add_pin_forces(eq, x, v, f)
    if eq.spring.size:
        apply_springs(eq, x, v, f)
    if eq.force_kind.size:
        _given(eq, t, x, f)
        if eq.term_kind.size:
            _couples(eq, t, x, f)
    if eq.follower_mode.size:
        followers(eq, t, x, f)
    if eq.edge_A.size:
        add_continua_forces(eq, x, f)
    if eq.damp_six_edge.size + eq.damp_eight_edge.size:
        add_damping_forces(eq, x, v, f)
    if user != 0:
        call_at(user, t, x, v, f)
