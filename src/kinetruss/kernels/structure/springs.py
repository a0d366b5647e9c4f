"""Springs: laws on measures, sums of coordinate terms (structure.terms), and what they do to nodes.

With the value c of its measure and e = c - rest, taken the shortest way where c is the same after a period, a spring resists
with F = V'(e) + R(c'), R = damping c' + friction tanh(c'/slip), and pushes the nodes with -F dc/dx. V' is preload + k s with s
= e less what the play takes of it, or a table (s, V', V'', V) of piecewise cubics. Numbers of a spring are columns of `spring`:
k, rest, damping, friction, slip, play, preload, period.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1, F2, I2, Floats, Ints, Vector
from kinetruss.kernels.coordinates.forms import ALONG, FIXED_AXIS
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.structure import Structure
from kinetruss.kernels.structure.terms import add_term, nearest_turn, term_along, term_gradient, term_rates, term_value

SMALL = 1e-6
"""Change of a deflection, as a fraction of it, below which the mean force over it is that in its middle."""


@kernel_bare
def _cubic(table: F2, first: int, last: int, s: float) -> Vector:
    """V', V'' and V of the points first:last of a table at the deflection s."""
    low, high = first, last - 1
    end = low if s < table[low, 0] else (high if s >= table[high, 0] else -1)
    if end >= 0:
        # straight on behind the last point
        d = s - table[end, 0]
        force, slope = table[end, 1], table[end, 2]
        return force + slope * d, slope, table[end, 3] + force * d + 0.5 * slope * d * d
    # bisection for the piece that holds s
    while high - low > 1:
        middle = (low + high) // 2
        if table[middle, 0] <= s:
            low = middle
        else:
            high = middle
    h = table[high, 0] - table[low, 0]
    t, f0, f1, m0, m1 = (s - table[low, 0]) / h, table[low, 1], table[high, 1], h * table[low, 2], h * table[high, 2]
    # Hermite's cubic f0 + m0 t + a t^2 + b t^3
    a, b = 3.0 * (f1 - f0) - 2.0 * m0 - m1, 2.0 * (f0 - f1) + m0 + m1
    energy = table[low, 3] + h * t * (f0 + t * (m0 / 2.0 + t * (a / 3.0 + t * b / 4.0)))
    return f0 + t * (m0 + t * (a + t * b)), (m0 + t * (2.0 * a + 3.0 * t * b)) / h, energy


@kernel_bare
def _elastic(s: Structure, k: int, e: float) -> Vector:
    """V' (N or N m), V'' and V (J) of spring k at e = c - rest."""
    play, preload = s.spring[k, 5], s.spring[k, 6]
    deflection, free = e - min(max(e, -play), play), play > 0.0 and abs(e) <= play
    first, last = s.spring_table_ptr[k], s.spring_table_ptr[k + 1]
    if last > first:
        force, slope, energy = _cubic(s.spring_table, first, last, deflection)
    else:
        slope = s.spring[k, 0]
        force, energy = slope * deflection, 0.5 * slope * deflection * deflection
    return preload + force, 0.0 if free else slope, preload * e + energy


@kernel_inline
def _resisting(s: Structure, k: int, rate: float) -> tuple[float, float]:
    """R and dR/dc' of spring k."""
    c, friction = s.spring[k, 2], s.spring[k, 3]
    if friction == 0.0:
        return c * rate, c
    share = math.tanh(rate / s.spring[k, 4])
    return c * rate + friction * share, c + friction * (1.0 - share * share) / s.spring[k, 4]


@kernel_bare
def _deflection(s: Structure, k: int, x: F1) -> float:
    """e of spring k at x."""
    value = 0.0
    for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
        value += term_value(s.spring_form, s.spring_at, s.spring_data, t, x)
    return nearest_turn(value - s.spring[k, 1], s.spring[k, 7])


