"""Elements that resist a coordinate: a sum of terms (kernels.structure.terms), and a law of its value and rate.

With the value q of the coordinate and e = q - rest, taken the shortest way where q is the same after a period, an element
resists with F = V'(e) + R(e, q') and pushes the nodes with -F dq/dx. The law is a kernel of its own for each kind, reached by
its address; all the rest is compiled once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array

from kinetruss.kernels.compiled.calls import Interface
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, I2, Floats, Ints, Record, record
from kinetruss.kernels.coordinates.forms import ALONG, FIXED_AXIS
from kinetruss.kernels.coordinates.straight_line import addresses_of
from kinetruss.kernels.structure import element_table
from kinetruss.kernels.structure.terms import add_term, nearest_turn, term_along, term_gradient, term_rates, term_value

if TYPE_CHECKING:
    from kinetruss.mechanics.system import System

SMALL = 1e-6
"""Change of e, as a fraction of it, below which the mean force over it is that in its middle."""
KEPT, STORED, TAKEN, STIFF, DAMPED = range(5)
"""What a law gives: V' (N or N m), V (J), R, dF/de, dF/dq'."""
SCRATCH = 24 + 5
"""Numbers of scratch: gradient and rates of a term, and what its law gives."""


@Interface
def law(numbers: F1, table: F2, first: int, last: int, e: float, rate: float, out: F1) -> None:
    """KEPT ... DAMPED of an element at e and rate into out (5,).

    numbers (w,) : of the element. table[first:last] : its points, where it has such.
    """


_law_at = law.call


def measures_of(system: System, kind: str) -> NDArray[np.int64]:
    """The measures of the elements of a kind."""
    return system.force_element_measure[system.force_element_spans.get(kind, slice(0))]


def terms_of(system: System, measures: NDArray[np.int64]) -> dict[str, Any]:
    """Terms and periods of measures, as fields of `Part`."""
    spans = [np.arange(*system.measure_ptr[m : m + 2]) for m in measures]
    terms = np.concatenate([*spans, np.zeros(0)]).astype(np.int64)
    return {
        "ptr": np.cumsum([0, *map(len, spans)]),
        "kind": system.term_kind[terms],
        "at": system.term_at[terms],
        "data": system.term_data[..., terms, :],
        "period": system.measure_period[..., measures],
    }


class Part(NamedTuple):
    """The elements of one kind: names, of those that a person knows; the law; why there is no power series of a law that is
    not linear, with {!r} for the name; the other fields of `Scalars`, `kind` of the terms in place of their code; events where
    the law changes its form, for simulations to tell.
    """

    names: tuple[str, ...]
    law: Any
    bent: str
    linear: NDArray[Any]
    loses: NDArray[Any]
    ptr: NDArray[Any]
    kind: NDArray[Any]
    at: NDArray[Any]
    data: NDArray[Any]
    rest: NDArray[Any]
    period: NDArray[Any]
    numbers: NDArray[Any]
    table_ptr: NDArray[Any]
    table: NDArray[Any]
    switches: Mapping[str, Any] = MappingProxyType({})


@record
class Scalars(Record):
    """Elements on coordinates. law (k,) address; linear (k,) 1 where V' is linear in e and R proportional to the rate; loses
    (k,) 1 where R is not 0; rest, period (k,); numbers (k, w), table[table_ptr[k]:table_ptr[k + 1]] (p, 4) of the law.

    Terms ptr[k]:ptr[k + 1] of element k, at most `longest`: kind, form, at, data (kernels.structure.terms); local (t, 4) their
    nodes as counted among those of the element.
    """

    longest: I0
    law: I1
    linear: I1
    loses: I1
    ptr: I1
    kind: I1
    table_ptr: I1
    form: I2
    at: I2
    local: I2
    rest: F1
    period: F1
    numbers: F2
    data: F2
    table: F2


@kernel_bare
def _law(s: Scalars, k: int, e: float, rate: float, scratch: F1) -> None:
    """The law of element k at e and rate into scratch[24:]."""
    _law_at(s.law[k], (s.numbers[k], s.table, s.table_ptr[k], s.table_ptr[k + 1], e, rate, scratch[24:29]))


@kernel_bare
def _deflection(s: Scalars, k: int, x: F1) -> float:
    """e of element k at x."""
    value = 0.0
    for t in range(s.ptr[k], s.ptr[k + 1]):
        value += term_value(s.form, s.at, s.data, t, x)
    return nearest_turn(value - s.rest[k], s.period[k])


@kernel_bare
def _rate(s: Scalars, k: int, x: F1, v: F1, scratch: F1) -> float:
    """q' of element k; the increment of q to first order where v is one."""
    rate = 0.0
    for t in range(s.ptr[k], s.ptr[k + 1]):
        term_gradient(s.form, s.at, s.data, t, x, scratch)
        rate += term_along(s.at, t, scratch, v)
    return rate


