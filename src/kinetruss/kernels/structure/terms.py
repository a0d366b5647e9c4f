"""Coordinates of several nodes as sums of terms: angles about axes, offsets from lines, lengths, node coordinates,
cosines of scalars.

The gradient of every term is one vector g at a point, taken off two other nodes in shares w1, w2 (1 - s and s, where s is the
share of the axis at which the point stands): dq = g . (dx_P - w1 dx_1 - w2 dx_2). Angle of P about the axis 1 -> 2, with
b = x_2 - x_1, r = x_P - x_1, c = b x r: g = c |b|/|c|^2, s = r . b/|b|^2 (Blondel & Karplus, J. Comput. Chem. 17 (1996) 1132);
the angle between two half-planes is the difference of two such terms. The same shares hold for the offset of a point from a
line.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Vector
from kinetruss.kernels.structure.structure import ALONG, COSINE, FIXED_AXIS, NODE, OFFSET, States


@kernel_bare
def _cross(ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> Vector:
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


@kernel_bare
def _from(x: F1, a: int, b: int) -> Vector:
    return x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]


@kernel_bare
def term_value(kind: I1, at: I2, data: F2, t: int, x: F1) -> float:
    """What term t measures at flat positions x, factor and all; angles in (-pi, pi].

    kind (T,); at (T, 4) flat first coordinates of P, 1, 2 and of the point where an angle about 1 -> 2 begins (-1: the value is
    that of another term); data (T, 7): factor, two unit vectors.
    """
    P, one, two, begin, factor = at[t, 0], at[t, 1], at[t, 2], at[t, 3], data[t, 0]
    if kind[t] == NODE:
        return factor * (data[t, 1] * x[P] + data[t, 2] * x[P + 1] + data[t, 3] * x[P + 2])
    if kind[t] == COSINE:
        return factor * math.cos(x[P] + data[t, 1])
    rx, ry, rz = _from(x, one, P)
    if kind[t] == ALONG:
        return factor * math.sqrt(rx * rx + ry * ry + rz * rz)
    if kind[t] == FIXED_AXIS:
        c = data[t, 1] * rx + data[t, 2] * ry + data[t, 3] * rz
        s = data[t, 4] * rx + data[t, 5] * ry + data[t, 6] * rz
        return factor * math.atan2(s, c)
    bx, by, bz = _from(x, one, two)
    size = math.sqrt(bx * bx + by * by + bz * bz)
    if kind[t] == OFFSET:
        return factor * (bx * ry - by * rx) / size
    if begin < 0:
        return 0.0
    qx, qy, qz = _cross(bx, by, bz, rx, ry, rz)
    fx, fy, fz = _from(x, one, begin)
    px, py, pz = _cross(bx, by, bz, fx, fy, fz)
    sx, sy, sz = _cross(px, py, pz, qx, qy, qz)
    return factor * math.atan2((bx * sx + by * sy + bz * sz) / size, px * qx + py * qy + pz * qz)


@kernel_bare
def term_gradient(kind: I1, at: I2, data: F2, t: int, x: F1, out: F1) -> None:
    """g times the factor, and w1, w2 of term t at x into out[:5]."""
    P, one, two, factor = at[t, 0], at[t, 1], at[t, 2], data[t, 0]
    out[3], out[4] = 1.0, 0.0
    if kind[t] == NODE:
        out[0], out[1], out[2], out[3] = factor * data[t, 1], factor * data[t, 2], factor * data[t, 3], 0.0
        return
    if kind[t] == COSINE:
        out[0], out[1], out[2], out[3] = -factor * math.sin(x[P] + data[t, 1]), 0.0, 0.0, 0.0
        return
    rx, ry, rz = _from(x, one, P)
    if kind[t] == ALONG:
        scale = factor / math.sqrt(rx * rx + ry * ry + rz * rz)
        out[0], out[1], out[2] = scale * rx, scale * ry, scale * rz
        return
    if kind[t] == FIXED_AXIS:
        c = data[t, 1] * rx + data[t, 2] * ry + data[t, 3] * rz
        s = data[t, 4] * rx + data[t, 5] * ry + data[t, 6] * rz
        scale = factor / (c * c + s * s)
        # atan2(s, c): (c ds - s dc)/(c^2 + s^2)
        for k in range(3):
            out[k] = scale * (c * data[t, 4 + k] - s * data[t, 1 + k])
        return
    bx, by, bz = _from(x, one, two)
    square = bx * bx + by * by + bz * bz
    share = (rx * bx + ry * by + rz * bz) / square
    out[3], out[4] = 1.0 - share, share
    if kind[t] == OFFSET:
        scale = factor / math.sqrt(square)
        out[0], out[1], out[2] = -scale * by, scale * bx, 0.0
        return
    cx, cy, cz = _cross(bx, by, bz, rx, ry, rz)
    scale = factor * math.sqrt(square) / (cx * cx + cy * cy + cz * cz)
    out[0], out[1], out[2] = scale * cx, scale * cy, scale * cz


@kernel_bare
def term_rates(kind: I1, at: I2, data: F2, t: int, x: F1, v: F1, out: F1) -> None:
    """As `term_gradient` into out[:5], and how fast these change at velocities v into out[5:10]."""
    term_gradient(kind, at, data, t, x, out)
    # g' and the rates of w1, w2: zero where the gradient is constant
    for k in range(5, 10):
        out[k] = 0.0
    if kind[t] == NODE:
        return
    P, one, two, factor = at[t, 0], at[t, 1], at[t, 2], data[t, 0]
    if kind[t] == COSINE:
        out[5] = -factor * math.cos(x[P] + data[t, 1]) * v[P]
        return
    rx, ry, rz = _from(x, one, P)
    ex, ey, ez = _from(v, one, P)
    if kind[t] == ALONG:
        square = rx * rx + ry * ry + rz * rz
        scale, along = factor / math.sqrt(square), (rx * ex + ry * ey + rz * ez) / square
        out[5], out[6], out[7] = scale * (ex - along * rx), scale * (ey - along * ry), scale * (ez - along * rz)
        return
    if kind[t] == FIXED_AXIS:
        c = data[t, 1] * rx + data[t, 2] * ry + data[t, 3] * rz
        s = data[t, 4] * rx + data[t, 5] * ry + data[t, 6] * rz
        cd = data[t, 1] * ex + data[t, 2] * ey + data[t, 3] * ez
        sd = data[t, 4] * ex + data[t, 5] * ey + data[t, 6] * ez
        square = c * c + s * s
        # derivative in time of (c e_s - s e_c)/(c^2 + s^2), e_c and e_s the fixed unit vectors
        for k in range(3):
            out[5 + k] = (
                factor * (cd * data[t, 4 + k] - sd * data[t, 1 + k]) / square - 2.0 * (c * cd + s * sd) / square * out[k]
            )
        return
    bx, by, bz = _from(x, one, two)
    dx, dy, dz = _from(v, one, two)
    square = bx * bx + by * by + bz * bz
    dilation = (bx * dx + by * dy + bz * dz) / square
    shift = (ex * bx + ey * by + ez * bz + rx * dx + ry * dy + rz * dz) / square - 2.0 * out[4] * dilation
    out[8], out[9] = -shift, shift
    if kind[t] == OFFSET:
        scale = factor / math.sqrt(square)
        out[5], out[6] = -scale * (dy - dilation * by), scale * (dx - dilation * bx)
        return
    cx, cy, cz = _cross(bx, by, bz, rx, ry, rz)
    px, py, pz = _cross(dx, dy, dz, rx, ry, rz)
    qx, qy, qz = _cross(bx, by, bz, ex, ey, ez)
    px, py, pz = px + qx, py + qy, pz + qz
    around = cx * cx + cy * cy + cz * cz
    size, turn = math.sqrt(square), dilation - 2.0 * (cx * px + cy * py + cz * pz) / around
    scale = factor * size / around
    out[5], out[6], out[7] = scale * (px + turn * cx), scale * (py + turn * cy), scale * (pz + turn * cz)


@kernel_bare
def term_along(at: I2, t: int, out: F1, y: F1) -> float:
    """g . (y_P - w1 y_1 - w2 y_2) of term t whose gradient is in out."""
    P, one, two, total = at[t, 0], at[t, 1], at[t, 2], 0.0
    # dq = g . (y_P - w1 y_1 - w2 y_2)
    for k in range(3):
        total += out[k] * (y[P + k] - out[3] * y[one + k] - out[4] * y[two + k])
    return total


@kernel_bare
def term_second(kind: I1, at: I2, data: F2, t: int, x: F1, v: F1, out: F1) -> float:
    """The second rate of term t at velocities v, without accelerations."""
    term_rates(kind, at, data, t, x, v, out)
    P, one, two, total = at[t, 0], at[t, 1], at[t, 2], 0.0
    # J' v: rate of g along v, and of the shares w1, w2
    for k in range(3):
        total += out[5 + k] * (v[P + k] - out[3] * v[one + k] - out[4] * v[two + k])
        total -= out[k] * (out[8] * v[one + k] + out[9] * v[two + k])
    return total


@kernel
def term_gradients(kind: I1, at: I2, data: F2, t: int, x: F2, out: F2) -> None:
    """g, w1 and w2 of term t, factor and all, along x (times, 3 n) into out (times, 5)."""
    for i in range(x.shape[0]):
        term_gradient(kind, at, data, t, x[i], out[i])


@kernel
def nearest_turn(gap: float, period: float) -> float:
    """A difference of values that are the same after every period (0: that never are), taken the shortest way."""
    return gap - period * math.floor(gap / period + 0.5) if period > 0.0 else gap


@kernel
def measure_value(kind: I1, at: I2, data: F2, first: int, last: int, x: F1) -> float:
    """The sum of terms first:last at flat positions x."""
    total = 0.0
    # q = sum of the terms
    for t in range(first, last):
        total += term_value(kind, at, data, t, x)
    return total


@kernel
def measure_gradient(kind: I1, at: I2, data: F2, first: int, last: int, x: F1, out: F1, scratch: F1) -> None:
    """The gradient of terms first:last at x, added to out (3 n,); scratch (10,)."""
    # dq/dx: g at P, -w1 g and -w2 g at nodes 1 and 2
    for t in range(first, last):
        term_gradient(kind, at, data, t, x, scratch)
        for k in range(3):
            out[at[t, 0] + k] += scratch[k]
            out[at[t, 1] + k] -= scratch[3] * scratch[k]
            out[at[t, 2] + k] -= scratch[4] * scratch[k]


@kernel
def measure_rates(kind: I1, at: I2, data: F2, first: int, last: int, states: States, out: F2, scratch: F1) -> None:
    """Value (angles between jumps), rate, second rate of terms first:last along states into out (times, 3); scratch (10,)."""
    x, v, a = states
    # q, q' = J v, q'' = J a + J' v at each sample
    for i in range(x.shape[0]):
        value, rate, second = 0.0, 0.0, 0.0
        for t in range(first, last):
            value += term_value(kind, at, data, t, x[i])
            second += term_second(kind, at, data, t, x[i], v[i], scratch)
            rate += term_along(at, t, scratch, v[i])
            second += term_along(at, t, scratch, a[i])
        out[i, 0], out[i, 1], out[i, 2] = value, rate, second
