"""Bearings with friction: how fast they turn, the nodal forces that a couple in them is worth, and the forces that press them.

A pin is between two bars of the plane, or a bar and the ground; a hinge between a member and a hub in space. The force R that
presses a bearing is what the joint does to the end of its member: it is linear in accelerations and row forces,

    R = R_0(t, x, v) + sum M_j (a_j - g) + sum w N u + ...

with all that acts on the member between its ends replaced by forces at them (dynamics.joint_loads makes the table).
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Floats, Record, Vector, record
from kinetruss.kernels.structure.element_table import forces_of
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.laws import law_tension, length_rate
from kinetruss.kernels.structure.mass import at, between, direction, dot, pair_times, varying_forces, varying_times
from kinetruss.kernels.structure.tables import entry_at
from kinetruss.kernels.structure.terms import add_term, term_gradient


@record
class Bearings(Record):
    """arm (k,) : mu r, m; slip (k,) : rate at which friction has 76 % of its size, rad/s. All places are flat, 3 node.

    pin (k, 4) : ends A, B of the member and of the other one, -1 of the ground. turn (k, 4) : of a hinge the joint, a node on
    the axis, the far end of the member and a node of the hub off the axis (-1: ground); -1 of a pin. node[ptr[k]:ptr[k + 1]] :
    on which a couple in it acts: A and B of each bar; of a hinge the far end, the joint, and the nodes that carry the hub.
    """

    pin: I2
    turn: I2
    ptr: I1
    node: I1
    arm: F1
    slip: F1


@kernel_inline
def _crossed(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel_inline
def _across(x: F1, joint: int, axis: int, node: int) -> tuple[Vector, Vector]:
    """The axis as a unit vector, and the vector from it to a node."""
    _, a = direction(x, joint, axis)
    d = between(x, joint, node)
    s = dot(d, a)
    return a, (d[0] - s * a[0], d[1] - s * a[1], d[2] - s * a[2])


@kernel_inline
def _bar_rate(x: F1, v: F1, A: int, B: int) -> Vector:
    """d x d'/d^2 of a bar, rad/s."""
    d = between(x, A, B)
    w, square = _crossed(d, between(v, A, B)), dot(d, d)
    return w[0] / square, w[1] / square, w[2] / square


@kernel_inline
def _rate_about(x: F1, v: F1, joint: int, axis: int, node: int) -> tuple[float, Vector]:
    """Turning rate of a node about a moving axis, rad/s, and the axis."""
    a, r = _across(x, joint, axis, node)
    base = between(x, joint, axis)
    # the foot of the node on the axis moves with the axis: v_foot = v_joint + s (v_axis - v_joint)
    s = dot(between(x, joint, node), base) / dot(base, base)
    e, f = between(v, joint, node), between(v, joint, axis)
    return dot(_crossed(r, (e[0] - s * f[0], e[1] - s * f[1], e[2] - s * f[2])), a) / dot(r, r), a


@kernel_bare
def turning_rate(b: Bearings, k: int, x: F1, v: F1) -> Vector:
    """Turning rate of the member of bearing k less that of the other part, rad/s; for v accelerations, its rate at rest."""
    joint, axis, far, hub = b.turn[k, 0], b.turn[k, 1], b.turn[k, 2], b.turn[k, 3]
    if joint >= 0:
        rate, a = _rate_about(x, v, joint, axis, far)
        if hub >= 0:
            rate -= _rate_about(x, v, joint, axis, hub)[0]
        return rate * a[0], rate * a[1], rate * a[2]
    w = _bar_rate(x, v, b.pin[k, 0], b.pin[k, 1])
    if b.pin[k, 2] < 0:
        return w
    o = _bar_rate(x, v, b.pin[k, 2], b.pin[k, 3])
    return w[0] - o[0], w[1] - o[1], w[2] - o[2]


@kernel_inline
def _put(force: Vector, share: float, i: int, out: F2) -> None:
    for c in range(3):
        out[i, c] = share * force[c]


