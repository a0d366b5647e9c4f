"""Frames of nodes of beams as what they are, a displacement and a rotation: three unknowns a node in the plane, six in space.

A frame is an origin O and nodes at the tips of its axes r_k, held to each other by rigid bars. To first order they move as

    u_k = u_O + t x r_k/s

with s the size of the frame and t/s its rotation. With u = T q these bars are fulfilled and drop out, G T q = 0; their forces
follow from the equilibrium of the tips.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics import System, cached
from kinetruss.model.members import Brace

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Frames(NamedTuple):
    """node (k, 1 + dim) the origin and the tips of each frame; row (k, bars) the rows of its bars, between `PAIRS` of these."""

    node: NDArray[np.int64]
    row: NDArray[np.int64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Motions:
    """to (free, q) : T over the free coordinates. kept (rows,) : False for the bars of frames. frames : as of the system."""

    to: csr_array
    kept: NDArray[np.bool_]
    frames: Frames

    def bar_forces(self, x: NDArray[np.float64], left: NDArray[np.float64]) -> NDArray[np.float64]:
        """Forces (k, bars) N of the bars of frames that balance `left` (3 n,) N on their tips, at positions x (n, 3)."""
        node, A = self.frames.node[:, 1:], self._on_tips(x)
        right = left.reshape(-1, 3)[node].reshape(len(node), -1)
        # what the tips leave unbalanced in other directions is round-off: the rotation is in equilibrium
        square = np.einsum("kab,kac->kbc", A, A)
        return np.asarray(np.linalg.solve(square, np.einsum("kab,ka->kb", A, right)[..., None])[..., 0])

    def stretched(self, x: NDArray[np.float64], given: NDArray[np.float64]) -> NDArray[np.float64]:
        """Displacements (3 n,) m of the tips that give the bars of frames elongations (k, bars) m, at positions x (n, 3)."""
        node, A = self.frames.node[:, 1:], self._on_tips(x)
        moved = A @ np.linalg.solve(np.einsum("kab,kac->kbc", A, A), given[..., None])
        found = np.zeros_like(x)
        np.add.at(found, node, moved.reshape(*node.shape, 3))
        return found.reshape(-1)

    def _on_tips(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Forces (k, 3 tips, bars) of unit forces of the bars of frames on their tips, at positions x (n, 3)."""
        node, dim = self.frames.node, self.frames.node.shape[1] - 1
        pairs = list(combinations(range(dim + 1), 2))
        A = np.zeros((len(node), dim + 1, 3, len(pairs)))
        for b, (i, j) in enumerate(pairs):
            d = x[node[:, j]] - x[node[:, i]]
            u = d / np.linalg.norm(d, axis=1)[:, None]
            A[:, i, :, b], A[:, j, :, b] = -u, u
        return A[:, 1:].reshape(len(node), 3 * dim, len(pairs))


@cached()
def frames_of(held: System) -> Frames:
    """The frames of the rows of `stiff_rows` whose tips are free, and belong to them alone."""
    dim, inner = held.dim, held.inner
    pairs = list(combinations(range(dim + 1), 2))
    rigid = {}
    bars = held.model.bars
    for r in np.flatnonzero(held.row_kind == LENGTH).tolist():
        name = held.members[held.row_member[r]]
        if name in inner.bars and isinstance(bars.get(name), Brace) and held.row_drive[r] < 0:
            rigid[frozenset((int(held.p[held.row_member[r]]), int(held.q[held.row_member[r]])))] = r
    node, row = [], []
    free = ~held.prescribed.reshape(-1, 3)[:, :dim]
    for frame in inner.frames.values():
        own = [held.node_index(name) for name in frame.all]
        rows = [rigid.get(frozenset((own[i], own[j]))) for i, j in pairs]
        if None not in rows and free[own[1:]].all():
            node.append(own)
            row.append(rows)
    return Frames(np.array(node, np.int64).reshape(-1, dim + 1), np.array(row, np.int64).reshape(-1, len(pairs)))


def motions_of(held: System, x: NDArray[np.float64]) -> Motions | None:
    """The motions of the frames of a system at positions x (n, 3), None if it has none."""
    frames = frames_of(held)
    node, row = frames
    if not len(node):
        return None
    dim, free = held.dim, held.free
    tip = np.zeros(x.size, np.bool_)
    tip.reshape(-1, 3)[node[:, 1:], :dim] = True
    own = free[~tip[free]]  # coordinates that stay unknowns
    column = np.full(x.size, -1)
    column[own] = np.arange(len(own))
    turns = 1 if dim == 2 else 3
    turn = len(own) + turns * np.arange(len(node))
    rows, columns, values = [own], [column[own]], [np.ones(len(own))]
    r = x[node[:, 1:]] - x[node[:, :1]]
    r = r / np.linalg.norm(r[:, :1], axis=2, keepdims=True)
    for k in range(dim):
        for a in range(dim):
            flat = 3 * node[:, 1 + k] + a
            origin = column[3 * node[:, 0] + a]
            moves = origin >= 0
            rows.append(flat[moves])
            columns.append(origin[moves])
            values.append(np.ones(int(moves.sum())))
            # (t x r)_a = t_b r_c - t_c r_b
            b, c = (a + 1) % 3, (a + 2) % 3
            for about, other, sign in ((b, c, 1.0), (c, b, -1.0)):
                if dim == 2 and about != 2:
                    continue
                rows.append(flat)
                columns.append(turn + (0 if dim == 2 else about))
                values.append(sign * r[:, k, other])
    place = np.full(x.size, -1)
    place[free] = np.arange(len(free))
    at = (place[np.concatenate(rows)], np.concatenate(columns))
    shape = (len(free), len(own) + turns * len(node))
    kept = np.ones(len(held.row_kind), np.bool_)
    kept[row] = False
    return Motions(to=csr_array(coo_array((np.concatenate(values), at), shape=shape)), kept=kept, frames=frames)


def reduced(motions: Motions | None, G: Any, more: int) -> Any:
    """G (rows + more, free) without the bars of frames, over the unknowns q."""
    if motions is None:
        return G
    kept = np.append(motions.kept, np.ones(more, np.bool_))
    return csr_array(csr_array(G)[kept] @ motions.to)
