"""What passes between base and tube of an active member."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.structure.mass import direction, turning

__all__ = ["interface"]


@kernel
def interface(active, p, q, rods, g, axes, x, v, a, joint, force, moment):  # type: ignore[no-untyped-def]
    """Force and moment of the tube on the base at the tube's free end, in member axes, into (times, active, 3) each.

    Free body of the tube (mass m, length l, rotary inertia r, clamped at B, acceleration a_B - s' u''):
    S = F_B - m (a_B - g - l/2 u''), M = l u x F_B - u x (m l/2 (a_B - g) - m l^2/6 u'') - r u x u''.
    active (k,) member indices; axes (times, k, 3, 3) rows 1, 2, 3; x, v, a (times, 3 n); joint (times, members, 2, 3).
    """
    still = v.shape[0] == 1
    for i in range(x.shape[0]):
        j = 0 if still else i
        for k in range(active.size):
            m = active[k]
            A, B = 3 * p[m], 3 * q[m]
            L, u = direction(x[i], A, B)
            e = v[j, B] - v[j, A], v[j, B + 1] - v[j, A + 1], v[j, B + 2] - v[j, A + 2]
            ee = a[j, B] - a[j, A], a[j, B + 1] - a[j, A + 1], a[j, B + 2] - a[j, A + 2]
            _, _, _, (sx, sy, sz) = turning(L, u, e, ee)
            ux, uy, uz = u
            mass, length = rods[m, 3], rods[m, 4]
            half = 0.5 * mass * length
            swing = mass * length * length / 6.0 - rods[m, 5]
            bx, by, bz = a[j, B] - g[0], a[j, B + 1] - g[1], a[j, B + 2] - g[2]
            fx, fy, fz = joint[i, m, 1, 0], joint[i, m, 1, 1], joint[i, m, 1, 2]
            tx = length * fx - half * bx + swing * sx
            ty = length * fy - half * by + swing * sy
            tz = length * fz - half * bz + swing * sz
            fx, fy, fz = fx - mass * bx + half * sx, fy - mass * by + half * sy, fz - mass * bz + half * sz
            mx, my, mz = uy * tz - uz * ty, uz * tx - ux * tz, ux * ty - uy * tx
            for c in range(3):
                ex, ey, ez = axes[i, k, c, 0], axes[i, k, c, 1], axes[i, k, c, 2]
                force[i, k, c] = ex * fx + ey * fy + ez * fz
                moment[i, k, c] = ex * mx + ey * my + ez * mz
