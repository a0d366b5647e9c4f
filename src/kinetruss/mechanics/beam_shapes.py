"""Elastic beams held in their shape: the structure that drives move where beams could bend freely.

A beam whose deformation the rows of a model leave free is held by rigid bars between the frames of its ends, in a second
system with the same nodes. Its positions are those of the undeformed structure. Where the bars are statically determinate,
their forces give those of the deformation modes (elements.beams): with the rigid motions xi of the second frame,

    sum_s S_s dm_s/dxi = -(F, M),

F and M the resultants of the forces of the bars on that frame.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.beam_matrices import mode_gradients, mode_values
from kinetruss.elements.caching import cached
from kinetruss.mechanics.arrangement import arrange
from kinetruss.mechanics.mobility import mobility_at
from kinetruss.mechanics.row_gradients import row_directions
from kinetruss.mechanics.system import System, system_of
from kinetruss.model import Owner
from kinetruss.model.beam_frames import shape_bars

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.beams import BeamElements


BENDS = 1e-6
"""Change of a mode, over that of the nodes by the length, from which on a freedom of a structure deforms a beam."""
STRAIGHT = 1e-8
"""Largest mode of a beam that counts as undeformed."""


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedShapes:
    """A system whose loose beams are held in their shape.

    system : with the bars that hold them. elements : all elastic beams. beams (k,) indices of the held ones; members (m,) and
    rows (r,) of the model's own members and rows in `system`; bars : by beam the rows of its bars.
    """

    system: System
    elements: BeamElements
    beams: NDArray[np.int64]
    members: NDArray[np.int64]
    rows: NDArray[np.int64]
    bars: tuple[NDArray[np.int64], ...]

    def undecided(self, not_unique: NDArray[np.bool_]) -> tuple[str, ...]:
        """Names of held beams whose forces balance alone does not decide; not_unique : mask of the rows of `system`."""
        modes = self.elements.rigidity.shape[1]
        # a rigid bar beside a beam shares its force: one bar fewer than modes
        pairs = zip(self.beams, self.bars, strict=True)
        return tuple(self.elements.names[k] for k, rows in pairs if len(rows) < modes or not_unique[rows].any())

    def undeformed(self, x: NDArray[np.float64]) -> bool:
        """True if the held beams have their shape at all positions x (times, n, 3)."""
        return bool(np.abs(mode_values(self.elements, x)[:, self.beams]).max(initial=0.0) < STRAIGHT)

    def mode_forces(self, x: NDArray[np.float64], N: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Forces of the modes of all elastic beams (times, beams, s), N m, NaN of those not held.

        x (times, n, 3); N (times, rows) row forces of `system`; values (times, drives).
        """
        system, found = self.system, self.elements
        out = np.full((len(x), *found.rigidity.shape), np.nan)
        for i, place in enumerate(x):
            tension = N[i][:, None] * row_directions(system, place, values[i])
            gradients = mode_gradients(found, place)
            for k, rows in zip(self.beams, self.bars, strict=True):
                modes = gradients[k * found.rigidity.shape[1] : (k + 1) * found.rigidity.shape[1]]
                out[i, k] = _modes_of(system, found, k, place, (rows, tension, modes))
        return out


def _modes_of(system: System, found: BeamElements, k: int, x: NDArray[np.float64], bars: Any) -> NDArray[np.float64]:
    """Mode forces (s,) of beam k from the forces N u of its bars: rows, (all rows, 3) N, on their first ends, and gradients of
    its modes.
    """
    rows, tension, gradients = bars
    own = found.nodes[k]
    second = own[len(own) // 2 :]
    at = x[second] - x[second[0]]
    force = np.zeros_like(at)
    place = {int(node): i for i, node in enumerate(second)}
    for r in rows:
        m = system.row_member[r]
        for node, sign in ((int(system.p[m]), 1.0), (int(system.q[m]), -1.0)):
            if node in place:
                force[place[node]] += sign * tension[r]
    # rigid motions of the second frame: translations, then rotations
    dim = found.axes.shape[1]
    ways = [np.broadcast_to(axis, at.shape) for axis in np.eye(3)[:dim]]
    ways += [np.cross(axis, at) for axis in np.eye(3)[(2 if dim == 2 else 0) :]]
    rates, work = [], []
    for way in ways:
        u = np.zeros_like(x)
        u[second] = way
        rates.append(gradients @ u.reshape(-1))
        work.append(float(np.sum(force * way)))
    return np.asarray(-np.linalg.solve(np.array(rates), np.array(work)))


@cached()
def fixed_shapes(system: System) -> FixedShapes | None:
    """The system with its loose beams held in their shape; None if its rows determine all coordinates, or no beam is loose."""
    found = None if system.continua is None else system.continua.beams
    if found is None or arrange(system).plan is not None:
        return None
    loose = _deformable(system, found)
    if not len(loose):
        return None
    bars = shape_bars(system.model, [found.names[k] for k in loose])
    added = {name: bar for part in bars.values() for name, bar in part.items()}
    owners = {name: Owner("beams", beam) for beam, part in bars.items() for name in part}
    whole = system_of(system.given, system.model.with_bars(added, owners))
    place = {name: i for i, name in enumerate(whole.members)}
    keys = {key: r for r, key in enumerate(_keys(whole))}
    own = np.array([keys[key] for key in _keys(system)], np.int64)
    more = [np.flatnonzero(np.isin(whole.row_member, [place[bar] for bar in part])) for part in bars.values()]
    # the rows, drives and prescribed coordinates of this system, which may be fewer or others than those of its model
    rows = np.concatenate([own, *more])
    ends = np.cumsum([len(own), *map(len, more)])
    names = ("drives", "drive_start", "drive_measure", "prescribed", "coordinate_drive", "x0")
    held = whole.with_rows(rows, **{name: getattr(system, name) for name in names})
    none = np.full(len(rows) - len(own), -1, held.row_drive.dtype)
    return FixedShapes(
        system=replace(
            held,
            row_drive=np.concatenate([system.row_drive, none]),
            row_value=np.concatenate([system.row_value, held.row_value[len(own) :]]),
        ),
        elements=found,
        beams=loose,
        members=np.array([place[name] for name in system.members], np.int64),
        rows=np.arange(len(own)),
        bars=tuple(np.arange(a, b) for a, b in pairwise(ends)),
    )


def shaped(system: System) -> System:
    """The system that positions of motions of drives satisfy: with its loose beams held in their shape."""
    held = fixed_shapes(system)
    return system if held is None else held.system


def _deformable(system: System, found: BeamElements) -> NDArray[np.int64]:
    """Beams (k,) that some freedom of the structure, its drives held, deforms."""
    flat = mobility_at(system, system.x0).mechanisms
    u = np.zeros((len(flat), *system.x0.shape))
    u[:, :, : system.dim] = flat
    rates = (mode_gradients(found, system.x0) @ u.reshape(len(u), -1).T).reshape(*found.rigidity.shape, -1)
    return np.flatnonzero(np.abs(rates).max(axis=(1, 2), initial=0.0) * found.length > BENDS)


def _keys(system: System) -> list[tuple[str, int, int]]:
    """Names of the rows of a system."""
    columns = zip(system.row_member.tolist(), system.row_kind.tolist(), system.row_measure.tolist(), strict=True)
    return [("" if m >= 0 else system.members[i], kind, m) for i, kind, m in columns]
