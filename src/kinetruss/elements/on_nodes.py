"""Elements on nodes whose law is an expression (kernels.coordinates.node_laws): forces, energies, tangents, steps, results.

With the energy V(x) and the other forces F(t, x, v) of a law, an element pushes its nodes with F - dV/dx; what F takes from the
motion is -F v. A kind is a function of a system that gives its `Part`; `element` makes an entry of elements.kinds of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array

from kinetruss.elements.caching import cached
from kinetruss.elements.element import Element, Results
from kinetruss.elements.scalars import assembled
from kinetruss.kernels.compiled.calls import caller
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, I2, Floats, Ints, Record, record
from kinetruss.kernels.coordinates.node_laws import (
    CURVATURE,
    ENERGY,
    GRADIENT,
    SLOPES,
    VALUES,
    NodeLaw,
    addresses,
    addresses_of_value,
    size_of,
)
from kinetruss.kernels.structure import element_table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System

STORED, GRADIENT_OF, CURVATURE_OF, PUSHED, SLOPES_OF = range(5)
"""Columns of `NodeElements.law`: addresses, 0 where a law has no energy or no other force."""
RIGID = 6
"""Rigid motions in space."""
ROUND_OFF = 1e-14
"""Of a change of energy, relative to the energies at both ends."""
STEP = 1e-3
"""Of differences of tangents, as a fraction of the size of an element."""

_energy, _gradient, _curvature, _values, _slopes = (caller(one) for one in (ENERGY, GRADIENT, CURVATURE, VALUES, SLOPES))


class Part(NamedTuple):
    """The elements of one kind, a word, in a system: their names and law; nodes, by index, of each; numbers (..., elements, k),
    which may be complex, and copies. loses : whether the law's force takes energy; feeds : whether it may give some. grounded :
    the law depends on places or velocities against the ground. says : what the force on the first node is. switches : events by
    name where the law changes its form, for simulations to tell.
    """

    kind: str
    names: tuple[str, ...]
    law: NodeLaw
    nodes: Sequence[Sequence[int]]
    numbers: Any
    loses: bool = True
    feeds: bool = False
    grounded: bool = False
    says: str = "force on the first node"
    switches: Mapping[str, Any] = MappingProxyType({})


@record
class NodeElements(Record):
    """longest : most coordinates of an element. grounded, loses, feeds : 1 if so. law (k, 5) addresses. numbers (k, w). Nodes
    of element k, flat: at[ptr[k]:ptr[k + 1]].
    """

    longest: I0
    grounded: I0
    loses: I0
    feeds: I0
    ptr: I1
    at: I1
    law: I2
    numbers: F2


@kernel_bare
def _add(s: NodeElements, k: int, factor: float, own: F1, f: F1) -> None:
    """f += factor times what `own` has for the coordinates of element k."""
    first = s.ptr[k]
    for n in range(first, s.ptr[k + 1]):
        for c in range(3):
            f[s.at[n] + c] += factor * own[3 * (n - first) + c]


@kernel_bare
def _along(s: NodeElements, k: int, own: F1, y: F1) -> float:
    """What `own` has for the coordinates of element k, times y."""
    first, total = s.ptr[k], 0.0
    for n in range(first, s.ptr[k + 1]):
        for c in range(3):
            total += own[3 * (n - first) + c] * y[s.at[n] + c]
    return total


@kernel
def force(s: NodeElements, t: float, x: F1, v: F1, f: F1) -> None:
    """As kernels.structure.element_table.force."""
    own = np.empty(s.longest)
    for k in range(s.law.shape[0]):
        at = s.at[s.ptr[k] : s.ptr[k + 1]]
        if s.law[k, GRADIENT_OF] != 0:
            _gradient(s.law[k, GRADIENT_OF], (at, s.numbers[k], x, own))
            _add(s, k, -1.0, own, f)
        if s.law[k, PUSHED] != 0:
            _values(s.law[k, PUSHED], (at, s.numbers[k], t, x, v, own))
            _add(s, k, 1.0, own, f)


@kernel_bare
def _stored(s: NodeElements, k: int, x: F1) -> float:
    """The energy of element k."""
    if s.law[k, STORED] == 0:
        return 0.0
    found: float = _energy(s.law[k, STORED], (s.at[s.ptr[k] : s.ptr[k + 1]], s.numbers[k], x))
    return found


@kernel
def energy(s: NodeElements, x: F1) -> float:
    """As kernels.structure.element_table.energy."""
    total = 0.0
    for k in range(s.law.shape[0]):
        total += _stored(s, k, x)
    return total


@kernel
def balance(s: NodeElements, t: float, x: F1, v: F1, out: F1) -> None:
    """As kernels.structure.element_table.balance: V, dV/dx v and -F v."""
    own = np.empty(s.longest)
    for k in range(s.law.shape[0]):
        at = s.at[s.ptr[k] : s.ptr[k + 1]]
        out[0] += _stored(s, k, x)
        if s.law[k, GRADIENT_OF] != 0:
            _gradient(s.law[k, GRADIENT_OF], (at, s.numbers[k], x, own))
            out[1] += _along(s, k, own, v)
        if s.law[k, PUSHED] != 0:
            _values(s.law[k, PUSHED], (at, s.numbers[k], t, x, v, own))
            out[2] -= _along(s, k, own, v)


@kernel
def blocks(s: NodeElements, t: float, x: F1, v: F1, stiff: Floats, damp: Floats) -> None:
    """Minus the derivatives of the forces by x and by v of every element into stiff and damp (elements, w, w), by j in row j.

    K = d2V/dx2 - dF/dx and C = -dF/dv, in the order of the nodes of an element.
    """
    own, unit, none = np.empty(2 * s.longest), np.zeros(x.size), np.zeros(x.size)
    for k in range(s.law.shape[0]):
        at = s.at[s.ptr[k] : s.ptr[k + 1]]
        w = 3 * at.size
        for j in range(s.longest):
            for i in range(s.longest):
                stiff[k, j, i] = 0.0
                damp[k, j, i] = 0.0
        for j in range(w):
            flat = at[j // 3] + j % 3
            unit[flat] = 1.0
            if s.law[k, CURVATURE_OF] != 0:
                _curvature(s.law[k, CURVATURE_OF], (at, s.numbers[k], x, unit, own))
                for i in range(w):
                    stiff[k, j, i] += own[w + i]
            if s.law[k, SLOPES_OF] != 0:
                _slopes(s.law[k, SLOPES_OF], (at, s.numbers[k], t, x, v, unit, none, own))
                for i in range(w):
                    stiff[k, j, i] -= own[w + i]
                _slopes(s.law[k, SLOPES_OF], (at, s.numbers[k], t, x, v, none, unit, own))
                for i in range(w):
                    damp[k, j, i] -= own[w + i]
            unit[flat] = 0.0


@kernel
def tangent(s: NodeElements, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """As kernels.structure.element_table.tangent: the symmetric part, at the time 0."""
    w, count = s.longest, s.law.shape[0]
    stiff, damp = np.empty((count, w, w)), np.empty((count, w, w))
    blocks(s, 0.0, x, v, stiff, damp)
    for k in range(count):
        for i in range(w):
            for j in range(i + 1):
                both = beta * (stiff[k, i, j] + stiff[k, j, i]) + gamma * (damp[k, i, j] + damp[k, j, i])
                value[at[k, w * i + j]] += 0.5 * both


@kernel_bare
def _moved(s: NodeElements, k: int, x0: F1, x1: F1, xe: F1, basis: F2, d: F1) -> float:
    """x1 - x0 of element k less the rigid motions about xe, into d, and its square; of grounded laws with these.

    basis (6, w) : scratch. Translations and rotations, orthogonal to those before; one that they have already is left out.
    """
    first, w = s.ptr[k], 3 * (s.ptr[k + 1] - s.ptr[k])
    square = 0.0
    for i in range(w):
        flat = s.at[first + i // 3] + i % 3
        d[i] = x1[flat] - x0[flat]
        square += d[i] * d[i]
    if s.grounded != 0:
        return square
    for r in range(RIGID):
        e, whole = basis[r], 0.0
        for i in range(w):
            e[i] = 1.0 if r < 3 and i % 3 == r else 0.0
            if r >= 3:
                # unit vector of axis r - 3 times the place against the first node
                a, here = (r - 3 + 1) % 3, s.at[first + i // 3]
                b = (r - 3 + 2) % 3
                if i % 3 == a:
                    e[i] = -(xe[here + b] - xe[s.at[first] + b])
                elif i % 3 == b:
                    e[i] = xe[here + a] - xe[s.at[first] + a]
            whole += e[i] * e[i]
        # twice, as one pass leaves round-off of what is nearly parallel
        for _ in range(2):
            for q in range(r):
                part = 0.0
                for i in range(w):
                    part += e[i] * basis[q, i]
                for i in range(w):
                    e[i] -= part * basis[q, i]
        left = 0.0
        for i in range(w):
            left += e[i] * e[i]
        scale = 1.0 / math.sqrt(left) if left > 1e-20 * whole else 0.0
        part = 0.0
        for i in range(w):
            e[i] *= scale
            part += e[i] * d[i]
        for i in range(w):
            d[i] -= part * e[i]
    square = 0.0
    for i in range(w):
        square += d[i] * d[i]
    return square


@kernel
def swap(s: NodeElements, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.swap.

    Gonzalez' discrete gradient (J. Nonlinear Sci. 6 (1996) 449, eq. 3.4): dV/dx in the middle, and along the change of the
    positions what its product with it lacks of the change of V. Of laws that are not grounded rigid motions are taken out of
    that direction, so that the momenta are kept.
    """
    own, d, basis = np.empty(s.longest), np.empty(s.longest), np.empty((RIGID, s.longest))
    for k in range(s.law.shape[0]):
        if s.law[k, GRADIENT_OF] == 0:
            continue
        before, after = _stored(s, k, x0), _stored(s, k, x1)
        _gradient(s.law[k, GRADIENT_OF], (s.at[s.ptr[k] : s.ptr[k + 1]], s.numbers[k], xe, own))
        lacking = after - before - (_along(s, k, own, x1) - _along(s, k, own, x0))
        square = _moved(s, k, x0, x1, xe, basis, d)
        if abs(lacking) > ROUND_OFF * (abs(before) + abs(after)) and square > 0.0:
            _add(s, k, -lacking / square, d, f)


