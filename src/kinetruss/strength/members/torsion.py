"""Torsion of arms and members by couples that pass through hinges, or enter hubs through members."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.actions import couples_at_hinges, friction_on_arms
from kinetruss.mechanics import compile, ends_of
from kinetruss.mechanics.assembly import case_loads
from kinetruss.model import Active, BodyCouple, Model
from kinetruss.model.hubs import arm_through, pivots_of
from kinetruss.strength.members.parts import parts_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from kinetruss.results import Forces

__all__ = ["shear_of_torsion", "torsion_of", "twisted_parts", "with_torsion"]

ROUND_OFF = 1e-10
"""Torques below this fraction of the couple are round-off."""


def twisted_parts(model: Model) -> NDArray[np.bool_]:
    """Parts (parts,) that may be under torsion: arms and members of hinges and of `BodyCouple.member`."""
    through = {(load.body, load.member) for load in _couples(model).values()}
    names = {str(name) for _, name in through}
    names |= {arm.name for body, member in through if member and (arm := arm_through(model, body, member))}
    pivots = pivots_of(model) if model.hubs else []
    names |= {one.tip for one in pivots}
    names |= {one.member for one in pivots if one.clamped or [other.member for other in pivots].count(one.member) == 2}
    return np.array([name in names for name in parts_of(model).members], np.bool_)


def _couples(model: Model) -> dict[str, BodyCouple]:
    """Loads that enter hubs through members."""
    return {name: load for name, load in model.loads.items() if isinstance(load, BodyCouple) and load.member is not None}


def torsion_of(model: Model, forces: Forces) -> NDArray[np.float64] | None:
    """Torque about axis 1 along every part, exerted by its B-side on its A-side, (times, parts) N m; None if nothing twists.

    The arm of a member has the component along it of the couples that pass through the joint, from its tip to the centre of the
    hub. The member itself, with base and tube, has their component along its own axis, from joint to joint.
    """
    found = None
    system, parts = compile(model), parts_of(model)
    x = np.pad(forces.motion.arrays["position"].values, ((0, 0), (0, 0), (0, 3 - model.dim)))
    index = {name: i for i, name in enumerate(system.members)}
    for arm, member, end, couple in _passed(model, forces, x):
        if found is None:
            found = np.zeros((len(x), len(parts.names)))
        size = ROUND_OFF * np.linalg.norm(couple, axis=1)
        for name, sign in ((arm, 1.0 if system.nodes[system.q[index[arm]]] == arm else -1.0), (member, 1.0 - 2.0 * end)):
            if not name:
                continue
            i = index[name]
            torque = sign * np.einsum("tc,tc->t", couple, ends_of(system, x, i)[2])
            rods = 2 if isinstance(model.members[name], Active) else 1
            found[:, parts.first[i] : parts.first[i] + rods] += np.where(np.abs(torque) > size, torque, 0.0)[:, None]
    return found


def _passed(model: Model, forces: Forces, x: NDArray[np.float64]) -> Iterator[tuple[str, str, int, NDArray[np.float64]]]:
    """Arm, member that is twisted from its other end (or empty), end of the member, couple (times, 3) of it on the hub."""
    arrays, twisted = forces.arrays, set[str]()
    if couples := _couples(model):
        case = forces.load_case if forces.load_case in model.load_cases else None
        given = case_loads(compile(model), arrays["time"].values, case, rotating=True).couples
        by_end: dict[tuple[str, int], str] = {}
        for name, load in couples.items():
            arm = arm_through(model, load.body, str(load.member))
            if name in given and arm is not None:
                # what leaves at one end entered at the other: of a member with couples at both ends the first counts
                own = by_end.setdefault((arm.member, 0), f"{arm.end}") == f"{arm.end}"
                yield arm.name, arm.member if own else "", arm.end, given[name]
    if model.hubs and pivots_of(model):
        coupling = arrays["coupling_force"].values if model.couplings else np.zeros((len(x), 0))
        hinges = couples_at_hinges(compile(model), x, arrays["member_force"].values, coupling)
        rubbed = {}
        if "bearing_couple" in arrays:
            rubbed = friction_on_arms(compile(model), x, arrays["bearing_couple"].values)
        for pivot, couple in hinges:
            alone = not pivot.clamped and [one.member for one, _ in hinges].count(pivot.member) == 1
            own = not alone and pivot.member not in twisted
            twisted.add(pivot.member)
            more = rubbed.get(list(model.members).index(pivot.tip), 0.0)
            yield pivot.tip, pivot.member if own else "", pivot.end, couple + more


def shear_of_torsion(model: Model, torque: NDArray[np.float64]) -> NDArray[np.float64]:
    """Largest shear stress, Pa, by torques (times, parts), N m; NaN at all times where a section does not know it."""
    factor = np.where((torque != 0).any(axis=0), parts_of(model).twist, 0.0)
    return np.asarray(np.abs(torque) * factor)


def with_torsion(von_mises: NDArray[np.float64], shear: NDArray[np.float64], twist: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound on the von Mises stress where the largest shear stresses of V and of torsion, Pa, act at its point.

    s^2 = sigma^2 + 3 tau_V^2 at any point, so sigma^2 + 3 (tau_V + tau)^2 <= s^2 + 3 (2 tau_V tau + tau^2) with the largest s,
    tau_V and tau.
    """
    return np.asarray(np.sqrt(von_mises**2 + 3 * twist * (2 * shear + twist)))
