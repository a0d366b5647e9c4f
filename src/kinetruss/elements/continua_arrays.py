"""Bodies, membranes, solids and beams as arrays: pairs of nodes with mass, edges, stiffness, visible faces."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.beams import BeamElements, beam_elements
from kinetruss.model import Material, Orthotropic, WholeModel, body_mass
from kinetruss.model.beam_frames import rigid_beams

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.continua import EdgeElements


THIN = 1e-10
"""Eigenvalues of m_ij below this fraction of the largest count as zero: the body lies in a plane or on a line."""


def pair_arrays(model: WholeModel, index: dict[str, int]) -> dict[str, NDArray[Any]]:
    """pair_p, pair_q, pair_mass, pair_skew and thin of `System`."""
    pairs: list[tuple[int, int, float, float]] = []
    thin = np.zeros(len(index), np.bool_)
    for body in [*model.bodies.values(), *rigid_beams(model)]:
        if body.mass:
            nodes = [index[name] for name in body.carried_by(model.dim)]
            m, skew = body_mass(model, body)
            pairs += [
                (nodes[i], nodes[j], float(m[i, j]), skew if i != j else 0.0)
                for i in range(len(nodes))
                for j in range(i, len(nodes))
                if m[i, j] or (skew and i != j)
            ]
            thin[nodes] |= _is_thin(m, skew)
    p, q, mass, turn = zip(*pairs, strict=True) if pairs else ((), (), (), ())
    return {
        "pair_p": np.array(p, np.int32),
        "pair_q": np.array(q, np.int32),
        "pair_mass": np.array(mass, np.float64),
        "pair_skew": np.array(turn, np.float64),
        "thin": thin,
    }


def _is_thin(m: NDArray[np.float64], skew: float) -> bool:
    """True if the matrix of a body has a direction without inertia."""
    values = np.linalg.eigvalsh(m + 1j * np.triu(np.full_like(m, skew), 1) - 1j * np.tril(np.full_like(m, skew), -1))
    return bool(values[0] <= THIN * values[-1])


# Membranes, solids and beams as arrays: edges, which elements share, and the stiffness of each element by its edges.
#
# Of Green's strain E = (F^T F - 1)/2 with F = sum x_a grad N_a, where sum grad N_a = 0, only the squared distances c_ab of
# nodes remain,
#
#     E = -1/4 sum_(a < b) (c_ab - c0_ab) (grad N_a grad N_b^T + grad N_b grad N_a^T),
#
# so E = B (c - c0) and the energy of an element is a quadratic form, W = (c - c0)^T G (c - c0)/2, G = integral of B^T C B dV.
# A triangle has 3 such edges, a tetrahedron 6, a six-node triangle with linear strain 15, a beam with the frames of its ends 15
# in the plane and 28 in space (elements.beams). The force density of an edge is q =
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
    """p, q (e,) nodes of the edges, p < q; start (n, 3) places of all nodes, m, without stress; mass (e,) kg, m_pq of the
    consistent mass matrix, and lump (n,) its diagonal.

    groups : by number of nodes v, edge (k, v (v - 1)/2) edges of the pairs (0, 1), (0, 2), ... of each element's nodes in
    rising order, and stiff (k, w (w + 1)/2) the upper triangle of 2 G by rows, N/m^3. patches, beams : what they came from.
    """

    p: NDArray[np.int32]
    q: NDArray[np.int32]
    start: NDArray[np.float64]
    mass: NDArray[np.float64]
    lump: NDArray[np.float64]
    groups: dict[int, tuple[NDArray[np.int32], NDArray[np.float64]]]
    patches: tuple[Patch, ...]
    beams: BeamElements | None

    @cached_property
    def record(self) -> EdgeElements:
        """What kernels take."""
        from kinetruss.elements.continua import edge_elements  # compiled; callers that only check do not need it

        delays: dict[int, NDArray[np.float64]] = {}
        if self.beams is not None:
            v, own = self.beams.nodes.shape[1], self.beams.damping
            delays[v] = np.concatenate([np.zeros(len(self.groups[v][0]) - len(own)), own])  # beams are the last elements
        return edge_elements(self.p, self.q, self.start, self.groups, delays)


def compiled_continua(model: WholeModel, index: dict[str, int], x0: NDArray[np.float64]) -> Continua | None:
    """All membranes, solids and elastic beams of a model on positions x0 (n, 3), or None if it has none."""
    patches, beams = tuple(_patches(model, index, x0)), beam_elements(model, index, x0)
    if not patches and beams is None:
        return None
    n = len(x0)
    made = [(patch.nodes, *_stiffness(patch, x0)) for patch in patches]
    if beams is not None:
        made.append((beams.nodes, beams.stiffness(), beams.mass()))
    nodes = [np.sort(own, axis=1) for own, _, _ in made]
    keys = [_keys(one, n) for one in nodes]
    # edges that elements share are one
    found, place = np.unique(np.concatenate([key.reshape(-1) for key in keys]), return_inverse=True)
    p, q = found // n, found % n
    mass, lump = np.zeros(len(found)), np.zeros(n)
    places = np.split(place.reshape(-1).astype(np.int32), np.cumsum([key.size for key in keys])[:-1])
    groups: dict[int, list[tuple[NDArray[np.int32], NDArray[np.float64]]]] = {}
    # stiffness 2 G by elements; masses by edges and nodes
    for element, own, key, at in zip(made, nodes, keys, places, strict=True):
        edge, v = at.reshape(key.shape), own.shape[1]
        stiff, share = _by_sorted_nodes(*element)
        i, j = np.triu_indices(v, 1)
        mass += np.bincount(edge.reshape(-1), share[:, i, j].reshape(-1), len(found))
        lump += np.bincount(own.reshape(-1), np.einsum("kaa->ka", share).reshape(-1), n)
        groups.setdefault(v, []).append((edge, stiff))
    joined = {v: (np.concatenate([e for e, _ in parts]), np.concatenate([s for _, s in parts])) for v, parts in groups.items()}
    return Continua(
        p=p.astype(np.int32), q=q.astype(np.int32), start=x0, mass=mass, lump=lump, groups=joined, patches=patches, beams=beams
    )


def without_beams(found: Continua) -> Continua:
    """The same without its beams, which are the last elements."""
    if found.beams is None:
        return found
    v, count = found.beams.nodes.shape[1], len(found.beams.names)
    edge, stiff = found.groups[v]
    return replace(found, beams=None, groups={**found.groups, v: (edge[:-count], stiff[:-count])})


def _keys(nodes: NDArray[np.int64], n: int) -> NDArray[np.int64]:
    i, j = np.triu_indices(nodes.shape[1], 1)
    return np.asarray(nodes[:, i] * n + nodes[:, j])


def _patches(model: WholeModel, index: dict[str, int], x0: NDArray[np.float64]) -> list[Patch]:
    found = []
    parts: list[tuple[str, Any]] = [*model.membranes.items(), *model.solids.items()]
    for name, part in parts:
        here = np.array([index[node] for node in part.nodes], np.int64)
        nodes = here[np.array(part.elements, np.int64)]
        if nodes.shape[1] == 6 and part.strain == "constant":
            nodes = nodes[:, np.array(FOUR)].reshape(-1, 3)
        material: Any = part.orthotropic or model.material_of(part)  # one of them, or the model is faulty
        flat = hasattr(part, "thickness")
        found.append(
            Patch(
                name=name,
                nodes=nodes,
                C=law_matrix(material, part.plane if flat else "solid"),
                axes=material_axes(part, x0[nodes[:, :3]], model.dim),
                density=material.density,
                thickness=part.thickness if flat else 1.0,
            )
        )
    return found


def law_matrix(material: Material | Orthotropic, plane: str) -> NDArray[np.float64]:
    """C with S = C E, Pa, for (E11, E22, 2 E12), or (E11, E22, E33, 2 E23, 2 E13, 2 E12) of a solid; in material axes.

    plane : "stress", "strain" or "solid".
    """
    if isinstance(material, Material):
        E, nu = material.E, material.poisson
        E1 = E2 = E3 = E
        n12 = n13 = n23 = nu
        G12 = G13 = G23 = E / (2 * (1 + nu))
    else:
        E1, E2, n12, G12 = material.E1, material.E2, material.nu12, material.G12
        E3, n13, n23 = material.E3 or E2, material.nu13 or 0.0, material.nu23 or 0.0
        G13, G23 = material.G13 or G12, material.G23 or G12
    # compliance matrix
    S = np.zeros((6, 6))
    S[:3, :3] = [[1 / E1, -n12 / E1, -n13 / E1], [-n12 / E1, 1 / E2, -n23 / E2], [-n13 / E1, -n23 / E2, 1 / E3]]
    S[3:, 3:] = np.diag([1 / G23, 1 / G13, 1 / G12])
    inside = np.ix_([0, 1, 5], [0, 1, 5])
    if plane == "stress":
        return np.asarray(np.linalg.inv(S[inside]))
    C = np.linalg.inv(S)
    return np.asarray(C[inside] if plane == "strain" else C)


def material_axes(part: Any, corners: NDArray[np.float64], dim: int) -> NDArray[np.float64]:
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
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    laid = axis - normal * (normal @ axis)[:, None]
    size = np.linalg.norm(laid, axis=1, keepdims=True)
    if part.axis is None:  # of an element across x: y
        other = np.array([0.0, 1.0, 0.0]) - normal * normal[:, 1:2]
        laid = np.where(size > 0.1, laid, other)
        size = np.linalg.norm(laid, axis=1, keepdims=True)
    one = laid / size
    return np.stack([one, np.cross(normal, one)], axis=1)


def element_points(patch: Patch, nodes: NDArray[np.int64], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points (k, v, 2 or 3) of elements in material axes, m, from the first node."""
    d = x[nodes] - x[nodes[:, :1]]
    return np.asarray(np.einsum("kvc,ksc->kvs", d, np.broadcast_to(patch.axes, (len(nodes), *patch.axes.shape[1:]))))


