"""Coordinates of several nodes of a compiled model: values, rates, gradients, and what they depend on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.structure import ANGLE, States
from kinetruss.mechanics.measure_arrays import terms_of
from kinetruss.model import turns

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


def measured(
    system: System,
    m: Any,
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None = None,
    a: NDArray[np.float64] | None = None,
    *,
    along: bool = True,
) -> NDArray[np.float64]:
    """Value, rate and second rate (times, 3) of measure m along x, v, a (times, n, 3).

    along : values unwrapped from one time to the next; else each by itself is the nearest to that at the start.
    """
    from kinetruss.kernels.structure.terms import measure_rates

    size = system.x0.size  # given explicitly: there may be no times
    flat = [np.ascontiguousarray(np.zeros_like(x) if y is None else y, dtype=float).reshape(len(x), size) for y in (x, v, a)]
    found = np.empty((len(x), 3))
    first, last = system.measure_ptr[m : m + 2]
    measure_rates(system.term_kind, system.term_at, system.term_data, first, last, States(*flat), found, np.zeros(10))
    period, start = system.measure_period[m], system.measure_start[m]
    if period > 0.0 and along:
        found[:, 0] = np.unwrap(np.concatenate([[start], found[:, 0]]), period=period)[1:]
    elif period > 0.0:
        found[:, 0] += period * np.rint((start - found[:, 0]) / period)
    return found


def coordinate_derivatives(
    system: System, coordinate: Any, x: NDArray[np.float64], v: NDArray[np.float64], a: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Value, rate and second rate (times, 3) of any coordinate record along x, v, a (times, n, 3); angles unwrapped."""
    from kinetruss.kernels.structure.terms import measure_rates

    index = {name: i for i, name in enumerate(system.nodes)}
    kinds, places, data = zip(*terms_of(system.model, index, system.x0, coordinate, 1.0), strict=True)
    arrays = (np.array(kinds, np.int64), np.array(places, np.int64).reshape(-1, 4), np.array(data, float).reshape(-1, 7))
    flat = [np.ascontiguousarray(y, dtype=float).reshape(len(x), system.x0.size) for y in (x, v, a)]
    found = np.empty((len(x), 3))
    measure_rates(*arrays, 0, len(kinds), States(*flat), found, np.zeros(10))
    if turns(coordinate):
        found[:, 0] = np.unwrap(found[:, 0])
    return found


def measure_gradients(system: System, m: Any, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Gradients (times, 3 n) of measure m at x (times, n, 3)."""
    from kinetruss.kernels.structure.terms import measure_gradient

    found = np.zeros((len(x), system.x0.size))
    scratch, (first, last) = np.zeros(10), system.measure_ptr[m : m + 2]
    for i, y in enumerate(np.ascontiguousarray(x, dtype=float).reshape(len(x), system.x0.size)):
        measure_gradient(system.term_kind, system.term_at, system.term_data, first, last, y, found[i], scratch)
    return found


def measure_flats(system: System, m: Any) -> NDArray[np.int64]:
    """Flat coordinates of the nodes of measure m, ascending."""
    nodes = np.unique(system.term_at[system.measure_ptr[m] : system.measure_ptr[m + 1], :3])
    return np.asarray((nodes[:, None] + np.arange(3)).reshape(-1))


def touched_by(system: System, m: Any) -> NDArray[np.int64]:
    """Flat coordinates that measure m depends on: those of its gradient off any special position."""
    size = float(np.ptp(system.x0, axis=0).max()) or 1.0
    shift = np.random.default_rng(m).standard_normal(system.x0.shape)
    shift[:, system.dim :] = 0.0
    g = measure_gradients(system, m, (system.x0 + 0.1 * size * shift)[None])[0]
    return np.flatnonzero(np.abs(g) > 1e-12 * np.abs(g).max())


def sum_arrays(system: System, row: NDArray[np.int64], ptr: NDArray[np.int64], col: NDArray[np.int64]) -> dict[str, Any]:
    """The fields of a `Plan` for sums, from rows in the order of the plan, the pointers of its blocks and their columns."""
    held = system.row_measure[row]
    places = np.flatnonzero(held >= 0)
    measures = held[places]
    terms = [np.arange(system.measure_ptr[m], system.measure_ptr[m + 1]) for m in measures]
    chosen = np.concatenate([*terms, np.zeros(0)]).astype(np.int64)
    term_ptr = np.cumsum([0, *map(len, terms)]).astype(np.int64)
    sum_ptr = np.searchsorted(places, ptr)
    entries: list[tuple[int, int, int, int, int]] = []
    entry_ptr = [0]
    for b in range(len(ptr) - 1):
        column = {int(flat): k for k, flat in enumerate(col[ptr[b] : ptr[b + 1]])}
        for j in range(sum_ptr[b], sum_ptr[b + 1]):
            for t in range(term_ptr[j], term_ptr[j + 1]):
                for place, flat in enumerate(system.term_at[chosen[t], :3]):
                    own = [(axis, column[flat + axis]) for axis in range(3) if flat + axis in column]
                    entries += [(int(places[j]), t, place, axis, k) for axis, k in own]
        entry_ptr.append(len(entries))
    return {
        "sum_ptr": sum_ptr.astype(np.int64),
        "sum_row": places.astype(np.int64),
        "sum_scale": system.measure_scale[measures],
        "sum_period": system.measure_period[measures],
        "term_ptr": term_ptr,
        "term_kind": system.term_kind[chosen],
        "term_at": system.term_at[chosen],
        "term_data": system.term_data[chosen],
        "sum_entry_ptr": np.array(entry_ptr, np.int64),
        "sum_entry": np.array(entries, np.int64).reshape(-1, 5),
    }


def flats_of(system: System, r: Any) -> NDArray[np.int64]:
    """Flat coordinates that row r may depend on."""
    if (m := system.row_measure[r]) >= 0:
        return touched_by(system, m)
    axes = 2 if system.row_kind[r] == ANGLE else 3
    i = system.row_member[r]
    return np.array([3 * node + axis for node in (system.p[i], system.q[i]) for axis in range(axes)], np.int64)
