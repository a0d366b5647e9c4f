"""Section forces inside straight members, in closed form.

Every part of a member (a bar; the base or the tube of an active member) carries T and V quadratic and M cubic in the
fraction xi = (distance from the part's end towards A)/(length of the part). The force S and moment M are those that the
B-side part exerts on the A-side part; b = a - g is what the mass resists. With m the mass, l the length and i the rotary
inertia of the part, and C_A, C_B the couples of drives and couplings at its ends:

    bar and base, from A:   S(xi) = -F_A + m int_0^xi b dxi,    M(0) = -C_A
    base beyond the nut:    S(xi) = -m int_xi^1 b dxi,          M(1) = 0
    tube, from B:           S(xi) = F_B - m int_xi^1 b dxi,     M(1) = C_B
    masses on base, tube:   S jumps by m b at each, M does not
    everywhere:             dM/dxi = -l u x S + i u x u''

Along a bar b = b_A + xi (a_B - a_A); along the base b = b_A + s u''; along the tube b = b_B - s' u'', s' from B.

What else acts on a bar between its ends is given by the forces f_A, f_B at the ends that are worth the same. At a place s:

    S falls by q = f_A + f_B,  M by c = d x (f_B - s q),  d from A to B

On an active member a force is spread along the whole: its base takes what is before the nut, its tube the rest. On a bar it
is spread from xi = b to xi = b + w, eta = (xi - b)/w: a force q(eta) = q0 + q1 eta with q0 = 4 q - 6 r and q1 = 12 r - 6 q,
r = (f_B - b q)/w; a couple c (a0 + (a1 - a0) eta), a0 + a1 = 2, with f_B = -f_A. Where actions begin or end, segments do.
Source: free bodies of Lacy (1991, chapters 2 and 4), with the acceleration of the moving rods written out.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import Floats, Ints
from kinetruss.kernels.sections.records import FORCE, POINT, Histories, Members, Polynomials

__all__ = [
    "COEFFICIENTS",
    "WHOLE",
    "member_axes",
    "member_polynomials",
    "most_segments",
    "section_forces",
    "section_polynomials",
]


COEFFICIENTS = 17
"""Numbers a segment (`Polynomials`)."""

WHOLE = 2.0
"""Where the last segment of a part ends: beyond every xi."""


class Frame(NamedTuple):
    """A member at one instant: its length, m, and its axes 1, 2, 3."""

    length: float
    u: Any
    y: Any
    z: Any


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
def _seen(v: Any, frame: Frame) -> Any:
    """A vector by its components along the axes of a member."""
    return _dot(v, frame.u), _dot(v, frame.y), _dot(v, frame.z)


@kernel_inline
def _frame(position: Floats, i: int, a: int, b: int, o: int, reference: Floats, k: int) -> Frame:
    """Member k between nodes a and b; o : its orientation node, or -1, and reference as in `Members`."""
    planar, from_a = position.shape[2] == 2, _at(position, i, a)
    d = _less(_at(position, i, b), from_a)
    L = _dot(d, d) ** 0.5
    u = (d[0] / L, d[1] / L, d[2] / L)
    h = (reference[k, 0], reference[k, 1], reference[k, 2])
    if not planar and o >= 0:
        h = _less(_at(position, i, o), from_a)
    yx, yy, yz, zx, zy, zz = _axes(planar, u[0], u[1], u[2], h[0], h[1], h[2])
    return Frame(L, u, (yx, yy, yz), (zx, zy, zz))


@kernel
def member_axes(position: Floats, p: Ints, q: Ints, orient: Ints, reference: Floats, out: Floats) -> None:
    """Local axes 1, 2, 3 of every member as rows of out (t, m, 3, 3), from position (t, n, dim); the others as in `Members`."""
    for i in range(position.shape[0]):
        for k in range(p.shape[0]):
            frame = _frame(position, i, p[k], q[k], orient[k], reference, k)
            for c in range(3):
                out[i, k, 0, c], out[i, k, 1, c], out[i, k, 2, c] = frame.u[c], frame.y[c], frame.z[c]


@kernel_inline
def _bending(velocity: Floats, i: int, a: int, b: int, frame: Frame, e: Any) -> Any:
    """u'' in member axes; e = a_B - a_A in them."""
    r = 1.0 / frame.length
    v1, v2, v3 = _seen(_less(_at(velocity, i, b), _at(velocity, i, a)), frame)
    v2, v3 = v2 * r, v3 * r
    return -(v2 * v2 + v3 * v3), (e[1] - 2.0 * v1 * v2) * r, (e[2] - 2.0 * v1 * v3) * r


@kernel_inline
def _write(out: Polynomials, at: Any, force: Any, span: float, turn: Any, couple: Any, free: bool) -> None:
    """A segment with the force c0 + c1 xi + c2 xi^2 and its moments, `couple` about 2 and 3 at xi = 0, or at 1 where `free`.

    at : sample, part, segment. span : length of the part, and turn its rotary inertia times u''.
    """
    row, (c0, c1, c2), (k2, k3) = out.coef[at[0], at[1], at[2]], force, couple
    # coefficients of T, V2, V3
    for c in range(3):
        row[3 * c], row[3 * c + 1], row[3 * c + 2] = c0[c], c1[c], c2[c]
    m1, m2, m3 = span * c0[2] - turn[2], 0.5 * span * c1[2], span * c2[2] * (1 / 3)
    n1, n2, n3 = turn[1] - span * c0[1], -0.5 * span * c1[1], -span * c2[1] * (1 / 3)
    row[9], row[10], row[11], row[12] = k2 - (m1 + m2 + m3) if free else k2, m1, m2, m3
    row[13], row[14], row[15], row[16] = k3 - (n1 + n2 + n3) if free else k3, n1, n2, n3


@kernel_inline
def _acting(histories: Histories, i: int, n: int, frame: Frame) -> Any:
    """Force q of action n in member axes, and its couple about axes 2 and 3 at its place: c = d x (f_B - s q)."""
    worth, s, L = histories.worth[i], histories.place[i, n], frame.length
    at_a, at_b = _seen(_at(worth, n, 0), frame), _seen(_at(worth, n, 1), frame)
    q = (at_a[0] + at_b[0], at_a[1] + at_b[1], at_a[2] + at_b[2])
    return q, -L * (at_b[2] - s * q[2]), L * (at_b[1] - s * q[1])


@kernel_inline
def _end_couple(members: Members, histories: Histories, i: int, k: int, end: float, frame: Frame) -> Any:
    """Sum of the couples about axes 2 and 3 that act at one end of member k."""
    acting, k2, k3 = members.acting, 0.0, 0.0
    # couples that act at this end, about axes 2 and 3
    for n in range(acting[k], acting[k + 1]):
        if histories.place[i, n] == end:
            _, c2, c3 = _acting(histories, i, n, frame)
            k2, k3 = k2 + c2, k3 + c3
    return k2, k3


@kernel_inline
def _place(members: Members, histories: Histories, i: int, e: int) -> float:
    """Where action e // 2 begins (e even) or ends, as a fraction from A; a point has no end."""
    if members.spread[e // 2] == POINT:
        return histories.place[i, e // 2] if e % 2 == 0 else WHOLE
    return members.along[e // 2, e % 2]


@kernel_inline
def _next(members: Members, histories: Histories, i: int, k: int, before: float, last: int) -> int:
    """The beginning or end of an action on member k that comes next behind the place `before` of `last`; -1 behind all."""
    found, nearest = -1, WHOLE
    # the nearest of those behind; equal places in the order of the actions
    for e in range(2 * members.acting[k], 2 * members.acting[k + 1]):
        s = _place(members, histories, i, e)
        if (s > before or (s == before and e > last)) and s < nearest:
            found, nearest = e, s
    return found


@kernel_inline
def _integral(begin: float, width: float, q0: float, q1: float) -> Any:
    """int q0 + q1 eta from eta = 0, as coefficients of 1, xi, xi^2, eta = (xi - begin)/width."""
    d2 = 0.5 * q1 / (width * width)
    d1 = q0 / width - 2.0 * begin * d2
    return begin * (begin * d2 - q0 / width), d1, d2


@kernel_inline
def _falls(histories: Histories, i: int, n: int, along: Floats, frame: Frame) -> Any:
    """Coefficients of the integral of a force that is spread, and the whole of it, in member axes."""
    at_a, at_b = _seen(_at(histories.worth[i], n, 0), frame), _seen(_at(histories.worth[i], n, 1), frame)
    b, width = along[n, 0], along[n, 1] - along[n, 0]
    q = (at_a[0] + at_b[0], at_a[1] + at_b[1], at_a[2] + at_b[2])
    r = _times(1.0 / width, _less(at_b, _times(b, q)))
    q0, q1 = _less(_times(4.0, q), _times(6.0, r)), _less(_times(12.0, r), _times(6.0, q))
    x0, x1, x2 = _integral(b, width, q0[0], q1[0])
    y0, y1, y2 = _integral(b, width, q0[1], q1[1])
    z0, z1, z2 = _integral(b, width, q0[2], q1[2])
    return (x0, y0, z0), (x1, y1, z1), (x2, y2, z2), q


@kernel_inline
def _turn(out: Polynomials, at: Any, linear: Any, square: Any) -> None:
    """Add what couples along a segment take, by powers of xi, to its M2 and M3."""
    row = out.coef[at[0], at[1], at[2]]
    row[10], row[11] = row[10] + linear[0], row[11] + square[0]
    row[14], row[15] = row[14] + linear[1], row[15] + square[1]


@kernel_inline
def _bar(members: Members, histories: Histories, k: int, out: Polynomials, at: Any, frame: Frame, force: Any, w: Any) -> None:
    """All segments of bar k: a new one begins wherever something acts between its ends. force : without that; w : u''."""
    row, part, i = at
    c0, c1, c2 = force
    L, turn, along = frame.length, _times(members.rods[k, 2], w), members.along
    j, k2, k3, l2, l3, n2, n3 = 0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    e = _next(members, histories, i, k, -1.0, -1)
    # a new segment behind each place where S or M get another form
    while e >= 0:
        n, s = e // 2, _place(members, histories, i, e)
        if s >= 1.0:
            break
        if s > 0.0 and (j == 0 or s > out.ends[row, part, j - 1]):
            _write(out, (row, part, j), (c0, c1, c2), L, turn, (k2, k3), False)
            _turn(out, (row, part, j), (l2, l3), (n2, n3))
            out.ends[row, part, j] = s
            j += 1
        begins = 1.0 if e % 2 == 0 else -1.0
        if members.spread[n] == POINT:
            # T and V fall by the force, M by the couple
            q, m2, m3 = _acting(histories, i, n, frame)
            c0 = _less(c0, q)
            k2, k3 = k2 + L * q[2] * s - m2, k3 - L * q[1] * s - m3
        elif members.spread[n] == FORCE:
            # S falls by the integral of q, at the end by the whole in its place; M goes on without a jump
            d0, d1, d2, q = _falls(histories, i, n, along, frame)
            whole = _times(0.5 - 0.5 * begins, q)
            d0 = _less(_times(begins, d0), _times(-1.0, whole))
            d1, d2 = _times(begins, d1), _times(begins, d2)
            c0, c1, c2 = _less(c0, d0), _less(c1, d1), _less(c2, d2)
            k2 += L * s * (d0[2] + s * (0.5 * d1[2] + s * d2[2] * (1 / 3)))
            k3 -= L * s * (d0[1] + s * (0.5 * d1[1] + s * d2[1] * (1 / 3)))
        else:
            # M falls by the integral of c, at the end by the whole in its place
            at_b = _seen(_at(histories.worth[i], n, 1), frame)
            m2, m3 = -L * at_b[2], L * at_b[1]
            b, a0 = along[n, 0], along[n, 2]
            g0, g1, g2 = _integral(b, along[n, 1] - b, a0, along[n, 3] - a0)
            g0, g1, g2 = begins * g0 + 0.5 - 0.5 * begins, begins * g1, begins * g2
            k2, k3, l2, l3, n2, n3 = k2 - g0 * m2, k3 - g0 * m3, l2 - g1 * m2, l3 - g1 * m3, n2 - g2 * m2, n3 - g2 * m3
        e = _next(members, histories, i, k, s, e)
    _write(out, (row, part, j), (c0, c1, c2), L, turn, (k2, k3), False)
    _turn(out, (row, part, j), (l2, l3), (n2, n3))
    out.ends[row, part, j], out.nut[row, part] = WHOLE, WHOLE


@kernel_inline
def _resisting(members: Members, n: int, span: float, motion: Any) -> Any:
    """m b of mass n on a rod, b = s + xi l u''; motion : s, b at xi = 0, and u''."""
    s, w = motion
    m, arm = members.clamped[n, 1], members.clamped[n, 0] * span
    return m * (s[0] + arm * w[0]), m * (s[1] + arm * w[1]), m * (s[2] + arm * w[2])


@kernel_inline
def _to_the_end(members: Members, out: Polynomials, at: Any, masses: Any, rod: Any, force: Any, couple: Any) -> None:
    """The rest of a rod, given the force and couple at xi = 1: a new segment behind each of these masses.

    at : row, part, and the first segment of the rest. masses : the first and last. rod : span, rotary inertia times u'', motion
    as in `_resisting`. force : c0, c1, c2 of S(xi) without masses, and couple about 2, 3, those at xi = 1.
    """
    (row, part, j), (n, last), (span, turn, motion) = at, masses, rod
    (c0, c1, c2), (k2, k3), place = force, couple, members.clamped
    # S(xi) = F - m int_xi^1 b dxi - sum of m b of the masses ahead
    for ahead in range(n, last):
        q, s = _resisting(members, ahead, span, motion), place[ahead, 0]
        c0 = _less(c0, q)
        k2, k3 = k2 - span * q[2] * (1.0 - s), k3 + span * q[1] * (1.0 - s)
    while n < last:
        q, s = _resisting(members, n, span, motion), place[n, 0]
        if s > 0.0 and (j == 0 or s > out.ends[row, part, j - 1]):
            _write(out, (row, part, j), (c0, c1, c2), span, turn, (k2, k3), True)
            out.ends[row, part, j] = s
            j += 1
        c0 = (c0[0] + q[0], c0[1] + q[1], c0[2] + q[2])
        k2, k3 = k2 + span * q[2] * (1.0 - s), k3 - span * q[1] * (1.0 - s)
        n += 1
    _write(out, (row, part, j), (c0, c1, c2), span, turn, (k2, k3), True)
    out.ends[row, part, j] = WHOLE


@kernel_inline
def _base(members: Members, k: int, out: Polynomials, at: Any, nut: float, force: Any, motion: Any, couple: Any) -> None:
    """The base of active member k, a new segment behind every mass on it and behind the nut. couple : about 2, 3 at A."""
    row, part = at
    (c0, c1, c2), (k2, k3) = force, couple
    span, turn, place, last = (
        members.rods[k, 1],
        _times(members.rods[k, 2], motion[1]),
        members.clamped,
        members.clamped_ptr[2 * k + 1],
    )
    j, n = 0, members.clamped_ptr[2 * k]
    # from A: S(xi) = -F_A + m int_0^xi b dxi + sum of m b of the masses passed
    while n < last and place[n, 0] < nut:
        s = place[n, 0]
        if s > 0.0 and (j == 0 or s > out.ends[row, part, j - 1]):
            _write(out, (row, part, j), (c0, c1, c2), span, turn, (k2, k3), False)
            out.ends[row, part, j] = s
            j += 1
        q = _resisting(members, n, span, motion)
        c0 = (c0[0] + q[0], c0[1] + q[1], c0[2] + q[2])
        k2, k3 = k2 - span * q[2] * s, k3 + span * q[1] * s
        n += 1
    _write(out, (row, part, j), (c0, c1, c2), span, turn, (k2, k3), False)
    out.ends[row, part, j], out.nut[row, part] = nut, nut
    # beyond the nut no force acts at xi = 1
    free = _less(_less((0.0, 0.0, 0.0), c1), c2), c1, c2
    _to_the_end(members, out, (row, part, j + 1), (n, last), (span, turn, motion), free, (0.0, 0.0))


@kernel_inline
def _push_rods(members: Members, histories: Histories, k: int, out: Polynomials, at: Any, frame: Frame) -> None:
    """Add the forces along active member k, q (a0 + (a1 - a0) s), to its base, up to the nut, and to its tube, from its end."""
    (row, part, i), rods, along = at, members.rods, members.along
    base, tube, nut = rods[k, 1] / frame.length, rods[k, 4] / frame.length, max(0.0, 1.0 - rods[k, 4] / frame.length)
    for n in range(members.acting[k], members.acting[k + 1]):
        if members.spread[n] == POINT:
            continue
        a, b = _seen(_at(histories.worth[i], n, 0), frame), _seen(_at(histories.worth[i], n, 1), frame)
        a0, rise = along[n, 2], along[n, 3] - along[n, 2]
        # what base and tube take from their beginning: d1 xi + d2 xi^2
        b1, b2 = base * a0, 0.5 * base * base * rise
        t1, t2 = tube * (a0 + nut * rise), 0.5 * tube * tube * rise
        for c in range(3):
            q = a[c] + b[c]
            # M2' = l V3, M3' = -l V2
            first, sign = (9, 1.0) if c == 2 else (13, -1.0)
            j = 0
            while True:
                segment = out.coef[row, part, j]
                segment[3 * c + 1] -= q * b1
                segment[3 * c + 2] -= q * b2
                if c > 0:
                    segment[first + 2] -= sign * rods[k, 1] * q * b1 / 2.0
                    segment[first + 3] -= sign * rods[k, 1] * q * b2 / 3.0
                if out.ends[row, part, j] >= out.nut[row, part]:
                    break
                j += 1
            j = 0
            while True:
                segment = out.coef[row, part + 1, j]
                segment[3 * c] += q * (t1 + t2)
                segment[3 * c + 1] -= q * t1
                segment[3 * c + 2] -= q * t2
                if c > 0:
                    # M = 0 at the end of the tube
                    segment[first] -= sign * rods[k, 4] * q * (t1 / 2.0 + 2.0 * t2 / 3.0)
                    segment[first + 1] += sign * rods[k, 4] * q * (t1 + t2)
                    segment[first + 2] -= sign * rods[k, 4] * q * t1 / 2.0
                    segment[first + 3] -= sign * rods[k, 4] * q * t2 / 3.0
                if out.ends[row, part + 1, j] >= WHOLE:
                    break
                j += 1


@kernel_inline
def _rods(
    members: Members, histories: Histories, k: int, out: Polynomials, at: Any, frame: Frame, force: Any, motion: Any
) -> None:
    """Base and tube of active member k. force : along the base up to the first mass; motion : a_A - g and u''."""
    row, part, i = at
    rods, g, w = members.rods, members.gravity, motion[1]
    k2, k3 = _end_couple(members, histories, i, k, 0.0, frame)
    _base(members, k, out, (row, part), (frame.length - rods[k, 4]) / rods[k, 1], force, motion, (-k2, -k3))
    # the tube, from B: F_B and the couple there are those at xi = 1, and b = b_B - s' u'', s' from B
    m, span, f = rods[k, 3], rods[k, 4], _seen(_at(histories.joint_force[i], k, 1), frame)
    c2 = _times(0.5 * m * span, w)
    b = _seen(_less(_at(histories.acceleration, i, members.q[k]), (g[0], g[1], g[2])), frame)
    c1 = _less(_times(m, b), _times(2.0, c2))
    rod = span, _times(rods[k, 5], w), (_less(b, _times(span, w)), w)
    couple = _end_couple(members, histories, i, k, 1.0, frame)
    masses = members.clamped_ptr[2 * k + 1], members.clamped_ptr[2 * k + 2]
    out.nut[row, part + 1] = WHOLE
    _to_the_end(members, out, (row, part + 1, 0), masses, rod, (_less(_less(f, c1), c2), c1, c2), couple)
    _push_rods(members, histories, k, out, at, frame)


@kernel_inline
def _member(members: Members, histories: Histories, i: int, k: int, out: Polynomials, row: int, part: int) -> None:
    """The parts of member k at sample i, into parts part, part + 1 of a row of out."""
    p, q, rods = members.p, members.q, members.rods
    # S(xi) = -F_A + m int b dxi, b linear along the member
    g, still, a, b, m = (members.gravity[0], members.gravity[1], members.gravity[2]), (0.0, 0.0, 0.0), p[k], q[k], rods[k, 0]
    frame = _frame(histories.position, i, a, b, members.orient[k], members.reference, k)
    # in member axes: f the force at A, s = a_A - g, e = a_B - a_A, w = u'' (zero where it is not needed)
    at_a, at_b = _at(histories.acceleration, i, a), _at(histories.acceleration, i, b)
    f, s = _seen(_at(histories.joint_force[i], k, 0), frame), _seen(_less(at_a, g), frame)
    e, w = _seen(_less(at_b, at_a), frame), still
    two = members.two_rods[k] != 0
    if two or rods[k, 2] != 0.0:
        w = _bending(histories.velocity, i, a, b, frame, e)
    c0, c1, at = _less(still, f), _times(m, s), (row, part, i)
    if two:
        _rods(members, histories, k, out, at, frame, (c0, c1, _times(0.5 * m * rods[k, 1], w)), (s, w))
    else:
        _bar(members, histories, k, out, at, frame, (c0, c1, _times(0.5 * m, e)), w)


@kernel_bare
def member_polynomials(members: Members, histories: Histories, i: int, k: int, out: Polynomials, part: int) -> None:
    """Coefficients of all segments of the parts of member k at sample i, into parts part, part + 1 of row 0 of out."""
    _member(members, histories, i, k, out, 0, part)


@kernel_inline
def _sample(members: Members, histories: Histories, i: int, out: Polynomials, row: int) -> None:
    """All parts at sample i, into a row of out."""
    part = 0
    for k in range(members.p.shape[0]):
        _member(members, histories, i, k, out, row, part)
        part += 2 if members.two_rods[k] != 0 else 1


@kernel_bare
def section_polynomials(members: Members, histories: Histories, out: Polynomials) -> None:
    """Coefficients of all segments of all parts.

    The last segment of a part ends at 2; those behind it are left as they are. The base of an active member has two, which
    meet at the nut, its tube one, and each one more a mass; a bar one more than places where something acts between its ends.
    """
    for i in range(histories.position.shape[0]):
        _sample(members, histories, i, out, i)


@kernel_inline
def _evaluate(given: Polynomials, xi: Floats, T: Floats, V: Floats, M: Floats, i: int) -> None:
    """Row 0 of the polynomials at the fractions xi, into sample i; where two segments meet, that on the side of A."""
    coef, space = given.coef, V.shape[3] == 2
    # T, V quadratic and M cubic in xi, by Horner's scheme on each segment
    for part in range(coef.shape[1]):
        n, j = 0, 0
        while n < xi.shape[0]:
            # read once: for all the compiler knows, writing the outputs could change them
            t0, t1, t2 = coef[0, part, j, 0], coef[0, part, j, 1], coef[0, part, j, 2]
            p0, p1, p2 = coef[0, part, j, 3], coef[0, part, j, 4], coef[0, part, j, 5]
            s0, s1, s2 = coef[0, part, j, 6], coef[0, part, j, 7], coef[0, part, j, 8]
            m0, m1, m2, m3 = coef[0, part, j, 9], coef[0, part, j, 10], coef[0, part, j, 11], coef[0, part, j, 12]
            n0, n1, n2, n3 = coef[0, part, j, 13], coef[0, part, j, 14], coef[0, part, j, 15], coef[0, part, j, 16]
            end = given.ends[0, part, j]
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


def most_segments(acting: Ints, spread: Ints, along: Floats, clamped_ptr: Ints) -> int:
    """How many segments a part has at most; 2 at least, and one more a mass, for the rods of an active member."""
    inside = (along[:, 0] > 0.0).astype(np.int64) + (along[:, 1] < 1.0)
    places = np.append(0, np.cumsum(np.where(spread == POINT, 1, inside)))
    return 1 + max(int(np.diff(places[acting]).max(initial=1)), 1 + int(np.diff(clamped_ptr).max(initial=0)))


@kernel_bare
def section_forces(
    members: Members, histories: Histories, scratch: Polynomials, xi: Floats, T: Floats, V: Floats, M: Floats
) -> None:
    """T (t, parts, stations), V and M (t, parts, stations, 2 in space or 1 in the plane) at the fractions xi of every part.

    xi ascending. scratch : for the polynomials of one sample.
    """
    # coefficients of one sample at a time stay in the cache
    for i in range(T.shape[0]):
        _sample(members, histories, i, scratch, 0)
        _evaluate(scratch, xi, T, V, M, i)
