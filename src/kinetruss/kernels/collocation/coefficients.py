"""Algebra of the Radau IIA method of order 5: coefficients, eigenvectors, error weights, size of the next step.

Three stages at the nodes c of the Radau quadrature, the last at the end of the step (Hairer & Wanner, Solving Ordinary
Differential Equations II, 2nd ed., 1996, table IV.5.6 and section IV.8). Nothing here knows any equation.

A has one real eigenvalue and two conjugate ones. With pi(c) = (c - c_1)(c - c_2)(c - c_3) an eigenvector has the entries
pi'(c_i) + lambda pi''(c_i) + lambda^2 pi'''(c_i): the polynomial q of degree 2 whose integral from 0 is lambda q at the nodes.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel_inline

__all__ = ["A", "AA", "C", "E", "EA", "EAA", "LEFT", "NODES", "REAL", "RIGHT", "TURNED", "smaller_step", "step_behind"]

_ROOT = math.sqrt(6.0)
C = NODES = np.array([(4.0 - _ROOT) / 10.0, (4.0 + _ROOT) / 10.0, 1.0])
"""Places of the stages in a step."""
A = np.array(
    [
        [(88.0 - 7.0 * _ROOT) / 360.0, (296.0 - 169.0 * _ROOT) / 1800.0, (-2.0 + 3.0 * _ROOT) / 225.0],
        [(296.0 + 169.0 * _ROOT) / 1800.0, (88.0 + 7.0 * _ROOT) / 360.0, (-2.0 - 3.0 * _ROOT) / 225.0],
        [(16.0 - _ROOT) / 36.0, (16.0 + _ROOT) / 36.0, 1.0 / 9.0],
    ]
)
"""V_i = v + h sum A_ij a_j."""
AA = A @ A
"""X_i = x + c_i h v + h^2 sum AA_ij a_j."""

_P, _Q = 81.0 ** (1.0 / 3.0), 9.0 ** (1.0 / 3.0)
REAL = (6.0 + _P - _Q) / 30.0
"""The real eigenvalue of A."""
TURNED = complex((12.0 - _P + _Q) / 60.0, (_P + _Q) * math.sqrt(3.0) / 60.0)
"""One of the two others."""


def _eigenvectors() -> NDArray[np.complex128]:
    """Columns: eigenvectors of A to REAL, TURNED and its conjugate."""
    pi = np.polynomial.Polynomial.fromroots(C)
    first, second, third = (pi.deriv(k)(C) for k in (1, 2, 3))
    return np.stack([first + z * second + z * z * third for z in (REAL, TURNED, TURNED.conjugate())], axis=1)


def _inverse(S: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """The inverse of a 3 x 3 matrix by its cofactors."""
    rows = np.stack([np.cross(S[:, (k + 1) % 3], S[:, (k + 2) % 3]) for k in range(3)])
    inverse: NDArray[np.complex128] = rows / (rows[0] @ S[:, 0])
    return inverse


_S = _eigenvectors()
_L = _inverse(_S)
RIGHT = np.ascontiguousarray(np.stack([_S[:, 0].real, 2.0 * _S[:, 1].real, -2.0 * _S[:, 1].imag], axis=1))
"""Stages from the parts w of the real eigenvector and p + i q of the other: w RIGHT[:, 0] + p RIGHT[:, 1] + q RIGHT[:, 2]."""
LEFT = np.ascontiguousarray(np.stack([_L[0].real, _L[1].real, _L[1].imag]))
"""The parts w, p and q from the stages."""

E = REAL / 3.0 * np.array([-13.0 - 7.0 * _ROOT, -13.0 + 7.0 * _ROOT, -1.0])
"""Weights of the stages less the start in the error of order 3, beside REAL h f(start) (Hairer & Wanner II, eq. IV.8.20)."""
EA = E @ A
"""The same weights of h a_j in the velocities."""
EAA = E @ AA
"""The same weights of h^2 a_j in the places; what the start contributes cancels."""

SAFETY, SHRINK, GROW = 0.9, 0.2, 8.0
MOST = 10
"""Turns of Newton's method after which SAFETY is halved, nearly."""


@kernel_inline
def smaller_step(h: float, error: float) -> float:
    """Size of the next try of a step with an error beyond 1: the estimate is of order 4."""
    return h * max(SHRINK, SAFETY * error**-0.25)


@kernel_inline
def step_behind(h: float, error: float, h_old: float, error_old: float, iterations: int) -> float:
    """Size of the step after one that is accepted: by its error, and by how errors have changed (Gustafsson's predictive
    controller, Hairer & Wanner II, eq. IV.8.25). iterations : of Newton's method. h_old : 0 where no step is known before.
    """
    safety = SAFETY * (2.0 * MOST + 1.0) / (2.0 * MOST + iterations)
    error = max(error, 1e-10)
    factor = safety * error**-0.25
    if h_old > 0.0:
        factor = min(factor, SAFETY * h / h_old * (error_old / (error * error)) ** 0.25)
    return h * min(GROW, max(SHRINK, factor))
