"""Programs of tasks: results against NumPy, Taylor coefficients and gradients against differences."""

from __future__ import annotations

import numpy as np
import pytest

from kinetruss.kernels.coordinates import tape as kernel
from kinetruss.kernels.coordinates.programs import Program, angle, cross, dot, minus, root, size, unit


def _made():
    """A program with every operation, and the same function in NumPy."""
    program = Program()
    a, b, c = (program.node(i, 3) for i in range(3))
    n = cross(minus(b, a), minus(c, a))
    program.result(angle(n[0], n[2]) + dot(unit(n), c) * 0.3)
    program.result(root(dot(a, a) + 2.0) / size(minus(b, c)) - program.parameter())

    def function(x, p):
        a, b, c = x.reshape(3, 3)
        n = np.cross(b - a, c - a)
        length = np.sqrt(n @ n)
        two = np.sqrt(a @ a + 2.0) / np.sqrt((b - c) @ (b - c)) - p
        # the angle of a complex argument: by its logarithm
        return np.array([-1j * np.log((n[2] + 1j * n[0]) / np.sqrt(n[0] ** 2 + n[2] ** 2)) + n @ c / length * 0.3, two])

    return kernel.tape_of(program, 2), function


def _series(tape, X, P):
    T = np.zeros((3, len(tape.op)))
    for k in range(3):
        kernel.forward(tape, X, P, k, T)
    return T


@pytest.mark.parametrize("seed", range(5))
def test_values_gradients_and_series(seed):
    rng = np.random.default_rng(seed)
    tape, function = _made()
    X, P = rng.normal(size=(3, 9)), rng.normal(size=(3, 1))
    T = _series(tape, X, P)
    assert T[0, tape.out] == pytest.approx(function(X[0] + 0j, P[0, 0]).real, abs=1e-13)
    # Taylor coefficients against differences of the function along the path
    h = 1e-3
    path = [
        function(X[0] + t * X[1] + t * t * X[2] + 0j, P[0, 0] + t * P[1, 0] + t * t * P[2, 0]).real
        for t in (-2 * h, -h, 0, h, 2 * h)
    ]
    first = (path[0] - 8 * path[1] + 8 * path[3] - path[4]) / (12 * h)
    second = (-path[0] + 16 * path[1] - 30 * path[2] + 16 * path[3] - path[4]) / (24 * h * h)
    assert T[1, tape.out] == pytest.approx(first, rel=1e-7, abs=1e-7)
    assert T[2, tape.out] == pytest.approx(second, rel=1e-4, abs=1e-4)


@pytest.mark.parametrize("seed", range(5))
def test_one_pass_back_gives_the_gradient_and_its_series(seed):
    rng = np.random.default_rng(seed)
    tape, _ = _made()
    X, P, s = rng.normal(size=(3, 9)), rng.normal(size=(3, 1)), rng.normal(size=(3, 2))
    T, B, G = _series(tape, X, P), np.zeros((3, len(tape.op))), np.zeros((3, 9))
    for j in range(2):
        B[:, tape.out[j]] += s[:, j]
    kernel.backward(tape, 2, T, B, np.zeros_like(B), G)
    # coefficient k of the gradient of s . c by x is the derivative of coefficient 2 of s . c by coefficient 2 - k of x
    for c in range(9):
        for k in range(3):
            pair = []
            for sign in (1, -1):
                Y = X.copy()
                Y[2 - k, c] += sign * 1e-6
                U = _series(tape, Y, P)[:, tape.out]
                pair.append(sum(s[i] @ U[2 - i] for i in range(3)))
            assert G[k, c] == pytest.approx((pair[0] - pair[1]) / 2e-6, rel=2e-6, abs=2e-7)
