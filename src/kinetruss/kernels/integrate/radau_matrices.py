"""Radau IIA of order 5: its coefficients, and the matrices of Newton's method, one real and one complex, both L D L^T.

Three stages at the nodes c of the Radau quadrature, the last at the end of the step (Hairer & Wanner, Solving Ordinary
Differential Equations II, 2nd ed., 1996, table IV.5.6 and section IV.8). Nothing here knows any equation.

A has one real eigenvalue and two conjugate ones. With pi(c) = (c - c_1)(c - c_2)(c - c_3) an eigenvector has the entries
pi'(c_i) + lambda pi''(c_i) + lambda^2 pi'''(c_i): the polynomial q of degree 2 whose integral from 0 is lambda q at the nodes.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.record import F1, F2, Record, record
from kinetruss.kernels.integrate.state import Control
from kinetruss.kernels.integrate.tangent import tangent_fill
from kinetruss.kernels.solve.kkt import prepare_rows, row_gradients
from kinetruss.kernels.solve.ldl import ldl_factor, ldl_solve
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import law_slopes, length_rate

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


# The matrices of Newton's method, in the pattern of integrate.tangent: one real, one complex, both L D L^T.
#
# Stages hold a = F(x, v), F the accelerations that the equations give. With K and C, the slopes of forces by places and rates,
# and an eigenvalue l of the coefficients, the change of the part w of the stages follows from
#
#     [[M + h l C + (h l)^2 K, J^T], [J, 0]] [w; n] = -[M r; J r]
#
# where r is the part of the residuals a - F. Left out are the slopes of J and of velocity terms: they are as slow as the
# motion.
#
# Tensions S of bars with a law are unknowns of their own, with the residuals q = S - N(L, L'): then a stiff bar may turn in the
# step, while S slaved to N would change its direction by its whole stiffness. With the gradient G of the lengths, and k and c
# the slopes of N, what is added on the right is G^T q, and S changes by -q + (k (h l)^2 + c h l) G w.

RE, IM = TURNED.real, TURNED.imag
RE2, IM2 = (TURNED * TURNED).real, (TURNED * TURNED).imag


@record
class Matrices(Record):
    """Values in the pattern, lower triangle and diagonal: mass : M and J. stiff : K. damp : C. real, complex_ : factors of the
    real and of the complex matrix. b, d (n,), z : vectors in the order of the pattern. In complex_ and z each imaginary part
    follows its real part. u (3, laws), slope (2, laws) : of bars with a law directions, dN/dL (N/m) and dN/dL' (N s/m).
    """

    mass: F1
    stiff: F1
    damp: F1
    real: F1
    complex_: F1
    b: F1
    z: F1
    d: F1
    u: F2
    slope: F2


_, INTEGERS, REALS = Matrices.COUNT


@kernel
def new_matrices(control: Control, laws: int) -> Matrices:
    """Work for the matrices of a pattern and of so many bars with a law."""
    values, n = control.values.size, control.space.size
    # in the order of the fields
    one = (values, 1)
    shapes = (one, one, one, one, (2 * values, 1), (n, 1), (2 * n, 1), (n, 1), (3, laws), (2, laws))
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    return Matrices(ints, reals)


@kernel_bare
def matrices_at(eq: Equations, ws: Workspace, control: Control, t: float, x: F1, v: F1, N: F1, own: Matrices) -> None:
    """M, J, K and C at t, x, v with the row forces N."""
    prepare_rows(eq, ws, t, x, v)
    row_gradients(eq, ws, x)
    mass, stiff, damp = own.mass, own.stiff, own.damp
    tangent_fill(eq, ws, control, x, v, N, (0.0, 0.0), mass)
    tangent_fill(eq, ws, control, x, v, N, (1.0, 0.0), stiff)
    tangent_fill(eq, ws, control, x, v, N, (0.0, 1.0), damp)
    # K and C alone: the matrices with a factor 1 less M and J
    for i in range(mass.size):
        stiff[i] -= mass[i]
        damp[i] -= mass[i]
    # G, dN/dL and dN/dL' of bars with a law
    for k in range(eq.law_A.size):
        L, u, Ld = length_rate(x, v, eq.law_A[k], eq.law_B[k])
        own.u[0, k], own.u[1, k], own.u[2, k] = u
        own.slope[0, k], own.slope[1, k] = law_slopes(eq, k, L, Ld)


@kernel_bare
def factor_both(control: Control, h: float, own: Matrices) -> None:
    """Factor the real and the complex matrix of a step h (s)."""
    mass, stiff, damp, real, turned = own.mass, own.stiff, own.damp, own.real, own.complex_
    r, rr, p, q, pp, qq = h * REAL, (h * REAL) ** 2, h * RE, h * IM, h * h * RE2, h * h * IM2
    # M + h l C + (h l)^2 K, l real, and the real and imaginary part with l complex
    for i in range(mass.size):
        real[i] = mass[i] + r * damp[i] + rr * stiff[i]
        turned[2 * i] = mass[i] + p * damp[i] + pp * stiff[i]
        turned[2 * i + 1] = q * damp[i] + qq * stiff[i]
    ldl_factor(control.ptr, control.below, control.target, real)
    ldl_factor(control.ptr, control.below, control.target, turned.view(np.complex128))


@kernel_bare
def _times(control: Control, value: F1, y: F1, share: float, vector: F1, out: F1) -> None:
    """out += share times a matrix of the pattern times y (nf,); vector (n,), scratch."""
    ptr, below, place = control.ptr, control.below, control.place
    entries = below.size
    for j in range(vector.size):
        vector[j] = 0.0
    for i in range(y.size):
        vector[place[i]] = share * y[i]
    for j in range(vector.size):
        z, total = vector[j], value[entries + j] * vector[j]
        for k in range(ptr[j], ptr[j + 1]):
            total += value[k] * vector[below[k]]
            out[below[k]] += value[k] * z
        out[j] += total


@kernel_bare
def _add_tensions(eq: Equations, control: Control, own: Matrices, q: F1, out: F1) -> None:
    """out += G^T q."""
    local, place, u = eq.local, control.place, own.u
    for k in range(q.size):
        for c in range(3):
            i, j = local[eq.law_A[k] + c], local[eq.law_B[k] + c]
            if i >= 0:
                out[place[i]] -= u[c, k] * q[k]
            if j >= 0:
                out[place[j]] += u[c, k] * q[k]


@kernel_inline
def _elongation(eq: Equations, own: Matrices, k: int, w: F1) -> float:
    """G w of bar k."""
    local, total = eq.local, 0.0
    for c in range(3):
        i, j = local[eq.law_A[k] + c], local[eq.law_B[k] + c]
        total += own.u[c, k] * ((w[j] if j >= 0 else 0.0) - (w[i] if i >= 0 else 0.0))
    return total


@kernel_bare
def solve_both(eq: Equations, control: Control, h: float, own: Matrices, r: F2, q: F2) -> None:
    """Replace the residuals r (3, nf) and q (3, laws), one of the real part and both of the complex part, by the changes."""
    place, b, d, z = control.place, own.b, own.d, own.z
    for j in range(b.size):
        b[j] = 0.0
    _times(control, own.mass, r[0], -1.0, d, b)
    _add_tensions(eq, control, own, q[0], b)
    ldl_solve(control.ptr, control.below, control.target, own.real, b)
    for i in range(place.size):
        r[0, i] = b[place[i]]
    for k in range(2):
        for j in range(b.size):
            b[j] = 0.0
        _times(control, own.mass, r[1 + k], -1.0, d, b)
        _add_tensions(eq, control, own, q[1 + k], b)
        for j in range(b.size):
            z[2 * j + k] = b[j]
    ldl_solve(control.ptr, control.below, control.target, own.complex_.view(np.complex128), z.view(np.complex128))
    for i in range(place.size):
        r[1, i], r[2, i] = z[2 * place[i]], z[2 * place[i] + 1]
    # S changes by (k (h l)^2 + c h l) G w - q
    for k in range(q.shape[1]):
        stiffness, damping = h * h * own.slope[0, k], h * own.slope[1, k]
        re, im = stiffness * RE2 + damping * RE, stiffness * IM2 + damping * IM
        x, y, z = _elongation(eq, own, k, r[0]), _elongation(eq, own, k, r[1]), _elongation(eq, own, k, r[2])
        q[0, k] = (stiffness * REAL * REAL + damping * REAL) * x - q[0, k]
        q[1, k], q[2, k] = re * y - im * z - q[1, k], re * z + im * y - q[2, k]


@kernel_bare
def filtered(control: Control, own: Matrices, h: float, ex: F1, ev: F1) -> None:
    """Replace errors ex (nf,) of places and ev (nf,) of velocities by (1 - g Jacobian)^-1 of them, g = h REAL.

    (M + g C + g^2 K) dv + J^T n = M ev - g K ex, J dv = J ev, dx = ex + g dv: what stiff parts forget at once counts little.
    """
    g, place, b = h * REAL, control.place, own.b
    if place.size > 0:
        for j in range(b.size):
            b[j] = 0.0
        _times(control, own.mass, ev, 1.0, own.d, b)
        _times(control, own.stiff, ex, -g, own.d, b)
        ldl_solve(control.ptr, control.below, control.target, own.real, b)
        for i in range(ev.size):
            ev[i] = b[place[i]]
    # dx = ex + g dv
    for i in range(ex.size):
        ex[i] += g * ev[i]
