"""What can move, what is held twice: rank, mechanisms and states of self-stress by name."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels._plan import LENGTH, SUM
from kinetruss.kinematics._positions import positions_of
from kinetruss.model import Model
from kinetruss.system import RANK_TOLERANCE, System, compile, jacobian

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Mobility", "mobility", "mobility_at", "moves_text", "underdriven"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Mobility:
    """Count and rank of a structure at one configuration (Maxwell 1864; Calladine 1978; Pellegrino & Calladine 1986).

    bars : rigid bars. couplings : between coordinates. drives : prescribed coordinates.
    coordinates, fixed : of all nodes. rank : of the rigid bars and couplings.
    degrees_of_freedom : freedoms before drives = coordinates - fixed - rank.
    undriven : freedoms left with all drives held. self_stress : number of states with all drives held.
    maxwell : coordinates - fixed - rigid bars - couplings - drives = undriven - self_stress (Calladine's count).
    mechanisms : (undriven, n_nodes, dim) unit displacements with all drives held.
    second_order : (undriven,) True for mechanisms that a self-stress ends at once: stiff only to second order, as flat
        arrangements are across their plane. Some s has sum of s_r |dd_r|^2/L_r other than 0 (Pellegrino & Calladine 1986).
    self_stress_states : (self_stress, n_rows) forces; row_names name the rows.
    smallest_singular_value : of the row-normalised Jacobian over all rows, the larger side being the bars or coordinates.
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
    mechanisms: NDArray[np.float64]
    second_order: tuple[bool, ...]
    self_stress_states: NDArray[np.float64]
    node_names: tuple[str, ...]
    row_names: tuple[str, ...]
    smallest_singular_value: float

    def __str__(self) -> str:
        coupled = f"{self.couplings} couplings, " if self.couplings else ""
        lines = [
            f"{self.bars} rigid bars, {coupled}{self.coordinates} coordinates, {self.fixed} fixed, rank {self.rank}: "
            f"{self.degrees_of_freedom} degrees of freedom, {self.drives} drives",
            f"with the drives held: {self.undriven} mechanisms, {self.self_stress} states of self-stress "
            f"(count {self.maxwell} = {self.undriven} - {self.self_stress})",
        ]
        lines += [f"  mechanism {i + 1}: {text}" for i, text in enumerate(self.mechanism_texts())]
        lines += [f"  self-stress {i + 1}: {text}" for i, text in enumerate(self.self_stress_texts())]
        return "\n".join(lines)

    def mechanism_texts(self) -> list[str]:
        """Each mechanism in words: which node moves in which direction, largest first."""
        soft = " -- stiff to second order only, loose under the least load: hold a node off the plane by bars, or add a support"
        return [
            moves_text(mode, self.node_names) + (soft if flat else "")
            for mode, flat in zip(self.mechanisms, self.second_order, strict=True)
        ]

    def self_stress_texts(self) -> list[str]:
        """Each state of self-stress in words: which bars push or pull each other, largest first."""
        return [_pulls(state, self.row_names) for state in self.self_stress_states]


def mobility(model: Model, position: NDArray[np.float64] | None = None) -> Mobility:
    """Degrees of freedom, mechanisms and states of self-stress of a model.

    Parameters
    ----------
    position : (n_nodes, dim), m; by default the model's own configuration.

    Notes
    -----
    Decided by the singular values of the Jacobian of lengths and angles with unit rows; values below 1e-9 of the largest
    count as zero. By rank, never by count.

    >>> import kinetruss as kt
    >>> square = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}, fixed=["A", "B"],
    ...                   bars={"b": ("B", "C"), "c": ("C", "D"), "d": ("D", "A")})
    >>> print(kt.kinematics.mobility(square))
    3 rigid bars, 8 coordinates, 4 fixed, rank 3: 1 degrees of freedom, 0 drives
    with the drives held: 1 mechanisms, 0 states of self-stress (count 1 = 1 - 0)
      mechanism 1: C moves along x (+1.000), D moves along x (+1.000)
    """
    system = compile(model)
    return mobility_at(system, positions_of(system, position))


def mobility_at(system: System, x: NDArray[np.float64], values: NDArray[np.float64] | None = None) -> Mobility:
    """`mobility` of a compiled system at positions x (n, 3)."""
    J = jacobian(system, x, values)
    rigid = J[system.row_drive < 0]
    rank, held = _rank(rigid), _rank(J)
    columns = J.shape[1]
    dim = system.dim
    idle = (dim - 1) * sum(node.scalar for node in system.model.nodes.values())
    coordinates = len(system.nodes) * dim - idle
    driven = len(system.coordinate_drive)
    fixed = int(system.prescribed.sum()) - driven - len(system.nodes) * (3 - dim) - idle
    modes = _tidy(_null(J)).T
    mechanisms = np.zeros((len(modes), system.x0.size))
    mechanisms[:, system.free] = modes
    states = _tidy(_null(J.T)).T
    values_of = np.linalg.svd(J, compute_uv=False) if J.size else np.ones(1)
    return Mobility(
        coordinates=coordinates,
        fixed=fixed,
        bars=int(((system.row_drive < 0) & (system.row_kind == LENGTH)).sum()),
        couplings=int(((system.row_drive < 0) & (system.row_kind == SUM)).sum()),
        drives=len(system.drives),
        rank=rank,
        degrees_of_freedom=columns + driven - rank,
        undriven=columns - held,
        self_stress=len(J) - held,
        maxwell=columns - len(J),
        mechanisms=mechanisms.reshape(len(modes), len(system.nodes), 3)[:, :, :dim],
        second_order=tuple(_ends_at_once(system, x, mode, states) for mode in mechanisms),
        self_stress_states=states,
        node_names=system.nodes,
        row_names=tuple(system.row_name(r) for r in range(len(J))),
        smallest_singular_value=float(values_of.min()),
    )


def _ends_at_once(system: System, x: NDArray[np.float64], mode: NDArray[np.float64], states: NDArray[np.float64]) -> bool:
    """True where a self-stress of lengths alone stiffens an infinitesimal mechanism (3 n,), so that it goes no further.

    Rigid motions and finite mechanisms have none such: the stress matrix of a self-stress takes every affine motion to 0.
    """
    states = states[np.all(np.abs(states[:, system.row_kind != LENGTH]) < 1e-9, axis=1)]
    if not len(states):
        return False
    ends = system.p[system.row_member], system.q[system.row_member]
    change = mode.reshape(-1, 3)[ends[1]] - mode.reshape(-1, 3)[ends[0]]
    length = np.linalg.norm(x[ends[1]] - x[ends[0]], axis=1)
    bent = np.einsum("rc,rc->r", change, change) / length
    whole = np.abs(states) @ bent
    return bool(np.any(np.abs(states @ bent) > 1e-6 * whole + 1e-12 / length.min()))


def underdriven(system: System) -> InputError:
    """The error of a mechanism that its drives do not hold, naming the nodes that move."""
    found = mobility_at(system, system.x0)
    moves = "; ".join(found.mechanism_texts()[:4])
    return InputError(
        f"The drives leave {found.undriven} freedom{'s' if found.undriven != 1 else ''} of the mechanism: {moves}. "
        "Add a drive or a bar for each, or fix a node."
    )


def _rank(J: NDArray[np.float64]) -> int:
    if not J.size:
        return 0
    values = np.linalg.svd(J, compute_uv=False)
    return int(np.sum(values > RANK_TOLERANCE * values[0]))


def _null(J: NDArray[np.float64]) -> NDArray[np.float64]:
    """Orthonormal basis of the null space, (columns, dimension)."""
    if J.shape[0] == 0 or J.shape[1] == 0:
        return np.eye(J.shape[1])
    from scipy.linalg import null_space

    return np.asarray(null_space(J, rcond=RANK_TOLERANCE))


def _tidy(basis: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same space with as many zeros as Gauss-Jordan elimination gives, largest entry of each vector +1."""
    tidy = basis.copy()
    for k in range(tidy.shape[1]):
        row = int(np.argmax(np.abs(tidy[:, k])))
        tidy[:, k] /= tidy[row, k]
        for other in range(tidy.shape[1]):
            if other != k:
                tidy[:, other] -= tidy[row, other] * tidy[:, k]
    for k in range(tidy.shape[1]):
        row = int(np.argmax(np.abs(tidy[:, k]) * (1 - 1e-9 * np.arange(len(tidy)))))
        tidy[:, k] /= tidy[row, k]
    tidy[np.abs(tidy) < 1e-12] = 0.0
    return tidy


def moves_text(mode: NDArray[np.float64], names: tuple[str, ...]) -> str:
    """A mode (n, dim) in words: which node moves in which direction, largest first."""
    sizes = np.linalg.norm(mode, axis=1)
    order = [i for i in np.argsort(-sizes, kind="stable") if sizes[i] > 1e-6 * sizes.max()]
    shown = [f"{names[i]} moves along {_direction(mode[i])}" for i in order[:4]]
    return ", ".join(shown) + (f" and {len(order) - 4} more nodes" if len(order) > 4 else "")


def _direction(vector: NDArray[np.float64]) -> str:
    size = float(np.linalg.norm(vector))
    for axis, name in enumerate("xyz"[: len(vector)]):
        if abs(abs(vector[axis]) - size) < 1e-9 * size:
            return f"{name} ({vector[axis]:+.3f})"
    return "(" + ", ".join(f"{value:+.3f}" for value in vector) + ")"


def _pulls(state: NDArray[np.float64], names: tuple[str, ...]) -> str:
    order = [i for i in np.argsort(-np.abs(state), kind="stable") if abs(state[i]) > 1e-6]
    shown = [f"{names[i]} {state[i]:+.3f}" for i in order[:6]]
    return ", ".join(shown) + (f" and {len(order) - 6} more" if len(order) > 6 else "")
