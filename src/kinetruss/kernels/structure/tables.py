"""What kernels read from tables of loads: entries in time, and places of nodes with factors."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, Vector


@kernel_bare
def entry_at(time: F1, value: F1, first: int, last: int, t: float) -> float:
    """Entry of a table at t: linear between, held outside."""
    if t <= time[first] or last - first == 1:
        return value[first]
    if t >= time[last - 1]:
        return value[last - 1]
    low, high = first, last - 1
    # bisection for the interval that holds t
    while high - low > 1:
        middle = (low + high) // 2
        if time[middle] <= t:
            low = middle
        else:
            high = middle
    share = (t - time[low]) / (time[high] - time[low])
    return value[low] + share * (value[high] - value[low])


@kernel_bare
def weighted_place(node: I1, data: F2, first: int, last: int, column: int, x: F1) -> Vector:
    """Sum of a factor, of a column of data, times the places of the nodes first:last, flat coordinates in `node`."""
    a, b, c = 0.0, 0.0, 0.0
    for i in range(first, last):
        at, factor = node[i], data[i, column]
        a, b, c = a + factor * x[at], b + factor * x[at + 1], c + factor * x[at + 2]
    return a, b, c
