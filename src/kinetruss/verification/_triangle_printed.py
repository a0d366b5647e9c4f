"""The triangular truss against the printed figures of Lacy (1991), chapter 3.

Statics, speeds and the Euler load are the product's own. The dynamic figures are his program's, with its finite
differences; `_thesis_differences` repeats them, fed by the product's motion and records.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from kinetruss import actuators, kinematics, strength
from kinetruss.library import vgt
from kinetruss.library.drives import SCREW_LACY_PLANAR
from kinetruss.model import Model
from kinetruss.results import Forces
from kinetruss.verification import _thesis_differences as thesis
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._triangle import analysed, outer_fibre, truss

__all__ = ["cases"]

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


def figures(payload: float) -> dict[str, float]:
    """Section 3.3, 3.5 and Table 3.3: dynamic stresses by his differences, static ones by the product."""
    model, forces, _, static = analysed(TIMES, payload)
    motion = forces.motion.data.sel(member="actuator")
    x, rate, acceleration = (motion[name].values for name in ("length", "length_rate", "length_acceleration"))
    setup = _setup(model)
    found = thesis.stresses(setup, thesis.record(setup, x - setup.member - setup.shortest, rate, acceleration, STEP))
    still, still_tube = outer_fibre(model, static, "follower", 3), outer_fibre(model, static, "actuator.tube", 0)
    peak = int(found.follower.argmax())
    moved, moved_tube = found.follower - still, found.tube - still_tube
    return {
        "follower_largest": found.follower.max(),
        "follower_largest_time": (peak + 1) * STEP,
        "follower_static_there": still[peak],
        "follower_static_largest": still.max(),
        "follower_motion_largest": moved.max(),
        "follower_motion_largest_time": (int(moved.argmax()) + 1) * STEP,
        "tube_largest": found.tube.max(),
        "tube_static_largest": still_tube.max(),
        "tube_motion_largest": moved_tube.max(),
        "tube_motion_largest_time": (int(moved_tube.argmax()) + 1) * STEP,
        "follower_largest_compression": found.follower_compression.max(),
        "tube_largest_compression": found.tube_compression.max(),
    }


def _setup(model: Model) -> thesis.Setup:
    inputs = load("triangle")["inputs"]
    bar = model.bars["follower"]
    return thesis.Setup(
        section=model.section_of(bar),
        density=inputs["rho"],
        member=inputs["L1"], ground=inputs["L4"], shortest=inputs["L3min"], rod_mass=inputs["m_base"],
        rod_length=inputs["L3max_base_length"], load=model.nodes["B"].mass, gravity=inputs["g"],
    )  # fmt: skip


def euler_load() -> float:
    """Table 3.3: of the follower, 2 m long with pinned ends."""
    model = truss()
    bar = model.bars["follower"]
    inertia, length = model.section_of(bar).second_moments[0], load("triangle")["inputs"]["L1"]
    return float(strength.euler_load(load("triangle")["inputs"]["E"], inertia, length, bar.buckling))


def cases() -> Iterator[Case]:
    """One case a printed figure; the id says where the figure stands and what it is."""
    for entry in load("printed")["triangle"]:
        yield Case(entry["id"], entry["source"], entry["expected"], entry["tolerance"], *_computation(entry["id"]))


def _computation(label: str) -> tuple[Callable[..., Any], tuple[float, ...], tuple[str, ...]]:
    """Analysis, its arguments, and the key of the figure in it."""
    _, where, *rest = label.split(".")
    payload = 40.0 if rest[-1].endswith("_40kg") else 10.0
    name = rest[-1].removesuffix("_40kg").removesuffix("_10kg")
    if name == "euler_load":
        return euler_load, (), ()
    if where in ("table_3_2", "section_3_2", "section_3_7"):
        return {"table_3_2": table_3_2, "section_3_2": weight, "section_3_7": drive}[where], (), (name,)
    return figures, (payload,), (name,)