@kernel_bare
def _rate(s: Structure, k: int, x: F1, v: F1, scratch: F1) -> float:
    """c' of spring k; the increment of c to first order where v is one."""
    rate = 0.0
    for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
        term_gradient(s.spring_form, s.spring_at, s.spring_data, t, x, scratch)
        rate += term_along(s.spring_at, t, scratch, v)
    return rate


@kernel_bare
def _push_term(s: Structure, t: int, amount: float, x: F1, f: F1, scratch: F1) -> None:
    """f += amount times the gradient of term t."""
    term_gradient(s.spring_form, s.spring_at, s.spring_data, t, x, scratch)
    add_term(s.spring_at, t, scratch, amount, f)


@kernel_bare
def _push(s: Structure, k: int, amount: float, x: F1, f: F1, scratch: F1) -> None:
    """f += amount dc/dx of spring k."""
    for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
        _push_term(s, t, amount, x, f, scratch)


@kernel
def _add_forces(s: Structure, x: F1, v: F1, f: F1) -> None:
    scratch = np.empty(24)
    # -F dc/dx
    for k in range(s.spring.shape[0]):
        force = _elastic(s, k, _deflection(s, k, x))[0] + _resisting(s, k, _rate(s, k, x, v, scratch))[0]
        _push(s, k, -force, x, f, scratch)


@kernel_late(allocates=True)
def add_spring_forces(s: Structure, x: F1, v: F1, f: F1) -> None:
    """Add to f (3 n,) the nodal forces of springs, N."""
    _add_forces(s, x, v, f)


@kernel_late(allocates=True)
def apply_springs(eq: Equations, x: F1, v: F1, f: F1) -> None:
    """`add_spring_forces` for the equations of motion: a late kernel takes one kind of record."""
    _add_forces(eq, x, v, f)


@kernel_late
def spring_energies(s: Equations, x: F1) -> float:
    """Energy stored in all springs, J."""
    energy = 0.0
    for k in range(s.spring.shape[0]):
        energy += _elastic(s, k, _deflection(s, k, x))[2]
    return energy


@kernel_late(allocates=True)
def spring_balance(s: Structure, x: F1, v: F1, out: F1) -> None:
    """Energy (J) of all springs, its rate (W) and what their damping and friction take (W), added to out (3,)."""
    scratch = np.empty(24)
    # V, V' c', R c'
    for k in range(s.spring.shape[0]):
        rate = _rate(s, k, x, v, scratch)
        force, _, energy = _elastic(s, k, _deflection(s, k, x))
        out[0] += energy
        out[1] += force * rate
        out[2] += _resisting(s, k, rate)[0] * rate


@kernel
def spring_histories(s: Structure, x: F2, v: F2, out: Floats) -> None:
    """e, c', the generalised force -F on the measure (N or N m) and V (J) along x, v (times, 3 n) into out (4, times, springs).

    v : or one row for all times.
    """
    scratch = np.empty(24)
    for i in range(x.shape[0]):
        for k in range(s.spring.shape[0]):
            e = _deflection(s, k, x[i])
            force, _, energy = _elastic(s, k, e)
            rate = _rate(s, k, x[i], v[min(i, v.shape[0] - 1)], scratch)
            out[0, i, k], out[1, i, k] = e, rate
            out[2, i, k], out[3, i, k] = -force - _resisting(s, k, rate)[0], energy


@kernel
def spring_slopes(s: Structure, x: F1, v: F1, out: F2) -> None:
    """F, dF/dc and dF/dc' of every spring at x, v (3 n,) into out (springs, 3)."""
    scratch = np.empty(24)
    for k in range(s.spring.shape[0]):
        force, slope, _ = _elastic(s, k, _deflection(s, k, x))
        resisting, damping = _resisting(s, k, _rate(s, k, x, v, scratch))
        out[k, 0], out[k, 1], out[k, 2] = force + resisting, slope, damping