@kernel
def histories(s: NodeElements, law: I2, t: F1, x: F2, v: F2, out: Floats) -> None:
    """Values of addresses law[k, 0] of every element along x, v (times, 3 n) into out (times, elements, size)."""
    for i in range(x.shape[0]):
        for k in range(s.law.shape[0]):
            _values(law[k, 0], (s.at[s.ptr[k] : s.ptr[k + 1]], s.numbers[k], t[i], x[i], v[i], out[i, k]))


@kernel
def changes(s: NodeElements, law: I2, x: F1, u: F1, out: Floats) -> None:
    """Values at x and rest and their changes with displacements u to first order into out (elements, 2 size)."""
    none = np.zeros(x.size)
    for k in range(s.law.shape[0]):
        _slopes(law[k, 1], (s.at[s.ptr[k] : s.ptr[k + 1]], s.numbers[k], 0.0, x, none, u, none, out[k]))


@kernel
def pushes(s: NodeElements, t: float, x: F1, v: F1, out: F2) -> None:
    """Force of every element on its first node into out (elements, 3)."""
    own = np.empty(s.longest)
    for k in range(s.law.shape[0]):
        at = s.at[s.ptr[k] : s.ptr[k + 1]]
        for c in range(3):
            out[k, c] = 0.0
        if s.law[k, GRADIENT_OF] != 0:
            _gradient(s.law[k, GRADIENT_OF], (at, s.numbers[k], x, own))
            for c in range(3):
                out[k, c] -= own[c]
        if s.law[k, PUSHED] != 0:
            _values(s.law[k, PUSHED], (at, s.numbers[k], t, x, v, own))
            for c in range(3):
                out[k, c] += own[c]


