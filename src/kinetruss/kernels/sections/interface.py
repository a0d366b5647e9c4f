"""What passes between base and tube of an active member."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, F2, I1, Floats, Record, record
from kinetruss.kernels.structure.mass import direction, turning
from kinetruss.kernels.structure.structure import States

__all__ = ["Actives", "interface"]


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
