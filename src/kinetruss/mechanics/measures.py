"""Coordinates of several nodes of a compiled model: values, rates, gradients, and what they depend on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.coordinates.forms import FORMS
from kinetruss.kernels.coordinates.programs import Program
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
    measure_rates(system.term_form, system.term_at, system.term_data, first, last, States(*flat), found, np.zeros(24))
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
    from kinetruss.kernels.coordinates.straight_line import addresses_of
    from kinetruss.kernels.structure.terms import measure_rates

    index = {name: i for i, name in enumerate(system.nodes)}
    kinds, places, data = zip(*terms_of(system.model, index, system.x0, coordinate, 1.0), strict=True)
    arrays = (
        addresses_of(np.array(kinds, np.int64)),
        np.array(places, np.int64).reshape(-1, 4),
        np.array(data, float).reshape(-1, 7),
    )
    flat = [np.ascontiguousarray(y, dtype=float).reshape(len(x), system.x0.size) for y in (x, v, a)]
    found = np.empty((len(x), 3))
    measure_rates(*arrays, 0, len(kinds), States(*flat), found, np.zeros(24))
    if turns(coordinate):
        found[:, 0] = np.unwrap(found[:, 0])
    return found


def measure_gradients(system: System, m: Any, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Gradients (times, 3 n) of measure m at x (times, n, 3)."""
    from kinetruss.kernels.structure.terms import measure_gradient

    found = np.zeros((len(x), system.x0.size))
    scratch, (first, last), form = np.zeros(24), system.measure_ptr[m : m + 2], system.term_form
    for i, y in enumerate(np.ascontiguousarray(x, dtype=float).reshape(len(x), system.x0.size)):
        measure_gradient(form, system.term_at, system.term_data, first, last, y, found[i], scratch)
    return found


