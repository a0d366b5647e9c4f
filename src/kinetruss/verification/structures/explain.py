"""Free bodies that close, and the labelled systems of Newton and Euler: their size, their condition, their solution."""

from __future__ import annotations

from functools import partial

import numpy as np

import kinetruss as kt
from kinetruss.verification.thesis.bay import slewed, truss_of
from kinetruss.verification.thesis.triangle import SAMPLES, analysed


def bay(duration: float, times: list[float]) -> dict[str, dict[str, float]]:
    """The slew of one bay at the given times: what its 117 equations and its free bodies say."""
    model, forces = slewed(duration, times)
    return {f"t={t:g}": _found(model, forces, t) for t in times}


def triangle() -> dict[str, dict[str, float]]:
    """The motion of the triangular truss at the samples: what its 11 equations and its free bodies say."""
    model, forces, _, _ = analysed(SAMPLES)
    return {f"t={t:g}": _found(model, forces, t) for t in SAMPLES}


def _found(model: kt.Model, forces: kt.results.Forces, time: float) -> dict[str, float]:
    """Unknowns by name as the system's own solution gives them, size, misses; tension at B of every member."""
    system = kt.dynamics.newton_euler(model, forces.motion, forces, time=time)
    names = (name.replace(" reaction ", " ").replace(" ", ".") for name in system.unknowns)
    found = dict(zip(names, system.solution.tolist(), strict=True))
    motion = forces.motion.data.sel(time=time)["position"]
    for name, member in model.members.items():
        a, b = (motion.sel(node=end).values for end in member.ends)
        tension = np.array([found[f"{name}.B.{axis}"] for axis in "xyz"[: model.dim]])
        found[f"{name}.tension_B"] = float(tension @ (b - a) / np.linalg.norm(b - a))
    cut = partial(kt.dynamics.free_body, model, forces.motion, forces, time=time)
    found |= {
        "equations": len(system.equations),
        "unknowns": len(system.unknowns),
        "difference": system.difference,
        "residual_of_members": max(cut(member=name).residual for name in model.members),
        "residual_of_nodes": max(cut(node=name).residual for name in model.nodes),
    }
    return found


def condition(lengths: list[float]) -> dict[str, float]:
    """Condition number of the 117 equations in a pose."""
    model = truss_of(tip_force=(0.0, 0.0, 46.0))
    position = kt.kinematics.assemble(model, dict(zip(("M7", "M9", "M11"), lengths, strict=True)))
    still = np.zeros((1, *position.shape))
    motion = kt.kinematics.from_arrays(model, [0.0], position[None], still, still)
    return {"condition": kt.dynamics.newton_euler(model, motion, kt.dynamics.inverse(model, motion, static=False)).condition}
