"""The triangular truss against the numbers of Lacy (1991), chapter 3, that need none of his formulas.

Statics, speeds and the Euler load. For the numbers that only his program gives see `triangle_thesis`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from kinetruss import actuators, kinematics, strength
from kinetruss.library import vgt
from kinetruss.library.drives import SCREW_LACY_PLANAR
from kinetruss.results import Forces
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification.thesis.printed import printed
from kinetruss.verification.thesis.triangle import analysed, outer_fibre, truss

__all__ = ["STEP", "TIMES", "cases", "payload_of"]

STEP = 0.06
TIMES = tuple(np.round(np.arange(50) * STEP, 12).tolist())
SPEED_LIMIT = 400.0  # rad/s, of the motor


def table_3_2() -> dict[str, float]:
    """Massless members, 98.1 N at B, actuator at 2.5 m."""
    model, forces, sections, _ = analysed((0.0,), 10.0, True)
    return {
        **_reactions(forces),
        "tension_follower": forces.member_force.sel(member="follower").item(),
        "tension_tube": forces.member_force.sel(member="actuator").item(),
        "stress_follower": outer_fibre(model, sections, "follower", 3)[0],
        "stress_tube": outer_fibre(model, sections, "actuator.tube", 0)[0],
    }


def _reactions(forces: Forces) -> dict[str, float]:
    reaction = forces.reaction
    return {f"R_O{k}{axis}": reaction.sel(support=f"O{k}", axis=axis).values[0] for k in (1, 2) for axis in "xy"}


def weight() -> dict[str, float]:
    """Reactions of the truss at rest under its own weight."""
    return _reactions(analysed((0.0,))[1])


def drive() -> dict[str, float]:
    """Largest actuator speed on the thesis' samples, and the gear that lets the motor follow it."""
    motion = kinematics.follow(truss(), vgt.lacy_step(), times=np.array(TIMES))
    speed = float(np.abs(motion.length_rate.sel(member="actuator").values).max())
    return {"largest_speed": speed, "gear_ratio": actuators.gear_ratio_for(SCREW_LACY_PLANAR, SPEED_LIMIT, speed)}


def static(payload: float) -> dict[str, float]:
    """Sections 3.3 and 3.5: stresses at rest on his samples, the largest and that at the printed 1.80 s."""
    model, _, _, at_rest = analysed(TIMES, payload)
    follower, tube = outer_fibre(model, at_rest, "follower", 3), outer_fibre(model, at_rest, "actuator.tube", 0)
    return {
        "follower_static_there": follower[TIMES.index(1.74)],
        "follower_static_largest": follower.max(),
        "tube_static_largest": tube.max(),
    }


def euler_load() -> float:
    """Table 3.3: of the follower, 2 m long with pinned ends."""
    model = truss()
    bar = model.bars["follower"]
    inertia, length = model.section_of(bar).second_moments[0], load("triangle")["inputs"]["L1"]
    return float(strength.euler_load(load("triangle")["inputs"]["E"], inertia, length, bar.buckling))


def cases() -> Iterator[Case]:
    """One case a printed number; the id says where it stands and what it is."""
    for one in printed("triangle"):
        if one.reference.kind != "thesis-formulas":
            yield Case(one.id, one.reference, one.expected, one.tolerance, *_computation(one.id))


def payload_of(label: str) -> tuple[str, float]:
    """Name and payload (kg) of a printed number."""
    name = label.rsplit(".", 1)[1]
    return name.removesuffix("_40kg").removesuffix("_10kg"), 40.0 if name.endswith("_40kg") else 10.0


def _computation(label: str) -> tuple[Callable[..., Any], tuple[float, ...], tuple[str, ...]]:
    """Analysis, its arguments, and the key of the number in it."""
    where = label.split(".")[1]
    name, payload = payload_of(label)
    if name == "euler_load":
        return euler_load, (), ()
    if "static" in name:
        return static, (payload,), (name,)
    return {"table_3_2": table_3_2, "section_3_2": weight, "section_3_7": drive}[where], (), (name,)
