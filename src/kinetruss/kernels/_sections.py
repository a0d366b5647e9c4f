"""Section forces inside straight members, in closed form.

Every part of a member (a bar; the base or the tube of an active member) carries T and V quadratic and M cubic in the
fraction xi = (distance from the part's end towards A)/(length of the part). The force S and moment M are those that the
B-side part exerts on the A-side part; b = a - g is what the mass resists. With m the mass, l the length and i the rotary
inertia of the part:

    bar and base, from A:   S(xi) = -F_A + m int_0^xi b dxi,    M(0) = 0
    base beyond the nut:    S(xi) = -m int_xi^1 b dxi,          M(1) = 0
    tube, from B:           S(xi) = F_B - m int_xi^1 b dxi,     M(1) = 0
    everywhere:             dM/dxi = -l u x S + i u x u''

Along a bar b = b_A + xi (a_B - a_A); along the base b = b_A + s u''; along the tube b = b_B - s' u'', s' from B.
Source: free bodies of Lacy (1991, chapters 2 and 4), with the acceleration of the moving rods written out.

The loops are written out in one function: handing arrays to a helper at every member costs more than the arithmetic.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels._jit import kernel, kernel_inline

__all__ = [
    "COEFFICIENTS", "WHOLE", "evaluate_sections", "member_axes", "section_forces", "section_polynomials",
    "start_references",
]  # fmt: skip

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]

COEFFICIENTS = 17
"""Numbers a segment: T 0:3, V2 3:6, V3 6:9, M2 9:13, M3 13:17, ascending powers of xi."""

WHOLE = 2.0
"""Place of the nut in a part without one: beyond every xi."""

_BATCHED = 1024  # parts and samples a batch of coefficients, so that it stays in the second-level cache


def start_references(x0: Floats, p: Ints, q: Ints) -> Floats:
    """Reference directions (m, 3) of the member axes: z, or x for members within 18 deg of z at the positions x0 (n, dim)."""
    reference = np.zeros((len(p), 3))
    if x0.shape[1] == 2:
        return reference
    d = x0[q] - x0[p]
    upright = np.abs(d[:, 2]) > 0.95 * np.linalg.norm(d, axis=1)
    reference[:, 2] = ~upright
    reference[:, 0] = upright
    return reference


@kernel_inline
def _axes(planar: bool, ux: float, uy: float, uz: float, hx: float, hy: float, hz: float) -> Any:
    """Axes 2 and 3: in the plane 3 = z, 2 = 3 x 1; in space 3 = u x h normalised, 2 = 3 x 1."""
    if planar:
        return -uy, ux, 0.0, 0.0, 0.0, 1.0
    zx, zy, zz = uy * hz - uz * hy, uz * hx - ux * hz, ux * hy - uy * hx
    size = zx * zx + zy * zy + zz * zz
    # a member swinging exactly through its reference direction has no such plane: take the axis it is farthest from
    if size <= 1e-18 * (hx * hx + hy * hy + hz * hz):
        if abs(ux) <= abs(uy) and abs(ux) <= abs(uz):
            zx, zy, zz = 0.0, uz, -uy
        elif abs(uy) <= abs(uz):
            zx, zy, zz = -uz, 0.0, ux
        else:
            zx, zy, zz = uy, -ux, 0.0
        size = zx * zx + zy * zy + zz * zz
    size = 1.0 / size**0.5
    zx, zy, zz = zx * size, zy * size, zz * size
    return zy * uz - zz * uy, zz * ux - zx * uz, zx * uy - zy * ux, zx, zy, zz


@kernel
def member_axes(position: Floats, p: Ints, q: Ints, orient: Ints, reference: Floats, out: Floats) -> None:
    """Local axes 1, 2, 3 of every member as rows of out (t, m, 3, 3), from position (t, n, dim).

    orient (m,): node that spans plane 1-2 with the member, or -1; reference (m, 3): direction where there is none.
    """
    planar = position.shape[2] == 2
    for i in range(position.shape[0]):
        for k in range(p.shape[0]):
            a, b, o = p[k], q[k], orient[k]
            dx, dy = position[i, b, 0] - position[i, a, 0], position[i, b, 1] - position[i, a, 1]
            dz, hx, hy, hz = 0.0, reference[k, 0], reference[k, 1], reference[k, 2]
            if not planar:
                dz = position[i, b, 2] - position[i, a, 2]
                if o >= 0:
                    hx, hy = position[i, o, 0] - position[i, a, 0], position[i, o, 1] - position[i, a, 1]
                    hz = position[i, o, 2] - position[i, a, 2]
            L = (dx * dx + dy * dy + dz * dz) ** 0.5
            ux, uy, uz = dx / L, dy / L, dz / L
            yx, yy, yz, zx, zy, zz = _axes(planar, ux, uy, uz, hx, hy, hz)
            out[i, k, 0, 0], out[i, k, 0, 1], out[i, k, 0, 2] = ux, uy, uz
            out[i, k, 1, 0], out[i, k, 1, 1], out[i, k, 1, 2] = yx, yy, yz
            out[i, k, 2, 0], out[i, k, 2, 1], out[i, k, 2, 2] = zx, zy, zz


@kernel
def section_polynomials(
    position: Floats, velocity: Floats, acceleration: Floats, joint_force: Floats, gravity: Floats,
    p: Ints, q: Ints, two_rods: Flags, rods: Floats, orient: Ints, reference: Floats, coef: Floats, nut: Floats,
) -> None:  # fmt: skip
    """Coefficients of all parts into coef (t, parts, 2, 17) and the nut's xi into nut (t, parts).

    Segment 0 holds up to the nut and segment 1 beyond it; only the base of an active member has a second one (elsewhere
    nut = 2 and segment 1 is left as it is). The arguments are those of `section_forces`.
    """
    planar = position.shape[2] == 2
    for i in range(position.shape[0]):
        part = 0
        for k in range(p.shape[0]):
            a, b, o = p[k], q[k], orient[k]
            dx, dy, dz = position[i, b, 0] - position[i, a, 0], position[i, b, 1] - position[i, a, 1], 0.0
            ax, ay, az = acceleration[i, a, 0], acceleration[i, a, 1], 0.0
            ex, ey, ez = acceleration[i, b, 0] - ax, acceleration[i, b, 1] - ay, 0.0
            fx, fy, fz = joint_force[i, k, 0, 0], joint_force[i, k, 0, 1], 0.0
            hx, hy, hz = reference[k, 0], reference[k, 1], reference[k, 2]
            ax, ay = ax - gravity[0], ay - gravity[1]
            if not planar:
                dz, az = position[i, b, 2] - position[i, a, 2], acceleration[i, a, 2]
                ez = acceleration[i, b, 2] - az
                az -= gravity[2]
                fz = joint_force[i, k, 0, 2]
                if o >= 0:
                    hx, hy = position[i, o, 0] - position[i, a, 0], position[i, o, 1] - position[i, a, 1]
                    hz = position[i, o, 2] - position[i, a, 2]
            L = (dx * dx + dy * dy + dz * dz) ** 0.5
            r = 1.0 / L
            ux, uy, uz = dx * r, dy * r, dz * r
            yx, yy, yz, zx, zy, zz = _axes(planar, ux, uy, uz, hx, hy, hz)

            # member axes from here on: b, e = a_B - a_A, w = u'' (zero where it is not needed)
            b1, b2, b3 = ax * ux + ay * uy + az * uz, ax * yx + ay * yy + az * yz, ax * zx + ay * zy + az * zz
            e1, e2, e3 = ex * ux + ey * uy + ez * uz, ex * yx + ey * yy + ez * yz, ex * zx + ey * zy + ez * zz
            w1 = w2 = w3 = 0.0
            active = two_rods[k]
            if active or rods[k, 2] != 0.0:
                vx, vy, vz = velocity[i, b, 0] - velocity[i, a, 0], velocity[i, b, 1] - velocity[i, a, 1], 0.0
                if not planar:
                    vz = velocity[i, b, 2] - velocity[i, a, 2]
                v1 = vx * ux + vy * uy + vz * uz
                v2, v3 = (vx * yx + vy * yy + vz * yz) * r, (vx * zx + vy * zy + vz * zz) * r
                w1, w2, w3 = -(v2 * v2 + v3 * v3), (e2 - 2 * v1 * v2) * r, (e3 - 2 * v1 * v3) * r

            # segment 0: from A
            m, span, rotary = rods[k, 0], L, rods[k, 2]
            f1, f2, f3 = fx * ux + fy * uy + fz * uz, fx * yx + fy * yy + fz * yz, fx * zx + fy * zy + fz * zz
            t0, t1, t2 = -f1, m * b1, 0.5 * m * e1
            p0, p1, p2 = -f2, m * b2, 0.5 * m * e2
            s0, s1, s2 = -f3, m * b3, 0.5 * m * e3
            nut[i, part] = WHOLE
            if active:
                span = rods[k, 1]
                t2, p2, s2 = 0.5 * m * span * w1, 0.5 * m * span * w2, 0.5 * m * span * w3
                nut[i, part] = (L - rods[k, 4]) / span
            for segment in range(3 if active else 1):
                if segment == 1:  # base beyond the nut: nothing pulls at xi = 1
                    t0, p0, s0 = -t1 - t2, -p1 - p2, -s1 - s2
                elif segment == 2:  # tube, written from xi = 1 back
                    m, span, rotary = rods[k, 3], rods[k, 4], rods[k, 5]
                    fx, fy, fz = joint_force[i, k, 1, 0], joint_force[i, k, 1, 1], 0.0
                    if not planar:
                        fz = joint_force[i, k, 1, 2]
                    f1, f2, f3 = fx * ux + fy * uy + fz * uz, fx * yx + fy * yy + fz * yz, fx * zx + fy * zy + fz * zz
                    t2, p2, s2 = 0.5 * m * span * w1, 0.5 * m * span * w2, 0.5 * m * span * w3
                    t1, p1, s1 = m * (b1 + e1) - 2 * t2, m * (b2 + e2) - 2 * p2, m * (b3 + e3) - 2 * s2
                    t0, p0, s0 = f1 - t1 - t2, f2 - p1 - p2, f3 - s1 - s2
                    part += 1
                    nut[i, part] = WHOLE
                m1, m2, m3 = span * s0 - rotary * w3, 0.5 * span * s1, span * s2 * (1 / 3)
                n1, n2, n3 = rotary * w2 - span * p0, -0.5 * span * p1, -span * p2 * (1 / 3)
                j = 1 if segment == 1 else 0
                coef[i, part, j, 0], coef[i, part, j, 1], coef[i, part, j, 2] = t0, t1, t2
                coef[i, part, j, 3], coef[i, part, j, 4], coef[i, part, j, 5] = p0, p1, p2
                coef[i, part, j, 6], coef[i, part, j, 7], coef[i, part, j, 8] = s0, s1, s2
                coef[i, part, j, 9] = 0.0 if segment == 0 else -(m1 + m2 + m3)
                coef[i, part, j, 10], coef[i, part, j, 11], coef[i, part, j, 12] = m1, m2, m3
                coef[i, part, j, 13] = 0.0 if segment == 0 else -(n1 + n2 + n3)
                coef[i, part, j, 14], coef[i, part, j, 15], coef[i, part, j, 16] = n1, n2, n3
            part += 1


@kernel
def evaluate_sections(coef: Floats, nut: Floats, xi: Floats, T: Floats, V: Floats, M: Floats) -> None:
    """T (t, parts, stations), V and M (t, parts, stations, 2 in space or 1 in the plane) from `section_polynomials`.

    A station exactly at the nut belongs to the side of A.
    """
    space = V.shape[3] == 2
    for i in range(coef.shape[0]):
        for part in range(coef.shape[1]):
            n = 0
            for j in range(2):
                # read once: for all the compiler knows, writing the outputs could change them
                t0, t1, t2 = coef[i, part, j, 0], coef[i, part, j, 1], coef[i, part, j, 2]
                p0, p1, p2 = coef[i, part, j, 3], coef[i, part, j, 4], coef[i, part, j, 5]
                s0, s1, s2 = coef[i, part, j, 6], coef[i, part, j, 7], coef[i, part, j, 8]
                m0, m1, m2, m3 = coef[i, part, j, 9], coef[i, part, j, 10], coef[i, part, j, 11], coef[i, part, j, 12]
                n0, n1, n2, n3 = coef[i, part, j, 13], coef[i, part, j, 14], coef[i, part, j, 15], coef[i, part, j, 16]
                end = nut[i, part] if j == 0 else WHOLE
                while n < xi.shape[0] and xi[n] <= end:
                    x = xi[n]
                    T[i, part, n] = t0 + x * (t1 + x * t2)
                    V[i, part, n, 0] = p0 + x * (p1 + x * p2)
                    if space:
                        V[i, part, n, 1] = s0 + x * (s1 + x * s2)
                        M[i, part, n, 0] = m0 + x * (m1 + x * (m2 + x * m3))
                        M[i, part, n, 1] = n0 + x * (n1 + x * (n2 + x * n3))
                    else:
                        M[i, part, n, 0] = n0 + x * (n1 + x * (n2 + x * n3))
                    n += 1


@kernel
def section_forces(
    position: Floats, velocity: Floats, acceleration: Floats, joint_force: Floats, gravity: Floats,
    p: Ints, q: Ints, two_rods: Flags, rods: Floats, orient: Ints, reference: Floats, xi: Floats,
    T: Floats, V: Floats, M: Floats,
) -> None:  # fmt: skip
    """T (t, parts, stations), V and M (t, parts, stations, 2 in space or 1 in the plane) at the fractions xi of every part.

    position, velocity, acceleration (t, n, dim), m, m/s, m/s^2; joint_force (t, m, 2, dim): force on the member at A, B, N;
    gravity (dim,); p, q (m,) end nodes; two_rods (m,), rods (m, 6) as in System; orient, reference as in `member_axes`;
    xi ascending.
    """
    batch = max(1, _BATCHED // max(1, T.shape[1]))
    coef, nut = np.empty((batch, T.shape[1], 2, COEFFICIENTS)), np.empty((batch, T.shape[1]))
    for start in range(0, position.shape[0], batch):
        stop = min(start + batch, position.shape[0])
        section_polynomials(
            position[start:stop], velocity[start:stop], acceleration[start:stop], joint_force[start:stop], gravity,
            p, q, two_rods, rods, orient, reference, coef, nut,
        )  # fmt: skip
        count = stop - start
        evaluate_sections(coef[:count], nut[:count], xi, T[start:stop], V[start:stop], M[start:stop])