def gradients(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Gradients of the shape functions (k, g, v, s), 1/m, at g points of each element, their volumes (k, g), and N (g, v).

    points (k, v, s) : reference points of the nodes, m.
    """
    weight, N, local = _rule(points.shape[1])
    # Jacobian of the map from area coordinates to the material axes
    J = np.einsum("gvs,kvc->kgsc", local, points)
    return np.einsum("gvs,kgcs->kgvc", local, np.linalg.inv(J)), weight * np.abs(np.linalg.det(J)), N


def _strain_rows(gradient: NDArray[np.float64]) -> NDArray[np.float64]:
    """B (k, g, s, w) of w pairs of nodes (0, 1), (0, 2), ... from gradients (k, g, v, dim)."""
    dim = gradient.shape[3]
    a, b = np.triu_indices(gradient.shape[2], 1)
    ga, gb = gradient[:, :, a], gradient[:, :, b]
    # E = -1/2 sum over pairs of nodes of s_ab (grad N_a grad N_b^T), symmetric part
    rows = [-0.5 * ga[..., c] * gb[..., c] for c in range(dim)]
    shears = [(0, 1)] if dim == 2 else [(1, 2), (0, 2), (0, 1)]
    rows += [-0.5 * (ga[..., c] * gb[..., d] + ga[..., d] * gb[..., c]) for c, d in shears]
    return np.stack(rows, axis=2)


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


def _stiffness(patch: Patch, x0: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """2 G (k, w, w) of the pairs of nodes of each element, N/m^3, and the masses (k, v, v), kg."""
    v = patch.nodes.shape[1]
    gradient, volume, N = gradients(element_points(patch, patch.nodes, x0))
    B, volume = _strain_rows(gradient), volume * patch.thickness
    G = np.einsum("kg,kgsa,st,kgtb->kab", volume, B, patch.C, B, optimize=True)
    share = patch.density * (
        np.einsum("kg,ga,gb->kab", volume, N, N) if v == 6 else volume[:, :1, None] * (1 + np.eye(v)) / (v * (v + 1))
    )
    return 2 * G, share


def _by_sorted_nodes(
    nodes: NDArray[np.int64], stiffness: NDArray[np.float64], share: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The upper triangle (k, w (w + 1)/2) of a stiffness (k, w, w), and masses (k, v, v), with the nodes (k, v) in rising
    order: the order in the record decides which are corners, or ends.
    """
    k, v = nodes.shape
    rank = np.argsort(nodes, axis=1)
    pair = np.zeros((v, v), np.int64)
    i, j = np.triu_indices(v, 1)
    pair[i, j] = pair[j, i] = np.arange(len(i))
    moved = pair[rank[:, i], rank[:, j]]
    own = np.arange(k)[:, None]
    a, b = np.triu_indices(len(i))
    return stiffness[own, moved[:, a], moved[:, b]], share[own[:, :, None], rank[:, :, None], rank[:, None, :]]


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
