"""The triangular truss against the numbers of Lacy (1991), chapter 3, that need none of his formulas.

Statics, speeds and the Euler load. For the numbers that only his program gives see `triangle_thesis`.
"""

from __future__ import annotations

import numpy as np

import kinetruss as kt
from kinetruss.verification.thesis.triangle import analysed, outer_fibre, truss

STEP = 0.06
TIMES = tuple(np.round(np.arange(50) * STEP, 12).tolist())
SPEED_LIMIT = 400.0  # rad/s, of the motor


def table_3_2() -> dict[str, float]:
    """Massless members, 98.1 N at B, actuator at 2.5 m."""
    model, forces, sections, _ = analysed((0.0,), 10.0, True)
    return _reactions(forces) | {
        "tension_follower": forces.member_force.sel(member="follower").item(),
        "tension_tube": forces.member_force.sel(member="actuator").item(),
        "stress_follower": outer_fibre(model, sections, "follower", 3)[0],
        "stress_tube": outer_fibre(model, sections, "actuator.tube", 0)[0],
    }


def _reactions(forces: kt.results.Forces) -> dict[str, float]:
    reaction = forces.reaction
    return {f"R_O{k}{axis}": reaction.sel(support=f"O{k}", axis=axis).values[0] for k in (1, 2) for axis in "xy"}


def weight() -> dict[str, float]:
    """Reactions of the truss at rest under its own weight."""
    return _reactions(analysed((0.0,))[1])


def drive() -> dict[str, float]:
    """Largest actuator speed on the thesis' samples, and the gear that lets the motor follow it."""
    motion = kt.kinematics.follow(truss(), kt.library.vgt.lacy_step(), times=np.array(TIMES))
    speed = float(np.abs(motion.length_rate.sel(member="actuator").values).max())
    return {
        "largest_speed": speed,
        "gear_ratio": kt.actuators.gear_ratio_for(kt.library.drives.SCREW_LACY_PLANAR, SPEED_LIMIT, speed),
    }


def static(payload: float) -> dict[str, float]:
    """Sections 3.3 and 3.5: stresses at rest on his samples, the largest and that at the printed 1.80 s."""
    model, _, _, at_rest = analysed(TIMES, payload)
    follower, tube = outer_fibre(model, at_rest, "follower", 3), outer_fibre(model, at_rest, "actuator.tube", 0)
    return {
        "follower_static_there": follower[TIMES.index(1.74)],
        "follower_static_largest": follower.max(),
        "tube_static_largest": tube.max(),
    }


def euler_load() -> dict[str, float]:
    """Table 3.3: of the follower, 2 m long with pinned ends."""
    model = truss()
    bar = model.bars["follower"]
    inertia = model.section_of(bar).second_moments[0]
    return {"euler_load": float(kt.strength.euler_load(71e9, inertia, 2.0, bar.buckling))}
