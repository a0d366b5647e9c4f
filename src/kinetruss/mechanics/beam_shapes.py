"""Elastic beams held in their shape: the structure that drives move where beams could bend freely.

A beam whose deformations the rows of a model leave free gets as many rows w, 3 in the plane and 6 in space: the length of its
chord l; y_p . l, z_p . l with the axes across it at its first end; and p_j . q_i, i < j, of the edges of both frames, which
stand along the axes of space at the start. From the first frame on they place the nodes of the second one by one, as rigid
bars do.

All w and all deformations m (elements.beams) of a beam in its shape are functions of the same rigid motions xi of its second
frame, so that the forces N of the rows give those S of the deformations by a constant matrix: dm/dxi^T S = dw/dxi^T N.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.elements.beam_matrices import mode_gradients, mode_values
from kinetruss.elements.caching import cached
from kinetruss.kernels.coordinates.forms import PRODUCT
from kinetruss.kernels.structure.structure import LENGTH, SUM
from kinetruss.mechanics.arrangement import arrange
from kinetruss.mechanics.measures import measure_gradients, measured
from kinetruss.mechanics.mobility import mobility_at
from kinetruss.mechanics.row_gradients import constraint_jacobian
from kinetruss.mechanics.system import System
from kinetruss.model import Piece
from kinetruss.model.beam_frames import owner_of
from kinetruss.model.bracing import CHORD

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.beams import BeamElements
    from kinetruss.elements.continua_arrays import Continua


BENDS = 1e-6
"""Change of a mode, over that of the nodes by the length, from which on a freedom of a structure deforms a beam."""
STRAIGHT = 1e-8
"""Largest mode of a beam that counts as undeformed."""
NEXT_TO_NOTHING = 2.0**-60
"""Share of its rigidity that a beam has where its rows alone hold it; ratios of rigidities stay as they are."""
LITTLE = 1e-15
"""Coefficient of an edge in an axis of a beam, over the largest, up to which it is round-off."""


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedShapes:
    """A system whose loose beams are held in their shape.

    system : with the rows that hold them behind its own. elements : all elastic beams. beams (k,) indices of the held ones,
    and chords (k,) the members along them; rows (k, s) of `system`; forces (k, s, s) of modes, N m, by those of rows, N.
    """

    system: System
    elements: BeamElements
    beams: NDArray[np.int64]
    chords: NDArray[np.int64]
    rows: NDArray[np.int64]
    forces: NDArray[np.float64]

    def undecided(self, not_unique: NDArray[np.bool_]) -> tuple[str, ...]:
        """Names of held beams and links whose forces balance alone does not decide; not_unique : mask of all rows."""
        return self._named(self.beams[not_unique[self.rows].any(axis=1)])

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the held beams and links."""
        return self._named(self.beams)

    def _named(self, beams: NDArray[np.int64]) -> tuple[str, ...]:
        every, model = (self.elements.names[k] for k in beams), self.system.model
        return tuple(dict.fromkeys(owner_of(name, model.beams[name]).name for name in every))

    def modes(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Deformations of the held beams (times, k, s) at positions x (times, n, 3)."""
        return mode_values(self.elements, x)[:, self.beams]

    def mode_forces(self, N: NDArray[np.float64], modes: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
        """Forces of the modes of all elastic beams (times, beams, s), N m, NaN of those not held: of row forces N of `system`
        (times, rows), and what the beams resist where round-off deforms them by these modes.
        """
        out = np.full((len(N), *self.elements.rigidity.shape), np.nan)
        resisted = 0.0 if modes is None else self.elements.rigidity[self.beams] * modes
        out[:, self.beams] = np.einsum("ksr,tkr->tks", self.forces, N[:, self.rows]) + resisted
        return out


@cached()
def fixed_shapes(system: System) -> FixedShapes | None:
    """The system with its loose beams held in their shape; None if its rows determine all coordinates, or no beam is loose."""
    found = None if system.continua is None else system.continua.beams
    if found is None or arrange(system).plan is not None:
        return None
    loose = _deformable(system, found)
    return _with_shapes(system, found, loose) if len(loose) else None


@cached()
def rigid_links(system: System) -> FixedShapes | None:
    """The system in which rigid links keep their shape by rows, and resist by these alone: what simulations integrate; None
    without such links.
    """
    found = None if system.continua is None else system.continua.beams
    if found is None or not system.model.links:
        return None
    rigid = np.array([isinstance(one := system.model.beams[name], Piece) and one.held for name in found.names])
    if not rigid.any():
        return None
    held, continua = _with_shapes(system, found, np.flatnonzero(rigid)), cast("Continua", system.continua)
    if continua.patches or not rigid.all():
        left = replace(continua, beams=None if rigid.all() else found.chosen(~rigid))
        return replace(held, system=replace(held.system, continua=left, loaded=found))
    # with their mass alone they are like bodies
    heavy, pairs = np.flatnonzero(continua.lump), np.flatnonzero(continua.mass)
    more: dict[str, Any] = {
        "pair_p": np.concatenate([heavy, continua.p[pairs]]),
        "pair_q": np.concatenate([heavy, continua.q[pairs]]),
        "pair_mass": np.concatenate([continua.lump[heavy], continua.mass[pairs]]),
        "pair_skew": np.zeros(len(heavy) + len(pairs)),
    }
    for name, behind in more.items():
        own = getattr(system, name)
        more[name] = np.concatenate([own, behind]).astype(own.dtype)
    return replace(held, system=replace(held.system, continua=None, loaded=found, **more))


def _with_shapes(system: System, found: BeamElements, loose: NDArray[np.int64]) -> FixedShapes:
    """The system with rows that hold the beams `loose` (k,) in their shape."""
    place = {name: i for i, name in enumerate(system.members)}
    chords = np.array([place[f"{found.names[k]}{CHORD}"] for k in loose])
    # of each beam its chord, then its sums of products
    count, modes = len(loose), found.rigidity.shape[1]
    rows = len(system.row_kind) + np.arange(count * modes).reshape(count, modes)
    sums = len(system.measures) + np.arange(count * (modes - 1)).reshape(count, modes - 1)
    measure = np.insert(sums, 0, -1, axis=1).reshape(-1)
    at, factor = zip(*(one for k in loose for one in _products(found, k)), strict=True)
    size = np.array([len(one) for one in factor])
    owners = [owner_of(found.names[k], system.model.beams[found.names[k]]) for k in loose]
    names = tuple(owner.text for owner in owners for _ in range(modes - 1))
    more: dict[str, Any] = {
        "measure_ptr": system.measure_ptr[-1] + np.cumsum(size),
        "term_kind": np.full(size.sum(), PRODUCT),
        "term_at": np.concatenate(at),
        "term_data": np.insert(np.zeros((size.sum(), 6)), 0, np.concatenate(factor), axis=1),
        "row_member": np.repeat(chords, modes),
        "row_kind": np.where(measure < 0, LENGTH, SUM),
        "row_drive": np.full(rows.size, -1),
        "row_value": np.repeat(system.length0[chords], modes),
        "row_measure": measure,
    }
    more |= dict.fromkeys(("measure_period", "measure_start", "measure_scale"), np.zeros(sums.size))
    for name, behind in more.items():
        own = getattr(system, name)
        more[name] = np.concatenate([own, behind]).astype(own.dtype)
    held = replace(system, measures=system.measures + names, **more)
    for m in sums.flat:
        held.measure_start[m] = measured(held, m, system.x0[None])[0, 0]
        held.measure_scale[m] = math.sqrt(2.0) / np.linalg.norm(measure_gradients(held, m, system.x0[None]))
    held.row_value[rows[:, 1:]] = held.measure_start[sums]
    J = constraint_jacobian(held, system.x0)
    forces = np.array([_forces(found, k, system.x0, J[mine]) for k, mine in zip(loose, rows, strict=True)])
    return FixedShapes(system=held, elements=found, beams=loose, chords=chords, rows=rows, forces=forces)


def shaped(system: System) -> System:
    """The system that positions of motions of drives satisfy: with its loose beams held in their shape."""
    held = fixed_shapes(system)
    return system if held is None else held.system


@cached()
def yielding_shapes(system: System) -> FixedShapes | None:
    """As `fixed_shapes`, with held beams that resist next to nothing themselves: at places that differ a little from those that
    the rows allow, the rows alone act.
    """
    held = fixed_shapes(system)
    if held is None:
        return None
    continua = cast("Continua", held.system.continua)
    rigidity = held.elements.rigidity.copy()
    rigidity[held.beams] *= NEXT_TO_NOTHING
    beams = replace(held.elements, rigidity=rigidity)
    return replace(held, system=replace(held.system, continua=replace(continua, beams=beams)), elements=beams)


def _deformable(system: System, found: BeamElements) -> NDArray[np.int64]:
    """Beams (k,) that some freedom of the structure, its drives held, deforms."""
    flat = mobility_at(system, system.x0).mechanisms
    u = np.zeros((len(flat), *system.x0.shape))
    u[:, :, : system.dim] = flat
    rates = (mode_gradients(found, system.x0) @ u.reshape(len(u), -1).T).reshape(*found.rigidity.shape, -1)
    return np.flatnonzero(np.abs(rates).max(axis=(1, 2), initial=0.0) * found.length > BENDS)


def _products(found: BeamElements, k: int) -> list[tuple[list[list[int]], NDArray[np.float64]]]:
    """Of each row of beam k but that of its chord: nodes (t, 4) of the edges, and factors (t,) of their products."""
    (P, *p), (Q, *q) = (3 * found.nodes[k]).reshape(2, -1).tolist()
    dim, local = len(p), found.axes[k, 1:, 1 : len(p) + 1]
    share = np.where(np.abs(local) > LITTLE * np.abs(local).max(), local, 0.0)
    across = [([[p[i], P, Q, P] for i in np.flatnonzero(own)], own[own != 0.0]) for own in share]
    return across + [([[p[j], P, q[i], Q]], np.ones(1)) for i, j in combinations(range(dim), 2)]


def _forces(found: BeamElements, k: int, x: NDArray[np.float64], rows: Any) -> NDArray[np.float64]:
    """Forces of the modes of beam k for unit forces of its rows (s, s), N m, from the gradients (s, 3 n) of these at x (n, 3).

    Both do the same work S dm = N dw in all rigid motions of the second frame.
    """
    second, dim = found.nodes[k].reshape(2, -1)[1], found.axes.shape[1]
    arm = x[second] - x[second[0]]
    # translations, then rotations
    ways = [np.broadcast_to(axis, arm.shape) for axis in np.eye(3)[:dim]]
    ways += [np.cross(axis, arm) for axis in np.eye(3)[(2 if dim == 2 else 0) :]]
    u = np.zeros((len(ways), *x.shape))
    u[:, second] = ways
    modes = mode_gradients(found, x)[k * len(ways) : (k + 1) * len(ways)]
    work, rates = (one @ u.reshape(len(ways), -1).T for one in (rows, modes))
    return np.asarray(np.linalg.solve(rates.T, work.T))
