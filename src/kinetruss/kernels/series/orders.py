"""Orders in time of applied forces and of what drives, supports and rows are held to; the workspace of power series.

Row j of an array is the order j in tau = (t - t0)/s.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.record import F1, F2, I0, Record, record
from kinetruss.kernels.coordinates.tape import Tape
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.rows import SINE, piece_at
from kinetruss.kernels.structure.structure import ANGLE, GREEN, LENGTH


@record
class SeriesWork(Record):
    """axes : in how many something moves, 2 or 3. x (3 n,) places.

    Rows: d (axes r,) differences of their ends, axis by axis; g the same of their directions where some turn at a given angle,
    else empty (they are d); q (r,) force densities, of an angle row forces; squares (r,) of wanted lengths where some change in
    time. motions (d,) of drives and supports. Bars with a law: law_d (3 s,), law_w squares of lengths, law_l lengths, law_r
    quotients by them, law_q densities (s,). Given forces: force_d (3 g,), force_w what they are divided by, force_q (g,)
    densities. sums (2, .), N (r,) : scratch. norms (2, orders) : how large each order is. Sums of terms: tape, adjoints,
    quotients (k,) of the operations of the tape; pushes (p,) : forces on their values (series.measured).
    """

    axes: I0
    x: F2
    d: F2
    g: F2
    q: F2
    squares: F2
    motions: F2
    law_d: F2
    law_w: F2
    law_l: F2
    law_r: F2
    law_q: F2
    force_d: F2
    force_w: F2
    force_q: F2
    sums: F2
    N: F1
    norms: F2
    tape: F2
    adjoints: F2
    quotients: F2
    pushes: F2


_, INTEGERS, REALS = SeriesWork.COUNT


@kernel_bare
def _axes(eq: Equations, stand: F1) -> int:
    """2 where all is and stays in the plane z = 0."""
    free, held = eq.free, eq.held
    # planar where no free coordinate is a z,
    for i in range(free.size):
        if free[i] % 3 == 2:
            return 3
    # none is prescribed,
    for i in range(held.size):
        if held[i] % 3 == 2:
            return 3
    # and all nodes stand at z = 0
    for c in range(2, stand.size, 3):
        if stand[c] != 0.0:
            return 3
    return 2


@kernel
def series_work(eq: Equations, stand: F1, orders: int, tape: Tape) -> SeriesWork:
    """Workspace of the orders 0 to `orders` of the places; stand (3 n,) : where prescribed coordinates are, m."""
    kind, motion = eq.kind, eq.motion
    r, s, g, n = kind.size, eq.law_A.size, eq.force_kind.size, stand.size
    axes, turning, moving = _axes(eq, stand), False, False
    # angles need n(t), prescribed lengths need L(t)^2
    for k in range(r):
        turning = turning or kind[k] == ANGLE
        moving = moving or motion[k] >= 0
    rows, widest, k, p = orders + 1, max(axes * r, 3 * s, n), tape.op.size, tape.out.size
    # in the order of the fields
    shapes = (
        (rows, n), (rows, axes * r), (rows if turning else 0, axes * r), (rows, r),
        (rows if moving else 0, r), (rows, eq.motion_kind.size),
        (rows, 3 * s), (rows, s), (rows, s), (rows, s), (rows, s),
        (rows, 3 * g), (rows, g), (rows, g), (2, widest), (r, 1), (2, rows),
        (rows, k), (rows, k), (rows, k), (rows, p),
    )  # fmt: skip
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    work = SeriesWork(ints, reals)
    work.axes = axes
    return work


# Orders in time of what drives, supports and rows are held to.


@kernel_bare
def _sine(data: F1, t: float, s: float, last: int, now: F2, d: int) -> None:
    """mean + amplitude sin(w t + phase): every order is the derivative before it over the order."""
    turn, angle, scale = data[2] * s, data[2] * t + data[3], data[1]
    first, second = math.sin(angle), math.cos(angle)
    # Taylor coefficients of A sin(w t + phase): A (w s)^j/j! times the j-th derivative of the sine
    for j in range(last + 1):
        now[j, d] = scale * first
        first, second = second, -first
        scale *= turn / (j + 1)
    now[0, d] += data[0]


@kernel_bare
def _polynomial(piece: F1, from_start: float, s: float, last: int, now: F2, d: int) -> None:
    """A polynomial about another place, by repeated synthetic division; from_start : s."""
    # coefficients about the start of the piece
    for j in range(last + 1):
        now[j, d] = piece[j] if j < piece.size else 0.0
    degree = min(piece.size - 1, last)
    # Horner's shift (synthetic division) to the new centre
    for j in range(degree):
        for k in range(degree - 1, j - 1, -1):
            now[k, d] += from_start * now[k + 1, d]
    scale = 1.0
    # from t to tau = (t - t0)/s
    for j in range(degree + 1):
        now[j, d] *= scale
        scale *= s


@kernel_bare
def motion_series(eq: Equations, work: SeriesWork, t: float, s: float) -> None:
    """Motions of drives and supports about t (s)."""
    kind, now = eq.motion_kind, work.motions
    start, last = eq.piece_start, now.shape[0] - 1
    # Taylor coefficients of each prescribed motion
    for d in range(kind.size):
        if kind[d] == SINE:
            _sine(eq.motion_data[d], t, s, last, now, d)
            continue
        i = piece_at(eq.motion_ptr, start, d, t)
        _polynomial(eq.piece[i], t - start[i], s, last, now, d)


@kernel_bare
def _direction(now: F1, angle: float, G: F2, k: int, r: int) -> None:
    """(-sin, cos) of a series of an angle: c' = -w' s, s' = w' c. now (orders,) : the angle; empty where it rests."""
    G[0, k], G[0, r + k] = -math.sin(angle), math.cos(angle)
    # n = (-sin, cos): orders of s' = w' c and c' = -w' s
    for j in range(1, G.shape[0]):
        first, second = 0.0, 0.0
        for i in range(1, j + 1 if now.size else 0):
            first -= i * now[i] * G[j - i, r + k]
            second += i * now[i] * G[j - i, k]
        G[j, k], G[j, r + k] = first / j, second / j


@kernel_bare
def row_series(eq: Equations, ws: Workspace, work: SeriesWork) -> None:
    """Squares of lengths that change, directions of lines that turn, as drives want them."""
    kind, motion, target = eq.kind, eq.motion, ws.target
    now, squares, G, r = work.motions, work.squares, work.g, kind.size
    nothing = now[0, :0]
    # n(t) of prescribed angles, L(t)^2 of prescribed lengths (Cauchy product)
    for k in range(r):
        d = motion[k]
        if kind[k] == ANGLE:
            _direction(now[:, d] if d >= 0 else nothing, target[0, k], G, k, r)
        elif d >= 0 and kind[k] == LENGTH:
            for j in range(now.shape[0]):
                total = 0.0
                for i in range(j + 1):
                    total += now[i, d] * now[j - i, d]
                squares[j, k] = total


# Orders in time of applied forces: bars with a law, given forces (laws: structure.laws).
#
# A force along d is q d. Lengths: L L = d . d; quotients: (N/L) L = N; of both the highest order stands alone.


@kernel_bare
def law_lengths(eq: Equations, work: SeriesWork, j: int) -> None:
    """Order j of the differences and lengths of bars with a law; the places must be known to that order."""
    A, B, X = eq.law_A, eq.law_B, work.x
    D, W, L, axes, count = work.law_d, work.law_w, work.law_l, work.axes, A.size
    # D_j = order j of d = x_B - x_A
    for c in range(axes):
        for k in range(count):
            D[j, c * count + k] = X[j, B[k] + c] - X[j, A[k] + c]
    # W_j = order j of d . d = 2 sum_(i < j/2) D_i . D_(j-i), and D_(j/2) . D_(j/2) where j is even
    for k in range(count):
        W[j, k] = 0.0
    for i in range((j + 1) // 2):
        for c in range(axes):
            for k in range(count):
                W[j, k] += 2.0 * D[i, c * count + k] * D[j - i, c * count + k]
    if j % 2 == 0:
        for c in range(axes):
            for k in range(count):
                W[j, k] += D[j // 2, c * count + k] * D[j // 2, c * count + k]
    if j == 0:
        # order 0 of the length is the root of that of its square
        for k in range(count):
            L[0, k] = math.sqrt(W[0, k])
        return
    # L L = W: 2 L_0 L_j = W_j - sum_(0<i<j) L_i L_(j-i)
    for k in range(count):
        L[j, k] = W[j, k]
    # the inner products of the sum
    for i in range(1, j):
        for k in range(count):
            L[j, k] -= L[i, k] * L[j - i, k]
    # solved for L_j
    for k in range(count):
        L[j, k] *= 0.5 / L[0, k]


@kernel_bare
def _densities(eq: Equations, work: SeriesWork, j: int, s: float) -> None:
    """Order j of the force densities; the lengths must be known to the order j + 1."""
    kind, law = eq.law_kind, eq.law
    W, L, R, Q, count = work.law_w, work.law_l, work.law_r, work.law_q, kind.size
    # order j of N = k (L - l0) + c L'; of Green's law the density q itself is linear in W
    for k in range(count):
        stiffness, natural, damping = law[k, 0], law[k, 1], law[k, 2]
        R[j, k] = damping * (j + 1.0) * L[j + 1, k] / s
        Q[j, k] = 0.0
        if kind[k] == GREEN:
            Q[j, k] = 0.5 * stiffness * (W[j, k] / (natural * natural) - (1.0 if j == 0 else 0.0))
        else:
            R[j, k] += stiffness * (L[j, k] - (natural if j == 0 else 0.0))
    # quotient R = N/L: L_0 R_j = N_j - sum_(i>0) L_i R_(j-i)
    for i in range(1, j + 1):
        for k in range(count):
            R[j, k] -= L[i, k] * R[j - i, k]
    # q = N/L, and of Green's law its elastic part
    for k in range(count):
        R[j, k] /= L[0, k]
        Q[j, k] += R[j, k]


@kernel_bare
def law_order(eq: Equations, work: SeriesWork, j: int, s: float, f: F1) -> None:
    """f += order j of the tensions of bars with a law."""
    _densities(eq, work, j, s)
    A, B = eq.law_A, eq.law_B
    D, Q, sums, axes, count = work.law_d, work.law_q, work.sums[0], work.axes, A.size
    # order j of q d
    for m in range(axes * count):
        sums[m] = 0.0
    # Cauchy product: sum_i Q_i D_(j-i)
    for i in range(j + 1):
        for c in range(axes):
            at = c * count
            for k in range(count):
                sums[at + k] += Q[i, k] * D[j - i, at + k]
    # q d at A towards B, -q d at B
    for c in range(axes):
        for k in range(count):
            f[A[k] + c] += sums[c * count + k]
            f[B[k] + c] -= sums[c * count + k]


@kernel_bare
def _amount(time: F1, value: F1, first: int, last: int, t: float) -> tuple[float, float]:
    """Entry of a table just behind t, and its slope: linear between, held outside."""
    if last - first == 1 or t < time[first]:
        return value[first], 0.0
    # first interval of the table that ends behind t
    for k in range(first, last - 1):
        if t < time[k + 1]:
            slope = (value[k + 1] - value[k]) / (time[k + 1] - time[k])
            return value[k] + slope * (t - time[k]), slope
    return value[last - 1], 0.0


@kernel_bare
def table_order(eq: Equations, g: int, t: float, s: float, j: int) -> float:
    """Order j of the amount of the given force g; t (s) is where the series begins."""
    value, slope = _amount(eq.force_time, eq.force_value, eq.force_ptr[g], eq.force_ptr[g + 1], t)
    return value if j == 0 else slope * s if j == 1 else 0.0


@kernel_bare
def _divisor(D: F2, W: F2, g: int, count: int, j: int, angle: bool) -> float:
    """Order j of what the force g is divided by: the square of the length (a torque), or the length."""
    total = 0.0
    # order j of d . d
    for i in range(j + 1):
        for c in range(3):
            total += D[i, c * count + g] * D[j - i, c * count + g]
    if angle:
        return total
    if j == 0:
        return math.sqrt(total)
    # square root: 2 L_0 L_j = W_j - sum_(0<i<j) L_i L_(j-i)
    for i in range(1, j):
        total -= W[i, g] * W[j - i, g]
    return 0.5 * total / W[0, g]


@kernel_bare
def given_order(eq: Equations, work: SeriesWork, t: float, s: float, j: int, f: F1) -> None:
    """f += order j of given forces; t (s) is where the series begins."""
    kind, A, B = eq.force_kind, eq.force_A, eq.force_B
    X, D, W, Q, count = (
        work.x,
        work.force_d,
        work.force_w,
        work.force_q,
        kind.size,
    )
    # order j of F d/L of a thrust, of T n/L^2 of a torque, by quotient and product of series
    for g in range(count):
        amount, a, b = table_order(eq, g, t, s, j), A[g], B[g]
        if kind[g] == e.COORDINATE_FORCE:
            f[a] += amount
            continue
        if kind[g] == e.SUM_FORCE:
            continue
        angle = kind[g] == e.ANGLE_FORCE
        for c in range(3):
            D[j, c * count + g] = X[j, b + c] - X[j, a + c]
        W[j, g] = _divisor(D, W, g, count, j, angle)
        for i in range(1, j + 1):
            amount -= W[i, g] * Q[j - i, g]
        Q[j, g] = amount / W[0, g]
        px, py, pz = 0.0, 0.0, 0.0
        for i in range(j + 1):
            px += Q[i, g] * D[j - i, g]
            py += Q[i, g] * D[j - i, count + g]
            pz += Q[i, g] * D[j - i, 2 * count + g]
        if angle:
            px, py, pz = -py, px, 0.0
        f[a] -= px
        f[a + 1] -= py
        f[a + 2] -= pz
        f[b] += px
        f[b + 1] += py
        f[b + 2] += pz
