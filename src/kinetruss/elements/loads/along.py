"""Loads between the ends of members: forces on bars, active members and elastic beams, couples on bars of a plane and on beams.

A force of q N/m from xi = b to xi = e of a member of length L does the work int q . dr L dxi on r = sum_j H_j(xi) r_j: along a
bar H = 1 - xi, xi, along an elastic beam Hermite's polynomials of the nodes at its ends (elements.beams). So node j
takes w_j q, w_j = L int (a + (c - a)(xi - b)/(e - b)) H_j dxi with the shape a, c, and of a force at a place w_j = H_j there.
In the axes of the member q turns with

    1 = d/|d|,    plane: 2 = J 1;    space: 2 = (h - (h . 1) 1)/|...|, 3 = 1 x 2

d from end A to B, h the direction that spans the plane 1-2 with it. It has no potential then. A load that counts on the
projection along its direction e is q |1 x e|.

Of an active member the tube, of length t, takes what is on it, the base the rest, and each moves along the member with its own
end: of the component along 1 the tube's end takes T = L int_n^1 (a + (c - a) xi) dxi, n = 1 - t/|d|, so that beside w_j q the
forces -(T - w_B)(q . 1) 1 and (T - w_B)(q . 1) 1 act at A and B.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from kinetruss.elements.directions import axes_along, unit
from kinetruss.elements.loads.beam_couples import couples_on_beam
from kinetruss.elements.loads.follower import FLAT_COUPLE, FORCE, Follower
from kinetruss.elements.loads.load import Load, OnBeam, OnMember, OnOthers, Spread, UnitLoad
from kinetruss.elements.local_axes import orientation, turned
from kinetruss.elements.numbers import apart, chosen, size
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, Record, Vector, record
from kinetruss.kernels.structure.tables import entry_at, weighted_place
from kinetruss.model import Piece
from kinetruss.model.loads_along import AlongMember, carrier, fraction

if TYPE_CHECKING:
    from kinetruss.mechanics.bars import Bars
    from kinetruss.mechanics.system import System

MEMBER, GLOBAL, SHADOW = 0, 1, 2
"""Directions of a load: an axis of the member; a global axis; a global axis, and the amount that of a projection."""


@record
class Turned(Record):
    """axis (k,) 0, 1, 2 along which load k acts; mode (k,) MEMBER, GLOBAL or SHADOW; planar (k,). node[ptr[k]:ptr[k + 1]] flat
    coordinates of its nodes, with data (nodes, 5): w, the factors of d and h, and of end A of a beam what its end B takes
    besides of the part along the beam, with the index of B; reference (k, 3) the constant part of h, of SHADOW e; rods (k, 3)
    t, L a and L c of a load on an active member, t = 0 of others. value at time, s, from table_ptr[k] on.
    """

    axis: I1
    mode: I1
    planar: I1
    ptr: I1
    node: I1
    table_ptr: I1
    time: F1
    value: F1
    data: F2
    reference: F2
    rods: F2


ROUNDING = 1e-14
"""Share of a load below which it is 0."""


@kernel_bare
def _axis(s: Turned, k: int, d: Vector, x: F1) -> Vector:
    """The direction of load k, times |1 x e| where it counts on a projection. d : from end A to B."""
    ux, uy, uz = d
    length = 1.0 / math.sqrt(ux * ux + uy * uy + uz * uz)
    ux, uy, uz = ux * length, uy * length, uz * length
    hx, hy, hz = s.reference[k, 0], s.reference[k, 1], s.reference[k, 2]
    if s.mode[k] != MEMBER:
        factor = 1.0
        if s.mode[k] == SHADOW:
            a, b, c = uy * hz - uz * hy, uz * hx - ux * hz, ux * hy - uy * hx
            factor = math.sqrt(a * a + b * b + c * c)
        if s.axis[k] == 0:
            return factor, 0.0, 0.0
        return (0.0, factor, 0.0) if s.axis[k] == 1 else (0.0, 0.0, factor)
    if s.axis[k] == 0:
        return ux, uy, uz
    if s.planar[k] != 0:
        return -uy, ux, 0.0
    gx, gy, gz = weighted_place(s.node, s.data, s.ptr[k], s.ptr[k + 1], 2, x)
    hx, hy, hz = hx + gx, hy + gy, hz + gz
    along = hx * ux + hy * uy + hz * uz
    hx, hy, hz = hx - along * ux, hy - along * uy, hz - along * uz
    length = 1.0 / math.sqrt(hx * hx + hy * hy + hz * hz)
    hx, hy, hz = hx * length, hy * length, hz * length
    if s.axis[k] == 1:
        return hx, hy, hz
    return uy * hz - uz * hy, uz * hx - ux * hz, ux * hy - uy * hx


@kernel_bare
def _push(A: int, B: int, share: float, q: Vector, x: F1, f: F1) -> None:
    """Move a share of the part of q along A-B from A to B."""
    dx, dy, dz = x[B] - x[A], x[B + 1] - x[A + 1], x[B + 2] - x[A + 2]
    push = share * (q[0] * dx + q[1] * dy + q[2] * dz) / (dx * dx + dy * dy + dz * dz)
    for j, d in ((0, dx), (1, dy), (2, dz)):
        f[A + j] -= push * d
        f[B + j] += push * d


@kernel
def force(s: Turned, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    # w_j q, and along an active member what base and tube take besides
    for k in range(s.axis.size):
        amount = entry_at(s.time, s.value, s.table_ptr[k], s.table_ptr[k + 1], t)
        d = weighted_place(s.node, s.data, s.ptr[k], s.ptr[k + 1], 1, x)
        qx, qy, qz = _axis(s, k, d, x)
        for i in range(s.ptr[k], s.ptr[k + 1]):
            at, share = s.node[i], amount * s.data[i, 0]
            f[at] += share * qx
            f[at + 1] += share * qy
            f[at + 2] += share * qz
        for i in range(s.ptr[k], s.ptr[k + 1]):
            if s.data[i, 3] != 0.0:
                _push(s.node[i], s.node[s.ptr[k] + int(s.data[i, 4])], amount * s.data[i, 3], (qx, qy, qz), x, f)
        if s.rods[k, 0] > 0.0:
            square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
            nut, a, c = max(0.0, 1.0 - s.rods[k, 0] / math.sqrt(square)), s.rods[k, 1], s.rods[k, 2]
            on_tube = a * (1.0 - nut) + 0.5 * (c - a) * (1.0 - nut * nut)
            A, B = s.node[s.ptr[k]], s.node[s.ptr[k] + 1]
            push = amount * (on_tube - s.data[s.ptr[k] + 1, 0]) * (qx * d[0] + qy * d[1] + qz * d[2]) / square
            for j in range(3):
                f[A + j] -= push * d[j]
                f[B + j] += push * d[j]


@dataclass(frozen=True, kw_only=True, eq=False)
class TurnedLoad(UnitLoad):
    """A load of 1 N/m along an axis of the member, or of 1 N at a place; nodes (k,), and the fields of `Turned`."""

    kernel, record, own = force, Turned, ("axis", "mode", "planar", "reference", "rods")
    axis: int
    mode: int
    planar: int
    reference: NDArray[np.float64]
    rods: NDArray[np.float64]

    @property
    def constant(self) -> bool:
        """As UnitLoad.constant."""
        return False

    def forces(self, r: NDArray[Any]) -> NDArray[Any]:
        """As UnitLoad.forces."""
        share, along, across, besides, partner = self.data.T
        d = np.einsum("j,...jc->...c", along, r)
        q = self._direction(d, np.einsum("j,...jc->...c", across, r))
        found = share[:, None] * q[..., None, :]
        for A in np.flatnonzero(besides != 0.0):
            B = int(partner[A].real)
            e = r[..., B, :] - r[..., A, :]
            push = (besides[A] * np.sum(q * e, axis=-1) / np.sum(e * e, axis=-1))[..., None] * e
            found = found + (np.eye(len(share))[B] - np.eye(len(share))[A])[:, None] * push[..., None, :]
        if self.rods[0]:
            t, a, c = self.rods
            length = size(d)
            nut = np.where((t < length).real, 1.0 - t / length, 0.0)
            on_tube = a * (1.0 - nut) + 0.5 * (c - a) * (1.0 - nut**2)
            push = ((on_tube - share[1]) * np.sum(q * d, axis=-1) / length**2)[..., None] * d
            found = found + np.array([-1.0, 1.0] + [0.0] * (len(share) - 2))[:, None] * push[..., None, :]
        return np.asarray(found)

    def _direction(self, d: NDArray[Any], h: NDArray[Any]) -> NDArray[Any]:
        if self.mode == MEMBER:
            if self.axis == 0:
                return unit(d)
            return turned(unit(d)) if self.planar else axes_along(d, self.reference + h)[self.axis]
        axis = np.eye(3)[self.axis]
        if self.mode == GLOBAL:
            return np.broadcast_to(axis, d.shape)
        off = np.cross(unit(d), self.reference)
        square = np.sum(off * off, axis=-1)
        # along the force the projection has no derivative: it is least there
        return np.where(square.real > 0.0, np.sqrt(square), 0.0)[..., None] * axis


def _length(system: System, load: Any) -> Any:
    """Length of the member in the model, m; of a link along it."""
    if load.member in system.model.links:
        return sum(_parts(system, load.member).values())
    return _between(system, cast("Any", carrier(system.model, load.member))[1].ends)


def _between(system: System, ends: tuple[str, str]) -> Any:
    return apart(*(system.x0[..., system.node_index(node), : system.dim] for node in ends))


def _parts(system: System, link: str) -> dict[str, Any]:
    """The beams between the pins of a link, with their lengths, m."""
    beams = system.model.beams.items()
    return {name: _between(system, beam.ends) for name, beam in beams if isinstance(beam, Piece) and beam.link == link}


def _span(system: System, load: Any) -> tuple[Any, Any]:
    """Where a load begins and ends, as fractions from end A; twice the same of one at a place."""
    length = _length(system, load)
    if hasattr(load, "at"):
        return (fraction(load.at, length),) * 2
    start, end = load.start, load.end
    return 0.0 if start is None else fraction(start, length), 1.0 if end is None else fraction(end, length)


def _shape(load: Any) -> tuple[Any, Any] | None:
    """The amounts at both ends; None of a load at a place."""
    return None if hasattr(load, "at") else load.shape


def _shadow(load: Any) -> NDArray[np.float64] | None:
    """The direction (3,) of a load that counts on the projection along it; None of others."""
    if getattr(load, "per", "length") == "length":
        return None
    table = getattr(load, load.amounts)
    rows = np.asarray(getattr(load, load.amount))[..., None, :] if table is None else np.asarray(table)
    rows = np.concatenate([rows, np.zeros((*rows.shape[:-1], 3 - rows.shape[-1]))], axis=-1)
    acts = np.flatnonzero(np.any(rows.real != 0.0, axis=(*range(rows.ndim - 2), -1)))
    return unit(rows[..., acts[0], :]) if len(acts) else np.zeros(3)


def _beams(system: System) -> Any:
    """The elastic beams, and those that rows hold in their shape; None without any."""
    return system.loaded if system.loaded is not None or system.continua is None else system.continua.beams


def _on_beams(system: System, load: Any) -> Iterator[OnBeam]:
    beams = _beams(system)
    if beams is None:
        return
    if load.member in system.model.links:
        parts = _on_link(system, load)
    elif load.member in beams.names:
        parts = iter([(load.member, *_span(system, load), _shape(load))])
    else:
        return
    for name, begin, end, shape in parts:
        turns, couple = load.axes == "member", load.amount == "moment"
        yield OnBeam(beams.names.index(name), begin, end, shape, turns, _shadow(load), couple)


def _on_link(system: System, load: Any) -> Iterator[tuple[str, Any, Any, tuple[Any, Any] | None]]:
    """The parts of a link that a load meets, each with begin and end as fractions of the part and its share of the shape."""
    parts = _parts(system, load.member)
    begin, end = (np.asarray(place * _length(system, load)) for place in _span(system, load))
    shape, at = _shape(load), np.zeros(())
    for k, (name, length) in enumerate(parts.items()):
        after = np.asarray(at + length)
        if shape is None:
            # at a pin it acts on the part behind it
            if begin.real.min() < after.real.max() or k == len(parts) - 1:
                yield name, (begin - at) / length, (begin - at) / length, None
                return
        else:
            low, high = (
                (begin if begin.real.max() > at.real.max() else at),
                (end if end.real.min() < after.real.min() else after),
            )
            if np.all(np.real(high) > np.real(low)):
                first, last = (shape[0] + (shape[1] - shape[0]) * (place - begin) / (end - begin) for place in (low, high))
                yield name, (low - at) / length, (high - at) / length, (first, last)
        at = after


def _along_bar(system: System, load: Any) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Nodes (k,) with data (k, 3), and reference (3,), of a load along a bar or at a place of it."""
    i, (begin, end), shape = system.members.index(load.member), _span(system, load), _shape(load)
    begin, end = (np.asarray(one)[..., None] for one in (begin, end))
    if shape is None:
        q, xi = np.ones(1), begin
    else:
        # three points are exact: w_j = L int q H_j dxi
        at, weight = np.polynomial.legendre.leggauss(3)
        eta = 0.5 * (1.0 + at)
        a, b, length = (np.asarray(one)[..., None] for one in (*shape, _length(system, load)))
        q, xi = 0.5 * weight * (end - begin) * length * (a + (b - a) * eta), begin + (end - begin) * eta
    node, reference = orientation(system)
    nodes = [system.p[i], system.q[i], *([] if node[i] < 0 else [node[i]])]
    first, second = np.sum(q * (1.0 - xi), axis=-1), np.sum(q * xi, axis=-1)
    data = np.zeros((*np.shape(first), 3, 5), np.result_type(first))
    data[..., :3] = [[0.0, -1.0, -1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    data[..., 0, 0], data[..., 1, 0] = first, second
    data = data[..., : len(nodes), :]
    if node[i] < 0:
        data[..., 2] = 0.0
    return np.array(nodes, np.int64), data, reference[i] if node[i] < 0 else np.zeros(3)


def _rods(system: System, load: Any) -> NDArray[np.float64]:
    """`Turned.rods` of a load, (3,)."""
    if load.member not in system.model.active:
        return np.zeros(3)
    length, (a, c) = _length(system, load), load.shape
    tube = system.own_rods[..., system.members.index(load.member), 4]
    return np.stack(np.broadcast_arrays(tube, length * a, length * c), axis=-1)


def _forces(system: System, load: Any) -> tuple[UnitLoad, ...]:
    parts = [_along_beam(system, one) for one in _on_beams(system, load)]
    return _units(system, load, *(_joined(parts) if parts else _along_bar(system, load)))


def units_on_beam(system: System, load: Any, one: OnBeam) -> tuple[UnitLoad, ...]:
    """The unit loads of the part of a load that acts on one elastic beam."""
    if one.couple:
        return couples_on_beam(_beams(system), one, system.dim)
    return _units(system, load, *_along_beam(system, one))


def _units(
    system: System, load: Any, nodes: NDArray[np.int64], data: NDArray[np.float64], reference: NDArray[np.float64]
) -> tuple[UnitLoad, ...]:
    axes = np.eye(3)
    shadow, rods = _shadow(load), _rods(system, load)
    mode = MEMBER if load.axes == "member" else GLOBAL if shadow is None else SHADOW
    if (
        mode != GLOBAL
        or rods.any()
        or chosen(data[..., 3] != 0.0, "loads whose parts along and across a beam are shared alike").any()
    ):
        own: dict[str, Any] = {
            "mode": mode,
            "planar": int(system.dim == 2),
            "reference": reference if shadow is None else shadow,
            "rods": rods,
        }
        return tuple(TurnedLoad(nodes=nodes, data=data, axis=c, **own) for c in range(system.dim))
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
    data = np.zeros((*parts[0][1].shape[:-2], len(nodes), 5), parts[0][1].dtype)
    for k, (own, given, _) in enumerate(parts):
        at = np.searchsorted(nodes, own)
        data[..., at, 0] += given[..., 0]
        if not k:
            data[..., at, 1:3] = given[..., 1:3]
        # each part has an end A of its own
        data[..., at[0], 3], data[..., at[0], 4] = given[..., 0, 3], at[len(own) // 2]
    return nodes, data, parts[0][2]


def _along_beam(system: System, one: OnBeam) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """The same of a load along an elastic beam; h is the mean of axis 2 at both ends."""
    beams = cast("Any", _beams(system))
    v = beams.nodes.shape[1]
    across = beams.axes[..., one.beam, 1, :] + beams.ends[..., one.beam, 1, :]
    along = np.broadcast_to(np.eye(v)[v // 2] - np.eye(v)[0], across.shape)
    share, first = one.shares(beams), np.eye(v)[0]
    # what is along the beam is shared by 1 - xi and xi, as its strain is uniform, and not by Hermite's polynomials
    besides = np.asarray(one.over(beams, lambda xi: xi[..., None]))[..., 0] - share[..., v // 2 :].sum(axis=-1)
    besides = besides - np.where(abs(besides.real) > ROUNDING * abs(share).max(), 0.0, besides.real)
    columns = np.broadcast_arrays(share, along, across, besides[..., None] * first, v // 2 * first)
    return beams.nodes[one.beam], np.stack(columns, axis=-1), np.zeros(3)


def _couples(system: System, load: Any) -> tuple[UnitLoad, ...]:
    if found := [*_on_beams(system, load)]:
        return couples_on_beam(_beams(system), found[0], system.dim)
    i, (begin, end), shape = system.members.index(load.member), _span(system, load), _shape(load)
    whole = 1.0 if shape is None else 0.5 * sum(shape) * (end - begin) * _length(system, load)
    nodes, data, vector = np.array([system.p[i], system.q[i]], np.int64), np.zeros((2, 4)), np.zeros((*np.shape(whole), 4))
    vector = vector.astype(np.result_type(whole))
    vector[..., 2] = whole
    return (Follower(mode=FLAT_COUPLE, nodes=nodes, data=data, vector=vector),)


def _places(system: System, bars: Bars, load: Any) -> Iterator[OnMember | OnOthers]:
    if load.member not in bars.index or load.member in system.model.links:
        return
    begin, end = _span(system, load)
    place: float | Spread = float(begin)
    if isinstance(load, AlongMember):
        ratio = None
        if load.amount == "moment" or load.member in system.model.active:
            ratio = 2.0 * load.shape[0] / sum(load.shape), 2.0 * load.shape[1] / sum(load.shape)
        place = Spread(begin, end, ratio, load.amount == "moment")
    yield OnMember(bars.index[load.member], place)


FORCES, COUPLES = Load(_forces, _places, _on_beams), Load(_couples, _places, _on_beams)
"""Of forces along members and at places of them, and of couples."""
