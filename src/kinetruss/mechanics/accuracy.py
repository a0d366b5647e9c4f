"""How many digits of forces a position near a singular one leaves, and the message about it.

Coordinates x have the relative precision eps, so that the direction of a bar of length L is known to eps |x|/L. With s, the
smallest singular value of a block of the Jacobian over its largest, forces that the block balances are known to eps |x|/(L s)
(Golub & Van Loan, Matrix Computations, 2013, section 2.6). Where this leaves no digit the position is singular: sets of forces
that differ by self-stress balance the loads alike.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics.arrangement import Arrangement
from kinetruss.mechanics.mode_texts import moves_text, ranked
from kinetruss.mechanics.null_space import Spaces
from kinetruss.mechanics.row_gradients import constraint_jacobian, row_directions, row_ends
from kinetruss.mechanics.system import System

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray


EPS = float(np.finfo(float).eps)

MANY = 1500
"""Number of rows up to which the Jacobian is a full matrix."""

NEAR = 1e-3
"""Pivots of rows of unit length below which singular values tell how many digits are lost."""

SILENT = 1e-7
"""Relative error up to which there is no message."""

NOTHING = 0.1
"""Relative error from which no digit is accurate."""

SHALLOW = 1e-4
"""The weakest mode is next to a mechanism if its strain over its relative motion is below this."""


def accuracy_note(system: System, x: NDArray[np.float64], force: float, displacement: float = 0.0) -> str:
    """Accuracy of forces and displacements, by bounds on their errors, and what limits it; empty if they are accurate.

    The weakest mode of the rows of `system` at x (n, 3) is named with the bars that resist it.
    """
    if force <= SILENT and displacement <= SILENT:
        return ""
    texts = [
        f"{what} are {_digits(error)}" for what, error in (("Forces", force), ("displacements", displacement)) if error > SILENT
    ]
    said = " and ".join(texts)
    return f"{said[0].upper()}{said[1:]}: {_cause(system, x)}"


def _digits(error: float) -> str:
    if not error < NOTHING:
        return "not sure to one digit"
    digits = int(-math.log10(error))
    return f"sure to about {digits} digit{'s' if digits != 1 else ''}"


def _cause(system: System, x: NDArray[np.float64]) -> str:
    bars = np.flatnonzero(system.row_kind == LENGTH)
    if not len(bars) or not len(system.free):
        return "the stiffnesses are too far apart. Make them more alike."
    flat = np.zeros(system.x0.size)
    flat[system.free] = Spaces(constraint_jacobian(system, x)[:, system.free]).weakest
    moved = flat.reshape(-1, 3)
    apart = row_ends(system, moved, bars)
    part = np.linalg.norm(apart, axis=1)
    strain = np.abs(np.einsum("rc,rc->r", row_directions(system, x, rows=bars), apart))
    names = ", ".join(system.parts_of(bars[k] for k in ranked(part, 0.5))[:4])
    way = moves_text(system, moved[:, : system.dim])
    if strain.max() < SHALLOW * part.max():
        return (
            f"the structure is next to a mechanism: {way}, held almost across by {names}. Add a bar or a support that holds "
            "this way, or move the nodes out of line."
        )
    return f"the structure is badly conditioned, weakest where {way}. Stiffen it there, or make stiffnesses more alike."


def weakest_block(system: System, plan: Any, x: NDArray[np.float64]) -> float:
    """Smallest singular value over the largest of a block of the Jacobian at x (n, 3); rows match the coordinates one to one.

    A closed loop may match as well and still move: then the ratio is 0 to round-off.
    """
    return min((ratio for _, ratio in _blocks(system, plan, x)), default=np.inf)


@cached(256)
def lost(system: System, arrangement: Arrangement, place: bytes) -> tuple[float, float]:
    """Round-off of directions, eps |x|/L, and the singular value s of `weakest_block`, of the block that loses most digits at
    positions (n, 3) as bytes: the same for every load case.
    """
    x = np.frombuffer(place).reshape(-1, 3)
    found = [(_round_off(system, rows, x), ratio) for rows, ratio in _blocks(system, arrangement.plan, x)]
    return max(found, key=lambda one: error_of(*one), default=(EPS, np.inf))


def error_of(round_off: float, ratio: float, power: int = 1) -> float:
    """Relative error of forces, by `lost`, at given positions, or with power 2 at those that have been closed from lengths,
    which are themselves known to eps/s only.
    """
    return round_off / ratio**power if ratio else np.inf


def _blocks(system: System, plan: Any, x: NDArray[np.float64]) -> Iterator[tuple[NDArray[np.int64], float]]:
    """Rows of each block, and the ratio of its singular values."""
    J: Any = constraint_jacobian(system, x)
    J = J.toarray() if J.shape[0] <= MANY else J
    for first, last in zip(plan.ptr[:-1], plan.ptr[1:], strict=True):
        rows, columns = plan.row[first:last], plan.col[first:last]
        block = J[np.ix_(rows, columns)] if isinstance(J, np.ndarray) else J[rows][:, columns].toarray()
        if block.size:
            sizes = np.linalg.svd(block, compute_uv=False)
            yield rows, float(sizes[-1] / sizes[0]) if sizes[0] else 0.0


def _round_off(system: System, rows: NDArray[np.int64], x: NDArray[np.float64]) -> float:
    """eps |x|/L of the rows of a block."""
    member = system.row_member[rows]
    ends = np.concatenate([x[system.p[member]], x[system.q[member]]])
    length = np.linalg.norm(x[system.q[member]] - x[system.p[member]], axis=1)
    return EPS * max(1.0, float(np.abs(ends).max()) / max(float(length.min()), 1e-300))
