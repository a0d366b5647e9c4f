"""Frames, which move as rigid wholes (a body, a hub, the smallest one bar), and what acts on the nodes of one.

Whatever acts does so by forces on nodes: the amount of a drive, a coupling or an element times the gradient of its coordinate,
the tension of a bar along it, loads, inertia. Their resultant on a frame is the sum over its nodes, force and couple. A
coordinate of several nodes has sides: the forces on one frame each, in balance as far as the coordinate does not press
against the ground. What a frame does inside with them is a question of its bars (`kinetruss.dynamics.action_couples`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.kernels.coordinates.forms import AROUND, FIXED_AXIS
from kinetruss.kernels.structure.terms import term_gradients
from kinetruss.mechanics.row_gradients import ends_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System
    from kinetruss.model.data import ModelData


FIRST, LAST = 0, 3
"""Places of P and B among the nodes of a term."""


class Side(NamedTuple):
    """What a drive, a coupling or an element on a coordinate does to one frame.

    source : kind and name. nodes : of an angle about an axis P and the nodes of the axis, of the offset of a node it and those
        of the line, of a bar its ends; of coordinates of nodes all of these. term : which has their forces, -1 for weights.
    end : FIRST, or LAST for B. turns : the forces are a couple about the other nodes. member : whose length or angle it is,
        else -1. weights (nodes, 3) : the forces where they are constant.
    """

    source: tuple[str, str]
    nodes: tuple[int, ...]
    term: int = -1
    end: int = FIRST
    turns: bool = False
    member: int = -1
    weights: Any = None


def source_of(model: ModelData, name: str) -> tuple[str, list[Any]]:
    """Whose coordinate has this name, a drive's, a coupling's or an element's of a kind, and its parts."""
    if name in model.force_elements:
        kind, record = model.force_elements[name]
        return kind, [one for one, _ in record.parts]
    if name in model.couplings:
        return "coupling", [one for one, _ in model.couplings[name].terms]
    return "drive", [model.all_drives[name]]


@cached()
def sides_of(system: System) -> tuple[Side, ...]:
    """The sides of all coordinates of several nodes, in the order of `system.measures`.

    Cosines and distances have none: a scalar turns with no bar, and forces along the line of two nodes bend none.
    """
    found: list[Side] = []
    for m, name in enumerate(system.measures):
        kind, parts = source_of(system.model, name)
        t = int(system.measure_ptr[m])
        weights: dict[int, NDArray[np.float64]] = {}
        for one in parts:
            P, *others = (int(flat) // 3 for flat in system.term_at[t])
            form, source = system.term_kind[t], (kind, name)
            if one.kind == "coordinate" and not system.model.nodes[one.node].scalar:
                weights[P] = weights.get(P, np.zeros(3)) + system.term_data[t, 0] * system.term_data[t, 1:4]
            elif one.kind == "offset":
                found.append(Side(source, (P, *others[:2]), t))
            elif one.kind == "hinge" and form == AROUND:
                found += [
                    Side(source, (node, *others[:2]), t, end, turns=True) for node, end in ((P, FIRST), (others[2], LAST))
                ]
            elif one.kind == "hinge":
                found.append(Side(source, (P, others[0]), t, turns=True))
                t += 1
                found.append(Side(source, (int(system.term_at[t, 0]) // 3, others[0]), t, turns=True))
            elif one.kind in ("length", "angle"):
                member = system.members.index(one.bar)
                found.append(Side(source, (P, others[0]), t, turns=form == FIXED_AXIS, member=member))
            t += 1
        if weights := {n: w for n, w in weights.items() if w.any()}:
            found.append(Side(source, tuple(weights), weights=np.array(list(weights.values()))))
    return tuple(found)


def side_forces(system: System, side: Side, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces (times, nodes, 3) of a unit of its source on the nodes of a side; x (times, n, 3).

    The force g at a node off an axis or a line is taken off the two nodes there in the shares 1 - s and s, the place of its
    foot.
    """
    if side.weights is not None:
        return np.broadcast_to(side.weights, (len(x), *side.weights.shape))
    out = np.empty((len(x), 12))
    flat = np.ascontiguousarray(x, dtype=float).reshape(len(x), -1)
    term_gradients(system.term_form, system.term_at, system.term_data, side.term, flat, out)
    g = out[:, 3 * side.end : 3 * side.end + 3]
    if len(side.nodes) == 2:
        return np.stack([g, -g], axis=1)
    P, one, two = (x[:, n] for n in side.nodes)
    b = two - one
    s = np.vecdot(P - one, b) / np.vecdot(b, b)
    return np.stack([g, -(1.0 - s)[:, None] * g, -s[:, None] * g], axis=1)


def bar_pushes(
    system: System, x: NDArray[np.float64], members: Sequence[int], tension: NDArray[np.float64], nodes: Sequence[int]
) -> NDArray[np.float64]:
    """Forces (times, nodes, 3), N, of truss bars on nodes; tension (times, members), N, of these members."""
    at = pulled(system, members, nodes)
    return np.asarray(np.einsum("tmc,mk->tkc", bar_pulls(system, x, members, tension), at))


def pulled(system: System, members: Sequence[int], nodes: Sequence[int]) -> NDArray[np.float64]:
    """Whether end A (1) or B (-1) of members is at nodes (members, nodes)."""
    p, q = (ends[list(members), None] == np.array(nodes, np.int64) for ends in (system.p, system.q))
    return np.asarray(p.astype(float) - q)


def bar_pulls(
    system: System, x: NDArray[np.float64], members: Sequence[int], tension: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Forces (times, members, 3), N, of truss bars on their ends A, opposite to those on B."""
    return np.asarray(tension[:, :, None] * ends_of(system, x, members)[2])


def resultant(
    x: NDArray[np.float64], forces: NDArray[np.float64], about: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Force (times, 3) and couple about a point (times, 3) of forces (times, k, 3) at places x (times, k, 3)."""
    return forces.sum(axis=1), cross(x - about[:, None], forces).sum(axis=1)


def cross(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """a x b (..., 3); of a few hundred vectors numpy.cross takes three times as long."""
    found = np.empty_like(b)
    for c, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
        found[..., c] = a[..., i] * b[..., j] - a[..., j] * b[..., i]
    return found