@kernel_inline
def _on_bar(x: F1, A: int, B: int, couple: Vector, i: int, out: F2) -> None:
    """f_B = C x d/d^2 and f_A = -f_B of the part of a couple across a bar into rows i and i + 1."""
    d = between(x, A, B)
    push, square = _crossed(couple, d), dot(d, d)
    _put(push, -1.0 / square, i, out)
    _put(push, 1.0 / square, i + 1, out)


@kernel_bare
def _spread(x: F1, node: I1, first: int, last: int, couple: Vector, out: F2) -> None:
    """The smallest forces on node[first:last] that are worth a couple: a x r_i with (sum |r|^2 1 - r r^T) a = C."""
    middle = 0.0, 0.0, 0.0
    for i in range(first, last):
        p = at(x, node[i])
        middle = middle[0] + p[0], middle[1] + p[1], middle[2] + p[2]
    count = last - first
    mx, my, mz = middle[0] / count, middle[1] / count, middle[2] / count
    xx, yy, zz, xy, xz, yz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(first, last):
        p = at(x, node[i])
        rx, ry, rz = p[0] - mx, p[1] - my, p[2] - mz
        xx, yy, zz = xx + ry * ry + rz * rz, yy + rx * rx + rz * rz, zz + rx * rx + ry * ry
        xy, xz, yz = xy - rx * ry, xz - rx * rz, yz - ry * rz
    # Cramer's rule: G is symmetric, with the rows p, q, s
    p, q, s = (xx, xy, xz), (xy, yy, yz), (xz, yz, zz)
    qs, sp, pq = _crossed(q, s), _crossed(s, p), _crossed(p, q)
    size = dot(p, qs)
    a = (
        (couple[0] * qs[0] + couple[1] * sp[0] + couple[2] * pq[0]) / size,
        (couple[0] * qs[1] + couple[1] * sp[1] + couple[2] * pq[1]) / size,
        (couple[0] * qs[2] + couple[1] * sp[2] + couple[2] * pq[2]) / size,
    )
    for i in range(first, last):
        p = at(x, node[i])
        _put(_crossed(a, (p[0] - mx, p[1] - my, p[2] - mz)), 1.0, i, out)


@kernel_bare
def couple_forces(b: Bearings, k: int, x: F1, couple: Vector, out: F2) -> None:
    """Forces (N) on node[ptr[k]:ptr[k + 1]] that a couple (N m) on the member, and its opposite on the other part, are worth.

    out (nodes, 3) : in its rows from ptr[k] on. A couple about the axis of a hinge is worth C x r/r^2 at the far end of the
    member and its opposite at the joint; the hub takes the opposite of the moment of both.
    """
    i, joint, far = b.ptr[k], b.turn[k, 0], b.turn[k, 2]
    if joint < 0:
        _on_bar(x, b.pin[k, 0], b.pin[k, 1], couple, i, out)
        if b.pin[k, 2] >= 0:
            _on_bar(x, b.pin[k, 2], b.pin[k, 3], (-couple[0], -couple[1], -couple[2]), i + 2, out)
        return
    _, r = _across(x, joint, b.turn[k, 1], far)
    push, square = _crossed(couple, r), dot(r, r)
    push = push[0] / square, push[1] / square, push[2] / square
    _put(push, 1.0, i, out)
    _put(push, -1.0, i + 1, out)
    if b.ptr[k + 1] > i + 2:
        moment = _crossed(push, between(x, joint, far))  # -(d x f)
        _spread(x, b.node, i + 2, b.ptr[k + 1], moment, out)


@kernel
def turning_rates(b: Bearings, x: F2, v: F2, out: Floats) -> None:
    """`turning_rate` of all bearings along x, v (times, 3 n), or v (1, 3 n) at rest, into out (times, bearings, 3)."""
    for i in range(x.shape[0]):
        for k in range(b.arm.size):
            out[i, k, 0], out[i, k, 1], out[i, k, 2] = turning_rate(b, k, x[i], v[min(i, v.shape[0] - 1)])


