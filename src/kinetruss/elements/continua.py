"""Membranes and solids: elements whose energy is quadratic in the squared lengths of their edges.

With the stretches s = |d|^2 - |d0|^2 of the edges, an element has the energy s^T G s/2 and its edges have the force
densities q = 2 G s, N/m: the force q d on the first node of an edge with d = x_q - x_p (see `elements.continua_arrays`).
Edges are shared: the stretch and the force of each are found once, whatever number of elements it belongs to.

Tangent between two different nodes a < b of an element: K_ab = -q_ab 1 + sum over the edges i of a and j of b of
+-2 (2 G)_ij d_i d_j^T, the sign by the ends; K_aa = -sum of K_ab over b, as nothing resists a translation.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Floats, Ints, Record, Vector, record
from kinetruss.kernels.structure import element_table


@record
class EdgeElements(Record):
    """A, B (e,) flat ends of the edges, start (3 n,) places of all nodes without stress, m.

    By the number of nodes, with w edges between them: the edges (k, w) of each element in the order of the pairs (0, 1),
    (0, 2), ... of its nodes, and the upper triangle of its stiffness 2 G by rows (k, w (w + 1)/2), N/m^3.
    """

    A: I1
    B: I1
    triangle_edge: I2
    tetrahedron_edge: I2
    six_edge: I2
    start: F1
    triangle: F2
    tetrahedron: F2
    six: F2


@kernel_bare
def _triangles(edge: I2, stiffness: F2, s: F1, q: F1) -> None:
    """q += 2 G s of elements with three edges."""
    # q = 2 G s of each triangle, symmetric 3 x 3 by its upper triangle
    for k in range(edge.shape[0]):
        a, b, c = edge[k, 0], edge[k, 1], edge[k, 2]
        g = stiffness[k]
        q[a] += g[0] * s[a] + g[1] * s[b] + g[2] * s[c]
        q[b] += g[1] * s[a] + g[3] * s[b] + g[4] * s[c]
        q[c] += g[2] * s[a] + g[4] * s[b] + g[5] * s[c]


@kernel_bare
def _tetrahedra(edge: I2, stiffness: F2, s: F1, q: F1) -> None:
    """q += 2 G s of elements with six edges."""
    # q = 2 G s of each tetrahedron, symmetric 6 x 6 by its upper triangle
    for k in range(edge.shape[0]):
        i0, i1, i2, i3, i4, i5 = edge[k, 0], edge[k, 1], edge[k, 2], edge[k, 3], edge[k, 4], edge[k, 5]
        s0, s1, s2, s3, s4, s5 = s[i0], s[i1], s[i2], s[i3], s[i4], s[i5]
        g = stiffness[k]
        q[i0] += g[0] * s0 + g[1] * s1 + g[2] * s2 + g[3] * s3 + g[4] * s4 + g[5] * s5
        q[i1] += g[1] * s0 + g[6] * s1 + g[7] * s2 + g[8] * s3 + g[9] * s4 + g[10] * s5
        q[i2] += g[2] * s0 + g[7] * s1 + g[11] * s2 + g[12] * s3 + g[13] * s4 + g[14] * s5
        q[i3] += g[3] * s0 + g[8] * s1 + g[12] * s2 + g[15] * s3 + g[16] * s4 + g[17] * s5
        q[i4] += g[4] * s0 + g[9] * s1 + g[13] * s2 + g[16] * s3 + g[18] * s4 + g[19] * s5
        q[i5] += g[5] * s0 + g[10] * s1 + g[14] * s2 + g[17] * s3 + g[19] * s4 + g[20] * s5


@kernel_bare
def _many(edge: I2, stiffness: F2, s: F1, q: F1) -> None:
    """q += 2 G s of elements with any number of edges."""
    w = edge.shape[1]
    # q = 2 G s of each element, symmetric by its upper triangle
    for k in range(edge.shape[0]):
        at = 0
        for i in range(w):
            a = edge[k, i]
            q[a] += stiffness[k, at] * s[a]
            at += 1
            for j in range(i + 1, w):
                b = edge[k, j]
                q[a] += stiffness[k, at] * s[b]
                q[b] += stiffness[k, at] * s[a]
                at += 1


@kernel
def edge_densities(s: EdgeElements, stretch: F1, q: F1) -> None:
    """Force densities q (e,), N/m, of stretches (e,), m^2."""
    # elements add to the edges they share
    for i in range(q.size):
        q[i] = 0.0
    _triangles(s.triangle_edge, s.triangle, stretch, q)
    _tetrahedra(s.tetrahedron_edge, s.tetrahedron, stretch, q)
    _many(s.six_edge, s.six, stretch, q)


@kernel_bare
def _stretches(s: EdgeElements, x: F1, stretch: F1) -> None:
    A, B, start = s.A, s.B, s.start
    # s = |d|^2 - |d_0|^2 = (u_q - u_p) . (d + d_0) with displacements u: small ones to all digits, and 0 where nothing moves
    for i in range(stretch.size):
        a, b, total = A[i], B[i], 0.0
        for c in range(3):
            moved = (x[b + c] - start[b + c]) - (x[a + c] - start[a + c])
            total += moved * ((x[b + c] - x[a + c]) + (start[b + c] - start[a + c]))
        stretch[i] = total


@kernel_bare
def _rates(s: EdgeElements, x: F1, v: F1, rate: F1) -> None:
    A, B = s.A, s.B
    # s' = 2 d . d'
    for i in range(rate.size):
        a, b, total = A[i], B[i], 0.0
        for c in range(3):
            total += (x[b + c] - x[a + c]) * (v[b + c] - v[a + c])
        rate[i] = 2.0 * total


@kernel_bare
def _add_edge_forces(s: EdgeElements, q: F1, x: F1, f: F1) -> None:
    A, B = s.A, s.B
    # q d at A, -q d at B
    for i in range(q.size):
        a, b = A[i], B[i]
        for c in range(3):
            push = q[i] * (x[b + c] - x[a + c])
            f[a + c] += push
            f[b + c] -= push


@kernel
def force(s: EdgeElements, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    stretch, q = np.empty(s.A.size), np.empty(s.A.size)
    _stretches(s, x, stretch)
    edge_densities(s, stretch, q)
    _add_edge_forces(s, q, x, f)


@kernel
def energy(s: EdgeElements, x: F1) -> float:
    """As kernels.structure.element_table.energy."""
    stretch, q, total = np.empty(s.A.size), np.empty(s.A.size), 0.0
    _stretches(s, x, stretch)
    edge_densities(s, stretch, q)
    # s^T G s/2 = q . s/4
    for i in range(q.size):
        total += 0.25 * q[i] * stretch[i]
    return total


@kernel
def balance(s: EdgeElements, t: float, x: F1, v: F1, out: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.balance."""
    count = s.A.size
    stretch, rate, q = np.empty(count), np.empty(count), np.empty(count)
    _stretches(s, x, stretch)
    _rates(s, x, v, rate)
    edge_densities(s, stretch, q)
    # s^T G s/2 = q . s/4, and its rate q . s'/2
    for i in range(count):
        out[0] += 0.25 * q[i] * stretch[i]
        out[1] += 0.5 * q[i] * rate[i]


