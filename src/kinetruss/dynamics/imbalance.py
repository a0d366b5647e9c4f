"""Forces that are left at nodes along a given motion, because elastic parts or the whole are not in balance."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import NONE
from kinetruss.mechanics import System
from kinetruss.mechanics.elements import material_stiffness, strained_forces
from kinetruss.mechanics.mobility import underdriven

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.loads import Loads

BALANCED = 1e-4
"""Residual, as a fraction of the largest nodal load, up to which elastic parts are in balance."""
ROUND_OFF = 1e-12
"""Residual, as a fraction of the stiffness times the size of the structure, that is round-off."""


def imbalance(
    system: System, loads: Any, x: NDArray[np.float64], rest: NDArray[np.float64], joint: NDArray[np.float64], still: bool
) -> dict[str, float]:
    """The largest residual at free coordinates, N, if it is more than round-off, by what is not in balance: ``off`` beams,
    membranes or solids; ``loose`` elastic bars, at rest also springs; ``adrift`` a structure that nothing holds.

    x, rest (times, 3 n) : positions, residuals. joint (times, members, 2, 3) : forces at the ends of members, N.
    """
    if off := _of_strained(system, loads, x, rest):
        return {"off": off}
    if off := _of_bars(system, rest, joint, still):
        return {"loose": off}
    return {"adrift": off} if (off := _of_the_whole(system, loads, rest, joint)) else {}


def imbalance_note(system: System, left: dict[str, float], at_rest: bool) -> str:
    """The message on what `imbalance` finds; empty if it is nothing."""
    if "off" in left:
        return unbalanced(left["off"], at_rest)
    if "loose" in left:
        return unbalanced(left["loose"], at_rest, "elastic bars" if (system.law != NONE).any() else "springs")
    return _unheld(left["adrift"], at_rest) if "adrift" in left else ""


def _of_strained(system: System, loads: Any, x: NDArray[np.float64], rest: NDArray[np.float64]) -> float:
    """Largest residual (times, 3 n) at free coordinates, N, where beams, membranes or solids are not in balance; else 0."""
    if system.continua is None or not len(x):
        return 0.0
    inner = [strained_forces(system, place) for place in x]
    largest = max(float(np.abs(part).max(initial=0.0)) for part in (loads.force, *inner))
    stiff = float(np.abs(material_stiffness(system, x[0].reshape(-1, 3)).diagonal()).max())
    off = float(np.abs(rest[:, system.free]).max(initial=0.0))
    return off if off > BALANCED * largest + ROUND_OFF * stiff * float(np.ptp(system.x0, axis=0).max()) else 0.0


def _of_bars(system: System, rest: NDArray[np.float64], joint: NDArray[np.float64], still: bool) -> float:
    """Largest residual (times, 3 n) at free coordinates, N, where elastic bars, at rest also springs, are not in balance; else
    0.

    joint (times, members, 2, 3) : forces at the ends of members, N. Without what is elastic there is none: what a mechanism
    needs in its free directions is no fault of its positions.
    """
    if not len(rest) or not ((system.law != NONE).any() or (still and system.force_elements)):
        return 0.0
    off = float(np.abs(rest[:, system.free]).max(initial=0.0))
    size = float(np.abs(joint).max(initial=0.0))
    stiff = float((system.spring * system.natural).max()) if (system.law != NONE).any() else 0.0
    return off if off > BALANCED * size + ROUND_OFF * stiff else 0.0


def _of_the_whole(system: System, loads: Any, rest: NDArray[np.float64], joint: NDArray[np.float64]) -> float:
    """Largest residual (times, 3 n), N, of a structure that nothing holds, whose motion is not one that its loads make; else 0.

    joint (times, members, 2, 3) : forces at the ends of members, N.
    """
    if not len(rest) or system.prescribed.reshape(-1, 3)[:, : system.dim].any():
        return 0.0
    off, size = (
        max(float(np.abs(one).max(initial=0.0)) for one in some) for some in ((rest[:, system.free],), (joint, loads.force))
    )
    return off if off > BALANCED * size else 0.0


def refuse_falling(system: System, loads: Loads, solved: dict[str, Any]) -> None:
    """Refuse poses of given drives in which loads act along a freedom that the drives leave; what is elastic yields, and has a
    message of its own.
    """
    if system.continua is not None or (system.law != NONE).any() or system.force_elements:
        return
    off = np.abs(solved["rest"][:, system.free]).max(initial=0.0)
    size = max(float(np.abs(one).max(initial=0.0)) for one in (solved["rest"], solved["joint"], loads.force))
    if off > BALANCED * size:
        raise InputError(f"{underdriven(system)} In this pose {off:.3g} N act along it, which nothing holds.")


def unbalanced(off: float, at_rest: bool, parts: str = "beams, membranes or solids") -> str:
    """The message on positions that the elastic parts do not have under these loads."""
    why = "at rest they have another shape, that of an equilibrium (in the model file: statics.equilibrium)"
    if not at_rest:
        why = "the motion is not one that these loads make"
    return (
        f"Not in balance: {parts} in these positions leave up to {off:.2g} N at free nodes; {why}. "
        "Reactions and member forces are without these."
    )


def _unheld(off: float, at_rest: bool) -> str:
    """The message on a floating structure in a motion that the loads do not make, or at rest under loads that move it."""
    why = "it cannot be at rest under these loads" if at_rest else "this is not the motion that these loads make"
    mend = "" if at_rest else " kinematics.follow moves it under all loads of the model, dynamics.simulate under a load case."
    return (
        f"Not in balance: nothing holds the structure, and {why}; up to {off:.2g} N are left at its nodes, and member forces "
        f"are without them.{mend}"
    )
