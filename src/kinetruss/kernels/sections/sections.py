"""Section forces inside straight members, in closed form.

Every part of a member (a bar; the base or the tube of an active member) carries T and V quadratic and M cubic in the
fraction xi = (distance from the part's end towards A)/(length of the part). The force S and moment M are those that the
B-side part exerts on the A-side part; b = a - g is what the mass resists. With m the mass, l the length and i the rotary
inertia of the part, and C_A, C_B the couples of drives and couplings at its ends:

    bar and base, from A:   S(xi) = -F_A + m int_0^xi b dxi,    M(0) = -C_A
    base beyond the nut:    S(xi) = -m int_xi^1 b dxi,          M(1) = 0
    tube, from B:           S(xi) = F_B - m int_xi^1 b dxi,     M(1) = C_B
    everywhere:             dM/dxi = -l u x S + i u x u''

Along a bar b = b_A + xi (a_B - a_A); along the base b = b_A + s u''; along the tube b = b_B - s' u'', s' from B.

What else acts on a bar between its ends is given by the forces f_A, f_B at the ends that are worth the same. At a place s:

    S falls by q = f_A + f_B,  M by c = d x (f_B - s q),  d from A to B

or spread along the bar as q(xi) = q0 + q1 xi with q0 = 4 f_A - 2 f_B, q1 = 6 (f_B - f_A). Places part a bar into segments.
Source: free bodies of Lacy (1991, chapters 2 and 4), with the acceleration of the moving rods written out.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel, kernel_inline

__all__ = [
    "COEFFICIENTS", "WHOLE", "evaluate_sections", "member_axes", "most_segments", "section_forces", "section_polynomials",
    "start_references",
]  # fmt: skip

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]

COEFFICIENTS = 17
"""Numbers a segment: T 0:3, V2 3:6, V3 6:9, M2 9:13, M3 13:17, ascending powers of xi."""

WHOLE = 2.0
"""Where the last segment of a part ends: beyond every xi."""

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


@kernel_inline
def _at(y: Floats, i: int, n: int) -> Any:
    """Row n of y (t, n, dim) at sample i as three numbers."""
    return y[i, n, 0], y[i, n, 1], (0.0 if y.shape[2] == 2 else y[i, n, 2])


@kernel_inline
def _less(a: Any, b: Any) -> Any:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@kernel_inline
def _dot(a: Any, b: Any) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel_inline
def _times(f: float, a: Any) -> Any:
    return f * a[0], f * a[1], f * a[2]


@kernel_inline
def _seen(v: Any, u: Any, y: Any, z: Any) -> Any:
    """A vector by its components along three axes."""
    return _dot(v, u), _dot(v, y), _dot(v, z)


@kernel_inline
def _frame(position: Floats, i: int, a: int, b: int, o: int, reference: Floats, k: int) -> Any:
    """Length of member k between nodes a and b, and its axes 1, 2, 3; o and reference as in `member_axes`."""
    planar, from_a = position.shape[2] == 2, _at(position, i, a)
    d = _less(_at(position, i, b), from_a)
    L = _dot(d, d) ** 0.5
    u = (d[0] / L, d[1] / L, d[2] / L)
    h = (reference[k, 0], reference[k, 1], reference[k, 2])
    if not planar and o >= 0:
        h = _less(_at(position, i, o), from_a)
    yx, yy, yz, zx, zy, zz = _axes(planar, u[0], u[1], u[2], h[0], h[1], h[2])
    return L, u, (yx, yy, yz), (zx, zy, zz)


@kernel
def member_axes(position: Floats, p: Ints, q: Ints, orient: Ints, reference: Floats, out: Floats) -> None:
    """Local axes 1, 2, 3 of every member as rows of out (t, m, 3, 3), from position (t, n, dim).

    orient (m,): node that spans plane 1-2 with the member, or -1; reference (m, 3): direction where there is none.
    """
    for i in range(position.shape[0]):
        for k in range(p.shape[0]):
            _, u, y, z = _frame(position, i, p[k], q[k], orient[k], reference, k)
            for c in range(3):
                out[i, k, 0, c], out[i, k, 1, c], out[i, k, 2, c] = u[c], y[c], z[c]


@kernel_inline
def _bending(velocity: Floats, i: int, a: int, b: int, L: float, u: Any, y: Any, z: Any, e: Any) -> Any:
    """u'' in member axes; e = a_B - a_A in them."""
    r = 1.0 / L
    v1, v2, v3 = _seen(_less(_at(velocity, i, b), _at(velocity, i, a)), u, y, z)
    v2, v3 = v2 * r, v3 * r
    return -(v2 * v2 + v3 * v3), (e[1] - 2.0 * v1 * v2) * r, (e[2] - 2.0 * v1 * v3) * r


@kernel_inline
def _write(
    coef: Floats, i: int, part: int, j: int, c0: Any, c1: Any, c2: Any, span: float, rotary: float, w: Any,
    k2: float, k3: float, free: bool,
) -> None:  # fmt: skip
    """Segment j of a part with the force c0 + c1 xi + c2 xi^2 and its moments, k2 and k3 at xi = 0, or at 1 where `free`."""
    out = coef[i, part, j]
    for c in range(3):
        out[3 * c], out[3 * c + 1], out[3 * c + 2] = c0[c], c1[c], c2[c]
    m1, m2, m3 = span * c0[2] - rotary * w[2], 0.5 * span * c1[2], span * c2[2] * (1 / 3)
    n1, n2, n3 = rotary * w[1] - span * c0[1], -0.5 * span * c1[1], -span * c2[1] * (1 / 3)
    out[9], out[10], out[11], out[12] = k2 - (m1 + m2 + m3) if free else k2, m1, m2, m3
    out[13], out[14], out[15], out[16] = k3 - (n1 + n2 + n3) if free else k3, n1, n2, n3


@kernel_inline
def _acting(worth: Floats, place: Floats, i: int, k: int, L: float, u: Any, y: Any, z: Any) -> Any:
    """Force q of action k in member axes, and its couple about axes 2 and 3 at its place: c = d x (f_B - s q)."""
    at_a, at_b = _seen(_at(worth[i], k, 0), u, y, z), _seen(_at(worth[i], k, 1), u, y, z)
    q = (at_a[0] + at_b[0], at_a[1] + at_b[1], at_a[2] + at_b[2])
    s = place[i, k]
    return q, -L * (at_b[2] - s * q[2]), L * (at_b[1] - s * q[1])


@kernel_inline
def _end_couple(
    worth: Floats, place: Floats, i: int, first: int, last: int, end: float, L: float, u: Any, y: Any, z: Any
) -> Any:
    """Sum of the couples about axes 2 and 3 that act at one end of a member."""
    k2, k3 = 0.0, 0.0
    for k in range(first, last):
        if place[i, k] == end:
            _, c2, c3 = _acting(worth, place, i, k, L, u, y, z)
            k2, k3 = k2 + c2, k3 + c3
    return k2, k3


@kernel_inline
def _next(place: Floats, spread: Flags, i: int, first: int, last: int, before: float, n: int) -> int:
    """The action at a point that comes next behind the place `before` of action n; -1 behind the last."""
    found = -1
    for k in range(first, last):
        later = place[i, k] > before or (place[i, k] == before and k > n)
        if later and not spread[k] and (found < 0 or place[i, k] < place[i, found]):
            found = k
    return found


@kernel_inline
def _bar(
    coef: Floats, ends: Floats, i: int, part: int, c0: Any, c1: Any, c2: Any, L: float, rotary: float, u: Any, y: Any, z: Any,
    w: Any, first: int, last: int, worth: Floats, place: Floats, spread: Flags,
) -> None:  # fmt: skip
    """All segments of a bar: a new one begins wherever something acts between its ends."""
    for k in range(first, last):
        if spread[k]:
            at_a, at_b = _seen(_at(worth[i], k, 0), u, y, z), _seen(_at(worth[i], k, 1), u, y, z)
            c1 = _less(c1, _less(_times(4.0, at_a), _times(2.0, at_b)))
            c2 = _less(c2, _times(3.0, _less(at_b, at_a)))
    j, k2, k3 = 0, 0.0, 0.0
    k = _next(place, spread, i, first, last, -1.0, -1)
    while k >= 0 and place[i, k] < 1.0:
        s = place[i, k]
        if s > 0.0 and (j == 0 or s > ends[i, part, j - 1]):
            _write(coef, i, part, j, c0, c1, c2, L, rotary, w, k2, k3, False)
            ends[i, part, j] = s
            j += 1
        q, m2, m3 = _acting(worth, place, i, k, L, u, y, z)
        c0 = _less(c0, q)
        k2, k3 = k2 + L * q[2] * s - m2, k3 - L * q[1] * s - m3
        k = _next(place, spread, i, first, last, s, k)
    _write(coef, i, part, j, c0, c1, c2, L, rotary, w, k2, k3, False)
    ends[i, part, j] = WHOLE


@kernel
def section_polynomials(
    position: Floats, velocity: Floats, acceleration: Floats, joint_force: Floats, gravity: Floats,
    p: Ints, q: Ints, two_rods: Flags, rods: Floats, orient: Ints, reference: Floats,
    acting: Ints, worth: Floats, place: Floats, spread: Flags, coef: Floats, ends: Floats,
) -> None:  # fmt: skip
    """Coefficients of all segments of all parts into coef (t, parts, s, 17), and the xi where they end into ends (t, parts, s).

    The last segment of a part ends at 2; those behind it are left as they are. The base of an active member has two, which
    meet at the nut; a bar one more than places where something acts between its ends. The arguments are those of
    `section_forces`.
    """
    g, still = (gravity[0], gravity[1], 0.0 if gravity.shape[0] == 2 else gravity[2]), (0.0, 0.0, 0.0)
    for i in range(position.shape[0]):
        part = 0
        for k in range(p.shape[0]):
            a, b, m = p[k], q[k], rods[k, 0]
            first, last = acting[k], acting[k + 1]
            L, u, y, z = _frame(position, i, a, b, orient[k], reference, k)
            # in member axes: f the force at A, s = a_A - g, e = a_B - a_A, w = u'' (zero where it is not needed)
            at_a, at_b = _at(acceleration, i, a), _at(acceleration, i, b)
            f, s = _seen(_at(joint_force[i], k, 0), u, y, z), _seen(_less(at_a, g), u, y, z)
            e = _seen(_less(at_b, at_a), u, y, z)
            w = _bending(velocity, i, a, b, L, u, y, z, e) if two_rods[k] or rods[k, 2] != 0.0 else still
            c0, c1 = _less(still, f), _times(m, s)
            if not two_rods[k]:
                c2 = _times(0.5 * m, e)
                _bar(coef, ends, i, part, c0, c1, c2, L, rods[k, 2], u, y, z, w, first, last, worth, place, spread)
                part += 1
                continue
            span = rods[k, 1]
            c2 = _times(0.5 * m * span, w)
            ends[i, part, 0], ends[i, part, 1], ends[i, part + 1, 0] = (L - rods[k, 4]) / span, WHOLE, WHOLE
            k2, k3 = _end_couple(worth, place, i, first, last, 0.0, L, u, y, z)
            _write(coef, i, part, 0, c0, c1, c2, span, rods[k, 2], w, -k2, -k3, False)
            # beyond the nut nothing pulls at xi = 1
            _write(coef, i, part, 1, _less(_less(still, c1), c2), c1, c2, span, rods[k, 2], w, 0.0, 0.0, True)
            # the tube is written from xi = 1 back
            m, span, f = rods[k, 3], rods[k, 4], _seen(_at(joint_force[i], k, 1), u, y, z)
            c2 = _times(0.5 * m * span, w)
            c1 = _less(_times(m, _seen(_less(at_b, g), u, y, z)), _times(2.0, c2))
            k2, k3 = _end_couple(worth, place, i, first, last, 1.0, L, u, y, z)
            _write(coef, i, part + 1, 0, _less(_less(f, c1), c2), c1, c2, span, rods[k, 5], w, k2, k3, True)
            part += 2


@kernel
def evaluate_sections(coef: Floats, ends: Floats, xi: Floats, T: Floats, V: Floats, M: Floats) -> None:
    """T (t, parts, stations), V and M (t, parts, stations, 2 in space or 1 in the plane) from `section_polynomials`.

    A station exactly where two segments meet belongs to the side of A.
    """
    space = V.shape[3] == 2
    for i in range(coef.shape[0]):
        for part in range(coef.shape[1]):
            n, j = 0, 0
            while n < xi.shape[0]:
                # read once: for all the compiler knows, writing the outputs could change them
                t0, t1, t2 = coef[i, part, j, 0], coef[i, part, j, 1], coef[i, part, j, 2]
                p0, p1, p2 = coef[i, part, j, 3], coef[i, part, j, 4], coef[i, part, j, 5]
                s0, s1, s2 = coef[i, part, j, 6], coef[i, part, j, 7], coef[i, part, j, 8]
                m0, m1, m2, m3 = coef[i, part, j, 9], coef[i, part, j, 10], coef[i, part, j, 11], coef[i, part, j, 12]
                n0, n1, n2, n3 = coef[i, part, j, 13], coef[i, part, j, 14], coef[i, part, j, 15], coef[i, part, j, 16]
                end = ends[i, part, j]
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
                j += 1


@kernel
def most_segments(acting: Ints, spread: Flags) -> int:
    """How many segments a part has at most; 2 at least, for the base of an active member."""
    most = 2
    for k in range(acting.shape[0] - 1):
        count = 1
        for n in range(acting[k], acting[k + 1]):
            if not spread[n]:
                count += 1
        most = max(most, count)
    return most


@kernel
def section_forces(
    position: Floats, velocity: Floats, acceleration: Floats, joint_force: Floats, gravity: Floats,
    p: Ints, q: Ints, two_rods: Flags, rods: Floats, orient: Ints, reference: Floats,
    acting: Ints, worth: Floats, place: Floats, spread: Flags, xi: Floats, T: Floats, V: Floats, M: Floats,
) -> None:  # fmt: skip
    """T (t, parts, stations), V and M (t, parts, stations, 2 in space or 1 in the plane) at the fractions xi of every part.

    position, velocity, acceleration (t, n, dim), m, m/s, m/s^2; joint_force (t, m, 2, dim): force on the member at A, B, N;
    gravity (dim,); p, q (m,) end nodes; two_rods (m,), rods (m, 6) as in System; orient, reference as in `member_axes`;
    xi ascending. Actions acting[k]:acting[k + 1] are those on member k, acting (m + 1,): worth (t, actions, 2, dim) the forces
    at A and B, N, that each is worth; place (t, actions) its fraction from A; spread (actions,): along the whole bar. On an
    active member they act at its ends.
    """
    batch = max(1, _BATCHED // max(1, T.shape[1]))
    segments = most_segments(acting, spread)
    coef, ends = np.empty((batch, T.shape[1], segments, COEFFICIENTS)), np.empty((batch, T.shape[1], segments))
    for start in range(0, position.shape[0], batch):
        stop = min(start + batch, position.shape[0])
        section_polynomials(
            position[start:stop], velocity[start:stop], acceleration[start:stop], joint_force[start:stop], gravity,
            p, q, two_rods, rods, orient, reference, acting, worth[start:stop], place[start:stop], spread, coef, ends,
        )  # fmt: skip
        count = stop - start
        evaluate_sections(coef[:count], ends[:count], xi, T[start:stop], V[start:stop], M[start:stop])
