"""Beams: elements whose energy is a function of scalar products of differences of their nodes (kernels.structure.beam_law).

The nodes of a beam give the chord and the axes of both ends, vectors that are linear in positions, and these the scalar
products z. Deformations m(z) with rigidities R have the forces S = R (m + b m') with a damping time b, and the nodes those
of g = S dm/dz on z: as z is bilinear, its gradient B is linear in positions and its second derivative constant.

Tangent: B^T (dm/dz^T R dm/dz + S d2m/dz2) B + sum g_i d2z_i, the last a number times the identity between two nodes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.compiled.calls import caller
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Floats, Record, record
from kinetruss.kernels.structure import element_table
from kinetruss.kernels.structure.beam_law import PLANE, PULL, RATES, SPACE, VALUE

if TYPE_CHECKING:
    from numpy.typing import NDArray

_value, _pull, _rates = (caller(one) for one in (VALUE, PULL, RATES))


@record
class BeamTable(Record):
    """law (3,) addresses of the deformations, their derivatives and the rates of these (kernels.structure.beam_law).

    at (k, v) flat nodes: origin and axes of the first frame, then of the second; start (k, 3 v) their places without stress, m;
    axes (k, 2 dim dim) coefficients, 1/m, of the nodes of both frames, from their origins, in the local axes 1, 2 (, 3);
    data (k, 5) : length, m, shares of bending in the slope about 3 and 2, E I3/(G J), E I2/(G J); rigidity (k, s) N m; damping
    (k,) s.
    """

    law: I1
    at: I2
    start: F2
    axes: F2
    data: F2
    rigidity: F2
    damping: F1


@kernel_bare
def _take(at: I1, x: F1, out: F2) -> None:
    """Chord, and nodes of frames from their origins, of positions or velocities x: (v, 3), nothing at the second origin."""
    half = at.size // 2
    for c in range(3):
        out[0, c] = x[at[half] + c] - x[at[0] + c]
    for n in range(1, at.size):
        if n != half:
            o = at[0] if n < half else at[half]
            for c in range(3):
                out[n, c] = x[at[n] + c] - x[o + c]


@kernel_inline
def _moved(a: float, b: float, a0: float, b0: float) -> float:
    """(a - b) - (a0 - b0) with the errors of both differences (Knuth): all digits of small displacements and of near nodes."""
    d, d0 = a - b, a0 - b0
    t, t0 = d - a, d0 - a0
    return (d - d0) + (((a - (d - t)) - (b + t)) - ((a0 - (d0 - t0)) - (b0 + t0)))


@kernel_bare
def _from_start(at: I1, x: F1, start: F1, out: F2) -> None:
    """How far these have changed from the start."""
    half = at.size // 2
    for c in range(3):
        out[0, c] = _moved(x[at[half] + c], x[at[0] + c], start[3 * half + c], start[c])
    for n in range(1, at.size):
        if n != half:
            o = 0 if n < half else half
            for c in range(3):
                out[n, c] = _moved(x[at[n] + c], x[at[o] + c], start[3 * n + c], start[3 * o + c])


@kernel_bare
def _vectors(axes: F1, half: int, y: F2, out: F2) -> None:
    """Chord and axes of both ends from the differences y (2 half, 3) of `_take`."""
    dim = half - 1
    for c in range(3):
        out[0, c] = y[0, c]
    # axis i of end e: sum of coefficients times the places from the origin
    for e in range(2):
        o = e * half
        for i in range(dim):
            row, at = 1 + e * dim + i, (e * dim + i) * dim
            for c in range(3):
                total = 0.0
                for n in range(dim):
                    total += axes[at + n] * y[o + 1 + n, c]
                out[row, c] = total


@kernel_bare
def _onto_nodes(axes: F1, half: int, push: F2, factor: float, out: F2) -> None:
    """factor times the transpose of `_vectors` and `_take` on push into out (2 half, 3)."""
    dim = half - 1
    for c in range(3):
        out[half, c] = factor * push[0, c]
        out[0, c] = -out[half, c]
    for e in range(2):
        o = e * half
        for n in range(dim):
            for c in range(3):
                out[o + 1 + n, c] = 0.0
        for i in range(dim):
            row, at = 1 + e * dim + i, (e * dim + i) * dim
            for n in range(dim):
                for c in range(3):
                    amount = factor * axes[at + n] * push[row, c]
                    out[o + 1 + n, c] += amount
                    out[o, c] -= amount


@kernel_bare
def _changed(base: F2, now: F2, change: F2, i: int, j: int) -> float:
    """now_i . now_j - base_i . base_j with now = base + change."""
    total = 0.0
    for c in range(3):
        total += change[i, c] * now[j, c] + base[i, c] * change[j, c]
    return total


@kernel_bare
def _products(dim: int, l: float, base: F2, now: F2, change: F2, z: F1) -> None:
    """z of vectors `now`, less that of `base`, which differ by `change`; rates of z, where base is now and change are rates."""
    p, q = 1, 1 + dim
    z[0] = 0.5 * _changed(base, now, change, 0, 0) / (l * l)
    z[1] = -0.5 * (_changed(base, now, change, p + 1, 0) + _changed(base, now, change, q + 1, 0)) / l
    z[2] = 0.5 * (_changed(base, now, change, p + 1, q) - _changed(base, now, change, p, q + 1))
    z[3] = 0.0
    for i in range(dim):
        z[3] -= 0.5 * _changed(base, now, change, p + i, q + i)
    if dim == 3:
        z[4] = 0.5 * (_changed(base, now, change, p + 2, 0) + _changed(base, now, change, q + 2, 0)) / l
        z[5] = 0.5 * (_changed(base, now, change, p + 2, q + 1) - _changed(base, now, change, p + 1, q + 2))
        z[6] = 0.5 * (_changed(base, now, change, p, q + 2) - _changed(base, now, change, p + 2, q))


@kernel_bare
def _onto_vectors(dim: int, l: float, g: F1, now: F2, push: F2) -> None:
    """Derivatives of sum g z by the vectors, at the vectors `now`, into push: linear in both."""
    p, q = 1, 1 + dim
    for c in range(3):
        along = now[0, c] / (2.0 * l)
        y = now[p + 1, c] + now[q + 1, c]
        push[0, c] = g[0] * now[0, c] / (l * l) - g[1] * y / (2.0 * l)
        # E, a3, s3, 1 - C
        push[p, c] = -0.5 * (g[2] * now[q + 1, c] + g[3] * now[q, c])
        push[q, c] = 0.5 * (g[2] * now[p + 1, c] - g[3] * now[p, c])
        push[p + 1, c] = 0.5 * (g[2] * now[q, c] - g[3] * now[q + 1, c]) - g[1] * along
        push[q + 1, c] = -0.5 * (g[2] * now[p, c] + g[3] * now[p + 1, c]) - g[1] * along
        if dim == 3:
            # a2, s1, s2
            push[0, c] += g[4] * (now[p + 2, c] + now[q + 2, c]) / (2.0 * l)
            push[p, c] += 0.5 * g[6] * now[q + 2, c]
            push[q, c] -= 0.5 * g[6] * now[p + 2, c]
            push[p + 1, c] -= 0.5 * g[5] * now[q + 2, c]
            push[q + 1, c] += 0.5 * g[5] * now[p + 2, c]
            push[p + 2, c] = 0.5 * (g[5] * now[q + 1, c] - g[6] * now[q, c] - g[3] * now[q + 2, c]) + g[4] * along
            push[q + 2, c] = 0.5 * (g[6] * now[p, c] - g[5] * now[p + 1, c] - g[3] * now[p + 2, c]) + g[4] * along


@kernel_bare
def _state(s: BeamTable, k: int, x: F1, y: F2, now: F2, change: F2, base: F2, z: F1, m: F1) -> None:
    """Vectors of beam k at x and at the start, scalar products and deformations; y : scratch for nodes."""
    half = s.at.shape[1] // 2
    _take(s.at[k], x, y)
    _vectors(s.axes[k], half, y, now)
    _from_start(s.at[k], x, s.start[k], y)
    _vectors(s.axes[k], half, y, change)
    for i in range(2 * half - 1):
        for c in range(3):
            base[i, c] = now[i, c] - change[i, c]
    _products(half - 1, s.data[k, 0], base, now, change, z)
    _value(s.law[0], (z, s.data[k], m))


@kernel_bare
def _deformation_rates(s: BeamTable, k: int, v: F1, y: F2, now: F2, change: F2, z: F1, m: F1, rate: F1, out: F1) -> None:
    """m' of beam k at velocities v into out[2 z.size:]; rate : scratch for z'."""
    half = s.at.shape[1] // 2
    _take(s.at[k], v, y)
    _vectors(s.axes[k], half, y, change)
    _products(half - 1, s.data[k, 0], now, now, change, rate)
    _rates(s.law[2], (z, s.data[k], m, rate, out))


@kernel_bare
def _push(s: BeamTable, k: int, g: F1, now: F2, change: F2, y: F2, factor: float, f: F1) -> None:
    """f += factor times the derivative of sum g z of beam k by its nodes, at the vectors now; change, y : scratch."""
    half = s.at.shape[1] // 2
    _onto_vectors(half - 1, s.data[k, 0], g, now, change)
    _onto_nodes(s.axes[k], half, change, factor, y)
    for n in range(2 * half):
        for c in range(3):
            f[s.at[k, n] + c] += y[n, c]


@kernel
def force(s: BeamTable, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    modes = s.rigidity.shape[1]
    y, now, change, base = np.empty((8, 3)), np.empty((7, 3)), np.empty((7, 3)), np.empty((7, 3))
    z, g, rate, m, out = np.empty(SPACE), np.empty(SPACE), np.empty(SPACE), np.empty(6), np.empty(2 * SPACE + 6)
    for k in range(s.at.shape[0]):
        _state(s, k, x, y, now, change, base, z, m)
        b = s.damping[k]
        if b > 0.0:
            _deformation_rates(s, k, v, y, now, change, z, m, rate, out)
            # S = R (m + b m')
            first = 2 * (PLANE if modes == 3 else SPACE)
            for i in range(modes):
                m[i] += b * out[first + i]
        for i in range(modes):
            m[i] *= s.rigidity[k, i]
        _pull(s.law[1], (z, s.data[k], m, g))
        _push(s, k, g, now, change, y, -1.0, f)


@kernel
def energy(s: BeamTable, x: F1) -> float:
    """As kernels.structure.element_table.energy."""
    y, now, change, base = np.empty((8, 3)), np.empty((7, 3)), np.empty((7, 3)), np.empty((7, 3))
    z, m, total = np.empty(SPACE), np.empty(6), 0.0
    # R m^2/2
    for k in range(s.at.shape[0]):
        _state(s, k, x, y, now, change, base, z, m)
        for i in range(s.rigidity.shape[1]):
            total += 0.5 * s.rigidity[k, i] * m[i] * m[i]
    return total


@kernel
def balance(s: BeamTable, t: float, x: F1, v: F1, out: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.balance."""
    modes = s.rigidity.shape[1]
    y, now, change, base = np.empty((8, 3)), np.empty((7, 3)), np.empty((7, 3)), np.empty((7, 3))
    z, rate, m, found = np.empty(SPACE), np.empty(SPACE), np.empty(6), np.empty(2 * SPACE + 6)
    first = 2 * (PLANE if modes == 3 else SPACE)
    # R m^2/2, R m m', b R m'^2
    for k in range(s.at.shape[0]):
        _state(s, k, x, y, now, change, base, z, m)
        _deformation_rates(s, k, v, y, now, change, z, m, rate, found)
        for i in range(modes):
            R, speed = s.rigidity[k, i], found[first + i]
            out[0] += 0.5 * R * m[i] * m[i]
            out[1] += R * m[i] * speed
            out[2] += s.damping[k] * R * speed * speed