@kernel_bare
def _push_term(s: Scalars, t: int, amount: float, x: F1, f: F1, scratch: F1) -> None:
    """f += amount times the gradient of term t."""
    term_gradient(s.form, s.at, s.data, t, x, scratch)
    add_term(s.at, t, scratch, amount, f)


@kernel
def force(s: Scalars, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    scratch, gradients = np.empty(SCRATCH), np.empty((s.longest, 12))
    for k in range(s.law.size):
        first, last, value, rate = s.ptr[k], s.ptr[k + 1], -s.rest[k], 0.0
        # q and q' = dq/dx . v
        for j in range(first, last):
            value += term_value(s.form, s.at, s.data, j, x)
            term_gradient(s.form, s.at, s.data, j, x, gradients[j - first])
            rate += term_along(s.at, j, gradients[j - first], v)
        _law(s, k, nearest_turn(value, s.period[k]), rate, scratch)
        # -F dq/dx
        for j in range(first, last):
            add_term(s.at, j, gradients[j - first], -(scratch[24 + KEPT] + scratch[24 + TAKEN]), f)


@kernel
def energy(s: Scalars, x: F1) -> float:
    """As kernels.structure.element_table.energy."""
    scratch, total = np.empty(SCRATCH), 0.0
    for k in range(s.law.size):
        _law(s, k, _deflection(s, k, x), 0.0, scratch)
        total += scratch[24 + STORED]
    return total


@kernel
def balance(s: Scalars, t: float, x: F1, v: F1, out: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.balance."""
    scratch = np.empty(SCRATCH)
    # V, V' q', R q'
    for k in range(s.law.size):
        rate = _rate(s, k, x, v, scratch)
        _law(s, k, _deflection(s, k, x), rate, scratch)
        out[0] += scratch[24 + STORED]
        out[1] += scratch[24 + KEPT] * rate
        out[2] += scratch[24 + TAKEN] * rate


@kernel
def histories(s: Scalars, x: F2, v: F2, out: Floats) -> None:
    """e, q', the generalised force -F on the coordinate (N or N m) and V (J) along x, v (times, 3 n) into out (4, times, k).

    v : or one row for all times.
    """
    scratch = np.empty(SCRATCH)
    for i in range(x.shape[0]):
        for k in range(s.law.size):
            e, rate = _deflection(s, k, x[i]), _rate(s, k, x[i], v[min(i, v.shape[0] - 1)], scratch)
            _law(s, k, e, rate, scratch)
            out[0, i, k], out[1, i, k] = e, rate
            out[2, i, k], out[3, i, k] = -scratch[24 + KEPT] - scratch[24 + TAKEN], scratch[24 + STORED]


@kernel
def slopes(s: Scalars, x: F1, v: F1, out: F2) -> None:
    """F, dF/dq and dF/dq' of every element at x, v (3 n,) into out (k, 3)."""
    scratch = np.empty(SCRATCH)
    for k in range(s.law.size):
        _law(s, k, _deflection(s, k, x), _rate(s, k, x, v, scratch), scratch)
        out[k, 0] = scratch[24 + KEPT] + scratch[24 + TAKEN]
        out[k, 1], out[k, 2] = scratch[24 + STIFF], scratch[24 + DAMPED]


@kernel_bare
def _add_curvature(s: Scalars, k: int, x: F1, v: F1, amount: float, column: F1, scratch: F1) -> None:
    """column += amount times the Hessian of element k times v, in the order of the nodes of the element."""
    for t in range(s.ptr[k], s.ptr[k + 1]):
        term_rates(s.form, s.at, s.data, t, x, v, scratch)
        for n in range(4):
            at = 3 * s.local[t, n]
            for c in range(3):
                column[at + c] += amount * scratch[12 + 3 * n + c]


@kernel_bare
def _local_gradient(s: Scalars, k: int, x: F1, g: F1, scratch: F1) -> None:
    """dq/dx of element k into g (w,), in the order of its nodes."""
    for i in range(g.size):
        g[i] = 0.0
    for t in range(s.ptr[k], s.ptr[k + 1]):
        term_gradient(s.form, s.at, s.data, t, x, scratch)
        for n in range(4):
            at = 3 * s.local[t, n]
            for c in range(3):
                g[at + c] += scratch[3 * n + c]


@kernel
def blocks(s: Scalars, places: Ints, x: F1, v: F1, resistance: F2, stiff: Floats, damp: Floats) -> None:
    """Minus the derivatives of the forces -F g by x and by v of every element into stiff and damp (elements, w, w).

    places (elements, w) : coordinates of the nodes of each element, ascending, -1 behind the last. resistance (elements, 3) :
    F, dF/dq, dF/dq'. With the Hessian H of q: dF/dq g g^T + F H + dF/dq' g (H v)^T, and dF/dq' g g^T.
    """
    w = places.shape[1]
    scratch, g, bent, unit = np.empty(SCRATCH), np.empty(w), np.empty(w), np.zeros(x.size)
    for k in range(places.shape[0]):
        force, slope, damping = resistance[k, 0], resistance[k, 1], resistance[k, 2]
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
def _mean_force(s: Scalars, k: int, e0: float, e1: float, rate: float, scratch: F1) -> float:
    """(V(e1) - V(e0))/(e1 - e0), and R in the middle at the mean rate."""
    _law(s, k, 0.5 * (e0 + e1), rate, scratch)
    kept, taken = scratch[24 + KEPT], scratch[24 + TAKEN]
    if s.linear[k] == 0 and abs(e1 - e0) > SMALL * (abs(e0) + abs(e1)):
        _law(s, k, e0, rate, scratch)
        stored = scratch[24 + STORED]
        _law(s, k, e1, rate, scratch)
        kept = (scratch[24 + STORED] - stored) / (e1 - e0)
    return kept + taken


@kernel_bare
def _stretch(s: Scalars, t: int, x0: F1, x1: F1) -> float:
    """Change of term t from x0 to x1 over that to first order from their middle; 1 where it is not known."""
    P, one = s.at[t, 0], s.at[t, 1]
    kind, data = s.kind[t], s.data
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


@kernel
def swap(s: Scalars, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.swap.

    A discrete gradient (Gonzalez, J. Nonlinear Sci. 6 (1996) 449): the mean force over the step times dq/dx in its middle,
    that of every term stretched so that its product with x1 - x0 is the change of the term. So it keeps the energy of elements
    on angles about fixed axes (in the plane all), on lengths and coordinates. For others, on angles about moving axes and
    offsets, the gradient is that in the middle: they keep the momenta, and the energy to the order of the step.
    """
    scratch = np.empty(SCRATCH)
    for k in range(s.law.size):
        _law(s, k, _deflection(s, k, xe), _rate(s, k, xe, ve, scratch), scratch)
        there = scratch[24 + KEPT] + scratch[24 + TAKEN]
        e0 = _deflection(s, k, x0)
        change = nearest_turn(_deflection(s, k, x1) - e0, s.period[k])
        mean = _mean_force(s, k, e0, e0 + change, change / h, scratch)
        for j in range(s.ptr[k], s.ptr[k + 1]):
            _push_term(s, j, there - _stretch(s, j, x0, x1) * mean, xe, f, scratch)


@kernel_bare
def _flat_of(s: Scalars, k: int, j: int) -> int:
    """The coordinate that is the local one j of element k; -1 if it has fewer."""
    for t in range(s.ptr[k], s.ptr[k + 1]):
        for n in range(4):
            if s.local[t, n] == j // 3:
                return s.at[t, n] + j % 3
    return -1


@kernel
def tangent(s: Scalars, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """As kernels.structure.element_table.tangent: (beta dF/dq + gamma dF/dq') g g^T + beta F H, g and H gradient and Hessian
    of q, in the order of `local`.
    """
    w = int(math.sqrt(float(at.shape[1])) + 0.5)
    scratch, g, column, unit = np.empty(SCRATCH), np.empty(w), np.empty(w), np.zeros(x.size)
    for k in range(s.law.size):
        _local_gradient(s, k, x, g, scratch)
        rate = _rate(s, k, x, v, scratch)
        _law(s, k, _deflection(s, k, x), rate, scratch)
        size = beta * scratch[24 + STIFF] + gamma * scratch[24 + DAMPED]
        turning = beta * (scratch[24 + KEPT] + scratch[24 + TAKEN])
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


@kernel
def linear_laws(s: Scalars, out: F2) -> None:
    """V', dF/de and dF/dq' of every element at e = 0 and rest, into out (k, 3): all of a linear law."""
    scratch = np.empty(SCRATCH)
    for k in range(s.law.size):
        _law(s, k, 0.0, 0.0, scratch)
        out[k, 0], out[k, 1], out[k, 2] = scratch[24 + KEPT], scratch[24 + STIFF], scratch[24 + DAMPED]


def fields(parts: Sequence[Part]) -> dict[str, NDArray[Any]]:
    """Those of `Scalars`, of all elements on coordinates, kind by kind; their numbers may be complex, and copies."""
    found = {name: np.concatenate([getattr(one, name) for one in parts]) for name in ("linear", "loses", "kind", "at")}
    found |= {name: np.concatenate([getattr(one, name) for one in parts], axis=-1) for name in ("rest", "period")}
    lead = found["rest"].shape[:-1]
    tables = [np.broadcast_to(one.table, (*lead, *one.table.shape[-2:])) for one in parts]
    ends = ([np.diff(one.ptr) for one in parts], [np.diff(one.table_ptr) for one in parts])
    ptr, table_ptr = (np.concatenate([[0], *counts]).cumsum().astype(np.int64) for counts in ends)
    width = max(one.numbers.shape[-1] for one in parts)
    padded = [np.pad(one.numbers, (*[(0, 0)] * (len(lead) + 1), (0, width - one.numbers.shape[-1]))) for one in parts]
    nodes = [np.unique(found["at"][first:last], return_inverse=True)[1].reshape(-1, 4) for first, last in pairwise(ptr)]
    return found | {
        "law": np.concatenate([np.full(len(one.loses), law.address(one.law) if len(one.loses) else 0) for one in parts]),
        "longest": np.array(np.diff(ptr).max(initial=0)),
        "ptr": ptr,
        "table_ptr": table_ptr,
        "form": addresses_of(found["kind"]),
        "local": np.concatenate([*nodes, np.zeros((0, 4), np.int64)]),
        "data": np.concatenate([one.data for one in parts], axis=-2),
        "numbers": np.concatenate(padded, axis=-2),
        "table": np.concatenate(tables, axis=-2),
    }


def alone(s: Scalars, k: int) -> Scalars:
    """The record of element k alone."""
    own, terms = s.arrays(), slice(s.ptr[k], s.ptr[k + 1])
    own |= {name: own[name][[k]] for name in ("law", "linear", "loses", "rest", "period", "numbers")}
    own |= {name: own[name][terms] for name in ("kind", "form", "at", "local", "data")}
    return Scalars.of(own | {"ptr": own["ptr"][k : k + 2] - own["ptr"][k], "table_ptr": own["table_ptr"][k : k + 2]})


def coordinates(s: Scalars) -> NDArray[np.int64]:
    """Coordinates (elements, w) of the nodes of elements, ascending; those that have fewer end with -1."""
    nodes = [np.unique(s.at[first:last]) for first, last in pairwise(s.ptr)]
    places = np.full((len(nodes), max(map(len, nodes), default=0), 3), -1, np.int64)
    for one, own in zip(places, nodes, strict=True):
        one[: len(own)] = own[:, None] + np.arange(3)
    return places.reshape(len(nodes), places.shape[1] * 3)


def tangents(
    system: System,  # noqa: ARG001
    record: Scalars,
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None,
    resistance: NDArray[np.float64] | None = None,
) -> tuple[Any, Any]:
    """K and C (3 n, 3 n), N/m and N s/m: minus the derivatives of the forces -F g by x and by v, both (n, 3).

    resistance (elements, 3) : F, dF/dq and dF/dq', by default those of the laws. g, H : gradient and Hessian of q, so that
    C = dF/dq' g g^T and K = dF/dq g g^T + F H + dF/dq' g (H v)^T.
    """
    places = coordinates(record)
    count, width = places.shape
    made = np.empty((2, count, width, width))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(x.size) if v is None else v))
    if resistance is None:
        resistance = np.zeros((count, 3))
        slopes(record, place, rate, resistance)
    blocks(record, places, place, rate, resistance, *made)
    K, C = (assembled(places, one, x.size) for one in made)
    return K, C


def assembled(places: NDArray[np.int64], blocks: NDArray[np.float64], size: int) -> csr_array:
    """The sum (size, size) of blocks (elements, w, w) at flat coordinates (elements, w), of which -1 stands for none."""
    width = places.shape[1]
    rows, columns = np.repeat(places, width, axis=1).reshape(-1), np.tile(places, (1, width)).reshape(-1)
    own = (rows >= 0) & (columns >= 0)
    return csr_array(coo_array((blocks.reshape(-1)[own], (rows[own], columns[own])), shape=(size, size)))


def geometric(system: System, record: Scalars, x: NDArray[np.float64], u: NDArray[np.float64]) -> Any:
    """As elements.kinds.Element.geometric: F H of the forces dF/dq dq/dx u that the displacements add."""
    place, moved = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, u))
    law, change = np.zeros((len(record.law), 3)), np.empty((4, 1, len(record.law)))
    slopes(record, place, np.zeros(x.size), law)
    histories(record, place[None], moved[None], change)
    return tangents(system, record, x, None, np.column_stack([law[:, 1] * change[1, 0], *np.zeros((2, len(law)))]))[0]


KERNELS = dict(enumerate(zip(element_table.INTERFACES, (force, energy, balance, tangent, swap), strict=True)))
"""By column of the table of kinds: interface and kernel."""
