"""Closed forms of platforms: the double-octahedral bay from angles and height to lengths and back; nodes of a rigid platform.

Lacy (1991), chapter 4. Base triangle N1 N2 N3 of side b about the origin, N3 on +y, z up. N4 swings about edge 3-1,
N5 about 2-3, N6 about 1-2, on the radius rim = sqrt(c^2 - b^2/4), c the cross longeron: N = m + rim (cos t o + sin t z)
with m the middle of the edge and o outward. Top normal u2 = (-sin g, -sin b cos g, cos b cos g); midplane
{r.u = d/2} with u = (z + u2)/|z + u2|, d the distance of the centroids. Lengths in the order M7 = |N4 N5|,
M9 = |N5 N6|, M11 = |N4 N6|.

Quantities are triples (value, first, second derivative in time); the rules below are Leibniz's and the chain rule.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, Floats, Vector

OUT = ((-math.sqrt(3.0) / 2.0, 0.5), (math.sqrt(3.0) / 2.0, 0.5), (0.0, -1.0))  # outward, edges of N4, N5, N6
STEPS = 64  # of the continuation from three equal lengths, at most


@kernel
def _add(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@kernel
def _sub(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@kernel
def _scale(s: float, a: Vector) -> Vector:
    return s * a[0], s * a[1], s * a[2]


@kernel
def _mul(a: Vector, b: Vector) -> Vector:
    return a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + 2.0 * a[1] * b[1] + a[2] * b[0]


@kernel
def _inverse(a: Vector) -> Vector:
    v = 1.0 / a[0]
    d = -v * v * a[1]
    return v, d, -v * (2.0 * d * a[1] + v * a[2])


@kernel
def _sqrt(a: Vector) -> Vector:
    v = math.sqrt(a[0])
    d = 0.5 * a[1] / v
    return v, d, (0.5 * a[2] - d * d) / v


@kernel
def _sin_cos(a: Vector) -> tuple[Vector, Vector]:
    s, c = math.sin(a[0]), math.cos(a[0])
    square = a[1] * a[1]
    return (s, c * a[1], c * a[2] - s * square), (c, -s * a[1], -s * a[2] - c * square)


@kernel
def _mid_node(
    ox: float, oy: float, inner: float, rim: float, ux: Vector, uy: Vector, uz: Vector, half: Vector
) -> tuple[Vector, Vector, float]:
    """Distance from the axis along o, and height, of a mid node; and q^2/(a^2 + B^2), negative if out of reach."""
    along = _add(_scale(ox, ux), _scale(oy, uy))  # o.u
    a, b, c = _scale(rim, along), _scale(rim, uz), _sub(half, _scale(inner, along))
    size = _add(_mul(a, a), _mul(b, b))
    left = _sub(size, _mul(c, c))
    margin = left[0] / size[0]
    if not margin > 0.0:
        return half, half, margin
    q, over = _sqrt(left), _inverse(size)
    cosine = _mul(_add(_mul(a, c), _mul(b, q)), over)
    sine = _mul(_sub(_mul(b, c), _mul(a, q)), over)
    out = _scale(rim, cosine)
    return (out[0] + inner, out[1], out[2]), _scale(rim, sine), margin


@kernel
def _length(e: tuple[float, float], p: Vector, pz: Vector, f: tuple[float, float], r: Vector, rz: Vector) -> Vector:
    """Distance of two mid nodes p e + pz z and r f + rz z."""
    x = _sub(_scale(e[0], p), _scale(f[0], r))
    y = _sub(_scale(e[1], p), _scale(f[1], r))
    z = _sub(pz, rz)
    return _sqrt(_add(_add(_mul(x, x), _mul(y, y)), _mul(z, z)))


@kernel
def _bay_lengths(inner: float, rim: float, beta: Vector, gamma: Vector, height: Vector) -> tuple[Vector, Vector, Vector, float]:
    """Three lengths with two rates of one pose, and the reach margin."""
    (sb, cb), (sg, cg) = _sin_cos(beta), _sin_cos(gamma)
    tilt = _mul(cb, cg)
    over = _inverse(_sqrt((2.0 + 2.0 * tilt[0], 2.0 * tilt[1], 2.0 * tilt[2])))  # 1/|z + u2|
    ux, uy = _scale(-1.0, _mul(sg, over)), _scale(-1.0, _mul(_mul(sb, cg), over))
    uz = _mul((1.0 + tilt[0], tilt[1], tilt[2]), over)
    half = _scale(0.5, height)
    p4, z4, m4 = _mid_node(OUT[0][0], OUT[0][1], inner, rim, ux, uy, uz, half)
    p5, z5, m5 = _mid_node(OUT[1][0], OUT[1][1], inner, rim, ux, uy, uz, half)
    p6, z6, m6 = _mid_node(OUT[2][0], OUT[2][1], inner, rim, ux, uy, uz, half)
    margin = min(m4, min(m5, m6))
    if not margin > 0.0 or not 1.0 + tilt[0] > 0.0:
        return half, half, half, margin
    seven = _length(OUT[0], p4, z4, OUT[1], p5, z5)
    nine = _length(OUT[1], p5, z5, OUT[2], p6, z6)
    eleven = _length(OUT[0], p4, z4, OUT[2], p6, z6)
    return seven, nine, eleven, margin


@kernel
def gimbal_inverse(base: F1, longeron: F1, pose: Floats, lengths: Floats, margin: F2) -> None:
    """Lengths of all bays at all times, with rates and accelerations.

    base, longeron : (n_bays,), m. pose : (n_times, n_bays, 3, 3), beta, gamma (rad), height (m) x value, rate,
    acceleration. Written: lengths (n_times, n_bays, 3, 3), M7, M9, M11 x value, rate, acceleration, NaN out of reach;
    margin (n_times, n_bays), positive within reach.
    """
    n_times, n_bays = pose.shape[0], pose.shape[1]
    # lengths and their two derivatives of each bay at each sample
    for j in range(n_bays):
        inner = base[j] / (2.0 * math.sqrt(3.0))
        rim = math.sqrt(longeron[j] ** 2 - 0.25 * base[j] ** 2)
        for i in range(n_times):
            p = pose[i, j]
            three = _bay_lengths(
                inner,
                rim,
                (p[0, 0], p[0, 1], p[0, 2]),
                (p[1, 0], p[1, 1], p[1, 2]),
                (p[2, 0], p[2, 1], p[2, 2]),
            )
            good = three[3] > 0.0 and p[2, 0] > 0.0
            margin[i, j] = three[3] if p[2, 0] > 0.0 else -1.0  # a bay of no height has collapsed
            for k in range(3):
                lengths[i, j, 0, k] = three[0][k] if good else np.nan
                lengths[i, j, 1, k] = three[1][k] if good else np.nan
                lengths[i, j, 2, k] = three[2][k] if good else np.nan


@kernel
def _node(k: int, t: float, inner: float, rim: float, at: F2) -> None:
    """Place mid node k (0: N4, 1: N5, 2: N6) at swing angle t from outward."""
    out = inner + rim * math.cos(t)
    at[k, 0], at[k, 1], at[k, 2] = out * OUT[k][0], out * OUT[k][1], rim * math.sin(t)


@kernel
def _pair(at: F2, slope: F2, i: int, j: int, square: float) -> Vector:
    """Residual |r_i - r_j|^2 - L^2 and its derivatives by angles i and j."""
    value, by_i, by_j = -square, 0.0, 0.0
    # |r_i - r_j|^2 - L^2 and its derivatives by the two swing angles
    for k in range(3):
        apart = at[i, k] - at[j, k]
        value += apart * apart
        by_i += 2.0 * apart * slope[i, k]
        by_j -= 2.0 * apart * slope[j, k]
    return value, by_i, by_j


@kernel
def _newton(inner: float, rim: float, square_45: float, square_56: float, square_46: float, t: F1, at: F2, slope: F2) -> bool:
    """Swing angles t (3,) of N4, N5, N6 at which they have the given squared distances; True if found nearby.

    One more step follows the first below 1e-8: Newton's method is quadratic, so that one ends at round-off.
    """
    last = False
    # Newton's method for the three swing angles
    for _ in range(20):
        # positions of N4, N5, N6 and their derivatives by the swing angles
        for k in range(3):
            _node(k, t[k], inner, rim, at)
            fall = -rim * math.sin(t[k])
            slope[k, 0], slope[k, 1], slope[k, 2] = fall * OUT[k][0], fall * OUT[k][1], rim * math.cos(t[k])
        r0, a, b = _pair(at, slope, 0, 1, square_45)
        r1, c, d = _pair(at, slope, 1, 2, square_56)
        r2, e, f = _pair(at, slope, 0, 2, square_46)
        # Cramer's rule on [[a, b, 0], [0, c, d], [e, 0, f]]
        det = a * c * f + b * d * e
        if det == 0.0:
            return False
        s4 = (r0 * c * f - b * (r1 * f - d * r2)) / det
        s5 = (a * (r1 * f - d * r2) + r0 * d * e) / det
        s6 = (a * c * r2 + b * e * r1 - c * e * r0) / det
        step = larger(abs(s4), larger(abs(s5), abs(s6)))
        if not step < 0.3:
            return False
        t[0] -= s4
        t[1] -= s5
        t[2] -= s6
        if last:
            return True
        last = step < 1e-8
    return False


@kernel
def _solve(inner: float, rim: float, lengths: F1, t: F1, at: F2, slope: F2) -> bool:
    """Swing angles for three lengths, walked from three equal ones so that the bay stays on its upright branch."""
    s0, s1, s2 = lengths[0] ** 2, lengths[1] ** 2, lengths[2] ** 2
    mean = (s0 + s1 + s2) / 3.0
    cosine = (math.sqrt(mean / 3.0) - inner) / rim
    if not abs(cosine) < 1.0:
        return False
    steps = 1
    # homotopy in the squared lengths from the equilateral bay, with twice the steps where Newton's method fails
    while steps <= STEPS:
        t[:] = math.acos(cosine)
        good = True
        for k in range(1, steps + 1):
            w = k / steps
            x0, x1, x2 = mean + w * (s0 - mean), mean + w * (s1 - mean), mean + w * (s2 - mean)
            if not _newton(inner, rim, x0, x1, x2, t, at, slope):
                good = False
                break
        if good:
            return True
        steps *= 2
    return False


@kernel
def gimbal_forward(base: float, longeron: float, lengths: F2, pose: F2) -> None:
    """Pose from lengths: 3 x 3 Newton on the swing angles of N4, N5, N6, then the plane through the three.

    base, longeron : m. lengths : (n, 3), M7, M9, M11, m. Written: pose (n, 3), beta, gamma (rad), height (m); NaN where
    the lengths cannot be closed.
    """
    inner = base / (2.0 * math.sqrt(3.0))
    rim = math.sqrt(longeron**2 - 0.25 * base**2)
    t, at, slope = np.empty(3), np.empty((3, 3)), np.empty((3, 3))
    # swing angles, then the normal u of the midplane and the pose of the top
    for i in range(lengths.shape[0]):
        if not _solve(inner, rim, lengths[i], t, at, slope):
            pose[i, :] = np.nan
            continue
        for k in range(3):
            _node(k, t[k], inner, rim, at)
        ax, ay, az = at[2, 0] - at[0, 0], at[2, 1] - at[0, 1], at[2, 2] - at[0, 2]
        bx, by, bz = at[1, 0] - at[0, 0], at[1, 1] - at[0, 1], at[1, 2] - at[0, 2]
        nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx  # upwards: N4, N6, N5 go round +z
        size = math.sqrt(nx * nx + ny * ny + nz * nz)
        ux, uy, uz = nx / size, ny / size, nz / size
        # u2 = 2 (u.z) u - z
        side, ahead, up = -2.0 * uz * ux, -2.0 * uz * uy, 2.0 * uz * uz - 1.0
        pose[i, 0] = math.atan2(ahead, up)
        pose[i, 1] = math.atan2(side, math.hypot(ahead, up))
        pose[i, 2] = 2.0 * (ux * at[0, 0] + uy * at[0, 1] + uz * at[0, 2])


# Nodes of a rigid platform whose place and turns are given in time, with two exact rates.
#
# Position of a node: c + p + R s, with the displacement p, R = Rz(yaw) Ry(pitch) Rx(roll) and s its place from the centre c.
# Quantities have their value and two derivatives in time along the first axis; products follow Leibniz's rule.


@kernel_inline
def _turned(axis: int, angle: float, rate: float, second: float, R: Floats, column: F2) -> None:
    """R and its two rates (3, 3, 3) times the rotation about an axis, in place; column (3, 2) is scratch.

    In the columns i, j across the axis [C_i, C_j] becomes [c C_i + s C_j, c C_j - s C_i].
    """
    c, s = math.cos(angle), math.sin(angle)
    c1, s1 = -s * rate, c * rate
    c2, s2 = -c * rate * rate - s * second, c * second - s * rate * rate
    i, j = (axis + 1) % 3, (axis + 2) % 3
    # R and its two derivatives, row by row, times the elementary rotation (Leibniz)
    for row in range(3):
        for order in range(3):
            column[order, 0], column[order, 1] = R[order, row, i], R[order, row, j]
        p, p1, p2, q, q1, q2 = column[0, 0], column[1, 0], column[2, 0], column[0, 1], column[1, 1], column[2, 1]
        R[0, row, i], R[0, row, j] = c * p + s * q, c * q - s * p
        R[1, row, i], R[1, row, j] = c1 * p + c * p1 + s1 * q + s * q1, c1 * q + c * q1 - s1 * p - s * p1
        R[2, row, i] = c2 * p + 2.0 * c1 * p1 + c * p2 + s2 * q + 2.0 * s1 * q1 + s * q2
        R[2, row, j] = c2 * q + 2.0 * c1 * q1 + c * q2 - s2 * p - 2.0 * s1 * p1 - s * p2


@kernel
def platform_motion(centre: F1, arms: F2, motion: Floats, out: Floats) -> None:
    """Fill out (3, times, nodes, dim) with positions (m), velocities and accelerations of nodes at centre + arms (nodes, 3).

    motion (3, times, 6): displacements x, y, z (m) and turns roll, pitch, yaw (rad), with their rates.
    """
    R, column = np.empty((3, 3, 3)), np.empty((3, 2))
    # R = Rz Ry Rx with two derivatives, then c + p + R s and its derivatives
    for i in range(out.shape[1]):
        R[:] = 0.0
        R[0, 0, 0] = R[0, 1, 1] = R[0, 2, 2] = 1.0
        for axis in (2, 1, 0):
            angle, rate, second = motion[0, i, 3 + axis], motion[1, i, 3 + axis], motion[2, i, 3 + axis]
            if angle != 0.0 or rate != 0.0 or second != 0.0:
                _turned(axis, angle, rate, second, R, column)
        for order in range(3):
            for n in range(out.shape[2]):
                for c in range(out.shape[3]):
                    place = motion[order, i, c] + (centre[c] if order == 0 else 0.0)
                    out[order, i, n, c] = (
                        place + R[order, c, 0] * arms[n, 0] + R[order, c, 1] * arms[n, 1] + R[order, c, 2] * arms[n, 2]
                    )