@kernel_bare
def _add_curvature(s: Structure, k: int, x: F1, v: F1, amount: float, column: F1, scratch: F1) -> None:
    """column += amount times the Hessian of spring k times v, in the order of the nodes of the spring."""
    for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
        term_rates(s.spring_form, s.spring_at, s.spring_data, t, x, v, scratch)
        for n in range(4):
            at = 3 * s.spring_local[t, n]
            for c in range(3):
                column[at + c] += amount * scratch[12 + 3 * n + c]


@kernel_bare
def _local_gradient(s: Structure, k: int, x: F1, g: F1, scratch: F1) -> None:
    """dc/dx of spring k into g (w,), in the order of its nodes."""
    for i in range(g.size):
        g[i] = 0.0
    for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
        term_gradient(s.spring_form, s.spring_at, s.spring_data, t, x, scratch)
        for n in range(4):
            at = 3 * s.spring_local[t, n]
            for c in range(3):
                g[at + c] += scratch[3 * n + c]


@kernel
def spring_blocks(s: Structure, places: Ints, x: F1, v: F1, law: F2, stiff: Floats, damp: Floats) -> None:
    """Minus the derivatives of the forces -F g by x and by v of every spring into stiff and damp (springs, w, w).

    places (springs, w) : coordinates of the nodes of each spring, ascending, -1 behind the last. law (springs, 3) : F, dF/dc,
    dF/dc'. With the Hessian H of c: dF/dc g g^T + F H + dF/dc' g (H v)^T, and dF/dc' g g^T.
    """
    w = places.shape[1]
    scratch, g, bent, unit = np.empty(24), np.empty(w), np.empty(w), np.zeros(x.size)
    for k in range(places.shape[0]):
        force, slope, damping = law[k, 0], law[k, 1], law[k, 2]
        _local_gradient(s, k, x, g, scratch)
        for i in range(w):
            bent[i] = 0.0
        if damping != 0.0:
            _add_curvature(s, k, x, v, damping, bent, scratch)
        for j in range(w):
            for i in range(w):
                stiff[k, j, i] = slope * g[j] * g[i]
                damp[k, j, i] = damping * g[j] * g[i]
            # F H: column j as row j, as H is symmetric
            if force != 0.0 and places[k, j] >= 0:
                unit[places[k, j]] = 1.0
                _add_curvature(s, k, x, unit, force, stiff[k, j], scratch)
                unit[places[k, j]] = 0.0
        for j in range(w):
            for i in range(w):
                stiff[k, j, i] += g[j] * bent[i]


@kernel_bare
def _mean_force(s: Structure, k: int, e0: float, e1: float) -> float:
    """(V(e1) - V(e0))/(e1 - e0)."""
    if s.spring[k, 5] == 0.0 and s.spring_table_ptr[k + 1] == s.spring_table_ptr[k]:
        return s.spring[k, 6] + 0.5 * s.spring[k, 0] * (e0 + e1)
    if abs(e1 - e0) <= SMALL * (abs(e0) + abs(e1)):
        return _elastic(s, k, 0.5 * (e0 + e1))[0]
    return (_elastic(s, k, e1)[2] - _elastic(s, k, e0)[2]) / (e1 - e0)


@kernel_bare
def _stretch(s: Structure, t: int, x0: F1, x1: F1) -> float:
    """Change of term t from x0 to x1 over that to first order from their middle; 1 where it is not known."""
    P, one = s.spring_at[t, 0], s.spring_at[t, 1]
    kind, data = s.spring_kind[t], s.spring_data
    if kind != ALONG and kind != FIXED_AXIS:
        return 1.0
    ax, ay, az = x0[P] - x0[one], x0[P + 1] - x0[one + 1], x0[P + 2] - x0[one + 2]
    bx, by, bz = x1[P] - x1[one], x1[P + 1] - x1[one + 1], x1[P + 2] - x1[one + 2]
    if kind == ALONG:
        # length in the middle over the mean length: L_1 - L_0 = (L_1^2 - L_0^2)/(L_0 + L_1)
        L0, L1 = math.sqrt(ax * ax + ay * ay + az * az), math.sqrt(bx * bx + by * by + bz * bz)
        mx, my, mz = ax + bx, ay + by, az + bz
        return math.sqrt(mx * mx + my * my + mz * mz) / (L0 + L1)
    c0 = data[t, 1] * ax + data[t, 2] * ay + data[t, 3] * az
    s0 = data[t, 4] * ax + data[t, 5] * ay + data[t, 6] * az
    c1 = data[t, 1] * bx + data[t, 2] * by + data[t, 3] * bz
    s1 = data[t, 4] * bx + data[t, 5] * by + data[t, 6] * bz
    cross, dot = c0 * s1 - s0 * c1, c0 * c1 + s0 * s1
    size, angle = math.sqrt(cross * cross + dot * dot), math.atan2(cross, dot)
    # angle times the square of the radius in the middle over the cross product of the ends
    over = 1.0 + angle * angle / 6.0 if abs(angle) < 1e-4 else angle * size / cross
    return 0.25 * ((c0 + c1) ** 2 + (s0 + s1) ** 2) / size * over