@kernel
def forces_of_couples(b: Bearings, x: F2, couple: Floats, out: Floats) -> None:
    """`couple_forces` of couples (times, bearings, 3) along x (times, 3 n) into out (times, nodes, 3)."""
    for i in range(x.shape[0]):
        for k in range(b.arm.size):
            c = couple[i, k]
            couple_forces(b, k, x[i], (c[0], c[1], c[2]), out[i])


# The force that presses a bearing.

ROW, TABLE, ELEMENT = 0, 1, 2
"""Where the amount of a pull comes from: N of a row, a table in time, the force of an element on its coordinate."""
ALONG, ACROSS, ACROSS_LENGTH, LEVER, TERM, FIXED = range(6)
"""What it is an amount of: the unit vector from A to B; that turned by 90 degrees, or over the length; the unit vector from A
to B at a node, whose moment bends the member; a term of a coordinate on one of its nodes; a vector."""


@record
class JointLoads(Record):
    """What acts on the ends of the members of bearings, and on the members between them.

    seat (k, 3) : ends A, B of the member, and 0 or 1 of the end that is pressed. mass (k, 4) : AA, AB, BB and the skew part of
    what is constant, kg. varying, law (k,) : index in these tables of the equations, or -1.
    pull (p, 8) : bearing, source and its index, form, and four numbers of the form: A, B and, of a LEVER, node and joint; of a
    TERM the term and whether it counts at its node P (0) or B (1), at node 1 or 2 of the axis (0, 1), and whether these share
    it (1). pull_by (p, 4) : share; a vector or, of a LEVER, the shares of its moment and of its axial force.
    load (l, 3) : bearing, axis, table; load_by (l,) share. Tables ptr[j]:ptr[j + 1] of time and value.
    part_ptr (q + 1,) : rows of the table of kinds `part` that are one part. push (r, 3) : bearing, part, node; push_by (r,).
    element (e, 3) : part, first and last term of its coordinate. form, place, data : all terms, as in structure.terms.
    rub (u, 3) : bearing, bearing whose couple presses it, row of `Bearings.node`; rub_by (u,).
    """

    seat: I2
    varying: I1
    law: I1
    pull: I2
    load: I2
    ptr: I1
    part_ptr: I1
    part: I2
    part_ints: I1
    push: I2
    element: I2
    form: I2
    place: I2
    rub: I2
    mass: F2
    pull_by: F2
    load_by: F1
    time: F1
    value: F1
    part_reals: F1
    push_by: F1
    data: F2
    rub_by: F1


@kernel_inline
def _add(out: F2, k: int, share: float, force: Vector) -> None:
    for c in range(3):
        out[k, c] += share * force[c]


@kernel_bare
def _pulled(p: JointLoads, i: int, amount: float, x: F1, scratch: F1) -> Vector:
    """The vector of pull i, of an amount."""
    form, a, b, by = p.pull[i, 3], p.pull[i, 4], p.pull[i, 5], p.pull_by
    if form == FIXED:
        return amount * by[i, 1], amount * by[i, 2], amount * by[i, 3]
    if form == TERM:
        return _of_term(p, i, amount, x, scratch)
    L, u = direction(x, a, b)
    if form in (ACROSS, ACROSS_LENGTH):
        amount = amount / L if form == ACROSS_LENGTH else amount
        return -amount * u[1], amount * u[0], 0.0
    return amount * u[0], amount * u[1], amount * u[2]


@kernel_inline
def _of_term(p: JointLoads, i: int, amount: float, x: F1, scratch: F1) -> Vector:
    """The force of a term on node 1 or 2 of its axis: that on P (or B) is taken off them, in the shares 1 - s and s of the
    place of the foot on the axis, or off 1 alone.
    """
    t, end, which, shared = p.pull[i, 4], p.pull[i, 5], p.pull[i, 6], p.pull[i, 7]
    term_gradient(p.form, p.place, p.data, t, x, scratch)
    share = 1.0 - which
    if shared:
        one, two = p.place[t, 1], p.place[t, 2]
        base = between(x, one, two)
        s = dot(between(x, one, p.place[t, 3 * end]), base) / dot(base, base)
        share = s if which else 1.0 - s
    share *= -amount
    return share * scratch[9 * end], share * scratch[9 * end + 1], share * scratch[9 * end + 2]