KERNELS = dict(enumerate(zip(element_table.INTERFACES, (force, energy, balance, tangent, swap), strict=True)))
"""By column of the table of kinds: interface and kernel."""


def coordinates(s: NodeElements) -> NDArray[np.int64]:
    """Coordinates (elements, w) of the nodes of elements; those that have fewer end with -1."""
    places = np.full((len(s.law), s.longest // 3, 3), -1, np.int64)
    for one, (first, last) in zip(places, pairwise(s.ptr), strict=True):
        one[: last - first] = s.at[first:last, None] + np.arange(3)
    return places.reshape(len(s.law), s.longest)


def tangents(
    system: System,  # noqa: ARG001
    record: NodeElements,
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None,
    t: float = 0.0,
) -> tuple[Any, Any]:
    """As elements.kinds.Element.tangents."""
    places = coordinates(record)
    count, width = places.shape
    made = np.empty((2, count, width, width))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(x.size) if v is None else v))
    blocks(record, t, place, rate, *made)
    K, C = (assembled(places, one.swapaxes(1, 2), x.size) for one in made)
    return K, C


def geometric(system: System, record: NodeElements, x: NDArray[np.float64], u: NDArray[np.float64]) -> Any:
    """As elements.kinds.Element.geometric: the change of K with u, from its values at four places beside x along u."""
    largest = float(np.abs(u).max())
    if largest == 0.0:
        return csr_array((x.size, x.size))
    step = STEP * max(float(np.ptp(x, axis=0).max()), 1e-300) / largest
    near, far = (
        tangents(system, record, x + k * step * u, None)[0] - tangents(system, record, x - k * step * u, None)[0]
        for k in (1.0, 2.0)
    )
    return (8.0 * near - far) / (12.0 * step)