@kernel
def deformations(s: BeamTable, x: F1, out: F2, gradients: Floats) -> None:
    """Deformations of every beam at x (3 n,) into out (k, s); into gradients (k, s, 3 v), if it has room, those by nodes."""
    v = s.at.shape[1]
    half = v // 2
    y, now, change, base = np.empty((8, 3)), np.empty((7, 3)), np.empty((7, 3)), np.empty((7, 3))
    z, g, unit = np.empty(SPACE), np.empty(SPACE), np.zeros(6)
    for k in range(s.at.shape[0]):
        _state(s, k, x, y, now, change, base, z, out[k])
        for i in range(min(s.rigidity.shape[1], gradients.size)):
            unit[i] = 1.0
            _pull(s.law[1], (z, s.data[k], unit, g))
            unit[i] = 0.0
            _onto_vectors(half - 1, s.data[k, 0], g, now, change)
            _onto_nodes(s.axes[k], half, change, 1.0, y)
            for n in range(v):
                for c in range(3):
                    gradients[k, i, 3 * n + c] = y[n, c]


@kernel
def blocks(s: BeamTable, x: F1, S: F2, R: F2, beta: float, gamma: float, out: Floats) -> None:
    """Tangents (k, 3 v, 3 v) of every beam at x (3 n,) into out: R (k, s) B^T B of the deformations' gradients B, and forces
    S (k, s) of deformations times their second derivatives; where S is empty beta K + gamma C of the beams at rest.
    """
    beams, v = s.at.shape
    modes, half = s.rigidity.shape[1], v // 2
    count, w = PLANE if modes == 3 else SPACE, 3 * v
    y, now, change, base = np.empty((8, 3)), np.empty((7, 3)), np.empty((7, 3)), np.empty((7, 3))
    z, m, unit, found = np.empty(SPACE), np.empty(6), np.zeros(SPACE), np.empty(2 * SPACE + 6)
    force, stiff = np.empty(6), np.empty(6)
    J, H = np.empty((modes, count)), np.empty((count, count))
    B, BH, g = np.empty((count, w)), np.empty((count, w)), np.empty(SPACE)
    for k in range(beams):
        _state(s, k, x, y, now, change, base, z, m)
        for i in range(modes):
            if S.size == 0:
                force[i] = beta * s.rigidity[k, i] * m[i]
                stiff[i] = (beta + gamma * s.damping[k]) * s.rigidity[k, i]
            else:
                force[i], stiff[i] = S[k, i], R[k, i]
        # by z: first and second derivatives, a column at a time
        for j in range(count):
            unit[j] = 1.0
            _rates(s.law[2], (z, s.data[k], force, unit, found))
            for i in range(count):
                H[i, j] = found[count + i]
            for i in range(modes):
                J[i, j] = found[2 * count + i]
            # the gradient of z_j
            _onto_vectors(half - 1, s.data[k, 0], unit, now, change)
            _onto_nodes(s.axes[k], half, change, 1.0, y)
            for n in range(v):
                for c in range(3):
                    B[j, 3 * n + c] = y[n, c]
            unit[j] = 0.0
        for i in range(count):
            g[i] = found[i]
            for j in range(count):
                for a in range(modes):
                    H[i, j] += stiff[a] * J[a, i] * J[a, j]
        for i in range(count):
            for c in range(w):
                total = 0.0
                for j in range(count):
                    total += H[i, j] * B[j, c]
                BH[i, c] = total
        for a in range(w):
            for c in range(a + 1):
                total = 0.0
                for i in range(count):
                    total += B[i, a] * BH[i, c]
                out[k, a, c] = out[k, c, a] = total
        # sum g_i d2z_i: its columns are the derivatives at unit nodes, three at a time
        for first in range(0, v, 3):
            for n in range(v):
                o = 0 if n < half else half
                for c in range(3):
                    y[n, c] = (1.0 if n == first + c else 0.0) - (1.0 if o == first + c else 0.0)
            for c in range(3):
                y[0, c] = (1.0 if half == first + c else 0.0) - (1.0 if first + c == 0 else 0.0)
            _vectors(s.axes[k], half, y, base)
            _onto_vectors(half - 1, s.data[k, 0], g, base, change)
            _onto_nodes(s.axes[k], half, change, 1.0, y)
            for n in range(v):
                for b in range(min(3, v - first)):
                    for c in range(3):
                        out[k, 3 * n + c, 3 * (first + b) + c] += y[n, b]


