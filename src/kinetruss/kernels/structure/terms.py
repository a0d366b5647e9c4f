"""Coordinates of several nodes as sums of terms, each of one of the kinds of kernels.coordinates.forms.

A term t has the flat first coordinates of its nodes P, 1, 2, B in at[t] (those that it does not read repeat another), its
factor and six numbers in data[t], and the addresses of its value, gradient and rates in form[t].
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.calls import caller
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1, I2
from kinetruss.kernels.coordinates.straight_line import GRADIENT, RATES, SECOND, VALUE
from kinetruss.kernels.structure.structure import States

_value, _gradient, _rates, _second = (caller(one) for one in (VALUE, GRADIENT, RATES, SECOND))


@kernel_inline
def term_value(form: I2, at: I2, data: F2, t: int, x: F1) -> float:
    """What term t measures at flat positions x, factor and all; angles in (-pi, pi]."""
    found: float = _value(form[t, 0], (at[t], data[t], x))
    return found


@kernel_inline
def term_gradient(form: I2, at: I2, data: F2, t: int, x: F1, out: F1) -> None:
    """The gradient of term t at x by its four nodes into out[:12], factor and all."""
    _gradient(form[t, 1], (at[t], data[t], x, out))


@kernel_inline
def term_rates(form: I2, at: I2, data: F2, t: int, x: F1, v: F1, out: F1) -> None:
    """As `term_gradient`, and how fast it changes at velocities v, the Hessian times v, into out[12:24]."""
    _rates(form[t, 2], (at[t], data[t], x, v, out))


@kernel_bare
def term_along(at: I2, t: int, out: F1, y: F1) -> float:
    """The gradient of term t, which is in out[:12], times y."""
    total = 0.0
    # dq = sum over the nodes of g_n . y_n
    for n in range(4):
        a = at[t, n]
        total += out[3 * n] * y[a] + out[3 * n + 1] * y[a + 1] + out[3 * n + 2] * y[a + 2]
    return total


@kernel_bare
def add_term(at: I2, t: int, out: F1, amount: float, f: F1) -> None:
    """f += amount times the gradient of term t, which is in out[:12]."""
    for n in range(4):
        a = at[t, n]
        for c in range(3):
            f[a + c] += amount * out[3 * n + c]


@kernel_bare
def term_second(form: I2, at: I2, data: F2, t: int, x: F1, v: F1, out: F1) -> float:
    """The second rate of term t at velocities v, without accelerations: v . H v. out (24,) : as `term_rates`."""
    term_rates(form, at, data, t, x, v, out)
    total = 0.0
    for n in range(4):
        a = at[t, n]
        total += out[12 + 3 * n] * v[a] + out[13 + 3 * n] * v[a + 1] + out[14 + 3 * n] * v[a + 2]
    return total


@kernel
def term_gradients(form: I2, at: I2, data: F2, t: int, x: F2, out: F2) -> None:
    """The gradient of term t along x (times, 3 n) into out (times, 12)."""
    for i in range(x.shape[0]):
        term_gradient(form, at, data, t, x[i], out[i])


@kernel
def nearest_turn(gap: float, period: float) -> float:
    """A difference of values that are the same after every period (0: that never are), taken the shortest way."""
    return gap - period * math.floor(gap / period + 0.5) if period > 0.0 else gap


@kernel
def measure_value(form: I2, at: I2, data: F2, first: int, last: int, x: F1) -> float:
    """The sum of terms first:last at flat positions x."""
    total = 0.0
    # q = sum of the terms
    for t in range(first, last):
        total += term_value(form, at, data, t, x)
    return total


@kernel
def measure_gradient(form: I2, at: I2, data: F2, first: int, last: int, x: F1, out: F1, scratch: F1) -> None:
    """The gradient of terms first:last at x, added to out (3 n,); scratch (24,)."""
    # dq/dx
    for t in range(first, last):
        term_gradient(form, at, data, t, x, scratch)
        add_term(at, t, scratch, 1.0, out)


@kernel
def measure_turning(form: I2, at: I2, data: F2, first: int, last: int, x: F1, v: F1, out: F1, scratch: F1) -> None:
    """The Hessian of terms first:last at x times v, added to out (3 n,); scratch (24,)."""
    for t in range(first, last):
        term_rates(form, at, data, t, x, v, scratch)
        add_term(at, t, scratch[12:], 1.0, out)


@kernel
def measure_second(second: I1, at: I2, data: F2, first: int, last: int, state: States, out: F2, scratch: F1) -> None:
    """First and second rate of the gradient of terms first:last at x, v, a, added to out (2, 3 n); scratch (36,)."""
    x, v, a = state
    for t in range(first, last):
        _second(second[t], (at[t], data[t], x, v, a, scratch))
        add_term(at, t, scratch[12:], 1.0, out[0])
        add_term(at, t, scratch[24:], 1.0, out[1])


@kernel
def measure_rates(form: I2, at: I2, data: F2, first: int, last: int, states: States, out: F2, scratch: F1) -> None:
    """Value (angles between jumps), rate, second rate of terms first:last along states into out (times, 3); scratch (24,)."""
    x, v, a = states
    # q, q' = J v, q'' = J a + v . H v at each sample
    for i in range(x.shape[0]):
        value, rate, second = 0.0, 0.0, 0.0
        for t in range(first, last):
            value += term_value(form, at, data, t, x[i])
            second += term_second(form, at, data, t, x[i], v[i], scratch)
            rate += term_along(at, t, scratch, v[i])
            second += term_along(at, t, scratch, a[i])
        out[i, 0], out[i, 1], out[i, 2] = value, rate, second