@kernel_late(allocates=True)
def swap_springs(s: Equations, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:
    """Replace the forces of springs at (xe, ve), the middle of a step from x0 to x1, in f by those that keep the energy.

    A discrete gradient (Gonzalez, J. Nonlinear Sci. 6 (1996) 449): the mean force over the step times dc/dx in its middle,
    that of every term stretched so that its product with x1 - x0 is the change of the term. So it keeps the energy of springs
    on angles about fixed axes (in the plane all), on lengths and coordinates. For others, on angles about moving axes and
    offsets, the gradient is that in the middle: they keep the momenta, and the energy to the order of the step.
    """
    scratch = np.empty(24)
    for k in range(s.spring.shape[0]):
        kept = _elastic(s, k, _deflection(s, k, xe))[0] + _resisting(s, k, _rate(s, k, xe, ve, scratch))[0]
        e0 = _deflection(s, k, x0)
        change = nearest_turn(_deflection(s, k, x1) - e0, s.spring[k, 7])
        force = _mean_force(s, k, e0, e0 + change) + _resisting(s, k, change / h)[0]
        for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
            _push_term(s, t, kept - _stretch(s, t, x0, x1) * force, xe, f, scratch)


@kernel_bare
def _flat_of(s: Structure, k: int, j: int) -> int:
    """The coordinate that is the local one j of spring k; -1 if it has fewer."""
    for t in range(s.spring_ptr[k], s.spring_ptr[k + 1]):
        for n in range(4):
            if s.spring_local[t, n] == j // 3:
                return s.spring_at[t, n] + j % 3
    return -1


@kernel_late(allocates=True)
def add_springs(s: Equations, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """Add (beta V'' + gamma dR/dc') g g^T + beta F H, g and H gradient and Hessian of c, to the lower triangle in value.

    at (springs, w w) : places of the entries between the w coordinates that a spring has at most, in their order in
    spring_local.
    """
    w = int(math.sqrt(float(at.shape[1])) + 0.5)
    scratch, g, column, unit = np.empty(24), np.empty(w), np.empty(w), np.zeros(x.size)
    for k in range(s.spring.shape[0]):
        _local_gradient(s, k, x, g, scratch)
        rate = _rate(s, k, x, v, scratch)
        force, slope, _ = _elastic(s, k, _deflection(s, k, x))
        resisting, damping = _resisting(s, k, rate)
        size, turning = beta * slope + gamma * damping, beta * (force + resisting)
        for i in range(w):
            for j in range(i + 1):
                value[at[k, w * i + j]] += size * g[i] * g[j]
        if turning == 0.0:
            continue
        # F H, column by column: local coordinate j belongs to the node of the terms that have it
        for j in range(w):
            for i in range(w):
                column[i] = 0.0
            flat = _flat_of(s, k, j)
            if flat < 0:
                continue
            unit[flat] = 1.0
            _add_curvature(s, k, x, unit, turning, column, scratch)
            unit[flat] = 0.0
            for i in range(j, w):
                value[at[k, w * i + j]] += column[i]