@kernel_bare
def _take(p: JointLoads, i: int, amount: float, x: F1, scratch: F1, out: F2) -> None:
    """Add pull i, of an amount, to the force of its bearing in out (k, 3)."""
    k, by = p.pull[i, 0], p.pull_by
    f = _pulled(p, i, by[i, 0] * amount, x, scratch)
    if p.pull[i, 3] != LEVER:
        _add(out, k, 1.0, f)
        return
    # C x d/d^2 of the moment C about the joint, and the axial part
    d = between(x, p.seat[k, 0], p.seat[k, 1])
    couple, square = _crossed(between(x, p.pull[i, 7], p.pull[i, 6]), f), dot(d, d)
    _add(out, k, by[i, 1] / square, _crossed(couple, d))
    _add(out, k, by[i, 2] * dot(f, d) / square, d)


@kernel_bare
def linear_loads(eq: Equations, p: JointLoads, x: F1, a: F1, N: F1, scratch: F1, out: F2) -> None:
    """Add what accelerations a (3 n,) and row forces N (r,) contribute to the forces of bearings (k, 3), N. scratch (24,)."""
    for k in range(p.seat.shape[0]):
        A, B, end, j = p.seat[k, 0], p.seat[k, 1], p.seat[k, 2], p.varying[k]
        _add(out, k, 1.0, pair_times(p.mass, k, at(a, A), at(a, B))[end])
        if j >= 0:
            L, u = direction(x, A, B)
            _add(out, k, 1.0, varying_times(eq.varying, j, L, u, at(a, A), at(a, B))[end])
    for i in range(p.pull.shape[0]):
        if p.pull[i, 1] == ROW:
            _take(p, i, N[p.pull[i, 2]], x, scratch, out)


@kernel
def _part_force(p: JointLoads, j: int, t: float, x: F1, v: F1, f: F1) -> None:
    """Nodal forces of part j into f (3 n,)."""
    for c in range(f.size):
        f[c] = 0.0
    forces_of(p.part[p.part_ptr[j] : p.part_ptr[j + 1]], p.part_ints, p.part_reals, t, x, v, f)


@kernel
def _element_amount(p: JointLoads, e: int, t: float, x: F1, v: F1, f: F1, g: F1, scratch: F1) -> float:
    """The force of element e on its coordinate: that of the part is it times the gradient g."""
    _part_force(p, p.element[e, 0], t, x, v, f)
    for c in range(g.size):
        g[c] = 0.0
    for k in range(p.element[e, 1], p.element[e, 2]):
        term_gradient(p.form, p.place, p.data, k, x, scratch)
        add_term(p.place, k, scratch, 1.0, g)
    along, square = 0.0, 0.0
    for c in range(g.size):
        along += f[c] * g[c]
        square += g[c] * g[c]
    return along / square