@kernel
def swap(s: EdgeElements, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.swap: forces of the mean stretches at x0 and x1, whose work is the energy taken.

    Energy is quadratic in the squared lengths and these in the positions, so this is the discrete gradient; the mean of the
    squared lengths exceeds that in the middle by |d1 - d0|^2/4.
    """
    A, B = s.A, s.B
    stretch, q = np.empty(A.size), np.empty(A.size)
    # |d_1 - d_0|^2/4: mean of both squared lengths less that of the midpoint
    for i in range(stretch.size):
        a, b, square = A[i], B[i], 0.0
        for c in range(3):
            change = (x1[b + c] - x0[b + c]) - (x1[a + c] - x0[a + c])
            square += change * change
        stretch[i] = 0.25 * square
    edge_densities(s, stretch, q)
    _add_edge_forces(s, q, xe, f)


@kernel
def _of_group(v: int, edge: I2, stiffness: F2, d: F2, out: F2) -> None:
    """Material tangent of elements with v nodes added to out (edges, 9); d (edges, 3) from the first end to the second."""
    w = v * (v - 1) // 2
    full, y, own = np.empty((w, w)), np.empty((w, 3)), np.empty((v, v, 3))
    pair = np.zeros((v, v), np.int64)
    count = 0
    # number of the edge between nodes a and b
    for a in range(v):
        for b in range(a + 1, v):
            pair[a, b] = pair[b, a] = count
            count += 1
    # 2 (2 G)_ij d_i d_j^T summed over the edges i of a and j of b, for each pair of nodes of each element
    for k in range(edge.shape[0]):
        at = 0
        for i in range(w):
            for j in range(i, w):
                full[i, j] = full[j, i] = 2.0 * stiffness[k, at]
                at += 1
        for a in range(v):
            for b in range(a + 1, v):
                g = edge[k, pair[a, b]]
                for c in range(3):
                    own[a, b, c], own[b, a, c] = -d[g, c], d[g, c]
        for b in range(1, v):
            # what a unit change of the squared lengths at b asks of every edge
            for i in range(w):
                p, q, r = 0.0, 0.0, 0.0
                for m in range(v):
                    if m != b:
                        share = full[i, pair[b, m]]
                        p += share * own[b, m, 0]
                        q += share * own[b, m, 1]
                        r += share * own[b, m, 2]
                y[i, 0], y[i, 1], y[i, 2] = p, q, r
            for a in range(b):
                _add_pair(v, a, pair, own, y, out[edge[k, pair[a, b]]])


@kernel_inline
def _add_pair(v: int, a: int, pair: I2, own: Floats, y: F2, block: F1) -> None:
    """block (9,) += sum over the edges of node a of d y^T."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    # sum over the other nodes m of d_am y_am^T
    for m in range(v):
        if m != a:
            i = pair[a, m]
            ux, uy, uz, p, q, r = own[a, m, 0], own[a, m, 1], own[a, m, 2], y[i, 0], y[i, 1], y[i, 2]
            xx, xy, xz = xx + ux * p, xy + ux * q, xz + ux * r
            yx, yy, yz = yx + uy * p, yy + uy * q, yz + uy * r
            zx, zy, zz = zx + uz * p, zy + uz * q, zz + uz * r
    block[0], block[1], block[2] = block[0] + xx, block[1] + xy, block[2] + xz
    block[3], block[4], block[5] = block[3] + yx, block[4] + yy, block[5] + yz
    block[6], block[7], block[8] = block[6] + zx, block[7] + zy, block[8] + zz


@kernel_inline
def _mixed(f: float, a: Vector, g: float, b: Vector, h: float, c: Vector) -> Vector:
    """f a + g b + h c of three vectors."""
    return f * a[0] + g * b[0] + h * c[0], f * a[1] + g * b[1] + h * c[1], f * a[2] + g * b[2] + h * c[2]


@kernel_inline
def _add_products(block: F1, a: Vector, p: Vector, b: Vector, q: Vector, c: Vector, r: Vector) -> None:
    """block (9,) += a p^T + b q^T + c r^T."""
    block[0] += a[0] * p[0] + b[0] * q[0] + c[0] * r[0]
    block[1] += a[0] * p[1] + b[0] * q[1] + c[0] * r[1]
    block[2] += a[0] * p[2] + b[0] * q[2] + c[0] * r[2]
    block[3] += a[1] * p[0] + b[1] * q[0] + c[1] * r[0]
    block[4] += a[1] * p[1] + b[1] * q[1] + c[1] * r[1]
    block[5] += a[1] * p[2] + b[1] * q[2] + c[1] * r[2]
    block[6] += a[2] * p[0] + b[2] * q[0] + c[2] * r[0]
    block[7] += a[2] * p[1] + b[2] * q[1] + c[2] * r[1]
    block[8] += a[2] * p[2] + b[2] * q[2] + c[2] * r[2]


@kernel_inline
def _of_edge(d: F2, sign: float, i: int) -> Vector:
    return sign * d[i, 0], sign * d[i, 1], sign * d[i, 2]


@kernel_bare
def _of_tetrahedra(edge: I2, stiffness: F2, d: F2, out: F2) -> None:
    """`_of_group` of four nodes written out: it takes a third of the time. y as there."""
    # the same sum for each tetrahedron, with its six edges in registers
    for k in range(edge.shape[0]):
        i0, i1, i2, i3, i4, i5 = edge[k, 0], edge[k, 1], edge[k, 2], edge[k, 3], edge[k, 4], edge[k, 5]
        g = stiffness[k]
        # from the other end to node b, twice, for b = 1, 2, 3
        u0, u3, u4 = _of_edge(d, 2.0, i0), _of_edge(d, -2.0, i3), _of_edge(d, -2.0, i4)
        v1, v3, v5 = _of_edge(d, 2.0, i1), _of_edge(d, 2.0, i3), _of_edge(d, -2.0, i5)
        w2, w4, w5 = _of_edge(d, 2.0, i2), _of_edge(d, 2.0, i4), _of_edge(d, 2.0, i5)
        # from the other end to node a
        a0, a1, a2 = _of_edge(d, -1.0, i0), _of_edge(d, -1.0, i1), _of_edge(d, -1.0, i2)
        b0, b3, b4 = _of_edge(d, 1.0, i0), _of_edge(d, -1.0, i3), _of_edge(d, -1.0, i4)
        c1, c3, c5 = _of_edge(d, 1.0, i1), _of_edge(d, 1.0, i3), _of_edge(d, -1.0, i5)
        y0, y1 = _mixed(g[0], u0, g[3], u3, g[4], u4), _mixed(g[1], u0, g[8], u3, g[9], u4)
        y2 = _mixed(g[2], u0, g[12], u3, g[13], u4)
        _add_products(out[i0], a0, y0, a1, y1, a2, y2)
        y0, y1 = _mixed(g[1], v1, g[3], v3, g[5], v5), _mixed(g[6], v1, g[8], v3, g[10], v5)
        y2, y3 = _mixed(g[7], v1, g[12], v3, g[14], v5), _mixed(g[8], v1, g[15], v3, g[17], v5)
        y4 = _mixed(g[9], v1, g[16], v3, g[19], v5)
        _add_products(out[i1], a0, y0, a1, y1, a2, y2)
        _add_products(out[i3], b0, y0, b3, y3, b4, y4)
        y0, y1 = _mixed(g[2], w2, g[4], w4, g[5], w5), _mixed(g[7], w2, g[9], w4, g[10], w5)
        y2, y3 = _mixed(g[11], w2, g[13], w4, g[14], w5), _mixed(g[12], w2, g[16], w4, g[17], w5)
        y4, y5 = _mixed(g[13], w2, g[18], w4, g[19], w5), _mixed(g[14], w2, g[19], w4, g[20], w5)
        _add_products(out[i2], a0, y0, a1, y1, a2, y2)
        _add_products(out[i4], b0, y0, b3, y3, b4, y4)
        _add_products(out[i5], c1, y1, c3, y3, c5, y5)


@kernel_bare
def _differences(s: EdgeElements, x: F1, d: F2) -> None:
    """d (e, 3) of each edge, from its first end to the second."""
    A, B = s.A, s.B
    # difference of the places of both ends
    for i in range(d.shape[0]):
        for c in range(3):
            d[i, c] = x[B[i] + c] - x[A[i] + c]


@kernel
def edge_blocks(s: EdgeElements, q: F1, x: F1, out: F2) -> None:
    """K_pq of the ends p < q of every edge into out (e, 9), N/m, row by row; q (e,) force densities at x (3 n,)."""
    d = np.empty((q.size, 3))
    _differences(s, x, d)
    # geometric part -q 1 of K_pq
    for i in range(q.size):
        for k in range(9):
            out[i, k] = 0.0
        out[i, 0] = out[i, 4] = out[i, 8] = -q[i]
    _of_group(3, s.triangle_edge, s.triangle, d, out)
    _of_tetrahedra(s.tetrahedron_edge, s.tetrahedron, d, out)
    _of_group(6, s.six_edge, s.six, d, out)


@kernel_bare
def _add_blocks(at: I2, blocks: F2, beta: float, value: F1) -> None:
    # beta K: K_pq between the ends, minus its symmetric part at each end
    for k in range(blocks.shape[0]):
        for c in range(3):
            for d in range(3):
                entry = beta * blocks[k, 3 * c + d]
                value[at[k, 6 * (3 + d) + c]] += entry
                if d <= c:
                    value[at[k, 6 * c + d]] -= 0.5 * (entry + beta * blocks[k, 3 * d + c])
                    value[at[k, 6 * (3 + c) + 3 + d]] -= 0.5 * (entry + beta * blocks[k, 3 * d + c])


@kernel
def tangent(s: EdgeElements, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.tangent: an edge at a time, w = 6."""
    stretch, q, blocks = np.empty(s.A.size), np.empty(s.A.size), np.empty((s.A.size, 9))
    _stretches(s, x, stretch)
    edge_densities(s, stretch, q)
    edge_blocks(s, q, x, blocks)
    _add_blocks(at, blocks, beta, value)


KERNELS = dict(enumerate(zip(element_table.INTERFACES, (force, energy, balance, tangent, swap), strict=True)))
"""By column of the table of kinds: interface and kernel."""

NODES = {"triangle": 3, "tetrahedron": 4, "six": 6}
"""Numbers of nodes of elements by their fields."""


def edge_fields(p: Ints, q: Ints, start: Floats, groups: Mapping[int, tuple[Ints, Floats]]) -> dict[str, NDArray[Any]]:
    """The fields of the record of edges between the nodes p, q (e,), start (n, 3) places of all nodes without stress, m; the
    numbers may be complex, and copies.

    groups : edges and stiffness of elements by their number of nodes.
    """
    lead = start.shape[:-2]
    found: dict[str, Any] = {"A": 3 * p.astype(np.int64), "B": 3 * q.astype(np.int64), "start": start.reshape(*lead, -1)}
    for name, v in NODES.items():
        w = v * (v - 1) // 2
        edge, stiff = groups.get(v, (np.zeros((0, w), np.int64), np.zeros((*lead, 0, w * (w + 1) // 2))))
        found |= {f"{name}_edge": edge, name: stiff}
    return found


def coordinates(s: EdgeElements) -> NDArray[np.int64]:
    """Coordinates (e, 6) of the ends of the edges."""
    return np.concatenate([s.A[:, None] + np.arange(3), s.B[:, None] + np.arange(3)], axis=1)
