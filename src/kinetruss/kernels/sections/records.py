"""What section forces follow from and what they are handed on as; what passes between base and tube of an active member."""

from __future__ import annotations

from typing import NamedTuple

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, Floats, Record, record
from kinetruss.kernels.structure.mass import direction, turning
from kinetruss.kernels.structure.structure import States

POINT, FORCE, COUPLE = 0, 1, 2
"""An action at a point, and those spread along a part of a bar."""


@record
class Members(Record):
    """Members, their masses and the actions on them: what stays the same along a motion.

    segments : that a part has at most. p, q (m,) : nodes at the ends A, B. orient (m,) : node that spans plane 1-2 with the
    member, or -1; reference (m, 3) : direction where there is none. two_rods (m,) : 1 of active members. rods (m, 6) : mass kg,
    length m, rotary inertia kg m^2 of a bar or base, then of a tube. acting (m + 1,) : actions acting[k]:acting[k + 1] are on
    member k. clamped_ptr (2 m + 1,) : masses clamped[clamped_ptr[j]:clamped_ptr[j + 1]] are on the base of member k, j = 2 k,
    or on its tube, j = 2 k + 1; clamped (c, 2) : fraction from the end towards A, ascending, and kg, besides those in rods.
    spread (actions,) : POINT, FORCE or COUPLE; along (actions, 4) : of one that is spread the fractions from A where it begins
    and ends, and of a couple, or a force on an active member, its amount a length there over the mean. gravity (3,) m/s^2.
    """

    segments: I0
    p: I1
    q: I1
    orient: I1
    two_rods: I1
    acting: I1
    spread: I1
    clamped_ptr: I1
    along: F2
    clamped: F2
    rods: F2
    reference: F2
    gravity: F1


class Histories(NamedTuple):
    """What members go through: how their nodes move, what their joints do, what acts on them between their ends.

    position, velocity, acceleration (t, n, dim) m, m/s, m/s^2. joint_force (t, m, 2, dim) : on the member at its ends A, B, N.
    worth (t, actions, 2, dim) : forces at A and B that an action is worth, N. place (t, actions) : its fraction from A, of one
    at a point; on an active member an end.
    """

    position: Floats
    velocity: Floats
    acceleration: Floats
    joint_force: Floats
    worth: Floats
    place: Floats


class Polynomials(NamedTuple):
    """Section forces along the segments s of all parts.

    coef (t, parts, s, 17) : T 0:3, V2 3:6, V3 6:9 N, M2 9:13, M3 13:17 N m, in ascending powers of xi. ends (t, parts, s) : the
    xi where a segment ends, that of the last beyond every xi; segments behind it mean nothing. nut (t, parts) : the one of them
    where the nut is on a base; beyond every xi on other parts.
    """

    coef: Floats
    ends: Floats
    nut: Floats


# What passes between base and tube of an active member.


@record
class Actives(Record):
    """Active members: member (k,) among all, p, q (k,) nodes at their ends, tube (k,) length of their tubes, m, rods (k, 6)
    uniform ones with the same moments as base and tube with their masses: mass kg, length m, rotary inertia kg m^2.
    """

    member: I1
    p: I1
    q: I1
    tube: F1
    rods: F2


@kernel
def interface(actives: Actives, states: States, joint: Floats, g: F1, axes: Floats, force: Floats, moment: Floats) -> None:
    """Force and moment of the tube on the base at the tube's free end, in member axes, into (times, active, 3) each.

    Free body of the tube of length h (mass m, first moment k = m l/2 and second j = m l^2/3 + r about B, acceleration
    a_B - s' u''): S = F_B - m (a_B - g) + k u'', M = u x (h F_B - (m h - k) (a_B - g) + (k h - j) u'').
    joint (times, members, 2, 3); gravity g (3,); axes (times, k, 3, 3) rows 1, 2, 3.
    """
    (x, v, a), member, p, q, rods = states, actives.member, actives.p, actives.q, actives.rods
    still = v.shape[0] == 1
    # Newton's and Euler's equations of the tube as a free body, at each sample
    for i in range(x.shape[0]):
        j = 0 if still else i
        for k in range(member.size):
            m, A, B = member[k], 3 * p[k], 3 * q[k]
            L, u = direction(x[i], A, B)
            e = v[j, B] - v[j, A], v[j, B + 1] - v[j, A + 1], v[j, B + 2] - v[j, A + 2]
            ee = a[j, B] - a[j, A], a[j, B + 1] - a[j, A + 1], a[j, B + 2] - a[j, A + 2]
            _, _, _, (sx, sy, sz) = turning(L, u, e, ee)
            ux, uy, uz = u
            mass, length = rods[k, 3], actives.tube[k]
            first = 0.5 * mass * rods[k, 4]
            half = mass * length - first
            swing = first * length - mass * rods[k, 4] ** 2 / 3.0 - rods[k, 5]
            bx, by, bz = a[j, B] - g[0], a[j, B + 1] - g[1], a[j, B + 2] - g[2]
            fx, fy, fz = joint[i, m, 1, 0], joint[i, m, 1, 1], joint[i, m, 1, 2]
            tx = length * fx - half * bx + swing * sx
            ty = length * fy - half * by + swing * sy
            tz = length * fz - half * bz + swing * sz
            fx, fy, fz = fx - mass * bx + first * sx, fy - mass * by + first * sy, fz - mass * bz + first * sz
            mx, my, mz = uy * tz - uz * ty, uz * tx - ux * tz, ux * ty - uy * tx
            for c in range(3):
                ex, ey, ez = axes[i, k, c, 0], axes[i, k, c, 1], axes[i, k, c, 2]
                force[i, k, c] = ex * fx + ey * fy + ez * fz
                moment[i, k, c] = ex * mx + ey * my + ez * mz
