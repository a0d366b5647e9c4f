"""Which weights count, and the weight of members as equivalent forces at their ends."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from kinetruss.dynamics.assembly.cases import Loads, case_loads
from kinetruss.errors import InputError
from kinetruss.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Weight", "end_weights", "loads_at", "weight_word"]

Weight = bool | Literal["lumped"]


def weight_word(weight: Weight) -> str:
    """``all``, ``lumped`` or ``none``; InputError for anything else."""
    if weight is True or weight is False:
        return "all" if weight else "none"
    if weight == "lumped":
        return "lumped"
    raise InputError(
        f"weight={weight!r}: give True (members and lumped masses), 'lumped' (massless members) or False (nothing weighs)."
    )


def loads_at(system: System, t: NDArray[np.float64], load_case: str | None, word: str) -> Loads:
    """Loads of a case with the weights that count; forces given over time are taken at the times t."""
    loads = case_loads(system, t, load_case)
    if word == "all":
        return loads
    lump = loads.lump_gravity if word == "lumped" else np.zeros_like(loads.lump_gravity)
    return replace(loads, gravity=np.zeros(3), lump_gravity=lump)


def end_weights(system: System, x: NDArray[np.float64], g: NDArray[np.float64]) -> NDArray[np.float64]:
    """What members weigh on their ends A and B, (members, 2, 3) N, at positions x (n, 3) under gravity g (3,).

    Half and half for a uniform bar, by the place of its centre for a planar body. The base of an active member hangs on A
    along the member, its tube on B; across the member the weight is shared by the lever.
    """
    d = x[system.q] - x[system.p]
    L = np.linalg.norm(d, axis=1)
    u = d / L[:, None]
    along = (u @ g)[:, None] * u
    across = g - along
    mass, length = system.rods[:, [0, 3]], system.rods[:, [1, 4]]
    lever = np.where(system.two_rods[:, None], 0.5 * length / L[:, None], 0.5)
    on_b = np.where(system.two_rods, 0.0, 0.5 * mass[:, 0])[:, None] * along
    on_b += (mass[:, 0] * lever[:, 0])[:, None] * across
    on_a = np.where(system.two_rods, mass[:, 0], 0.5 * mass[:, 0])[:, None] * along
    on_a += (mass[:, 0] * (1 - lever[:, 0]))[:, None] * across
    tube = np.where(system.two_rods, mass[:, 1], 0.0)
    on_b += tube[:, None] * (along + (1 - lever[:, 1])[:, None] * across)
    on_a += (tube * lever[:, 1])[:, None] * across
    if system.is_body.any():
        # a force at (e, f): (1 - e/l) g and f/l times g turned by 90 deg at A, the rest at B
        m, e, f, _ = system.body.T
        turned = np.array([-g[1], g[0], 0.0])
        on_a += (m * (1 - e / L))[:, None] * g + (m * f / L)[:, None] * turned
        on_b += (m * e / L)[:, None] * g - (m * f / L)[:, None] * turned
    return np.stack([on_a, on_b], axis=1)