@kernel
def known_loads(eq: Equations, p: JointLoads, t: float, x: F1, v: F1, f: F1, g: F1, scratch: F1, out: F2) -> None:
    """Add what follows from t, x, v alone to the forces of bearings (k, 3), N; f, g (3 n,), scratch (24,) : scratch."""
    down = (-eq.gravity[0], -eq.gravity[1], -eq.gravity[2])
    for k in range(p.seat.shape[0]):
        A, B, end, j, s = p.seat[k, 0], p.seat[k, 1], p.seat[k, 2], p.varying[k], p.law[k]
        _add(out, k, 1.0, pair_times(p.mass, k, down, down)[end])
        if j >= 0:
            L, u = direction(x, A, B)
            _add(out, k, -1.0, varying_forces(eq.varying, j, eq.gravity, L, u, between(v, A, B))[end])
        if s >= 0:
            L, u, rate = length_rate(x, v, A, B)
            _add(out, k, (2.0 * end - 1.0) * law_tension(eq, s, L, rate), u)
    for i in range(p.load.shape[0]):
        j = p.load[i, 2]
        out[p.load[i, 0], p.load[i, 1]] += p.load_by[i] * entry_at(p.time, p.value, p.ptr[j], p.ptr[j + 1], t)
    for i in range(p.push.shape[0]):
        _part_force(p, p.push[i, 1], t, x, v, f)
        _add(out, p.push[i, 0], p.push_by[i], at(f, p.push[i, 2]))
    for i in range(p.pull.shape[0]):
        j = p.pull[i, 2]
        if p.pull[i, 1] == TABLE:
            _take(p, i, entry_at(p.time, p.value, p.ptr[j], p.ptr[j + 1], t), x, scratch, out)
        elif p.pull[i, 1] == ELEMENT:
            _take(p, i, _element_amount(p, j, t, x, v, f, g, scratch), x, scratch, out)


@kernel_bare
def rubbed_loads(p: JointLoads, j: int, force: F2, out: F2) -> None:
    """Add what the nodal forces of the couple in bearing j, rows of `force`, contribute to the forces of bearings (k, 3)."""
    for i in range(p.rub.shape[0]):
        if p.rub[i, 1] == j:
            row = p.rub[i, 2]
            _add(out, p.rub[i, 0], p.rub_by[i], (force[row, 0], force[row, 1], force[row, 2]))


# Coulomb's law with a small rate at which friction is not yet all there.

CLOSE = 1e-14
"""Change of the couples that counts as none, relative to the largest."""
GROWN = 1e6
"""Growth of the change at which the couples count as unbounded."""
MOST = 400
"""Rounds of the fixed point."""


@kernel_bare
def friction_sizes(b: Bearings, x: F1, v: F1, way: F2, most: F1) -> float:
    """Couple over force of every bearing, mu r tanh(w/slip), m, into most (k,), the way of w into way (k, 3); the largest."""
    largest = 0.0
    for k in range(b.arm.size):
        w = turning_rate(b, k, x, v)
        size = math.sqrt(dot(w, w))
        most[k] = b.arm[k] * math.tanh(size / b.slip[k])
        for c in range(3):
            way[k, c] = w[c] / size if size > 0.0 else 0.0
        largest = larger(largest, most[k])
    return largest


@kernel_bare
def settled(most: F1, base: F2, change: Floats, amount: F1, found: F1) -> int:
    """Couples c_k = -most_k |R_k|, R = base + sum c_j change_j, into amount (k,); found (k,) : scratch.

    base (k, 3), N; change (j, k, 3), 1/m. A fixed point, whose rate is mu r/l: far below 1 where joints turn at all. Returns
    -1, or the bearing with the largest couple where there is none.
    """
    first, bearings = 0.0, most.size
    for k in range(bearings):
        amount[k] = 0.0
    for turn in range(MOST):
        moved, largest, worst = 0.0, 0.0, 0
        for k in range(bearings):
            Rx, Ry, Rz = base[k, 0], base[k, 1], base[k, 2]
            for j in range(bearings):
                Rx += amount[j] * change[j, k, 0]
                Ry += amount[j] * change[j, k, 1]
                Rz += amount[j] * change[j, k, 2]
            found[k] = -most[k] * math.sqrt(Rx * Rx + Ry * Ry + Rz * Rz)
        for k in range(bearings):
            step = abs(found[k] - amount[k])
            moved = step if not step <= moved else moved
            amount[k] = found[k]
            if abs(amount[k]) > largest:
                largest, worst = abs(amount[k]), k
        if turn == 0:
            first = moved
        if moved <= CLOSE * largest:
            return -1
        if not moved <= GROWN * first:
            return worst
    return worst
