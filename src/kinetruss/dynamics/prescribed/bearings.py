"""Forces with friction that follows from the joint forces: solved again with it until both agree."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.actions import couples_on_ends, friction_directions, seats_of
from kinetruss.dynamics.prescribed.tables import Read, carried
from kinetruss.errors import AnalysisError

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from kinetruss.kernels.structure.structure import States
    from kinetruss.mechanics import System
    from kinetruss.mechanics.assembly import Loads

__all__ = ["jammed", "rubbing", "with_friction", "with_friction_of"]

CLOSE = 1e-12
"""Change of the couples that counts as none, relative to the largest."""
GROWN = 1e6
"""Growth of the change at which the couples count as unbounded."""
MOST = 200
"""Rounds; they take about as many as -12/log10(mu r/l) with the lengths l of the members."""


def with_friction(
    system: System,
    read: Read,
    loads: Loads,
    states: States,
    solve: Callable[[Loads], dict[str, Any]],
    *,
    at_rest: bool = False,
) -> dict[str, Any]:
    """What `solve` finds under loads and friction: its result, and the couples (times, bearings, 3), N m, as ``bearing``.

    Raises
    ------
    AnalysisError : the couples do not settle: the joints jam.

    Notes
    -----
    Fixed point C = -mu r |R(C)| w/|w| over the samples together; its rate is mu r/l, far below 1 where joints turn at all.
    """
    solved = solve(loads)
    seats = seats_of(system)
    if at_rest or not seats:
        return solved
    x, ways = states.x.reshape(len(states.x), -1, 3), friction_directions(system, states)
    couple, first = np.zeros_like(ways), None
    for _ in range(MOST):
        trial = solved | {"joint": solved["joint"].copy(), "bearing": couple}
        joint = carried(system, read, loads, trial, False)[0].joint_force
        force = np.stack([np.linalg.norm(joint[:, seat.member, seat.end], axis=1) for seat in seats], axis=1)
        found = -(np.array([seat.arm for seat in seats]) * force)[:, :, None] * ways
        change, couple = np.abs(found - couple).max(initial=0.0), found
        first = change if first is None else first
        if not change <= GROWN * first:
            break
        if change <= CLOSE * np.abs(found).max(initial=0.0):
            return solved | {"bearing": couple}
        solved = solve(rubbing(system, loads, x, couple))
    worst = seats[int(np.argmax(np.abs(couple).max(axis=(0, 2))))].name
    raise jammed(worst)


def jammed(worst: str) -> AnalysisError:
    """The error of couples that do not settle."""
    return AnalysisError(
        f"The friction of bearing {worst!r} does not settle: the joint jams. Give it less friction or a smaller radius, or "
        "stay farther from positions in which its members line up."
    )


def rubbing(system: System, loads: Loads, x: NDArray[np.float64], couple: NDArray[np.float64]) -> Loads:
    """Loads and the nodal forces of couples of friction."""
    return with_friction_of(loads, *couples_on_ends(system, x, couple))


def with_friction_of(loads: Loads, nodes: NDArray[np.int64], forces: NDArray[np.float64]) -> Loads:
    """Loads and nodal forces (times, k, 3), N, of friction on nodes (k,)."""
    return replace(
        loads,
        loads=(*loads.loads, *("friction" for _ in nodes)),
        node=np.concatenate([loads.node, nodes]),
        force=np.concatenate([loads.force, forces], axis=1),
    )
