"""Loads along members: forces along bars and elastic beams, couples along bars of a plane.

A force of q N/m from xi = b to xi = e of a member of length L does the work int q . dr L dxi on r = sum_j H_j(xi) r_j: along a
bar H = 1 - xi, xi, along an elastic beam Hermite's polynomials of the nodes at its ends (elements.beams). So node j
takes w_j q, w_j = L int (a + (c - a)(xi - b)/(e - b)) H_j dxi with the shape a, c. In the axes of the member q turns with

    1 = d/|d|,    plane: 2 = J 1;    space: 2 = (h - (h . 1) 1)/|...|, 3 = 1 x 2

d from end A to B, h the direction that spans the plane 1-2 with it. It has no potential then.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from kinetruss.elements.directions import axes_along, unit
from kinetruss.elements.loads.follower import FLAT_COUPLE, FORCE, Follower
from kinetruss.elements.loads.load import Load, OnBeam, OnMember, OnOthers, Spread, UnitLoad
from kinetruss.elements.local_axes import orientation, turned
from kinetruss.elements.numbers import apart, chosen
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, Record, Vector, record
from kinetruss.kernels.structure.tables import entry_at
from kinetruss.model import Piece

if TYPE_CHECKING:
    from kinetruss.mechanics.bars import Bars
    from kinetruss.mechanics.system import System
    from kinetruss.model.loads import MemberCouple, MemberLoad


@record
class Turned(Record):
    """axis (k,) 0, 1, 2 along which load k acts; planar (k,). node[ptr[k]:ptr[k + 1]] flat coordinates of its nodes, with data
    (nodes, 3): w, and the factors of d and h; reference (k, 3) the constant part of h. value at time, s, from table_ptr[k] on.
    """

    axis: I1
    planar: I1
    ptr: I1
    node: I1
    table_ptr: I1
    time: F1
    value: F1
    data: F2
    reference: F2


@kernel_bare
def _sum(s: Turned, k: int, column: int, x: F1) -> Vector:
    """Sum of a factor times the places of the nodes of load k."""
    a, b, c = 0.0, 0.0, 0.0
    for i in range(s.ptr[k], s.ptr[k + 1]):
        at, factor = s.node[i], s.data[i, column]
        a, b, c = a + factor * x[at], b + factor * x[at + 1], c + factor * x[at + 2]
    return a, b, c


@kernel_bare
def _axis(s: Turned, k: int, x: F1) -> Vector:
    """The axis of the member along which load k acts."""
    ux, uy, uz = _sum(s, k, 1, x)
    size = 1.0 / math.sqrt(ux * ux + uy * uy + uz * uz)
    ux, uy, uz = ux * size, uy * size, uz * size
    if s.axis[k] == 0:
        return ux, uy, uz
    if s.planar[k] != 0:
        return -uy, ux, 0.0
    hx, hy, hz = _sum(s, k, 2, x)
    hx, hy, hz = hx + s.reference[k, 0], hy + s.reference[k, 1], hz + s.reference[k, 2]
    along = hx * ux + hy * uy + hz * uz
    hx, hy, hz = hx - along * ux, hy - along * uy, hz - along * uz
    size = 1.0 / math.sqrt(hx * hx + hy * hy + hz * hz)
    hx, hy, hz = hx * size, hy * size, hz * size
    if s.axis[k] == 1:
        return hx, hy, hz
    return uy * hz - uz * hy, uz * hx - ux * hz, ux * hy - uy * hx


@kernel
def force(s: Turned, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    # w_j q, q along an axis of the member
    for k in range(s.axis.size):
        amount = entry_at(s.time, s.value, s.table_ptr[k], s.table_ptr[k + 1], t)
        qx, qy, qz = _axis(s, k, x)
        for i in range(s.ptr[k], s.ptr[k + 1]):
            at, share = s.node[i], amount * s.data[i, 0]
            f[at] += share * qx
            f[at + 1] += share * qy
            f[at + 2] += share * qz


@dataclass(frozen=True, kw_only=True, eq=False)
class TurnedLoad(UnitLoad):
    """A load of 1 N/m along an axis of the member; nodes (k,), and the fields of `Turned`."""

    kernel, record, own = force, Turned, ("axis", "planar", "reference")
    axis: int
    planar: int
    reference: NDArray[np.float64]

    @property
    def constant(self) -> bool:
        """As UnitLoad.constant."""
        return False

    def forces(self, r: NDArray[Any]) -> NDArray[Any]:
        """As UnitLoad.forces."""
        share, along, across = self.data.T
        d = np.einsum("j,...jc->...c", along, r)
        if self.axis == 0:
            axis = unit(d)
        elif self.planar:
            axis = turned(unit(d))
        else:
            axis = axes_along(d, self.reference + np.einsum("j,...jc->...c", across, r))[self.axis]
        return np.asarray(share[:, None] * axis[..., None, :])


def _length(system: System, load: MemberLoad | MemberCouple) -> Any:
    """Length of the member in the model, m."""
    model = system.model
    ends = (model.beams if load.member in model.beams else model.bars)[load.member].ends
    return apart(*(system.x0[..., system.node_index(node), : system.dim] for node in ends))


def _span(system: System, load: MemberLoad | MemberCouple) -> tuple[Any, Any]:
    """Where a load begins and ends, as fractions from end A."""
    length = _length(system, load)
    return 0.0 if load.start is None else load.start / length, 1.0 if load.end is None else load.end / length


def _beams(system: System) -> Any:
    """The elastic beams, and those that rows hold in their shape; None without any."""
    return system.loaded if system.loaded is not None or system.continua is None else system.continua.beams


def _on_beams(system: System, load: MemberLoad) -> Iterator[OnBeam]:
    beams = _beams(system)
    if beams is not None and load.member in system.model.links:
        yield from _on_link(system, beams.names, load)
    elif beams is not None and load.member in beams.names:
        yield OnBeam(beams.names.index(load.member), *_span(system, load), *load.shape, load.axes == "member")


def _on_link(system: System, names: tuple[str, ...], load: MemberLoad) -> Iterator[OnBeam]:
    """The same of the parts of a link, each with its share of the load."""
    own = {name: beam for name, beam in system.model.beams.items() if isinstance(beam, Piece) and beam.link == load.member}
    ends = [[system.x0[..., system.node_index(node), : system.dim] for node in beam.ends] for beam in own.values()]
    lengths = [apart(*pair) for pair in ends]
    begin = np.asarray(0.0 if load.start is None else load.start)
    end = np.asarray(sum(lengths) if load.end is None else load.end)
    first, last = load.shape
    at: Any = np.zeros(())
    for name, length in zip(own, lengths, strict=True):
        low = begin if begin.real.max() > at.real.max() else at
        high = end if end.real.min() < np.asarray(at + length).real.min() else at + length
        if np.all(np.real(high) > np.real(low)):
            one, two = (first + (last - first) * (place - begin) / (end - begin) for place in (low, high))
            yield OnBeam(names.index(name), (low - at) / length, (high - at) / length, one, two, load.axes == "member")
        at = at + length


def _along_bar(system: System, load: MemberLoad) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Nodes (k,) with data (k, 3), and reference (3,), of a load along a bar."""
    i = system.members.index(load.member)
    (begin, end), (first, last) = _span(system, load), load.shape
    # three points are exact: w_j = L int q H_j dxi
    at, weight = np.polynomial.legendre.leggauss(3)
    eta = 0.5 * (1.0 + at)
    a, b, length = (np.asarray(one)[..., None] for one in (first, last, _length(system, load)))
    begin, end = (np.asarray(one)[..., None] for one in (begin, end))
    q, xi = 0.5 * weight * (end - begin) * length * (a + (b - a) * eta), begin + (end - begin) * eta
    node, reference = orientation(system)
    nodes = [system.p[i], system.q[i], *([] if node[i] < 0 else [node[i]])]
    data = np.zeros((*q.shape[:-1], 3, 3), q.dtype)
    data[...] = [[0.0, -1.0, -1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    data[..., 0, 0], data[..., 1, 0] = np.vecdot(q.conj(), 1.0 - xi), np.vecdot(q.conj(), xi)
    data = data[..., : len(nodes), :]
    if node[i] < 0:
        data[..., 2] = 0.0
    return np.array(nodes, np.int64), data, reference[i] if node[i] < 0 else np.zeros(3)


def _loads(system: System, load: MemberLoad) -> tuple[UnitLoad, ...]:
    parts = [_along_beam(system, one) for one in _on_beams(system, load)]
    (nodes, data, reference), axes = _joined(parts) if parts else _along_bar(system, load), np.eye(3)
    if load.axes == "member":
        planar = int(system.dim == 2)
        return tuple(TurnedLoad(nodes=nodes, data=data, reference=reference, planar=planar, axis=c) for c in range(system.dim))
    taken = np.flatnonzero(chosen(data[..., 0] != 0.0, "nodes that take a load"))
    shared = np.zeros((*data.shape[:-2], len(taken), 4), data.dtype)
    nodes, shared[..., 2] = nodes[taken], data[..., taken, 0]
    return tuple(Follower(mode=FORCE, nodes=nodes, data=shared, vector=np.append(one, 0.0)) for one in axes[: system.dim])


def _joined(
    parts: list[tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]],
) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Loads on the parts of a link as one, with the axes of the first: it is straight where they count."""
    if len(parts) == 1:
        return parts[0]
    nodes = np.unique(np.concatenate([own for own, *_ in parts]))
    data = np.zeros((*parts[0][1].shape[:-2], len(nodes), 3), parts[0][1].dtype)
    for k, (own, given, _) in enumerate(parts):
        at = np.searchsorted(nodes, own)
        data[..., at, 0] += given[..., 0]
        if not k:
            data[..., at, 1:] = given[..., 1:]
    return nodes, data, parts[0][2]


def _along_beam(system: System, one: OnBeam) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """The same of a load along an elastic beam; h is the mean of axis 2 at both ends."""
    beams = cast("Any", _beams(system))
    v = beams.nodes.shape[1]
    across = beams.axes[..., one.beam, 1, :] + beams.ends[..., one.beam, 1, :]
    along = np.broadcast_to(np.eye(v)[v // 2] - np.eye(v)[0], across.shape)
    return beams.nodes[one.beam], np.stack([beams.shares(*one[:-1]), along, across], axis=-1), np.zeros(3)


def _couples(system: System, load: MemberCouple) -> tuple[UnitLoad, ...]:
    i, (begin, end) = system.members.index(load.member), _span(system, load)
    whole = 0.5 * sum(load.shape) * (end - begin) * _length(system, load)
    nodes, data, vector = np.array([system.p[i], system.q[i]], np.int64), np.zeros((2, 4)), np.zeros((*np.shape(whole), 4))
    vector = vector.astype(np.result_type(whole))
    vector[..., 2] = whole
    return (Follower(mode=FLAT_COUPLE, nodes=nodes, data=data, vector=vector),)


def _places(system: System, bars: Bars, load: MemberLoad | MemberCouple) -> Iterator[OnMember | OnOthers]:
    if load.member in bars.index and load.member not in system.model.links:
        first, last = load.shape
        couple = None if load.amount == "force" else (2.0 * first / (first + last), 2.0 * last / (first + last))
        yield OnMember(bars.index[load.member], Spread(*_span(system, load), couple))


LOADS, COUPLES = Load(_loads, _places, _on_beams), Load(_couples, _places)
