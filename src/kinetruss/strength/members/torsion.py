"""Torsion of arms and active members by couples that enter hubs through members."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.mechanics import compile, ends_of
from kinetruss.mechanics.assembly import case_loads
from kinetruss.model import Active, BodyCouple, Model
from kinetruss.model.hubs import arm_through
from kinetruss.strength.members.parts import parts_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Forces

__all__ = ["shear_of_torsion", "torsion_of", "twisted_parts", "with_torsion"]


def twisted_parts(model: Model) -> NDArray[np.bool_]:
    """Parts (parts,) that couples of `BodyCouple.member` twist: arms, and base and tube of active members."""
    parts = parts_of(model)
    through = {(load.body, load.member) for load in model.loads.values() if isinstance(load, BodyCouple) and load.member}
    names = {name for _, name in through}
    names |= {arm.name for body, member in through if member and (arm := arm_through(model, body, member))}
    return np.array([name in names for name in parts.members])


def torsion_of(model: Model, forces: Forces) -> NDArray[np.float64] | None:
    """Torque about axis 1 along every part, exerted by its B-side on its A-side, (times, parts) N m; None without couples.

    An arm has the component of the couple along it, from its tip to the centre of the hub. The member itself, with base and
    tube, has the component along its axis: from joint to joint, which is where its other end passes it on.
    """
    if not any(isinstance(load, BodyCouple) and load.member for load in model.loads.values()):
        return None
    system, parts = compile(model), parts_of(model)
    position = forces.motion.arrays["position"].values
    case = forces.load_case if forces.load_case in model.load_cases else None
    couples = case_loads(system, forces.arrays["time"].values, case).couples
    found, index = np.zeros((len(position), len(parts.names))), {name: i for i, name in enumerate(system.members)}
    carried: dict[str, NDArray[np.float64]] = {}
    for name, couple in couples.items():
        load = model.loads[name]
        arm = arm_through(model, load.body, load.member)
        if arm is None:
            continue
        i = index[arm.name]
        tip = 1.0 if system.nodes[system.q[i]] == arm.name else -1.0
        found[:, parts.first[i]] += tip * np.einsum("tc,tc->t", couple, ends_of(system, position, i)[2])
        # the couple on the hub is the opposite of that on the member: +C . u behind a section where it leaves at A
        sign = 1.0 if arm.end == 0 else -1.0
        along = sign * np.einsum("tc,tc->t", couple, ends_of(system, position, index[arm.member])[2])
        carried.setdefault(f"{arm.member} {arm.end}", np.zeros(len(position)))
        carried[f"{arm.member} {arm.end}"] += along
    for member, i in index.items():
        ends = [carried[key] for end in (0, 1) if (key := f"{member} {end}") in carried]
        if ends:
            rods = 2 if isinstance(model.members[member], Active) else 1
            found[:, parts.first[i] : parts.first[i] + rods] += ends[0][:, None]
    return found


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