def element(part_of: Callable[[Any], Part | None]) -> Element:
    """The entry of a kind: part_of gives its elements in a system, or None."""
    part: Callable[[Any], Any] = cached()(part_of)

    def fields(system: Any) -> dict[str, NDArray[Any]] | None:
        return None if (one := part(system)) is None else arrays_of(one)

    @cached()
    def table(system: Any) -> NodeElements | None:
        return None if (found := fields(system)) is None else NodeElements.of(found)

    def results(system: Any, s: NodeElements, t: Any, x: Any, v: Any) -> Results:
        one, times = part(system), np.ascontiguousarray(t, float)
        place, rate = (np.ascontiguousarray(y, float) for y in (x, v))
        pushed = np.empty((len(place), len(one.names), 3))
        for i, own in enumerate(pushed):
            pushes(s, times[i], place[i], rate[i], own)
        found = {"force": (pushed, "N", one.says)}
        for name, law, size, value in values_of(one):
            column = np.empty((len(place), len(one.names), size))
            histories(s, law, times, place, rate, column)
            found[name] = (column if size > 1 else column[..., 0], value.unit, value.words)
        return Results(one.kind, one.names, found)

    def linear_results(system: Any, s: NodeElements, x: Any, u: Any) -> Results:
        one, place, moved = part(system), *(np.ascontiguousarray(y, float).reshape(-1) for y in (x, u))
        pushed = np.empty((len(one.names), 3))
        pushes(s, 0.0, place, np.zeros_like(place), pushed)
        stiff, damp = np.empty((2, len(one.names), s.longest, s.longest))
        blocks(s, 0.0, place, np.zeros_like(place), stiff, damp)
        at = np.maximum(coordinates(s), 0)
        pushed -= np.einsum("kji,kj->ki", stiff, moved[at])[:, :3]
        found = {"force": (pushed[None], "N", one.says)}
        for name, law, size, value in values_of(one):
            column = np.empty((len(one.names), 2 * size))
            changes(s, law, place, moved, column)
            total = (column[:, :size] + column[:, size:])[None]
            found[name] = (total if size > 1 else total[..., 0], value.unit, value.words)
        return Results(one.kind, one.names, found)

    def without_series(system: Any) -> str | None:
        return None if (one := part(system)) is None else f"the {one.kind} {one.names[0]!r} has a law without one"

    def switches(system: Any) -> Mapping[str, Any]:
        return {} if (one := part(system)) is None else one.switches

    return Element(
        table,
        coordinates,
        KERNELS,
        tangents,
        without_series=without_series,
        loses=lambda s: bool(s.loses),
        geometric=geometric,
        results=results,
        fields=fields,
        linear_results=linear_results,
        switches=switches,
        feeds=lambda s: bool(s.feeds),
        name=part_of.__module__.rpartition(".")[2],
    )


def values_of(one: Part) -> list[tuple[str, Ints, int, Any]]:
    """Name, addresses (elements, 2), size and description of the values of a kind."""
    width, counts = np.shape(one.numbers)[-1], [len(nodes) for nodes in one.nodes]
    return [
        (
            name,
            np.array([addresses_of_value(value.make, count, width) for count in counts], np.int64),
            size_of(value.make, counts[0], width),
            value,
        )
        for name, value in one.law.values.items()
    ]


def arrays_of(one: Part) -> dict[str, Any]:
    """The fields of the record."""
    counts, width = [len(nodes) for nodes in one.nodes], np.shape(one.numbers)[-1]
    return {
        "longest": 3 * max(counts),
        "grounded": int(one.grounded),
        "loses": int(one.loses and one.law.force is not None),
        "feeds": int(one.feeds),
        "ptr": np.cumsum([0, *counts]),
        "at": 3 * np.concatenate([np.asarray(nodes, np.int64) for nodes in one.nodes]),
        "law": np.array([addresses(one.law.energy, one.law.force, count, width) for count in counts], np.int64),
        "numbers": np.asarray(one.numbers),
    }
