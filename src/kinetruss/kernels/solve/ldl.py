"""L D L^T of sparse symmetric matrices, real or complex, on a pattern that is found once: column by column, without swaps.

Values stand in one array: entries below the diagonal column by column, `below` their rows and ptr[j]:ptr[j + 1] those of column
j, then the diagonal. Factors take their place, reciprocals of D that of the diagonal. `target` says where each product of two
entries of a column goes, in the order in which they are made; without targets, columns reach without a gap as far as they reach
(a skyline), and products go side by side. Davis, Direct Methods for Sparse Linear Systems, 2006, chapter 4.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, I1
from kinetruss.kernels.compiled.views import view

__all__ = ["COORDINATE", "REDUNDANT", "ROW", "ldl_dropped", "ldl_factor", "ldl_pattern", "ldl_solve", "ldl_targets"]

COORDINATE, ROW, REDUNDANT = 2, 0, 1
"""What stands at a place: a coordinate, a row, a redundant row."""
DROP = 1e-11
"""Pivot of a row, as a share of what the coordinates give to it, below which it depends on rows before it."""


@kernel
def ldl_pattern(n: int, upper_ptr: I1, upper_row: I1, parent: I1, flag: I1, count: I1, below: I1) -> None:
    """Elimination tree and, in two passes, the pattern of L: with empty `below` the column counts, else the rows.

    upper_ptr, upper_row : rows above the diagonal of each column. Davis, section 4.1.
    """
    fill = below.size > 0
    # row k of L: paths in the elimination tree from the entries of row k of the matrix up to k
    for k in range(n):
        flag[k] = k
        if not fill:
            parent[k] = -1
        for at in range(upper_ptr[k], upper_ptr[k + 1]):
            i = upper_row[at]
            while flag[i] != k:
                if not fill and parent[i] == -1:
                    parent[i] = k
                if fill:
                    below[count[i]] = k
                count[i] += 1
                flag[i] = k
                i = parent[i]


@kernel
def ldl_targets(ptr: I1, below: I1, target: I1) -> int:
    """Fill `target`; returns how many there are."""
    at = 0
    # column j updates entry (below[b], below[a]) of column below[a]
    for j in range(ptr.size - 1):
        for a in range(ptr[j], ptr[j + 1]):
            p = ptr[below[a]]
            for b in range(a + 1, ptr[j + 1]):
                while below[p] != below[b]:
                    p += 1
                if at < target.size:
                    target[at] = p
                at += 1
    return at


@kernel_inline
def _column(ptr: I1, below: I1, target: I1, value: F1, j: int, inverse: float, at: int) -> int:
    """Column j scaled by its pivot, its outer product taken off the columns behind; returns the next place of `target`."""
    entries, last, skyline = below.size, ptr[j + 1], target.size == 0
    value[entries + j] = inverse
    for a in range(ptr[j], last):
        y = value[a]
        factor = y * inverse
        value[a] = factor
        i = below[a]
        value[entries + i] -= factor * y
        if skyline:
            if factor != 0.0:
                more = last - a - 1
                to, rest = view(value, ptr[i], more), view(value, a + 1, more)
                for b in range(more):
                    to[b] -= factor * rest[b]
        else:
            for b in range(a + 1, last):
                value[target[at]] -= factor * value[b]
                at += 1
    return at


@kernel_bare
def ldl_factor(ptr: I1, below: I1, target: I1, value: F1) -> None:
    """L D L^T in place; value (entries + n,) may be complex."""
    at = 0
    for j in range(ptr.size - 1):
        at = _column(ptr, below, target, value, j, 1.0 / value[below.size + j], at)


@kernel_bare
def ldl_dropped(ptr: I1, below: I1, target: I1, value: F1, sort: I1, gain: F1) -> float:
    """L D L^T in place of [[M, J^T], [J, 0]], M positive; coordinates without mass and rows that depend on others are dropped.

    sort (n,) : what stands at a place, each row behind all coordinates that it touches. gain (n,) : written, the diagonal of
    J M^-1 J^T as far as coordinates are eliminated. Returns the square root of the smallest pivot of rows that are not
    redundant, as a share of that.
    """
    smallest, at, entries = 1.0, 0, below.size
    for j in range(sort.size):
        gain[j] = 0.0
    for j in range(sort.size):
        inverse, smallest = _pivot(j, sort, value[entries + j], gain, smallest)
        if sort[j] == COORDINATE:
            for a in range(ptr[j], ptr[j + 1]):
                gain[below[a]] += value[a] * inverse * value[a]
        at = _column(ptr, below, target, value, j, inverse, at)
    return math.sqrt(smallest)


@kernel_bare
def _pivot(j: int, sort: I1, d: float, gain: F1, smallest: float) -> tuple[float, float]:
    """Reciprocal of the pivot at place j, 0 where it is dropped, and the smallest scaled pivot so far."""
    if sort[j] == COORDINATE:
        return (1.0 / d, smallest) if 0.0 < d < math.inf else (0.0, 0.0)
    share = -d / gain[j] if gain[j] > 0.0 else 0.0
    if sort[j] == ROW and not share >= smallest:
        smallest = share if share > 0.0 else 0.0
    return (1.0 / d if DROP < share < math.inf else 0.0), smallest


@kernel_bare
def ldl_solve(ptr: I1, below: I1, target: I1, value: F1, b: F1) -> None:
    """L D L^T y = b in place; value and b (n,) both real or both complex."""
    n, entries = ptr.size - 1, below.size
    if target.size == 0:
        _solve_skyline(ptr, entries, value, b)
        return
    # forward substitution L z = b
    for j in range(n):
        y = b[j]
        for a in range(ptr[j], ptr[j + 1]):
            b[below[a]] -= value[a] * y
    # D^-1 and back substitution L^T y = D^-1 z
    for j in range(n - 1, -1, -1):
        y = b[j] * value[entries + j]
        for a in range(ptr[j], ptr[j + 1]):
            y -= value[a] * b[below[a]]
        b[j] = y


@kernel_bare
def _solve_skyline(ptr: I1, entries: int, value: F1, b: F1) -> None:
    """The same where columns have no gaps."""
    n = ptr.size - 1
    # forward substitution L z = b
    for j in range(n):
        count, y = ptr[j + 1] - ptr[j], b[j]
        column, rest = view(value, ptr[j], count), view(b, j + 1, count)
        for a in range(count):
            rest[a] -= column[a] * y
    # D^-1 and back substitution L^T y = D^-1 z
    for j in range(n - 1, -1, -1):
        count = ptr[j + 1] - ptr[j]
        column, rest = view(value, ptr[j], count), view(b, j + 1, count)
        # four sums side by side: one would wait for itself
        p, q, r, s = 0.0 * b[j], 0.0 * b[j], 0.0 * b[j], 0.0 * b[j]
        whole = count - count % 4
        for a in range(0, whole, 4):
            p += column[a] * rest[a]
            q += column[a + 1] * rest[a + 1]
            r += column[a + 2] * rest[a + 2]
            s += column[a + 3] * rest[a + 3]
        for a in range(whole, count):
            p += column[a] * rest[a]
        b[j] = b[j] * value[entries + j] - ((p + q) + (r + s))
