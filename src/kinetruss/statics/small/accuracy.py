"""The message if digits are lost: how many are left, which mechanism is near, and the fix."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.structure.plan import LENGTH
from kinetruss.mechanics import System, constraint_jacobian, row_directions, row_ends
from kinetruss.mechanics.constraints import Spaces, moves_text, ranked

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["NOTHING", "SILENT", "accuracy_note"]

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
