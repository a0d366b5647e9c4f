"""Tables in time."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1


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