@kernel
def tangent(s: BeamTable, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.tangent; without what the rates add to K."""
    w = 3 * s.at.shape[1]
    own, found = np.empty((0, 0)), np.empty((s.at.shape[0], w, w))
    blocks(s, x, own, own, beta, gamma, found)
    for k in range(s.at.shape[0]):
        for i in range(w):
            for j in range(i + 1):
                value[at[k, w * i + j]] += found[k, i, j]


@kernel
def swap(s: BeamTable, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.swap: the gradient by z in the middle of both z, changed along the stiffest of them so
    that its product with their change is that of the energy (O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449-467).

    z is quadratic in positions, so its gradient in the middle of the step times x1 - x0 is its change.
    """
    modes = s.rigidity.shape[1]
    count = PLANE if modes == 3 else SPACE
    y, now, change, base = np.empty((8, 3)), np.empty((7, 3)), np.empty((7, 3)), np.empty((7, 3))
    z0, z1, g, own = np.empty(SPACE), np.empty(SPACE), np.empty(SPACE), np.empty(SPACE)
    m0, m1, z, m = np.empty(6), np.empty(6), np.empty(SPACE), np.empty(6)
    for k in range(s.at.shape[0]):
        _state(s, k, x0, y, now, change, base, z0, m0)
        _state(s, k, x1, y, now, change, base, z1, m1)
        _state(s, k, xe, y, now, change, base, z, m)
        gain = 0.0
        # R (m1^2 - m0^2)/2, and forces at xe
        for i in range(modes):
            R = s.rigidity[k, i]
            gain += 0.5 * R * (m1[i] + m0[i]) * (m1[i] - m0[i])
            m[i] *= R
        _pull(s.law[1], (z, s.data[k], m, own))
        for i in range(count):
            z[i] = 0.5 * (z0[i] + z1[i])
        _value(s.law[0], (z, s.data[k], m))
        for i in range(modes):
            m[i] *= s.rigidity[k, i]
        _pull(s.law[1], (z, s.data[k], m, g))
        # what is lacking, along the change of z, each weighted by its stiffness: of E that of e, of the others that of bending
        size, EI = 0.0, s.rigidity[k, 1]
        for i in range(3, modes):
            EI = max(EI, s.rigidity[k, i])
        for i in range(count):
            weight = s.rigidity[k, 0] if i == 0 else EI
            d = z1[i] - z0[i]
            gain -= g[i] * d
            size += weight * d * d
        for i in range(count):
            weight = s.rigidity[k, 0] if i == 0 else EI
            if size > 0.0:
                g[i] += gain * weight * (z1[i] - z0[i]) / size
            g[i] -= own[i]
        _push(s, k, g, now, change, y, -1.0, f)


KERNELS = dict(enumerate(zip(element_table.INTERFACES, (force, energy, balance, tangent, swap), strict=True)))
"""By column of the table of kinds: interface and kernel."""


def coordinates(s: BeamTable) -> NDArray[np.int64]:
    """Coordinates (k, 3 v) of the nodes of the beams."""
    return (s.at[:, :, None] + np.arange(3)).reshape(len(s.at), -1)


def loses(s: BeamTable) -> bool:
    """Whether some beams have damping."""
    return bool((s.damping > 0.0).any())
