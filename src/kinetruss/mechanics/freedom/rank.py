"""Mobility of a structure: rank, mechanisms and states of self-stress by name."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display import counted
from kinetruss.errors import InputError
from kinetruss.kernels.structure.plan import LENGTH, SUM
from kinetruss.mechanics import (
    RANK_TOLERANCE,
    System,
    compile,
    constraint_jacobian,
    eliminated,
    ends_of,
    row_directions,
    row_ends,
)
from kinetruss.mechanics.configuration.positions import positions_of
from kinetruss.mechanics.constraints.moves import moves_text, self_stress_text
from kinetruss.mechanics.constraints.null_space import Spaces, outside
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Mobility", "mobility", "mobility_at", "underdriven"]

QUICK = 600
"""Rows and columns up to which an elimination is faster than inverse iteration."""
LINES = 40
"""Largest number of mechanisms, and of states of self-stress, that are printed."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Mobility:
    """Count and rank of a structure at one configuration (Maxwell 1864; Calladine 1978; Pellegrino & Calladine 1986).

    bars : rigid bars. couplings : between coordinates. drives : prescribed coordinates.
    coordinates, fixed : of all nodes. rank : of the rigid bars and couplings.
    degrees_of_freedom : freedoms before drives = coordinates - fixed - rank.
    undriven : freedoms left with all drives held. self_stress : number of states with all drives held.
    maxwell : coordinates - fixed - rigid bars - couplings - drives = undriven - self_stress (Calladine's count).
    node_names, row_names : names of nodes and of what is held.
    spaces : null spaces of the row-normalised Jacobian; their vectors are computed at first use.
    """

    coordinates: int
    fixed: int
    bars: int
    couplings: int
    drives: int
    rank: int
    degrees_of_freedom: int
    undriven: int
    self_stress: int
    maxwell: int
    node_names: tuple[str, ...]
    row_names: tuple[str, ...]
    system: System = field(repr=False)
    position: NDArray[np.float64] = field(repr=False)
    spaces: Spaces = field(repr=False)

    @cached_property
    def mechanisms(self) -> NDArray[np.float64]:
        """(undriven, n_nodes, dim) displacements with all drives held, the largest component of each 1."""
        return self._flat.reshape(self.undriven, len(self.node_names), 3)[:, :, : self.system.dim]

    @cached_property
    def self_stress_states(self) -> NDArray[np.float64]:
        """(self_stress, n_rows) forces, the largest of each 1; row_names name the rows."""
        return self.spaces.left.T

    @cached_property
    def second_order(self) -> tuple[bool, ...]:
        """True for infinitesimal mechanisms that a self-stress stiffens to second order, as flat arrangements across their
        plane. Some s has sum of s_r |dd_r|^2/L_r other than 0 (Pellegrino & Calladine 1986).
        """
        return self._soft(self.undriven)

    def _soft(self, most: int) -> tuple[bool, ...]:
        """`second_order` of the first mechanisms."""
        if not self.self_stress or not self.undriven:
            return (False,) * min(most, self.undriven)
        return _stiffened(self.system, self.position, self._flat[:most])

    @cached_property
    def smallest_singular_value(self) -> float:
        """Of the row-normalised Jacobian over all rows, the larger side being the bars or coordinates."""
        return self.spaces.smallest

    @cached_property
    def _flat(self) -> NDArray[np.float64]:
        found = np.zeros((self.undriven, self.system.x0.size))
        found[:, self.system.free] = self.spaces.right.T
        return found

    def __str__(self) -> str:
        coupled = f"{counted(self.couplings, 'coupling')}, " if self.couplings else ""
        lines = [
            f"{counted(self.bars, 'rigid bar')}, {coupled}{self.coordinates} coordinates, {self.fixed} fixed, "
            f"rank {self.rank}: "
            f"{counted(self.degrees_of_freedom, 'degree')} of freedom, {counted(self.drives, 'drive')}",
            f"with the drives held: {counted(self.undriven, 'mechanism')}, {counted(self.self_stress, 'state')} of self-stress "
            f"(count {self.maxwell} = {self.undriven} - {self.self_stress})",
        ]
        lines += [f"  mechanism {i + 1}: {text}" for i, text in enumerate(self.mechanism_texts(LINES))]
        lines += [f"  and {self.undriven - LINES} more mechanisms"] * (self.undriven > LINES)
        lines += [f"  self-stress {i + 1}: {text}" for i, text in enumerate(self.self_stress_texts(LINES))]
        lines += [f"  and {self.self_stress - LINES} more states of self-stress"] * (self.self_stress > LINES)
        return "\n".join(lines)

    def mechanism_texts(self, most: int | None = None) -> list[str]:
        """Each mechanism in words, the first `most`: which node moves in which direction, largest first."""
        soft = " -- stiff to second order only, loose under the least load: hold a node off the plane by bars, or add a support"
        return [
            moves_text(mode, self.node_names) + (soft if flat else "")
            for mode, flat in zip(self.mechanisms[:most], self._soft(self.undriven if most is None else most), strict=True)
        ]

    def self_stress_texts(self, most: int | None = None) -> list[str]:
        """Each state of self-stress in words, the first `most`: which bars are in compression or tension, largest first."""
        return [self_stress_text(state, self.row_names) for state in self.self_stress_states[:most]]


