"""Orders in time of what drives, supports and rows are held to (see series.workspace for the parts)."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.constraints.motions import SINE, piece_at
from kinetruss.kernels.series.workspace import SeriesWork
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.plan import ANGLE, LENGTH

__all__ = ["motion_series", "row_series"]


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