def measure_hessian(system: System, m: Any, x: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Flat coordinates (k,) of the nodes of measure m, and its second derivatives (k, k) by these, at x (n, 3)."""
    flats = measure_flats(system, m)
    found, unit = np.zeros((len(flats), len(flats))), np.zeros(x.size)
    for k, flat in enumerate(flats):
        unit[flat] = 1.0
        # column k of the Hessian
        found[k] = _hessian_times(system, m, x.reshape(-1), unit)[flats]
        unit[flat] = 0.0
    return flats, 0.5 * (found + found.T)


def measure_curvature(system: System, m: Any, x: NDArray[np.float64], F: NDArray[np.float64]) -> NDArray[np.float64]:
    """F_i^T H F_j (k, k) of measure m at x (n, 3), for the columns of F (3 n, k)."""
    flats, H = measure_hessian(system, m, x)
    return np.asarray(F[flats].T @ H @ F[flats])


def measure_turning(
    system: System, m: Any, x: NDArray[np.float64], v: NDArray[np.float64] | None, a: NDArray[np.float64] | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """First and second rate (3 n,) of the gradient of measure m at x, v, a (n, 3); None is at rest."""
    from kinetruss.kernels.coordinates.straight_line import address_of_second
    from kinetruss.kernels.structure.terms import measure_second

    y, w, b = (np.zeros(x.size) if one is None else np.ascontiguousarray(one, float).reshape(-1) for one in (x, v, a))
    first, last = system.measure_ptr[m : m + 2]
    out = np.zeros((2, x.size))
    if np.any(w) or np.any(b):
        second = np.array([address_of_second(kind) for kind in system.term_kind.tolist()], np.int64)
        measure_second(second, system.term_at, system.term_data, first, last, States(y, w, b), out, np.zeros(36))
    return out[0], out[1]


def _hessian_times(system: System, m: Any, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """The Hessian of measure m at flat x times v, (3 n,)."""
    from kinetruss.kernels.structure.terms import measure_turning as turning

    first, last = system.measure_ptr[m : m + 2]
    found = np.zeros(x.size)
    turning(system.term_form, system.term_at, system.term_data, first, last, np.ascontiguousarray(x), v, found, np.zeros(24))
    return found


def measure_flats(system: System, m: Any) -> NDArray[np.int64]:
    """Flat coordinates of the nodes of measure m, ascending."""
    nodes = np.unique(system.term_at[system.measure_ptr[m] : system.measure_ptr[m + 1]])
    return np.asarray((nodes[:, None] + np.arange(3)).reshape(-1))


def measure_of(system: System, program: Program, m: int) -> Any:
    """Measure m as an expression of the positions of nodes: the sum of its terms."""
    own = slice(*system.measure_ptr[m : m + 2].tolist())
    return terms_sum(program, system.dim, system.term_kind[own], system.term_at[own], system.term_data[own])


def terms_sum(program: Program, dim: int, kinds: NDArray[np.int64], at: NDArray[np.int64], data: NDArray[np.float64]) -> Any:
    """A sum of terms as an expression of the positions of nodes, in a plane or in space (dim)."""
    found: Any = program.number(0.0)
    for kind, places, (factor, *numbers) in zip(kinds.tolist(), at.tolist(), data.tolist(), strict=True):
        form = FORMS[kind]
        nodes = [program.node(flat // 3, dim) for flat in places[: form.nodes]]
        found = found + form.make(nodes, numbers) * factor
    return found


def sum_arrays(system: System, row: NDArray[np.int64], ptr: NDArray[np.int64], col: NDArray[np.int64]) -> dict[str, Any]:
    """The fields of a `Plan` for sums, from rows in the order of the plan, the pointers of its blocks and their columns."""
    held = system.row_measure[row]
    places = np.flatnonzero(held >= 0)
    measures = held[places]
    terms = [np.arange(system.measure_ptr[m], system.measure_ptr[m + 1]) for m in measures]
    chosen = np.concatenate([*terms, np.zeros(0)]).astype(np.int64)
    term_ptr = np.cumsum([0, *map(len, terms)]).astype(np.int64)
    sum_ptr = np.searchsorted(places, ptr)
    entries: list[tuple[int, int, int, int]] = []
    entry_ptr = [0]
    for b in range(len(ptr) - 1):
        column = {int(flat): k for k, flat in enumerate(col[ptr[b] : ptr[b + 1]])}
        for j in range(sum_ptr[b], sum_ptr[b + 1]):
            for t in range(term_ptr[j], term_ptr[j + 1]):
                nodes = FORMS[system.term_kind[chosen[t]]].nodes
                for c, flat in enumerate((system.term_at[chosen[t], :nodes, None] + np.arange(3)).reshape(-1).tolist()):
                    if flat in column:
                        entries.append((int(places[j]), t, c, column[flat]))
        entry_ptr.append(len(entries))
    if len(places):
        from kinetruss.kernels.structure.sums import of_plan  # compiled; most plans do not need it

        sums = of_plan.addresses()
    else:
        sums = np.zeros(0, np.int64)
    return {
        "sums": sums,
        "sum_ptr": sum_ptr.astype(np.int64),
        "sum_row": places.astype(np.int64),
        "sum_scale": system.measure_scale[measures],
        "sum_period": system.measure_period[measures],
        "term_ptr": term_ptr,
        "term_form": system.term_form[chosen],
        "term_at": system.term_at[chosen],
        "term_data": system.term_data[chosen],
        "sum_entry_ptr": np.array(entry_ptr, np.int64),
        "sum_entry": np.array(entries, np.int64).reshape(-1, 4),
    }


def flats_of(system: System, r: Any) -> NDArray[np.int64]:
    """Flat coordinates that row r may depend on."""
    if (m := system.row_measure[r]) >= 0:
        program = Program()
        return np.array(program.reads(measure_of(system, program, int(m))), np.int64)
    axes = 2 if system.row_kind[r] == ANGLE else 3
    i = system.row_member[r]
    return np.array([3 * node + axis for node in (system.p[i], system.q[i]) for axis in range(axes)], np.int64)