def mobility(model: Model, position: NDArray[np.float64] | None = None) -> Mobility:
    """Degrees of freedom, mechanisms and states of self-stress of a model.

    Parameters
    ----------
    position : (n_nodes, dim), m; by default the model's own configuration.

    Notes
    -----
    Decided by the singular values of the Jacobian of lengths and angles with unit rows; values below 1e-9 of the largest
    count as zero. By rank, never by count. Up to 600 rows and coordinates an elimination finds the rank where bounds of the
    singular values leave no doubt. Of more than 300 else only the lowest are found, with sparse
    factors, in little more than proportion to the size; a long truss with a small bending stiffness then does not count as
    a mechanism: its bars rotate as little as they elongate. The vectors are computed at first use.

    >>> import kinetruss as kt
    >>> square = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}, fixed=["A", "B"],
    ...                   bars={"b": ("B", "C"), "c": ("C", "D"), "d": ("D", "A")})
    >>> print(kt.kinematics.mobility(square))
    3 rigid bars, 8 coordinates, 4 fixed, rank 3: 1 degree of freedom, 0 drives
    with the drives held: 1 mechanism, 0 states of self-stress (count 1 = 1 - 0)
      mechanism 1: C moves along x (+1.000), D moves along x (+1.000)
    """
    system = compile(model)
    return mobility_at(system, positions_of(system, position))


def mobility_at(system: System, x: NDArray[np.float64]) -> Mobility:
    """`mobility` of a compiled system at positions x (n, 3)."""
    J = constraint_jacobian(system, x)[:, system.free]
    sure = eliminated(system, x) if max(J.shape) <= QUICK else None
    spaces = Spaces(J, lambda change: _hardly_strains(system, x, change), sure)
    own = system.row_drive < 0
    if sure is not None:
        rank = sure.first
    else:
        rank = spaces.rank if own.all() else Spaces(J[own], spaces.near).rank
    rows, columns = J.shape
    dim = system.dim
    idle = (dim - 1) * sum(node.scalar for node in system.model.nodes.values())
    driven = len(system.coordinate_drive)
    return Mobility(
        coordinates=len(system.nodes) * dim - idle,
        fixed=int(system.prescribed.sum()) - driven - len(system.nodes) * (3 - dim) - idle,
        bars=int((own & (system.row_kind == LENGTH)).sum()),
        couplings=int((own & (system.row_kind == SUM)).sum()),
        drives=len(system.drives),
        rank=rank,
        degrees_of_freedom=columns + driven - rank,
        undriven=columns - spaces.rank,
        self_stress=rows - spaces.rank,
        maxwell=columns - rows,
        node_names=system.nodes,
        row_names=system.row_names,
        system=system,
        position=x,
        spaces=spaces,
    )


def _hardly_strains(system: System, x: NDArray[np.float64], change: NDArray[np.float64]) -> bool:
    """True if a change (free,) with a small effect on lengths is a mechanism, not the bending of a long structure.

    A long truss bends with little strain, but then its bars also rotate little. In a mechanism the relative displacement of
    the ends of some bar is far larger than its elongation.
    """
    bars = system.row_kind == LENGTH
    flat = np.zeros(system.x0.size)
    flat[system.free] = change
    apart = row_ends(system, flat.reshape(-1, 3), bars)
    strain = np.abs(np.einsum("rc,rc->r", row_directions(system, x, rows=bars), apart))
    return bool(strain.max(initial=0.0) <= RANK_TOLERANCE * np.linalg.norm(apart, axis=1).max(initial=0.0))


def _stiffened(system: System, x: NDArray[np.float64], modes: NDArray[np.float64]) -> tuple[bool, ...]:
    """True if a self-stress of lengths alone stiffens an infinitesimal mechanism (3 n,).

    Rigid motions and finite mechanisms have no such self-stress: the stress matrix of a self-stress maps every affine
    motion to 0. The states of self-stress of the lengths are orthogonal to the range of their Jacobian.
    """
    bars = np.flatnonzero(system.row_kind == LENGTH)
    length = ends_of(system, x, system.row_member[bars])[1]
    bent = (np.sum(row_ends(system, modes.reshape(len(modes), len(x), 3), bars) ** 2, axis=2) / length).T
    J = constraint_jacobian(system, x)[:, system.free][bars]
    stiff = np.linalg.norm(outside(J, bent), axis=0)
    return tuple(bool(one) for one in stiff > 1e-6 * np.linalg.norm(bent, axis=0) + 1e-12 / length.min(initial=np.inf))


def underdriven(system: System) -> InputError:
    """The error of a mechanism that its drives do not hold, naming the nodes that move."""
    found = mobility_at(system, system.x0)
    if not found.undriven:
        way = np.zeros(system.x0.size)
        way[system.free] = found.spaces.weakest / np.abs(found.spaces.weakest).max()
        return InputError(
            f"The structure is in a singular position (smallest singular value {found.smallest_singular_value:.2g}): there "
            "its drives do not say which way it goes on. Nothing holds this: "
            f"{moves_text(way.reshape(-1, 3)[:, : system.dim], system.nodes)}. "
            "Draw it beside that position, or drive another member."
        )
    moves = "; ".join(found.mechanism_texts(4))
    return InputError(
        f"The drives leave {found.undriven} freedom{'s' if found.undriven != 1 else ''} of the mechanism: {moves}. "
        "Add a drive or a bar for each, or fix a node."
    )
