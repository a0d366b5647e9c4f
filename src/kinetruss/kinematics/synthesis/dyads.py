"""Burmester's theory: points of a body that lie on one circle, or on one line, in all its positions.

A position takes a point w of the body to D_j w = d_j + e_j w (complex numbers; e_j a unit number). A dyad is a fixed pivot g
and a point w with |D_j w - g| the same for all j, a circle point and its centre point:

    Re(k_j w) - Re(conj(d_j) g) - Re(e_j w conj(g)) + |d_j|^2/2 = const,    k_j = conj(d_j) e_j.

The square of |w| is the same in all positions. So this is linear in w for given g, and linear in g for given w.

Source: L. Burmester, Lehrbuch der Kinematik (1888); J. M. McCarthy, G. S. Soh, Geometric Design of Linkages (2nd ed. 2011),
chapter 5 (design equations of the RR dyad, its curves for four positions, five positions as the roots of a quartic).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Complex = NDArray[np.complex128]

LINES = 160
"""Lines across the region on which the curve of centre points is sampled, in each direction."""

REAL = 1e-7
"""A root whose imaginary part is smaller than this, in units of the task's size, is real."""


def points_for(d: Complex, e: Complex, g: Complex) -> tuple[Complex, NDArray[np.float64]]:
    """The points w (m,) of the body that stay nearest to circles about fixed pivots g (m,), and how far they miss, m^2.

    d, e (n,) : the positions. Three positions leave no residual, so any pivot is the centre of one point.
    """
    rows, right = _equations(d, e, g)
    w = np.linalg.pinv(rows) @ right[..., None]
    left = np.abs(rows @ w - right[..., None]).max((-2, -1))
    return w[:, 0, 0] + 1j * w[:, 1, 0], left


def _equations(d: Complex, e: Complex, g: Complex) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rows (m, n - 1, 2) and right sides (m, n - 1) of the linear equations for w, one set for each pivot."""
    factor = (np.conj(d) * e)[None] - np.conj(g)[:, None] * e[None]  # Re(factor w)
    right = (np.conj(d)[None] * g[:, None]).real - abs(d)[None] ** 2 / 2
    factor, right = factor[:, 1:] - factor[:, :1], right[:, 1:] - right[:, :1]
    return np.stack([factor.real, -factor.imag], -1), right


def centre_curve(d: Complex, e: Complex, low: complex, high: complex) -> Complex:
    """Centre points (m,) of four positions in a rectangle: the roots of the cubic on lines along x and along y."""
    found = []
    for turned in (False, True):
        start, end = ((low.real, high.real), (low.imag, high.imag))[:: -1 if turned else 1]
        middle, half = (end[0] + end[1]) / 2, (end[1] - end[0]) / 2
        nodes = np.array([-1.0, -1 / 3, 1 / 3, 1.0])
        for fixed in np.linspace(*start, LINES):
            places = middle + half * nodes
            g = places + 1j * fixed if turned else fixed + 1j * places
            rows, right = _equations(d, e, g)
            cubic = np.polyfit(nodes, np.linalg.det(np.concatenate([rows, right[..., None]], -1)), 3)
            roots = np.roots(cubic)
            own = roots.real[(abs(roots.imag) < REAL) & (abs(roots.real) <= 1)]
            there = middle + half * own
            found.append(there + 1j * fixed if turned else fixed + 1j * there)
    return np.concatenate(found)


def five(d: Complex, e: Complex) -> tuple[Complex, Complex]:
    """All dyads of five positions, up to four: pivots g and points w.

    The equations are linear in Re, Im (w conj(g)), g, w and 1; what solves them is a plane of vectors m = N (a, b, 1), and the
    first two entries are products of the others: two conics in a and b, whose intersections are the roots of a quartic.
    """
    k = np.conj(d) * e
    columns = [-e.real, e.imag, -d.real, -d.imag, k.real, -k.imag, abs(d) ** 2 / 2]
    rows = np.stack(columns, -1)
    space = np.linalg.svd(rows[1:] - rows[0])[2][4:].T  # 7 x 3
    # generic axes: no intersection at infinity, no two with the same first coordinate
    space = space @ np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    p, q, gx, gy, u, v, one = space
    conics = [_product(p, one) - _product(u, gx) - _product(v, gy), _product(q, one) - _product(v, gx) + _product(u, gy)]
    found = [space @ np.array([a, b, 1.0]) for a, b in _intersections(*conics)]
    kept = np.array([m / m[6] for m in found if abs(m[6]) > REAL * abs(m).max()]).reshape(-1, 7)
    return kept[:, 2] + 1j * kept[:, 3], kept[:, 4] + 1j * kept[:, 5]


def _product(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    """The symmetric matrix of a product of two linear forms."""
    return (np.outer(first, second) + np.outer(second, first)) / 2


def _intersections(first: NDArray[np.float64], second: NDArray[np.float64]) -> list[tuple[float, float]]:
    """Real points (a, b, 1) on two conics: the quartic resultant in a, then b; improved by Newton's method."""

    def in_b(conic: NDArray[np.float64]) -> list[np.poly1d]:
        """Coefficients of b^2, b, 1, polynomials in a."""
        return [
            np.poly1d([conic[1, 1]]),
            np.poly1d([2 * conic[0, 1], 2 * conic[1, 2]]),
            np.poly1d([conic[0, 0], 2 * conic[0, 2], conic[2, 2]]),
        ]

    (p2, p1, p0), (q2, q1, q0) = in_b(first), in_b(second)
    outer, left, right = p2 * q0 - p0 * q2, p2 * q1 - p1 * q2, p1 * q0 - p0 * q1
    found = []
    for a in np.roots((outer * outer - left * right).coeffs):
        if abs(a.imag) > REAL * max(1.0, abs(a)) or left(a.real) == 0:
            continue
        point = np.array([a.real, -outer(a.real) / left(a.real), 1.0])
        for _ in range(8):
            value = np.array([point @ first @ point, point @ second @ point])
            slopes = 2 * np.stack([first @ point, second @ point])[:, :2]
            point[:2] -= np.linalg.lstsq(slopes, value, rcond=None)[0]
        if max(abs(point @ first @ point), abs(point @ second @ point)) < 1e-10 * (point @ point):
            found.append((float(point[0]), float(point[1])))
    return found


