"""Membranes and solids as arrays: edges, stiffness, visible faces; and masses of these and of beams."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.beams import BeamElements, Beams, beams_at, beams_of
from kinetruss.elements.numbers import size, sums_at

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.continua import EdgeElements
    from kinetruss.elements.matter import Matter
    from kinetruss.elements.numbers import Array, Numbers
    from kinetruss.model import WholeModel


# Membranes and solids as arrays: edges, which elements share, and the stiffness of each element by its edges.
#
# Of Green's strain E = (F^T F - 1)/2 with F = sum x_a grad N_a, where sum grad N_a = 0, only the squared distances c_ab of
# nodes remain,
#
#     E = -1/4 sum_(a < b) (c_ab - c0_ab) (grad N_a grad N_b^T + grad N_b grad N_a^T),
#
# so E = B (c - c0) and the energy of an element is a quadratic form, W = (c - c0)^T G (c - c0)/2, G = integral of B^T C B dV.
# A triangle has 3 such edges, a tetrahedron 6, a six-node triangle with linear strain 15. The force density of an edge is q =
# 2 G (c - c0), N/m, which is N/l of a bar. An element of one edge is a bar with Green's strain.

FOUR = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
"""The triangles between the nodes of a six-node triangle (corners, middles of sides 1-2, 2-3, 3-1)."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Patch:
    """The elements of one membrane or solid with the same number of nodes and the same law.

    name; nodes (k, v) indices in the model, in the order of the record; C (s, s) elastic law in material axes, Pa;
    axes (k, dim, 3) or (1, dim, 3) material axes as rows; thickness m (1 for solids).
    """

    name: str
    nodes: NDArray[np.int64]
    C: NDArray[np.float64]
    axes: NDArray[np.float64]
    thickness: float
    density: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Continua:
    """p, q (e,) pairs of nodes, p < q, of which the first `edges` are those of membranes and solids; start (n, 3) places of all
    nodes, m, without stress; mass (e,) kg, m_pq of the consistent mass matrix, and lump (n,) its diagonal.

    groups : by number of nodes v, edge (k, v (v - 1)/2) edges of the pairs (0, 1), (0, 2), ... of each element's nodes in
    rising order, and stiff (k, w (w + 1)/2) the upper triangle of 2 G by rows, N/m^3. patches, beams : what they came from.
    """

    p: NDArray[np.int32]
    q: NDArray[np.int32]
    edges: int
    start: NDArray[np.float64]
    mass: NDArray[np.float64]
    lump: NDArray[np.float64]
    groups: dict[int, tuple[NDArray[np.int32], NDArray[np.float64]]]
    patches: tuple[Patch, ...]
    beams: BeamElements | None

    @property
    def ends(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Nodes of the edges of membranes and solids."""
        return self.p[: self.edges], self.q[: self.edges]

    @cached_property
    def record(self) -> EdgeElements:
        """What kernels take."""
        from kinetruss.elements.continua import EdgeElements  # compiled; callers that only check do not need it

        return EdgeElements.of(self.fields())

    def fields(self) -> dict[str, Array]:
        """Its fields."""
        from kinetruss.elements.continua import edge_fields

        return edge_fields(*self.ends, self.start, self.groups)


@dataclass(frozen=True, kw_only=True, eq=False)
class Sheets:
    """The structure of membranes, solids and elastic beams. p, q (e,) pairs of nodes, first the edges, `resisting` ones, of
    membranes and solids; pairs (k, w) of the elements of each part, then of the beams, and ranks (k, v) that sort their nodes.
    """

    dim: int
    parts: tuple[SheetPart, ...]
    beams: Beams | None
    p: NDArray[np.int32]
    q: NDArray[np.int32]
    resisting: int
    pairs: tuple[NDArray[np.int32], ...]
    ranks: tuple[NDArray[np.int64], ...]


class SheetPart(NamedTuple):
    """A membrane or solid: name, record, nodes (k, v), places of its material and thickness, or -1, and of its own numbers."""

    name: str
    record: Any
    nodes: NDArray[np.int64]
    material: int
    thickness: int
    own: dict[str, int]


def sheets_of(model: WholeModel, index: dict[str, int], matter: Matter) -> tuple[Sheets | None, dict[str, Any]]:
    """The membranes, solids and elastic beams of a model, None if it has none; and their numbers."""
    beams, of_beams = beams_of(model, index, matter)
    parts, thickness, own = [], list[float](), list[float]()
    sheets: list[tuple[str, Any]] = [*model.membranes.items(), *model.solids.items()]
    for name, part in sheets:
        here = np.array([index[node] for node in part.nodes], np.int64)
        nodes = here[np.array(part.elements, np.int64)]
        if nodes.shape[1] == 6 and part.strain == "constant":
            nodes = nodes[:, np.array(FOUR)].reshape(-1, 3)
        stated = {} if part.orthotropic is None else {name: one for name, one in part.orthotropic if isinstance(one, float)}
        thick = hasattr(part, "thickness")
        places = {name: len(own) + k for k, name in enumerate(stated)}
        material = matter.material_of(part) if part.orthotropic is None else -1
        parts.append(SheetPart(name, part, nodes, material, len(thickness) if thick else -1, places))
        thickness += [part.thickness] if thick else []
        own += stated.values()
    numbers = {"thickness": np.array(thickness, float), "orthotropic": np.array(own, float), **of_beams}
    if not parts and beams is None:
        return None, numbers
    every = [one.nodes for one in parts] + ([] if beams is None else [beams.nodes])
    n = len(index)
    keys = [_keys(np.sort(nodes, axis=1), n) for nodes in every]
    # pairs that elements share are one
    found = np.unique(np.concatenate([np.zeros(0, np.int64), *(key.reshape(-1) for key in keys[: len(parts)])]))
    resisting = len(found)
    if beams is not None:
        found = np.concatenate([found, np.setdiff1d(keys[-1], found)])
    order = np.argsort(found)
    return Sheets(
        dim=model.dim,
        parts=tuple(parts),
        beams=beams,
        p=(found // n).astype(np.int32),
        q=(found % n).astype(np.int32),
        resisting=resisting,
        pairs=tuple(order[np.searchsorted(found, key, sorter=order)].astype(np.int32) for key in keys),
        ranks=tuple(np.argsort(nodes, axis=1) for nodes in every),
    ), numbers


def continua_at(sheets: Sheets | None, numbers: Numbers, x0: Array) -> Continua | None:
    """All membranes, solids and elastic beams on positions x0 (n, 3), or None if there are none."""
    if sheets is None:
        return None
    patches = tuple(_patch(one, numbers, x0, sheets.dim) for one in sheets.parts)
    beams = None if sheets.beams is None else beams_at(sheets.beams, numbers, x0)
    made: list[tuple[Any, Any, Any]] = [(patch.nodes, *_stiffness(patch, x0)) for patch in patches]
    if beams is not None:
        made.append((beams.nodes, None, beams.mass()))
    n = x0.shape[-2]
    mass, lump = numbers.full(len(sheets.p)), numbers.full(n)
    groups: dict[int, list[tuple[NDArray[np.int32], Array]]] = {}
    # stiffness 2 G by elements; masses by pairs and nodes
    for (nodes, stiffness, own), pair, rank in zip(made, sheets.pairs, sheets.ranks, strict=True):
        at = np.arange(len(rank))[:, None, None]
        share = own[..., at, rank[:, :, None], rank[:, None, :]]
        i, j = np.triu_indices(nodes.shape[1], 1)
        mass += sums_at(pair.reshape(-1), share[..., i, j].reshape(*numbers.lead, -1), len(sheets.p))
        own_mass = np.einsum("...aa->...a", share).reshape(*numbers.lead, -1)
        lump += sums_at(np.sort(nodes, axis=1).reshape(-1), own_mass, n)
        if stiffness is not None:
            groups.setdefault(nodes.shape[1], []).append((pair, _by_sorted_nodes(rank, stiffness)))
    joined = {
        v: (np.concatenate([e for e, _ in parts]), np.concatenate([s for _, s in parts], axis=-2))
        for v, parts in groups.items()
    }
    return Continua(
        p=sheets.p,
        q=sheets.q,
        edges=sheets.resisting,
        start=x0,
        mass=mass,
        lump=lump,
        groups=joined,
        patches=patches,
        beams=beams,
    )


def _keys(nodes: NDArray[np.int64], n: int) -> NDArray[np.int64]:
    i, j = np.triu_indices(nodes.shape[1], 1)
    return np.asarray(nodes[:, i] * n + nodes[:, j])


def _patch(part: SheetPart, numbers: Numbers, x0: Array, dim: int) -> Patch:
    """A membrane or solid from its numbers."""
    at, record = part.material, part.record
    if at >= 0:
        own = {name: numbers.each(name)[at] for name in ("E", "poisson", "density")}
    else:
        own = dict.fromkeys(type(record.orthotropic).model_fields) | {
            name: numbers.each("orthotropic")[place] for name, place in part.own.items()
        }
    return Patch(
        name=part.name,
        nodes=part.nodes,
        C=law_matrix(SimpleNamespace(**own), record.plane if part.thickness >= 0 else "solid"),
        axes=material_axes(record, x0[..., part.nodes[:, :3], :], dim),
        density=own["density"],
        thickness=numbers.each("thickness")[part.thickness] if part.thickness >= 0 else 1.0,
    )


def law_matrix(material: Any, plane: str) -> Array:
    """C with S = C E, Pa, for (E11, E22, 2 E12), or (E11, E22, E33, 2 E23, 2 E13, 2 E12) of a solid; in material axes.

    material : a `Material` or `Orthotropic`, or their numbers. plane : "stress", "strain" or "solid".
    """
    if hasattr(material, "poisson"):
        E, nu = material.E, material.poisson
        E1 = E2 = E3 = E
        n12 = n13 = n23 = nu
        G12 = G13 = G23 = E / (2 * (1 + nu))
    else:
        E1, E2, n12, G12 = material.E1, material.E2, material.nu12, material.G12
        E3, G13, G23 = (
            other if one is None else one for one, other in ((material.E3, E2), (material.G13, G12), (material.G23, G12))
        )
        n13, n23 = (0.0 if one is None else one for one in (material.nu13, material.nu23))
    # compliance matrix
    rows = [[1 / E1, -n12 / E1, -n13 / E1], [-n12 / E1, 1 / E2, -n23 / E2], [-n13 / E1, -n23 / E2, 1 / E3]]
    values = {(i, j): one for i, row in enumerate(rows) for j, one in enumerate(row)}
    values |= {(3, 3): 1 / G23, (4, 4): 1 / G13, (5, 5): 1 / G12}
    S = np.zeros((*np.broadcast_shapes(*map(np.shape, values.values())), 6, 6), np.result_type(*values.values()))
    for (i, j), one in values.items():
        S[..., i, j] = one
    inside: Any = (..., *np.ix_([0, 1, 5], [0, 1, 5]))
    if plane == "stress":
        return np.asarray(np.linalg.inv(S[inside]))
    C = np.linalg.inv(S)
    return np.asarray(C[inside] if plane == "strain" else C)


def material_axes(part: Any, corners: Array, dim: int) -> Array:
    """Material axes (1 or k, 2 or 3, 3) as rows, of a membrane or solid whose elements have corners (k, 3, 3) first.

    Solids: axis 2 is made normal to axis 1. Membranes in space: axis 1 is laid into the plane of the corners.
    """
    if not hasattr(part, "thickness"):
        first, second = np.array(part.axes or ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)), float)
        one = first / np.linalg.norm(first)
        three = np.cross(one, second)
        three /= np.linalg.norm(three)
        return np.stack([one, np.cross(three, one), three])[None]
    axis = np.zeros(3)
    given = part.axis or (1.0, 0.0, 0.0)[:dim]
    axis[: len(given)] = given
    axis /= np.linalg.norm(axis)
    if dim == 2:
        return np.array([[axis, [-axis[1], axis[0], 0.0]]])
    normal = np.cross(corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :])
    normal = normal / size(normal)[..., None]
    laid = axis - normal * (normal @ axis)[..., None]
    length = size(laid)[..., None]
    if part.axis is None:  # of an element across x: y
        other = np.array([0.0, 1.0, 0.0]) - normal * normal[..., 1:2]
        laid = np.where(length.real > 0.1, laid, other)
        length = size(laid)[..., None]
    one = laid / length
    return np.stack([one, np.cross(normal, one)], axis=-2)


def element_points(patch: Patch, nodes: NDArray[np.int64], x: Array) -> Array:
    """Points (k, v, 2 or 3) of elements in material axes, m, from the first node."""
    d = x[..., nodes, :] - x[..., nodes[:, :1], :]
    shape = (*patch.axes.shape[:-3], len(nodes), *patch.axes.shape[-2:])
    return np.asarray(np.einsum("...kvc,...ksc->...kvs", d, np.broadcast_to(patch.axes, shape)))


def gradients(points: Array) -> tuple[Array, Array, NDArray[np.float64]]:
    """Gradients of the shape functions (k, g, v, s), 1/m, at g points of each element, their volumes (k, g), and N (g, v).

    points (k, v, s) : reference points of the nodes, m.
    """
    weight, N, local = _rule(points.shape[-2])
    # Jacobian of the map from area coordinates to the material axes
    J = np.einsum("gvs,...kvc->...kgsc", local, points)
    det = np.linalg.det(J)
    return np.einsum("gvs,...kgcs->...kgvc", local, np.linalg.inv(J)), weight * (det * np.sign(det.real)), N


def _strain_rows(gradient: Array) -> Array:
    """B (k, g, s, w) of w pairs of nodes (0, 1), (0, 2), ... from gradients (k, g, v, dim)."""
    dim = gradient.shape[-1]
    a, b = np.triu_indices(gradient.shape[-2], 1)
    ga, gb = gradient[..., a, :], gradient[..., b, :]
    # E = -1/2 sum over pairs of nodes of s_ab (grad N_a grad N_b^T), symmetric part
    rows = [-0.5 * ga[..., c] * gb[..., c] for c in range(dim)]
    shears = [(0, 1)] if dim == 2 else [(1, 2), (0, 2), (0, 1)]
    rows += [-0.5 * (ga[..., c] * gb[..., d] + ga[..., d] * gb[..., c]) for c, d in shears]
    return np.stack(rows, axis=-2)


def _rule(v: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Weights (g,), shape functions (g, v) and their derivatives (g, v, s) by area coordinates 2, 3 (, 4).

    Six-node triangles: the rule of degree 4 with six points (Dunavant, 1985), exact for straight sides.
    """
    if v in (3, 4):
        # linear shape functions: N_1 = 1 - l_2 - .. and N_i = l_i, one point at the centre
        derivative = np.vstack([-np.ones((1, v - 1)), np.eye(v - 1)])
        return np.array([0.5 if v == 3 else 1 / 6]), np.full((1, v), 1 / v), derivative[None]
    L, weight = [], []
    for w, a in ((0.223381589678011, 0.445948490915965), (0.109951743655322, 0.091576213509771)):
        L += [[1 - 2 * a, a, a], [a, 1 - 2 * a, a], [a, a, 1 - 2 * a]]
        weight += 3 * [0.5 * w]
    l1, l2, l3 = np.array(L).T
    # corners l (2 l - 1), middles of sides 4 l l'; derivatives with l_1 = 1 - l_2 - l_3
    N = np.stack([l1 * (2 * l1 - 1), l2 * (2 * l2 - 1), l3 * (2 * l3 - 1), 4 * l1 * l2, 4 * l2 * l3, 4 * l3 * l1], axis=1)
    zero = 0 * l1
    by2 = np.stack([1 - 4 * l1, 4 * l2 - 1, zero, 4 * (l1 - l2), 4 * l3, -4 * l3], axis=1)
    by3 = np.stack([1 - 4 * l1, zero, 4 * l3 - 1, -4 * l2, 4 * l2, 4 * (l1 - l3)], axis=1)
    return np.array(weight), N, np.stack([by2, by3], axis=2)


def _stiffness(patch: Patch, x0: Array) -> tuple[Array, Array]:
    """2 G (k, w, w) of the pairs of nodes of each element, N/m^3, and the masses (k, v, v), kg."""
    v = patch.nodes.shape[1]
    gradient, volume, N = gradients(element_points(patch, patch.nodes, x0))
    B, volume = _strain_rows(gradient), volume * _over(patch.thickness, 2)
    G = np.einsum("...kg,...kgsa,...st,...kgtb->...kab", volume, B, patch.C, B, optimize=True)
    even = np.einsum("...kg,ga,gb->...kab", volume, N, N) if v == 6 else volume[..., :1, None] * (1 + np.eye(v)) / (v * (v + 1))
    return 2 * G, _over(patch.density, 3) * even


def _over(one: Any, axes: int) -> Any:
    """A number of each copy over further axes."""
    return np.asarray(one)[(..., *axes * (None,))]


def _by_sorted_nodes(rank: NDArray[np.int64], stiffness: Array) -> Array:
    """The upper triangle (k, w (w + 1)/2) of a stiffness (k, w, w) with the nodes in rising order, their rank (k, v): the order
    in the record decides which are corners.
    """
    k, v = rank.shape
    pair = np.zeros((v, v), np.int64)
    i, j = np.triu_indices(v, 1)
    pair[i, j] = pair[j, i] = np.arange(len(i))
    moved = pair[rank[:, i], rank[:, j]]
    own = np.arange(k)[:, None]
    a, b = np.triu_indices(len(i))
    return np.asarray(stiffness[..., own, moved[:, a], moved[:, b]])


# Visible faces of bodies, membranes and solids: triangles between nodes.

TRIANGLES: dict[int, tuple[tuple[int, ...], ...]] = {
    3: ((0, 1, 2),),
    4: ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)),
    6: ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
}
"""Faces of elements by their number of nodes; those of six nodes in the order of their stresses."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Skin:
    """Triangles of membranes and of the surface of solids.

    nodes : (f, 3). part : (f,) which of `names`; kinds : ``membrane`` or ``solid``. element : (f,) row in the table of its
    part. corner : (f,) which of the triangles of its element.
    """

    nodes: NDArray[np.int64]
    part: NDArray[np.int64]
    element: NDArray[np.int64]
    corner: NDArray[np.int64]
    names: tuple[str, ...]
    kinds: tuple[str, ...]


def skin_of(model: WholeModel) -> Skin:
    """The elements of membranes; of solids the faces that belong to one element only."""
    index = {name: k for k, name in enumerate(model.nodes)}
    records: list[tuple[str, Any]] = [*model.membranes.items(), *model.solids.items()]
    columns: list[NDArray[np.int64]] = [np.zeros((0, 6), np.int64)]
    for k, (_, part) in enumerate(records):
        rows = np.array([index[node] for node in part.nodes], np.int64)[np.array(part.elements, np.int64)]
        pattern = TRIANGLES[rows.shape[1]]
        count, each = len(rows), len(pattern)
        which = [np.full(count * each, k), np.repeat(np.arange(count), each), np.tile(np.arange(each), count)]
        columns.append(np.column_stack([rows[:, np.array(pattern)].reshape(-1, 3), *which]))
    rows = np.concatenate(columns)
    solid = rows[:, 3] >= len(model.membranes)
    if solid.any():
        _, first, times = np.unique(np.sort(rows[solid, :3], axis=1), axis=0, return_index=True, return_counts=True)
        outside = np.sort(first[times == 1])  # a face between two elements is not visible
        rows = np.concatenate([rows[~solid], rows[solid][outside]])
    return Skin(
        nodes=rows[:, :3],
        part=rows[:, 3],
        element=rows[:, 4],
        corner=rows[:, 5],
        names=tuple(name for name, _ in records),
        kinds=("membrane",) * len(model.membranes) + ("solid",) * len(model.solids),
    )


def body_faces(model: WholeModel, x0: NDArray[np.float64]) -> list[list[int]]:
    """Nodes of the triangles that a body of three nodes or more is drawn with: its hull in the start configuration (n, dim)."""
    if not model.bodies:
        return []
    from scipy.spatial import ConvexHull

    index = {name: k for k, name in enumerate(model.nodes)}
    found: list[list[int]] = []
    for body in model.bodies.values():
        nodes = np.array([index[name] for name in body.nodes])
        if len(nodes) < 3:
            continue
        flat = x0[nodes] - x0[nodes].mean(axis=0)
        sizes, axes = np.linalg.svd(flat, full_matrices=False)[1:]
        rank = int((sizes > 1e-6 * sizes[0]).sum())
        if rank == 3:
            found += nodes[ConvexHull(flat).simplices].tolist()
        elif rank == 2:
            ring = nodes[ConvexHull(flat @ axes[:2].T).vertices].tolist()
            found += [[ring[0], ring[k], ring[k + 1]] for k in range(1, len(ring) - 1)]
    return found
