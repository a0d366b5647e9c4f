"""Choice of weights, and the weight of members as equivalent forces at their ends."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import System
from kinetruss.mechanics.assembly import Loads, case_loads, elements, pair_weights

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


def loads_at(system: System, t: NDArray[np.float64], load_case: str | None, word: str, *, rotating: bool = False) -> Loads:
    """Loads of a case with the chosen weights; loads in time are taken at the times t. rotating : as of `case_loads`.

    Raises
    ------
    InputError : a base that rotates, with masses left out.
    """
    loads = case_loads(system, t, load_case, rotating=rotating)
    if word == "all":
        return loads
    if loads.base is not None:
        raise InputError("Masses that do not weigh do not rotate with the base. Give weight=True, or leave out base_rotation.")
    lump = loads.lump_gravity if word == "lumped" else np.zeros_like(loads.lump_gravity)
    return replace(loads, gravity=np.zeros(3), lump_gravity=lump)


def end_weights(system: System, x: NDArray[np.float64], g: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weight of members at their ends A and B, (members, 2, 3) N, at positions x (n, 3) under gravity g (3,).

    Half at each end for a uniform bar, by the place of its centre for a planar body. Along an active member, the base is
    carried by end A and the tube by end B; across it, the lever rule applies.
    """
    found, out = elements(system), np.zeros((len(system.members), 2, 3))
    own = found["pair_member"] >= 0
    out[found["pair_member"][own]] = pair_weights(found["pair"][own], g)
    # varying masses: m_A g and m_B g, and across the member the lever of the first moments h over L
    member, (m_A, m_B, h_A, h_B, _, _) = found["varying_member"], found["varying"].T[:, :, None]
    d = x[system.q[member]] - x[system.p[member]]
    L = np.linalg.norm(d, axis=1)[:, None]
    lever = (h_A - h_B) / L * (g - (d @ g)[:, None] * d / L**2)
    out[member, 0] += m_A * g - lever
    out[member, 1] += m_B * g + lever
    return out