def on_lines(d: Complex, e: Complex, count: int) -> Complex:
    """Points w of the body that lie on one line in all positions: of three `count` points on a circle, of four one, else none.

    Of three positions the points are the circle Im((D_2 w - D_1 w) conj(D_3 w - D_1 w)) = 0. Of four two such circles meet in
    the pole of two positions, which is no solution, and in the point that is.
    """
    if len(d) > 4:
        return np.array([], dtype=complex)
    order = np.argsort(-abs(e - e[0]))  # the second position is the one that turns most
    d, e = d[[0, *order[:-1]]], e[[0, *order[:-1]]]
    if abs(e[1] - e[0]) < REAL:
        return np.array([], dtype=complex)
    a, b = d[1:] - d[0], e[1:] - e[0]
    square = (b[0] * np.conj(b[1:])).imag
    # Im(a0 conj(b) conj(w) + b0 conj(a) w) = Re(linear w)
    linear = -1j * b[0] * np.conj(a[1:]) + 1j * np.conj(a[0]) * b[1:]
    pole = -a[0] / b[0]
    if len(d) == 3:
        if abs(square[0]) < REAL:
            return np.array([], dtype=complex)
        centre = -np.conj(linear[0]) / (2 * square[0])
        circle: Complex = centre + abs(pole - centre) * np.exp(2j * np.pi * (np.arange(count) + 0.5) / count)
        return circle
    across = square[1] * linear[0] - square[0] * linear[1]  # the line through both intersections
    best = int(np.argmax(abs(square)))
    if abs(across) < REAL or abs(square[best]) < REAL:
        return np.array([], dtype=complex)
    way = 1j * np.conj(across) / abs(across)
    step = -(2 * square[best] * (pole * np.conj(way)).real + (linear[best] * way).real) / square[best]
    return np.array([pole + step * way])
