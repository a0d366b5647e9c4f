"""Free bodies that close, and the labelled systems of Newton and Euler: their size, their condition, their solution."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.library import vgt
from kinetruss.model import Model
from kinetruss.results import Forces
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference
from kinetruss.verification.thesis.bay import EXACT, TILT, truss_of
from kinetruss.verification.thesis.tables import LEVEL, LONG
from kinetruss.verification.thesis.triangle import truss

__all__ = ["cases"]

ROUNDING = 1e-12
"""Of the largest force: what is left of equations that close."""

LARGEST = 100.0
"""N; forces of both trusses are of this size."""

CLOSES = Reference("identity", "Newton and Euler: the equations of a free body close (Lacy, 1991, chapters 2 and 4)")
TWICE = Reference("agreement", "the equations of Newton and Euler, solved whole, and inverse dynamics")
COUNT = Reference("count", "Lacy (1991): 11 equations of the triangular truss (chapter 2), 117 of one bay (chapter 4)")
CONDITION = Reference("independent", "Independent assembly of the 117 equations of Lacy (1991, chapter 4), three digits stored")


def bay(duration: float, times: tuple[float, ...]) -> list[dict[str, float]]:
    """The slew of one bay at the given times: what its 117 equations and its free bodies say."""
    model = truss_of(load("single_bay")["inputs"], tip_force=(0.0, 0.0, 46.0))
    motion = kinematics.follow(model, vgt.slew(beta=(-TILT, TILT), duration=duration), times=np.array(times))
    forces = dynamics.inverse(model, motion)
    return [_found(model, forces, t) for t in times]


def triangle(times: tuple[float, ...]) -> list[dict[str, float]]:
    """The motion of the triangular truss at the given times: what its 11 equations and its free bodies say."""
    model = truss()
    motion = kinematics.follow(model, vgt.lacy_step(), times=np.array(times))
    forces = dynamics.inverse(model, motion)
    return [_found(model, forces, t) for t in times]


def _found(model: Model, forces: Forces, time: float) -> dict[str, float]:
    """Unknowns by name as the system's own solution gives them, size, misses; tension at B of every member."""
    system = dynamics.newton_euler(model, forces.motion, forces, time=time)
    found = dict(zip(system.unknowns, system.solution.tolist(), strict=True))
    motion = forces.motion.data.sel(time=time)["position"]
    for name, member in model.members.items():
        a, b = (motion.sel(node=end).values for end in member.ends)
        pull = np.array([found[f"{name} B {axis}"] for axis in "xyz"[: model.dim]])
        found[f"{name} tension B"] = float(pull @ (b - a) / np.linalg.norm(b - a))
    cut = partial(dynamics.free_body, model, forces.motion, forces, time=time)
    found |= {
        "equations": float(len(system.equations)),
        "unknowns": float(len(system.unknowns)),
        "difference": system.difference,
        "residual of members": max(cut(member=name).residual for name in model.members),
        "residual of nodes": max(cut(node=name).residual for name in model.nodes),
    }
    return found


def condition(lengths: tuple[float, float, float]) -> float:
    """Condition number of the 117 equations in a pose."""
    model = truss_of(load("single_bay")["inputs"], tip_force=(0.0, 0.0, 46.0))
    position = kinematics.assemble(model, dict(zip(("M7", "M9", "M11"), lengths, strict=True)))
    still = np.zeros((1, *position.shape))
    motion = kinematics.from_arrays(model, [0.0], position[None], still, still)
    return dynamics.newton_euler(model, motion, dynamics.inverse(model, motion, static=False)).condition


def cases() -> Iterator[Case]:
    """Sizes, misses, and the solution of the equations against what is stored from elsewhere."""
    for name, lengths, expected in (("level", LEVEL, 42.7), ("slewed", LONG, 43.3)):
        yield Case(f"explain.bay.condition.{name}", CONDITION, expected, 0.05 / expected, condition, (lengths,))
    yield from _triangle_cases()
    yield from _bay_cases()


def _triangle_cases() -> Iterator[Case]:
    data = load("triangle")
    source = Reference("independent", data["source"])
    times = tuple(float(t) for t in data["samples"])
    for i, (t, stored) in enumerate(data["samples"].items()):
        yield from _closing(f"explain.triangle.t={t}", triangle, (times,), i, 11)
        for quantity, label in (("R1", "follower A"), ("R2", "actuator A"), ("F_on_follower_at_B", "follower B")):
            scale = max(map(abs, stored[quantity]))
            for axis, expected in zip("xy", stored[quantity], strict=True):
                name = f"explain.triangle.t={t}.{label.replace(' ', '.')}.{axis}"
                yield Case(name, source, expected, EXACT, triangle, (times,), (i, f"{label} {axis}"), scale)


def _bay_cases() -> Iterator[Case]:
    data = load("single_bay")
    source = Reference("independent", data["source"])
    instants = [(*(float(word.split("=")[1]) for word in label.split()), label) for label in data["values"]]
    for duration in dict.fromkeys(one[0] for one in instants):
        times = tuple(t for d, t, _ in instants if d == duration)
        for i, label in enumerate(name for d, _, name in instants if d == duration):
            prefix, given, stored = f"explain.bay.{label.replace(' ', '.')}", (duration, times), data["values"][label]
            yield from _closing(prefix, bay, given, i, 117)
            for k, reaction in enumerate(stored["reactions"], start=1):
                for axis, expected in zip("xyz", reaction, strict=True):
                    at, scale = (i, f"N{k} reaction {axis}"), max(map(abs, reaction))
                    yield Case(f"{prefix}.N{k}.{axis}", source, expected, EXACT, bay, given, at, scale)
            for number, expected in stored["tension_at_B_end"].items():
                at = (i, f"M{number} tension B")
                yield Case(f"{prefix}.M{number}.tension_B", source, expected, EXACT, bay, given, at)


def _closing(prefix: str, make: Any, given: tuple[Any, ...], i: int, size: int) -> Iterator[Case]:
    for name in ("equations", "unknowns"):
        yield Case(f"{prefix}.{name}", COUNT, float(size), 0.0, make, given, (i, name))
    misses = {"difference": 10 * ROUNDING, "residual of members": ROUNDING, "residual of nodes": ROUNDING}
    for name, tolerance in misses.items():
        reference = TWICE if name == "difference" else CLOSES
        yield Case(f"{prefix}.{name.replace(' ', '_')}", reference, 0.0, tolerance, make, given, (i, name), LARGEST)
